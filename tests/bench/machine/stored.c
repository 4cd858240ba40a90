/* SPDX-License-Identifier: MIT
 * The lines of lines.S, where flash is read as memory is. */
#include <string.h>

#include "clock.h"

extern const struct glint_vec lines_int16[SCENE_COUNT * SPHERE_LINES][SPHERE_W], stored_palette[], stored_palette_end[];
extern const uint32_t lines_int8[SCENE_COUNT * SPHERE_LINES][SPHERE_W];
extern const uint16_t lines_palette_offsets[SPHERE_LINES][SPHERE_W];

void sphere_line(enum bench_map map, unsigned k)
{
    memcpy(bench_line.normals, lines_int16[k], sizeof lines_int16[k]);
    if (map == MAP_INT8)
        memcpy(bench_map, lines_int8[k], sizeof lines_int8[k]);
    if (map == MAP_PALETTE) {
        memcpy(bench_map, lines_palette_offsets[k], sizeof lines_palette_offsets[k]);
        memcpy(bench_palette, stored_palette, (size_t)(stored_palette_end - stored_palette) * sizeof *stored_palette);
    }
}
