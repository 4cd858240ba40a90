/* SPDX-License-Identifier: MIT
 * Paints of tables: made, and any source drawn with them. */
#include "glint_tables.h"
#include "glint_math.h"

size_t glint_tables_bytes(enum glint_tables_kind kind, bool dither)
{
    return kind == GLINT_TABLES_COLOUR              ? dither ? GLINT_TABLES_DITHER_BYTES : GLINT_TABLES_COLOUR_BYTES
           : kind == GLINT_TABLES_ALBEDO && !dither ? GLINT_TABLES_ALBEDO_BYTES
                                                    : 0;
}

/* ---- Made ---- */

enum glint_err glint_paint_tables_for(struct glint_paint *paint, const struct glint_use_tables *kind,
                                      const struct glint_material *material, const struct glint_output *output,
                                      void *memory, size_t bytes, const struct glint_use_model *model,
                                      const struct glint_use_format *format)
{
    if (!paint || !kind || !memory || bytes < GLINT_FLASH_U16(kind->bytes) || GLINT_MISALIGNED(memory, 32) || !model ||
        GLINT_FLASH_POINTER(model->geometry)) /* Phong's is not |N - H|^2 */
        return GLINT_ERR_ARG;
    enum glint_err err = glint_paint_check(material, output, false);
    if (!err)
        err = GLINT_FLASH_POINTER(kind->can)(material, output);
    if (!err) /* what fills the tables, in their paint's own place, for the stack */
        err = glint_paint_exact_for(paint, material, output, model, format);
    if (err)
        return err;
    struct glint_tables tables;
    tables.kind = GLINT_FLASH_U8(kind->kind);
    tables.format = output->format;
    tables.dither = output->dither;
    tables.dark = 0;
    tables.n = (uint16_t)paint->of.exact.n;
    tables.use = kind;
    GLINT_FLASH_POINTER(kind->fill)(&tables, paint, memory);
    return glint_paint_tables_filled(paint, &tables, output);
}

enum glint_err glint_paint_tables_filled(struct glint_paint *paint, const struct glint_tables *filled,
                                         const struct glint_output *output)
{
    if (!paint || !filled || !filled->use || !output)
        return GLINT_ERR_ARG;
    if (filled->format != output->format || filled->dither != output->dither || output->space > GLINT_LINEAR)
        return GLINT_ERR_FORMAT;
    paint->of.tables.filled = *filled; /* it may be the paint's own */
    paint->model = NULL;
    paint->format = NULL;
    glint_paint_unlit(paint, output);
    return GLINT_OK;
}

/* ---- Filled: the axes ---- */

enum { COLUMNS_SPARE = 16 };
#define COLUMNS_GAP ((uint32_t)1 << 16) /* how far below 0 t may come, Q2.30, by rounding */

unsigned glint_columns_shift(uint32_t t_max_q30, uint32_t columns)
{
    unsigned s = 0;
    while ((t_max_q30 >> s) + (COLUMNS_GAP >> s) >= columns - COLUMNS_SPARE)
        s++;
    return s;
}

/* By bisection, bit by bit from the top. */
uint32_t glint_last_t(const struct glint_paint *exact, bool (*shows)(const struct glint_paint *exact, uint32_t f))
{
    uint32_t t = 0;
    for (uint32_t bit = (uint32_t)1 << 30; bit; bit >>= 1)
        if ((t | bit) < exact->of.exact.t_end && shows(exact, glint_paint_f(exact, t | bit)))
            t |= bit;
    return t;
}

/* A value is 65535 * 2^32 = 1.0; one < 2^10, so the product is below 2^58. */
uint32_t glint_field_level(const struct glint_paint *exact, struct glint_field field, unsigned k, uint8_t albedo,
                           uint32_t nl_q16, uint32_t f)
{
    const uint64_t value = glint_exact_value(&exact->material, k, albedo * 257u, nl_q16, (uint64_t)65535 * f);
    return (uint32_t)((value * field.one + ((uint64_t)65535 << 31)) >> 32) / 65535;
}

/* ---- Drawn ---- */

enum glint_err glint_tables_check(const struct glint_paint *paint, const struct glint_maps *maps, uint32_t h,
                                  bool normals)
{
    const bool takes_albedo = GLINT_FLASH_U8(paint->of.tables.filled.use->takes_albedo);
    const uint8_t *albedo = maps ? maps->albedo : NULL;
    const bool takes_maps = GLINT_FLASH_POINTER(paint->of.tables.filled.use->shiny) != NULL;
    if (!albedo != !takes_albedo || (maps && (maps->grain || (!takes_maps && (maps->gloss || maps->shininess)))))
        return GLINT_ERR_ARG;
    const uint32_t n = paint->of.tables.filled.n; /* of tables from flash it may be anything */
    if (maps && maps->shininess && (n == 0 || n > GLINT_N_MAX))
        return GLINT_ERR_ARG;
    if (albedo && maps->albedo_format != GLINT_RGB565)
        return GLINT_ERR_FORMAT;
    if (albedo && (GLINT_MISALIGNED(albedo, 16) || (h > 1 && GLINT_MISALIGNED(maps->albedo_stride, 16))))
        return GLINT_ERR_ARG;
    return maps && normals && maps->normals_format == GLINT_NORMALS_INT8 && !paint->of.tables.is_frontal
               ? GLINT_ERR_VECTOR
               : GLINT_OK;
}

/* Alone, for the registers. */
static __attribute__((noinline)) void tables_raws_int16(const struct glint_vec *n, const struct glint_vec *l_of,
                                                        const struct glint_vec *h_of, uint32_t t_max,
                                                        struct glint_raw *raw, unsigned count)
{
    const struct glint_vec l = {l_of->x, l_of->y, l_of->z}, h = {h_of->x, h_of->y, h_of->z}; /* no call of memcpy */
    for (const struct glint_raw *end = raw + count; raw != end; raw++, n++)
        *raw = glint_raw_of(n, &l, &h, t_max);
}

static void tables_unlit(const struct glint_paint *paint, struct glint_raw *raws, unsigned count)
{
    for (unsigned i = 0; paint->light_count == 0 && i < count; i++)
        if (raws[i].nl_q30 != GLINT_RAW_NOTHING)
            raws[i].nl_q30 = -1;
}

/* The raws of a run. */
static void tables_raws(const struct glint_paint *paint, const struct glint_lines *lines, struct glint_span *at,
                        struct glint_raw *raws)
{
    const uint32_t t_max = paint->of.tables.filled.t_max_q30;
    const unsigned count = lines->count;
    if (at) {
        glint_raws_walk(at, t_max, raws, count);
    } else if (lines->maps->normals_format == GLINT_NORMALS_INT8) {
        const uint32_t *words = (const uint32_t *)(const void *)lines->normals + lines->run.x;
        GLINT_FLASH_POINTER(paint->of.tables.filled.use->raws)(paint, words, raws, count);
    } else {
        const struct glint_vec *n = (const struct glint_vec *)(const void *)lines->normals + lines->run.x;
        tables_raws_int16(n, &paint->l, &paint->h, t_max, raws, count);
    }
    tables_unlit(paint, raws, count);
}

/* Of a pixel's own n: F is nearly that of the tables where m = n t is theirs; in models that know n and t by m alone, it is. So t is scaled: m
 * is counted back from what it is at t_max, Q22. */
struct tables_scale {
    uint32_t m_max, inverse; /* n t_max, Q22; 2^31 / n */
};

static inline __attribute__((always_inline)) struct tables_scale tables_scale_of(const struct glint_paint *paint)
{
    const uint32_t n = paint->of.tables.filled.n;
    const struct tables_scale scale = {(paint->of.tables.filled.t_max_q30 >> 8) * n, (((uint32_t)1 << 31) + n / 2) / n};
    return scale;
}

static inline __attribute__((always_inline)) struct glint_raw
tables_scaled(const struct tables_scale *scale, struct glint_raw raw, uint32_t t_q30, uint8_t code)
{
    const uint32_t m = (t_q30 >> 8) * glint_shininess_n(code);
    raw.back = t_q30 > GLINT_T_ONE || m > scale->m_max ? GLINT_RAW_OUTSIDE
                                                       : glint_mulhi_near(scale->m_max - m, scale->inverse) << 9;
    return raw;
}

static inline const uint8_t *tables_codes(const struct glint_lines *lines)
{
    return lines->maps->shininess + lines->maps->shininess_stride * (ptrdiff_t)(lines->run.y - lines->target->y) +
           lines->run.x;
}

/* Alone, for the registers. */
static __attribute__((noinline)) void tables_shiny_rect(const struct glint_paint *paint,
                                                        const struct glint_lines *lines, struct glint_raw *raw)
{
    const struct glint_vec l = {paint->l.x, paint->l.y, paint->l.z}, h = {paint->h.x, paint->h.y, paint->h.z};
    const bool is_int8 = lines->maps->normals_format == GLINT_NORMALS_INT8;
    const unsigned bytes = is_int8 ? 4 : sizeof(struct glint_vec);
    const uint8_t *normal = (const uint8_t *)lines->normals + bytes * lines->run.x;
    const uint8_t *code = tables_codes(lines);
    const struct tables_scale scale = tables_scale_of(paint);
    for (const struct glint_raw *end = raw + lines->count; raw != end; raw++, normal += bytes) {
        const struct glint_vec n = is_int8 ? glint_int8_normal(*(const uint32_t *)(const void *)normal)
                                           : *(const struct glint_vec *)(const void *)normal;
        const struct glint_raw at = glint_raw_of(&n, &l, &h, 0);
        *raw = at.nl_q30 < 0 ? at : tables_scaled(&scale, at, 0 - at.back, *code);
        code++;
    }
}

void glint_tables_shiny(const struct glint_paint *paint, const struct glint_lines *lines, struct glint_span *at,
                        struct glint_raw *raws)
{
    if (at) {
        const uint8_t *const codes = tables_codes(lines);
        const struct tables_scale scale = tables_scale_of(paint);
        glint_raws_walk(at, INT32_MAX, raws, lines->count);
        for (unsigned i = 0; i < lines->count; i++)
            raws[i] = tables_scaled(&scale, raws[i], INT32_MAX - raws[i].back, codes[i]);
    } else {
        tables_shiny_rect(paint, lines, raws);
    }
    tables_unlit(paint, raws, lines->count);
}

static void tables_note(struct glint_bounds *bounds, const struct glint_run *run, const struct glint_raw *raws,
                        unsigned count, uint32_t y)
{
    for (unsigned i = 0; i < count; i++)
        if (glint_raw_shines(&raws[i]))
            glint_bounds_add(bounds, run->x + i, y);
}

/* Draws in runs, or not; their highlight goes to the box, unless that is NULL. What is not drawn is not looked at where the box has it
 * already. Alone, as the fused loops do not need its raws on the stack. */
static __attribute__((noinline)) void tables_runs(const struct glint_paint *paint, struct glint_lines *lines,
                                                  struct glint_span *at, uint32_t h, struct glint_box *highlight,
                                                  bool draws)
{
    struct glint_raw raws[GLINT_RUN];
    struct glint_run *const run = &lines->run;
    const bool shines_its_way = lines->maps && lines->maps->shininess;
    struct glint_bounds bounds;
    uint32_t walked = 0;
    glint_bounds_begin(&bounds);
    lines->most = GLINT_RUN;
    for (uint32_t y = 0; y < h; y++)
        for (glint_lines_set(lines, y); glint_lines_next(lines); run->x += lines->count) {
            if (!draws && bounds.bottom == y && run->x >= bounds.left && run->x + lines->count <= bounds.right + 1u)
                continue;
            if (at && run->x != walked)
                glint_span_skip(at, run->x - walked);
            if (shines_its_way)
                GLINT_FLASH_POINTER(paint->of.tables.filled.use->shiny)(paint, lines, at, raws);
            else
                tables_raws(paint, lines, at, raws);
            walked = run->x + lines->count;
            if (highlight)
                tables_note(&bounds, run, raws, lines->count, y);
            if (draws)
                glint_tables_pixels(paint, run, raws, lines->count);
        }
    glint_bounds_box(&bounds, highlight);
}

/* Draws a line by the kind's fused loops: what is covered side by side at a time. */
static void tables_fused(const struct glint_paint *paint, struct glint_lines *lines, uint32_t y)
{
    struct glint_run *const run = &lines->run;
    lines->most = UINT16_MAX;
    glint_lines_set(lines, y);
    if (!run->coverage) {
        GLINT_FLASH_POINTER(paint->of.tables.filled.use->line)(paint, lines, 0, lines->w);
        return;
    }
    for (; glint_lines_next(lines); run->x += lines->count)
        if (run->soft)
            GLINT_FLASH_POINTER(lines->soft->line)(paint, lines);
        else
            GLINT_FLASH_POINTER(paint->of.tables.filled.use->line)(paint, lines, run->x, run->x + lines->count);
}

void glint_tables_draw(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                       struct glint_box *highlight)
{
    const struct glint_surface *target = lines->target;
    const struct glint_maps *maps = lines->maps;
    const bool apart = maps && (maps->gloss || maps->shininess);
    const bool is_fused = GLINT_FUSED && !at && !apart && paint->light_count > 0 &&
                          !GLINT_MISALIGNED(target->pixels, 16) && (h < 2 || !GLINT_MISALIGNED(target->stride, 16));
    if (!apart) /* where a gap may be taken for a normal */
        lines->has_gaps = false;
    if (!is_fused || highlight)
        tables_runs(paint, lines, at, h, highlight, !is_fused);
    for (uint32_t y = 0; is_fused && y < h; y++)
        tables_fused(paint, lines, y);
}
