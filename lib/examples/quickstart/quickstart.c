/* SPDX-License-Identifier: MIT
 * A badge of 64 x 64 pixels, exact to the last bit. */
#include <stdio.h>
#include "glint.h"

static const struct glint_material red = {
    GLINT_MSH,             /* model */
    0,                     /* q, where the highlight ends; 0: what the output needs */
    60,                    /* n, the shininess */
    0,                     /* n_across */
    {3000, 3000, 3000},    /* ambient: red, green, blue; 65536 = 1.0 */
    {45000, 9000, 9000},   /* diffuse */
    {60000, 60000, 60000}, /* specular */
    {255, 255, 255},       /* albedo; 255 = 1.0 */
    false                  /* clamp_peak */
};
static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
static struct glint_vec normals[64 * 64];
static struct glint_maps maps;
static struct glint_paint paint;
static uint16_t pixels[64 * 64];

int main(void)
{
    const struct glint_surface surface = {pixels, sizeof pixels / 64, 0, 0};
    struct glint_light light;
    for (int i = 0; i < 64 * 64; i++) { /* a dome; `glint bake` makes normals of your own picture */
        const int32_t slope[3] = {i % 64 - 32, 32 - i / 64, 40};
        glint_vec_normalize(&normals[i], slope);
    }
    maps.normals = normals;
    maps.normals_stride = sizeof normals / 64;
    if (glint_paint_exact(&paint, &red, &output) ||  /* once a material */
        glint_light_directional(&light, to_light) || /* once a frame, as the light moves */
        glint_paint_light(&paint, &light, 1, to_viewer) || glint_draw_rect(&paint, &maps, 64, 64, &surface, NULL))
        return 1;
    return printf("64x64 pixels, %04x in the highlight, %04x in the corner\n", pixels[20 * 64 + 20], pixels[4095]) < 0;
}
