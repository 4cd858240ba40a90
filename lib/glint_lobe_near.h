/* SPDX-License-Identifier: MIT
 * A lobe from below, quickly: what the exact pixel takes from each model; not for users.
 *
 * A line is shaded in three stages over runs of samples: the geometry gives t and N.L, the model's loop F, the format's loop
 * levels. So a model is one loop, called once a run, and knows no format. Its F may be low by a few units, by a bound that is
 * stated: a level that this leaves open is drawn from the exact F. */
#ifndef GLINT_LOBE_NEAR_H
#define GLINT_LOBE_NEAR_H

#include "glint.h"
#include "glint_math_flash.h"

#define GLINT_RUN 16u /* samples at most */

struct glint_sample {
    uint32_t t_q30;  /* any; F is 0 from near->t_end on. UINT32_MAX where nl_q16 is 0 */
    uint32_t nl_q16; /* step 2 */
    uint32_t f_q16;  /* the model's loop fills it: step 3, or a little less */
};

/* glint_shade_msh and so on: const, one a model. */
struct glint_shade_model {
    uint8_t model; /* enum glint_model */
    uint8_t slack; /* f <= F <= f + slack for every t */
    /* NULL: t is that of the half vector. Else fills count samples' t and N.L from normals. */
    void (*geometry)(const struct glint_light *light, const struct glint_vec *normals, struct glint_sample *samples,
                     unsigned count);
    void (*fold)(struct glint_near *near); /* near->k from the rest of near; NULL: there is none */
    void (*run)(const struct glint_near *near, struct glint_sample *samples, unsigned count);
    uint32_t (*exact)(uint32_t n, uint32_t t_q30);
};

/* Blinn's, which Phong shares. */
void glint_blinn_run(const struct glint_near *near, struct glint_sample *samples, unsigned count);

/* Every model's loop: f(near, t) is asked only where F > 0. With f known at compile time no call is left. */
static inline __attribute__((always_inline)) void
glint_near_run(const struct glint_near *near, struct glint_sample *sample, unsigned count,
               uint32_t (*f)(const struct glint_near *near, uint32_t t_q30))
{
    const struct glint_sample *end = sample + count;
    const uint32_t t_end = near->t_end;
    do
        sample->f_q16 = sample->t_q30 < t_end ? f(near, sample->t_q30) : 0;
    while (++sample != end);
}

#endif
