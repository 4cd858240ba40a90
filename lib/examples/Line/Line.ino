/* SPDX-License-Identifier: MIT
 * A line of 64 pixels over a curved surface, drawn exactly without a map: t is quadratic along a span, so that a pixel takes two
 * additions. RGB565 values, printed in hexadecimal. Fits an Arduino Uno, since a model and a format are named: a Mega holds all. */
#include <glint.h>

static struct glint_paint paint;
static uint16_t line[64];

void setup()
{
    /* model, q, n, n_across, ambient, diffuse, specular, albedo, clamp_peak */
    static const struct glint_material red = {
        GLINT_MSH, 0, 60, 0, {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}, false};
    static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
    const struct glint_vec left = {-22000, 0, 24284}, middle = {0, 0, 32767}, right = {22000, 0, 24284};
    const struct glint_vec *ends[3] = {&left, &middle, &right};
    Serial.begin(115200);
    struct glint_light light;
    glint_paint_exact_for(&paint, &red, &output, &glint_use_msh, &glint_use_rgb565);
    glint_light_directional(&light, to_light);
    glint_paint_light(&paint, &light, 1, to_viewer);
    for (int half = 0; half < 2; half++) {
        struct glint_span span;
        const struct glint_surface surface = {line + 32 * half, 64, 0, 0};
        glint_span_init(&span, &paint, ends[half], ends[half + 1], 32);
        glint_draw_span(&paint, &span, NULL, &surface, NULL);
    }
    for (int x = 0; x < 64; x++)
        Serial.println(line[x], HEX);
}

void loop()
{
}
