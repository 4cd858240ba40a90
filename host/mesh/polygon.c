/* SPDX-License-Identifier: MIT */
#include "mesh/polygon.h"

#include <math.h>
#include <stdbool.h>
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

struct ring {
    const double (*flat)[2];
    size_t *next;
};

static bool is_same(const double a[2], const double b[2])
{
    return a[0] == b[0] && a[1] == b[1];
}

/* Does the corner stand out, and is none of the others in its triangle? */
static bool is_ear(const struct ring *ring, size_t before, size_t at)
{
    const size_t behind = ring->next[at];
    const double *a = ring->flat[before], *b = ring->flat[at], *c = ring->flat[behind];
    if (turn(a, b, c) < 0)
        return false;
    for (size_t i = ring->next[behind]; i != before; i = ring->next[i]) {
        const double *p = ring->flat[i];
        if (turn(a, b, p) > 0 && turn(b, c, p) > 0 && turn(c, a, p) > 0 && !is_same(p, a) && !is_same(p, b) &&
            !is_same(p, c))
            return false;
    }
    return true;
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
static void cut_ears(const double (*flat)[2], size_t count, size_t (*triangles)[3])
{
    struct ring ring = {flat, allocate(count, sizeof *ring.next)};
    size_t before = count - 1, at = 0, misses = 0;
    for (size_t i = 0; i < count; i++)
        ring.next[i] = (i + 1) % count;
    for (size_t left = count; left > 2;) {
        if (misses < left && !is_ear(&ring, before, at)) {
            misses++;
            before = at;
        } else {
            put(triangles[count - left--], before, at, ring.next[at]);
            ring.next[before] = ring.next[at];
            misses = misses < left + 1 ? 0 : misses;
        }
        at = ring.next[before];
    }
    free(ring.next);
}

void polygon_cut(const double (*places)[3], size_t count, size_t (*triangles)[3])
{
    if (count == 3) {
        put(triangles[0], 0, 1, 2);
        return;
    }
    double(*flat)[2] = allocate(count, sizeof *flat);
    flatten(places, count, flat);
    if (count == 4) {
        const size_t dent = dent_of_four(flat);
        put(triangles[0], dent, (dent + 1) % 4, (dent + 2) % 4);
        put(triangles[1], dent, (dent + 2) % 4, (dent + 3) % 4);
    } else {
        cut_ears(flat, count, triangles);
    }
    free(flat);
}
