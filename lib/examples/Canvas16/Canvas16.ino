/* SPDX-License-Identifier: MIT
 * A badge in Adafruit GFX's GFXcanvas16, line by line with SMALL tables: 904 bytes of tables and 288 of normals. The canvas's pixels are RGB565
 * in the machine's order: GLINT_RGB565. Show it with display.drawRGBBitmap(x, y, canvas.getBuffer(), SIZE, SIZE). It fits the 8 KB of RAM of an
 * Arduino Mega: SIZE of 48 takes 4.5 KB on the heap, 64 would take all 8. */
#include <Adafruit_GFX.h>
#include <glint.h>

enum { SIZE = 48 };
static GFXcanvas16 canvas(SIZE, SIZE);
static struct glint_shader shader;
static struct glint_tables tables;
static uint32_t memory[GLINT_TABLES_SMALL_BYTES / 4];

static enum glint_err draw()
{
    static struct glint_vec normals[SIZE];
    struct glint_tables_light light;
    uint16_t *pixels = canvas.getBuffer();
    if (!pixels)
        return GLINT_ERR_ARG; /* too little memory for the canvas */
    enum glint_err err = glint_tables_light_init(&light, &tables, &shader.light);
    for (int y = 0; y < SIZE && !err; y++) {
        for (int x = 0; x < SIZE; x++) { /* a dome */
            const int32_t slope[3] = {x - SIZE / 2, SIZE / 2 - y, SIZE * 5 / 8};
            glint_vec_normalize(&normals[x], slope);
        }
        const struct glint_surface line = {pixels + SIZE * y, 2 * SIZE, 0, (uint16_t)y};
        err = glint_tables_rect(&tables, &light, GLINT_NORMALS_INT16, normals, sizeof normals, SIZE, 1, &line);
    }
    return err;
}

void setup()
{
    static const struct glint_material blue = {
        {3000, 3000, 3000}, {9000, 15000, 45000}, {60000, 60000, 60000}, {255, 255, 255}};
    static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
    Serial.begin(115200);
    shader.material = blue;
    shader.format = GLINT_RGB565;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 6);
    glint_light_init(&shader.light, to_light, to_viewer);
    glint_tables_fill(&tables, GLINT_TABLES_SMALL, &shader, memory, sizeof memory);
    if (draw())
        Serial.println("Canvas16: nothing was drawn");
    else
        Serial.println(canvas.getBuffer()[SIZE * 5 / 16 * SIZE + SIZE * 5 / 16], HEX);
}

void loop()
{
}
