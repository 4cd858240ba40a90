/* SPDX-License-Identifier: MIT */
#include "cases.h"

#include "glint_lobe.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chosen.h"

static int16_t extreme(uint64_t *seed)
{
    static const int16_t of[] = {-32768, -32767, 32767, 0, 1, -1};
    return of[BELOW(6)];
}

struct glint_vec case_vector(uint64_t *seed)
{
    struct glint_vec v = {(int16_t)(BELOW(65536) - 32768), (int16_t)(BELOW(65536) - 32768),
                          (int16_t)(BELOW(65536) - 32768)};
    if (ONE_IN(3)) {
        v.x = extreme(seed);
        v.y = extreme(seed);
        v.z = extreme(seed);
    }
    return v;
}

static uint32_t coefficient(uint64_t *seed)
{
    static const uint32_t of[] = {0, 1, 65535, 65536, 65537, UINT32_MAX, 32768, 64000};
    return BELOW(2) ? BELOW(65537) : ONE_IN(2) ? BELOW(12000) : of[BELOW(8)];
}

static enum glint_model case_model(uint64_t *seed)
{
    const enum glint_model any = (enum glint_model)BELOW(GLINT_MODEL_COUNT);
    return only_model() < 0 ? any : (enum glint_model)only_model();
}

void case_color(uint64_t *seed, struct glint_light *light)
{
    static const uint32_t colors[] = {0, 1, 65535, 65536, 65537, 1 << 20, UINT32_MAX, 32768};
    const bool grey = ONE_IN(2);
    const unsigned bits = 14 + BELOW(7);
    for (int k = 0; k < 3; k++) {
        light->color_q16[k] = ONE_IN(3) ? colors[BELOW(8)] : BELOW(UINT32_C(1) << bits);
        if (grey)
            light->color_q16[k] = light->color_q16[0];
    }
}

/* Of length 1, or made by hand: shorter. */
static void case_light(uint64_t *seed, struct reference *s)
{
    const int32_t l[3] = {(int32_t)BELOW(201) - 100, (int32_t)BELOW(201) - 100, (int32_t)BELOW(120)},
                  front[3] = {0, 0, 1};
    if (glint_light_directional(&s->lights[0], l))
        (void)glint_light_directional(&s->lights[0], front);
    const uint32_t down = ONE_IN(16) ? BELOW(UINT32_C(1) << 30) : UINT32_C(1) << 30;
    for (int k = 0; k < 3; k++) {
        s->to_viewer[k] = ONE_IN(2) ? front[k] : (int32_t)BELOW(401) - 200;
        s->lights[0].direction_q30[k] = (int32_t)((int64_t)s->lights[0].direction_q30[k] * down >> 30);
    }
    if (ONE_IN(2))
        memcpy(s->to_viewer, front, sizeof front);
    if (ONE_IN(2))
        case_color(seed, &s->lights[0]);
}

/* Of GLINT_MODELS. */
bool case_has_grain(uint8_t model)
{
#define GRAIN_grained true
#define GRAIN_plain false
#define HAS(number, name, function, use, grain) [number] = GRAIN_##grain,
    static const bool has[] = {GLINT_MODELS(HAS)};
#undef HAS
    return has[model];
}

struct reference case_look(uint64_t *seed, struct glint_vec lvh[3])
{
    static const uint16_t shininess[] = {1, 2, 3, 4, 5, 10, 60, 200, 1000};
    struct reference s;
    memset(&s, 0, sizeof s);
    s.count = 1;
    s.material.model = (uint8_t)case_model(seed);
    s.material.n = (uint16_t)(ONE_IN(16) ? 1 + BELOW(65535) : ONE_IN(3) ? 1 + BELOW(1000) : shininess[BELOW(9)]);
    s.material.n_across = ONE_IN(3) ? s.material.n : 0;
    if (case_has_grain(s.material.model) && ONE_IN(4)) /* n_across */
        s.material.n_across = (uint16_t)(ONE_IN(3) ? 1 + BELOW(1200) : shininess[BELOW(9)]);
    s.material.q = (uint8_t)(ONE_IN(16) ? BELOW(256) : BELOW(17));
    do
        case_light(seed, &s);
    while (!reference_directions(&s, &s.lights[0], lvh));
    const bool grey = ONE_IN(2), plain = ONE_IN(2);                /* plain: no level is full */
    const uint32_t dim = ONE_IN(6) ? UINT32_C(1) << BELOW(14) : 0; /* dim: V has few bits, or takes more of them */
    for (int k = 0; k < 3; k++) {
        s.material.ambient_q16[k] = dim ? BELOW(dim) : plain ? BELOW(6000) : coefficient(seed);
        s.material.diffuse_q16[k] = dim ? BELOW(dim) : plain ? BELOW(40000) : coefficient(seed);
        s.material.specular_q16[k] = dim ? BELOW(dim) : coefficient(seed);
        s.material.albedo[k] = (uint8_t)(ONE_IN(2) ? 255 : BELOW(256));
        if (grey && k) {
            s.material.ambient_q16[k] = s.material.ambient_q16[0];
            s.material.diffuse_q16[k] = s.material.diffuse_q16[0];
            s.material.specular_q16[k] = s.material.specular_q16[0];
        }
    }
    s.output.format = (uint8_t)BELOW(5);
    if (s.output.format == GLINT_RGB888 && ONE_IN(2)) /* half of these: what is found in one of them is found in all */
        s.output.format = (uint8_t)(GLINT_BGR888 + BELOW(GLINT_GREY4 - GLINT_BGR888));
    if (s.output.format == GLINT_MONO && ONE_IN(2))
        s.output.format = (uint8_t)(GLINT_GREY4 + BELOW(2));
    s.output.space = (uint8_t)ONE_IN(3);
    s.output.dither = ONE_IN(2);
    s.material.clamp_peak = ONE_IN(2);
    return s;
}

struct glint_vec case_unit(const double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    struct glint_vec unit = {0, 0, 32767};
    if (length > 0) {
        unit.x = (int16_t)lrint(v[0] * 32767 / length);
        unit.y = (int16_t)lrint(v[1] * 32767 / length);
        unit.z = (int16_t)lrint(v[2] * 32767 / length);
    }
    return unit;
}

struct glint_vec case_normal(uint64_t *seed, struct glint_vec h, int spread)
{
    if (ONE_IN(16))
        return case_vector(seed);
    if (ONE_IN(3)) {
        const double any[3] = {(double)BELOW(2001) - 1000, (double)BELOW(2001) - 1000, (double)BELOW(1000)};
        return case_unit(any);
    }
    const int32_t x = h.x + (int32_t)BELOW((uint32_t)spread) - spread / 2;
    const int32_t y = h.y + (int32_t)BELOW((uint32_t)spread) - spread / 2;
    const struct glint_vec n = {(int16_t)x, (int16_t)y, h.z};
    return n;
}

struct glint_maps case_maps(uint64_t *seed, struct case_scene *s, unsigned w, unsigned h)
{
    struct glint_maps maps = {
        .albedo_format = GLINT_RGB888, .albedo_stride = 3 * CASE_W, .gloss_stride = CASE_W, .coverage_stride = CASE_W};
    maps.grain_kind = (uint8_t)BELOW(GLINT_GRAIN_SUNRAY + 1);
    for (int k = 0; k < 2; k++) /* a direction, or a centre near or far */
        maps.grain_at[k] = ONE_IN(3) ? (int32_t)BELOW(16 * 65536) : ONE_IN(3) ? 0 : (int32_t)BELOW(1 << 24) - (1 << 23);
    maps.grain_stride = maps.shininess_stride = CASE_W;
    maps.albedo = ONE_IN(2) ? s->albedo : NULL;
    maps.gloss = ONE_IN(3) ? s->gloss : NULL;
    maps.coverage = ONE_IN(3) ? s->coverage : NULL;
    const unsigned empty = ONE_IN(4) ? 2 : 5, full = 1 + BELOW(3);
    for (unsigned y = 0; y < h; y++)
        for (unsigned i = CASE_W * y; i < CASE_W * y + w; i++) {
            s->bytes[i] = (uint8_t)BELOW(256);
            s->gloss[i] = (uint8_t)(!maps.gloss || ONE_IN(2) ? 255 : BELOW(256));
            s->coverage[i] = (uint8_t)(!maps.coverage ? 255 : ONE_IN(empty) ? 0 : ONE_IN(full) ? 255 : 1 + BELOW(255));
            for (unsigned k = 0; k < 3 && maps.albedo; k++)
                s->albedo[3 * i + k] = (uint8_t)BELOW(256);
        }
    return maps;
}

void case_grain(uint64_t *seed, struct case_scene *s, const struct glint_material *material, bool normals,
                struct glint_maps *maps)
{
    const uint32_t n = material->n < 1000 ? material->n : 1000;
    const bool is_grained = material->n_across && material->n_across != n && (n < 1000 || material->n_across < 1000);
    if (!case_has_grain(material->model))
        return;
    if (!normals)
        maps->grain_kind = GLINT_GRAIN_BRUSHED;
    else if (ONE_IN(4))
        maps->grain = s->bytes;
    if (!is_grained && !maps->grain && ONE_IN(6))
        maps->shininess = s->bytes;
}

struct glint_surface case_target(uint64_t *seed, struct case_scene *s)
{
    const bool up = ONE_IN(4);
    const ptrdiff_t start = (up ? CASE_H : 1) * CASE_LINE + (ptrdiff_t)BELOW(3);
    const struct glint_surface target = {s->out + start, up ? -CASE_LINE : CASE_LINE - (ptrdiff_t)BELOW(3),
                                         (uint16_t)BELOW(65536), (uint16_t)BELOW(65536)};
    for (unsigned i = 0; i < CASE_SIZE; i++)
        s->out[i] = (uint8_t)BELOW(256);
    memcpy(s->expected, s->out, CASE_SIZE);
    return target;
}

struct glint_surface case_expected(struct case_scene *s, const struct glint_surface *target)
{
    struct glint_surface expected = *target;
    expected.pixels = s->expected + ((uint8_t *)target->pixels - s->out);
    return expected;
}

bool case_same(const struct case_scene *s, const struct glint_box *a, const struct glint_box *b)
{
    return !memcmp(s->out, s->expected, CASE_SIZE) && a->x == b->x && a->y == b->y && a->w == b->w && a->h == b->h;
}

static const struct glint_use_model *const models[] = {
#define USE(number, name, function, use, grain) &glint_use_##name,
    GLINT_MODELS(USE)
#undef USE
};

/* The paint by a model whose slack is 0. */
static enum glint_err paint_without_slack(struct glint_paint *paint, const struct reference *look)
{
    static const struct glint_use_format *const formats[] = {&glint_use_rgb565, &glint_use_rgb888, &glint_use_grey,
                                                             &glint_use_linear};
    static struct glint_use_model exact[GLINT_MODEL_COUNT];
    struct glint_use_model *model = &exact[look->material.model];
    enum glint_err err = GLINT_ERR_FORMAT;
#pragma omp critical
    if (!model->run) {
        *model = *models[look->material.model];
        model->slack = 0;
    }
    for (int i = 0; i < 4 && err == GLINT_ERR_FORMAT; i++)
        err = glint_paint_exact_for(paint, &look->material, &look->output, model, formats[i]);
    return err ? err : glint_paint_light(paint, look->lights, look->count, look->to_viewer);
}

/* The bounds of white light in the place of a coloured one's. */
static void paint_as_white(struct glint_paint *paint, const struct reference *look)
{
    struct reference white = *look;
    struct glint_paint other;
    for (int k = 0; k < 3; k++)
        white.lights[0].color_q16[k] = 65536;
    if (look->count == 1 && !paint->several && !reference_paint(&other, &white) &&
        other.of.exact.shift == paint->of.exact.shift) {
        paint->of.exact.w = other.of.exact.w;
        paint->of.exact.w_maps = other.of.exact.w_maps;
    }
}

enum glint_err case_paint(struct glint_paint *paint, const struct reference *look)
{
    const char *fault = getenv("GLINT_FAULT");
    if (fault && !strncmp(fault, "slack-", 6) && !strcmp(fault + 6, model_names[look->material.model]))
        return paint_without_slack(paint, look);
    const enum glint_err err = reference_paint(paint, look);
    if (!fault || err)
        return err;
    const bool is_gamma = look->output.space == GLINT_GAMMA;
    uint32_t *const w = &paint->of.exact.w, *const w_maps = &paint->of.exact.w_maps, most = paint->of.exact.most;
    if (is_gamma && !strcmp(fault, "half-w"))
        *w /= 2;
    if (is_gamma && !strcmp(fault, "w"))
        *w = 0;
    if (is_gamma && !strcmp(fault, "half-maps-w"))
        *w_maps /= 2;
    if (is_gamma && !strcmp(fault, "maps-w"))
        *w_maps = 0;
    if (!is_gamma && !strcmp(fault, "linear-w"))
        *w = *w_maps = 0;
    if (!strcmp(fault, "high") && paint->of.exact.high && is_gamma) {
        const bool has_threshold = look->output.format != GLINT_GREY8 && look->output.format != GLINT_MONO &&
                                   look->output.format < GLINT_GREY4 && !look->output.dither;
        for (int k = 0; k < 3 && has_threshold; k++)
            paint->of.exact.p[k] += (uint32_t)paint->of.exact.high << (paint->of.exact.shift - 15);
        paint->of.exact.high = 0;
    }
    if (!strcmp(fault, "color-w"))
        paint_as_white(paint, look);
    if (!strcmp(fault, "sums-w") && paint->several && most > 65536) {
        *w = (uint32_t)((uint64_t)*w * 65536 / most);
        *w_maps = (uint32_t)((uint64_t)*w_maps * 65536 / most);
    }
    if (!strcmp(fault, "sums-most") && paint->several)
        paint->of.exact.most = UINT32_C(1) << 24;
    return GLINT_OK;
}

static uint64_t pixels_of(unsigned share)
{
    const char *set = getenv("GLINT_PIXELS");
    return UINT64_C(1000) * share * (set ? strtoul(set, NULL, 10) : 100);
}

bool cases_pass(unsigned (*one)(uint64_t *seed, void *memory), size_t bytes, unsigned share)
{
    enum { BATCH = 64 };
    const uint64_t pixels = pixels_of(share);
    uint64_t done = 0, wrong = UINT64_MAX;
    for (uint64_t from = 0; done < pixels && wrong == UINT64_MAX; from += 4096) {
        uint64_t count = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : count) reduction(min : wrong)
        for (uint64_t batch = from; batch < from + 4096; batch += BATCH) {
            void *memory = malloc(bytes);
            for (uint64_t i = batch; i < batch + BATCH; i++) {
                uint64_t seed = i * UINT64_C(0x9e3779b97f4a7c15) + 1;
                const unsigned shaded = memory ? one(&seed, memory) : 0;
                count += shaded;
                if (!shaded && i < wrong)
                    wrong = i;
            }
            free(memory);
        }
        done += count;
    }
    if (wrong != UINT64_MAX)
        printf("# case %llu differs\n", (unsigned long long)wrong);
    printf("# %.0f million pixels\n", (double)done / 1e6);
    return wrong == UINT64_MAX;
}
