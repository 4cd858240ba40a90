/* SPDX-License-Identifier: MIT */
#include "sphere.h"

const uint16_t sphere_n[SPHERE_N_COUNT] = {5, 10, 60, 200, 1000};

void sphere_shader(struct glint_shader *shader, const struct sphere_look *look, uint32_t n)
{
    static const int32_t to_light[3] = {1, 1, 1}, to_viewer[3] = {0, 0, 1};
    static const struct glint_material material = {
        {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}};
    glint_lobe_init(&shader->lobe, (enum glint_model)look->model, n, SPHERE_Q);
    glint_light_init(&shader->light, to_light, to_viewer);
    shader->material = material;
    for (int k = 0; look->albedo && k < 3; k++)
        shader->material.diffuse_q16[k] = material.diffuse_q16[0];
    shader->format = look->format;
    shader->space = look->space;
    shader->dither = look->dither;
    shader->clamp_peak = false;
}

/* A point as far away as may be gives much the same picture as the light; so does a narrow spot there, whose cone holds the sphere and
 * is smooth over all of it. Four points are nearer, around the sphere. */
int sphere_lamps(struct glint_lamp lamps[GLINT_LAMPS_MAX], enum sphere_lamps which)
{
    enum { AWAY = 2097152, NEAR = 8192, MIDDLE_X = 16 * SPHERE_W / 2, MIDDLE_Y = 16 * SPHERE_H / 2, ONE = 1073741824 };
    static const int32_t to_light[3] = {1, 1, 1}, to_viewer[3] = {0, 0, 1}, middle[3] = {MIDDLE_X, MIDDLE_Y, 0};
    static const int32_t desk[3] = {MIDDLE_X + 2000, MIDDLE_Y - 2000, 3000};
    static const int32_t far_place[3] = {MIDDLE_X + AWAY, MIDDLE_Y - AWAY, AWAY};
    static const int32_t near_places[GLINT_LAMPS_MAX][3] = {{MIDDLE_X + NEAR, MIDDLE_Y - NEAR, NEAR},
                                                            {MIDDLE_X - NEAR, MIDDLE_Y - NEAR, NEAR},
                                                            {MIDDLE_X + NEAR, MIDDLE_Y + NEAR, NEAR},
                                                            {MIDDLE_X - NEAR, MIDDLE_Y + NEAR, NEAR}};
    static const uint32_t arriving = 99273, coloured[3] = {99273, 70000, 40000}; /* of it .66 arrive: (1 - 3 / 16)^2 */
    if (which == LAMPS_DIRECTIONAL)
        return glint_lamp_directional(lamps, to_light, to_viewer) ? GLINT_ERR_ARG : 1;
    if (which == LAMPS_FOUR) {
        for (unsigned i = 0; i < GLINT_LAMPS_MAX; i++)
            if (glint_lamp_point(&lamps[i], near_places[i], 32768))
                return GLINT_ERR_ARG;
        return GLINT_LAMPS_MAX;
    }
    if (which == LAMPS_SPOT) /* as of a desk lamp, 258 pixels away: full within 15 degrees, 0 from 25 on */
        return glint_lamp_spot(lamps, desk, middle, 1 << 14, 1037154959, 973141969) ? GLINT_ERR_ARG : 1;
    const uint32_t range = (uint32_t)GLINT_LAMP_FAR;
    /* the sphere's edge is 1934 / (sqrt(3) AWAY) from the axis: the cosine there is 1 - 1.4e-7, 152 below 2^30 */
    const enum glint_err err = which == LAMPS_NARROW ? glint_lamp_spot(lamps, far_place, middle, range, ONE, ONE - 400)
                                                     : glint_lamp_point(lamps, far_place, range);
    for (unsigned k = 0; k < 3; k++)
        lamps->color_q16[k] = which == LAMPS_COLOURED ? coloured[k] : arriving;
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
