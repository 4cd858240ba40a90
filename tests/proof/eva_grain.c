/* SPDX-License-Identifier: MIT
 * For Eva: lines with grain along an axis or by a map, and with maps of shininess, by Lyon in RGB565: rectangles and spans of any normals, places and materials.
 * Eva does not see that y - surface.y is the line, so that the first line's y is one number where a map is asked by it.
 * eva: -eva-precision 1 -eva-min-loop-unroll 24 -eva-slevel 20 -eva-ilevel 64 -eva-split-return-function glint_unit_near:0:1,glint_unit_q30:0:1,glint_vec_of_q30:0:1 -eva-use-spec VALUES,glint_unit_q30,glint_unit_near */
#include "eva.h"
#include "eva_directions.h"
#include "glint_draw.h"

/* As eva_places.c has it. */
/*@ assigns *unit, \result \from v[0 .. 2];
    ensures \result == 0 || \result == 1;
    ensures \initialized(&unit->unit_q30[0 .. 2]);
    ensures -0x40000008 <= unit->unit_q30[0] <= 0x40000008;
    ensures -0x40000008 <= unit->unit_q30[1] <= 0x40000008;
    ensures -0x40000008 <= unit->unit_q30[2] <= 0x40000008; */
bool glint_unit_near(struct glint_unit *unit, const int32_t v[3]);

enum { WIDE = 3, HIGH = 2 };
static uint8_t pixels[2 * WIDE * HIGH], grain[WIDE * HIGH], shininess[WIDE * HIGH], gloss[WIDE * HIGH];
static struct glint_vec normals[WIDE * HIGH];
static struct glint_paint paint;

static void make(bool has_grain)
{
    const struct glint_output output = {any & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, GLINT_GAMMA, any & 1};
    struct glint_material material = any_material(GLINT_LYON);
    material.n_across = has_grain ? (uint16_t)any : 0;
    (void)glint_paint_exact_for(&paint, &material, &output, &glint_use_lyon_grain, &glint_use_rgb565);
    paint.l = any_vector();
    paint.v = any_vector();
    paint.h = any_vector();
    paint.light_count = 1;
    ANY_BYTES(normals);
    ANY_BYTES(grain);
    ANY_BYTES(shininess);
    ANY_BYTES(gloss);
}

static struct glint_maps maps_of(void)
{
    const struct glint_maps maps = {.normals = normals,
                                    .normals_stride = WIDE * (ptrdiff_t)sizeof *normals,
                                    .gloss = any & 1 ? gloss : NULL,
                                    .gloss_stride = WIDE,
                                    .grain_stride = WIDE,
                                    .shininess_stride = WIDE,
                                    .normals_format = GLINT_NORMALS_INT16,
                                    .grain_at = {any_signed, any_signed}};
    return maps;
}
static void draw(const struct glint_maps *maps, uint16_t y)
{
    const struct glint_surface surface = {pixels, 2 * WIDE, (uint16_t)any, y};
    struct glint_box box;
    (void)glint_draw_rect(&paint, maps, WIDE, HIGH, &surface, &box);
}

void eva_grain_brushed(void)
{
    const struct glint_maps maps = maps_of();
    make(true);
    draw(&maps, (uint16_t)any);
}
void eva_grain_map(void)
{
    struct glint_maps maps = maps_of();
    maps.grain = grain;
    make(true);
    draw(&maps, UINT16_MAX);
}
void eva_grain_shininess(void)
{
    struct glint_maps maps = maps_of();
    maps.shininess = shininess;
    make(false);
    draw(&maps, UINT16_MAX);
}

static void span(const struct glint_maps *maps)
{
    const struct glint_span at = {
        any, any, any, any_signed, any_signed, WIDE, {{(int16_t)any, (int16_t)any}, {(int16_t)any, (int16_t)any}}};
    const struct glint_surface surface = {pixels, 0, (uint16_t)any, UINT16_MAX};
    struct glint_box box;
    (void)glint_draw_span(&paint, &at, maps, &surface, &box);
}
void eva_grain_span(void)
{
    struct glint_maps maps = maps_of();
    make(true);
    span(NULL);
    span(&maps);
    make(false);
    maps.shininess = shininess;
    span(&maps);
}
