/* SPDX-License-Identifier: MIT
 * Internal. Grain, and maps of shininess: m = n_across t + (n - n_across) (H.T)^2 / 2, or n t of a pixel's own n, in the place of n t.
 * F has two arguments then, t and m (Q10.22, < 2^32); all of it hangs on the pointer in a model's glint_use_NAME_grain. */
#ifndef GLINT_GRAIN_H
#define GLINT_GRAIN_H

#include "glint_draw.h"

#define GLINT_GRAIN_BITS 22u /* of m: fraction */
#define GLINT_GRAIN_NONE UINT32_MAX
#define GLINT_GRAIN_MOST ((uint32_t)GLINT_N_MAX << GLINT_GRAIN_BITS) /* the largest m */

struct glint_lights;

struct glint_use_grain {
    /* m from which on F < 2^-q whatever t is; it may be too large. */
    uint32_t (*m_end)(unsigned q);
    /* F from below of count samples, whose f_q16 holds m: f <= F <= f + the model's slack, and 0 exactly where F is; t becomes UINT32_MAX
     * there. */
    void (*run)(const struct glint_paint *paint, struct glint_sample *samples, unsigned count);
    /* F of t <= 1 and m, correctly rounded; is the true one 2^-q at least? */
    uint32_t (*exact)(uint32_t m, uint32_t t_q30);
    bool (*reaches)(uint32_t m, uint32_t t_q30, unsigned q);
    /* ---- the same for all models: grain.c ---- */
    /* F by its definition, held to the peak. */
    uint32_t (*f)(const struct glint_paint *paint, uint32_t m, uint32_t t_q30);
    /* Are the maps of w x h pixels such that a rectangle, or a span, can be drawn? lines->draw becomes `draw` where F is of two
     * arguments. */
    enum glint_err (*check)(const struct glint_paint *paint, struct glint_lines *lines, uint32_t h, bool normals);
    /* Draws under one directional light, or none. at: the span's, or NULL. */
    void (*draw)(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                 struct glint_box *highlight);
    /* Several lights of a paint, which are begun, are to draw these lines: sets what draws grain, where there is any. */
    void (*light)(struct glint_lights *lights, struct glint_lines *lines);
    /* Steps 1, 2 and 2a for the run's pixels from `from` on: f_q16 is m; t and it are UINT32_MAX where F is 0 for sure. Of a span
     * steps 1 and 2 are done, and there are no normals. */
    void (*sample)(const struct glint_paint *paint, const struct glint_lines *lines, const struct glint_span *span,
                   const struct glint_view *view, const struct glint_vec *normals, struct glint_sample *samples,
                   unsigned from, unsigned count);
};

/* Is F of two arguments? */
static inline bool glint_grain_is_drawn(const struct glint_paint *paint, const struct glint_maps *maps)
{
    return glint_material_across(&paint->material) || (maps && maps->shininess);
}

/* Every model's loop. near: F or 1 less, rounded, whether F reaches 2^-q or not, for t <= 1 and m < m_end. It need not be asked whether F
 * reaches 2^-q but where near is that, or 1 less. */
static inline __attribute__((always_inline)) void
glint_grain_run(const struct glint_paint *paint, struct glint_sample *sample, unsigned count, uint32_t end,
                uint32_t (*near)(uint32_t scale, uint32_t m, uint32_t t_q30), uint32_t scale,
                bool (*reaches)(uint32_t m, uint32_t t_q30, unsigned q))
{
    const unsigned q = glint_clamp_q(paint->material.q);
    const uint32_t least = (uint32_t)65536 >> q, most = paint->of.exact.f_max;
    do {
        const uint32_t m = sample->f_q16, t = sample->t_q30;
        uint32_t f = 0;
        if (m < end) {
            f = near(scale, m, t);
            if (f <= least) {
                if (f + 1 >= least && reaches(m, t, q))
                    f = least;
                else
                    f = 0;
            }
            f = f < most ? f : most;
        }
        sample->f_q16 = f;
        if (!f)
            sample->t_q30 = UINT32_MAX;
    } while (++sample, --count);
}

/* How far up MSH's E, Q20, goes such that the largest is just below 2^28, where m is below end. */
static inline uint32_t glint_msh_grain_up(uint32_t end)
{
    uint32_t up = 0;
    while ((end + ((uint32_t)5 << (GLINT_GRAIN_BITS - 2))) >> (27 - up) == 0)
        up++;
    return up;
}

/* The last fields of every model's. */
#define GLINT_GRAIN_USE_BY(draw) glint_grain_f, glint_grain_check, draw, glint_grain_light, glint_grain_sample
#define GLINT_GRAIN_USE GLINT_GRAIN_USE_BY(glint_grain_draw)
/* Where t (2 - t) / 2 takes the place of t in m. */
#define GLINT_GRAIN_USE_SINE                                                                                           \
    glint_grain_f, glint_grain_check, glint_grain_draw, glint_grain_light, glint_grain_sample_sine
uint32_t glint_grain_f(const struct glint_paint *paint, uint32_t m, uint32_t t_q30);
enum glint_err glint_grain_check(const struct glint_paint *paint, struct glint_lines *lines, uint32_t h, bool normals);
void glint_grain_draw(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                      struct glint_box *highlight);
/* Pixel `at` of the run, of normals or of a span, whose sample is left open, by the 64-bit sequence; its F. m is made again, as F took its
 * place; where F is 0, it is so exactly. */
uint32_t glint_grain_exactly(const struct glint_paint *paint, const struct glint_lines *lines,
                             const struct glint_span *span, struct glint_sample *sample, unsigned at);
/* Draws count of a line's pixels, of normals, from the run's place on. */
glint_draw_edge glint_grain_edge;
/* 2^15 sin, of 128ths of a quarter. */
extern const uint16_t glint_grain_sines[129]; /* GLINT_FLASH */
/* Before samples are made of a drawing's lines: their target and maps are set. */
void glint_grain_begin(struct glint_lines *lines);
void glint_grain_light(struct glint_lights *lights, struct glint_lines *lines);
void glint_grain_sample(const struct glint_paint *paint, const struct glint_lines *lines, const struct glint_span *span,
                        const struct glint_view *view, const struct glint_vec *normals, struct glint_sample *samples,
                        unsigned from, unsigned count);
void glint_grain_sample_sine(const struct glint_paint *paint, const struct glint_lines *lines,
                             const struct glint_span *span, const struct glint_view *view,
                             const struct glint_vec *normals, struct glint_sample *samples, unsigned from,
                             unsigned count);

/* ---- Meshes ---- */

/* Draws count pixels of a mesh's row under one directional light, or none. axis: of the mesh, turned by turn (Q14); samples: to work with. */
struct glint_use_axis {
    void (*row)(const struct glint_paint *paint, const struct glint_run *run, const int16_t axis[3], int16_t turn[3][3],
                const struct glint_vec *normals, struct glint_sample *samples, unsigned count);
};

#endif
