/* SPDX-License-Identifier: MIT
 * Colours and textures of meshes, for tests; and light in which they are the pixels. */
#ifndef GLINT_UNIT_MESH_COLOURS_H
#define GLINT_UNIT_MESH_COLOURS_H

#include "meshes.h"
#include "tables_model.h"

/* For faces or vertices; some channels full or 0. */
static inline void colour_at_random(struct made_mesh *m)
{
    for (unsigned i = 0; i < MESH_FACES; i++)
        for (int k = 0; k < 3; k++)
            m->colours[i][k] = (uint8_t)(below(8) ? below(256) : 255 * below(2));
}

/* In a block of its own, so that reading beyond it is noticed; to be freed. */
struct made_texture {
    struct glint_texture texture;
    uint16_t *palette;
    void *pixels;
};

static inline struct made_texture texture_at_random(void)
{
    static const uint16_t sides[] = {1, 2, 3, 5, 8, 16, 60, 64, 100, 2048};
    struct made_texture t = {.texture = {.w = sides[below(10)], .h = sides[below(9)]}};
    size_t count = 0;
    unsigned w = t.texture.w, h = t.texture.h;
    t.texture.levels = (uint8_t)(1 + below(12));
    t.texture.is_smooth = below(2);
    for (unsigned i = 0; i < t.texture.levels; i++) {
        count += (size_t)w * h;
        w = w > 1 ? w / 2 : 1;
        h = h > 1 ? h / 2 : 1;
    }
    const bool has_palette = below(2);
    t.pixels = malloc(count * (has_palette ? 1 : 2));
    if (has_palette) {
        t.palette = malloc(256 * sizeof *t.palette);
        for (unsigned i = 0; i < 256; i++)
            t.palette[i] = (uint16_t)below(65536);
    }
    for (size_t i = 0; i < count; i++)
        if (has_palette)
            ((uint8_t *)t.pixels)[i] = (uint8_t)below(256);
        else
            ((uint16_t *)t.pixels)[i] = (uint16_t)below(65536);
    t.texture.pixels = t.pixels;
    t.texture.palette = t.palette;
    return t;
}

static inline void texture_free(struct made_texture *t)
{
    free(t->pixels);
    free(t->palette);
}

static inline void uv_at_random(struct made_mesh *m)
{
    for (unsigned i = 0; i < MESH_VERTICES; i++)
        for (int k = 0; k < 2; k++)
            m->uv[i][k] = (uint16_t)below(65536);
    m->mesh.uv = &m->uv[0][0];
    m->mesh.uv_bits = (uint8_t)(8 + below(8));
}

/* The albedo is the pixel: no light but ambient, as much as there is. */
static inline struct look bare(enum glint_format format)
{
    struct look look = random_look(format, GLINT_GAMMA);
    set_model(&look, GLINT_MSH, 60, 8);
    look.output.dither = false;
    make_grey(&look, 65536, 0);
    memset(look.material.specular_q16, 0, sizeof look.material.specular_q16);
    return look;
}

/* The look by ALBEDO tables, for light that they hold; false where they do not have its model or format. */
static inline bool paint_of_albedo(struct glint_paint *paint, const struct look *of, uint32_t *memory)
{
    struct look look = *of;
    make_grey(&look, 10000, 50000);
    look.output.dither = false;
    if (glint_paint_tables(paint, GLINT_TABLES_ALBEDO, &look.material, &look.output, memory, GLINT_TABLES_ALBEDO_BYTES))
        return false;
    assert_int_equal(glint_paint_light(paint, &look.light, 1, in_front), GLINT_OK);
    return true;
}

/* Where the library has a place that is not turned: 1/16 pixel from the middle. */
static inline double on_screen(int32_t place, uint32_t scale)
{
    return scale < 16384 ? (double)((place * (int32_t)scale + 16384) >> 15)
                         : (double)(((int64_t)(place >> 2) * (int32_t)scale + 4096) >> 13);
}

#endif
