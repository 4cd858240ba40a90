/* SPDX-License-Identifier: MIT
 * Loops over the exact paths: rectangles and spans, prepared or not, and lights. */
#include "loops.h"

void exact_fill(void)
{
    bench_check(glint_shade_prepare(&exact_prepared, &bench_shader));
}

void exact_frame(void)
{
    bench_check(glint_shade_relight(&exact_prepared, &bench_shader.light));
}

static struct glint_surface line_from(uint16_t x)
{
    const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
    return surface;
}

static struct glint_source source(void)
{
    const struct glint_source from = {.normals = bench_line.normals,
                                      .mask = bench_line.mask,
                                      .albedo = bench_loop->look.albedo ? bench_albedo[0] : NULL,
                                      .gloss = bench_loop->look.gloss ? bench_gloss : NULL};
    return from;
}

void exact_line(const struct glint_prepared *prepared)
{
    const struct glint_source from = source();
    const struct glint_surface to = line_from(0);
    bench_check(glint_shade_prepared_rect(prepared, &from, SPHERE_W, 1, &to, NULL));
}

void exact_rect(void)
{
    exact_line(&exact_prepared);
}

void exact_call(void)
{
    const struct glint_source from = source();
    const struct glint_surface to = line_from(0);
    bench_check(glint_shade_rect(&bench_shader, &from, SPHERE_W, 1, &to, NULL));
}

/* ---- spans: the line's by pieces of at most so many pixels ---- */

static void spans_prepare(uint16_t width)
{
    struct glint_span *span = bench_spans;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + width), span++) {
        const uint16_t left = (uint16_t)(bench_line.to - x), w = left < width ? left : width;
        bench_check(
            glint_span_init(span, &bench_shader.light, &bench_line.normals[x], &bench_line.normals[x + w - 1], w));
    }
}

void bench_spans_16(void)
{
    spans_prepare(16);
}

void bench_spans_64(void)
{
    spans_prepare(64);
}

void exact_span(void)
{
    const struct glint_span *span = bench_spans;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + span->w), span++) {
        const struct glint_surface to = line_from(x);
        bench_check(glint_shade_prepared_span(&exact_prepared, span, &to, NULL));
    }
}

void exact_span_call(void)
{
    const struct glint_span *span = bench_spans;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + span->w), span++) {
        const struct glint_surface to = line_from(x);
        bench_check(glint_shade_span(&bench_shader, span, &to, NULL));
    }
}

/* ---- lights ---- */

static struct glint_lamp lamps[GLINT_LAMPS_MAX];
static int lamp_count;

void exact_lights_frame(void)
{
    lamp_count = sphere_lamps(lamps, (enum sphere_lamps)bench_loop->look.lamps);
    if (lamp_count < 0)
        bench_check((enum glint_err)lamp_count);
}

void exact_lights(void)
{
    const struct glint_source from = source();
    const struct glint_surface to = line_from(0);
    bench_check(glint_shade_lights(&bench_shader, lamps, (unsigned)lamp_count, &from, SPHERE_W, 1, &to, NULL));
}
