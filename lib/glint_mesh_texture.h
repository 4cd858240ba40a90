/* SPDX-License-Identifier: MIT
 * Internal. The albedo of a triangle's pixels where it is linear over the triangle: u and v of a texture, or for tables red, green and blue. */
#ifndef GLINT_MESH_TEXTURE_H
#define GLINT_MESH_TEXTURE_H

#include "glint_mesh_rows.h"
#include "glint_port.h"
#include "glint_tables.h"

/* One picture of the chain. */
struct glint_mesh_picture {
    const uint8_t *pixels;
    const uint16_t *palette; /* NULL: pixels are RGB565 */
    uint32_t w, h;           /* the loop of GLINT_MESH_SQUARE takes 32 less the power for h */
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
    const struct glint_texture *texture = drawn->mesh->textures;
    if (!texture)
        return NULL;
    texture += paint - drawn->paints;
    return texture->pixels ? texture : NULL;
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
    /* The part of the line after the one at hand. */
    void (*next)(struct glint_mesh_over *over);
    /* Before a picture: room for what triangles have of it, if it is of use. */
    void (*room)(struct glint_mesh_frame *frame, const struct glint_mesh *mesh, const struct glint_paint *paints);
    /* Without perspective: what fused lines take of the triangle, at its line. */
    void (*lay)(struct glint_mesh_laid *laid, const struct glint_mesh_target *target,
                const struct glint_mesh_triangle *triangle, const struct glint_texture *texture);
    /* Fused, behind GLINT_FUSED, or NULL: a triangle's lines by ALBEDO tables at even places. */
    void (*lines)(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                  const struct glint_mesh_target *target, const struct glint_texture *texture);
    /* In assembly alone: as glint_mesh_colour_begin; with lines NULL it only tells whether it can. 0: no; 2^31. */
    uint32_t (*begin)(const struct glint_mesh_target *target, const struct glint_paint *paint,
                      struct glint_mesh_lines *lines);
};

/* Pixels side by side on a line: whether they are in front, their albedo, their light. */
enum {
    GLINT_MESH_COLOURS,
    GLINT_MESH_NEAREST,
    GLINT_MESH_SQUARE, /* in assembly alone: nearest, width and height are one power of two */
    GLINT_MESH_PALETTE,
    GLINT_MESH_SMOOTH,
    GLINT_MESH_SOURCES
};
struct glint_mesh_pixels {
    uint32_t z, nl, now[3], back, dt; /* at the first one; back: t_max - t */
    uint32_t dz, dnl, step[3], ddt;
    uint16_t *depth;
    const uint16_t *end;   /* of depth */
    ptrdiff_t off;         /* bytes from a depth to its pixel */
    const uint8_t *levels; /* of the tables */
    const uint32_t *sums;
    uint32_t t_max, limit, shift, dark;
    struct glint_mesh_picture picture;
    uint8_t
        loop; /* 4 times where their albedo comes from, and 1 if they may be glossy, and 2 if their bytes are swapped */
};
/* Dark ones are matt with nl below 0. Has a twin in assembly. */
void glint_mesh_albedo_pixels(const struct glint_mesh_pixels *pixels);

/* fused_albedo.c */
void glint_mesh_albedo_lines(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                             const struct glint_mesh_target *target, const struct glint_texture *texture);

/* What is laid behind a triangle: set up where it is drawn for the first time. */
struct glint_mesh_laid *glint_mesh_albedo_laid(const struct glint_mesh_target *target,
                                               struct glint_mesh_triangle *triangle,
                                               const struct glint_texture *texture);

/* In assembly alone. The first sets what draws, the last draws one triangle, laid, by it. */
void glint_mesh_albedo_draws(struct glint_mesh_lines *lines);
uint32_t glint_mesh_albedo_begin(const struct glint_mesh_target *target, const struct glint_paint *paint,
                                 struct glint_mesh_lines *lines);
void glint_mesh_albedo_lines_set(const struct glint_mesh_target *target, const struct glint_tables *tables,
                                 const struct glint_texture *texture, struct glint_mesh_lines *lines);
void glint_mesh_albedo_triangle(const struct glint_mesh_target *target, struct glint_mesh_triangle *triangle,
                                const struct glint_tables *tables, const struct glint_texture *texture);

/* A line of n + 1 pixels on which colour k would leave 0..most is of one colour. */
static inline void glint_mesh_hold(uint32_t *now, uint32_t *step, unsigned k, uint32_t n)
{
    const uint32_t end = (uint32_t)(k == 1 ? 64 : 32) << 21, first = *now, last = first + n * *step;
    if (first < end && last < end)
        return;
    *now = first < end ? first : (int32_t)first < 0 ? 0 : end - 1;
    *step = 0;
}

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

/* The four around a place, and of 2^bits how far it is from the first to those right of it and below. */
struct glint_mesh_around {
    uint16_t of[2][2];
    uint32_t x, y;
};
static inline void glint_mesh_around_set(struct glint_mesh_around *around, const struct glint_mesh_picture *picture,
                                         uint32_t u, uint32_t v, unsigned bits)
{
    const uint32_t x = (u >> 16) * picture->w, y = (v >> 16) * picture->h;
    const uint32_t left = x >> 16, right = left + 1 < picture->w ? left + 1 : 0;
    const uint32_t top = (y >> 16) * picture->w, below = (y >> 16) + 1 < picture->h ? top + picture->w : 0;
    around->of[0][0] = glint_mesh_texel(picture, top + left);
    around->of[0][1] = glint_mesh_texel(picture, top + right);
    around->of[1][0] = glint_mesh_texel(picture, below + left);
    around->of[1][1] = glint_mesh_texel(picture, below + right);
    around->x = (x & 0xffff) >> (16 - bits);
    around->y = (y & 0xffff) >> (16 - bits);
}

/* In assembly: is each picture of the chain so, and has more than one texel? */
static inline bool glint_mesh_is_square(const struct glint_texture *texture)
{
    return GLINT_CORTEX_M0PLUS_ASM && !texture->is_smooth && !texture->palette && texture->w == texture->h &&
           (texture->w & (texture->w - 1u)) == 0 && texture->w >> texture->levels;
}
/* What loops take for a picture's height. */
static inline uint32_t glint_mesh_height_of(const struct glint_texture *texture,
                                            const struct glint_mesh_picture *picture)
{
    return glint_mesh_is_square(texture) ? glint_mesh_zeros(picture->w) + 1 : picture->h;
}

static inline uint32_t glint_mesh_fields(uint32_t texel)
{
    return (texel | texel << 16) & GLINT_ALBEDO_FIELDS;
}

/* As fields of ALBEDO tables, by weights whose sum is 32 and that are never below 0: no field overflows into its neighbour. */
static inline uint32_t glint_mesh_smooth_fields(const struct glint_mesh_picture *picture, uint32_t u, uint32_t v)
{
    struct glint_mesh_around a;
    glint_mesh_around_set(&a, picture, u, v, 5);
    const uint32_t both = (a.x * a.y + 16) >> 5, first = glint_mesh_fields(a.of[0][0]),
                   right = glint_mesh_fields(a.of[0][1]) - first, below = glint_mesh_fields(a.of[1][0]) - first;
    const uint32_t sum =
        32 * first + a.x * right + a.y * below + both * (glint_mesh_fields(a.of[1][1]) - first - right - below);
    return (sum + GLINT_ALBEDO_HALF) >> 5 & GLINT_ALBEDO_FIELDS;
}

/* Red, green and blue as these fields. */
static inline uint32_t glint_mesh_colour_fields(uint32_t red, uint32_t green, uint32_t blue)
{
    return red >> 21 << 11 | green >> 21 << 21 | blue >> 21;
}

#endif
