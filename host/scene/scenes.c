/* SPDX-License-Identifier: MIT
 * The built-in scenes: the sphere, and reliefs turned into normals. */
#include "scene/scenes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "scene/coin.h"
#include "scene/shapes.h"
#include "scene/watchface.h"

static uint8_t to_byte(double value)
{
    return (uint8_t)lround(255 * fmax(0, fmin(1, value)));
}

/* Positions in units of half the shorter side, from the picture's middle. */
struct frame {
    double left, top, pixel;
};

static struct frame frame_of(uint32_t width, uint32_t height)
{
    const double pixel = 2.0 / fmin(width, height);
    return (struct frame){-pixel * width / 2, pixel * height / 2, pixel};
}

static void add_maps(struct scene *scene)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    scene->albedo = allocate(pixels, 3);
    scene->gloss = allocate(pixels, 1);
}

static void set_pixel(struct scene *scene, size_t pixel, const double normal[3], const struct relief *point)
{
    const double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    for (unsigned k = 0; k < 3; k++) {
        scene->normals[pixel][k] = normal[k] / length;
        scene->albedo[3 * pixel + k] = to_byte(point->albedo[k]);
    }
    scene->gloss[pixel] = to_byte(point->gloss);
}

/* ---- reliefs ---- */

/* Heights are sampled at the pixels' corners: the mean slope over a pixel is then exact along its edges, and no detail is
 * lost between samples. Colours are sampled in the middle. */
static void draw_relief(struct scene *scene, relief_function *at, const double body[3])
{
    const struct frame f = frame_of(scene->width, scene->height);
    const size_t width = scene->width;
    double *above = allocate(width + 1, sizeof *above), *below = allocate(width + 1, sizeof *below);
    for (size_t x = 0; x <= width; x++)
        above[x] = at(f.left + f.pixel * (double)x, f.top, f.pixel, body).height;
    for (size_t y = 0; y < scene->height; y++) {
        for (size_t x = 0; x <= width; x++)
            below[x] = at(f.left + f.pixel * (double)x, f.top - f.pixel * (double)(y + 1), f.pixel, body).height;
        for (size_t x = 0; x < width; x++) {
            const double right = (above[x + 1] - above[x] + below[x + 1] - below[x]) / (2 * f.pixel);
            const double up = (above[x] - below[x] + above[x + 1] - below[x + 1]) / (2 * f.pixel);
            const struct relief middle =
                at(f.left + f.pixel * ((double)x + .5), f.top - f.pixel * ((double)y + .5), f.pixel, body);
            set_pixel(scene, y * width + x, (double[3]){-right, -up, 1}, &middle);
        }
        double *swap = above;
        above = below;
        below = swap;
    }
    free(above);
    free(below);
}

/* ---- the sphere ---- */

/* A glossy ball before a matt wall that darkens towards the corners. At the silhouette the two are mixed by coverage and
 * the gloss fades first, or a mixed normal would catch a highlight that neither has. */
static void draw_sphere(struct scene *scene, const double body[3])
{
    static const double red[3] = {.70, .10, .07};
    const double *color = body ? body : red;
    static const double radius = .8;
    const struct frame f = frame_of(scene->width, scene->height);
    for (size_t i = 0; i < (size_t)scene->width * scene->height; i++) {
        const double x = f.left + f.pixel * ((double)(i % scene->width) + .5);
        const double y = f.top - f.pixel * ((double)(i / scene->width) + .5);
        const double r = hypot(x, y);
        const double shade = mix(.36, .14, fmin(1, r * r / 2));
        struct relief point = {0, {.80 * shade, .92 * shade, shade}, 0};
        double normal[3] = {0, 0, 1};
        const double part = coverage(r - radius, f.pixel);
        if (part > 0) {
            const double s = fmin(r, radius * .9999) / (radius * r + (r == 0)); /* sine of the slope over r */
            const double rise = sqrt(1 - r * s * r * s);
            const double ball[3] = {x * s, y * s, rise};
            for (unsigned k = 0; k < 3; k++)
                normal[k] = mix(normal[k], ball[k], part);
            relief_cover(&point, &(struct relief){0, {color[0], color[1], color[2]}, 1}, part);
            point.gloss = part < 1 ? 0 : 1;
        }
        set_pixel(scene, i, normal, &point);
    }
}

/* ---- by name ---- */

const char *const scene_names[] = {"sphere", "watchface", "coin", "dial", NULL};

static const struct {
    relief_function *at; /* NULL: the sphere */
    struct finish finish;
} scenes[] = {
    {NULL, {60, 0, {.15, .15, .15}, {.85, .85, .85}, {.8, .8, .8}}},
    {relief_watchface, {40, 0, {.2, .2, .2}, {.8, .8, .8}, {.7, .7, .7}}},
    {relief_coin, {30, 0, {.15, .15, .15}, {.75, .75, .75}, {.75, .68, .5}}},
    {relief_dial, {60, 0, {.2, .2, .2}, {.8, .8, .8}, {.7, .7, .7}}},
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
    return scene_draw_in(name, width, height, NULL);
}

struct scene *scene_draw_in(const char *name, uint32_t width, uint32_t height, const uint8_t body[3])
{
    const unsigned i = find(name);
    double color[3];
    for (unsigned k = 0; body && k < 3; k++)
        color[k] = body[k] / 255.;
    if (!scene_names[i])
        return NULL;
    struct scene *scene = scene_new(width, height);
    add_maps(scene);
    if (scenes[i].at)
        draw_relief(scene, scenes[i].at, body ? color : NULL);
    else
        draw_sphere(scene, body ? color : NULL);
    scene->finish = scenes[i].finish;
    return scene;
}
