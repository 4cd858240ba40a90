/* SPDX-License-Identifier: MIT
 * What the emulated board's panel shows, and what it should show; RGB, to standard output.
 *   judge look CONTROLLER WIDTH HEIGHT ROTATION    standard input: a transcript of the panel's pins (pico.mjs)
 *   judge demo WIDTH HEIGHT FRAME         the stand-alone demo, by the library on this machine
 *   judge lit WIDTH HEIGHT FRAME          the same of `map`, without soft edges; and the demo with a tearing line
 *   judge exact WIDTH HEIGHT FRAME        the same by the exact rectangle (PATH=exact)
 *   judge teapot WIDTH HEIGHT FRAME       the demo of DEMO=teapot, in one strip
 *   judge scene NAME WIDTH HEIGHT X Y Z    a scene, as boards with an accelerometer show it, under a light towards X, Y, Z
 *   judge palette NAME WIDTH HEIGHT X Y Z    the same by a palette, each of its normals exactly
 *   judge fault WIDTH HEIGHT NUMBER       what is shown where something is wrong
 *   judge lz4                             standard input as one LZ4 block (no picture)
 *   judge map WIDTH HEIGHT                a map, as it goes over the wire to a device that shades
 *   judge material                        the demo's material, likewise
 *   judge light FRAME                     and its light, one message */
#include <lz4hc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake/bake.h"
#include "bake/write.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/parse.h"
#include "demo.h"
#include "fault.h"
#include "glint_mesh.h"
#include "light_protocol.h"
#include "mesh/fit.h"
#include "mesh/load.h"
#include "orbit.h"
#include "scene/scenes.h"
#include "sinks/panel/virtual_panel.h"

static struct virtual_panel seen;

static enum panel_controller controller_of(const char *name)
{
    static const char *const names[] = {
#define CONTROLLER(id, name, ...) name,
#include "panels.def"
    };
    unsigned i = 0;
    while (i < PANEL_CONTROLLERS && strcmp(name, names[i]) != 0)
        i++;
    return (enum panel_controller)i;
}

static void show_panel(const char *controller, unsigned width, unsigned height, unsigned rotation)
{
    struct panel panel = {0};
    if (!panel_defaults(&panel, controller_of(controller), (uint8_t)rotation, (uint16_t)width, (uint16_t)height))
        fail("judge: unknown panel %s %ux%u", controller, width, height);
    const struct virtual_glass glass = virtual_glass_of(&panel);
    virtual_panel_init(&seen, &glass);
    for (int kind, byte; (kind = getchar()) != EOF && (byte = getchar()) != EOF;) {
        const uint8_t value = (uint8_t)byte;
        switch (kind) {
        case 'C':
            virtual_panel_command(&seen, value);
            break;
        case 'D':
            virtual_panel_data(&seen, &value, 1);
            break;
        case 'R':
            if (!value)
                virtual_panel_reset(&seen);
            break;
        case 'B':
            seen.lit = value;
        }
    }
    uint8_t *rgb = allocate((size_t)width * height, 3);
    virtual_panel_look(&seen, rotation, rgb);
    fwrite(rgb, 3, (size_t)width * height, stdout);
    free(rgb);
}

static uint8_t shown(unsigned level, unsigned max)
{
    return (uint8_t)((level * 255 + max / 2) / max);
}

static void write_shown(const uint16_t *pixels, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint8_t rgb[3] = {shown(pixels[i] >> 11, 31), shown(pixels[i] >> 5 & 63, 63), shown(pixels[i] & 31, 31)};
        fwrite(rgb, 1, sizeof rgb, stdout);
    }
}

static void draw_fault(unsigned width, unsigned height, unsigned fault)
{
    uint16_t line[PANEL_ROWS];
    for (unsigned y = 0; y < height; y++) {
        fault_line(line, (uint16_t)width, (uint16_t)height, (uint16_t)y, (enum fault)fault);
        write_shown(line, width);
    }
}

/* The demo's gold, exact or by COLOUR tables, under a light. */
static void make_paint(struct glint_paint *paint, bool exact, const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
    struct glint_light light;
    const enum glint_err error =
        exact ? glint_paint_exact(paint, &demo_gold, &demo_output)
              : glint_paint_tables(paint, GLINT_TABLES_COLOUR, &demo_gold, &demo_output, memory, sizeof memory);
    if (error != GLINT_OK || glint_light_directional(&light, to_light) != GLINT_OK ||
        glint_paint_light(paint, &light, 1, to_viewer) != GLINT_OK)
        fail("judge: the library refused the paint");
}

/* The coin: cut out with a soft edge, or with its wall, as a computer sends it. */
static void draw_map(const char *name, unsigned width, unsigned height, const int32_t to_light[3], bool cut, bool exact)
{
    struct scene *scene = scene_draw_in(name, width, height, NULL, cut);
    struct baked *baked = bake(scene, BAKE_INT8, 0);
    uint16_t *pixels = allocate((size_t)width * height, sizeof *pixels);
    const struct glint_surface surface = {pixels, 2 * (ptrdiff_t)width, 0, 0};
    const struct glint_maps maps = {.normals = baked->words,
                                    .normals_stride = 4 * (ptrdiff_t)width,
                                    .normals_format = GLINT_NORMALS_INT8,
                                    .coverage = scene->mask,
                                    .coverage_stride = (ptrdiff_t)width};
    struct glint_paint paint;
    make_paint(&paint, exact, to_light);
    if (glint_draw_rect(&paint, &maps, (uint16_t)width, (uint16_t)height, &surface, NULL) != GLINT_OK)
        fail("judge: the library refused the demo");
    write_shown(pixels, (size_t)width * height);
    free(pixels);
    baked_free(baked);
    scene_free(scene);
}

static void draw_palette(const char *name, unsigned width, unsigned height, const int32_t to_light[3])
{
    struct scene *scene = scene_draw(name, width, height);
    struct baked *baked = bake(scene, BAKE_PALETTE, PALETTE_DEFAULT);
    uint16_t *pixels = allocate((size_t)width * height, sizeof *pixels);
    uint16_t *colours = allocate(baked->entries, sizeof *colours);
    const struct glint_surface surface = {pixels, 2 * (ptrdiff_t)width, 0, 0}, entries = {colours, 0, 0, 0};
    const struct glint_maps maps = {.normals = baked->normals};
    struct glint_paint paint;
    make_paint(&paint, true, to_light);
    if (glint_draw_rect(&paint, &maps, (uint16_t)baked->entries, 1, &entries, NULL) != GLINT_OK)
        fail("judge: the library refused the palette");
    colours[0] = 0;
    if (glint_draw_palette(colours, baked->offsets, 2 * (ptrdiff_t)width, (uint16_t)width, (uint16_t)height,
                           &surface) != GLINT_OK)
        fail("judge: the library refused the demo");
    write_shown(pixels, (size_t)width * height);
    free(pixels);
    free(colours);
    baked_free(baked);
    scene_free(scene);
}

static void draw_coin(unsigned width, unsigned height, unsigned frame, bool cut, bool exact)
{
    int32_t to_light[3];
    orbit_light(to_light, frame, ORBIT_FRAMES);
    draw_map("coin", width, height, to_light, cut, exact);
}

static void draw_mesh(const struct glint_mesh *mesh, const struct glint_pose *pose, unsigned width, unsigned height)
{
    struct glint_paint paint;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    const uint16_t w = (uint16_t)width, h = (uint16_t)height;
    const size_t frame_bytes = glint_mesh_frame_bytes(w, h), mesh_bytes = glint_mesh_bytes(mesh, h);
    uint16_t *pixels = allocate((size_t)width * height, sizeof *pixels);
    void *of_frame = allocate(frame_bytes, 1), *of_mesh = allocate(mesh_bytes, 1);
    const struct glint_surface surface = {pixels, 2 * (ptrdiff_t)width, 0, 0};
    make_paint(&paint, false, demo_mesh_light);
    if (glint_mesh_begin(&frame, w, h, h, 0, of_frame, frame_bytes) != GLINT_OK ||
        glint_mesh_add(&frame, &drawn, mesh, pose, &paint, of_mesh, mesh_bytes) != GLINT_OK ||
        glint_mesh_strip(&frame, 0, h, &surface) != GLINT_OK)
        fail("judge: the library refused the mesh");
    write_shown(pixels, (size_t)width * height);
    free(of_mesh);
    free(of_frame);
    free(pixels);
}

static void draw_teapot(unsigned width, unsigned height, unsigned frame)
{
    const struct mesh_source source = {
        .name = "teapot", .built_in = true, .crease = -1, .split = 180, .axes = AXES_USUAL};
    struct mesh *mesh = mesh_load(&source);
    struct fitted *fitted = mesh_fit(mesh, 0);
    struct glint_pose pose;
    fitted->mesh.normals = NULL;
    demo_pose(&pose, frame, (uint16_t)width);
    draw_mesh(&fitted->mesh, &pose, width, height);
    fitted_free(fitted);
    mesh_free(mesh);
}

static void compress(void)
{
    static char in[1 << 20], out[LZ4_COMPRESSBOUND(sizeof in)];
    const int length = (int)fread(in, 1, sizeof in, stdin);
    fwrite(out, 1, (size_t)LZ4_compress_HC(in, out, length, sizeof out, LZ4HC_CLEVEL_MAX), stdout);
}

static void pack_map(unsigned width, unsigned height)
{
    struct scene *scene = scene_draw("coin", width, height);
    struct baked *baked = bake(scene, BAKE_INT8, 0);
    bake_write_raw(baked, stdout);
    baked_free(baked);
    scene_free(scene);
}

static void pack_material(void)
{
    struct light_material material;
    uint8_t bytes[LIGHT_MATERIAL_BYTES];
    light_material_of(&material, &demo_gold, &demo_output);
    light_material_pack(bytes, &material);
    fwrite(bytes, 1, sizeof bytes, stdout);
}

static void pack_light(unsigned frame)
{
    int32_t to_light[3];
    uint8_t bytes[LIGHT_MESSAGE_BYTES];
    orbit_light(to_light, frame, ORBIT_FRAMES);
    light_message_pack(bytes, frame, to_light);
    fwrite(bytes, 1, sizeof bytes, stdout);
}

static unsigned number(const char *text)
{
    return (unsigned)parse_integer(NULL, "judge", text, 0, 65535);
}

int main(int argc, char **argv)
{
    if (argc == 6 && strcmp(argv[1], "look") == 0)
        show_panel(argv[2], number(argv[3]), number(argv[4]), number(argv[5]));
    else if (argc == 5 && strcmp(argv[1], "demo") == 0)
        draw_coin(number(argv[2]), number(argv[3]), number(argv[4]), true, false);
    else if (argc == 5 && strcmp(argv[1], "exact") == 0)
        draw_coin(number(argv[2]), number(argv[3]), number(argv[4]), true, true);
    else if (argc == 5 && strcmp(argv[1], "lit") == 0)
        draw_coin(number(argv[2]), number(argv[3]), number(argv[4]), false, false);
    else if (argc == 5 && strcmp(argv[1], "teapot") == 0)
        draw_teapot(number(argv[2]), number(argv[3]), number(argv[4]));
    else if (argc == 8 && (strcmp(argv[1], "scene") == 0 || strcmp(argv[1], "palette") == 0)) {
        const int32_t to_light[3] = {atoi(argv[5]), atoi(argv[6]), atoi(argv[7])};
        if (strcmp(argv[1], "palette") == 0)
            draw_palette(argv[2], number(argv[3]), number(argv[4]), to_light);
        else
            draw_map(argv[2], number(argv[3]), number(argv[4]), to_light, strcmp(argv[2], "coin") == 0, false);
    } else if (argc == 5 && strcmp(argv[1], "fault") == 0)
        draw_fault(number(argv[2]), number(argv[3]), number(argv[4]));
    else if (argc == 2 && strcmp(argv[1], "lz4") == 0)
        compress();
    else if (argc == 4 && strcmp(argv[1], "map") == 0)
        pack_map(number(argv[2]), number(argv[3]));
    else if (argc == 2 && strcmp(argv[1], "material") == 0)
        pack_material();
    else if (argc == 3 && strcmp(argv[1], "light") == 0)
        pack_light(number(argv[2]));
    else
        fail("judge: unknown call; the source lists the calls");
    return fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
