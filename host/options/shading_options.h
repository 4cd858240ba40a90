/* SPDX-License-Identifier: MIT
 * The options of the commands that draw or describe how: a built-in scene, lights, material, pixels. */
#ifndef GLINT_SHADING_OPTIONS_H
#define GLINT_SHADING_OPTIONS_H

#include <argp.h>

#include "options/scene_options.h"
#include "options/view_options.h"
#include "draw/mesh_canvas.h"
#include "draw/shading.h"

struct shading_options {
    struct scene_options scene;
    struct view_options view; /* of a mesh; drawing_options.h fills it */
    bool has_color;           /* instead of an albedo */
    bool has_material;        /* whose values are in `shading` where no option says otherwise */
    unsigned material;        /* its place in preset_names */
    bool has_across;          /* by --across; else that of the material or the scene */
    bool has_view;
    bool has_light;         /* of any kind; otherwise the default one */
    bool has_format;        /* otherwise RGB888, or the device's */
    double roughness;       /* what -n is made from; NAN: nothing */
    struct shading shading; /* with gaps, which shading_of_options fills */
};

/* A child of a command's argp; its input is a struct shading_options, which it fills. It refuses wrong values,
 * and has no options of maps and meshes: a command that draws takes drawing_options_argp instead. */
extern const struct argp shading_options_argp;
/* Checks what depends on the format. */
void shading_options_check(const struct argp_state *state, const struct shading_options *options,
                           const struct shading *shading);

/* Is all of a mesh drawn in one colour, that of --color or of the material? */
bool shading_options_one_color(const struct shading_options *options);
/* What the options leave to a mesh's materials. */
/* Along which of the mesh's axes grain runs. */
void shading_options_grain(const struct shading_options *options, struct fitted *fitted);
struct mesh_own shading_options_own(const struct shading_options *options);

/* The scene of maps that were read; width = 0: at its own size. */
struct scene *scene_of_shading_options(const struct shading_options *options, const struct scene_maps *maps,
                                       uint32_t width, uint32_t height);
/* Some of its lines. */
struct scene *scene_lines_of_shading_options(const struct shading_options *options, struct scene_lines *lines,
                                             uint32_t top, uint32_t count);
/* The shading, completed for the format and the scene's finish. */
struct shading shading_of_options(const struct shading_options *options, enum glint_format format,
                                  const struct finish *finish);

#endif
