/* SPDX-License-Identifier: MIT
 * The picture in doubles, from the original normals, directions and coefficients: what the library's integers are to
 * come near. Written from the formula, not from the library. */
#include <math.h>

#include "host.h"
#include "shade.h"

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

struct geometry {
    double l[3], v[3], h[3];
};

static struct geometry geometry_of(const struct shading *shading)
{
    struct geometry g;
    for (unsigned k = 0; k < 3; k++) {
        g.l[k] = shading->light[k];
        g.v[k] = shading->view[k];
    }
    normalize(g.l);
    normalize(g.v);
    for (unsigned k = 0; k < 3; k++)
        g.h[k] = g.l[k] + g.v[k];
    normalize(g.h);
    return g;
}

static double highlight(const struct geometry *g, const struct shading *shading, enum glint_model model,
                        const double normal[3], double nl)
{
    double c = dot(normal, g->h);
    if (model == GLINT_PHONG) {
        double r[3];
        for (unsigned k = 0; k < 3; k++)
            r[k] = 2 * nl * normal[k] - g->l[k];
        c = dot(g->v, r);
    }
    if (nl <= 0 || c < 0)
        return 0;
    const double f = model_double(model, shading->n, fmin(1, c));
    if (f < ldexp(1, -(int)shading->q))
        return 0;
    return shading->clamp_peak ? fmin(1, f) : f;
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
    const struct geometry g = geometry_of(shading);
    const unsigned channels = format_channels(shading->format);
    const bool linear = shading->space == GLINT_LINEAR;
    for (uint32_t x = 0; x < scene->width; x++) {
        const size_t i = (size_t)y * scene->width + x;
        const double nl = dot(scene->normals[i], g.l);
        const double gloss = scene->gloss ? scene->gloss[i] / 255. : 1;
        const double f = gloss * highlight(&g, shading, model, scene->normals[i], nl);
        double value[3];
        for (unsigned k = 0; k < 3; k++) {
            double albedo = (scene->albedo ? scene->albedo[3 * i + k] : shading->color[k]) / 255.;
            if (linear)
                albedo = srgb_decode(albedo);
            value[k] =
                fmin(1, albedo * (shading->ambient[k] + shading->diffuse[k] * fmax(0, nl)) + shading->specular[k] * f);
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
