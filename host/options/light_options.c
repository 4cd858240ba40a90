/* SPDX-License-Identifier: MIT
 * --light, --point and --spot of the commands that draw. */
#include <math.h>
#include <string.h>

#include "base/argp.h"
#include "base/parse.h"
#include "options/light_options.h"

static const double farthest = GLINT_LIGHT_FAR / 16., widest = 1e6; /* pixels; the parts of a direction */
enum { BRIGHTEST = GLINT_LIGHT_COLOR_MAX / 65536 };

void check_direction(const struct argp_state *state, const char *option, const double direction[3])
{
    if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0)
        refuse(state, "%s: the direction must not be 0,0,0", option);
}

/* The library holds places in sixteenths of a pixel. */
static double sixteenths(double pixels)
{
    return round(16 * pixels) / 16;
}

/* The next lamp. Its option has `count` numbers, and three more if it has a colour. */
static struct lamp *add_lamp(const struct argp_state *state, const char *option, const char *text, int count,
                             struct shading *shading, enum lamp_kind kind, double *values)
{
    if (shading->lamp_count == GLINT_LIGHTS_MAX)
        refuse(state, "%s: more than %u lights; give --light, --point and --spot at most %u times in all", option,
               GLINT_LIGHTS_MAX, GLINT_LIGHTS_MAX);
    int commas = 0;
    for (const char *at = text; *at; at++)
        commas += *at == ',';
    const bool has_color = commas + 1 == count + 3;
    if (!has_color && commas + 1 != count)
        refuse(state, "%s: '%s' is not %d numbers separated by commas, or %d with a colour", option, text, count,
               count + 3);
    parse_reals(state, option, text, values, has_color ? count + 3 : count, -widest, widest);
    struct lamp *lamp = &shading->lamps[shading->lamp_count++];
    *lamp = (struct lamp){.kind = kind, .color = {1, 1, 1}};
    for (int k = 0; k < 3 && has_color; k++) {
        lamp->color[k] = values[count + k];
        if (!(lamp->color[k] >= 0 && lamp->color[k] <= BRIGHTEST))
            refuse(state, "%s: '%s': the colour must be three numbers from 0 to %d", option, text, BRIGHTEST);
    }
    return lamp;
}

void parse_light(const struct argp_state *state, const char *text, struct shading *shading)
{
    double values[6];
    struct lamp *lamp = add_lamp(state, "--light", text, 3, shading, LAMP_DIRECTIONAL, values);
    memcpy(lamp->direction, values, sizeof lamp->direction);
    check_direction(state, "--light", lamp->direction);
}

static void set_place(const struct argp_state *state, const char *option, const char *text, struct lamp *lamp,
                      const double position[3], double range)
{
    for (int k = 0; k < 3; k++) {
        lamp->position[k] = sixteenths(position[k]);
        if (fabs(lamp->position[k]) > farthest)
            refuse(state, "%s: '%s': the place is more than %.0f pixels away", option, text, farthest);
    }
    lamp->range = sixteenths(range);
    if (lamp->range <= 0 || lamp->range > farthest)
        refuse(state, "%s: '%s': the range must be from 1/16 to %.0f pixels", option, text, farthest);
}

void parse_point(const struct argp_state *state, const char *text, struct shading *shading)
{
    double values[7];
    struct lamp *lamp = add_lamp(state, "--point", text, 4, shading, LAMP_POINT, values);
    set_place(state, "--point", text, lamp, values, values[3]);
}

void parse_spot(const struct argp_state *state, const char *text, struct shading *shading)
{
    double values[11];
    struct lamp *lamp = add_lamp(state, "--spot", text, 8, shading, LAMP_SPOT, values);
    set_place(state, "--spot", text, lamp, values, values[5]);
    for (int k = 0; k < 2; k++) {
        lamp->target[k] = sixteenths(values[3 + k]);
        if (fabs(lamp->target[k]) > farthest)
            refuse(state, "--spot: '%s': the target is more than %.0f pixels away", text, farthest);
        lamp->cone[k] = values[6 + k];
    }
    if (lamp->cone[0] < 0 || lamp->cone[0] > lamp->cone[1] || lamp->cone[1] > 180)
        refuse(state, "--spot: '%s': the angles must be 0 <= INNER <= OUTER <= 180 degrees", text);
    if (lamp->target[0] == lamp->position[0] && lamp->target[1] == lamp->position[1] && lamp->position[2] == 0)
        refuse(state, "--spot: '%s': the target is the light's own place; raise Z or move TX,TY", text);
}

void check_lamps(const struct argp_state *state, struct shading *shading)
{
    if (shading->lamp_count == 0)
        parse_light(state, "-1,1,1", shading);
    for (unsigned i = 0; i < shading->lamp_count; i++) {
        struct glint_light light;
        if (shading_light(shading, i, &light) != GLINT_OK)
            refuse(state, "--light: must not be opposite to --view: there is no half vector");
    }
}
