/* SPDX-License-Identifier: MIT
 * Internal. Tables: how they are filled, looked up, and drawn with. */
#ifndef GLINT_TABLES_H
#define GLINT_TABLES_H

#include "glint_draw.h"
#include "glint_offsets.h"

/* A kind of tables. */
struct glint_use_tables {
    uint8_t kind; /* enum glint_tables_kind */
    bool dither;
    bool takes_albedo; /* needs it, in RGB565 */
    uint16_t bytes;
    /* May they be filled for this material and output? GLINT_OK, GLINT_ERR_ARG or GLINT_ERR_FORMAT. */
    enum glint_err (*can)(const struct glint_material *material, const struct glint_output *output);
    /* Fills, by an exact paint. */
    void (*fill)(struct glint_tables *tables, const struct glint_paint *exact, void *memory);
    /* Sets of.tables' numbers for INT8 from l and v. */
    void (*light)(struct glint_paint *paint);
    /* May these maps be drawn? */
    enum glint_err (*check)(const struct glint_paint *paint, const struct glint_maps *maps, uint32_t h, bool normals);
    /* Draws a source: *at, unless NULL, is a span that walks along. */
    glint_draw_lines *draw;
    /* The raws of a run with a map of shininess, and pixels as below with one of gloss; or NULL: it takes no such maps. */
    void (*shiny)(const struct glint_paint *paint, const struct glint_lines *lines, struct glint_span *at,
                  struct glint_raw *raws);
    void (*glossy)(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raws,
                   unsigned count);
    /* The general way: count raws of INT8 words; count pixels of a run from raws, at any address. */
    void (*raws)(const struct glint_paint *paint, const uint32_t *words, struct glint_raw *raws, unsigned count);
    void (*pixels)(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raws,
                   unsigned count);
    /* Fused, behind GLINT_FUSED: pixels x..end - 1 of a line of normals, and a span's, or NULL; these are aligned, and the paint has a light. */
    void (*line)(const struct glint_paint *paint, const struct glint_lines *lines, uint32_t x, uint32_t end);
    void (*span)(const struct glint_paint *paint, const struct glint_span *span, const struct glint_surface *target);
};

enum glint_err glint_tables_check(const struct glint_paint *paint, const struct glint_maps *maps, uint32_t h,
                                  bool normals);
void glint_tables_draw(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at, uint32_t h,
                       struct glint_box *highlight);
/* Of kinds that take maps of gloss and shininess: raws with one of shininess. */
void glint_tables_shiny(const struct glint_paint *paint, const struct glint_lines *lines, struct glint_span *at,
                        struct glint_raw *raws);

/* The general way, not blended. */
static inline void glint_tables_plainly(const struct glint_paint *paint, const struct glint_run *run,
                                        const struct glint_raw *raws, unsigned count)
{
    const struct glint_use_tables *const use = paint->of.tables.filled.use;
    if (run->gloss)
        GLINT_FLASH_POINTER(use->glossy)(paint, run, raws, count);
    else
        GLINT_FLASH_POINTER(use->pixels)(paint, run, raws, count);
}

/* The general way, blended where the run is. */
static inline void glint_tables_pixels(const struct glint_paint *paint, const struct glint_run *run,
                                       const struct glint_raw *raws, unsigned count)
{
    if (run->soft)
        GLINT_FLASH_POINTER(run->soft->blend_pixels)(run, paint, raws, count);
    else
        glint_tables_plainly(paint, run, raws, count);
}

/* Does a pixel in the format's order differ from this machine's? */
static inline bool glint_is_swapped(const struct glint_tables *tables)
{
    const uint16_t one = 1;
    const bool low_first = *(const uint8_t *)&one == 1;
    return (tables->format == GLINT_RGB565_SWAPPED) == low_first;
}

static inline void glint_put_pixel(uint8_t *out, uint16_t pixel)
{
    out[0] = ((const uint8_t *)&pixel)[0];
    out[1] = ((const uint8_t *)&pixel)[1];
}

/* The fields of both halves of a word side by side, as a pixel of RGB565. */
static inline uint16_t glint_packed(uint32_t word, bool swapped)
{
    const uint32_t rgb = word | word >> 16;
    return (uint16_t)(swapped ? rgb << 8 | (rgb >> 8 & 255) : rgb);
}

/* RGB565, p over q, by a part m of 255: of each level v = m p + (255 - m) q + 128, (v + (v >> 8)) >> 8. Red and blue lie side by side, green apart. */
static inline uint16_t glint_over(uint32_t p, uint32_t q, uint32_t m)
{
    const uint32_t fields = 0x001f001f, both_p = (p | p << 5) & fields, both_q = (q | q << 5) & fields;
    const uint32_t green_p = p >> 5 & 63, green_q = q >> 5 & 63;
    uint32_t both = m * (both_p - both_q) - both_q + (both_q << 8) + 0x00800080, /* a field is below 32 2^8 */
        green = m * (green_p - green_q) - green_q + (green_q << 8) + 128;
    both = (both + (both >> 8 & fields)) >> 8 & fields;
    green = (green + (green >> 8)) >> 8;
    return (uint16_t)(both | both >> 5 | green << 5);
}

/* How much of a highlight a pixel has, of 256; all of it where there is no map of gloss. */
#define GLINT_NO_GLOSS (-1)
static inline int32_t glint_gloss_part(uint8_t gloss)
{
    return gloss + (gloss >> 7);
}

/* ---- The axes: t, F and nl, and what value each interval stands for ---- */

/* Columns over t = 0..t_max, the one of t_max first: a power of two of t each, some to spare at the peak. The least shift
 * for which so many columns hold them, and the middle of column i. */
unsigned glint_columns_shift(uint32_t t_max_q30, uint32_t columns);
static inline uint32_t glint_column_t(uint32_t t_max_q30, unsigned shift, uint32_t i)
{
    const uint64_t back = ((uint64_t)i << shift) + ((uint32_t)1 << shift >> 1);
    return back < t_max_q30 ? t_max_q30 - (uint32_t)back : 0;
}

/* The largest t, up to the cutoff, whose F shows: F falls as t grows, so what shows no more does not come back. */
uint32_t glint_last_t(const struct glint_paint *exact, bool (*shows)(const struct glint_paint *exact, uint32_t f));

/* Where a channel lies in a word, and what 1.0 is there; the guard bit is the one above its top bit: set by a sum that overflows. */
struct glint_field {
    uint16_t at, one;
};
/* Channel k's value for albedo, nl and F as a field's level, nearest. */
uint32_t glint_field_level(const struct glint_paint *exact, struct glint_field field, unsigned k, uint8_t albedo,
                           uint32_t nl_q16, uint32_t f);

/* ---- COLOUR ---- */

/* Tables and limits in registers: the output may alias the structs as far as compilers know. */
struct glint_look {
    const uint8_t *columns;
    const uint8_t *colours;
    uint32_t t_max, limit; /* limit: see glint_look_store */
    unsigned shift;
    uint16_t dark;
};

static inline struct glint_look glint_look_up(const struct glint_tables *tables)
{
    const struct glint_look look = {tables->columns,   (const uint8_t *)tables->colour.colours,
                                    tables->t_max_q30, tables->t_max_q30 - GLINT_NEGATIVE_T,
                                    tables->shift,     tables->dark};
    return look;
}

/* at: in bytes, as the columns are. */
static inline uint16_t glint_look_colour(const struct glint_look *look, uint32_t at)
{
    return *(const uint16_t *)(const void *)(look->colours + at);
}

static inline uint32_t glint_look_row(uint32_t nl)
{
    return nl >> GLINT_COLOUR_ROW_SHIFT << GLINT_COLOUR_ROW_BYTES_LOG;
}

/* The pixel of a raw that has a surface. part: of the highlight, or GLINT_NO_GLOSS. */
static inline uint16_t glint_look_pixel(const struct glint_look *look, const struct glint_raw *raw, int32_t part)
{
    if (raw->nl_q30 < 0)
        return look->dark;
    uint32_t at = glint_look_row((uint32_t)raw->nl_q30);
    if ((int32_t)raw->back >= 0) {
        const uint32_t column = look->columns[raw->back >> look->shift];
        at += part < 0 ? column : (column * (uint32_t)part + 256) >> 9 << 1;
    }
    return glint_look_colour(look, at);
}

/* A span's pixel. back = t_max - t, modulo 2^32: a t a little below 0 makes it more than t_max, by no more than limit allows. */
static inline void glint_look_store(const struct glint_look *look, uint32_t back, uint32_t nl, uint16_t *out)
{
    if (nl > INT32_MAX) {
        *out = look->dark;
        return;
    }
    uint32_t at = glint_look_row(nl);
    if (back <= look->limit)
        at += look->columns[(back <= look->t_max ? back : look->t_max) >> look->shift];
    *out = glint_look_colour(look, at);
}

/* Sets of.tables' numbers for INT8 over COLOUR, dithered or not. */
void glint_colour_light(struct glint_paint *paint);
enum glint_err glint_colour_can(const struct glint_material *material, const struct glint_output *output);
/* An INT8 normal's d and e (sequence.md), Q29. e is -1 at most where it is beyond the last column. */
static inline int32_t glint_colour_d(const struct glint_paint *paint, uint32_t word)
{
    return (int32_t)((uint32_t)((int8_t)word * paint->of.tables.x) + (uint32_t)((int16_t)word * paint->of.tables.y) +
                     (uint32_t)(((int32_t)word >> 16) * paint->of.tables.z));
}
static inline struct glint_raw glint_colour_raw(const struct glint_paint *paint, uint32_t word, unsigned columns_log)
{
    const int32_t d = glint_colour_d(paint, word);
    const uint32_t e = (uint32_t)d + ((uint32_t)((int32_t)word >> 16) << 14) - (uint32_t)paint->of.tables.cut;
    const struct glint_raw raw = {(int32_t)e < 0 ? GLINT_RAW_OUTSIDE
                                                 : ((e >> paint->of.tables.a) * paint->of.tables.r) >>
                                                       (32 - columns_log) << paint->of.tables.filled.shift,
                                  !(word >> 16) ? GLINT_RAW_NOTHING
                                  : d < 0       ? -1
                                                : (int32_t)((uint32_t)d << 1)};
    return raw;
}

/* ---- COLOUR, dithered ---- */

/* The fields of a sum, 5.4, 6.4 and 5.4 bits: red from bit 23, green from 1, blue from 12. Where a field overflows: bits 21 (blue) and
 * 11 (green), and the carry out of bit 31 (red). */
#define GLINT_DITHER_FIELDS UINT32_C(0xf81f07e0) /* their whole levels; with what is 16 bits above, a pixel */
#define GLINT_DITHER_GUARDS UINT32_C(0x00200800)

/* What a line reads: its parts of the tables, from nl = 0 on. */
struct glint_dither_look {
    const uint8_t *pixels, *sums;
    const uint32_t *shines;
    unsigned shift;
    uint32_t nudge; /* of nl, Q30, so that lines take turns between two rows */
};

/* An odd number of eighths of a row for each y mod 4: 7, 5, 1, 3; the order that leaves least beside the thresholds. */
static inline struct glint_dither_look glint_dither_look_up(const struct glint_tables *tables, uint32_t y)
{
    const uint8_t *const bytes = (const uint8_t *)tables->colour.colours;
    const struct glint_dither_look look = {bytes + (y & 3) * GLINT_DITHER_PIXELS_PART + (1 << GLINT_DITHER_PIXELS_LOG),
                                           bytes + GLINT_DITHER_SUMS + (y & 3) * GLINT_DITHER_SUMS_PART,
                                           (const uint32_t *)(const void *)tables->columns, tables->shift,
                                           (UINT32_C(0x3157) >> (4 * (y & 3)) & 15) << (GLINT_DITHER_ROW_SHIFT - 3)};
    return look;
}

/* row: -1 is dark. phase: 2 (x mod 4). */
static inline uint16_t glint_dither_past(const struct glint_dither_look *look, int32_t row, uint32_t phase)
{
    return *(const uint16_t *)(const void *)(look->pixels + row * (1 << GLINT_DITHER_PIXELS_LOG) + phase);
}

/* A sum whose fields may overflow, each to full. */
static inline uint32_t glint_dither_full(uint32_t sum, bool carry)
{
    const uint32_t over = sum & GLINT_DITHER_GUARDS, full = (over - (over >> 5)) | (over & 2048) >> 6;
    return sum | full | (carry ? UINT32_C(0xf8000000) : 0);
}

/* Within the highlight a pixel is the sum of a word for its row and place on the screen and one for t. */
static inline uint16_t glint_dither_within(const struct glint_dither_look *look, uint32_t row, uint32_t phase,
                                           uint32_t column, int32_t part, bool swapped)
{
    uint32_t shine = look->shines[column];
    if (part >= 0) {
        const uint32_t of = (uint32_t)part;
        shine = ((shine >> 23) * of + 128) >> 8 << 23 | ((shine >> 12 & 511) * of + 128) >> 8 << 12 |
                ((shine >> 1 & 1023) * of + 128) >> 8 << 1;
    }
    uint32_t sum = *(const uint32_t *)(const void *)(look->sums + (row << GLINT_DITHER_SUMS_LOG) + 2 * phase);
    sum += shine;
    if (sum < shine || sum & GLINT_DITHER_GUARDS)
        sum = glint_dither_full(sum, sum < shine);
    return glint_packed(sum & GLINT_DITHER_FIELDS, swapped);
}

/* The pixel of a raw that has a surface. */
static inline uint16_t glint_dither_pixel(const struct glint_dither_look *look, const struct glint_raw *raw,
                                          uint32_t phase, int32_t part, bool swapped)
{
    if (raw->nl_q30 < 0) /* dark: the row before the first */
        return glint_dither_past(look, -1, phase);
    const uint32_t row = ((uint32_t)raw->nl_q30 + look->nudge) >> GLINT_DITHER_ROW_SHIFT;
    return (int32_t)raw->back < 0 ? glint_dither_past(look, (int32_t)row, phase)
                                  : glint_dither_within(look, row, phase, raw->back >> look->shift, part, swapped);
}

/* The phase of the next pixel. */
static inline uint32_t glint_dither_next(uint32_t phase)
{
    return (phase + 2) & 6;
}

/* ---- ALBEDO ---- */

/* Blue, red and green as fields of a word, each with room above it: a product by a level of up to 32 fits, and so does a
 * guard bit. So all three channels are scaled by one multiplication; the highlight is added, field by field, and what overflows into a
 * guard bit is set full. */
#define GLINT_ALBEDO_FIELDS UINT32_C(0x07e0f81f)
#define GLINT_ALBEDO_HALF UINT32_C(0x02008010) /* of 32nds, in each field */

/* In 32nds, how much of the albedo shows at nl_q30 >= 0; all below 0 are tables->dark. Levels lie before the highlights,
 * downwards, so that the assembly has one pointer for both. */
static inline const uint8_t *glint_albedo_level(const struct glint_tables *tables, int32_t number)
{
    return tables->columns - 1 - number;
}

static inline uint32_t glint_albedo_part(uint32_t word, uint32_t level)
{
    return (word * level + GLINT_ALBEDO_HALF) >> 5 & GLINT_ALBEDO_FIELDS;
}
static inline uint32_t glint_albedo_lit(uint16_t albedo, uint32_t level)
{
    return glint_albedo_part((albedo | (uint32_t)albedo << 16) & GLINT_ALBEDO_FIELDS, level);
}

static inline uint32_t
glint_albedo_full(uint32_t sum) /* a field whose guard is set is full; green has 6 bits: its lowest by the >> 6 */
{
    const uint32_t over = sum & ~GLINT_ALBEDO_FIELDS;
    return over ? (sum | (over - (over >> 5)) | over >> 6) & GLINT_ALBEDO_FIELDS : sum;
}

/* The pixel of a raw that has a surface. */
static inline uint16_t glint_albedo_pixel(const struct glint_tables *tables, const struct glint_raw *raw,
                                          uint16_t albedo, int32_t part, bool swapped)
{
    const int32_t nl = raw->nl_q30;
    uint32_t word =
        glint_albedo_lit(albedo, nl < 0 ? tables->dark : *glint_albedo_level(tables, nl >> GLINT_ALBEDO_LEVEL_SHIFT));
    if (glint_raw_shines(raw)) {
        const uint32_t shine = tables->colour.sums[raw->back >> tables->shift];
        word = glint_albedo_full(word + (part < 0 ? shine : glint_albedo_part(shine, ((uint32_t)part + 4) >> 3)));
    }
    return glint_packed(word, swapped);
}

/* ---- Fused loops (fused_tables.c, assembly) ---- */

void glint_colour_int8(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out);
/* As 16-bit numbers, or with their bytes swapped. phase: 2 (x mod 4). */
void glint_dither_int8_plain(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out,
                             uint32_t phase, uint32_t y);
void glint_dither_int8_swapped(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out,
                               uint32_t phase, uint32_t y);
void glint_albedo_int8(const struct glint_paint *paint, const uint32_t *words, const uint16_t *albedo, uint32_t w,
                       uint16_t *out);
void glint_albedo_int8_swapped(const struct glint_paint *paint, const uint32_t *words, const uint16_t *albedo,
                               uint32_t w, uint16_t *out);
void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint16_t *out);
/* glint_use_tables' own. */
void glint_colour_line(const struct glint_paint *paint, const struct glint_lines *lines, uint32_t x, uint32_t end);
void glint_dither_line(const struct glint_paint *paint, const struct glint_lines *lines, uint32_t x, uint32_t end);
void glint_albedo_line(const struct glint_paint *paint, const struct glint_lines *lines, uint32_t x, uint32_t end);
void glint_colour_fused(const struct glint_paint *paint, const struct glint_span *span,
                        const struct glint_surface *target);
void glint_dither_fused(const struct glint_paint *paint, const struct glint_span *span,
                        const struct glint_surface *target);
#if GLINT_FUSED
#define GLINT_TABLES_FUSED(function) function
#else
#define GLINT_TABLES_FUSED(function) NULL
#endif

#endif
