/* SPDX-License-Identifier: MIT */
#include "sphere.h"

const uint16_t sphere_n[SPHERE_N_COUNT] = {5, 10, 60, 200, 1000};
const uint16_t scene_n[SCENE_N_COUNT] = {20, 60, 200};
const char *const scene_names[SCENE_COUNT] = {"sphere", "waves", "dome", "checks", "inside", "outside"};

const int32_t sphere_viewer[3] = {0, 0, 1};

/* What the lights' colour is divided out by. */
static uint32_t sphere_darker(uint8_t lights)
{
    return lights == LIGHTS_FOUR_2 ? 2 : lights == LIGHTS_FOUR_4 ? 4 : lights == LIGHTS_FOUR_16 ? 16 : 1;
}

void sphere_material(struct glint_material *material, struct glint_output *output, const struct sphere_look *look,
                     uint32_t n)
{
    static const struct glint_material clay = {.ambient_q16 = {3000, 3000, 3000},
                                               .diffuse_q16 = {45000, 9000, 9000},
                                               .specular_q16 = {60000, 60000, 60000},
                                               .albedo = {255, 255, 255}};
    *material = clay;
    material->model = look->model;
    material->q = SPHERE_Q;
    material->n = (uint16_t)n;
    material->n_across = look->grain != GRAIN_NONE && look->grain != GRAIN_SHININESS ? 8 : 0;
    for (int k = 0; k < 3; k++) {
        if (look->albedo)
            material->diffuse_q16[k] = clay.diffuse_q16[0];
        material->diffuse_q16[k] /= sphere_darker(look->lights);
        material->specular_q16[k] /= sphere_darker(look->lights);
    }
    output->format = look->format;
    output->space = look->space;
    output->dither = look->dither;
}

/* A point as far away as may be gives much the same picture as the light; so does a narrow spot there, whose cone holds the sphere and
 * is smooth over all of it. Four points are nearer, around the sphere. */
int sphere_lights(struct glint_light lights[GLINT_LIGHTS_MAX], enum sphere_lights which)
{
    enum { AWAY = 2097152, NEAR = 8192, MIDDLE_X = 16 * SPHERE_W / 2, MIDDLE_Y = 16 * SPHERE_H / 2, ONE = 1073741824 };
    static const int32_t to_light[3] = {1, 1, 1}, middle[3] = {MIDDLE_X, MIDDLE_Y, 0};
    static const int32_t desk[3] = {MIDDLE_X + 2000, MIDDLE_Y - 2000, 3000};
    static const int32_t far_place[3] = {MIDDLE_X + AWAY, MIDDLE_Y - AWAY, AWAY};
    static const int32_t near_places[GLINT_LIGHTS_MAX][3] = {{MIDDLE_X + NEAR, MIDDLE_Y - NEAR, NEAR},
                                                             {MIDDLE_X - NEAR, MIDDLE_Y - NEAR, NEAR},
                                                             {MIDDLE_X + NEAR, MIDDLE_Y + NEAR, NEAR},
                                                             {MIDDLE_X - NEAR, MIDDLE_Y + NEAR, NEAR}};
    static const uint32_t arriving = 99273, coloured[3] = {99273, 70000, 40000}; /* of it .66 arrive: (1 - 3 / 16)^2 */
    if (which == LIGHTS_WHITE || which == LIGHTS_DIRECTIONAL_COLOURED) {
        if (glint_light_directional(lights, to_light))
            return GLINT_ERR_ARG;
        for (unsigned k = 0; which == LIGHTS_DIRECTIONAL_COLOURED && k < 3; k++)
            lights->color_q16[k] = coloured[k];
        return 1;
    }
    if (which >= LIGHTS_FOUR) {
        for (unsigned i = 0; i < GLINT_LIGHTS_MAX; i++) {
            if (glint_light_point(&lights[i], near_places[i], 32768))
                return GLINT_ERR_ARG;
            for (unsigned k = 0; k < 3; k++)
                lights[i].color_q16[k] *= sphere_darker((uint8_t)which);
        }
        return GLINT_LIGHTS_MAX;
    }
    if (which == LIGHTS_SPOT) /* as of a desk lamp, 258 pixels away: full within 15 degrees, 0 from 25 on */
        return glint_light_spot(lights, desk, middle, 1 << 14, 1037154959, 973141969) ? GLINT_ERR_ARG : 1;
    const uint32_t range = (uint32_t)GLINT_LIGHT_FAR;
    /* the sphere's edge is 1934 / (sqrt(3) AWAY) from the axis: the cosine there is 1 - 1.4e-7, 152 below 2^30 */
    const enum glint_err err = which == LIGHTS_NARROW
                                   ? glint_light_spot(lights, far_place, middle, range, ONE, ONE - 400)
                                   : glint_light_point(lights, far_place, range);
    for (unsigned k = 0; k < 3; k++)
        lights->color_q16[k] = which == LIGHTS_COLOURED ? coloured[k] : arriving;
    return err ? err : 1;
}

static uint8_t wave(unsigned at) /* a triangle of period 512 */
{
    at &= 511;
    return (uint8_t)(at < 256 ? at : 511 - at);
}

uint16_t sphere_albedo(uint16_t x, uint16_t y)
{
    return (uint16_t)(wave(9u * x) >> 3 << 11 | wave(11u * y) >> 2 << 5 | wave(5u * x + 7u * y) >> 3);
}

void sphere_expand(uint8_t rgb[3], uint16_t rgb565)
{
    rgb[0] = (uint8_t)(((rgb565 >> 11) * 510u + 31) / 62);
    rgb[1] = (uint8_t)(((rgb565 >> 5 & 63) * 510u + 63) / 126);
    rgb[2] = (uint8_t)(((rgb565 & 31) * 510u + 31) / 62);
}

uint8_t sphere_gloss(uint16_t x, uint16_t y)
{
    return (uint8_t)(128 + (wave(3u * x + 2u * y) >> 1));
}

uint8_t sphere_grain_byte(const struct sphere_look *look, uint16_t x, uint16_t y)
{
    const uint8_t at = wave(3u * x + 2u * y);
    return look->grain == GRAIN_SHININESS ? (uint8_t)(128 + (at >> 3)) : at; /* n = 32..78 */
}

void sphere_grain(struct glint_maps *maps, const struct sphere_look *look, const uint8_t *bytes, ptrdiff_t stride)
{
    maps->grain = look->grain == GRAIN_MAP ? bytes : NULL;
    maps->shininess = look->grain == GRAIN_SHININESS ? bytes : NULL;
    maps->grain_stride = maps->shininess_stride = stride;
    maps->grain_kind = look->grain == GRAIN_SPUN ? GLINT_GRAIN_SPUN : GLINT_GRAIN_BRUSHED;
    maps->grain_at[0] = look->grain == GRAIN_SPUN ? 8 * SPHERE_W : 3; /* its middle, or a slanted direction */
    maps->grain_at[1] = look->grain == GRAIN_SPUN ? 8 * SPHERE_H : 1;
}
