/* SPDX-License-Identifier: MIT
 * The files that tests of `glint render` shade. */
#ifndef GLINT_RENDER_MAPS_H
#define GLINT_RENDER_MAPS_H

#include "command.h"
#include "made_png.h"

/* A small height map and an albedo of its size, an albedo of another, and one line of a tall map. */
static inline int make_maps(void **state)
{
    if (enter_own_directory(state) != 0)
        return -1;
    uint16_t heights[12 * 8], colors[12 * 8 * 3];
    for (int i = 0; i < 12 * 8; i++)
        heights[i] = (uint16_t)(i * i * 31 % 256);
    for (int i = 0; i < 12 * 8 * 3; i++)
        colors[i] = (uint16_t)(100 + i % 150);
    make_png("heights.png", &(struct made_png){.width = 12, .height = 8, .bits = 8, .samples = heights});
    make_png(
        "colors.png",
        &(struct made_png){.width = 12, .height = 8, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = colors});
    make_png("small.png", &(struct made_png){
                              .width = 4, .height = 4, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = colors});
    make_png("line.png", &(struct made_png){.width = 1, .height = 8, .bits = 8, .samples = heights});
    for (int i = 0; i < 12 * 8; i++)
        heights[i] &= 1;
    make_png("bits.png", &(struct made_png){.width = 12, .height = 8, .bits = 1, .samples = heights});
    return mkdir("out", 0777);
}

#endif
