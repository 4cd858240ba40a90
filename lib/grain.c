/* SPDX-License-Identifier: MIT
 * Grain: m of each sample (step 2a of sequence.md), and lines drawn by F of t and m, under several lights, too. */
#include "glint_grain.h"
#include "glint_lights.h"
#include "glint_mesh_pose.h"
#include "glint_math.h"
#include "glint_math_vector.h"

/* ---- The direction U ---- */

/* With what is the same for all normals: |U|^2 and H.U, Q30. */
struct grain_way {
    int32_t x, y, z, h; /* z: of meshes alone */
    uint32_t square;
};

static inline void grain_way_set(struct grain_way *way, int32_t x, int32_t y, const struct glint_vec *h)
{
    way->x = x;
    way->y = y;
    way->h = h->x * x + h->y * y;
}

/* 2^15 sin, of 128ths of a quarter. */
const uint16_t glint_grain_sines[129] GLINT_FLASH = {
    0,     402,   804,   1206,  1608,  2009,  2411,  2811,  3212,  3612,  4011,  4410,  4808,  5205,  5602,
    5998,  6393,  6787,  7180,  7571,  7962,  8351,  8740,  9127,  9512,  9896,  10279, 10660, 11039, 11417,
    11793, 12167, 12540, 12910, 13279, 13646, 14010, 14373, 14733, 15091, 15447, 15800, 16151, 16500, 16846,
    17190, 17531, 17869, 18205, 18538, 18868, 19195, 19520, 19841, 20160, 20475, 20788, 21097, 21403, 21706,
    22006, 22302, 22595, 22884, 23170, 23453, 23732, 24008, 24279, 24548, 24812, 25073, 25330, 25583, 25833,
    26078, 26320, 26557, 26791, 27020, 27246, 27467, 27684, 27897, 28106, 28311, 28511, 28707, 28899, 29086,
    29269, 29448, 29622, 29792, 29957, 30118, 30274, 30425, 30572, 30715, 30853, 30986, 31114, 31238, 31357,
    31471, 31581, 31686, 31786, 31881, 31972, 32058, 32138, 32214, 32286, 32352, 32413, 32470, 32522, 32568,
    32610, 32647, 32679, 32706, 32729, 32746, 32758, 32766, 32768};

/* By an angle of a map, 256 a half turn: of length 1. */
static inline void grain_turned(struct grain_way *way, uint32_t angle, const struct glint_vec *h)
{
    const uint32_t back = angle <= 128 ? angle : 256 - angle;
    const int32_t x = GLINT_FLASH_U16(glint_grain_sines[128 - back]);
    grain_way_set(way, angle <= 128 ? x : -x, GLINT_FLASH_U16(glint_grain_sines[back]), h);
}

/* Of any length, shifted so that |x| + |y| is in 2^14 .. 2^15; up: of the pixel before. 0, 0 stays. */
static inline void grain_scaled(struct grain_way *way, int32_t x, int32_t y, unsigned *up, const struct glint_vec *h)
{
    const uint32_t size = (uint32_t)(x < 0 ? -x : x) + (uint32_t)(y < 0 ? -y : y); /* < 2^31 */
    if (size) {
        while (size >> (31 - *up))
            --*up;
        while (!(size >> (30 - *up)))
            ++*up;
    }
    x = (int32_t)((uint32_t)x << *up) >> 16;
    y = (int32_t)((uint32_t)y << *up) >> 16;
    way->square = (uint32_t)(x * x + y * y);
    grain_way_set(way, x, y, h);
}

/* ---- m ---- */

/* (H.T)^2 / 2 in Q22, held to most: of off = t N.U - D.U, D = N - H, which is -H.T times the root of d = |U|^2 - (N.U)^2 of a unit N. */
static inline __attribute__((always_inline)) uint32_t grain_half_square(uint32_t off_q30, uint32_t d_q27, uint32_t most)
{
    const uint32_t size = off_q30 >> 31 ? 0 - off_q30 : off_q30;
    uint32_t d = d_q27;
    if (d == 0)
        return most >> 1; /* the mean over all directions */
    if (size >> 30)
        return most;
    if (d >> 28)
        d = ((uint32_t)1 << 28) - 1; /* normals of no unit length, as before */
    int down = 11;
    while (!(d >> 27)) {
        d <<= 1;
        down--;
    }
    /* 2^43 / d: as glint_reciprocal, but for its last term */
    const uint32_t y = GLINT_FLASH_U8(glint_reciprocals[(d >> 21) - 64]);
    const int32_t e = (int32_t)(d * y), r = e >> 14;
    const uint32_t inverse = (((y << 23) + (uint32_t)((int32_t)y * ((r * r >> 13) - (e >> 6)) >> 6)) + 16384) >> 15;
    const uint32_t square = glint_squarehi_near(size << 2); /* Q32 */
    const uint32_t w = (square >> 16) * inverse + ((square & 0xffff) * inverse >> 16);
    if (down >= 0)
        return w >> down < most ? w >> down : most;
    return w <= most >> -down ? w << -down : most;
}

/* t N.U - D.U, Q30; modulo 2^32. */
static inline uint32_t grain_off(const struct grain_way *way, int32_t along, uint32_t t)
{
    const int32_t along_q14 = (int32_t)((uint32_t)along + 32768) >> 16;
    return ((t + 8192) >> 14) * (uint32_t)along_q14 - (uint32_t)along + (uint32_t)way->h;
}

/* Modulo 2^32, as all sums of normals and axes that need not be of length 1. */
static inline uint32_t grain_square(int32_t x)
{
    return (uint32_t)x * (uint32_t)x;
}

/* Of a normal. As |U|^2 - (N.U)^2 = z^2 |U|^2 + (N.V)^2, V being U turned by a quarter, nothing is lost where that is small. */
static inline __attribute__((always_inline)) uint32_t
grain_of_normal(const struct grain_way *way, bool is_unit, int32_t x, int32_t y, int32_t z, uint32_t t, uint32_t most)
{
    const int32_t along = x * way->x + y * way->y, across = (y * way->x - x * way->y) >> 15;
    uint32_t d = (uint32_t)(z * z);
    if (!is_unit)
        d = glint_mulhi_near(d << 1, way->square << 1);
    d = (d + grain_square(across)) >> 3;
    return grain_half_square(grain_off(way, along, t), d, most);
}

/* The same of a direction in space. |U|^2 |N|^2 - (N.U)^2 = |N x U|^2. */
static inline __attribute__((always_inline)) uint32_t grain_of_axis(const struct grain_way *way, int32_t x, int32_t y,
                                                                    int32_t z, uint32_t t, uint32_t most)
{
    const int32_t u = way->x, v = way->y, w = way->z;
    const int32_t a = (y * w - z * v) >> 15, b = (z * u - x * w) >> 15, c = (x * v - y * u) >> 15;
    const uint32_t d = (grain_square(a) + grain_square(b) + grain_square(c)) >> 3;
    const uint32_t along = (uint32_t)(x * u) + (uint32_t)(y * v) + (uint32_t)(z * w);
    return grain_half_square(grain_off(way, (int32_t)along, t), d, most);
}

/* ---- Samples ---- */

/* What is the same for all of a run. is_sine is known at compile time, but for meshes. */
struct grain_run {
    uint32_t n_across, more; /* n - n_across, modulo 2^32 */
    struct glint_vec l, h;
    bool is_sine;
};

static inline __attribute__((always_inline)) void grain_run_set(struct grain_run *g, const struct glint_paint *paint,
                                                                const struct glint_vec *l, const struct glint_vec *h,
                                                                bool is_sine)
{ /* by fields: no call of memcpy */
    g->n_across = glint_material_across(&paint->material);
    g->more = paint->of.exact.n - g->n_across;
    g->l.x = l->x, g->l.y = l->y, g->l.z = l->z;
    g->h.x = h->x, g->h.y = h->y, g->h.z = h->z;
    g->is_sine = is_sine;
}

/* t of m: Q22. */
static inline uint32_t grain_t(const struct grain_run *g, uint32_t t)
{
    return (g->is_sine ? t - (glint_squarehi_near(t << 1) >> 1) : t) >> 8;
}

/* What is known of U when it is compiled. */
enum grain_kind { GRAIN_UNIT, GRAIN_ANY, GRAIN_AXIS };

/* Steps 1, 2 and 2a of one normal; t and m are UINT32_MAX where N.L is 0 or t > 1. way: NULL where there is no grain: n times t. */
static inline __attribute__((always_inline)) void grain_sample(const struct grain_run *g, const struct grain_way *way,
                                                               enum grain_kind kind, const struct glint_vec *normal,
                                                               struct glint_sample *sample)
{
    const int32_t x = normal->x, y = normal->y, z = normal->z;
    const int32_t nl = (((x * g->l.x + y * g->l.y + z * g->l.z) >> 13) + 1) >> 1;
    sample->t_q30 = sample->f_q16 = UINT32_MAX;
    sample->nl_q16 = nl <= 0 ? 0 : nl < 65536 ? (uint32_t)nl : 65536;
    if (nl <= 0)
        return;
    const int32_t dx = x - g->h.x, dy = y - g->h.y, dz = z - g->h.z;
    const uint32_t xx = (uint32_t)dx * (uint32_t)dx, yy = (uint32_t)dy * (uint32_t)dy;
    const uint32_t zz = (uint32_t)dz * (uint32_t)dz, xy = xx + yy, sum = xy + zz, t = sum >> 1;
    if (xy < xx || sum < zz || t > GLINT_T_ONE)
        return;
    const uint32_t s = grain_t(g, t);
    sample->t_q30 = t;
    sample->f_q16 =
        g->n_across * s + g->more * (!way                 ? s
                                     : kind == GRAIN_AXIS ? grain_of_axis(way, x, y, z, t, s)
                                                          : grain_of_normal(way, kind == GRAIN_UNIT, x, y, z, t, s));
}

static inline __attribute__((always_inline)) void grain_one_way(const struct grain_run *g, const struct grain_way *way,
                                                                const struct glint_vec *normal,
                                                                struct glint_sample *sample, unsigned count)
{
    const struct glint_sample *end = sample + count;
    for (; sample != end; sample++, normal++)
        grain_sample(g, way, GRAIN_UNIT, normal, sample);
}

static inline __attribute__((always_inline)) void grain_by_map(const struct grain_run *g, const uint8_t *angle,
                                                               const struct glint_vec *normal,
                                                               struct glint_sample *sample, unsigned count)
{
    const struct glint_sample *end = sample + count;
    for (; sample != end; sample++, normal++, angle++) {
        struct grain_way way;
        grain_turned(&way, *angle, &g->h);
        grain_sample(g, &way, GRAIN_UNIT, normal, sample);
    }
}

/* Round a centre or away from it: x, y from it to the first pixel, y up. */
static inline __attribute__((always_inline)) void grain_by_place(const struct grain_run *g, bool spun, int32_t x,
                                                                 int32_t y, const struct glint_vec *normal,
                                                                 struct glint_sample *sample, unsigned count)
{
    unsigned up = 16;
    const struct glint_sample *end = sample + count;
    for (; sample != end; sample++, normal++, x += 16) {
        struct grain_way way;
        grain_scaled(&way, spun ? -y : x, spun ? x : y, &up, &g->h);
        grain_sample(g, &way, GRAIN_ANY, normal, sample);
    }
}

/* The pixels of a span from its pixel `from` on, whose N.U is linear, within (w + 1) 2^-30; t is there. */
static inline __attribute__((always_inline)) void grain_walk(const struct grain_run *g, const struct grain_way *way,
                                                             const struct glint_span *span, uint32_t from, uint32_t w,
                                                             struct glint_sample *sample, unsigned count)
{
    const int32_t first = span->ends[0][0] * way->x + span->ends[0][1] * way->y;
    const int32_t last = span->ends[1][0] * way->x + span->ends[1][1] * way->y, steps = w > 1 ? (int32_t)w - 1 : 1;
    const uint32_t step = 2 * (uint32_t)((last / 2 - first / 2) / steps);
    uint32_t at = (uint32_t)first + step * from; /* modulo 2^32: only a pixel's own is sure to fit */
    for (const struct glint_sample *end = sample + count; sample != end; sample++, at += step) {
        const uint32_t t = sample->t_q30, s = grain_t(g, t);
        const int32_t along = (int32_t)at, p = along >> 15;
        const uint32_t square = grain_square(p);
        sample->f_q16 = UINT32_MAX;
        if (t > GLINT_T_ONE)
            continue;
        const uint32_t d = square < GLINT_T_ONE ? (GLINT_T_ONE - square) >> 3 : 0;
        sample->f_q16 = g->n_across * s + g->more * grain_half_square(grain_off(way, along, t), d, s);
    }
}

/* n of a pixel, without grain. */
static inline __attribute__((always_inline)) void grain_shiny(struct grain_run *g, const uint8_t *code,
                                                              const struct glint_vec *normal,
                                                              struct glint_sample *sample, unsigned count)
{
    const struct glint_sample *end = sample + count;
    for (; sample != end; sample++, code++) {
        g->n_across = glint_shininess_n(*code);
        if (normal)
            grain_sample(g, NULL, GRAIN_UNIT, normal++, sample);
        else
            sample->f_q16 = sample->t_q30 > GLINT_T_ONE ? UINT32_MAX : g->n_across * grain_t(g, sample->t_q30);
    }
}

static inline __attribute__((always_inline)) void
grain_samples(const struct glint_paint *paint, const struct glint_lines *lines, const struct glint_span *span,
              const struct glint_view *view, const struct glint_vec *normals, struct glint_sample *samples,
              unsigned from, unsigned count, bool is_sine)
{
    const struct glint_maps *const maps = lines->maps;
    const struct glint_run *const run = &lines->run;
    const uint32_t x = run->x + from, line = run->y - lines->target->y;
    struct grain_run g;
    grain_run_set(&g, paint, &view->l, &view->h, is_sine);
    if (maps && maps->shininess) {
        g.more = 0;
        grain_shiny(&g, maps->shininess + maps->shininess_stride * (ptrdiff_t)line + x, normals, samples, count);
    } else if (span || (!maps->grain && maps->grain_kind == GLINT_GRAIN_BRUSHED)) {
        struct grain_way way;
        grain_way_set(&way, lines->grain[0], lines->grain[1], &view->h);
        if (span)
            grain_walk(&g, &way, span, x, lines->w, samples, count);
        else
            grain_one_way(&g, &way, normals, samples, count);
    } else if (maps->grain) {
        grain_by_map(&g, maps->grain + maps->grain_stride * (ptrdiff_t)line + x, normals, samples, count);
    } else {
        grain_by_place(&g, maps->grain_kind == GLINT_GRAIN_SPUN, 16 * (int32_t)(run->left + x) + 8 - maps->grain_at[0],
                       maps->grain_at[1] - 16 * (int32_t)run->y - 8, normals, samples, count);
    }
}

void glint_grain_sample(const struct glint_paint *paint, const struct glint_lines *lines, const struct glint_span *span,
                        const struct glint_view *view, const struct glint_vec *normals, struct glint_sample *samples,
                        unsigned from, unsigned count)
{
    grain_samples(paint, lines, span, view, normals, samples, from, count, false);
}

void glint_grain_sample_sine(const struct glint_paint *paint, const struct glint_lines *lines,
                             const struct glint_span *span, const struct glint_view *view,
                             const struct glint_vec *normals, struct glint_sample *samples, unsigned from,
                             unsigned count)
{
    grain_samples(paint, lines, span, view, normals, samples, from, count, true);
}

/* ---- Rows of meshes ---- */

static __attribute__((noinline)) void grain_row_samples(const struct glint_paint *paint, const struct grain_way *way,
                                                        const struct glint_vec *normal, struct glint_sample *sample,
                                                        unsigned count)
{
    struct grain_run g;
    grain_run_set(&g, paint, &paint->l, &paint->h, GLINT_FLASH_U8(paint->model->model) == GLINT_GGX);
    for (const struct glint_sample *end = sample + count; sample != end; sample++, normal++)
        grain_sample(&g, way, GRAIN_AXIS, normal, sample);
}

/* An axis, turned, as normals are. */
static void grain_axis(struct grain_way *way, const int16_t axis[3], int16_t turn[3][3], const struct glint_vec *h)
{
    int32_t u[3];
    for (unsigned k = 0; k < 3; k++)
        u[k] = glint_mesh_turned(turn[k], axis[0], axis[1], axis[2]);
    way->x = u[0], way->y = u[1], way->z = u[2];
    way->h = h->x * u[0] + h->y * u[1] + h->z * u[2];
}

static void grain_row(const struct glint_paint *paint, const struct glint_run *run, const int16_t axis[3],
                      int16_t turn[3][3], const struct glint_vec *normals, struct glint_sample *samples, unsigned count)
{
    struct grain_way way;
    grain_axis(&way, axis, turn, &paint->h);
    grain_row_samples(paint, &way, normals, samples, count);
    GLINT_FLASH_POINTER(GLINT_FLASH_POINTER(paint->model->grain)->run)(paint, samples, count);
    uint32_t open = glint_run_levels(paint, run, samples, count);
    for (unsigned i = 0; open; i++, open >>= 1) {
        uint32_t f = 0;
        if (!(open & 1))
            continue;
        if (samples[i].f_q16) {
            grain_row_samples(paint, &way, normals + i, samples + i, 1);
            f = glint_grain_f(paint, samples[i].f_q16, samples[i].t_q30);
        }
        glint_paint_sums(paint, run, i, samples[i].nl_q16, f);
    }
}

const struct glint_use_axis glint_use_mesh_grain GLINT_FLASH = {grain_row};

/* ---- Lines ---- */

void glint_grain_begin(struct glint_lines *lines)
{
    const struct glint_maps *maps = lines->maps;
    int32_t u[3] = {maps ? maps->grain_at[0] : 0, maps ? maps->grain_at[1] : 0, 0};
    struct glint_vec unit = {32767, 0, 0};
    struct glint_unit near;
    if ((u[0] | u[1]) && !(glint_unit_near(&near, u) && glint_vec_of_q30(&unit, near.unit_q30, GLINT_UNIT_SLACK))) {
        (void)glint_unit_q30(u, u);
        (void)glint_vec_of_q30(&unit, u, 0);
    }
    lines->grain[0] = unit.x;
    lines->grain[1] = unit.y;
}

uint32_t glint_grain_f(const struct glint_paint *paint, uint32_t m, uint32_t t)
{
    const struct glint_use_grain *use = GLINT_FLASH_POINTER(paint->model->grain);
    if (t > GLINT_T_ONE || m > GLINT_GRAIN_MOST ||
        !GLINT_FLASH_POINTER(use->reaches)(m, t, glint_clamp_q(paint->material.q)))
        return 0;
    const uint32_t f = GLINT_FLASH_POINTER(use->exact)(m, t);
    return f < paint->of.exact.f_max ? f : paint->of.exact.f_max;
}

enum { GRAIN_RUN = 14 }; /* what the stack allows */

/* m of count of the run's samples, from pixel `from` of it on; span: whose t and N.L are there, or NULL. */
static __attribute__((noinline)) void grain_source(const struct glint_paint *paint, const struct glint_lines *lines,
                                                   const struct glint_span *span, struct glint_sample *samples,
                                                   unsigned from, unsigned count)
{
    const struct glint_use_grain *use = GLINT_FLASH_POINTER(paint->model->grain);
    struct glint_vec unpacked[GRAIN_RUN];
    struct glint_view view;
    view.l.x = paint->l.x, view.l.y = paint->l.y, view.l.z = paint->l.z;
    view.h.x = paint->h.x, view.h.y = paint->h.y, view.h.z = paint->h.z;
    const struct glint_vec *normals = span ? NULL : glint_lines_normals(lines, unpacked) + from;
    GLINT_FLASH_POINTER(use->sample)(paint, lines, span, &view, normals, samples, from, count);
}

uint32_t glint_grain_exactly(const struct glint_paint *paint, const struct glint_lines *lines,
                             const struct glint_span *span, struct glint_sample *sample, unsigned at)
{
    uint32_t f = 0;
    if (sample->f_q16) {
        grain_source(paint, lines, span, sample, at, 1);
        f = glint_grain_f(paint, sample->f_q16, sample->t_q30);
    }
    glint_paint_sums(paint, &lines->run, at, sample->nl_q16, f);
    return f;
}

/* Draws the run's pixels, at most GRAIN_RUN. bounds: what shines goes there, or NULL. */
static __attribute__((noinline)) void grain_pixels(const struct glint_paint *paint, struct glint_lines *lines,
                                                   struct glint_span *at, struct glint_bounds *bounds, uint32_t y)
{
    struct glint_sample samples[GRAIN_RUN];
    struct glint_run *const run = &lines->run;
    const unsigned count = lines->count;
    if (at)
        glint_lines_walk(paint, lines, at, samples);
    grain_source(paint, lines, at, samples, 0, count);
    GLINT_FLASH_POINTER(GLINT_FLASH_POINTER(paint->model->grain)->run)(paint, samples, count);
    for (unsigned i = 0; bounds && i < count; i++) /* before gloss is drawn over */
        if (samples[i].f_q16 && (!run->gloss || run->gloss[i]))
            glint_bounds_add(bounds, run->x + i, y);
    uint32_t open = glint_run_levels(paint, run, samples, count);
    for (unsigned i = 0; open; i++, open >>= 1)
        if (open & 1)
            (void)glint_grain_exactly(paint, lines, at, samples + i, i);
}

#if GLINT_CORTEX_M0PLUS_ASM && GLINT_FUSED /* the one loop that asks for it */
void glint_grain_edge(const struct glint_paint *paint, struct glint_lines *lines, struct glint_bounds *bounds,
                      unsigned count, uint32_t y)
{
    for (; count; count -= lines->count, lines->run.x += lines->count) {
        lines->count = (uint16_t)(count < GRAIN_RUN ? count : (unsigned)GRAIN_RUN);
        grain_pixels(paint, lines, NULL, bounds, y);
    }
}
#endif

void glint_grain_draw(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                      struct glint_box *highlight)
{
    struct glint_bounds bounds;
    glint_bounds_begin(&bounds);
    lines->most = GRAIN_RUN;
    glint_grain_begin(lines);
    for (uint32_t y = 0; y < h; y++)
        for (glint_lines_set(lines, y); glint_lines_next(lines); lines->run.x += lines->count)
            grain_pixels(paint, lines, at, highlight ? &bounds : NULL, y);
    glint_bounds_box(&bounds, highlight);
}

static __attribute__((noinline)) enum glint_err grain_check_maps(const struct glint_maps *maps, uint32_t w, uint32_t h,
                                                                 bool normals, uint32_t across)
{
    const bool turns = maps->grain || maps->grain_kind != GLINT_GRAIN_BRUSHED;
    for (unsigned k = 0; k < 2; k++)
        if (turns && !maps->grain && (maps->grain_at[k] > GLINT_LIGHT_FAR || maps->grain_at[k] < -GLINT_LIGHT_FAR))
            return GLINT_ERR_ARG;
    if ((h > 1 && maps->grain && !glint_stride_fits(maps->grain_stride, w)) || maps->grain_kind > GLINT_GRAIN_SUNRAY ||
        (turns && !normals) || (maps->shininess && (maps->grain || across)))
        return GLINT_ERR_ARG;
    return GLINT_OK;
}

enum glint_err glint_grain_check(const struct glint_paint *paint, struct glint_lines *lines, uint32_t h, bool normals)
{
    const struct glint_maps *const maps = lines->maps;
    const uint32_t across = glint_material_across(&paint->material);
    if (across || (maps && maps->shininess))
        lines->draw = GLINT_FLASH_POINTER(GLINT_FLASH_POINTER(paint->model->grain)->draw);
    if (maps && (across || maps->shininess || maps->grain))
        return grain_check_maps(maps, lines->w, h, normals, across);
    return GLINT_OK;
}

/* ---- Under several lights: what takes the place of a model's geometry and of its F ---- */

static const struct glint_use_grain *grained_use(const struct glint_lights *lights)
{
    return GLINT_FLASH_POINTER(lights->paint->model->grain);
}

/* Steps 1, 2 and 2a of the view at hand; l is the view's. */
static void grained_geometry(const struct glint_vec *l, const struct glint_vec *v, const struct glint_vec *h,
                             const struct glint_vec *normals, struct glint_sample *samples, unsigned count)
{
    const struct glint_lights *lights =
        (const struct glint_lights *)(const void *)((const uint8_t *)l - offsetof(struct glint_lights, view.l));
    (void)v;
    (void)h;
    GLINT_FLASH_POINTER(grained_use(lights)->sample)
    (lights->paint, lights->grained, NULL, &lights->view, normals, samples, (unsigned)(normals - lights->normals),
     count);
}

/* Step 3: f_q16, which is m. A t that shines is below every cutoff's. */
static void grained_shade(const struct glint_lights *lights, struct glint_sample *sample, unsigned count, bool exact)
{
    const struct glint_use_grain *grain = grained_use(lights);
    if (exact)
        sample->f_q16 = GLINT_FLASH_POINTER(grain->f)(lights->paint, sample->f_q16, sample->t_q30);
    else
        GLINT_FLASH_POINTER(grain->run)(lights->paint, sample, count);
    for (; count--; sample++)
        sample->t_q30 = sample->f_q16 ? 0 : UINT32_MAX;
}

void glint_grain_light(struct glint_lights *lights, struct glint_lines *lines)
{
    if (!glint_grain_is_drawn(lights->paint, lines->maps))
        return;
    lights->grained = lines;
    lights->geometry = grained_geometry;
    lights->shade = grained_shade;
    glint_grain_begin(lines);
}
