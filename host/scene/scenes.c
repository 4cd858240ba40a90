/* SPDX-License-Identifier: MIT
 * The built-in scenes: the sphere, and reliefs turned into normals. */
#include "scene/scenes.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/stop.h"
#include "scene/coin.h"
#include "scene/knob.h"
#include "scene/shapes.h"
#include "scene/watchface.h"

static uint8_t to_byte(double value)
{
    return (uint8_t)lround(255 * fmax(0, fmin(1, value)));
}

/* Positions in units of half the shorter side, from the picture's middle. */
struct frame {
    double left, top, pixel;
    uint32_t first; /* the line that the scene's first is */
};

static struct frame frame_of(uint32_t width, uint32_t height, uint32_t first)
{
    const double pixel = 2.0 / fmin(width, height);
    return (struct frame){-pixel * width / 2, pixel * height / 2, pixel, first};
}

/* How far up the upper edge of a line is. */
static double edge_of(const struct frame *f, size_t line, double below)
{
    return f->top - f->pixel * ((double)(f->first + line) + below);
}

/* A thing before its wall, or cut out of it. */
struct drawing {
    struct scene *scene; /* some lines of the picture */
    struct frame frame;
    relief_function *thing; /* NULL: the sphere */
    struct relief (*wall)(double x, double y);
    const double *body;
    bool cut;
};

static void add_maps(struct scene *scene, bool cut)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    scene->albedo = allocate(pixels, 3);
    scene->gloss = allocate(pixels, 1);
    if (cut)
        scene->mask = allocate(pixels, 1);
}

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* At an edge colours and normals are mixed, without gloss: such a normal would catch a highlight that neither has. */
static void set_pixel(const struct drawing *drawing, size_t pixel, const double normal[3], struct relief thing,
                      double x, double y)
{
    struct scene *scene = drawing->scene;
    const double part = drawing->cut ? 1 : thing.solid, length = length_of(normal);
    double *out = scene->normals[pixel];
    if (drawing->cut) {
        scene->mask[pixel] = to_byte(thing.solid);
    } else {
        struct relief point = drawing->wall(x, y);
        relief_cover(&point, &thing, part);
        point.gloss = part < 1 ? 0 : thing.gloss;
        thing = point;
    }
    for (unsigned k = 0; k < 3; k++) {
        out[k] = mix(k == 2, normal[k] / length, part);
        scene->albedo[3 * pixel + k] = to_byte(thing.albedo[k]);
    }
    const double mixed = length_of(out);
    for (unsigned k = 0; k < 3; k++)
        out[k] /= mixed;
    scene->gloss[pixel] = to_byte(thing.gloss);
}

/* ---- reliefs ---- */

/* The mean slopes over a cell, of the heights at its corners: above left and right, below left and right. */
static void slopes(double normal[3], const double above[2], const double below[2], double side)
{
    normal[0] = (above[0] - above[1] + below[0] - below[1]) / (2 * side);
    normal[1] = (below[0] - above[0] + below[1] - above[1]) / (2 * side);
    normal[2] = 1;
}

/* Whether the ground of a pixel is steep, or no plane: by the heights at its corners and in its middle. */
static bool is_bent(const double above[2], const double below[2], double middle, double side)
{
    const double plane = .0213 * side; /* .02 is what a dome of .38 bends by at 38 pixels: no question for rounding */
    return fabs(above[0] - below[1]) > side || fabs(above[1] - below[0]) > side ||
           fabs(above[0] + below[1] - 2 * middle) > plane || fabs(above[1] + below[0] - 2 * middle) > plane;
}

/* Seen from above a wall between two grounds is thin, so a pixel's normal is the mean of its cells', of which most are ground. What they
 * scatter dims the highlight, as by scene_soften: else a wall's edge is a row of sparks. */
static void refine(const struct drawing *drawing, double normal[3], struct relief *point, double x, double y)
{
    enum { CELLS = 2 };
    const double side = drawing->frame.pixel / CELLS, left = x - drawing->frame.pixel / 2,
                 top = y + drawing->frame.pixel / 2;
    double heights[CELLS + 1][CELLS + 1], sum[3] = {0, 0, 0};
    for (unsigned i = 0; i <= CELLS; i++)
        for (unsigned k = 0; k <= CELLS; k++)
            heights[i][k] = drawing->thing(left + side * k, top - side * i, side, drawing->body).height;
    for (unsigned i = 0; i < CELLS * CELLS; i++) {
        const unsigned line = i / CELLS, at = i % CELLS;
        double cell[3];
        slopes(cell, &heights[line][at], &heights[line + 1][at], side);
        const double length = length_of(cell);
        for (unsigned k = 0; k < 3; k++)
            sum[k] += cell[k] / length / (CELLS * CELLS);
    }
    const double mean = fmin(1, length_of(sum)), n = drawing->scene->finish.n,
                 wider = mean * n / (mean + n * (1 - mean));
    memcpy(normal, sum, sizeof sum);
    point->gloss *= (1 + wider) / (1 + n);
}

/* Lines from first up to end. Heights are sampled at the pixels' corners: the mean slope over a pixel is then exact along its edges, and no
 * detail is lost between samples. Colours are sampled in the middle. */
static void draw_relief_lines(const struct drawing *drawing, size_t first, size_t end)
{
    const double *body = drawing->body;
    const struct frame f = drawing->frame;
    const size_t width = drawing->scene->width;
    double *above = allocate(width + 1, sizeof *above), *below = allocate(width + 1, sizeof *below);
    for (size_t x = 0; x <= width; x++)
        above[x] = drawing->thing(f.left + f.pixel * (double)x, edge_of(&f, first, 0), f.pixel, body).height;
    for (size_t y = first; y < end; y++) {
        for (size_t x = 0; x <= width; x++)
            below[x] = drawing->thing(f.left + f.pixel * (double)x, edge_of(&f, y, 1), f.pixel, body).height;
        for (size_t x = 0; x < width; x++) {
            const double mx = f.left + f.pixel * ((double)x + .5), my = edge_of(&f, y, .5);
            struct relief point = drawing->thing(mx, my, f.pixel, body);
            double normal[3];
            slopes(normal, &above[x], &below[x], f.pixel);
            if (is_bent(&above[x], &below[x], point.height, f.pixel))
                refine(drawing, normal, &point, mx, my);
            set_pixel(drawing, y * width + x, normal, point, mx, my);
        }
        double *swap = above;
        above = below;
        below = swap;
    }
    free(above);
    free(below);
}

static void draw_relief(const struct drawing *drawing)
{
    enum { BAND = 32 }; /* lines; each band finds the heights above it again */
    const size_t height = drawing->scene->height;
    sigset_t before;
    signals_hold_but_faults(&before); /* the first thread alone takes them, at once: a large scene takes long */
#pragma omp parallel
    {
#pragma omp master
        signals_release(&before);
#pragma omp for schedule(dynamic)
        for (size_t y = 0; y < height; y += BAND)
            draw_relief_lines(drawing, y, height - y < BAND ? height : y + BAND);
    }
}

static struct relief before_cloth(double x, double y)
{
    (void)x;
    (void)y;
    return coin_cloth;
}

static struct relief before_wall(double x, double y)
{
    (void)x;
    (void)y;
    return watch_wall;
}

/* ---- the sphere ---- */

/* A glossy ball before a matt wall that darkens towards the corners. */
static struct relief dark_corners(double x, double y)
{
    const double shade = mix(.36, .14, fmin(1, (x * x + y * y) / 2));
    return (struct relief){0, {.80 * shade, .92 * shade, shade}, 0, 0};
}

static void draw_sphere(const struct drawing *drawing)
{
    static const double radius = .8, red[3] = {.70, .10, .07};
    const double *color = drawing->body ? drawing->body : red;
    const struct scene *scene = drawing->scene;
    const struct frame f = drawing->frame;
    sigset_t before;
    signals_hold_but_faults(&before);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < (size_t)scene->width * scene->height; i++) {
        const double x = f.left + f.pixel * ((double)(i % scene->width) + .5);
        const double y = edge_of(&f, i / scene->width, .5);
        const double r = hypot(x, y);
        const double s = fmin(r, radius * .9999) / (radius * r + (r == 0)); /* sine of the slope over r */
        const double ball[3] = {x * s, y * s, sqrt(1 - r * s * r * s)};
        const struct relief point = {0, {color[0], color[1], color[2]}, 1, coverage(r - radius, f.pixel)};
        set_pixel(drawing, i, ball, point, x, y);
    }
    signals_release(&before);
}

/* ---- by name ---- */

const char *const scene_names[] = {"sphere", "watchface", "coin", "dial", "knob", "sunray", NULL};

static const struct {
    relief_function *at; /* NULL: the sphere */
    struct relief (*wall)(double x, double y);
    struct finish finish;
    uint8_t grain; /* enum glint_grain, about the picture's middle; used where the finish has n_across */
} scenes[] = {
    {NULL, dark_corners, {60, 0, {.15, .15, .15}, {.85, .85, .85}, {.8, .8, .8}}, 0},
    {relief_watchface, before_wall, {40, 0, {.2, .2, .2}, {.8, .8, .8}, {.7, .7, .7}}, 0},
    {relief_coin, before_cloth, {30, 0, {.15, .15, .15}, {.75, .75, .75}, {.75, .68, .5}}, 0},
    {relief_dial, before_wall, {60, 0, {.2, .2, .2}, {.8, .8, .8}, {.7, .7, .7}}, 0},
    {relief_knob, knob_panel, {160, 6, {.22, .22, .22}, {.5, .5, .5}, {.8, .8, .8}}, GLINT_GRAIN_SPUN},
    {relief_sunray, before_wall, {160, 8, {.25, .25, .25}, {.6, .6, .6}, {.75, .75, .75}}, GLINT_GRAIN_SUNRAY},
};

/* The place of a name; that of NULL where no scene has it. */
static unsigned find(const char *name)
{
    unsigned i = 0;
    while (scene_names[i] && !(name && strcmp(name, scene_names[i]) == 0))
        i++;
    return i;
}

const struct finish *scene_finish(const char *name)
{
    const unsigned i = find(name);
    return scene_names[i] ? &scenes[i].finish : &plain_finish;
}

struct scene *scene_draw(const char *name, uint32_t width, uint32_t height)
{
    return scene_draw_in(name, width, height, NULL, false);
}

struct scene *scene_draw_in(const char *name, uint32_t width, uint32_t height, const uint8_t body[3], bool cut)
{
    return scene_draw_lines(name, width, height, body, cut, 0, height);
}

struct scene *scene_draw_lines(const char *name, uint32_t width, uint32_t height, const uint8_t body[3], bool cut,
                               uint32_t top, uint32_t lines)
{
    const unsigned i = find(name);
    if (!scene_names[i])
        return NULL;
    double color[3];
    for (unsigned k = 0; body && k < 3; k++)
        color[k] = body[k] / 255.;
    struct scene *scene = scene_new(width, lines);
    scene->top = top;
    const struct drawing drawing = {scene,          frame_of(width, height, top), scenes[i].at,
                                    scenes[i].wall, body ? color : NULL,          cut};
    add_maps(scene, cut);
    scene->finish = scenes[i].finish;
    (drawing.thing ? draw_relief : draw_sphere)(&drawing);
    if (scenes[i].finish.n_across)
        scene->grain = (struct grain){scenes[i].grain, {width / 2., height / 2., 0}};
    return scene;
}
