/* SPDX-License-Identifier: MIT
 * A badge in Adafruit GFX's GFXcanvas16, line by line with SMALL tables: 1 KB of tables and 384 bytes of normals. The canvas's pixels are RGB565
 * in the machine's order: GLINT_RGB565. Show it with display.drawRGBBitmap(x, y, canvas.getBuffer(), 64, 64). */
#include <Adafruit_GFX.h>
#include <glint.h>

static GFXcanvas16 canvas(64, 64);
static struct glint_shader shader;
static struct glint_tables tables;
static uint32_t memory[GLINT_TABLES_SMALL_BYTES / 4];

static enum glint_err draw()
{
    static struct glint_vec normals[64];
    struct glint_tables_light light;
    uint16_t *pixels = canvas.getBuffer();
    if (!pixels)
        return GLINT_ERR_ARG; /* too little memory for the canvas */
    enum glint_err err = glint_tables_light_init(&light, &tables, &shader.light);
    for (int y = 0; y < 64 && !err; y++) {
        for (int x = 0; x < 64; x++) { /* a dome */
            const int32_t slope[3] = {x - 32, 32 - y, 40};
            glint_vec_normalize(&normals[x], slope);
        }
        const struct glint_surface line = {pixels + 64 * y, 128, 0, (uint16_t)y};
        err = glint_tables_rect(&tables, &light, GLINT_NORMALS_INT16, normals, sizeof normals, 64, 1, &line);
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
        Serial.println(canvas.getBuffer()[20 * 64 + 20], HEX);
}

void loop()
{
}
