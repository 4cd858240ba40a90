/* SPDX-License-Identifier: MIT
 * What is shaded, apart from how: each pixel's normal and maps, from files or drawn. */
#ifndef GLINT_SCENE_SCENE_H
#define GLINT_SCENE_SCENE_H

#include <stdint.h>

#include "glint.h"

/* A scene's own material, for what the user leaves out. */
struct finish {
    unsigned n, n_across; /* n_across: 0 without grain */
    double ambient[3], diffuse[3], specular[3];
};

/* Which way the scratches of a surface run. */
struct grain {
    uint8_t kind; /* enum glint_grain */
    /* brushed: the direction, y up, 0 is to the right, in space for a mesh; spun, sunray: the centre, in pixels from the picture's upper left corner */
    double at[3];
};

struct scene {
    uint32_t width, height;
    uint32_t top;         /* the picture's line that its first one is: more than 0 of a part */
    double (*normals)[3]; /* length 1; x right, y up, z towards the viewer; lines from the top */
    uint8_t *albedo;      /* RGB888, or NULL */
    uint8_t *gloss;       /* or NULL */
    uint8_t *mask;        /* coverage: 0 is not drawn, below 255 in part; or NULL */
    uint8_t *grain_map;   /* 256 a half turn, counterclockwise from the right; or NULL: as `grain` says everywhere */
    struct grain grain;
    double *lengths;    /* of a scene made smaller: of the means of its normals; or NULL */
    uint8_t *shininess; /* a pixel's code (glint.h); or NULL: the material's n */
    uint8_t *backdrop;  /* RGB888: what is drawn over; or NULL: black */
    uint8_t *parts;     /* of a mesh: by which of its parts' shadings; or NULL: by the only one */
    double (*places)
        [3]; /* of a mesh: in pixels from the picture's upper left corner, x right, y down, z to you; or NULL: each pixel's
                           * middle, at z = 0 */
    struct finish finish;
};

extern const struct finish plain_finish;

struct scene *scene_new(uint32_t width, uint32_t height); /* normals towards the viewer, no maps, the plain finish */
void scene_free(struct scene *scene);
/* The scene cut to the size, or repeated to fill it. */
void scene_repeat(struct scene *scene, uint32_t width, uint32_t height);
/* Some of its lines, without the backdrop and what is of meshes. */
struct scene *scene_part(const struct scene *scene, uint32_t top, uint32_t lines);
/* What the library takes: nearest Q1.15, 1.0 held as 32767; malloc'd. */
struct glint_vec *scene_normals_q15(const struct scene *scene);
/* The albedo, or `color` throughout where there is none, in the nearest RGB565, as ALBEDO tables take it; malloc'd. */
uint16_t *scene_albedo_565(const struct scene *scene, const uint8_t color[3]);

#endif
