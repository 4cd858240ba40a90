/* SPDX-License-Identifier: MIT
 * What is told of the picture: its numbers as C has them, its errors, the curve of its lobe. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "compare/compare.h"
#include "compare/mesh_scene.h"
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
static struct glint_box highlight_box(const struct glint_paint *paint)
{
    const struct page_state *now = page_state();
    const struct scene *scene = now->scene;
    if (!scene)
        return (struct glint_box){0}; /* a mesh's is not told */
    const size_t line = format_line_bytes(now->shading.format, scene->width);
    struct glint_vec *normals = scene_normals_q15(scene);
    uint8_t *pixels = allocate(scene->height, line);
    struct glint_maps maps = {.normals = normals,
                              .normals_stride = (ptrdiff_t)(scene->width * sizeof *normals),
                              .gloss = scene->gloss,
                              .gloss_stride = (ptrdiff_t)scene->width,
                              .coverage = scene->mask,
                              .coverage_stride = (ptrdiff_t)scene->width,
                              .shininess = scene->shininess,
                              .shininess_stride = (ptrdiff_t)scene->width};
    scene_add_grain(scene, &now->shading, 0, &maps);
    const struct glint_surface target = {pixels, (ptrdiff_t)line, 0, 0};
    struct glint_box box = {0};
    const enum glint_err error =
        glint_draw_rect(paint, &maps, (uint16_t)scene->width, (uint16_t)scene->height, &target, &box);
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
    struct glint_light lights[GLINT_LIGHTS_MAX];
    const struct glint_paint paint = shading_paint(shading, lights);
    const struct glint_material *m = &paint.material;
    const int32_t cutoff = (int32_t)glint_cutoff(shading->model, shading->n, shading->q);
    unsigned mean[3];
    FILE *out = text_open(&text);
    fprintf(out, "n %u\nacross %u\nq %u\n", shading->n, shading->n_across ? shading->n_across : shading->n, shading->q);
    struct glint_maps maps = {.grain_kind = GLINT_GRAIN_BRUSHED};
    if (now->scene)
        scene_add_grain(now->scene, shading, 0, &maps);
    fprintf(out, "grain %u\ngrain_at %" PRId32 " %" PRId32 "\n",
            now->scene ? now->scene->grain.kind : GLINT_GRAIN_BRUSHED, maps.grain_at[0], maps.grain_at[1]);
    put3(out, "ambient_q16", m->ambient_q16);
    put3(out, "diffuse_q16", m->diffuse_q16);
    put3(out, "specular_q16", m->specular_q16);
    fprintf(out, "albedo %u %u %u\n", m->albedo[0], m->albedo[1], m->albedo[2]);
    mean_colour(now, mean);
    fprintf(out, "colour %u %u %u\n", mean[0], mean[1], mean[2]);
    fprintf(out, "has_albedo %d\nhas_gloss %d\nhas_mask %d\n", now->scene && now->scene->albedo,
            now->scene && now->scene->gloss, now->scene && now->scene->mask);
    /* as on a microcontroller: pointers have 32 bits here, too */
    fprintf(out, "paint_bytes %zu\ncolour_bytes %zu\nalbedo_bytes %zu\n", sizeof paint,
            glint_tables_bytes(GLINT_TABLES_COLOUR, shading->dither), glint_tables_bytes(GLINT_TABLES_ALBEDO, false));
    if (page_mesh()) {
        const struct view *view = &page_mesh()->view;
        fprintf(out, "split %g\n", page_mesh()->mesh->split);
        fprintf(out, "faces %zu\nmesh_bytes %zu\n", page_mesh()->mesh->face_count,
                fitted_bytes(page_mesh()->fitted, strstr(path_names[shading->path], "int8")));
        fprintf(out, "turn %.9g %.9g %.9g\nzoom %.9g\n", view->turn[0], view->turn[1], view->turn[2], view->zoom);
    }
    fprintf(out, "cutoff_c_q16 %" PRId32 "\ncutoff_t_q30 %" PRIu32 "\n", cutoff,
            glint_cutoff_t(shading->model, shading->n, shading->q));
    fprintf(out, "cutoff_degrees %.6f\n", acos(cutoff / 65536.) * 180 / M_PI);
    fprintf(out, "l_q15 %d %d %d\nh_q15 %d %d %d\n", paint.l.x, paint.l.y, paint.l.z, paint.h.x, paint.h.y, paint.h.z);
    return text_close(&text);
}

const uint32_t *page_box(void)
{
    static uint32_t four[4];
    struct glint_light lights[GLINT_LIGHTS_MAX];
    const struct glint_paint paint = shading_paint(&page_state()->shading, lights);
    const struct glint_box box = highlight_box(&paint);
    const uint32_t values[4] = {box.x, box.y, box.w, box.h};
    memcpy(four, values, sizeof four);
    return four;
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
    struct levels *behind = levels_behind(scene, shadings);
    for (unsigned i = 0; i < PAGE_BINS; i++)
        bins[i] = 0;
    for (uint32_t y = 0; y < levels->height; y++) {
        wanted_line(scene, shadings, shadings->model, behind, y, line);
        for (size_t i = 0; i < samples; i++) {
            const size_t at = y * samples + i;
            if (scene->mask && !scene->mask[at / channels])
                continue;
            const double off = 255 * fabs((double)levels->values[at] / levels->max[i % channels] - line[i]);
            bins[(unsigned)fmin(PAGE_BINS - 1, floor(4 * off + .5))]++;
        }
    }
    free(line);
    levels_free(behind);
}

/* What double precision draws: the scene, or what the mesh shows, to be freed then. Its parts have the shadings. */
static struct scene *scene_in_double(const struct shading **shadings)
{
    struct mesh_coverage coverage;
    const struct page_state *now = page_state();
    const struct page_mesh *mesh = page_mesh();
    *shadings = mesh ? mesh->now : &now->shading;
    return mesh ? mesh_scene(mesh->mesh, mesh->fitted, &mesh->view, *shadings, &coverage) : now->scene;
}

/* The picture, of a mesh with stepped outlines, to be freed then. */
static struct levels *levels_compared(void)
{
    const struct page_state *now = page_state();
    const enum glint_format format = now->shading.format;
    uint8_t *pixels = allocate(now->height, format_line_bytes(format, now->width));
    mesh_draw_stepped(pixels);
    struct levels *levels = levels_of_pixels(now->width, now->height, format, pixels);
    free(pixels);
    return levels;
}

const char *page_compare(void)
{
    static struct text text;
    const struct page_state *now = page_state();
    const struct shading *shadings;
    struct scene *scene = scene_in_double(&shadings);
    struct levels *levels = page_mesh() ? levels_compared() : now->levels;
    struct comparison comparison;
    compare(scene, shadings, levels, &comparison);
    error_times = error_map_amplification(&comparison.unrounded);
    struct picture *map = error_map(scene, shadings, levels, shadings->model, error_times);
    free(error_rgba);
    error_rgba = rgba_of_picture(map);
    picture_free(map);
    count(levels, scene, shadings);
    comparison_print(&comparison, shadings, levels, text_open(&text));
    if (page_mesh()) {
        scene_free(scene);
        levels_free(levels);
    }
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

static enum glint_model model_of(const char *name)
{
    for (unsigned i = 0; model_names[i]; i++)
        if (strcmp(name, model_names[i]) == 0)
            return (enum glint_model)i;
    fail("unknown model '%s'", name);
}

const double *page_curve(char *name, uint32_t n, uint32_t count, double degrees)
{
    static double *rows;
    const enum glint_model model = model_of(name);
    free(name);
    free(rows);
    rows = allocate(3 * (size_t)count, sizeof *rows);
    for (uint32_t i = 0; i < count; i++) {
        const double c = cos(degrees * i / (count - 1) * M_PI / 180);
        const uint32_t t = (uint32_t)lround((1 - c) * (double)GLINT_T_ONE);
        rows[i] = glint_eval_t(model, n, t) / 65536.;
        rows[count + i] = model_double(model, n, c);
        rows[2 * count + i] = model_double(GLINT_BLINN, n, c);
    }
    return rows;
}
