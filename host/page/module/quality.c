/* SPDX-License-Identifier: MIT
 * What is told of the picture: its numbers as C has them, its errors, the curve of its lobe. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "compare/compare.h"
#include "compare/reference.h"
#include "draw/paths.h"
#include "image/format.h"
#include "mesh.h"
#include "mesh/fit.h"
#include "mesh/mesh.h"
#include "models/models.h"
#include "page.h"
#include "state.h"

/* ---- a text that is kept ---- */

struct text {
    char *bytes;
    size_t len;
    FILE *stream;
};

static FILE *text_open(struct text *text)
{
    free(text->bytes);
    text->bytes = NULL;
    text->stream = open_memstream(&text->bytes, &text->len);
    if (!text->stream)
        fail("out of memory");
    return text->stream;
}

static const char *text_close(struct text *text)
{
    if (fclose(text->stream) != 0)
        fail("out of memory");
    return text->bytes;
}

/* ---- numbers ---- */

static void put3(FILE *out, const char *name, const uint32_t values[3])
{
    fprintf(out, "%s %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", name, values[0], values[1], values[2]);
}

/* The box in which the library says that the highlight lies; w = 0: there is none. */
static struct glint_box highlight_box(const struct glint_shader *shader)
{
    const struct page_state *now = page_state();
    const struct scene *scene = now->scene;
    if (!scene)
        return (struct glint_box){0}; /* a mesh's is not told */
    const size_t line = format_line_bytes(now->shading.format, scene->width);
    struct glint_vec *normals = scene_normals_q15(scene);
    uint8_t *pixels = allocate(scene->height, line);
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    shading_lamps(&now->shading, lamps);
    const struct glint_source source = {.normals = normals,
                                        .normals_stride = (ptrdiff_t)(scene->width * sizeof *normals),
                                        .gloss = scene->gloss,
                                        .gloss_stride = (ptrdiff_t)scene->width,
                                        .mask = scene->mask,
                                        .mask_stride = (ptrdiff_t)scene->width};
    const struct glint_surface surface = {pixels, (ptrdiff_t)line, 0, 0};
    const uint16_t w = (uint16_t)scene->width, h = (uint16_t)scene->height;
    struct glint_box box = {0};
    const enum glint_err error =
        shading_is_plain(&now->shading)
            ? glint_shade_rect(shader, &source, w, h, &surface, &box)
            : glint_shade_lights(shader, lamps, now->shading.lamp_count, &source, w, h, &surface, &box);
    if (error != GLINT_OK)
        fail("the library refused the rectangle (error %d)", error);
    free(normals);
    free(pixels);
    return box;
}

/* Of what is drawn, for what takes one colour: the mean of its albedo. */
static void mean_colour(const struct page_state *now, unsigned mean[3])
{
    const struct scene *scene = now->scene;
    const size_t pixels = (size_t)now->width * now->height;
    uint64_t sum[3] = {0}, count = 0;
    for (size_t i = 0; scene && scene->albedo && i < pixels; i++) {
        if (scene->mask && !scene->mask[i])
            continue;
        for (unsigned k = 0; k < 3; k++)
            sum[k] += scene->albedo[3 * i + k];
        count++;
    }
    for (unsigned k = 0; k < 3; k++)
        mean[k] = count ? (unsigned)((sum[k] + count / 2) / count) : now->shading.color[k];
}

const char *page_facts(void)
{
    static struct text text;
    const struct page_state *now = page_state();
    const struct shading *shading = &now->shading;
    const struct glint_shader shader = shading_shader(shading);
    const struct glint_material *m = &shader.material;
    const int32_t cutoff = (int32_t)glint_cutoff(shading->model, shading->n, shading->q);
    const struct glint_box box = highlight_box(&shader);
    unsigned mean[3];
    FILE *out = text_open(&text);
    fprintf(out, "n %u\nq %u\n", shading->n, shading->q);
    put3(out, "ambient_q16", m->ambient_q16);
    put3(out, "diffuse_q16", m->diffuse_q16);
    put3(out, "specular_q16", m->specular_q16);
    fprintf(out, "albedo %u %u %u\n", m->albedo[0], m->albedo[1], m->albedo[2]);
    mean_colour(now, mean);
    fprintf(out, "colour %u %u %u\n", mean[0], mean[1], mean[2]);
    fprintf(out, "has_albedo %d\nhas_gloss %d\nhas_mask %d\n", now->scene && now->scene->albedo,
            now->scene && now->scene->gloss, now->scene && now->scene->mask);
    /* as on a microcontroller: pointers have 32 bits here, too */
    fprintf(out, "prepared_bytes %zu\ncolour_bytes %u\nsmall_bytes %u\nalbedo_bytes %u\n",
            sizeof(struct glint_prepared),
            shading->dither ? (unsigned)GLINT_TABLES_DITHER_BYTES : (unsigned)GLINT_TABLES_COLOUR_BYTES,
            (unsigned)GLINT_TABLES_SMALL_BYTES, (unsigned)GLINT_TABLES_ALBEDO_BYTES);
    if (page_mesh()) {
        const struct view *view = &page_mesh()->view;
        fprintf(out, "faces %zu\nmesh_bytes %zu\n", page_mesh()->mesh->face_count,
                fitted_bytes(page_mesh()->fitted, strstr(path_names[shading->path], "int8")));
        fprintf(out, "turn %.9g %.9g %.9g\nzoom %.9g\n", view->turn[0], view->turn[1], view->turn[2], view->zoom);
    }
    fprintf(out, "cutoff_c_q16 %" PRId32 "\ncutoff_t_q30 %" PRIu32 "\n", cutoff,
            glint_cutoff_t(shading->model, shading->n, shading->q));
    fprintf(out, "cutoff_degrees %.6f\n", acos(cutoff / 65536.) * 180 / M_PI);
    fprintf(out, "l_q15 %d %d %d\nh_q15 %d %d %d\n", shader.light.l.x, shader.light.l.y, shader.light.l.z,
            shader.light.h.x, shader.light.h.y, shader.light.h.z);
    fprintf(out, "box %u %u %u %u\n", box.x, box.y, box.w, box.h);
    return text_close(&text);
}

/* ---- errors ---- */

static uint8_t *error_rgba;
static uint32_t error_times, bins[PAGE_BINS];

/* Over what is drawn, each sample against the unrounded reference. */
static void count(const struct levels *levels, const struct scene *scene, const struct shading *shadings)
{
    const unsigned channels = levels->channels;
    const size_t samples = (size_t)levels->width * channels;
    double *line = allocate(samples, sizeof *line);
    for (unsigned i = 0; i < PAGE_BINS; i++)
        bins[i] = 0;
    for (uint32_t y = 0; y < levels->height; y++) {
        reference_line(scene, shadings, shadings->model, y, line);
        for (size_t i = 0; i < samples; i++) {
            const size_t at = y * samples + i;
            if (scene->mask && !scene->mask[at / channels])
                continue;
            const double off = 255 * fabs((double)levels->values[at] / levels->max[i % channels] - line[i]);
            bins[(unsigned)fmin(PAGE_BINS - 1, floor(4 * off + .5))]++;
        }
    }
    free(line);
}

const char *page_compare(void)
{
    static struct text text;
    const struct page_state *now = page_state();
    const struct shading *shadings;
    struct scene *scene = page_scene(&shadings);
    struct comparison comparison;
    compare(scene, shadings, now->levels, &comparison);
    error_times = error_map_amplification(&comparison.unrounded);
    struct picture *map = error_map(scene, shadings, now->levels, shadings->model, error_times);
    free(error_rgba);
    error_rgba = rgba_of_picture(map);
    picture_free(map);
    count(now->levels, scene, shadings);
    page_scene_done(scene);
    comparison_print(&comparison, shadings, now->levels, text_open(&text));
    return text_close(&text);
}

const uint8_t *page_error_map(void)
{
    return error_rgba;
}

uint32_t page_error_times(void)
{
    return error_times;
}

const uint32_t *page_histogram(void)
{
    return bins;
}

/* ---- the curve ---- */

const double *page_curve(uint32_t model, uint32_t n, uint32_t count, double degrees)
{
    static double *rows;
    free(rows);
    rows = allocate(3 * (size_t)count, sizeof *rows);
    for (uint32_t i = 0; i < count; i++) {
        const double c = cos(degrees * i / (count - 1) * M_PI / 180);
        const uint32_t t = (uint32_t)lround((1 - c) * (double)GLINT_T_ONE);
        rows[i] = glint_eval_t((enum glint_model)model, n, t) / 65536.;
        rows[count + i] = model_double((enum glint_model)model, n, c);
        rows[2 * count + i] = model_double(GLINT_BLINN, n, c);
    }
    return rows;
}
