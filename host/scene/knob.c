/* SPDX-License-Identifier: MIT
 * A turned metal knob on a panel: a hollow face with spun grain, a bevel, a knurled skirt and a pointer mark. */
#include "scene/knob.h"

#include <math.h>

static const double skirt_radius = .94, bevel_radius = .83, face_radius = .72;

static const struct relief panel = {0, {.15, .16, .18}, 0, 0};
static const double aluminium[3] = {.66, .67, .70};

/* The face is a shallow dome; a rounded edge leads to the bevel, which ends level at its foot. The skirt's rim is rounded, too. */
static double profile(double r)
{
    const double rim = fmax(0, r - (skirt_radius - .05)) / .05;
    return mix(.26 - .08 * r * r, .10, smooth_step(face_radius, bevel_radius, r)) - .025 * rim * rim;
}

/* Grooves along the skirt; they fade where pixels cannot hold them. */
static double knurl(double x, double y, double r, double pixel)
{
    enum { COUNT = 60 };
    const double fade = smooth_step(.10, .04, pixel * COUNT / (2 * M_PI * r) * 4);
    const double across =
        smooth_step(bevel_radius, bevel_radius + .03, r) * smooth_step(skirt_radius, skirt_radius - .03, r);
    return .012 * cos(COUNT * atan2(y, x)) * across * fade;
}

/* The mark points to the upper right, filled with paint. */
static void add_pointer(struct relief *point, double x, double y, double pixel)
{
    static const double turn = 50 * M_PI / 180;
    const double dx = sin(turn), dy = cos(turn);
    const double distance = distance_to_segment(x, y, .34 * dx, .34 * dy, .60 * dx, .60 * dy) - .030;
    const struct relief paint = {point->height - .01, {.93, .42, .10}, .12, 1};
    relief_cover(point, &paint, coverage(distance, pixel));
}

struct relief knob_panel(double x, double y)
{
    struct relief point = panel;
    const double shadow = smooth_step(skirt_radius + .12, skirt_radius - .02, hypot(x - .03, y + .04));
    for (unsigned k = 0; k < 3; k++)
        point.albedo[k] *= 1 - .7 * shadow;
    return point;
}

struct relief relief_knob(double x, double y, double pixel, const double body[3])
{
    const double r = hypot(x, y);
    const double *metal = body ? body : aluminium;
    struct relief knob = {profile(r), {metal[0], metal[1], metal[2]}, 1, coverage(r - skirt_radius, pixel)};
    if (r > skirt_radius + 2 * pixel)
        return knob;
    knob.height += knurl(x, y, r, pixel);
    const double groove = smooth_step(.02, .008, fabs(r - bevel_radius)); /* dark where the skirt meets the bevel */
    for (unsigned k = 0; k < 3; k++)
        knob.albedo[k] *= 1 - .5 * groove;
    knob.gloss = 1 - .6 * groove;
    add_pointer(&knob, x, y, pixel);
    return knob;
}
