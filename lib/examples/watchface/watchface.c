/* SPDX-License-Identifier: MIT
 * A picture of 240 x 240 pixels, relit on a part with 64 KB of RAM: the whole frame (115,200 bytes) does not fit, so that strips of 16 lines are
 * drawn and sent one by one; the normals stay in flash. From any PNG to the two files that this includes:
 *
 *     glint bake --height face.png --bevel 10 --strip 16 -o face.c
 *     glint material --format rgb565 -o material.h
 *
 * You write display_send. The pixels are those of
 *
 *     glint render --height face.png --bevel 10 --format rgb565 --path colour-int8 --image raw -o face.raw */
#include "face.h"
#include "material.h"
#include "watchface.h"

static struct glint_paint paint;
static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4];
static uint16_t strip[FACE_WIDTH * FACE_STRIP];

enum glint_err watchface_init(void)
{
    return glint_paint_tables_for(&paint, &glint_use_colour, &material, &material_output, memory, sizeof memory,
                                  &glint_use_msh, &glint_use_rgb565);
}

enum glint_err watchface_draw(const int32_t to_light[3])
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    static struct glint_maps maps;
    struct glint_light light;
    enum glint_err err = glint_light_directional(&light, to_light);
    err = err ? err : glint_paint_light(&paint, &light, 1, to_viewer);
    maps.normals_format = FACE_FORMAT;
    maps.normals_stride = FACE_STRIDE;
    for (unsigned i = 0; !err && i < FACE_STRIPS; i++) {
        const uint16_t y = (uint16_t)(i * FACE_STRIP), lines = (uint16_t)FACE_STRIP_LINES(i);
        const struct glint_surface surface = {strip, 2 * FACE_WIDTH, 0, y};
        for (size_t k = 0; k < sizeof strip / sizeof *strip; k++)
            strip[k] = 0; /* where there is no surface */
        maps.normals = FACE_STRIP_START(i);
        err = glint_draw_rect(&paint, &maps, FACE_WIDTH, lines, &surface, NULL);
        display_send(y, lines, strip, 2u * FACE_WIDTH * lines);
    }
    return err;
}
