/* SPDX-License-Identifier: MIT
 * Pictures in both orders of RGB565 by every paint and source, a line each: what was refused, how many bytes were drawn, a hash of them. */
#include "glint_mesh.h"
#include "machine.h"

enum { SIDE = 48, STRIP = 16 };

static const struct glint_material material = {
    GLINT_MSH, 0, 20, 0, {9000, 9000, 9000}, {45000, 45000, 45000}, {60000, 30000, 60000}, {255, 90, 200}, false};
static uint32_t words[SIDE * SIDE], tables[GLINT_TABLES_DITHER_BYTES / 4], of_frame[1024], of_mesh[1024];
static struct glint_vec normals[SIDE * SIDE];
static uint16_t colours[SIDE * SIDE];
static uint8_t coverage[SIDE * SIDE];
static union {
    uint16_t aligned;
    uint8_t bytes[2 * SIDE * SIDE + 1];
} pixels;
static struct glint_paint paint;

/* ---- the report ---- */

static void say(const char *text)
{
    while (*text)
        machine_put(*text++);
}

static void say_number(uint32_t number)
{
    for (int at = 28; at >= 0; at -= 4)
        machine_put("0123456789abcdef"[number >> at & 15]);
    machine_put(' ');
}

static void clear(void)
{
    for (unsigned i = 0; i < sizeof pixels.bytes; i++)
        pixels.bytes[i] = (uint8_t)(i & 1 ? 0x21 : 0x84);
}

static void report(const char *name, enum glint_err refused)
{
    uint32_t hash = 2166136261u, drawn = 0;
    for (unsigned i = 0; i < sizeof pixels.bytes; i++) {
        hash = (hash ^ pixels.bytes[i]) * 16777619u;
        drawn += pixels.bytes[i] != (i & 1 ? 0x21 : 0x84);
    }
    say_number((uint32_t)-refused);
    say_number(drawn);
    say_number(hash);
    say(name);
    say("\n");
}

/* ---- sources ---- */

static void dome(void)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        const int32_t slope[3] = {i % SIDE - SIDE / 2, SIDE / 2 - i / SIDE, SIDE / 2};
        glint_vec_normalize(&normals[i], slope);
        words[i] = glint_normals_pack(GLINT_NORMALS_INT8, &normals[i]);
        colours[i] = (uint16_t)(i * 2741);
        coverage[i] = (uint8_t)(i % 5 == 0 ? 255 : i % 5 == 1 ? 0 : i);
    }
}

/* At an even address, and at an odd one. */
static void rectangles(bool albedo, bool box)
{
    static const char *const names[] = {"rectangle of INT16 normals", "rectangle of INT8 normals"};
    for (unsigned kind = 0; kind < 8; kind++) {
        const bool packed = kind & 1, odd = kind & 2;
        struct glint_maps maps = {.normals = normals, .normals_stride = SIDE * sizeof *normals};
        const struct glint_surface surface = {pixels.bytes + odd, 2 * SIDE, 0, 0};
        struct glint_box lit;
        if (packed) {
            maps.normals = words;
            maps.normals_stride = SIDE * sizeof *words;
            maps.normals_format = GLINT_NORMALS_INT8;
        }
        if (albedo) {
            maps.albedo = (const uint8_t *)colours;
            maps.albedo_stride = SIDE * sizeof *colours;
            maps.albedo_format = GLINT_RGB565;
        }
        if (kind & 4) {
            maps.coverage = coverage;
            maps.coverage_stride = SIDE;
        }
        clear();
        report(names[packed], glint_draw_rect(&paint, &maps, SIDE, SIDE, &surface, box ? &lit : NULL));
    }
}

static void span(bool albedo)
{
    const struct glint_maps maps = {.albedo = (const uint8_t *)colours, .albedo_format = GLINT_RGB565};
    const struct glint_surface surface = {pixels.bytes, 0, 0, 0};
    struct glint_span at;
    clear();
    enum glint_err err = glint_span_init(&at, &paint, &normals[SIDE * 20 + 8], &normals[SIDE * 20 + 36], SIDE);
    err = err ? err : glint_draw_span(&paint, &at, albedo ? &maps : NULL, &surface, NULL);
    report("span", err);
}

static void palette(void)
{
    static uint16_t shaded[SIDE], offsets[SIDE * SIDE];
    const struct glint_maps maps = {.normals = normals + SIDE * 20};
    const struct glint_surface of = {shaded, 0, 0, 0}, surface = {pixels.bytes, 2 * SIDE, 0, 0};
    for (unsigned i = 0; i < SIDE * SIDE; i++)
        offsets[i] = (uint16_t)(2 * (i * 7 % SIDE));
    clear();
    enum glint_err err = glint_draw_rect(&paint, &maps, SIDE, 1, &of, NULL);
    err = err ? err : glint_draw_palette(shaded, offsets, 2 * SIDE, SIDE, SIDE, &surface);
    report("palette", err);
}

/* Two triangles side by side, of which every other edge is an outline. */
static void mesh(bool textured)
{
    static const int16_t places[] = {-20000, -15000, 0, 21000, -9000, 0, 3000, 20000, 900, -21000, 17000, 0};
    static const int16_t bends[] = {-9000, -9000, 30000, 12000, -3000, 30000, 0, 14000, 29000, -14000, 4000, 29000};
    static const uint16_t faces[] = {0, 1, 2, 0, 2, 3}, uv[] = {0, 0, 300, 0, 300, 280, 0, 256};
    static const uint16_t beside[] = {GLINT_MESH_RIM, GLINT_MESH_RIM, 1, 0, GLINT_MESH_RIM, GLINT_MESH_RIM};
    static const struct glint_texture texture = {colours, NULL, 16, 16, 1, true};
    static const struct glint_pose pose = {{32767, 900, -1200, 0}, {3, -7, 0}, 560};
    struct glint_mesh of = {
        .places = places, .normals = bends, .faces = faces, .neighbours = beside, .vertex_count = 4, .face_count = 2};
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    if (textured) {
        of.textures = &texture;
        of.uv = uv;
        of.uv_bits = 8;
        of.use = &glint_use_mesh_albedo;
    }
    for (unsigned odd = 0; odd < 2; odd++) {
        clear();
        enum glint_err err = glint_mesh_check(&of);
        err = err ? err : glint_mesh_begin(&frame, SIDE, SIDE, STRIP, 0, of_frame, sizeof of_frame);
        frame.outlines = &glint_outlines;
        err = err ? err : glint_mesh_add(&frame, &drawn, &of, &pose, &paint, of_mesh, sizeof of_mesh);
        for (uint16_t y = 0; y < SIDE && !err; y = (uint16_t)(y + STRIP)) {
            const struct glint_surface surface = {pixels.bytes + odd + 2 * SIDE * y, 2 * SIDE, 0, y};
            err = glint_mesh_strip(&frame, y, STRIP, &surface);
        }
        report(textured ? "mesh with a texture" : "mesh", err);
    }
}

/* ---- paints ---- */

static enum glint_err light(void)
{
    static const int32_t to_light[3] = {-1, 1, 3}, to_viewer[3] = {0, 0, 1};
    struct glint_light of;
    const enum glint_err err = glint_light_directional(&of, to_light);
    return err ? err : glint_paint_light(&paint, &of, 1, to_viewer);
}

static void pictures(const char *name, enum glint_err err, bool albedo, bool maps)
{
    say(name);
    say("\n");
    err = err ? err : light();
    if (err)
        report("paint", err);
    rectangles(albedo && maps, false);
    rectangles(albedo && maps, true);
    span(albedo && maps);
    if (!albedo)
        palette();
    if (!albedo)
        mesh(false);
    if (albedo || !maps)
        mesh(true);
}

bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    dome();
    for (unsigned swapped = 0; swapped < 2; swapped++) {
        const struct glint_output plain = {(uint8_t)(swapped ? GLINT_RGB565_SWAPPED : GLINT_RGB565), GLINT_GAMMA,
                                           false};
        const struct glint_output dithered = {plain.format, GLINT_GAMMA, true};
        pictures("exact", glint_paint_exact(&paint, &material, &plain), false, false);
        pictures("COLOUR", glint_paint_tables(&paint, GLINT_TABLES_COLOUR, &material, &plain, tables, sizeof tables),
                 false, true);
        pictures("COLOUR, dithered",
                 glint_paint_tables(&paint, GLINT_TABLES_COLOUR, &material, &dithered, tables, sizeof tables), false,
                 true);
        pictures("ALBEDO", glint_paint_tables(&paint, GLINT_TABLES_ALBEDO, &material, &plain, tables, sizeof tables),
                 true, true);
    }
    return true;
}
