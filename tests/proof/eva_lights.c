/* SPDX-License-Identifier: MIT
 * For Eva: what several lights do to a run of pixels, for every layout of the sums: one light or more, white or coloured, folded or not,
 * runs of every length, any normals, colours and places. What of a light reaches a pixel: eva_places.c; levels from sums: eva_pixels.c.
 * eva: -eva-precision 1 -eva-min-loop-unroll 9 -eva-slevel 12 -eva-ilevel 64 -eva-use-spec VALUES,glint_unit_q30,any_begin,any_near,any_exact */
#include "eva.h"
#include "eva_directions.h"
#include "glint_lights.h"

/* A kind that has a place, of which eva_places.c shows what is said here. */
/*@ assigns *reach \from light->range; ensures \initialized(reach); */
void any_begin(struct glint_reach *reach, const struct glint_light *light);
/*@ assigns view->l, view->h, \result \from light->range; ensures \result <= 65536 || \result == 0xffffffff; */
uint32_t any_near(const struct glint_reach *reach, const struct glint_light *light, const struct glint_sight *sight,
                  struct glint_view *view);
/*@ assigns view->l, view->h, \result \from light->range; ensures \result <= 65536; */
uint32_t any_exact(const struct glint_light *light, const struct glint_sight *sight, struct glint_view *view);
static const struct glint_light_kind placed = {false, &glint_use_lights, NULL, any_begin, any_near, any_exact};
static const struct glint_light_kind directional = {false, NULL, NULL, NULL, NULL, NULL};

/* With its static functions. */
#include "lights.c" /* in its place */

enum { MOST = GLINT_LIGHTS_SLOTS };
static uint8_t pixels[4 * (MOST + 3)], albedo[3 * MOST], gloss[MOST], coverage[MOST + 3];
static struct glint_vec normals[MOST];
static int32_t places[MOST][3];
static struct glint_light several[GLINT_LIGHTS_MAX];
static struct glint_paint paint;
static struct glint_lights lights;
static struct glint_run run;

/* Lights as they are checked. */
static void make(const struct glint_light_kind *kind)
{
    const int32_t far = GLINT_LIGHT_FAR, one = GLINT_T_ONE + 1;
    for (unsigned i = 0; i < GLINT_LIGHTS_MAX; i++) {
        struct glint_light *const light = &several[i];
        light->kind = kind;
        for (unsigned k = 0; k < 3; k++) {
            light->color_q16[k] = any;
            light->position[k] = any_signed % (far + 1);
            light->direction_q30[k] = any_signed % one;
        }
        light->range = any;
        light->cos_inner_q30 = light->cos_outer_q30 = any_signed;
    }
}

static void fill(const struct glint_use_model *model, const struct glint_use_format *format, uint8_t number,
                 uint8_t space, const struct glint_light_kind *kind, unsigned count, bool coloured)
{
    const struct glint_material material = any_material(model->model);
    const struct glint_output output = {number, space, any & 1};
    ANY_BYTES(normals);
    ANY_BYTES(albedo);
    ANY_BYTES(gloss);
    ANY_BYTES(coverage);
    make(kind);
    for (unsigned i = 0; i < MOST; i++)
        for (unsigned k = 0; k < 3; k++)
            places[i][k] = any_signed % (1 << 22);
    (void)glint_paint_exact_for(&paint, &material, &output, model, format);
    paint.v = any_vector();
    paint.several = &glint_use_lights;
    paint.lights = several;
    paint.light_count = (uint8_t)count;
    paint.of.exact.most = any % 131073;
    paint.of.exact.nl_down = any % 17;
    paint.of.exact.f_down = any % 17;
    paint.of.exact.high = 0;
    for (unsigned i = 0; i < GLINT_LIGHTS_MAX; i++)
        paint.of.exact.halves[i] = any_vector();
    const struct glint_run of = {
        pixels,   any % 4, any % 65536,  any % 65536, any & 1 ? albedo : NULL, any & 1 ? gloss : NULL,
        coverage, 0,       paint.format, NULL};
    run = of;
    lights.paint = &paint;
    lights.run = &run;
    lights.channels = coloured ? 3 : 1;
    lights.length = (uint8_t)(GLINT_LIGHTS_SLOTS / (lights.channels + (count > 1)));
    run.apart = lights.channels == 1 ? 0 : lights.length;
    lights.is_folded = any & 1;
    lights.is_boxed = true;
    lights.shines = 0;
    lights.normals = normals;
    lights.places = NULL;
    lights.shade = NULL;
    lights.geometry = paint.model->geometry ? paint.model->geometry : glint_samples_half;
    lights.v = any_vector();
    for (unsigned i = 0; i < 3; i++) {
        lights.sight.v_q30[i] = any_signed % 0x40000001;
        lights.sight.e[i] = 0;
    }
    ANY_BYTES(lights.reach);
    for (unsigned i = 0; i < GLINT_LIGHTS_SLOTS; i++) {
        const struct glint_sample sample = {any, any, any};
        lights.slots[i] = sample;
    }
}

/* Every run by quick and exact sums, on the surface and at places of a mesh. */
static void runs(const struct glint_use_model *model, const struct glint_light_kind *kind)
{
    for (unsigned coloured = 0; coloured < 2; coloured++)
        for (unsigned count = 1; count <= GLINT_LIGHTS_MAX; count += GLINT_LIGHTS_MAX - 1) {
            fill(model, &glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA, kind, count, coloured);
            for (unsigned length = 1; length <= lights.length; length++) {
                lights.places = NULL;
                lights_sum(&lights, 0, length, false, false);
                (void)lights_note(&lights, 0, length);
                (void)lights_fit(&lights, length);
                lights.places = (const int32_t(*)[3])places;
                lights_sum(&lights, length - 1, 1, true, false);
                (void)lights_note(&lights, length - 1, 1);
            }
        }
}
void eva_lights_directional(void)
{
    runs(&glint_use_lyon, &directional);
}
void eva_lights_directional_phong(void)
{
    runs(&glint_use_phong, &directional);
}
void eva_lights_placed(void)
{
    runs(&glint_use_lyon, &placed);
}
void eva_lights_placed_phong(void)
{
    runs(&glint_use_phong, &placed);
}

/* A pixel of every format by the 64 bits, from sums of any lights. */
static void store(const struct glint_use_format *use, uint8_t format, uint8_t space)
{
    for (unsigned coloured = 0; coloured < 2; coloured++) {
        fill(&glint_use_lyon, use, format, space, &placed, 1, coloured);
        for (unsigned i = 0; i < GLINT_LIGHTS_SLOTS; i++) {
            lights.slots[i].nl_q16 %= (uint32_t)1 << 23;
            lights.slots[i].f_q16 %= (uint32_t)1 << 23;
        }
        use->exact(&paint, &run, any % lights.length, lights.slots, run.apart);
    }
}
void eva_lights_store(void)
{
    store(&glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA);
    store(&glint_use_rgb888, GLINT_ARGB8888, GLINT_GAMMA);
    store(&glint_use_grey, GLINT_GREY8, GLINT_GAMMA);
    store(&glint_use_grey, GLINT_MONO, GLINT_GAMMA);
    for (uint8_t format = 0; format < GLINT_FORMAT_COUNT; format++)
        store(&glint_use_linear, format, GLINT_LINEAR);
}

/* What they are for all pixels. */
void eva_lights_begin(void)
{
    for (unsigned count = 1; count <= GLINT_LIGHTS_MAX; count++)
        for (unsigned is_placed = 0; is_placed < 2; is_placed++) {
            fill(&glint_use_lyon, &glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA, is_placed ? &placed : &directional,
                 count, false);
            paint.of.exact.high = (uint16_t)any;
            lights_begin(&lights, &paint, any & 1);
        }
}
