/* SPDX-License-Identifier: MIT */
#include "worst.h"

#ifndef __AVR__ /* it has no room for maps */
#include "glint_pixel.h"
#include "glint_pixel_prepared.h"

uint8_t worst_open[SPHERE_W];

static const struct glint_shade_format *counted;

static void count_exact(const struct glint_shader *shader, const struct glint_run *run, unsigned i, uint32_t nl_q16,
                        uint32_t f_q16)
{
    worst_open[run->x + i] = 1;
    counted->exact(shader, run, i, nl_q16, f_q16);
}

/* The format with another last function: what the bound leaves open goes there. */
uint32_t worst_count(void)
{
    struct glint_prepared with_count = exact_prepared;
    struct glint_shade_format counting = *exact_prepared.format;
    counted = exact_prepared.format;
    counting.exact = count_exact;
    with_count.format = &counting;
    for (int x = 0; x < SPHERE_W; x++)
        worst_open[x] = 0;
    exact_line(&with_count);
    uint32_t count = 0;
    for (int x = 0; x < SPHERE_W; x++)
        count += worst_open[x];
    return count;
}

/* Step 1, in the geometry of the lobe's model. */
uint32_t worst_t(uint32_t x)
{
    const struct glint_vec *normal = &bench_line.normals[x];
    if (bench_shader.lobe.model == GLINT_PHONG)
        return glint_phong_t(normal, &bench_shader.light);
    const uint64_t sum = glint_distance_squared(normal, &bench_shader.light.h);
    return sum >> 32 ? (uint32_t)1 << 31 : (uint32_t)(sum >> 1);
}

/* F as the sequence of a pixel that is open finds it. */
uint32_t worst_lobe(uint32_t t_q30)
{
    return t_q30 < exact_prepared.near.t_end ? exact_prepared.model->exact(exact_prepared.near.n, t_q30) : 0;
}

void worst_material(uint32_t red, uint32_t green, uint32_t blue)
{
    const uint32_t ambient[3] = {red, green, blue};
    for (int k = 0; k < 3; k++)
        bench_shader.material.ambient_q16[k] = ambient[k];
    exact_fill();
}

void worst_begin(void)
{
    static const uint8_t albedo[3] = {250, 203, 151};
    for (int x = 0; x < SPHERE_W; x++) {
        bench_gloss[x] = 230;
        for (int k = 0; k < 3; k++)
            bench_albedo[x][k] = albedo[k];
        bench_line.mask[x] = 255;
    }
    bench_line.y = 0;
}
#endif
