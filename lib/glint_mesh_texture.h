/* SPDX-License-Identifier: MIT
 * Internal. The albedo of a triangle's pixels where it is linear over the triangle: u and v of a texture, or for tables red, green and blue. */
#ifndef GLINT_MESH_TEXTURE_H
#define GLINT_MESH_TEXTURE_H

#include "glint_mesh_rows.h"

/* One picture of the chain. */
struct glint_mesh_picture {
    const uint8_t *pixels;
    const uint16_t *palette; /* NULL: pixels are RGB565 */
    uint32_t w, h;
};

/* Of u and v 2^32 is the texture's width and height: modulo 2^32 they repeat, and no place is outside. Of colours 2^21 is a level of RGB565,
 * with half a level added. */
struct glint_mesh_over {
    struct glint_mesh_linear of[3];
    int32_t x, y; /* the pixel */
    struct glint_mesh_picture picture;
    uint8_t count; /* of numbers: 2 or 3 */
    bool is_smooth;
    /* In perspective `of` is the numerator of what u and v are more than at corner a, over R, the depth's distance from the farthest. */
    bool is_far;
    uint8_t up, down[2]; /* from Q13 of the mesh's units; to that, of a numerator times an inverse */
    uint32_t base[2];
    /* Of the line at hand. */
    uint32_t now[3], step[3]; /* at pixel from; good up to pixel to - 1 */
    uint32_t line[2];         /* the numerators at pixel left */
    uint32_t z, dz;           /* at left */
    int32_t from, to, left, right;
    int32_t off[2]; /* at from */
};

/* The texture of what is painted by it, or NULL. */
static inline const struct glint_texture *glint_mesh_texture_of(const struct glint_mesh_drawn *drawn,
                                                                const struct glint_paint *paint)
{
    const struct glint_texture *textures = drawn->mesh->textures, *texture = textures + (paint - drawn->paints);
    return textures && texture->pixels ? texture : NULL;
}

/* What a mesh uses for it, const. */
struct glint_use_mesh {
    /* Are its textures good? */
    bool (*can)(const struct glint_mesh *mesh);
    /* Sets the triangle at hand of a face; of the texture, or NULL: of the mesh's colours. */
    void (*set)(struct glint_mesh_over *over, const struct glint_mesh_target *target, unsigned face,
                const struct glint_texture *texture);
    /* Begins a line of the picture, pixels left..right - 1, with the depth at left and its step; the first part of it is at hand then. */
    void (*line)(struct glint_mesh_over *over, int32_t y, int32_t left, int32_t right, uint32_t z, uint32_t dz);
    /* Albedo of count pixels from x on, RGB888 or, aligned to 2, RGB565; x does not go back in a line. */
    void (*rgb888)(struct glint_mesh_over *over, int32_t x, uint8_t *out, unsigned count);
    void (*rgb565)(struct glint_mesh_over *over, int32_t x, uint8_t *out, unsigned count);
};

static inline uint16_t glint_mesh_texel(const struct glint_mesh_picture *picture, uint32_t at)
{
    return picture->palette ? picture->palette[picture->pixels[at]]
                            : ((const uint16_t *)(const void *)picture->pixels)[at];
}

/* The nearest. (u >> 16) w < 2^27, and over 2^16 it is below w. */
static inline uint32_t glint_mesh_nearest(const struct glint_mesh_picture *picture, uint32_t u, uint32_t v)
{
    return ((v >> 16) * picture->h >> 16) * picture->w + ((u >> 16) * picture->w >> 16);
}

/* The four around it, as fields of ALBEDO tables (glint_tables.h), by weights of 32 that are never below 0. */
uint32_t glint_mesh_smooth_fields(const struct glint_mesh_picture *picture, uint32_t u, uint32_t v);

/* Red, green and blue as these fields. */
static inline uint32_t glint_mesh_colour_fields(uint32_t red, uint32_t green, uint32_t blue)
{
    return red >> 21 << 11 | green >> 21 << 21 | blue >> 21;
}

#endif
