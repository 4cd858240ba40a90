/* SPDX-License-Identifier: MIT */
#include "sphere.h"

const uint16_t sphere_n[SPHERE_N_COUNT] = {5, 10, 60, 200, 1000};

void sphere_shader(struct glint_shader *shader, enum glint_model model, uint32_t n, enum glint_format format,
                   bool dither)
{
    static const int32_t to_light[3] = {1, 1, 1}, to_viewer[3] = {0, 0, 1};
    static const struct glint_material material = {
        {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}};
    glint_lobe_init(&shader->lobe, model, n, SPHERE_Q);
    glint_light_init(&shader->light, to_light, to_viewer);
    shader->material = material;
    shader->format = (uint8_t)format;
    shader->space = GLINT_GAMMA;
    shader->dither = dither;
    shader->clamp_peak = false;
}

static uint8_t wave(unsigned at) /* a triangle of period 512 */
{
    at &= 511;
    return (uint8_t)(at < 256 ? at : 511 - at);
}

void sphere_grey(struct glint_shader *shader)
{
    for (int k = 0; k < 3; k++)
        shader->material.diffuse_q16[k] = shader->material.diffuse_q16[0];
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
