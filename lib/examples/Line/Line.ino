/* SPDX-License-Identifier: MIT
 * A line of 64 pixels over a curved surface, shaded exactly without a map: t is quadratic along a span, so that a pixel takes two
 * additions. RGB565 values, printed in hexadecimal. Fits an Arduino Uno, since a model and a format are named: a Mega holds all. */
#include <glint.h>

static struct glint_shader shader;
static struct glint_prepared prepared;
static uint16_t line[64];

void setup()
{
    static const struct glint_material red = {
        {3000, 3000, 3000}, {45000, 9000, 9000}, {60000, 60000, 60000}, {255, 255, 255}};
    static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
    const struct glint_vec left = {-22000, 0, 24284}, middle = {0, 0, 32767}, right = {22000, 0, 24284};
    const struct glint_vec *ends[3] = {&left, &middle, &right};
    Serial.begin(115200);
    shader.material = red;
    shader.format = GLINT_RGB565;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 6); /* n = 60; below 2^-6 there is no highlight */
    glint_light_init(&shader.light, to_light, to_viewer);
    glint_shade_prepare_for(&prepared, &shader, &glint_shade_msh, &glint_shade_rgb565);
    for (int half = 0; half < 2; half++) {
        struct glint_span span;
        const struct glint_surface surface = {line + 32 * half, 64, 0, 0};
        glint_span_init(&span, &shader.light, ends[half], ends[half + 1], 32);
        glint_shade_prepared_span(&prepared, &span, &surface, NULL);
    }
    for (int x = 0; x < 64; x++)
        Serial.println(line[x], HEX);
}

void loop()
{
}
