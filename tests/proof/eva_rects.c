/* SPDX-License-Identifier: MIT
 * For Eva: exact paints, made and lit by one light; rectangles and spans by them, of any normals, maps, coverage, places and spans. Runs of pixels
 * as eva_pixels.c has them stand for every format and model, so that here it is RGB565 by Lyon.
 * eva: -eva-precision 1 -eva-min-loop-unroll 24 -eva-slevel 20 -eva-ilevel 64 -eva-split-return auto -eva-use-spec VALUES,glint_unit_q30 */
#include "eva.h"
#include "eva_directions.h"
#include "glint_draw.h"

enum { WIDE = GLINT_RUN + 2, HIGH = 2 }; /* two runs */
static uint8_t pixels[2 * WIDE * HIGH], albedo[3 * WIDE * HIGH], gloss[WIDE * HIGH], coverage[WIDE * HIGH];
static struct glint_vec normals[WIDE * HIGH];
static uint32_t words[2 * HIGH];
static struct glint_paint paint;

static void make(void)
{
    const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, any & 1};
    const struct glint_material material = any_material(GLINT_LYON);
    (void)glint_paint_exact_for(&paint, &material, &output, &glint_use_lyon, &glint_use_rgb565);
    paint.l = any_vector();
    paint.v = any_vector();
    paint.h = any_vector();
    paint.light_count = 1;
    ANY_BYTES(normals);
    ANY_BYTES(albedo);
    ANY_BYTES(gloss);
}

static void draw(const struct glint_maps *maps, uint16_t w)
{
    const struct glint_surface surface = {pixels, 2 * w, (uint16_t)any, (uint16_t)any};
    struct glint_box box;
    (void)glint_draw_rect(&paint, maps, w, HIGH, &surface, &box);
    (void)glint_draw_rect(&paint, maps, w, HIGH, &surface, NULL);
}

static struct glint_maps maps_of(uint16_t w, bool mapped)
{
    const struct glint_maps maps = {.normals = normals,
                                    .normals_stride = w * (ptrdiff_t)sizeof *normals,
                                    .albedo = mapped ? albedo : NULL,
                                    .albedo_stride = 3 * w,
                                    .gloss = mapped ? gloss : NULL,
                                    .gloss_stride = w,
                                    .coverage_stride = w,
                                    .normals_format = GLINT_NORMALS_INT16,
                                    .albedo_format = GLINT_RGB888};
    return maps;
}

void eva_rect(void)
{
    const struct glint_maps maps = maps_of(WIDE, false);
    make();
    draw(&maps, WIDE);
}
void eva_rect_maps(void)
{
    const struct glint_maps maps = maps_of(WIDE, true);
    make();
    draw(&maps, WIDE);
}
/* Every coverage of two lines of two pixels. */
void eva_rect_covered(void)
{
    struct glint_maps maps = maps_of(2, true);
    maps.coverage = coverage;
    make();
    for (unsigned bits = 0; bits < 16; bits++) {
        for (unsigned i = 0; i < 4; i++)
            coverage[i] = bits >> i & 1 ? 255 : 0;
        draw(&maps, 2);
    }
}
/* INT8, with every gap of two lines of two pixels. */
void eva_rect_int8(void)
{
    struct glint_maps maps = maps_of(2, true);
    maps.normals = words;
    maps.normals_stride = 2 * sizeof *words;
    maps.normals_format = GLINT_NORMALS_INT8;
    make();
    for (unsigned bits = 0; bits < 16; bits++) {
        for (unsigned i = 0; i < 4; i++)
            words[i] = bits >> i & 1 ? 65536 + any % (UINT32_MAX - 65535) : any % 65536;
        draw(&maps, 2);
    }
}

static struct glint_span any_span(uint16_t w)
{
    const struct glint_span span = {any, any, any, any_signed, any_signed, w, {{0, 0}, {0, 0}}};
    return span;
}

void eva_span(void)
{
    const struct glint_span span = any_span(WIDE);
    const struct glint_surface surface = {pixels, 0, (uint16_t)any, (uint16_t)any};
    struct glint_box box;
    make();
    (void)glint_draw_span(&paint, &span, NULL, &surface, &box);
    paint.light_count = 0;
    (void)glint_draw_span(&paint, &span, NULL, &surface, NULL);
}
/* With maps, and every coverage of four pixels. */
void eva_span_maps(void)
{
    struct glint_maps maps = maps_of(4, true);
    const struct glint_surface surface = {pixels, 0, (uint16_t)any, (uint16_t)any};
    struct glint_box box;
    maps.coverage = coverage;
    make();
    for (unsigned bits = 0; bits < 16; bits++) {
        const struct glint_span span = any_span(4);
        for (unsigned i = 0; i < 4; i++)
            coverage[i] = bits >> i & 1 ? 255 : 0;
        (void)glint_draw_span(&paint, &span, &maps, &surface, &box);
    }
}

/* A box's bounds are set before they are read. */
void eva_bounds_one(void)
{
    struct glint_bounds bounds;
    struct glint_box box;
    glint_bounds_begin(&bounds);
    glint_bounds_box(&bounds, &box);
    for (unsigned i = 0; i < 2; i++) {
        glint_bounds_add(&bounds, any, any);
        glint_bounds_box(&bounds, &box);
    }
}

/* Any model and output, also those that there are not. */
void eva_paint_exact(void)
{
    struct glint_material material = any_material((uint8_t)any);
    const struct glint_output output = {(uint8_t)any, (uint8_t)any, any & 1};
    material.n = (uint16_t)any;
    material.n_across = (uint16_t)any;
    (void)glint_paint_exact(&paint, &material, &output);
}

/* One directional light of any colour for a paint of every format, and none. */
static void lit(const struct glint_use_format *use, uint8_t format, uint8_t space)
{
    static const int32_t ahead[3] = {0, 0, 1};
    const int32_t v[3] = {any_signed, any_signed, any_signed};
    const struct glint_output output = {format, space, any & 1};
    const struct glint_material material = any_material(GLINT_LYON);
    struct glint_light light;
    (void)glint_paint_exact_for(&paint, &material, &output, &glint_use_lyon, use);
    if (glint_light_directional(&light, ahead))
        return;
    for (unsigned i = 0; i < 3; i++) { /* as it is checked: eva_places.c */
        light.color_q16[i] = any;
        light.direction_q30[i] = any_signed % ((int32_t)GLINT_T_ONE + 17);
    }
    (void)glint_paint_light(&paint, &light, 1, v);
    (void)glint_paint_light(&paint, NULL, 0, v);
}
void eva_paint_light(void)
{
    lit(&glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA);
    lit(&glint_use_rgb888, GLINT_RGB888, GLINT_GAMMA);
    lit(&glint_use_grey, GLINT_GREY8, GLINT_GAMMA);
    lit(&glint_use_grey, GLINT_MONO, GLINT_GAMMA);
    for (uint8_t format = 0; format < GLINT_FORMAT_COUNT; format++)
        lit(&glint_use_linear, format, GLINT_LINEAR);
}

/* Offsets even and inside, as the manual asks. */
void eva_palette(void)
{
    static uint16_t colours[32], offsets[5 * HIGH];
    ANY_BYTES(colours);
    for (unsigned i = 0; i < 5 * HIGH; i++)
        offsets[i] = (uint16_t)(2 * (any % 32));
    static uint16_t out[5 * HIGH];
    const struct glint_surface surface = {out, 2 * 5, 0, 0};
    (void)glint_draw_palette(colours, offsets, 2 * 5, 5, HIGH, &surface);
}
