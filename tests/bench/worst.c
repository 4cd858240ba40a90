/* SPDX-License-Identifier: MIT */
#include "worst.h"

#ifndef __AVR__ /* it has no room for maps */
#include "glint_pixel.h"

uint8_t worst_open[SPHERE_W];

static const struct glint_use_format *counted;

static void count_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                        const struct glint_sample *sums, unsigned apart)
{
    worst_open[run->x + i] = 1;
    counted->exact(paint, run, i, sums, apart);
}

/* The format with another last function: what the bound leaves open goes there. */
uint32_t worst_count(void)
{
    struct glint_paint with_count = bench_paint;
    struct glint_use_format counting = *bench_paint.format;
    counted = bench_paint.format;
    counting.exact = count_exact;
    with_count.format = &counting;
    for (int x = 0; x < SPHERE_W; x++)
        worst_open[x] = 0;
    bench_rect_by(&with_count, MAP_INT16, NULL);
    uint32_t count = 0;
    for (int x = 0; x < SPHERE_W; x++)
        count += worst_open[x];
    return count;
}

/* Step 1, in the geometry of the lobe's model. */
uint32_t worst_t(uint32_t x)
{
    struct glint_sample sample;
    (bench_paint.model->geometry ? bench_paint.model->geometry : glint_samples_half)(
        &bench_paint.l, &bench_paint.v, &bench_paint.h, &bench_line.normals[x], &sample, 1);
    return sample.t_q30 >> 31 ? (uint32_t)1 << 31 : sample.t_q30;
}

/* F as the sequence of a pixel that is open finds it. */
uint32_t worst_lobe(uint32_t t_q30)
{
    return glint_paint_f(&bench_paint, t_q30);
}

void worst_material(uint32_t red, uint32_t green, uint32_t blue)
{
    const uint32_t ambient[3] = {red, green, blue};
    for (int k = 0; k < 3; k++)
        bench_material.ambient_q16[k] = ambient[k];
    exact_fill();
    bench_light();
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
    bench_line.y = bench_loop->look.lights ? SPHERE_H / 2 : 0; /* within a spot's cone */
}
#endif
