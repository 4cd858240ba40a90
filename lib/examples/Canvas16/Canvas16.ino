/* SPDX-License-Identifier: MIT
 * A badge in Adafruit GFX's GFXcanvas16, drawn exactly line by line, so that 288 bytes hold its normals. The canvas's pixels are RGB565
 * in the machine's order: GLINT_RGB565. Show it with display.drawRGBBitmap(x, y, canvas.getBuffer(), SIZE, SIZE). It fits the 8 KB of RAM of an
 * Arduino Mega: SIZE of 48 takes 4.5 KB on the heap, 64 would take all 8. */
#include <Adafruit_GFX.h>
#include <glint.h>

enum { SIZE = 48 };
static GFXcanvas16 canvas(SIZE, SIZE);
static struct glint_paint paint;

static enum glint_err draw()
{
    /* model, q, n, n_across, ambient, diffuse, specular, albedo, clamp_peak */
    static const struct glint_material blue = {
        GLINT_MSH, 0, 60, 0, {3000, 3000, 3000}, {9000, 15000, 45000}, {60000, 60000, 60000}, {255, 255, 255}, false};
    static const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
    static struct glint_vec normals[SIZE];
    static struct glint_maps maps;
    struct glint_light light;
    uint16_t *pixels = canvas.getBuffer();
    if (!pixels)
        return GLINT_ERR_ARG; /* too little memory for the canvas */
    enum glint_err err = glint_paint_exact_for(&paint, &blue, &output, &glint_use_msh, &glint_use_rgb565);
    err = err ? err : glint_light_directional(&light, to_light);
    err = err ? err : glint_paint_light(&paint, &light, 1, to_viewer);
    maps.normals = normals;
    for (int y = 0; y < SIZE && !err; y++) {
        for (int x = 0; x < SIZE; x++) { /* a dome */
            const int32_t slope[3] = {x - SIZE / 2, SIZE / 2 - y, SIZE * 5 / 8};
            glint_vec_normalize(&normals[x], slope);
        }
        const struct glint_surface line = {pixels + SIZE * y, 2 * SIZE, 0, (uint16_t)y};
        err = glint_draw_rect(&paint, &maps, SIZE, 1, &line, NULL);
    }
    return err;
}

void setup()
{
    Serial.begin(115200);
    if (draw())
        Serial.println("Canvas16: nothing was drawn");
    else
        Serial.println(canvas.getBuffer()[SIZE * 5 / 16 * SIZE + SIZE * 5 / 16], HEX);
}

void loop()
{
}
