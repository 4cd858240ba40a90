/* SPDX-License-Identifier: MIT
 * A badge that is relit as its light goes round, by TFT_eSPI. pushImage takes pixels in the panel's order while setSwapBytes is false, as it is at the
 * start: GLINT_RGB565_SWAPPED, which spares the swap. A sprite's pixels (getPointer) are the same. */
#include <TFT_eSPI.h>
#include <glint.h>

static TFT_eSPI tft;
static struct glint_shader shader;
static struct glint_tables tables;
static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4], normals[64 * 64];
static uint16_t pixels[64 * 64];

void setup()
{
    static const struct glint_material red = {
        {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}};
    tft.init();
    tft.fillScreen(TFT_BLACK);
    tft.setSwapBytes(false);
    for (int i = 0; i < 64 * 64; i++) { /* a dome; `glint bake` makes normals of your own picture */
        const int32_t slope[3] = {i % 64 - 32, 32 - i / 64, 40};
        struct glint_vec normal;
        glint_vec_normalize(&normal, slope);
        normals[i] = glint_normals_pack(GLINT_NORMALS_INT8, &normal);
    }
    shader.material = red;
    shader.format = GLINT_RGB565_SWAPPED;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 6);
    glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory);
}

void loop()
{
    static const int8_t circle[8][2] = {{-2, 0}, {-1, 1}, {0, 2}, {1, 1}, {2, 0}, {1, -1}, {0, -2}, {-1, -1}};
    static const int32_t to_viewer[3] = {0, 0, 1};
    static unsigned frame;
    const int8_t *at = circle[frame++ % 8];
    const int32_t to_light[3] = {at[0], at[1], 3};
    const struct glint_surface surface = {pixels, 128, 0, 0};
    struct glint_tables_light light;
    glint_light_init(&shader.light, to_light, to_viewer);
    glint_tables_light_init(&light, &tables, &shader.light);
    glint_tables_rect(&tables, &light, GLINT_NORMALS_INT8, normals, 256, 64, 64, &surface);
    tft.pushImage(0, 0, 64, 64, pixels);
}
