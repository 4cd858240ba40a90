/* SPDX-License-Identifier: MIT
 * The picture in doubles, from the original normals, directions and coefficients. It is written from the formula, not from
 * the library, so that an error in one does not hide in the other. */
#include "compare/reference.h"

#include <math.h>

#include "image/format.h"
#include "models/models.h"

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalize(double v[3])
{
    const double length = sqrt(dot(v, v));
    for (unsigned k = 0; k < 3; k++)
        v[k] /= length;
}

/* What a lamp is at a pixel. */
struct geometry {
    double l[3], v[3], h[3];
    double arrives; /* 0..1, of its light; 0 where there is no l or h */
};

/* 0 at x <= from, 1 at x >= to, an edge where they are equal. */
static double step(double from, double to, double x)
{
    const double part = x >= to ? 1 : x <= from ? 0 : (x - from) / (to - from);
    return part * part * (3 - 2 * part);
}

static double degrees_cosine(double degrees)
{
    return cos(degrees * M_PI / 180);
}

/* How much of a point or spot arrives at a place; `e` leads from there to the lamp. */
static double attenuation(const struct lamp *lamp, double e[3], const double place[3])
{
    e[0] = lamp->position[0] - place[0];
    e[1] = place[1] - lamp->position[1];
    e[2] = lamp->position[2] - place[2];
    const double u = dot(e, e) / (lamp->range * lamp->range);
    if (u == 0 || u >= 1)
        return 0;
    double all = (1 - u) * (1 - u);
    if (lamp->kind == LAMP_SPOT) {
        const double axis[3] = {lamp->target[0] - lamp->position[0], lamp->position[1] - lamp->target[1],
                                -lamp->position[2]};
        const double c = -dot(axis, e) / sqrt(dot(axis, axis) * dot(e, e));
        all *= step(degrees_cosine(lamp->cone[1]), degrees_cosine(lamp->cone[0]), c);
    }
    return all;
}

static struct geometry geometry_of(const struct shading *shading, const struct lamp *lamp, const double place[3])
{
    struct geometry g = {.arrives = 1};
    for (unsigned k = 0; k < 3; k++) {
        g.l[k] = lamp->direction[k];
        g.v[k] = shading->view[k];
    }
    if (lamp->kind != LAMP_DIRECTIONAL)
        g.arrives = attenuation(lamp, g.l, place);
    if (g.arrives == 0)
        return g;
    normalize(g.l);
    normalize(g.v);
    for (unsigned k = 0; k < 3; k++)
        g.h[k] = g.l[k] + g.v[k];
    if (dot(g.h, g.h) == 0)
        g.arrives = 0; /* straight behind */
    else
        normalize(g.h);
    return g;
}

/* What a pixel has besides its light. */
struct pixel {
    const double *normal, *place;
    double n;        /* shininess, along the grain where there is one */
    bool is_own;     /* not the material's */
    double grain[3]; /* its direction, not yet in the surface */
};

/* With a grain or a map of shininess; T is the grain's direction in the surface. Where it has none there, the mean of n and n_across
 * counts: that over all directions. */
static double grained(enum glint_model model, const struct pixel *pixel, const double h[3], double c, double n_across)
{
    const double *grain = pixel->grain, off = dot(pixel->normal, grain);
    const double square = dot(grain, grain) - off * off, along = dot(h, grain) - c * off;
    if (n_across > 0 && square > 1e-12)
        return model_grained(model, pixel->n, n_across, c, along * along / square);
    const double n = n_across > 0 ? (pixel->n + n_across) / 2 : pixel->n;
    return model_grained(model, n, n, c, 0);
}

static double highlight(const struct geometry *g, const struct shading *shading, enum glint_model model,
                        const struct pixel *pixel, double nl)
{
    const double *normal = pixel->normal;
    double c = dot(normal, g->h);
    if (model == GLINT_PHONG) {
        double r[3];
        for (unsigned k = 0; k < 3; k++)
            r[k] = 2 * nl * normal[k] - g->l[k];
        c = dot(g->v, r);
    }
    if (c < 0)
        return 0;
    c = fmin(1, c);
    const double f = shading->n_across || pixel->is_own ? grained(model, pixel, g->h, c, shading->n_across)
                                                        : model_double(model, pixel->n, c);
    if (f < ldexp(1, -(int)shading->q))
        return 0;
    return shading->clamp_peak ? fmin(1, f) : f;
}

/* What a lamp adds to what a surface that scatters all, and one that mirrors all, would send. */
static void add_lamp(const struct shading *shading, const struct lamp *lamp, enum glint_model model,
                     const struct pixel *pixel, double lit[3], double shine[3])
{
    const struct geometry g = geometry_of(shading, lamp, pixel->place);
    const double nl = dot(pixel->normal, g.l);
    if (g.arrives == 0 || nl <= 0)
        return;
    const double f = highlight(&g, shading, model, pixel, nl);
    for (unsigned k = 0; k < 3; k++) {
        lit[k] += lamp->color[k] * g.arrives * nl;
        shine[k] += lamp->color[k] * g.arrives * f;
    }
}

/* x, y: the pixel's middle. */
static void grain_at(const struct scene *scene, size_t i, double x, double y, double grain[3])
{
    const double *at = scene->grain.at;
    const double right = x - at[0], up = at[1] - y;
    grain[0] = at[0];
    grain[1] = at[1];
    grain[2] = at[2];
    if (scene->grain_map) {
        grain[2] = 0;
        grain[0] = cos(scene->grain_map[i] * M_PI / 256);
        grain[1] = sin(scene->grain_map[i] * M_PI / 256);
    } else if (scene->grain.kind != GLINT_GRAIN_BRUSHED) {
        const bool spun = scene->grain.kind == GLINT_GRAIN_SPUN;
        grain[2] = 0;
        grain[0] = spun ? -up : right;
        grain[1] = spun ? right : up;
    } else if (at[0] == 0 && at[1] == 0 && at[2] == 0) {
        grain[0] = 1;
    }
}

/* IEC 61966-2-1 */
static double srgb_decode(double encoded)
{
    return encoded <= .04045 ? encoded / 12.92 : pow((encoded + .055) / 1.055, 2.4);
}

static double srgb_encode(double linear)
{
    return linear <= .0031308 ? linear * 12.92 : 1.055 * pow(linear, 1 / 2.4) - .055;
}

void reference_line(const struct scene *scene, const struct shading *shading, enum glint_model model, uint32_t y,
                    double *values)
{
    static const double grey[3] = {GREY_RED / 256., GREY_GREEN / 256., GREY_BLUE / 256.};
    const unsigned channels = format_channels(shading->format);
    const bool linear = shading->space == GLINT_LINEAR;
    for (uint32_t x = 0; x < scene->width; x++) {
        const size_t i = (size_t)y * scene->width + x;
        const struct shading *own = &shading[scene->parts ? scene->parts[i] : 0];
        const double middle[3] = {x + .5, y + .5, 0};
        struct pixel pixel = {scene->normals[i], scene->places ? scene->places[i] : middle, own->n, false, {0}};
        if (scene->shininess)
            pixel.n = glint_shininess_n(scene->shininess[i]);
        grain_at(scene, i, middle[0], middle[1], pixel.grain);
        double lit[3] = {0}, shine[3] = {0};
        for (unsigned lamp = 0; lamp < own->lamp_count; lamp++)
            add_lamp(own, &own->lamps[lamp], model, &pixel, lit, shine);
        const double gloss = scene->gloss ? scene->gloss[i] / 255. : 1;
        double value[3];
        for (unsigned k = 0; k < 3; k++) {
            double albedo = (scene->albedo ? scene->albedo[3 * i + k] : own->color[k]) / 255.;
            if (linear)
                albedo = srgb_decode(albedo);
            value[k] =
                fmin(1, albedo * (own->ambient[k] + own->diffuse[k] * lit[k]) + own->specular[k] * gloss * shine[k]);
        }
        if (channels == 1)
            value[0] = dot(value, grey);
        for (unsigned k = 0; k < channels; k++)
            values[channels * x + k] = linear ? srgb_encode(value[k]) : value[k];
    }
}

unsigned reference_level(double value, unsigned max, bool dither, uint32_t x, uint32_t y)
{
    static const unsigned bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const double threshold = dither ? (2 * bayer[y % 4][x % 4] + 1) / 32. : .5;
    return (unsigned)floor(value * max + threshold);
}
