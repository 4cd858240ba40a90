/* SPDX-License-Identifier: MIT
 * glint bake in a scratch folder with a height map and a mask. */
#ifndef UNIT_BAKED_H
#define UNIT_BAKED_H

#include "files.h"

enum { WIDTH = 12, HEIGHT = 8, PIXELS = WIDTH * HEIGHT };
#define MASKED "--height heights.png --mask mask.png"

static inline bool drawn(int pixel)
{
    return pixel % 7 > 2;
}

static inline int make_masked(void **state)
{
    uint16_t samples[PIXELS];
    for (int i = 0; i < PIXELS; i++)
        samples[i] = drawn(i) ? 255 : 0;
    if (make_maps(state) != 0)
        return -1;
    make_png("mask.png", &(struct made_png){.width = WIDTH, .height = HEIGHT, .bits = 8, .samples = samples});
    return 0;
}

static inline void bake_to(const char *options, const char *format, const char *file)
{
    char line[300];
    snprintf(line, sizeof line, "$GLINT bake %s --to %s -o %s", options, format, file);
    const struct run *result = run(line);
    assert_string_equal(result->err, "");
    assert_int_equal(result->status, 0);
}

#endif
