/* SPDX-License-Identifier: MIT
 * A watch: a domed dial with embossed numerals, minute marks, hands and a polished bezel; or a plain one with hour marks
 * only. */
#include "scene/watchface.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

static const double case_radius = .97, bezel_radius = .83, dial_radius = .79;

const struct relief watch_wall = {-.06, {.13, .14, .16}, 0, 0};
static const struct relief steel = {0, {.50, .52, .55}, 1, 1};
static const struct relief brass = {0, {.86, .68, .36}, 1, 1};
static const struct relief enamel = {0, {.05, .14, .33}, .6, 1};

/* The dial is a dome, so steep that a light from the side is mirrored somewhere on it; the hands follow it. */
static double dome(double r)
{
    return .38 * (dial_radius * dial_radius - r * r) - .10;
}

/* 1 in the middle of a stroke, 0 and level at its edge. */
static double ridge(double distance, double half_width)
{
    const double s = fmin(1, distance / half_width);
    return (1 - s * s) * (1 - s * s);
}

static void raise(struct relief *point, struct relief metal, double distance, double half_width, double height,
                  double pixel)
{
    const double half = fmax(half_width, pixel);
    metal.height = point->height + height * ridge(distance, half);
    relief_cover(point, &metal, coverage(distance - half, pixel));
    if (distance < half)
        point->height = metal.height; /* the profile is smooth by itself */
}

static void add_dial(struct relief *point, double x, double y, double pixel, bool plain)
{
    const double r = hypot(x, y);
    struct relief dial = enamel;
    dial.height = dome(r);
    relief_cover(point, &dial, coverage(r - dial_radius, 2 * pixel));
    if (r > dial_radius)
        return;
    /* Minute marks: fold the plane into one of sixty sectors. */
    const double angle = atan2(x, y);
    const double minute = round(angle / (M_PI / 30));
    const double off = angle - minute * (M_PI / 30);
    const bool hour = (long)minute % 5 == 0;
    const double along = r * cos(off), across = r * sin(off);
    if (hour || !plain)
        raise(point, brass, distance_to_segment(across, along, 0, .715, 0, .745), hour ? .014 : .007, .010, pixel);
    for (unsigned i = 1; i <= 12 && !plain; i++) {
        const double at = i * (M_PI / 6);
        const double dx = x - .575 * sin(at), dy = y - .575 * cos(at);
        if (hypot(dx, dy) < .16)
            raise(point, brass, distance_to_number(dx, dy, i, .135), .020, .020, pixel);
    }
}

/* A hand with two facets that meet in a ridge; it points up, turned clockwise by `turn`. */
static void add_hand(struct relief *point, double x, double y, double turn, double length, double half_width,
                     double base, double pixel)
{
    const double along = x * sin(turn) + y * cos(turn), across = fabs(x * cos(turn) - y * sin(turn));
    const double widest = .22 * length;
    const double limit = along > widest ? half_width * (length - along) / (length - widest)
                                        : half_width * (1 - .55 * (widest - along) / (widest + .12));
    const double inside = fmin(limit - across, fmin(along + .12, length - along));
    struct relief hand = steel;
    hand.albedo[0] = hand.albedo[1] = hand.albedo[2] = .80;
    hand.height = dome(hypot(x, y)) + base + .8 * fmax(0, limit - across);
    relief_cover(point, &hand, coverage(-inside, pixel));
}

static void add_bezel(struct relief *point, double r, double pixel, const double body[3])
{
    const double middle = (case_radius + bezel_radius) / 2, half = (case_radius - bezel_radius) / 2;
    const double s = (r - middle) / half;
    struct relief ring = steel;
    for (unsigned k = 0; body && k < 3; k++)
        ring.albedo[k] = body[k];
    if (r < bezel_radius) { /* the flange that leads down to the dial */
        ring.height = mix(-.10, -.02, smooth_step(dial_radius, bezel_radius, r));
        relief_cover(point, &ring, coverage(dial_radius - r, 2 * pixel));
        return;
    }
    ring.height = .07 * (1 - s * s) - .02;
    *point = ring;
}

static struct relief watch(double x, double y, double pixel, const double body[3], bool plain)
{
    const double r = hypot(x, y);
    struct relief point = watch_wall;
    if (r > case_radius + 2 * pixel)
        return point;
    add_dial(&point, x, y, pixel, plain);
    if (r > dial_radius - 2 * pixel)
        add_bezel(&point, r, pixel, body);
    if (r < .7) { /* 10:09, as in advertisements */
        add_hand(&point, x, y, 10.15 * (M_PI / 6), .34, .042, .02, pixel);
        add_hand(&point, x, y, 9 * (M_PI / 30), .53, .034, .03, pixel);
        raise(&point, brass, r, .045, .03, pixel);
    }
    point.solid = coverage(r - case_radius, pixel);
    return point;
}

/* ---- the sunray dial ---- */

static const struct relief blue = {0, {.13, .27, .47}, 1, 1};

/* Batons with two facets, twice as wide at twelve; fine marks between them. */
static void add_batons(struct relief *point, double x, double y, double pixel)
{
    const double angle = atan2(x, y), r = hypot(x, y);
    const double minute = round(angle / (M_PI / 30));
    const double off = angle - minute * (M_PI / 30);
    const double along = r * cos(off), across = r * sin(off);
    struct relief metal = steel;
    metal.albedo[0] = metal.albedo[1] = metal.albedo[2] = .86;
    if ((long)minute % 5 == 0) {
        const double half = (long)minute % 60 == 0 ? .036 : .022;
        const double inside = fmin(half - fabs(across), fmin(along - .56, .72 - along));
        metal.height = point->height + .012 + 1.1 * fmax(0, fmin(half - fabs(across), inside + .012));
        relief_cover(point, &metal, coverage(-inside, pixel));
    } else {
        metal.gloss = .3;
        metal.height = point->height;
        relief_cover(point, &metal, .8 * coverage(distance_to_segment(across, along, 0, .735, 0, .76) - .004, pixel));
    }
}

struct relief relief_sunray(double x, double y, double pixel, const double body[3])
{
    const double r = hypot(x, y);
    struct relief point = watch_wall, dial = blue;
    if (r > case_radius + 2 * pixel)
        return point;
    for (unsigned k = 0; body && k < 3; k++)
        dial.albedo[k] = body[k];
    dial.height = .03 * (dial_radius * dial_radius - r * r) - .10;
    relief_cover(&point, &dial, coverage(r - dial_radius, 2 * pixel));
    if (r < dial_radius)
        add_batons(&point, x, y, pixel);
    if (r > dial_radius - 2 * pixel)
        add_bezel(&point, r, pixel, NULL);
    if (r < .7) {
        add_hand(&point, x, y, 10.15 * (M_PI / 6), .38, .040, .02, pixel);
        add_hand(&point, x, y, 9 * (M_PI / 30), .60, .032, .03, pixel);
        raise(&point, steel, r, .045, .03, pixel);
    }
    point.solid = coverage(r - case_radius, pixel);
    return point;
}

struct relief relief_watchface(double x, double y, double pixel, const double body[3])
{
    return watch(x, y, pixel, body, false);
}

struct relief relief_dial(double x, double y, double pixel, const double body[3])
{
    return watch(x, y, pixel, body, true);
}
