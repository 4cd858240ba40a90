/* SPDX-License-Identifier: MIT */
#include "demo.h"

void demo_shader(struct glint_shader *shader)
{
    static const struct glint_shader gold = {.material = {.ambient_q16 = {5200, 5200, 5200},
                                                          .diffuse_q16 = {43000, 43000, 43000},
                                                          .specular_q16 = {65536, 62000, 50000},
                                                          .albedo = {230, 168, 66}},
                                             .format = GLINT_RGB565,
                                             .space = GLINT_GAMMA};
    *shader = gold;
    glint_lobe_init(&shader->lobe, GLINT_MSH, 60, 6); /* below 2^-6 a step of 565 hides it */
}
