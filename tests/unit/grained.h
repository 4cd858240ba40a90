/* SPDX-License-Identifier: MIT
 * Models that may have grain, and what tests of it draw. */
#ifndef GLINT_UNIT_GRAINED_H
#define GLINT_UNIT_GRAINED_H

#include "shading.h"

static const uint8_t grained[] = {GLINT_MSH, GLINT_SCHLICK, GLINT_CAYLEY, GLINT_LYON, GLINT_GGX};
enum { GRAINED = sizeof grained };

static inline struct look metal(enum glint_model model, uint16_t n, uint16_t across)
{
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    static const int32_t to_light[3] = {-5, 6, 9};
    set_model(&look, model, n, 16);
    look.material.n_across = across;
    look.material.clamp_peak = false;
    look.output.dither = false;
    for (int k = 0; k < 3; k++) {
        look.material.ambient_q16[k] = 4000;
        look.material.diffuse_q16[k] = 9000;
        look.material.specular_q16[k] = 52000;
        look.material.albedo[k] = 200;
    }
    assert_int_equal(look_light(&look, to_light, in_front), GLINT_OK);
    return look;
}

#endif
