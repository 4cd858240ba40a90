/* SPDX-License-Identifier: MIT
 * Loops over the line by bench_paint: rectangles and spans. */
#include "loops.h"

void exact_fill(void)
{
    bench_check(glint_paint_exact(&bench_paint, &bench_material, &bench_output));
}

void bench_light(void)
{
    const int count = sphere_lights(bench_lights, (enum sphere_lights)bench_loop->look.lights);
    bench_check(count < 0 ? (enum glint_err)count
                          : glint_paint_light(&bench_paint, bench_lights, (unsigned)count, sphere_viewer));
}

static struct glint_surface line_from(uint16_t x)
{
    const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
    return surface;
}

/* Is the line to be blended? */
static bool is_soft(void)
{
    return bench_loop->pack == bench_soft_edges || bench_loop->pack == bench_soft_all;
}

/* The line's maps: albedo as the paint takes it. */
static struct glint_maps maps_of(const struct glint_paint *paint, enum bench_map map)
{
    const bool exact = paint->format != NULL;
    struct glint_maps maps = {.normals = bench_line.normals,
                              .coverage = exact || is_soft() ? bench_line.mask : NULL,
                              .albedo = exact && bench_loop->look.albedo ? bench_albedo[0] : NULL,
                              .albedo_format = GLINT_RGB888,
                              .gloss = bench_loop->look.gloss ? bench_gloss : NULL};
#ifndef __AVR__
    if (map == MAP_INT8) {
        maps.normals = bench_map;
        maps.normals_format = GLINT_NORMALS_INT8;
    }
    if (!exact && bench_loop->look.albedo) {
        maps.albedo = (const uint8_t *)bench_albedo_565;
        maps.albedo_format = GLINT_RGB565;
    }
#else
    (void)map;
#endif
    sphere_grain(&maps, &bench_loop->look, bench_grain, 0);
    return maps;
}

void bench_rect_by(const struct glint_paint *paint, enum bench_map map, struct glint_box *highlight)
{
    static struct glint_maps maps; /* as a program has them: set for the map at hand alone */
    static const struct bench_loop *of;
    const struct glint_surface to = line_from(0);
    if (of != bench_loop)
        maps = maps_of(paint, map);
    of = bench_loop;
    bench_check(glint_draw_rect(paint, &maps, SPHERE_W, 1, &to, highlight));
}

void bench_rect(void)
{
    bench_rect_by(&bench_paint, (enum bench_map)bench_loop->map, NULL);
}

/* What is blended lies on what it is itself, so that the picture stays near the exact one. */
void bench_soft_edges(void)
{
    static const uint8_t edge[] = {60, 200};
    bench_rect();
    for (int i = 0; i < 2 && 2 * i < bench_line.to - bench_line.from; i++)
        bench_line.mask[bench_line.from + i] = bench_line.mask[bench_line.to - 1 - i] = edge[i];
}

void bench_soft_all(void)
{
    bench_rect();
    for (int x = bench_line.from; x < bench_line.to; x++)
        bench_line.mask[x] = (uint8_t)(1 + x % 254);
}

/* ---- spans: the line's by pieces of at most so many pixels ---- */

static void spans_prepare(uint16_t width)
{
    struct glint_span *span = bench_spans;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + width), span++) {
        const uint16_t left = (uint16_t)(bench_line.to - x), w = left < width ? left : width;
        bench_check(glint_span_init(span, &bench_paint, &bench_line.normals[x], &bench_line.normals[x + w - 1], w));
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

void bench_span(void)
{
    const struct glint_span *span = bench_spans;
    struct glint_maps maps;
    const uint8_t *albedo = NULL;
    if (bench_loop->look.albedo) {
        maps = maps_of(&bench_paint, MAP_INT16);
        maps.coverage = NULL;
        albedo = maps.albedo;
    }
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + span->w), span++) {
        const struct glint_surface to = line_from(x);
        if (albedo)
            maps.albedo = albedo + 2 * x;
        bench_check(glint_draw_span(&bench_paint, span, albedo ? &maps : NULL, &to, NULL));
    }
}
