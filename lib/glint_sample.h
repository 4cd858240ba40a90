/* SPDX-License-Identifier: MIT
 * Internal. What a pixel knows, and the sources that make it: rectangles of normals, spans, rows of triangles. */
#ifndef GLINT_SAMPLE_H
#define GLINT_SAMPLE_H

#include "glint.h"

#define GLINT_RUN 20u /* samples at most: pixels side by side that are drawn together; what the stack allows */

/* For the exact paint. */
struct glint_sample {
    uint32_t t_q30;  /* any; F is 0 from the paint's t_end on. UINT32_MAX where nl_q16 is 0 */
    uint32_t nl_q16; /* step 2 */
    uint32_t f_q16;  /* the model's loop fills it: step 3, or a little less */
};

/* For tables, as their sequence has it: modulo 2^32. */
struct glint_raw {
    uint32_t back;  /* how far t is before the last column: t_max - t; as an int32_t below 0: beyond it */
    int32_t nl_q30; /* below 0: dark */
};
#define GLINT_RAW_OUTSIDE UINT32_MAX
#define GLINT_RAW_NOTHING INT32_MIN                /* as nl: no surface, the pixel stays */
static inline int32_t glint_raw_nl(int32_t nl_q30) /* all that are dark are -1 */
{
    return nl_q30 | nl_q30 >> 31;
}
static inline bool glint_raw_shines(const struct glint_raw *raw)
{
    return (int32_t)raw->back >= 0 && raw->nl_q30 >= 0;
}

/* The light of a pixel. Components are of length 1, so that |x| + |y| + |z| < 2^16 and N.L fits 32 bits. */
struct glint_view {
    struct glint_vec l, v, h;
};

/* A span's t this large stands for one a little below 0, where rounding has led: 0 is meant. */
#define GLINT_NEGATIVE_T UINT32_C(0xf8000000)

/* A paint of zeros or one that was never lit is not. NULL: neither. */
static inline __attribute__((always_inline)) bool glint_paint_is_lit(const struct glint_paint *paint)
{
    return paint && (paint->format || paint->of.tables.filled.use) && paint->light_count != 255;
}

/* Step 2: nl_q30 of 32 bits. */
static inline uint32_t glint_sample_nl(int32_t nl_q30)
{
    const int32_t nl = ((nl_q30 >> 13) + 1) >> 1; /* (nl_q30 + 2^13) >> 14, which might overflow */
    return nl < 0 ? 0 : nl > 65536 ? 65536 : (uint32_t)nl;
}

/* Steps 1 and 2 for count >= 1 normals, by the half vector or as Phong has it. */
typedef void glint_geometry(const struct glint_vec *l, const struct glint_vec *v, const struct glint_vec *h,
                            const struct glint_vec *normals, struct glint_sample *samples, unsigned count);
glint_geometry glint_samples_half, glint_samples_phong;

/* The next count >= 1 samples of a span, which goes on. */
void glint_samples_walk(struct glint_span *at, struct glint_sample *samples, unsigned count);
void glint_raws_walk(struct glint_span *at, uint32_t t_max_q30, struct glint_raw *raws, unsigned count);
/* A span from its pixel n on. */
void glint_span_skip(struct glint_span *at, uint32_t n);

/* Of a span's t and nl. */
static inline struct glint_raw glint_raw_at(uint32_t t_q30, int32_t nl_q30, uint32_t t_max_q30)
{
    const uint32_t t = t_q30 >= GLINT_NEGATIVE_T ? 0 : t_q30;
    const struct glint_raw raw = {t > t_max_q30 ? GLINT_RAW_OUTSIDE : t_max_q30 - t, glint_raw_nl(nl_q30)};
    return raw;
}

/* Of a normal, modulo 2^32: right for unit normals (t <= 2, |nl| < 1 + 2^-14), harmless for others. */
static inline struct glint_raw glint_raw_of(const struct glint_vec *n, const struct glint_vec *l,
                                            const struct glint_vec *h, uint32_t t_max_q30)
{
    struct glint_raw raw = {GLINT_RAW_OUTSIDE, GLINT_RAW_NOTHING};
    const int32_t nx = n->x, ny = n->y, nz = n->z;
    if (nx | ny | nz) {
        const uint32_t x = (uint32_t)(nx - h->x), y = (uint32_t)(ny - h->y), z = (uint32_t)(nz - h->z);
        raw.back = t_max_q30 - ((x * x + y * y + z * z) >> 1); /* t < 2^31 */
        raw.nl_q30 = glint_raw_nl((int32_t)((uint32_t)(nx * l->x) + (uint32_t)(ny * l->y) + (uint32_t)(nz * l->z)));
    }
    return raw;
}

/* Is a stride at least a line's bytes? */
static inline bool glint_stride_fits(ptrdiff_t stride, uint32_t bytes)
{
    return (stride < 0 ? 0 - (size_t)stride : (size_t)stride) >= bytes;
}

/* Bytes of a normal. */
static inline size_t glint_normals_size(uint8_t format)
{
    return format == GLINT_NORMALS_INT16 ? sizeof(struct glint_vec) : 4;
}

/* A word of INT8 as a normal. */
static inline struct glint_vec glint_int8_normal(uint32_t word)
{
    /* the low half is 256 y + x */
    const struct glint_vec n = {(int16_t)((int8_t)word * 256), (int16_t)((int32_t)(int16_t)word - (int8_t)word),
                                (int16_t)(word >> 16)};
    return n;
}

/* From a word of INT8 without surface on: how many pixels are to be stepped over, 1..left. */
static inline uint32_t glint_gap(uint32_t word, uint32_t left)
{
    const uint32_t count = word & 0xffff;
    return count < 1 ? 1 : count < left ? count : left;
}

#endif
