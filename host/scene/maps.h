/* SPDX-License-Identifier: MIT
 * Scenes as the user names them: a height map, a normal map or a built-in scene, with the maps that go with it. */
#ifndef GLINT_SCENE_MAPS_H
#define GLINT_SCENE_MAPS_H

#include <stdbool.h>

#include "mesh/load.h"
#include "scene/scene.h"

enum { SCENE_SIDE = 320 }; /* of built-in scenes and meshes where --size is not given */

struct scene_options {
    /* one of four; a built-in mesh is one that `mesh` names */
    const char *heights, *normals, *scene;
    struct mesh_source mesh; /* its name is NULL where there is none */
    double scale, bevel;     /* bevel > 0: the heights are those of a shape's rounded edge */
    double fit;              /* of a bevelled shape: percent of the picture that it takes; 0: it stays as it is */
    bool wraps, flip_y;
    const char *mask;
    uint32_t width, height;     /* 0: the map's own */
    const char *albedo, *gloss; /* for commands that take them to set; NULL: the scene's own */
    const char *grain_map;      /* FILE; NULL: */
    struct grain grain;         /* where has_grain; a centre that is NAN is the picture's middle */
    bool has_grain, grain_is_axis;
    const char *backdrop; /* FILE; NULL: */
    uint8_t backdrop_color[3];
    bool has_backdrop;
    unsigned filter; /* so many pixels of the maps each way become one; 0: as 1 */
    bool cut_out;    /* the thing alone: a built-in scene's without its wall, a logo's shape */
    bool on_device;  /* a device shows a surface of its own: none is named here */
    bool has_body;
    uint8_t body[3]; /* what a built-in scene is made of; else its own colour */
};

/* All of these are for maps and scenes, not for meshes, and end the program through fail() where something is wrong. */
struct scene *scene_of_options(const struct scene_options *options);

/* What the picture is drawn over, RGB888; NULL: black. malloc'd. */
uint8_t *scene_backdrop(const struct scene_options *options, uint32_t width, uint32_t height);

/* The same in two steps, for a size that is known only when the maps are: width = 0 is the options'. */
struct scene_maps;
struct scene_maps *scene_maps_read(const struct scene_options *options);
void scene_maps_free(struct scene_maps *maps);
/* Of the surface's map; 0, 0 of a built-in scene, which takes any. */
void scene_maps_size(const struct scene_maps *maps, uint32_t *width, uint32_t *height);
struct scene *scene_of_maps(const struct scene_maps *maps, uint32_t width, uint32_t height);

/* The same in parts of some lines, from the top, for pictures larger than memory holds. (Shapes with --bevel and scenes that --filter makes
 * smaller are held as a whole.) The maps must outlive it. At the end it warns of what looks wrong. */
struct scene_lines;
struct scene_lines *scene_lines_new(const struct scene_maps *maps, uint32_t width, uint32_t height);
void scene_lines_size(const struct scene_lines *lines, uint32_t *width, uint32_t *height);
struct scene *scene_lines_make(struct scene_lines *lines, uint32_t top, uint32_t count);
void scene_lines_end(struct scene_lines *lines);

#endif
