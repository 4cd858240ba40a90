/* SPDX-License-Identifier: MIT
 * A badge of 64 x 64 pixels by tables: filled once a material, then a few cycles a pixel. */
#include <stdio.h>
#include "glint.h"

/* model, q, n, n_across, ambient, diffuse, specular, albedo, clamp_peak */
static const struct glint_material red = {
    GLINT_MSH, 0, 60, 0, {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}, false};
static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
static uint32_t normals[64 * 64], memory[GLINT_TABLES_COLOUR_BYTES / 4]; /* 4 bytes a normal; 20 KB of tables */
static struct glint_maps maps;
static struct glint_paint paint;
static uint16_t pixels[64 * 64];

int main(void)
{
    const struct glint_surface surface = {pixels, sizeof pixels / 64, 0, 0};
    struct glint_light light;
    for (int i = 0; i < 64 * 64; i++) { /* a dome; `glint bake` makes normals of your own picture */
        const int32_t slope[3] = {i % 64 - 32, 32 - i / 64, 40};
        struct glint_vec normal;
        glint_vec_normalize(&normal, slope);
        normals[i] = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
    }
    maps.normals = normals;
    maps.normals_stride = sizeof normals / 64;
    maps.normals_format = GLINT_NORMALS_INT8;
    if (glint_paint_tables_for(&paint, &glint_use_colour, &red, &output, memory, sizeof memory, &glint_use_msh,
                               &glint_use_rgb565) || /* once a material */
        glint_light_directional(&light, to_light) || /* once a frame, as the light moves */
        glint_paint_light(&paint, &light, 1, to_viewer) ||
        glint_draw_rect(&paint, &maps, 64, 64, &surface, NULL))
        return 1;
    return printf("64x64 pixels, %04x in the highlight, %04x in the corner\n", pixels[20 * 64 + 20], pixels[4095]) < 0;
}
