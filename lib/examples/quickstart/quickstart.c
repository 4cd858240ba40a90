/* SPDX-License-Identifier: MIT
 * A badge of 64 x 64 pixels by the fast path: tables filled once a material, then a few cycles a pixel. */
#include <stdio.h>
#include "glint.h"

static struct glint_shader shader;
static uint32_t normals[64 * 64], memory[GLINT_TABLES_COLOUR_BYTES / 4];
static uint16_t pixels[64 * 64];

int main(void)
{
    const struct glint_material red = {{3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}};
    const struct glint_surface surface = {pixels, 128, 0, 0};
    const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
    struct glint_tables tables;
    struct glint_tables_light light;
    for (int i = 0; i < 64 * 64; i++) { /* a dome; `glint bake` makes normals of your own picture */
        const int32_t slope[3] = {i % 64 - 32, 32 - i / 64, 40};
        struct glint_vec normal;
        glint_vec_normalize(&normal, slope);
        normals[i] = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
    }
    shader.material = red; /* once a material */
    shader.format = GLINT_RGB565;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 6); /* n = 60; below 2^-6 there is no highlight */
    glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory);
    glint_light_init(&shader.light, to_light, to_viewer); /* once a frame, as the light moves */
    glint_tables_light_init(&light, &tables, &shader.light);
    glint_tables_rect(&tables, &light, GLINT_NORMALS_INT8, normals, 256, 64, 64, &surface);
    return printf("64x64 pixels, %04x in the highlight, %04x in the corner\n", pixels[20 * 64 + 20], pixels[4095]) < 0;
}
