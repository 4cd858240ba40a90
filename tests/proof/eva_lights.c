/* SPDX-License-Identifier: MIT
 * For Eva: what several lights do to a run of pixels, for every layout of the sums: one lamp or more, white or coloured, folded or not,
 * runs of every length, any normals, colours and places. What of a lamp reaches a pixel: eva_lamps.c; levels from sums: eva_pixels.c.
 * eva: -eva-precision 1 -eva-min-loop-unroll 9 -eva-slevel 12 -eva-use-spec glint_msh_t,glint_schlick_t,glint_blinn_t,glint_gauss_t,glint_cayley_t,glint_lyon_t,glint_reach_init,glint_reach_near,glint_reach_exact,glint_unit_q30 */
#include "eva.h"
#include "eva_directions.h"
#include "glint_lamp.h"
#include "glint_lights_fold.h"

/*@ assigns *reach \from lamp->kind; ensures \initialized(reach); */
void glint_reach_init(struct glint_reach *reach, const struct glint_lamp *lamp);
/*@ assigns light->l, light->h, \result \from lamp->kind; ensures \result <= 65536 || \result == 0xffffffff; */
uint32_t glint_reach_near(const struct glint_reach *reach, const struct glint_lamp *lamp,
                          const struct glint_sight *sight, struct glint_light *light);
/*@ assigns light->l, light->h, \result \from lamp->kind; ensures \result <= 65536; */
uint32_t glint_reach_exact(const struct glint_reach *reach, const struct glint_lamp *lamp,
                           const struct glint_sight *sight, struct glint_light *light);

/* The library's, with its static functions. */
#define glint_shade_lights of_shade_lights
#define glint_lights_init of_lights_init
#define glint_lights_pixel of_lights_pixel
#include "lights.c"

enum { MOST = GLINT_LIGHTS_SLOTS };
static uint8_t pixels[4 * (MOST + 3)], albedo[3 * MOST], gloss[MOST], mask[MOST + 3];
static struct glint_vec normals[MOST];
static struct glint_lamp lamps[GLINT_LAMPS_MAX];
static struct glint_prepared prepared;
static struct glint_lights lights;

static void fill(uint8_t model, uint8_t format, uint8_t space, unsigned count, uint8_t kind, bool coloured)
{
    struct glint_shader shader = any_shader(format, space, any & 1);
    shader.lobe.model = model;
    ANY_BYTES(lamps);
    ANY_BYTES(normals);
    ANY_BYTES(albedo);
    ANY_BYTES(gloss);
    ANY_BYTES(mask);
    for (unsigned i = 0; i < GLINT_LAMPS_MAX; i++) {
        const int32_t far = GLINT_LAMP_FAR;
        lamps[i].kind = kind;
        for (unsigned k = 0; k < 3; k++)
            lamps[i].position[k] = any_signed % (far + 1);
    }
    glint_prepared_fill(&prepared, &shader, model == GLINT_PHONG ? &glint_shade_phong : &glint_shade_lyon,
                        space == GLINT_LINEAR ? &glint_shade_linear : &glint_shade_rgb565);
    prepared.slack = (uint16_t)any;
    lights.prepared = &prepared;
    lights.lamps = lamps;
    lights.count = (uint8_t)count;
    lights.channels = coloured ? 3 : 1;
    lights.length = (uint8_t)(GLINT_LIGHTS_SLOTS / (lights.channels + (count > 1)));
    lights.boxed = true;
    lights.most = any % 131073;
    lights.bounds.any = false;
    prepared.apart = lights.channels == 1 ? 0 : lights.length;
    prepared.high = 0;
    for (unsigned i = 0; i < 3; i++) {
        lights.sight.v_q30[i] = any_signed % 0x40000001;
        lights.sight.e[i] = 0;
    }
    for (unsigned i = 0; i < GLINT_LIGHTS_SLOTS; i++) {
        const struct glint_sample sample = {any, any, any};
        lights.slots[i] = sample;
    }
    const struct glint_run run = {
        pixels, any % 4, (uint16_t)any, (uint32_t)(uint16_t)any, any & 1 ? albedo : NULL, any & 1 ? gloss : NULL, mask};
    lights.run = run;
    lights.normals = normals;
}

/* Every run by quick and exact sums, and each pixel by the 64 bits. */
static void run(uint8_t model, uint8_t kind)
{
    for (unsigned coloured = 0; coloured < 2; coloured++)
        for (unsigned count = 0; count <= GLINT_LAMPS_MAX; count += count ? GLINT_LAMPS_MAX - 1 : 1) {
            fill(model, GLINT_RGB565, GLINT_GAMMA, count, kind, coloured);
            for (unsigned length = 1; length <= lights.length; length++) {
                lights_sum(&lights, 0, length, false);
                (void)lights_note(&lights, 0, length);
                (void)lights_fit(&lights, length);
                lights_sum(&lights, length - 1, 1, true);
                (void)lights_note(&lights, length - 1, 1);
            }
        }
}
void eva_lights_directional(void)
{
    run(GLINT_LYON, GLINT_DIRECTIONAL);
}
void eva_lights_directional_phong(void)
{
    run(GLINT_PHONG, GLINT_DIRECTIONAL);
}
void eva_lights_point(void)
{
    run(GLINT_LYON, GLINT_POINT);
}
void eva_lights_spot_phong(void)
{
    run(GLINT_PHONG, GLINT_SPOT);
}

/* A pixel of every format by the 64 bits. */
void eva_lights_store(void)
{
    for (uint8_t format = 0; format < GLINT_FORMAT_COUNT; format++)
        for (unsigned coloured = 0; coloured < 2; coloured++)
            for (uint8_t space = GLINT_GAMMA; space <= GLINT_LINEAR; space++) {
                fill(GLINT_LYON, GLINT_RGB565, GLINT_GAMMA, 1, GLINT_POINT, coloured);
                prepared.shader.format = format;
                prepared.shader.space = space;
                lights_store(&lights, any % lights.length);
            }
}

/* What lamps are for all pixels; a coloured one folded in every format. */
void eva_lights_prepare(void)
{
    for (unsigned count = 0; count <= GLINT_LAMPS_MAX; count++)
        for (uint8_t format = 0; format < GLINT_FORMAT_COUNT; format++)
            for (uint8_t space = GLINT_GAMMA; space <= GLINT_LINEAR; space++) {
                const struct glint_shader shader = any_shader(format, space, any & 1);
                fill(GLINT_LYON, GLINT_RGB565, GLINT_GAMMA, count, GLINT_POINT, false);
                (void)lights_begin(&prepared, &shader, lamps, count);
                lights_prepare(&lights, lamps, count);
            }
}
