/* SPDX-License-Identifier: MIT
 * From the user's doubles to the library's integers. */
#include "draw/shading.h"

#include <math.h>

#include "base/message.h"

void direction_integers(const double direction[3], int32_t out[3])
{
    const double longest = fmax(fabs(direction[0]), fmax(fabs(direction[1]), fabs(direction[2])));
    for (unsigned k = 0; k < 3; k++)
        out[k] = longest > 0 ? (int32_t)lround(direction[k] / longest * (1 << 30)) : 0;
}

static uint32_t to_q16(double value)
{
    return (uint32_t)lround(value * 65536);
}

static int32_t to_sixteenths(double pixels)
{
    return (int32_t)lround(16 * pixels);
}

static int32_t cosine_q30(double degrees)
{
    return (int32_t)lround(cos(degrees * M_PI / 180) * (double)GLINT_T_ONE);
}

enum glint_err shading_lamp(const struct shading *shading, unsigned i, struct glint_lamp *out)
{
    const struct lamp *lamp = &shading->lamps[i];
    int32_t to_light[3], to_viewer[3], position[3];
    for (unsigned k = 0; k < 3; k++)
        position[k] = to_sixteenths(lamp->position[k]);
    const int32_t target[3] = {to_sixteenths(lamp->target[0]), to_sixteenths(lamp->target[1]), 0};
    const uint32_t range = (uint32_t)to_sixteenths(lamp->range);
    enum glint_err error = GLINT_ERR_ARG;
    switch (lamp->kind) {
    case GLINT_DIRECTIONAL:
        direction_integers(lamp->direction, to_light);
        direction_integers(shading->view, to_viewer);
        error = glint_lamp_directional(out, to_light, to_viewer);
        break;
    case GLINT_POINT:
        error = glint_lamp_point(out, position, range);
        break;
    case GLINT_SPOT:
        error = glint_lamp_spot(out, position, target, range, cosine_q30(lamp->cone[0]), cosine_q30(lamp->cone[1]));
        break;
    }
    for (unsigned k = 0; k < 3; k++)
        out->color_q16[k] = to_q16(lamp->color[k]);
    return error;
}

bool shading_is_plain(const struct shading *shading)
{
    const struct lamp *lamp = &shading->lamps[0];
    return shading->lamp_count == 1 && lamp->kind == GLINT_DIRECTIONAL && lamp->color[0] == 1 && lamp->color[1] == 1 &&
           lamp->color[2] == 1;
}

void shading_lamps(const struct shading *shading, struct glint_lamp lamps[GLINT_LAMPS_MAX])
{
    for (unsigned i = 0; i < shading->lamp_count; i++)
        if (shading_lamp(shading, i, &lamps[i]) != GLINT_OK)
            fail("the library refused light %u", i + 1);
}

struct glint_shader shading_shader(const struct shading *shading)
{
    struct glint_shader shader = {.format = (uint8_t)shading->format,
                                  .space = (uint8_t)shading->space,
                                  .dither = shading->dither,
                                  .clamp_peak = shading->clamp_peak};
    glint_lobe_init(&shader.lobe, shading->model, shading->n, shading->q);
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    shading_lamps(shading, lamps);
    int32_t to_viewer[3];
    direction_integers(shading->view, to_viewer);
    if (shading_is_plain(shading))
        shader.light = lamps[0].light;
    else if (glint_vec_normalize(&shader.light.v, to_viewer) != GLINT_OK)
        fail("the viewer has no direction");
    for (unsigned k = 0; k < 3; k++) {
        shader.material.ambient_q16[k] = to_q16(shading->ambient[k]);
        shader.material.diffuse_q16[k] = to_q16(shading->diffuse[k]);
        shader.material.specular_q16[k] = to_q16(shading->specular[k]);
        shader.material.albedo[k] = shading->color[k];
    }
    return shader;
}
