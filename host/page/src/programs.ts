// SPDX-License-Identifier: MIT
// Programs that draw the picture, beside what `glint material` and `glint bake` write: in plain C, for Arduino, for LVGL.
import type { Facts } from './engine'
import type { State } from './words'

export type Kind = 'c' | 'arduino' | 'lvgl'

/** picture.h: draws lines of the picture. `normals` is the header that glint bake wrote, `format` the pixels' in C. */
export function pictureHeader(state: State, facts: Facts, normals: string, format: string): string {
    const has = (map: string) => normals.includes(`normals_${map}[`)
    const isBrushed = facts.across[0] !== facts.n[0] // else a map of grain changes nothing, and beside one of shininess is refused
    const maps = ['coverage', 'shininess', 'gloss', ...isBrushed ? ['grain'] : []].filter(has).map(map => `    maps.${map} = normals_${map} + (size_t)y * NORMALS_WIDTH;\n    maps.${map}_stride = NORMALS_WIDTH;\n`)
    const isGrained = isBrushed || has('shininess')
    const grain = isBrushed && !has('grain')
        ? `    maps.grain_kind = GLINT_GRAIN_${['BRUSHED', 'SPUN', 'SUNRAY'][facts.grain[0]]};\n    maps.grain_at[0] = ${facts.grain_at[0]};\n    maps.grain_at[1] = ${facts.grain_at[1]};\n` : ''
    const group = state.space === 'linear' ? 'linear' : /565/.test(format) ? 'rgb565' : /888/.test(format) ? 'rgb888' : 'grey'
    return `/* Lines of the picture, ${facts.albedo.join(', ')} its one colour. Wants glint (its folder lib, or glint.c and glint.h). */
#ifndef PICTURE_H
#define PICTURE_H

#include "material.h"
#include "normals.h"

static struct glint_paint picture_paint;
static struct glint_light picture_lights[material_light_count];

/* Once, before picture_draw. */
static inline enum glint_err picture_begin(void)
{
    enum glint_err error = glint_paint_exact_for(&picture_paint, &material, &material_output, &glint_use_${state.model ?? 'msh'}${isGrained ? '_grain' : ''}, &glint_use_${group});
    return error ? error : material_light(&picture_paint, picture_lights);
}

/* Draws lines y to y + lines - 1 to pixels, whose lines have stride bytes. */
static inline enum glint_err picture_draw(int y, int lines, void *pixels, ptrdiff_t stride)
{
    struct glint_maps maps = {0};
    struct glint_surface surface = {0};
    surface.pixels = pixels;
    surface.stride = stride;
    surface.y = (int16_t)y;
    maps.normals = (const uint8_t *)normals + (ptrdiff_t)y * NORMALS_STRIDE;
    maps.normals_stride = NORMALS_STRIDE;
    maps.normals_format = NORMALS_FORMAT;
${maps.join('')}${grain}    return glint_draw_rect(&picture_paint, &maps, NORMALS_WIDTH, (uint16_t)lines, &surface, NULL);
}

#endif
`
}

/** Their file's name and text, and the pixels that it wants; undefined: those of the state. */
export const programs: Record<Kind, { name: string, format?: (own: string) => string, text: (format: string) => string }> = {
    c: {
        name: 'main.c',
        text: format => `/* Writes the picture's pixels (${format}) to standard output, as "glint render --image raw" does:
 *   cc -Ilib main.c normals.c lib/[a-z]*.c -o picture && ./picture >picture.raw */
#include <stdio.h>

#include "picture.h"

static uint8_t line[${bytesOf('NORMALS_WIDTH', format)}];

int main(void)
{
    if (picture_begin())
        return 1;
    for (int y = 0; y < NORMALS_HEIGHT; y++) {
        for (size_t i = 0; i < sizeof line; i++)
            line[i] = 0;
        if (picture_draw(y, 1, line, sizeof line) || fwrite(line, sizeof line, 1, stdout) != 1)
            return 1;
    }
    return fflush(stdout) != 0;
}
`,
    },
    arduino: {
        name: 'picture.ino', format: () => 'rgb565-swapped',
        text: () => `/* The picture on a panel of TFT_eSPI, 8 lines at a time. Put the folder lib of glint into libraries/glint. */
#include <TFT_eSPI.h>
#include "picture.h"

static TFT_eSPI tft;
static uint16_t pixels[8 * NORMALS_WIDTH];

void setup()
{
    tft.init();
    tft.fillScreen(TFT_BLACK);
    tft.setSwapBytes(false);
    if (picture_begin())
        return;
    for (int y = 0; y < NORMALS_HEIGHT; y += 8) {
        const int lines = NORMALS_HEIGHT - y < 8 ? NORMALS_HEIGHT - y : 8;
        for (int i = 0; i < lines * NORMALS_WIDTH; i++)
            pixels[i] = 0;
        picture_draw(y, lines, pixels, 2 * NORMALS_WIDTH);
        tft.pushImage(0, y, NORMALS_WIDTH, lines, pixels);
    }
}

void loop()
{
}
`,
    },
    lvgl: {
        name: 'picture.c', format: own => /^(rgb565|bgr888|xrgb8888|grey8)$/.test(own) ? own : 'rgb565',
        text: format => `/* The picture in a canvas of LVGL 9. Call picture_create after lv_init and the display's own set-up. */
#include "lvgl.h"
#include "picture.h"

lv_obj_t *picture_create(lv_obj_t *parent)
{
    static uint8_t pixels[NORMALS_HEIGHT * ${bytesOf('NORMALS_WIDTH', format)}] __attribute__((aligned(4)));
    lv_obj_t *canvas = lv_canvas_create(parent);
    lv_canvas_set_buffer(canvas, pixels, NORMALS_WIDTH, NORMALS_HEIGHT, LV_COLOR_FORMAT_${{ rgb565: 'RGB565', bgr888: 'RGB888', xrgb8888: 'XRGB8888', grey8: 'L8' }[format] ?? 'RGB565'});
    if (picture_begin() == GLINT_OK)
        picture_draw(0, NORMALS_HEIGHT, pixels, ${bytesOf('NORMALS_WIDTH', format)});
    lv_obj_invalidate(canvas);
    return canvas;
}
`,
    },
}

/** In C, of a line of so many pixels. */
function bytesOf(width: string, format: string): string {
    const bits = ({ mono: 1, grey2: 2, grey4: 4, grey8: 8, rgb888: 24, bgr888: 24, xrgb8888: 32, argb8888: 32 } as Record<string, number>)[format] ?? 16
    return bits < 8 ? `((${width} + ${8 / bits - 1}) / ${8 / bits})` : `${bits / 8} * ${width}`
}
