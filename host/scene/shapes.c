/* SPDX-License-Identifier: MIT
 * Shapes by signed distances, for the built-in scenes; numerals are strokes, so that no font is needed. */
#include "scene/shapes.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

double smooth_step(double from, double to, double at)
{
    const double s = fmax(0, fmin(1, (at - from) / (to - from)));
    return s * s * (3 - 2 * s);
}

double mix(double a, double b, double part)
{
    return a + (b - a) * part;
}

double coverage(double distance, double pixel)
{
    return smooth_step(.75 * pixel, -.75 * pixel, distance);
}

void relief_cover(struct relief *bottom, const struct relief *top, double part)
{
    bottom->height = mix(bottom->height, top->height, part);
    bottom->gloss = mix(bottom->gloss, top->gloss, part);
    for (unsigned k = 0; k < 3; k++)
        bottom->albedo[k] = mix(bottom->albedo[k], top->albedo[k], part);
}

double distance_to_segment(double x, double y, double ax, double ay, double bx, double by)
{
    const double dx = bx - ax, dy = by - ay;
    const double square = dx * dx + dy * dy;
    const double along = square > 0 ? fmax(0, fmin(1, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
    return hypot(x - ax - along * dx, y - ay - along * dy);
}

/* A stroke: a line from a to b, or an arc about a of radius bx from angle `from` through `sweep`, in quarter turns
 * anticlockwise from the right. A digit is 1 high and .6 wide about 0, 0. */
struct stroke {
    bool arc;
    double ax, ay, bx, by;
    double from, sweep;
};
enum { STROKES_MAX = 4 };

#define LINE(ax, ay, bx, by)                                                                                           \
    {                                                                                                                  \
        false, ax, ay, bx, by, 0, 0                                                                                    \
    }
#define ARC(x, y, radius, from, sweep)                                                                                 \
    {                                                                                                                  \
        true, x, y, radius, 0, from, sweep                                                                             \
    }

static const struct digit {
    unsigned count;
    struct stroke strokes[STROKES_MAX];
} digits[10] = {
    {4, {ARC(0, .22, .28, 0, 2), ARC(0, -.22, .28, 2, 2), LINE(-.28, -.22, -.28, .22), LINE(.28, -.22, .28, .22)}},
    {2, {LINE(.06, -.5, .06, .5), LINE(.06, .5, -.16, .3)}},
    {3, {ARC(0, .22, .28, -.45, 2.45), LINE(.213, .038, -.28, -.5), LINE(-.28, -.5, .28, -.5)}},
    {2, {ARC(0, .255, .245, -1, 2.7), ARC(0, -.245, .255, -1.7, 2.7)}},
    {3, {LINE(.14, -.5, .14, .5), LINE(.14, .5, -.28, -.2), LINE(-.28, -.2, .3, -.2)}},
    {4, {LINE(.24, .5, -.2, .5), LINE(-.2, .5, -.24, .06), ARC(0, -.2, .3, -1.65, 3.25), LINE(-.24, .06, -.177, .042)}},
    {2, {ARC(0, -.22, .28, 0, 4), LINE(-.243, -.08, .12, .5)}},
    {2, {LINE(-.28, .5, .28, .5), LINE(.28, .5, -.1, -.5)}},
    {2, {ARC(0, .26, .24, 0, 4), ARC(0, -.24, .26, 0, 4)}},
    {2, {ARC(0, .22, .28, 0, 4), LINE(.243, .08, -.12, -.5)}},
};

static double distance_to_arc(double x, double y, const struct stroke *s)
{
    const double quarter = M_PI / 2;
    const double dx = x - s->ax, dy = y - s->ay;
    const double middle = (s->from + s->sweep / 2) * quarter;
    const double off = fabs(remainder(atan2(dy, dx) - middle, 4 * quarter)); /* from the arc's middle */
    const double half = s->sweep / 2 * quarter;
    if (off <= half)
        return fabs(hypot(dx, dy) - s->bx);
    const double end1 = middle + half, end2 = middle - half;
    return fmin(hypot(dx - s->bx * cos(end1), dy - s->bx * sin(end1)),
                hypot(dx - s->bx * cos(end2), dy - s->bx * sin(end2)));
}

static double distance_to_digit(double x, double y, unsigned digit)
{
    double nearest = INFINITY;
    for (unsigned i = 0; i < digits[digit].count; i++) {
        const struct stroke *s = &digits[digit].strokes[i];
        nearest =
            fmin(nearest, s->arc ? distance_to_arc(x, y, s) : distance_to_segment(x, y, s->ax, s->ay, s->bx, s->by));
    }
    return nearest;
}

double distance_to_number(double x, double y, unsigned number, double size)
{
    const double advance = number == 11 ? .46 : .74; /* of the size, from a digit to the next; ones are narrow */
    unsigned count = 1;
    for (unsigned rest = number; rest >= 10; rest /= 10)
        count++;
    double nearest = INFINITY;
    for (unsigned i = 0; i < count; i++, number /= 10) {
        const double at = ((count - 1) / 2.0 - i) * advance; /* the last digit first */
        nearest = fmin(nearest, distance_to_digit(x / size - at, y / size, number % 10));
    }
    return nearest * size;
}
