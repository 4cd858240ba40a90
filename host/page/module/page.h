/* SPDX-License-Identifier: MIT
 * The page's module: all that JavaScript may call. The page's types are made from these declarations (module_types.mjs).
 *
 * Texts end with 0. Words of a command line follow each other, each with its 0. What goes in lies in memory of
 * page_allocate, which the callee frees. What comes out stays until the next call of its kind. An error is a line on
 * standard error and the end of the program, as in the command: the page then begins with a fresh module. */
#ifndef GLINT_PAGE_PAGE_H
#define GLINT_PAGE_PAGE_H

#include <stddef.h>
#include <stdint.h>

#define PAGE_EXPORT(name) __attribute__((export_name(#name))) name

void *PAGE_EXPORT(page_allocate)(size_t bytes);

/* A map: 16-bit samples as struct image has them. */
void PAGE_EXPORT(page_image)(char *name, uint32_t width, uint32_t height, uint32_t channels, uint32_t bits,
                             uint32_t palette, uint16_t *samples);

/* A mesh's file. */
void PAGE_EXPORT(page_mesh_file)(char *name, uint8_t *bytes, size_t len);

/* No map or mesh has this name from now on; the picture that was drawn of it stays. */
void PAGE_EXPORT(page_forget)(char *name);

/* What options take by name: lines of a list (models, formats, paths, materials, scenes), a name, its title, what it means, its
 * formula, with tabs between. */
const char *PAGE_EXPORT(page_lists)(void);

/* Would the words of `glint render` be refused, whatever the files hold? Then the program ends with a line. */
void PAGE_EXPORT(page_check)(char *words, size_t bytes);

/* ---- the picture ---- */

/* Draws by the words of `glint render`, the first being the command's name. What did not change since the call before is
 * kept: PAGE_KEEP_SCENE, the surface and its maps, or the mesh; PAGE_KEEP_CANVAS, all but the lights' values and where the
 * mesh stands. */
enum { PAGE_KEEP_NOTHING, PAGE_KEEP_SCENE, PAGE_KEEP_CANVAS };
void PAGE_EXPORT(page_draw)(char *words, size_t bytes, uint32_t keep);
uint32_t PAGE_EXPORT(page_width)(void);
uint32_t PAGE_EXPORT(page_height)(void);
/* In the format, lines without gaps, as `--image raw` writes them. */
const uint8_t *PAGE_EXPORT(page_pixels)(void);
size_t PAGE_EXPORT(page_pixels_bytes)(void);
/* As `glint render` writes it into a PNG, with alpha 255 where it has none; page_width x page_height. */
const uint8_t *PAGE_EXPORT(page_rgba)(void);
/* Lines "name value ..." of the shader that drew. */
const char *PAGE_EXPORT(page_facts)(void);
/* Where its highlight is, which takes as long as to draw: x, y, width, height; of a mesh 0. */
const uint32_t *PAGE_EXPORT(page_box)(void);
/* Milliseconds that are not spent on words: draws the picture `times` times. For the page's bench. */
void PAGE_EXPORT(page_again)(uint32_t times);

/* ---- its quality ---- */

/* Compares the picture with double precision, as `glint render --compare` does, and returns what that prints. */
const char *PAGE_EXPORT(page_compare)(void);
/* Afterwards: the error map, amplified, in RGBA, and by how much. */
const uint8_t *PAGE_EXPORT(page_error_map)(void);
uint32_t PAGE_EXPORT(page_error_times)(void);
/* And how many samples are off by i quarters of a level of 255, to the nearest; the last bin has the rest. */
enum { PAGE_BINS = 65 };
const uint32_t *PAGE_EXPORT(page_histogram)(void);

/* The lobe of a model, by its name, at `count` angles from 0 to `degrees`: rows of the library's value, the same in double, Blinn in
 * double. */
const double *PAGE_EXPORT(page_curve)(char *model, uint32_t n, uint32_t count, double degrees);

/* ---- a device that shades by itself (firmware/core/light_protocol.h) ---- */

/* Of its descriptor, LIGHT_DESCRIPTOR_BYTES: width << 16 | height; 0 where it is none. */
uint32_t PAGE_EXPORT(page_device_size)(const uint8_t *bytes);
/* What it is sent to draw the last picture: LIGHT_MATERIAL_BYTES, 4 bytes a pixel, LIGHT_MESSAGE_BYTES. The program ends
 * with a line where a device cannot draw so. */
const uint8_t *PAGE_EXPORT(page_device_material)(void);
const uint8_t *PAGE_EXPORT(page_device_map)(void);
const uint8_t *PAGE_EXPORT(page_device_light)(uint32_t tag);
/* Of a mesh that it holds, LIGHT_MESH_BYTES: that of the words of `glint render`, whose edges are split at so many degrees; 0:
 * another one. */
uint32_t PAGE_EXPORT(page_device_mesh)(const uint8_t *held, char *words, size_t bytes);
/* Is the last picture of a mesh? Then it is sent in the place of a map and lights: LIGHT_POSE_BYTES. */
uint32_t PAGE_EXPORT(page_draws_mesh)(void);
const uint8_t *PAGE_EXPORT(page_device_pose)(uint32_t tag);

/* ---- files ---- */

/* Runs `glint bake`, `material` or `table`. */
void PAGE_EXPORT(page_run)(char *words, size_t bytes);
uint32_t PAGE_EXPORT(page_files)(void);
const char *PAGE_EXPORT(page_file_name)(uint32_t i);
const char *PAGE_EXPORT(page_file_bytes)(uint32_t i);
size_t PAGE_EXPORT(page_file_length)(uint32_t i);

#endif
