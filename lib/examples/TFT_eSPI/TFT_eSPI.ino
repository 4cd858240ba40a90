/* SPDX-License-Identifier: MIT
 * A badge that is relit as its light goes round, by TFT_eSPI. pushImage takes pixels in the panel's order while setSwapBytes is false, as it is at the
 * start: GLINT_RGB565_SWAPPED, which spares the swap. A sprite's pixels (getPointer) are the same. */
#include <TFT_eSPI.h>
#include <glint.h>

static TFT_eSPI tft;
static struct glint_paint paint;
static struct glint_maps maps;
static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4], normals[64 * 64];
static uint16_t pixels[64 * 64];

void setup()
{
    /* model, q, n, n_across, ambient, diffuse, specular, albedo, clamp_peak */
    static const struct glint_material red = {
        GLINT_MSH, 0, 60, 0, {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}, false};
    static const struct glint_output output = {GLINT_RGB565_SWAPPED, GLINT_GAMMA, false};
    tft.init();
    tft.fillScreen(TFT_BLACK);
    tft.setSwapBytes(false);
    for (int i = 0; i < 64 * 64; i++) { /* a dome; `glint bake` makes normals of your own picture */
        const int32_t slope[3] = {i % 64 - 32, 32 - i / 64, 40};
        struct glint_vec normal;
        glint_vec_normalize(&normal, slope);
        normals[i] = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
    }
    maps.normals = normals;
    maps.normals_stride = sizeof normals / 64;
    maps.normals_format = GLINT_NORMALS_INT8;
    glint_paint_tables_for(&paint, &glint_use_colour, &red, &output, memory, sizeof memory, &glint_use_msh,
                           &glint_use_rgb565);
}

void loop()
{
    static const int8_t circle[8][2] = {{-2, 0}, {-1, 1}, {0, 2}, {1, 1}, {2, 0}, {1, -1}, {0, -2}, {-1, -1}};
    static const int32_t to_viewer[3] = {0, 0, 1};
    static unsigned frame;
    const int8_t *at = circle[frame++ % 8];
    const int32_t to_light[3] = {at[0], at[1], 3};
    const struct glint_surface surface = {pixels, 128, 0, 0};
    struct glint_light light;
    glint_light_directional(&light, to_light);
    glint_paint_light(&paint, &light, 1, to_viewer);
    glint_draw_rect(&paint, &maps, 64, 64, &surface, NULL);
    tft.pushImage(0, 0, 64, 64, pixels);
}
