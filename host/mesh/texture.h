/* SPDX-License-Identifier: MIT
 * Pictures as the library's textures: scaled to a budget, with their chains of halves. */
#ifndef GLINT_MESH_TEXTURE_H
#define GLINT_MESH_TEXTURE_H

#include "glint_mesh.h"
#include "mesh/mesh.h"
#include "mesh/texture_palette.h"

enum { TEXTURE_BYTES_USUAL = 192 << 10 };

/* Of one picture; the library's texture points into the arrays. */
struct texture {
    struct glint_texture texture;
    const char *name; /* the picture's */
    uint16_t *pixels; /* RGB565; with a palette NULL */
    uint8_t *indices;
    uint16_t palette[TEXTURE_COLORS];
    unsigned colors; /* in the palette; 0: none */
};
size_t texture_pixels(const struct texture *texture); /* with those of its halves */
size_t texture_bytes(const struct texture *texture);  /* with its palette */
/* Of each picture that `is_used`. Ends the program through fail() where they do not fit. malloc'd. */
struct texture *textures_of(const struct mesh *mesh, const bool *is_used);
void textures_free(struct texture *textures, unsigned count);

/* A pixel of one of its pictures, in levels of 255; x and y of any size, since it repeats. */
void texture_color(const struct glint_texture *texture, unsigned level, long x, long y, double rgb[3]);
/* The width and height of one of its pictures. */
void texture_size(const struct glint_texture *texture, unsigned level, uint32_t size[2]);

/* Encoded sRGB, 0..1, and linear light. */
double texture_decode(double encoded);
double texture_encode(double linear);

#endif
