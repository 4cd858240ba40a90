/* SPDX-License-Identifier: MIT
 * The comparison, a line at a time: nothing the size of the picture is held in doubles. */
#include "compare/compare.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"
#include "compare/reference.h"
#include "draw/canvas.h"
#include "image/format.h"
#include "image/levels.h"
#include "image/picture.h"
#include "models/models.h"

static double rounded(double value, unsigned max, const struct shading *shading, uint32_t x, uint32_t y)
{
    return (double)reference_level(value, max, shading->dither, x, y) / max;
}

struct levels *levels_behind(const struct scene *scene, const struct shading *shading)
{
    if (!scene->mask || shading->format == GLINT_ARGB8888) /* which has coverage in its alpha */
        return NULL;
    const uint32_t width = scene->width, height = scene->height;
    uint8_t *pixels = backdrop_pixels(scene->backdrop, width, height, shading);
    if (!pixels)
        pixels = allocate(height, format_line_bytes(shading->format, width));
    struct levels *levels = levels_of_pixels(width, height, shading->format, pixels);
    free(pixels);
    return levels;
}

void wanted_line(const struct scene *scene, const struct shading *shading, enum glint_model model,
                 const struct levels *behind, uint32_t y, double *values)
{
    reference_line(scene, shading, model, y, values);
    for (uint32_t x = 0; behind && x < scene->width; x++) {
        const size_t pixel = (size_t)y * scene->width + x;
        const double covered = scene->mask[pixel] / 255.;
        for (unsigned k = 0; k < behind->channels; k++) {
            double *value = &values[behind->channels * x + k];
            *value = covered * fmin(1, *value) +
                     (1 - covered) * behind->values[behind->channels * pixel + k] / behind->max[k];
        }
    }
}

void compare(const struct scene *scene, const struct shading *shading, const struct levels *levels,
             struct comparison *out)
{
    struct levels *behind = levels_behind(scene, shading);
    *out = (struct comparison){0};
    const unsigned channels = levels->channels;
    double *same = allocate((size_t)levels->width * channels, sizeof *same);
    double *blinn = allocate((size_t)levels->width * channels, sizeof *blinn);
    for (uint32_t y = 0; y < levels->height; y++) {
        wanted_line(scene, shading, shading->model, behind, y, same);
        wanted_line(scene, shading, GLINT_BLINN, behind, y, blinn);
        const uint8_t *line = &levels->values[(size_t)y * levels->width * channels];
        for (uint32_t i = 0; i < levels->width * channels; i++) {
            const uint32_t x = i / channels;
            const unsigned k = i % channels, max = levels->max[k];
            if (scene->mask && !scene->mask[(size_t)y * levels->width + x])
                continue;
            const double value = (double)line[i] / max;
            const double ideal = rounded(same[i], max, shading, x, y);
            difference_add(&out->rounded, value, ideal, x, y, k);
            difference_add(&out->unrounded, value, same[i], x, y, k);
            difference_add(&out->rounding, ideal, same[i], x, y, k);
            difference_add(&out->blinn_rounded, value, rounded(blinn[i], max, shading, x, y), x, y, k);
            difference_add(&out->blinn_unrounded, value, blinn[i], x, y, k);
        }
    }
    free(same);
    free(blinn);
    levels_free(behind);
}

/* ---- the error map ---- */

unsigned error_map_amplification(const struct difference *d)
{
    unsigned amplification = 1;
    while (amplification < 1u << 16 && d->largest * amplification * 2 <= 255)
        amplification *= 2;
    return amplification;
}

struct picture *error_map(const struct scene *scene, const struct shading *shading, const struct levels *levels,
                          enum glint_model model, unsigned amplification)
{
    const unsigned channels = levels->channels;
    const size_t samples = (size_t)levels->width * channels;
    struct picture *map = allocate(1, sizeof *map);
    *map = (struct picture){levels->width, levels->height, channels, false, allocate(samples, levels->height)};
    double *line = allocate(samples, sizeof *line);
    struct levels *behind = levels_behind(scene, shading);
    for (uint32_t y = 0; y < levels->height; y++) {
        wanted_line(scene, shading, model, behind, y, line);
        for (size_t i = 0; i < samples; i++) {
            const size_t at = y * samples + i;
            if (scene->mask && !scene->mask[at / channels])
                continue;
            const double off = fabs((double)levels->values[at] / levels->max[i % channels] - line[i]);
            map->samples[at] = (uint8_t)lround(fmin(255, 255 * off * amplification));
        }
    }
    free(line);
    levels_free(behind);
    return map;
}

/* ---- the report ---- */

static void print_row(FILE *stream, const char *against, const struct difference *d, unsigned channels)
{
    fprintf(stream, "%-32s", against);
    if (d->differing == 0) {
        fputs("no difference\n", stream);
        return;
    }
    fprintf(stream, "%7.2f  %8.4f  %7.3f  at %u,%u %s\n", difference_psnr_db(d), difference_mean(d), d->largest, d->x,
            d->y, difference_channel(d, channels));
}

static void print_share(FILE *stream, const struct difference *d)
{
    if (d->differing)
        fprintf(stream, "  samples that differ: %llu of %llu (%.3g %%)\n", (unsigned long long)d->differing,
                (unsigned long long)d->samples, 100. * (double)d->differing / (double)d->samples);
}

void comparison_print(const struct comparison *c, const struct shading *shading, const struct levels *levels,
                      FILE *stream)
{
    const unsigned channels = levels->channels;
    char same[32], same_rounded[32];
    snprintf(same, sizeof same, "%s in double", model_names[shading->model]);
    snprintf(same_rounded, sizeof same_rounded, "%s in double, rounded", model_names[shading->model]);
    fprintf(stream, "%ux%u %s%s, %s, %s, n = %u, q = %u\n", levels->width, levels->height,
            format_names[shading->format], shading->dither ? " dithered" : "", space_names[shading->space],
            model_names[shading->model], shading->n, shading->q);
    if (c->rounding.samples == 0) {
        fputs("nothing is drawn: the mask leaves every pixel out\n", stream);
        return;
    }
    fprintf(stream, "%-32s%7s  %8s  %7s  in levels of 255\n", "against", "PSNR dB", "mean", "largest");
    print_row(stream, same_rounded, &c->rounded, channels);
    print_share(stream, &c->rounded);
    print_row(stream, same, &c->unrounded, channels);
    print_row(stream, "  of that, the rounding alone", &c->rounding, channels);
    if (shading->model == GLINT_BLINN)
        return;
    print_row(stream, "blinn in double, rounded", &c->blinn_rounded, channels);
    print_share(stream, &c->blinn_rounded);
    print_row(stream, "blinn in double", &c->blinn_unrounded, channels);
    if (shading->model == GLINT_PHONG)
        fputs("phong takes the power of V.R, blinn that of N.H: with the same n phong's highlight is smaller\n",
              stream);
}
