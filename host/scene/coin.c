/* SPDX-License-Identifier: MIT
 * A coin: a rim, a ring of beads, a wreath and a chiselled star. */
#include "scene/coin.h"

#include <math.h>

static const double coin_radius = .93, rim_radius = .85;

const struct relief coin_cloth = {-.08, {.10, .13, .16}, 0, 0};
static const double gold[3] = {.90, .66, .26};

/* A rise of 1 from the edge inwards over `width`, rounded at both ends; `inside` is the distance from the edge. */
static double rise(double inside, double width)
{
    return smooth_step(0, width, inside);
}

static double beads(double x, double y)
{
    enum { COUNT = 72 };
    static const double ring = .805, radius = .0235;
    const double sector = 2 * M_PI / COUNT;
    const double angle = remainder(atan2(y, x), sector), r = hypot(x, y);
    const double s = hypot(r * cos(angle) - ring, r * sin(angle)) / radius;
    return s < 1 ? .022 * (1 - s * s) : 0;
}

/* A leaf: where two circles overlap, with a vein along the middle. It points along `turn` from its stalk at ax, ay. */
static double leaf(double x, double y, double ax, double ay, double turn, double length, double half_width)
{
    const double dx = x - ax, dy = y - ay;
    const double along = (dx * cos(turn) + dy * sin(turn)) / length * 2 - 1,
                 across = fabs(-dx * sin(turn) + dy * cos(turn));
    if (fabs(along) >= 1)
        return 0;
    const double limit = half_width * (1 - along * along);
    if (across >= limit)
        return 0;
    const double s = across / limit;
    return (.010 + .020 * (1 - along * along)) * (1 - s * s * s) - .006 * (1 - smooth_step(0, .35, s));
}

static double wreath(double x, double y)
{
    enum { PAIRS = 9 };
    static const double ring = .60;
    const double mx = fabs(x); /* two branches, one mirrored */
    double height = 0;
    for (int i = 0; i < PAIRS; i++) {
        const double at = -M_PI / 2 + .16 + i * .285; /* from the foot, anticlockwise */
        const double px = ring * cos(at), py = ring * sin(at), forward = at + M_PI / 2;
        height = fmax(height, leaf(mx, y, px, py, forward - .55, .20, .036));
        height = fmax(height, leaf(mx, y, px, py, forward + .55, .20, .036));
    }
    const double r = hypot(mx, y), angle = atan2(y, mx);
    if (angle < -M_PI / 2 + .16 + PAIRS * .285) { /* the stem */
        const double s = (r - ring) / .012;
        height = fmax(height, s * s < 1 ? .018 * (1 - s * s) : 0);
    }
    return height;
}

/* A star of facets. The plane is folded into half an arm, in which the height rises linearly from the edge. */
static double star(double x, double y, unsigned arms, double turn, double outer, double inner, double steep)
{
    const double sector = M_PI / arms;
    const double angle = fabs(remainder(atan2(x, y) - turn, 2 * sector)), r = hypot(x, y);
    const double px = r * cos(angle), py = r * sin(angle);
    const double ix = inner * cos(sector), iy = inner * sin(sector);
    const double length = hypot(outer - ix, iy);
    const double inside = ((outer - px) * iy - py * (outer - ix)) / length;
    return inside > 0 ? steep * inside : 0;
}

struct relief relief_coin(double x, double y, double pixel, const double body[3])
{
    const double r = hypot(x, y);
    if (r > coin_radius + 2 * pixel)
        return coin_cloth;
    const double *metal = body ? body : gold;
    struct relief coin = {
        .05 * r * r, {metal[0], metal[1], metal[2]}, 1, coverage(r - coin_radius, pixel)}; /* the field is hollow */
    const double soft = fmin((coin_radius - rim_radius) / 2, fmax(.012, 1.5 * pixel));     /* else the rim has a step */
    double relief = fmax(beads(x, y), .05 * rise(r - rim_radius + soft, soft * 2));
    relief -= .03 * rise(r - coin_radius + 2 * soft, 2 * soft) * (r > rim_radius);
    if (r < .78)
        relief = fmax(relief, wreath(x, y));
    if (r < .46) {
        relief = fmax(relief, star(x, y, 4, M_PI / 4, .30, .12, .45));
        relief = fmax(relief, star(x, y, 4, 0, .44, .13, .45));
    }
    coin.height += relief;
    const double patina = mix(.62, 1, smooth_step(-.004, .02, relief)); /* darker where fingers do not polish */
    for (unsigned k = 0; k < 3; k++)
        coin.albedo[k] *= patina;
    coin.gloss = patina;
    return coin;
}
