/* SPDX-License-Identifier: MIT
 * What the paths over rectangles of normals share; internal. */
#ifndef GLINT_RECT_H
#define GLINT_RECT_H

#include "glint_lobe_near.h"

/* Can this be drawn? GLINT_OK, or what glint_shade_rect answers. */
enum glint_err glint_rect_check(const struct glint_shader *shader, const struct glint_source *source,
                                const struct glint_surface *surface);

/* The same of the maps alone; false for GLINT_ERR_ARG. */
bool glint_rect_can(const struct glint_source *source, const struct glint_surface *surface);

/* Steps 1 and 2 for count normals, t by the half vector; for lights that glint_light_is_wide says no or yes of. */
void glint_samples_unit(const struct glint_light *light, const struct glint_vec *normals, struct glint_sample *samples,
                        unsigned count);
void glint_samples_wide(const struct glint_light *light, const struct glint_vec *normals, struct glint_sample *samples,
                        unsigned count);

/* How many pixels from x on, which is one, are drawn, side by side, up to `most`. */
unsigned glint_rect_length(const uint8_t *mask, uint32_t x, uint32_t w, unsigned most);

/* A line of the maps. */
struct glint_line {
    const struct glint_vec *normals;
    const uint8_t *albedo, *gloss, *mask; /* NULL: none */
};

static inline const uint8_t *glint_line_of(const uint8_t *map, ptrdiff_t stride, uint16_t y)
{
    return map ? map + stride * (ptrdiff_t)y : NULL;
}

static inline struct glint_line glint_line_at(const struct glint_source *s, uint16_t y)
{
    const uint8_t *normals = glint_line_of((const uint8_t *)s->normals, s->normals_stride, y);
    const struct glint_line line = {
        (const struct glint_vec *)(const void *)normals, glint_line_of(s->albedo, s->albedo_stride, y),
        glint_line_of(s->gloss, s->gloss_stride, y), glint_line_of(s->mask, s->mask_stride, y)};
    return line;
}

/* The smallest box that holds what has been added, lines from the top. */
struct glint_bounds {
    uint16_t left, right, top, bottom;
    bool any;
};
void glint_bounds_add(struct glint_bounds *b, uint16_t x, uint16_t y);
void glint_bounds_box(const struct glint_bounds *b, struct glint_box *box); /* box may be NULL */

#endif
