/* SPDX-License-Identifier: MIT
 * tables orbit|chord: writes the module glint_orbit or glint_chord. */
#include <stdio.h>
#include <string.h>

#include "glint.h"
#include "orbit.h"
#include "sphere.h"

static const char orbit_head[] = "// SPDX-License-Identifier: MIT\n"
                                 "// Written by tables.c: the light's orbit, as a paint is lit for a viewer at (0, "
                                 "0, 1), in Q1.15: 164 L.x, 164 L.y\n"
                                 "// (24 bits each), L.z, 164 H.x, 164 H.y, H.z, and 2^30 + |H|^2.\n"
                                 "`default_nettype none\n\n"
                                 "module glint_orbit (\n"
                                 "    input wire clk,\n"
                                 "    input wire [7:0] frame,\n"
                                 "    output reg [159:0] light\n"
                                 ");\n"
                                 "    reg [159:0] memory[0:255];\n"
                                 "    always @(posedge clk) light <= memory[frame];\n"
                                 "    initial begin\n";

static const char chord_head[] = "// SPDX-License-Identifier: MIT\n"
                                 "// Written by tables.c: for the rows j = +-row of the sphere their half width in "
                                 "pixels and, at their first pixel,\n"
                                 "// z^2 and 2 (41)^2 |i|.\n"
                                 "`default_nettype none\n\n"
                                 "module glint_chord (\n"
                                 "    input wire clk,\n"
                                 "    input wire [7:0] row,\n"
                                 "    output reg [51:0] chord\n"
                                 ");\n"
                                 "    reg [51:0] memory[0:255];\n"
                                 "    always @(posedge clk) chord <= memory[row];\n"
                                 "    initial begin\n";

static unsigned bits(int32_t value, unsigned width)
{
    return (uint32_t)value & ((1u << width) - 1);
}

static int write_orbit(void)
{
    static const int32_t viewer[3] = {0, 0, 1};
    const struct glint_material material = {.n = 60};
    const struct glint_output output = {0};
    struct glint_paint paint;
    if (glint_paint_exact_for(&paint, &material, &output, &glint_use_msh, &glint_use_rgb565) != GLINT_OK)
        return 1;
    fputs(orbit_head, stdout);
    for (unsigned i = 0; i < 256; i++) { /* all of the memory, so that no entry is unknown */
        int32_t to[3];
        struct glint_light light;
        orbit_light(to, i, ORBIT_FRAMES);
        if (glint_light_directional(&light, to) != GLINT_OK || glint_paint_light(&paint, &light, 1, viewer) != GLINT_OK)
            return 1;
        const struct glint_vec l = paint.l, h = paint.h;
        const int64_t one_hh = SPHERE_ONE + ((int64_t)h.x * h.x + (int64_t)h.y * h.y + (int64_t)h.z * h.z);
        printf("        memory[%u] = 160'h%06x%06x%04x%06x%06x%04x%08llx;\n", i, bits(SPHERE_STEP * l.x, 24),
               bits(SPHERE_STEP * l.y, 24), bits(l.z, 16), bits(SPHERE_STEP * h.x, 24), bits(SPHERE_STEP * h.y, 24),
               bits(h.z, 16), (unsigned long long)one_hh);
    }
    return 0;
}

static int write_chord(void)
{
    fputs(chord_head, stdout);
    for (int32_t row = 0; row < 256; row++) {
        const int32_t half = row <= SPHERE_ROWS ? sphere_half_width(row) : 0;
        const int32_t z2 = half ? sphere_z2(half, row) : 0, slope = SPHERE_STEP * SPHERE_STEP / 8 * half;
        if (half > 255 || z2 >> 24 || slope >> 20)
            return 1;
        printf("        memory[%d] = {8'd%d, 24'd%d, 20'd%d};\n", (int)row, (int)half, (int)z2, (int)slope);
    }
    return 0;
}

int main(int argc, char **argv)
{
    if (argc != 2 || (strcmp(argv[1], "orbit") != 0 && strcmp(argv[1], "chord") != 0)) {
        fputs("usage: tables orbit|chord\n", stderr);
        return 2;
    }
    const int status = strcmp(argv[1], "orbit") == 0 ? write_orbit() : write_chord();
    puts("    end\nendmodule\n\n`default_nettype wire");
    return status;
}
