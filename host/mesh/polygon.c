/* SPDX-License-Identifier: MIT */
#include "mesh/polygon.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"

/* ---- seen from where it faces ---- */

static double turn(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Without the coordinate that its normal has most of, so that it turns counterclockwise. */
static void flatten(const double (*places)[3], size_t count, double (*flat)[2])
{
    double normal[3] = {0, 0, 0};
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            const double *a = places[i], *b = places[(i + 1) % count];
            const int y = (k + 1) % 3, z = (k + 2) % 3;
            normal[k] += (a[y] - b[y]) * (a[z] + b[z]);
        }
    int most = 2;
    for (int k = 0; k < 2; k++)
        if (fabs(normal[k]) > fabs(normal[most]))
            most = k;
    const int x = (most + 1) % 3, y = (most + 2) % 3, mirrors = normal[most] < 0;
    for (size_t i = 0; i < count; i++) {
        flat[i][mirrors] = places[i][x];
        flat[i][!mirrors] = places[i][y];
    }
}

/* ---- cut ---- */

/* Corners that stand in are dents. Where a polygon does not cross itself and has a corner in another's triangle, it has a dent there; and no
 * cut makes one. */
enum { NONE = -1 };
#define STEPS_MAX 300000000u /* about a second */
struct ring {
    const double (*flat)[2];
    struct corner {
        long before, behind, dent; /* the next dent */
        bool is_dent;
    } * corners;
    long dents;
    unsigned long steps; /* so many corners were looked at */
};

static bool is_same(const double a[2], const double b[2])
{
    return a[0] == b[0] && a[1] == b[1];
}

static bool stands_in(const struct ring *ring, long at)
{
    const struct corner *corner = &ring->corners[at];
    return turn(ring->flat[corner->before], ring->flat[at], ring->flat[corner->behind]) < 0;
}

/* Does the corner stand out, and is none of the others in its triangle, nor on its sides? Dents that are none any more leave their list. */
static bool is_ear(struct ring *ring, long at)
{
    struct corner *const corners = ring->corners;
    const double *a = ring->flat[corners[at].before], *b = ring->flat[at], *c = ring->flat[corners[at].behind];
    ring->steps++;
    if (stands_in(ring, at))
        return false;
    for (long *next = &ring->dents; *next != NONE; ring->steps++) {
        const double *p = ring->flat[*next];
        if (!corners[*next].is_dent) {
            *next = corners[*next].dent;
            continue;
        }
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0 && !is_same(p, a) && !is_same(p, b) &&
            !is_same(p, c))
            return false;
        next = &corners[*next].dent;
    }
    return true;
}

static void leave_out(struct ring *ring, long at)
{
    struct corner *const corner = &ring->corners[at], *const before = &ring->corners[corner->before],
                         *const behind = &ring->corners[corner->behind];
    before->behind = corner->behind;
    behind->before = corner->before;
    corner->is_dent = false;
    before->is_dent = before->is_dent && stands_in(ring, corner->before);
    behind->is_dent = behind->is_dent && stands_in(ring, corner->behind);
}

/* Of four corners at most one is a dent: both triangles meet there. */
static size_t dent_of_four(const double (*flat)[2])
{
    for (size_t i = 0; i < 4; i++)
        if (turn(flat[(i + 3) % 4], flat[i], flat[(i + 1) % 4]) < 0)
            return i;
    return 0;
}

static void put(size_t triangle[3], size_t a, size_t b, size_t c)
{
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
}

/* Ears one after the other; where there is none, since the polygon crosses itself, whatever comes next. */
static bool cut_ears(const double (*flat)[2], size_t count, size_t (*triangles)[3])
{
    struct ring ring = {flat, allocate(count, sizeof *ring.corners), NONE, 0};
    const long last = (long)count - 1;
    for (long i = 0; i <= last; i++)
        ring.corners[i] = (struct corner){i ? i - 1 : last, i < last ? i + 1 : 0, NONE, false};
    for (long i = last; i >= 0; i--) {
        ring.corners[i].is_dent = stands_in(&ring, i);
        if (ring.corners[i].is_dent) {
            ring.corners[i].dent = ring.dents;
            ring.dents = i;
        }
    }
    long at = 0;
    for (size_t left = count, misses = 0; left > 2 && ring.steps < STEPS_MAX;) {
        const struct corner corner = ring.corners[at];
        if (misses < left && !is_ear(&ring, at)) {
            misses++;
        } else {
            put(triangles[count - left--], (size_t)corner.before, (size_t)at, (size_t)corner.behind);
            leave_out(&ring, at);
            misses = misses < left + 1 ? 0 : misses;
        }
        at = corner.behind;
    }
    free(ring.corners);
    return ring.steps < STEPS_MAX;
}

bool polygon_cut(const double (*places)[3], size_t count, size_t (*triangles)[3])
{
    if (count == 3) {
        put(triangles[0], 0, 1, 2);
        return true;
    }
    bool good = true;
    double(*flat)[2] = allocate(count, sizeof *flat);
    flatten(places, count, flat);
    if (count == 4) {
        const size_t dent = dent_of_four(flat);
        put(triangles[0], dent, (dent + 1) % 4, (dent + 2) % 4);
        put(triangles[1], dent, (dent + 2) % 4, (dent + 3) % 4);
    } else {
        good = cut_ears(flat, count, triangles);
    }
    free(flat);
    return good;
}
