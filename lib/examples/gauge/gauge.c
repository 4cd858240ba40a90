/* SPDX-License-Identifier: MIT
 * A bar gauge, a glossy tube of 200 x 32 pixels filled up to a value, without a map: each line is a span between the normals at its ends,
 * drawn exactly; the code of one model and one format is linked. Prints a PPM picture:
 *
 *     cc -Ilib lib/examples/gauge/gauge.c lib/[a-z]*.c -o gauge && ./gauge 70 >gauge.ppm */
#include <stdio.h>
#include <stdlib.h>

#include "glint.h"

enum { WIDTH = 200, HEIGHT = 32 };

/* The tube in columns x..x + w - 1; its ends bulge a little, so that the highlight has two. */
static enum glint_err tube(const struct glint_paint *paint, uint8_t *pixels, int x, int w)
{
    for (int y = 0; y < HEIGHT; y++) {
        const int32_t up = HEIGHT - 1 - 2 * y; /* of HEIGHT: the normal leans up at the top */
        const int32_t depth = HEIGHT - up * up / (HEIGHT + HEIGHT / 2);
        const int32_t slope[2][3] = {{(2 * x - WIDTH) * 8 / WIDTH, up, depth},
                                     {(2 * (x + w) - WIDTH) * 8 / WIDTH, up, depth}};
        const struct glint_surface line = {pixels + 3 * (y * WIDTH + x), 3 * WIDTH, 0, 0};
        struct glint_vec left, right;
        struct glint_span span;
        enum glint_err err = glint_vec_normalize(&left, slope[0]);
        err = err ? err : glint_vec_normalize(&right, slope[1]);
        err = err ? err : glint_span_init(&span, paint, &left, &right, (uint16_t)w);
        err = err ? err : glint_draw_span(paint, &span, NULL, &line, NULL);
        if (err)
            return err;
    }
    return GLINT_OK;
}

/* A paint of one material, lit. */
static enum glint_err lit(struct glint_paint *paint, const struct glint_material *material)
{
    static const struct glint_output output = {GLINT_RGB888, GLINT_GAMMA, false};
    static const int32_t to_light[3] = {-1, 2, 4}, to_viewer[3] = {0, 0, 1};
    struct glint_light light;
    enum glint_err err = glint_paint_exact_for(paint, material, &output, &glint_use_cayley, &glint_use_rgb888);
    err = err ? err : glint_light_directional(&light, to_light);
    return err ? err : glint_paint_light(paint, &light, 1, to_viewer);
}

static enum glint_err gauge_draw(uint8_t *pixels, int percent)
{
    /* model, q, n, n_across, ambient, diffuse, specular, albedo, clamp_peak */
    static const struct glint_material full = {
        GLINT_CAYLEY, 0, 80, 0, {6000, 2000, 2000}, {50000, 9000, 6000}, {60000, 60000, 60000}, {255, 255, 255}, false};
    static const struct glint_material empty = {
        GLINT_CAYLEY, 0, 80, 0, {2000, 2000, 2500}, {9000, 9000, 12000}, {40000, 40000, 40000}, {255, 255, 255}, false};
    static struct glint_paint paint;
    const int filled = WIDTH * percent / 100;
    enum glint_err err = lit(&paint, &full);
    err = err || !filled ? err : tube(&paint, pixels, 0, filled);
    err = err ? err : lit(&paint, &empty);
    return err || filled == WIDTH ? err : tube(&paint, pixels, filled, WIDTH - filled);
}

int main(int argc, char **argv)
{
    static uint8_t pixels[3 * WIDTH * HEIGHT];
    char none[] = "", *end = none;
    const long percent = argc > 1 ? strtol(argv[1], &end, 10) : 70;
    if (*end || percent < 0 || percent > 100) {
        fprintf(stderr, "gauge: %s: give a value from 0 to 100\n", argv[1]);
        return 2;
    }
    const enum glint_err err = gauge_draw(pixels, (int)percent);
    if (err) {
        fprintf(stderr, "gauge: glint's error %d\n", (int)err);
        return 1;
    }
    printf("P6 %d %d 255\n", WIDTH, HEIGHT);
    return fwrite(pixels, 1, sizeof pixels, stdout) != sizeof pixels;
}
