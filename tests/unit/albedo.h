/* SPDX-License-Identifier: MIT
 * What the tests of ALBEDO tables share. */
#ifndef UNIT_ALBEDO_H
#define UNIT_ALBEDO_H

#include "tables_model.h"

static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];

static inline struct look grey_look(uint16_t n, enum glint_format format)
{
    struct look s;
    memset(&s, 0, sizeof s);
    set_model(&s, GLINT_MSH, n, 8);
    static const int32_t to_light[3] = {3, 4, 5};
    assert_int_equal(look_light(&s, to_light, in_front), GLINT_OK);
    make_grey(&s, 6000, 58000);
    for (uint32_t k = 0; k < 3; k++)
        s.material.specular_q16[k] = 30000 + 10000 * k;
    s.output.format = (uint8_t)format;
    return s;
}

/* Normals in a format, and albedo, w pixels a line. */
static inline struct glint_maps maps_over(enum glint_normals format, const void *normals, const uint16_t *albedo,
                                          uint16_t w)
{
    const struct glint_maps maps = {.normals = normals,
                                    .normals_stride = w * (format == GLINT_NORMALS_INT8 ? 4 : 6),
                                    .normals_format = (uint8_t)format,
                                    .albedo = (const uint8_t *)albedo,
                                    .albedo_stride = 2 * w,
                                    .albedo_format = GLINT_RGB565};
    return maps;
}

#endif
