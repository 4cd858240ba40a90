/* SPDX-License-Identifier: MIT
 * What the tests of ALBEDO tables share. */
#ifndef UNIT_ALBEDO_H
#define UNIT_ALBEDO_H

#include "shading.h"

static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];

static inline struct glint_shader grey_shader(uint32_t n, enum glint_format format)
{
    struct glint_shader s;
    memset(&s, 0, sizeof s);
    glint_lobe_init(&s.lobe, GLINT_MSH, n, 8);
    static const int32_t to_light[3] = {3, 4, 5}, to_viewer[3] = {0, 0, 1};
    assert_int_equal(glint_light_init(&s.light, to_light, to_viewer), GLINT_OK);
    for (int k = 0; k < 3; k++) {
        s.material.ambient_q16[k] = 6000;
        s.material.diffuse_q16[k] = 58000;
        s.material.specular_q16[k] = 30000 + 10000 * (uint32_t)k;
    }
    s.format = (uint8_t)format;
    return s;
}

static inline void prepare(struct glint_tables *tables, struct glint_tables_light *light,
                           const struct glint_shader *shader)
{
    assert_int_equal(glint_tables_fill(tables, GLINT_TABLES_ALBEDO, shader, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_tables_light_init(light, tables, &shader->light), GLINT_OK);
}

#endif
