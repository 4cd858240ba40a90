/* SPDX-License-Identifier: MIT */
#include "scene.h"

const uint16_t scene_n[SCENE_N_COUNT] = {5, 10, 60, 200, 1000};

void scene_shader(struct glint_shader *shader, enum glint_model model, uint32_t n, enum glint_format format,
                  bool dither)
{
    static const int32_t to_light[3] = {1, 1, 1}, to_viewer[3] = {0, 0, 1};
    static const struct glint_material material = {
        {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}};
    glint_lobe_init(&shader->lobe, model, n, SCENE_Q);
    glint_light_init(&shader->light, to_light, to_viewer);
    shader->material = material;
    shader->format = (uint8_t)format;
    shader->space = GLINT_GAMMA;
    shader->dither = dither;
    shader->clamp_peak = false;
}
