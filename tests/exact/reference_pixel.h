/* SPDX-License-Identifier: MIT
 * Pixels as sequence.md has them, step by step in 64 bits: what every fast way of the library must equal. */
#ifndef GLINT_EXACT_REFERENCE_PIXEL_H
#define GLINT_EXACT_REFERENCE_PIXEL_H

#include "glint.h"

/* What is drawn with. */
struct reference {
    struct glint_material material;
    struct glint_output output;
    struct glint_light lights[GLINT_LIGHTS_MAX];
    unsigned count;
    int32_t to_viewer[3];
};

/* A rectangle or a span at work: begun with its first five fields. */
struct reference_lines {
    const struct reference *look;
    const struct glint_maps *maps; /* NULL: none */
    const struct glint_surface *target;
    bool any_f;           /* the highlight is where F is, whatever the light's colour: of one directional light */
    uint32_t t_last;      /* reference_t_last */
    struct glint_box box; /* what shines so far */
    uint32_t right;
};

/* The normal of a pixel; false where there is none, or no coverage. */
bool reference_at(const struct reference_lines *lines, uint32_t x, uint32_t y, struct glint_vec *normal);
bool reference_is_covered(const struct reference_lines *lines, uint32_t x, uint32_t y);
/* The last t where F is. */
uint32_t reference_t_last(const struct reference *look);
/* Step 2; step 3 of t, or of a normal whose light is L, V, H. */
uint32_t reference_nl_of(int64_t nl_q30);
uint32_t reference_lobe(const struct reference_lines *lines, uint32_t t, uint32_t nl);
uint32_t reference_nl(struct glint_vec normal, const struct glint_vec *l);
uint32_t reference_f(const struct reference_lines *lines, uint32_t x, uint32_t y, struct glint_vec normal,
                     const struct glint_vec lvh[3]);
/* Is there grain, or a map of shininess? F then, of a span: */
bool reference_is_grained(const struct reference_lines *lines);
uint32_t reference_span_f(const struct reference_lines *lines, const struct glint_span *span, uint32_t x, uint32_t t,
                          uint32_t nl, struct glint_vec h);
/* x / |x|; false where it does not exist. |v| < 2^62. */
bool reference_unit(int64_t out[3], const int64_t v[3]);
/* Steps 4 to 9, of what lights sum to; f: does it shine at all? */
void reference_put(struct reference_lines *lines, uint32_t x, uint32_t y, const uint64_t lit[3],
                   const uint64_t shine[3], bool f);

#endif
