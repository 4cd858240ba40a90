/* SPDX-License-Identifier: MIT
 * From the user's doubles to the library's integers. */
#include "draw/shading.h"

#include <math.h>
#include <string.h>

#include "base/message.h"

void direction_integers(const double direction[3], int32_t out[3])
{
    const double longest = fmax(fabs(direction[0]), fmax(fabs(direction[1]), fabs(direction[2])));
    for (unsigned k = 0; k < 3; k++)
        out[k] = longest > 0 ? (int32_t)lround(direction[k] / longest * (1 << 30)) : 0;
}

static int32_t to_sixteenths(double pixels)
{
    return (int32_t)lround(16 * pixels);
}

void place_integers(const double pixels[3], int32_t out[3])
{
    for (unsigned k = 0; k < 3; k++)
        out[k] = to_sixteenths(pixels[k]);
}

static uint32_t to_q16(double value)
{
    return (uint32_t)lround(value * 65536);
}

static int32_t cosine_q30(double degrees)
{
    return (int32_t)lround(cos(degrees * M_PI / 180) * (double)GLINT_T_ONE);
}

static void to_channels(uint32_t out[3], const double values[3])
{
    for (unsigned k = 0; k < 3; k++)
        out[k] = to_q16(values[k]);
}

struct glint_material shading_material(const struct shading *shading)
{
    struct glint_material material = {.model = (uint8_t)shading->model,
                                      .q = (uint8_t)shading->q,
                                      .n = (uint16_t)shading->n,
                                      .n_across = (uint16_t)shading->n_across,
                                      .clamp_peak = shading->clamp_peak};
    to_channels(material.ambient_q16, shading->ambient);
    to_channels(material.diffuse_q16, shading->diffuse);
    to_channels(material.specular_q16, shading->specular);
    memcpy(material.albedo, shading->color, sizeof material.albedo);
    return material;
}

struct glint_output shading_output(const struct shading *shading)
{
    return (struct glint_output){(uint8_t)shading->format, (uint8_t)shading->space, shading->dither};
}

unsigned shading_q(const struct shading *shading)
{
    const struct glint_material material = shading_material(shading);
    const struct glint_output output = shading_output(shading);
    struct glint_paint paint;
    const enum glint_err error = glint_paint_exact(&paint, &material, &output);
    if (error)
        fail("the library refused the material (error %d)", (int)error);
    return paint.material.q;
}

/* ---- lights ---- */

static enum glint_err light_of(const struct lamp *lamp, struct glint_light *out)
{
    const double at[3] = {lamp->target[0], lamp->target[1], 0};
    int32_t to_light[3], position[3], target[3];
    place_integers(lamp->position, position);
    place_integers(at, target);
    const uint32_t range = (uint32_t)to_sixteenths(lamp->range);
    switch (lamp->kind) {
    case LAMP_DIRECTIONAL:
        direction_integers(lamp->direction, to_light);
        return glint_light_directional(out, to_light);
    case LAMP_POINT:
        return glint_light_point(out, position, range);
    case LAMP_SPOT:
        return glint_light_spot(out, position, target, range, cosine_q30(lamp->cone[0]), cosine_q30(lamp->cone[1]));
    }
    return GLINT_ERR_ARG;
}

/* The library looks for a light straight behind only where it is the one light of a paint. */
static enum glint_err refused_alone(const struct shading *shading, const struct glint_light *light)
{
    static const struct glint_material any = {.model = GLINT_MSH, .n = 1};
    static const struct glint_output grey = {.format = GLINT_GREY8};
    struct glint_paint paint;
    int32_t to_viewer[3];
    direction_integers(shading->view, to_viewer);
    const enum glint_err error = glint_paint_exact(&paint, &any, &grey);
    return error ? error : glint_paint_light(&paint, light, 1, to_viewer);
}

enum glint_err shading_light(const struct shading *shading, unsigned i, struct glint_light *light)
{
    const struct lamp *lamp = &shading->lamps[i];
    const enum glint_err error = light_of(lamp, light);
    if (error != GLINT_OK)
        return error;
    to_channels(light->color_q16, lamp->color);
    return refused_alone(shading, light);
}

void shading_lights(const struct shading *shading, struct glint_light lights[GLINT_LIGHTS_MAX])
{
    for (unsigned i = 0; i < shading->lamp_count; i++)
        if (shading_light(shading, i, &lights[i]) != GLINT_OK)
            fail("the library refused light %u", i + 1);
}

bool shading_is_plain(const struct shading *shading)
{
    const struct lamp *lamp = &shading->lamps[0];
    return shading->lamp_count == 1 && lamp->kind == LAMP_DIRECTIONAL && lamp->color[0] == 1 && lamp->color[1] == 1 &&
           lamp->color[2] == 1;
}

/* ---- paints ---- */

void shading_light_paint(const struct shading *shading, struct glint_paint *paint,
                         struct glint_light lights[GLINT_LIGHTS_MAX])
{
    int32_t to_viewer[3];
    direction_integers(shading->view, to_viewer);
    shading_lights(shading, lights);
    const enum glint_err error = glint_paint_light(paint, lights, shading->lamp_count, to_viewer);
    if (error != GLINT_OK)
        fail("the library refused the lights (error %d)", error);
}

struct glint_paint shading_paint(const struct shading *shading, struct glint_light lights[GLINT_LIGHTS_MAX])
{
    const struct glint_material material = shading_material(shading);
    const struct glint_output output = shading_output(shading);
    struct glint_paint paint;
    const enum glint_err error = glint_paint_exact(&paint, &material, &output);
    if (error != GLINT_OK)
        fail("the library refused the material (error %d)", error);
    shading_light_paint(shading, &paint, lights);
    return paint;
}
