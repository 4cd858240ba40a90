/* SPDX-License-Identifier: MIT
 * Loops of C for RISC-V with multiplication: INT8 normals over COLOUR tables, and the exact line of RGB565 under MSH in one loop. There samples, F and
 * levels of a pixel stay in registers, and products' upper halves take the place of shifts. The same integers as sample.c, lobe_msh.c and
 * glint_levels_rgb have, but for 2/5 of the quotient, which is nearer. */
#include "glint_fused.h"

#if GLINT_RISCV
#include "glint_math.h"
#include "glint_offsets.h"
#include "glint_pixel.h"

GLINT_INLINE uint32_t riscv_high(uint32_t a, uint32_t b)
{
    return (uint32_t)((uint64_t)a * b >> 32);
}

/* x 2^s >= 2^27 */
GLINT_INLINE unsigned riscv_up(uint32_t x)
{
#ifdef __riscv_zbb
    return (unsigned)__builtin_clz(x) - 4;
#else
    unsigned s = 0;
    for (; !(x >> 27); s++)
        x <<= 1;
    return s;
#endif
}

GLINT_INLINE uint32_t riscv_least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

/* What is needed in the highlight alone is read there, and not before: else compilers keep it on the stack. */
#define RISCV_READ(field) (((const volatile struct glint_line_loop *)loop)->field)
#define RISCV_RARELY(condition) __builtin_expect(condition, 0)
/* words goes on by four, as the first instruction of a loop: one of 16 bits, as Hazard3 takes a cycle more for a jump to one of 32 bits that is not
 * aligned. */
#ifdef __riscv
#define RISCV_FOUR(words) __asm__ volatile("addi %0, %0, 16" : "+r"(words))
#else
#define RISCV_FOUR(words) ((words) += 4)
#endif
#define RISCV_STEP() __asm__ volatile("" ::: "memory")

/* msh_near: F 2^16, never high, for t < t_end. m = floor(k t / 2^14) + 5 2^(16 + up), as floor(k 2^(18 - b) t 2^b / 2^32). */
GLINT_INLINE uint32_t riscv_msh(const struct glint_line_loop *loop, uint32_t t)
{
    uint32_t m = riscv_high(t << RISCV_READ(up), RISCV_READ(factor)) + RISCV_READ(addend);
    const unsigned s = riscv_up(m);
    m <<= s;
    const uint32_t y = RISCV_READ(reciprocals)[(m >> 21) - 64];
    const int32_t r = (int32_t)(m * y) >> 14;
    const int32_t p = (r * (3 * r - (r * r >> 19)) >> 22) - r;
    const uint32_t b = (((GLINT_T_ONE - t) >> 6) * y >> 8) * y;
    const uint32_t x = b + (uint32_t)((int32_t)(b >> 16) * p >> 4);
    RISCV_STEP();
    const unsigned below = RISCV_READ(below) - 2 * s;
    const uint32_t q = riscv_high(x, RISCV_READ(two_fifths)) - RISCV_READ(high);
    return riscv_least((q + ((uint32_t)1 << below)) >> below >> 1, RISCV_READ(f_max));
}

static uint32_t riscv_draw(struct glint_line_loop *loop, uint32_t x)
{
    static const uint8_t full = 255;
    const unsigned step = loop->mask ? 1 : 0;
    const uint8_t *mask = loop->mask ? loop->mask + x : &full;
    const struct glint_vec *normal = loop->normals + x, *const end = loop->normals + loop->w;
    uint16_t *out = (uint16_t *)(void *)(loop->out + 2 * x);
    const int32_t lx = loop->l[0], ly = loop->l[1], lz = loop->l[2], hx = loop->h[0], hy = loop->h[1], hz = loop->h[2];
    const uint32_t q0 = loop->q[0], q1 = loop->q[1], q2 = loop->q[2], two_t_end = loop->two_t_end;
    const uint32_t most = (uint32_t)31 << GLINT_LINE_SHIFT, most_green = (uint32_t)63 << GLINT_LINE_SHIFT;
    for (; normal != end; normal++, out++, mask += step) {
        if (*mask != 255) {
            if (*mask)
                break;
            continue;
        }
        const int32_t nx = normal->x, ny = normal->y, nz = normal->z;
        const int32_t dot = (((nx * lx + ny * ly + nz * lz) >> 13) + 1) >> 1;
        if (dot <= 0) {
            *out = RISCV_READ(dark);
            continue;
        }
        const uint32_t nl = riscv_least((uint32_t)dot, 65536);
        const int32_t dx = nx - hx, dy = ny - hy, dz = nz - hz;
        const uint32_t xx = (uint32_t)dx * (uint32_t)dx, xy = xx + (uint32_t)dy * (uint32_t)dy;
        const uint32_t zz = (uint32_t)dz * (uint32_t)dz, sum = xy + zz;
        uint32_t red, green, blue;
        if (sum < two_t_end && xy >= xx && sum >= zz) {
            const uint32_t f = riscv_msh(loop, sum >> 1);
            RISCV_STEP();
            red = RISCV_READ(r[0]) * f + q0 * nl;
            green = RISCV_READ(r[1]) * f + q1 * nl;
            blue = RISCV_READ(r[2]) * f + q2 * nl;
            loop->last = (uint8_t *)out;
            if ((uintptr_t)loop->first > (uintptr_t)out)
                loop->first = (uint8_t *)out;
        } else {
            red = q0 * nl;
            green = q1 * nl;
            blue = q2 * nl;
        }
        red = riscv_least(red + RISCV_READ(p[0]), most);
        green = riscv_least(green + RISCV_READ(p[1]), most_green);
        blue = riscv_least(blue + RISCV_READ(p[2]), most);
        const uint32_t limit = RISCV_READ(limit);
        if (red << (32 - GLINT_LINE_SHIFT) >= limit || green << (32 - GLINT_LINE_SHIFT) >= limit ||
            blue << (32 - GLINT_LINE_SHIFT) >= limit)
            break;
        uint32_t pixel = red >> GLINT_LINE_SHIFT << 11 | green >> GLINT_LINE_SHIFT << 5 | blue >> GLINT_LINE_SHIFT;
        if (RISCV_READ(swapped))
            pixel = pixel << 8 | pixel >> 8;
        *out = (uint16_t)pixel;
    }
    return (uint32_t)(normal - loop->normals);
}

bool glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *p, bool albedo)
{
    const uint32_t t_end = p->of.exact.t_end;
    const int32_t factor = p->of.exact.k[GLINT_MSH_FACTOR];
    if (albedo || p->model->model != GLINT_MSH || p->of.exact.shift != GLINT_LINE_SHIFT || p->output.dither ||
        factor <= 0 || t_end >> 13 == 0)
        return false;
    loop->l[0] = p->l.x, loop->l[1] = p->l.y, loop->l[2] = p->l.z;
    loop->h[0] = p->h.x, loop->h[1] = p->h.y, loop->h[2] = p->h.z;
    for (int k = 0; k < 3; k++) {
        loop->p[k] = p->of.exact.p[k];
        loop->q[k] = p->of.exact.q[k];
        loop->r[k] = p->of.exact.r[k];
    }
    loop->limit = 0 - (p->of.exact.w << (32 - GLINT_LINE_SHIFT));
    loop->two_t_end = 2 * t_end;
    loop->up = 0; /* k t < 2^42, so that one of both has room for each bit */
    while (loop->up < 18 && t_end >> (31 - loop->up) == 0)
        loop->up++;
    loop->factor = (uint32_t)factor << (18 - loop->up);
    loop->addend = (uint32_t)p->of.exact.k[GLINT_MSH_ADDEND];
    loop->below = (uint32_t)p->of.exact.k[GLINT_MSH_SHIFT] - 1;
    loop->two_fifths = UINT32_C(1717986918); /* low by less than 1 of the quotient */
    loop->high = GLINT_MSH_HIGH;
    loop->reciprocals = glint_reciprocals;
    loop->f_max = p->of.exact.f_max;
    loop->swapped = p->output.format == GLINT_RGB565_SWAPPED;
    loop->draw = riscv_draw;
    return true;
}

/* ---- INT8 over COLOUR ---- */

/* What lies side by side is mostly of one kind, so that each has a loop without branches that are taken. From far on, d alone says that no
 * highlight is there: z 2^14 < 2^29. A loop leaves at a pixel of another kind. */
enum riscv_kind { RISCV_DARK, RISCV_FAR, RISCV_MATT, RISCV_GLOSSY };
struct riscv_int8 {
    const uint8_t *columns, *colours;
    int32_t x, y, z, cut; /* as glint_colour_d and glint_colour_raw have them */
    uint32_t far, r;
    unsigned a;
    uint16_t dark;
};
typedef int16_t __attribute__((may_alias)) riscv_half; /* a load each takes less than a load and two shifts */
typedef int8_t __attribute__((may_alias)) riscv_byte;

GLINT_INLINE uint32_t riscv_row(uint32_t d)
{
    return d >> (GLINT_COLOUR_ROW_SHIFT - 1) << GLINT_COLOUR_ROW_BYTES_LOG;
}

GLINT_INLINE uint16_t riscv_colour(const struct riscv_int8 *look, uint32_t row, uint32_t column)
{
    return *(const uint16_t *)(const void *)(look->colours + row + column);
}

struct riscv_normal {
    int32_t z;
    uint32_t d;
};

GLINT_INLINE struct riscv_normal riscv_normal_at(const struct riscv_int8 *look, const uint32_t *word)
{
    const riscv_half *half = (const riscv_half *)word;
    const int32_t y = half[0], z = half[1], x = *(const riscv_byte *)word;
    const struct riscv_normal at = {z, (uint32_t)(y * look->y) + (uint32_t)(x * look->x) + (uint32_t)(z * look->z)};
    return at;
}

/* |e| < 2^31 where d >= 0 */
GLINT_INLINE int32_t riscv_e(const struct riscv_int8 *look, struct riscv_normal at)
{
    return (int32_t)(at.d + ((uint32_t)at.z << 14) - (uint32_t)look->cut);
}

GLINT_INLINE uint32_t riscv_column(const struct riscv_int8 *look, int32_t e)
{
    return look->columns[(((uint32_t)e >> look->a) * look->r) >> (32 - GLINT_COLOUR_COLUMNS_LOG)];
}

/* Draws a pixel of this kind; false where it is of another. */
GLINT_INLINE bool riscv_pixel(const struct riscv_int8 *look, struct riscv_normal at, uint16_t *out,
                              enum riscv_kind kind)
{
    const int32_t e = riscv_e(look, at);
    uint32_t row = riscv_row(at.d), column = 0;
    if (RISCV_RARELY(at.z == 0) || (kind == RISCV_DARK  ? RISCV_RARELY((int32_t)at.d >= 0)
                                    : kind == RISCV_FAR ? RISCV_RARELY(at.d >= look->far)
                                                        : RISCV_RARELY((int32_t)at.d < (int32_t)look->far) ||
                                                              RISCV_RARELY((e < 0) != (kind == RISCV_MATT))))
        return false;
    if (kind == RISCV_GLOSSY) {
        column = riscv_column(look, e);
        __asm__ volatile("" : "+r"(row) : : "memory"); /* its place while the column is being loaded */
    }
    *out = kind == RISCV_DARK ? look->dark : riscv_colour(look, row, column);
    return true;
}

/* On from a pixel of this kind, four at a time. */
#define RISCV_PIXEL(kind, k)                                                                                           \
    at = riscv_normal_at(&look, words - 4 + (k));                                                                      \
    if (!riscv_pixel(&look, at, out + (k), kind)) {                                                                    \
        words -= 4 - (k);                                                                                              \
        out += (k);                                                                                                    \
        goto another;                                                                                                  \
    }
#define RISCV_LOOP(kind)                                                                                               \
    while (out < last) {                                                                                               \
        RISCV_FOUR(words);                                                                                             \
        RISCV_PIXEL(kind, 0)                                                                                           \
        RISCV_PIXEL(kind, 1)                                                                                           \
        RISCV_PIXEL(kind, 2)                                                                                           \
        RISCV_PIXEL(kind, 3)                                                                                           \
        out += 4;                                                                                                      \
    }

void glint_colour_int8(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out)
{
    const struct glint_tables *const tables = &paint->of.tables.filled;
    const int32_t cut = paint->of.tables.cut;
    const struct riscv_int8 look = {tables->columns,
                                    (const uint8_t *)tables->colour.colours,
                                    paint->of.tables.x,
                                    paint->of.tables.y,
                                    paint->of.tables.z,
                                    cut,
                                    cut < (1 << 29) ? 0 : (uint32_t)cut - (1 << 29),
                                    paint->of.tables.r,
                                    paint->of.tables.a,
                                    tables->dark};
    const uint16_t *const end = out + w, *const last = w > 3 ? end - 3 : out; /* from here on there are no four */
    while (out != end) {
        struct riscv_normal at = riscv_normal_at(&look, words);
    another:
        if (at.z == 0) {
            const uint32_t gap = glint_gap(*words, (uint32_t)(end - out));
            words += gap;
            out += gap;
            continue;
        }
        words++;
        out++;
        if ((int32_t)at.d < 0) {
            out[-1] = look.dark;
            RISCV_LOOP(RISCV_DARK)
        } else if (at.d < look.far) {
            out[-1] = riscv_colour(&look, riscv_row(at.d), 0);
            RISCV_LOOP(RISCV_FAR)
        } else {
            const int32_t e = riscv_e(&look, at);
            if (e < 0) {
                out[-1] = riscv_colour(&look, riscv_row(at.d), 0);
                RISCV_LOOP(RISCV_MATT)
            } else {
                out[-1] = riscv_colour(&look, riscv_row(at.d), riscv_column(&look, e));
                RISCV_LOOP(RISCV_GLOSSY)
            }
        }
    }
}
#endif
