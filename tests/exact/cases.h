/* SPDX-License-Identifier: MIT
 * Materials, lights, normals and many cases of them, likely or hostile. A case has its own generator, so that cases are the same for any
 * number of threads. */
#ifndef GLINT_EXACT_CASES_H
#define GLINT_EXACT_CASES_H

#include <stddef.h>

#include "reference_lights.h"

/* Here, since a case takes many. */
static inline uint32_t case_below(uint64_t *seed, uint32_t limit)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((*seed >> 32) * limit >> 32);
}
#define BELOW(limit) case_below(seed, limit)
#define ONE_IN(count) (case_below(seed, count) == 0)

struct glint_vec case_vector(uint64_t *seed);
/* Any colour: white, dim, bright, black. */
void case_color(uint64_t *seed, struct glint_light *light);
/* Material, output and viewer, and one directional light that there can be. lvh: what the light comes to. */
struct reference case_look(uint64_t *seed, struct glint_vec lvh[3]);
/* In doubles, within a unit of glint_vec_normalize, which takes longer than a pixel; (0, 0, 1) for a zero vector. */
struct glint_vec case_unit(const double v[3]);
/* Of the whole sphere, near the half vector, or anything. */
struct glint_vec case_normal(uint64_t *seed, struct glint_vec h, int spread);

/* A picture with its maps. */
enum { CASE_W = 61, CASE_H = 8, CASE_LINE = 4 * CASE_W + 13, CASE_SIZE = (CASE_H + 2) * CASE_LINE, CASE_GUARD = 0xa5 };
struct case_scene {
    struct glint_vec normals[CASE_W * CASE_H];
    uint32_t words[CASE_W * CASE_H];
    uint8_t albedo[3 * CASE_W * CASE_H], gloss[CASE_W * CASE_H], coverage[CASE_W * CASE_H], bytes[CASE_W * CASE_H];
    uint8_t out[CASE_SIZE], expected[CASE_SIZE];
};
/* Some of the maps, of lines from the top or the last one's, and of a line step normals; w x h pixels are set. Normals are not. */
struct glint_maps case_maps(uint64_t *seed, struct case_scene *scene, unsigned w, unsigned h);
/* Grain or shininess, where the material may have it. */
void case_grain(uint64_t *seed, struct case_scene *scene, const struct glint_material *material, bool normals,
                struct glint_maps *maps);
bool case_has_grain(uint8_t model);
/* Where its pixels go; up or down, at any address; both pictures are filled with CASE_GUARD. */
struct glint_surface case_target(uint64_t *seed, struct case_scene *scene);
/* The same place in the expected picture. */
struct glint_surface case_expected(struct case_scene *scene, const struct glint_surface *target);
/* Are pictures and boxes the same? */
bool case_same(const struct case_scene *scene, const struct glint_box *a, const struct glint_box *b);

/* reference_paint, with a fault where GLINT_FAULT in the environment names one, which a test then is to find (test_bounds): half-w, w, half-maps-w,
 * maps-w, linear-w: bounds of V that are half of what they should be, or 0; high, color-w: of coloured light; sums-w, sums-most: of several lights;
 * slack-MODEL: a model that says to be exact. */
enum glint_err case_paint(struct glint_paint *paint, const struct reference *look);

/* Cases until `share` thousandths of GLINT_PIXELS million pixels are drawn, 100 where it is not set. `one` draws one case in so many
 * bytes of memory of its own, and returns how many pixels; 0 where one differs: then the case's number is printed. */
bool cases_pass(unsigned (*one)(uint64_t *seed, void *memory), size_t bytes, unsigned share);

#endif
