/* SPDX-License-Identifier: MIT
 * A triangle by COLOUR tables, and by ALBEDO tables with a texture or colours of vertices. Its lines are short, so each pixel is asked for its
 * depth and drawn at once; loops take what dark, matt and glossy pixels need and no more. */
#include "glint_mesh_rows.h"
#include "glint_mesh_strip.h"
#include "glint_mesh_texture.h"
#include "glint_tables.h"

#if GLINT_THUMB2
/* The lines of a triangle in one routine: a line's values are set and go on in registers, and a pixel takes 21 instructions, with no highlight in
 * its triangle 14. Offsets are those of the structs. On the stack, in words: columns, colours, dark, t_max, shift - 256; w, the line's depths, what out
 * is beyond them, less 2, and their steps; the left and the right edge, x and steps of both; the triangle, the line after its last one, and how many
 * lines a part has. */
#define COLOUR_AT(type, field, offset) (offsetof(struct type, field) == (offset))
typedef char
    colour_layout[COLOUR_AT(glint_tables, columns, 0) && COLOUR_AT(glint_tables, colour, 4) &&
                          COLOUR_AT(glint_tables, t_max_q30, 8) && COLOUR_AT(glint_tables, dark, 12) &&
                          COLOUR_AT(glint_tables, shift, 16) && COLOUR_AT(glint_mesh_target, surface, 0) &&
                          COLOUR_AT(glint_mesh_target, depth, 4) && COLOUR_AT(glint_mesh_target, w, 8) &&
                          COLOUR_AT(glint_mesh_target, y, 12) && COLOUR_AT(glint_mesh_target, end, 16) &&
                          COLOUR_AT(glint_mesh_triangle, long_edge, 52) && COLOUR_AT(glint_mesh_triangle, upper, 60) &&
                          COLOUR_AT(glint_mesh_triangle, lower, 68) && COLOUR_AT(glint_mesh_triangle, y, 76) &&
                          COLOUR_AT(glint_mesh_triangle, y_middle, 78) && COLOUR_AT(glint_mesh_triangle, y_end, 80) &&
                          COLOUR_AT(glint_mesh_triangle, shine, 82) &&
                          COLOUR_AT(glint_mesh_triangle, long_is_left, 83) && COLOUR_AT(glint_mesh_values, zy, 20) &&
                          COLOUR_AT(glint_mesh_values, zx, 36) && COLOUR_AT(glint_mesh_values, x, 48) &&
                          GLINT_COLOUR_ROW_SHIFT == 24 && GLINT_COLOUR_ROW_BYTES_LOG == 7 && GLINT_NEGATIVE_T_LOG == 27
                      ? 1
                      : -1];
#undef COLOUR_AT

/* A line's first column to r2, the one after its last to r3; the edges go on; the triangle to r1. */
#define COLOUR_COLUMNS                                                                                                 \
    "ldrd r4, r5, [sp, #48]\n\t"                                                                                       \
    "ldrd r6, r7, [sp, #56]\n\t"                                                                                       \
    "ldrd r8, r0, [sp, #20]\n\t"                                                                                       \
    "ldr r1, [sp, #64]\n\t"                                                                                            \
    "usat r2, #16, r4, asr #16\n\t"                                                                                    \
    "asr r3, r5, #16\n\t"                                                                                              \
    "cmp r3, r8\n\t"                                                                                                   \
    "it gt\n\t"                                                                                                        \
    "movgt r3, r8\n\t"                                                                                                 \
    "add r4, r6\n\t"                                                                                                   \
    "add r5, r7\n\t"                                                                                                   \
    "strd r4, r5, [sp, #48]\n\t"

/* A pixel: on to 2 where it is behind. */
#define COLOUR_DEPTH                                                                                                   \
    "ldrh r11, [r0], #2\n\t"                                                                                           \
    "cmp r11, r4, lsr #16\n\t"                                                                                         \
    "bls 2f\n\t"                                                                                                       \
    "lsr r11, r4, #16\n\t"                                                                                             \
    "strh r11, [r0, #-2]\n\t"

#define COLOUR_STEP                                                                                                    \
    "add r4, r8\n\t"                                                                                                   \
    "add r5, r9\n\t"                                                                                                   \
    "sub r6, r7\n\t"                                                                                                   \
    "add r7, r10\n\t"                                                                                                  \
    "subs r2, #256\n\t"                                                                                                \
    "bpl 1b\n\t"

/* To the next line; is there one? */
#define COLOUR_LINE                                                                                                    \
    "ldrd r0, r1, [sp, #24]\n\t"                                                                                       \
    "ldrd r2, r3, [sp, #32]\n\t"                                                                                       \
    "ldr r4, [sp, #72]\n\t"                                                                                            \
    "add r0, r2\n\t"                                                                                                   \
    "add r1, r3\n\t"                                                                                                   \
    "strd r0, r1, [sp, #24]\n\t"                                                                                       \
    "subs r4, #1\n\t"                                                                                                  \
    "str r4, [sp, #72]\n\t"

__attribute__((naked, noinline)) void glint_mesh_colour(__attribute__((unused)) const struct glint_tables *tables,
                                                        __attribute__((unused)) struct glint_mesh_triangle *triangle,
                                                        __attribute__((unused)) const struct glint_mesh_target *target)
{
    __asm__(
        "push {r4, r5, r6, r7, r8, r9, r10, r11, lr}\n\t"
        "sub sp, #76\n\t"
        "ldrsh r4, [r1, #76]\n\t"
        "ldrsh r5, [r1, #80]\n\t"
        "ldr r6, [r2, #16]\n\t"
        "cmp r5, r6\n\t"
        "it gt\n\t"
        "movgt r5, r6\n\t"
        "cmp r4, r5\n\t"
        "bge 9f\n\t"
        "strd r1, r5, [sp, #64]\n\t"
        "ldrd r7, r8, [r0]\n\t"
        "ldrh r9, [r0, #12]\n\t"
        "ldr r10, [r0, #8]\n\t"
        "ldrb r12, [r0, #16]\n\t"
        "sub r12, #256\n\t"
        "stmia sp, {r7, r8, r9, r10, r12}\n\t"
        "ldmia r2, {r6, r7, r8, r9}\n\t" /* surface, depths, w, y */
        "mov r2, r7\n\t"
        "mov r7, r8\n\t"
        "sub r9, r4, r9\n\t"
        "ldrd r3, r12, [r6]\n\t"
        "lsl r10, r7, #1\n\t"
        "mla r8, r10, r9, r2\n\t"
        "mla r9, r12, r9, r3\n\t"
        "sub r9, r9, r8\n\t"
        "sub r9, #2\n\t"
        "sub r12, r10\n\t"
        "add r3, sp, #20\n\t"
        "stmia r3, {r7, r8, r9, r10, r12}\n"
        "10:\n\t" /* a part: from line r4 of the triangle r1, which ends at r5 */
        "ldrsh r6, [r1, #78]\n\t"
        "add r3, r1, #68\n\t"
        "mov r8, r5\n\t"
        "cmp r4, r6\n\t"
        "bge 11f\n\t"
        "sub r3, #8\n\t"
        "cmp r6, r5\n\t"
        "it lt\n\t"
        "movlt r8, r6\n"
        "11:\n\t"
        "strh r8, [r1, #76]\n\t"
        "sub r8, r4\n\t"
        "str r8, [sp, #72]\n\t"
        "add r2, r1, #52\n\t"
        "ldrb r6, [r1, #83]\n\t"
        "ldrb r8, [r1, #82]\n\t"
        "cbnz r6, 12f\n\t"
        "mov r6, r2\n\t"
        "mov r2, r3\n\t"
        "mov r3, r6\n"
        "12:\n\t"
        "ldrd r4, r6, [r2]\n\t"
        "ldrd r5, r7, [r3]\n\t"
        "add r9, sp, #40\n\t"
        "stmia r9, {r2, r3, r4, r5, r6, r7}\n\t"
        "cmp r8, #2\n\t"
        "bne 30f\n"
        "20:\n\t" COLOUR_COLUMNS "ldmia r1, {r4, r5, r6, r7, r8, r9, r10, r11, r12}\n\t"
        "add lr, r8, r12\n\t"
        "add r12, r7, r11\n\t"
        "add r11, r6, r8\n\t"
        "add r10, r5\n\t"
        "add r9, r4\n\t"
        "stmia r1, {r9, r10, r11, r12, lr}\n\t"
        "subs r3, r3, r2\n\t"
        "ble 8f\n\t"
        "ldrd r8, r9, [r1, #36]\n\t"
        "ldrd r10, r11, [r1, #44]\n\t"
        "add r0, r0, r2, lsl #1\n\t"
        "sub r11, r2, r11\n\t" /* k, from the column of the values */
        "mla r4, r11, r8, r4\n\t"
        "mla r5, r11, r9, r5\n\t"
        "ldrd lr, r2, [sp, #12]\n\t"
        "sub r6, lr, r6\n\t"
        "mls r6, r11, r7, r6\n\t"
        "sub r12, r11, #1\n\t"
        "mul r12, r11, r12\n\t"
        "asr r12, r12, #1\n\t"
        "mls r6, r12, r10, r6\n\t"
        "mla r7, r11, r10, r7\n\t"
        "add r2, r2, r3, lsl #8\n\t"
        "ldr r3, [sp, #4]\n\t"
        "ldr r1, [sp, #28]\n"
        /* r0: depths, r1: out beyond them, r2: shift + 256 (pixels - 1), r3: colours; z, nl, back and dt from r4 on; dz, dnl, ddt from r8
             * on; lr: t_max */
        "1:\n\t" COLOUR_DEPTH "cmp r6, lr\n\t"
        "bhi 3f\n\t"
        "ldr r12, [sp]\n\t"
        "lsr r11, r6, r2\n"
        "4:\n\t"
        "ldrb r12, [r12, r11]\n\t"
        "asrs r11, r5, #24\n\t"
        "bmi 5f\n\t"
        "add r11, r3, r11, lsl #7\n\t"
        "ldrh r11, [r11, r12]\n"
        "6:\n\t"
        "strh r11, [r0, r1]\n"
        "2:\n\t" COLOUR_STEP "b 8f\n"
        "3:\n\t"
        "sub r12, r6, lr\n\t"
        "cmp r12, #0x8000000\n\t"
        "bls 7f\n\t"
        "asrs r11, r5, #24\n\t"
        "bmi 5f\n\t"
        "lsl r11, r11, #7\n\t"
        "ldrh r11, [r3, r11]\n\t"
        "strh r11, [r0, r1]\n\t" COLOUR_STEP "b 8f\n"
        "7:\n\t" /* t is a little below 0 */
        "ldr r12, [sp]\n\t"
        "lsr r11, lr, r2\n\t"
        "b 4b\n"
        "5:\n\t"
        "ldr r11, [sp, #8]\n\t"
        "b 6b\n"
        "8:\n\t" COLOUR_LINE "bne 20b\n"
        "13:\n\t" /* the part's end */
        "add r9, sp, #40\n\t"
        "ldmia r9, {r2, r3, r4, r5}\n\t"
        "str r4, [r2]\n\t"
        "str r5, [r3]\n\t"
        "ldrd r1, r5, [sp, #64]\n\t"
        "ldrsh r4, [r1, #76]\n\t"
        "cmp r4, r5\n\t"
        "blt 10b\n"
        "9:\n\t"
        "add sp, #76\n\t"
        "pop {r4, r5, r6, r7, r8, r9, r10, r11, pc}\n"
        "30:\n\t" COLOUR_COLUMNS "ldrd r4, r5, [r1]\n\t"
        "ldrd r10, r11, [r1, #20]\n\t"
        "add r10, r4\n\t"
        "add r11, r5\n\t"
        "strd r10, r11, [r1]\n\t"
        "subs r3, r3, r2\n\t"
        "ble 8f\n\t"
        "ldrd r8, r9, [r1, #36]\n\t"
        "ldr r12, [r1, #48]\n\t"
        "ldrd r6, r7, [sp, #4]\n\t"
        "ldr r1, [sp, #28]\n\t"
        "add r0, r0, r2, lsl #1\n\t"
        "sub r12, r2, r12\n\t"
        "mla r4, r12, r8, r4\n\t"
        "mla r5, r12, r9, r5\n"
        /* r3: pixels, r6: colours, r7: dark */
        "1:\n\t" COLOUR_DEPTH "asrs r11, r5, #24\n\t"
        "bmi 5f\n\t"
        "lsl r11, r11, #7\n\t"
        "ldrh r11, [r6, r11]\n\t"
        "strh r11, [r0, r1]\n"
        "2:\n\t"
        "add r4, r8\n\t"
        "add r5, r9\n\t"
        "subs r3, #1\n\t"
        "bne 1b\n"
        "8:\n\t" COLOUR_LINE "bne 30b\n\t"
        "b 13b\n"
        "5:\n\t"
        "strh r7, [r0, r1]\n\t"
        "b 2b\n");
}
#undef COLOUR_LINE
#undef COLOUR_STEP
#undef COLOUR_DEPTH
#undef COLOUR_COLUMNS
#elif !GLINT_CORTEX_M0PLUS_ASM
/* Pixels with their depths; end: of these. */
static void colour_dark(const struct glint_look *look, uint32_t z, uint32_t dz, uint16_t *depth, const uint16_t *end,
                        uint16_t *out)
{
    const uint16_t dark = look->dark;
    for (; depth != end; depth++, out++, z += dz)
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            *out = dark;
        }
}

static void colour_matt(const struct glint_look *look, uint32_t z, uint32_t dz, uint32_t nl, uint32_t dnl,
                        uint16_t *depth, const uint16_t *end, uint16_t *out)
{
    for (; depth != end; depth++, out++, z += dz, nl += dnl)
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            *out = (int32_t)nl < 0 ? look->dark : glint_look_colour(look, glint_look_row(nl));
        }
}

static void colour_glossy(const struct glint_look *look, const struct glint_mesh_values *v, uint32_t n, uint32_t pairs,
                          uint16_t *depth, const uint16_t *end, uint16_t *out)
{
    const uint32_t dz = v->zx, dnl = v->nlx, ddt = v->txx;
    uint32_t z = v->z + n * dz, nl = v->nl + n * dnl, dt = v->tx + n * ddt;
    uint32_t back = look->t_max - v->t - n * v->tx - pairs * ddt;
    for (; depth != end; depth++, out++) {
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            glint_look_store(look, back, nl, out);
        }
        z += dz;
        nl += dnl;
        back -= dt;
        dt += ddt;
    }
}

/* Lines of a part, with the edges and steps at hand. */
static void colour_part(const struct glint_look *look, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_part *part, const struct glint_mesh_target *target)
{
    const struct glint_surface *surface = target->surface;
    const int32_t line = triangle->y - target->y;
    struct glint_mesh_values *v = &triangle->values;
    struct glint_mesh_edge left = *part->left, right = *part->right;
    uint16_t *depth_line = target->depth + target->w * line;
    uint8_t *out_line = (uint8_t *)surface->pixels + surface->stride * line;
    for (int32_t lines = part->end - triangle->y; lines; lines--) {
        int32_t from, to;
        if (glint_mesh_columns(&left, &right, target->w, &from, &to)) {
            uint16_t *depth = depth_line + from, *out = (uint16_t *)(void *)out_line + from;
            const uint16_t *const end = depth_line + to;
            const int32_t k = from - v->x; /* |k| < 2^12 */
            const uint32_t n = (uint32_t)k;
            if (triangle->shine == GLINT_MESH_GLOSSY)
                colour_glossy(look, v, n, (uint32_t)(k * (k - 1) / 2), depth, end, out);
            else if (triangle->shine == GLINT_MESH_MATT)
                colour_matt(look, v->z + n * v->zx, v->zx, v->nl + n * v->nlx, v->nlx, depth, end, out);
            else
                colour_dark(look, v->z + n * v->zx, v->zx, depth, end, out);
        }
        glint_mesh_edge_next(&left);
        glint_mesh_edge_next(&right);
        depth_line += target->w;
        out_line += surface->stride;
        if (triangle->shine == GLINT_MESH_GLOSSY) {
            glint_mesh_values_next(v);
        } else {
            v->nl += v->nly;
            v->z += v->zy;
        }
    }
    *part->left = left;
    *part->right = right;
    triangle->y = (int16_t)part->end;
}

void glint_mesh_colour(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *target)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    const struct glint_look look = glint_look_up(tables);
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        colour_part(&look, triangle, &part, target);
    }
}
#else
/* What lines by any tables need. */
static void lines_set(const struct glint_mesh_target *target, struct glint_mesh_lines *lines)
{
    const uint32_t y = (uint32_t)target->y, line = (uint32_t)target->depth;
    lines->line_step = 2 * (uint32_t)target->w;
    lines->off_step = (uint32_t)target->surface->stride - lines->line_step;
    lines->line_first = line - y * lines->line_step;
    lines->off_first = (uint32_t)target->surface->pixels - line - y * lines->off_step;
    lines->w = target->w;
    lines->end = target->end;
}

void glint_mesh_colour_set(const struct glint_tables *tables, const struct glint_mesh_target *target,
                           struct glint_mesh_lines *lines)
{
    const struct glint_look look = glint_look_up(tables);
    lines_set(target, lines);
    lines->colours = look.colours;
    lines->dark = look.dark;
    lines->shift = look.shift;
    lines->limit = look.limit;
    lines->columns = look.columns;
    lines->t_max = look.t_max;
}
#endif

/* ---- ALBEDO ---- */

#if GLINT_FUSED
#if !GLINT_CORTEX_M0PLUS_ASM
/* 1: small code: the order of bytes is asked at each pixel, and of lines of a texture there is one function. */
#ifdef __OPTIMIZE_SIZE__
#define ALBEDO_SMALL 1
#else
#define ALBEDO_SMALL 0
#endif

/* 1: a function for glossy triangles and one for others, as each then has its registers for one loop. Left to itself gcc has a loop's steps on the
 * stack and takes the registers that can do little but add for what it fetches. So steps are held in these, and what goes on from line to line
 * stays in memory. */
#if GLINT_THUMB1
#define ALBEDO_APART (!ALBEDO_SMALL)
#define ALBEDO_STEP(x) __asm__("" : "+h"(x))
#define ALBEDO_STAY(x) __asm__("" : "+m"(x) : : "memory")
#else
#define ALBEDO_APART 0
#define ALBEDO_STEP(x) (void)0
#define ALBEDO_STAY(x) (void)0
#endif

/* Of all but colours and the nearest texel without a palette: those that are asked at each pixel. */
#define ALBEDO_OTHER GLINT_MESH_SOURCES

/* Alone, as it would leave the loop no register. */
static __attribute__((noinline)) uint32_t albedo_smooth(const struct glint_mesh_picture *picture, uint32_t u,
                                                        uint32_t v)
{
    return glint_mesh_smooth_fields(picture, u, v);
}

static inline __attribute__((always_inline)) uint32_t albedo_fields(const struct glint_mesh_pixels *p, uint32_t u,
                                                                    uint32_t v, uint32_t blue, unsigned source)
{
    if (source == GLINT_MESH_COLOURS)
        return glint_mesh_colour_fields(u, v, blue);
    if (source == ALBEDO_OTHER && p->loop >= 4 * GLINT_MESH_SMOOTH)
        return albedo_smooth(&p->picture, u, v);
    const uint32_t at = glint_mesh_nearest(&p->picture, u, v);
    return glint_mesh_fields(source == ALBEDO_OTHER ? p->picture.palette[p->picture.pixels[at]]
                                                    : ((const uint16_t *)(const void *)p->picture.pixels)[at]);
}

/* A line's pixels: values at the first one, and steps. */
struct albedo_run {
    uint32_t z, nl, back, dt, now[3];
    uint32_t dz, dnl, ddt, step[3];
    uint16_t *depth;
    const uint16_t *end; /* of depth; there is one */
    ptrdiff_t off;       /* bytes from a depth to its pixel */
};

static inline __attribute__((always_inline)) void albedo_side_by_side(const struct glint_mesh_pixels *p,
                                                                      const struct albedo_run *run, bool is_glossy,
                                                                      bool is_swapped, unsigned source)
{
    const uint8_t *const levels = p->levels;
    const uint16_t *const end = run->end;
    const ptrdiff_t off = run->off;
    const bool has_blue = source == GLINT_MESH_COLOURS;
    uint32_t dz = run->dz, dlack = 0 - run->dnl, du = run->step[0], dv = run->step[1], half = GLINT_ALBEDO_HALF;
    const uint32_t ddt = is_glossy ? run->ddt : 0, dblue = has_blue ? run->step[2] : 0;
    uint32_t z = run->z, lack = ~run->nl; /* -1 - nl, as levels go down */
    uint32_t back = is_glossy ? run->back : 0, dback = is_glossy ? 0 - run->dt : 0;
    uint32_t u = run->now[0], v = run->now[1], blue = has_blue ? run->now[2] : 0;
    uint16_t *depth = run->depth;
    do {
        if (source != ALBEDO_OTHER) {
            ALBEDO_STEP(dz);
            ALBEDO_STEP(dlack);
            ALBEDO_STEP(du);
            ALBEDO_STEP(dv);
        }
        if (source == GLINT_MESH_NEAREST && !is_glossy)
            ALBEDO_STEP(half);
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            uint32_t word = albedo_fields(p, u, v, blue, source);
            const int32_t number = (int32_t)lack >> GLINT_ALBEDO_LEVEL_SHIFT;
            word = (word * (number < 0 ? levels[number] : p->dark) + half) >> 5 & GLINT_ALBEDO_FIELDS;
            if (is_glossy && (int32_t)back >= 0 && number < 0) { /* t_max and limit are below 2^31 */
                if (__builtin_expect(back <= p->t_max, 1))
                    word = glint_albedo_full(word + p->sums[back >> p->shift]);
                else if (back <= p->limit)
                    word = glint_albedo_full(word + p->sums[p->t_max >> p->shift]);
            }
            *(uint16_t *)(void *)((uint8_t *)depth + off) = glint_packed(word, is_swapped);
        }
        z += dz;
        lack += dlack;
        u += du;
        v += dv;
        if (has_blue)
            blue += dblue;
        if (is_glossy) {
            back += dback;
            dback -= ddt;
        }
    } while (++depth != end);
}

static inline __attribute__((always_inline)) void
albedo_run_by(const struct glint_mesh_pixels *p, const struct albedo_run *run, bool is_glossy, unsigned source)
{
    if (ALBEDO_SMALL)
        albedo_side_by_side(p, run, is_glossy, p->loop & 2, source);
    else if (p->loop & 2)
        albedo_side_by_side(p, run, is_glossy, true, source);
    else
        albedo_side_by_side(p, run, is_glossy, false, source);
}

static inline __attribute__((always_inline)) void
albedo_numbers(const struct glint_mesh_pixels *p, const struct albedo_run *run, bool is_glossy, unsigned source)
{
    if (GLINT_THUMB1 || source == ALBEDO_OTHER)
        albedo_side_by_side(p, run, is_glossy, p->loop & 2, source);
    else
        albedo_run_by(p, run, is_glossy, source);
}

/* The same from numbers in memory. */
#define ALBEDO_PIXELS(name, is_glossy, source)                                                                         \
    static __attribute__((noinline)) void albedo_pixels_##name(const struct glint_mesh_pixels *p)                      \
    {                                                                                                                  \
        const struct albedo_run run = {p->z,                                                                           \
                                       p->nl,                                                                          \
                                       p->back,                                                                        \
                                       p->dt,                                                                          \
                                       {p->now[0], p->now[1], 0},                                                      \
                                       p->dz,                                                                          \
                                       p->dnl,                                                                         \
                                       p->ddt,                                                                         \
                                       {p->step[0], p->step[1], 0},                                                    \
                                       p->depth,                                                                       \
                                       p->end,                                                                         \
                                       p->off};                                                                        \
        albedo_numbers(p, &run, is_glossy, source);                                                                    \
    }
ALBEDO_PIXELS(nearest_matt, false, GLINT_MESH_NEAREST)
ALBEDO_PIXELS(nearest_glossy, true, GLINT_MESH_NEAREST)
ALBEDO_PIXELS(other_matt, false, ALBEDO_OTHER)
ALBEDO_PIXELS(other_glossy, true, ALBEDO_OTHER)

void glint_mesh_albedo_pixels(const struct glint_mesh_pixels *p)
{
    const bool is_glossy = p->loop & 1;
    if (p->loop < 4 * GLINT_MESH_PALETTE)
        (is_glossy ? albedo_pixels_nearest_glossy : albedo_pixels_nearest_matt)(p);
    else
        (is_glossy ? albedo_pixels_other_glossy : albedo_pixels_other_matt)(p);
}
#endif

/* What is the same for all of a part's triangles. */
static inline void albedo_set(struct glint_mesh_pixels *p, const struct glint_tables *tables,
                              const struct glint_texture *texture)
{
    const unsigned source = !texture                        ? GLINT_MESH_COLOURS
                            : texture->is_smooth            ? GLINT_MESH_SMOOTH
                            : texture->palette              ? GLINT_MESH_PALETTE
                            : glint_mesh_is_square(texture) ? GLINT_MESH_SQUARE
                                                            : GLINT_MESH_NEAREST;
    p->levels = tables->columns;
    p->sums = tables->colour.sums;
    p->t_max = tables->t_max_q30;
    p->limit = tables->t_max_q30 - GLINT_NEGATIVE_T;
    p->shift = tables->shift;
    p->dark = tables->dark;
    p->picture.pixels = texture ? (const uint8_t *)texture->pixels : NULL;
    p->picture.palette = texture ? texture->palette : NULL;
    p->loop = (uint8_t)(4u * source + 2u * glint_is_swapped(tables));
}

/* What a triangle has of the texture. */
static inline void albedo_picture(struct glint_mesh_pixels *p, const struct glint_mesh_laid *laid)
{
    p->picture.pixels += laid->blue[0];
    p->picture.w = laid->blue[1] & 0xffff;
    p->picture.h = laid->blue[1] >> 16;
}

/* And of its lines. */
static void albedo_triangle(struct glint_mesh_pixels *p, const struct glint_mesh_triangle *triangle)
{
    p->dz = triangle->values.zx;
    p->dnl = triangle->values.nlx;
    p->ddt = triangle->values.txx;
    p->loop = (uint8_t)(p->loop | (triangle->shine >> 1 & 1)); /* glossy */
}

/* Pixels of a line up to `to`, from where p has its numbers. */
static inline __attribute__((always_inline)) void
albedo_row(struct glint_mesh_pixels *p, const struct glint_mesh_values *v, uint16_t *depth, int32_t from, int32_t to)
{
    const int32_t k = from - v->x;
    const uint32_t n = (uint32_t)k;
    p->z = v->z + n * p->dz;
    p->nl = v->nl + n * p->dnl;
    if (p->loop & 1) {
        p->dt = v->tx + n * p->ddt;
        p->back = p->t_max - v->t - n * v->tx - ((uint32_t)(k * (k - 1)) >> 1) * p->ddt;
    }
    p->depth = depth + from;
    p->end = depth + to;
    glint_mesh_albedo_pixels(p);
}

/* Of a part: in perspective over, by which a line's parts follow each other, or laid. */
static __attribute__((noinline)) void albedo_part(struct glint_mesh_pixels *p, struct glint_mesh_triangle *triangle,
                                                  const struct glint_mesh_part *part,
                                                  const struct glint_mesh_target *target, struct glint_mesh_over *over,
                                                  struct glint_mesh_laid *laid)
{
    const struct glint_use_mesh *const use = target->drawn->mesh->use;
    struct glint_mesh_values *const v = &triangle->values;
    for (; triangle->y < part->end; triangle->y++) {
        const int32_t line = triangle->y - target->y;
        uint16_t *const depth = target->depth + target->w * line;
        int32_t from, to;
        p->off = (ptrdiff_t)((uintptr_t)target->surface->pixels + (uintptr_t)(target->surface->stride * line) -
                             (uintptr_t)depth);
        if (!glint_mesh_columns(part->left, part->right, target->w, &from, &to)) {
        } else if (laid) {
            for (unsigned i = 0; i < 2; i++)
                p->now[i] = laid->at[i] + (uint32_t)(from - v->x) * p->step[i];
            albedo_row(p, v, depth, from, to);
        } else {
            GLINT_FLASH_POINTER(use->line)(over, triangle->y, from, to, v->z + (uint32_t)(from - v->x) * v->zx, v->zx);
            for (;;) {
                for (unsigned i = 0; i < 2; i++) {
                    p->now[i] = over->now[i];
                    p->step[i] = over->step[i];
                }
                albedo_row(p, v, depth, over->from, over->to);
                if (over->to == to)
                    break;
                GLINT_FLASH_POINTER(use->next)(over);
            }
        }
        for (unsigned i = 0; i < 2 && laid; i++)
            laid->at[i] += laid->down[i];
        glint_mesh_edge_next(part->left);
        glint_mesh_edge_next(part->right);
        glint_mesh_values_next(v);
    }
}

struct glint_mesh_laid *glint_mesh_albedo_laid(const struct glint_mesh_target *target,
                                               struct glint_mesh_triangle *triangle,
                                               const struct glint_texture *texture)
{
    struct glint_mesh_laid *const laid =
        (struct glint_mesh_laid *)(void *)((struct glint_mesh_kept *)(void *)triangle + 1);
    if (!(triangle->shine & GLINT_MESH_LAID)) {
        GLINT_FLASH_POINTER(target->drawn->mesh->use->lay)(laid, target, triangle, texture);
        triangle->shine |= GLINT_MESH_LAID;
    }
    return laid;
}

/* laid: NULL in perspective. */
static __attribute__((noinline)) void albedo_lines_of(const struct glint_tables *tables,
                                                      struct glint_mesh_triangle *triangle,
                                                      const struct glint_mesh_target *target,
                                                      const struct glint_texture *texture, struct glint_mesh_laid *laid)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    struct glint_mesh_over *const over = &((struct glint_mesh_bench *)target->frame->memory)->of.over;
    struct glint_mesh_pixels p;
    albedo_set(&p, tables, texture);
    albedo_triangle(&p, triangle);
    if (laid) {
        albedo_picture(&p, laid);
        p.step[0] = laid->right[0];
        p.step[1] = laid->right[1];
    } else {
        GLINT_FLASH_POINTER(target->drawn->mesh->use->set)(over, target, glint_mesh_face_of(triangle), texture);
        p.picture = over->picture;
        p.picture.h = glint_mesh_height_of(texture, &p.picture);
    }
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        albedo_part(&p, triangle, &part, target, over, laid);
    }
}

#if GLINT_CORTEX_M0PLUS_ASM
/* The assembly has them where they need not stay. */
typedef char
    albedo_pixels_fit[sizeof(struct glint_mesh_pixels) <= GLINT_MESH_RUN * sizeof(struct glint_sample) ? 1 : -1];

void glint_mesh_albedo_lines_set(const struct glint_mesh_target *target, const struct glint_tables *tables,
                                 const struct glint_texture *texture, struct glint_mesh_lines *lines)
{
    struct glint_mesh_pixels *const p = (struct glint_mesh_pixels *)(void *)target->samples;
    albedo_set(p, tables, texture);
    lines_set(target, lines);
    glint_mesh_albedo_draws(lines);
    lines->colours = p;
    lines->dark = (uint32_t)target;
    lines->shift = (uint32_t)texture;
    if (!texture)
        return;
    p->picture.w = texture->w;
    p->picture.h = texture->h;
    p->now[2] = texture->w | glint_mesh_height_of(texture, &p->picture) << 16;
    for (unsigned k = 0; k < 2; k++) /* what bilinear ones begin before the corner */
        p->now[k] = texture->is_smooth ? UINT32_C(0x80000000) / (k ? texture->h : texture->w) : 0;
}

uint32_t glint_mesh_albedo_begin(const struct glint_mesh_target *target, const struct glint_paint *paint,
                                 struct glint_mesh_lines *lines)
{
    const struct glint_texture *const texture = glint_mesh_texture_of(target->drawn, paint);
    if (target->frame->kept_bytes != GLINT_MESH_LAID_SIZE || (texture && target->frame->distance) ||
        !glint_mesh_is_albedo(paint, target))
        return 0;
    if (lines)
        glint_mesh_albedo_lines_set(target, &paint->of.tables.filled, texture, lines);
    return (uint32_t)1 << 31;
}

static void albedo_draw(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    (void)glint_mesh_albedo_laid(target, triangle, texture);
    glint_mesh_albedo_triangle(target, triangle, tables, texture);
}
#else
/* Does no colour leave its range on a line of n + 1 pixels? */
static inline bool albedo_is_held(const struct albedo_run *run, uint32_t n)
{
    const uint32_t red = run->now[0] | (run->now[0] + n * run->step[0]),
                   green = run->now[1] | (run->now[1] + n * run->step[1]),
                   blue = run->now[2] | (run->now[2] + n * run->step[2]);
    return ((red | blue) >> 26 | green >> 27) == 0;
}

/* A line where one would. */
static __attribute__((noinline)) void albedo_hold(uint32_t now[3], uint32_t step[3], uint32_t n)
{
    for (unsigned k = 0; k < 3; k++)
        glint_mesh_hold(&now[k], &step[k], k, n);
}

static inline __attribute__((always_inline)) void albedo_colours_begin(struct albedo_run *run,
                                                                       const struct glint_mesh_laid *laid, uint32_t n)
{
    const uint32_t last = (uint32_t)(run->end - run->depth - 1);
    run->step[2] = laid->blue[2];
    run->now[2] = laid->blue[0] + n * run->step[2];
    if (albedo_is_held(run, last))
        return;
    uint32_t now[3] = {run->now[0], run->now[1], run->now[2]}, step[3] = {run->step[0], run->step[1], run->step[2]};
    albedo_hold(now, step, last);
    for (unsigned k = 0; k < 3; k++) {
        run->now[k] = now[k];
        run->step[k] = step[k];
    }
}

/* Pixels of the triangle's line from column `from` on, which run has. */
static inline __attribute__((always_inline)) void
albedo_line(const struct glint_mesh_pixels *p, const struct glint_mesh_triangle *triangle,
            const struct glint_mesh_laid *laid, struct albedo_run *run, int32_t from, bool is_glossy, unsigned source)
{
    const struct glint_mesh_values *const v = &triangle->values;
    const int32_t k = from - v->x;
    const uint32_t n = (uint32_t)k;
    run->dz = v->zx;
    run->z = v->z + n * run->dz;
    run->dnl = v->nlx;
    run->nl = v->nl + n * run->dnl;
    for (unsigned i = 0; i < 2; i++) {
        run->step[i] = laid->right[i];
        run->now[i] = laid->at[i] + n * run->step[i];
    }
    if (is_glossy) {
        run->ddt = v->txx;
        run->dt = v->tx + n * run->ddt;
        run->back = p->t_max - v->t - n * v->tx - ((uint32_t)(k * (k - 1)) >> 1) * run->ddt;
    }
    if (source == GLINT_MESH_COLOURS)
        albedo_colours_begin(run, laid, n);
    if (is_glossy)
        albedo_run_by(p, run, true, source);
    else
        albedo_run_by(p, run, false, source);
}

/* To the next line. */
static inline void albedo_next(struct glint_mesh_values *v, struct glint_mesh_laid *laid, bool is_glossy,
                               unsigned source)
{
    laid->at[0] += laid->down[0];
    laid->at[1] += laid->down[1];
    if (source == GLINT_MESH_COLOURS)
        laid->blue[0] += laid->blue[1];
    if (is_glossy) {
        glint_mesh_values_next(v);
    } else {
        v->nl += v->nly;
        v->z += v->zy;
    }
}

/* A triangle, laid, up to line end - 1. */
static inline __attribute__((always_inline)) void albedo_lines(const struct glint_tables *tables,
                                                               struct glint_mesh_triangle *triangle,
                                                               const struct glint_mesh_target *target,
                                                               const struct glint_texture *texture, bool is_glossy,
                                                               unsigned source)
{
    const struct glint_surface *const surface = target->surface;
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end, w = target->w,
                  line = triangle->y - target->y;
    struct glint_mesh_laid *const laid =
        (struct glint_mesh_laid *)(void *)((struct glint_mesh_kept *)(void *)triangle + 1);
    ptrdiff_t depth_step = 2 * (ptrdiff_t)w, off_step = surface->stride - depth_step;
    uint8_t *depth = (uint8_t *)(target->depth + w * line);
    ptrdiff_t off = (ptrdiff_t)((uintptr_t)surface->pixels + (uintptr_t)(surface->stride * line) - (uintptr_t)depth);
    struct glint_mesh_pixels p;
    albedo_set(&p, tables, texture);
    albedo_triangle(&p, triangle);
    if (source != GLINT_MESH_COLOURS)
        albedo_picture(&p, laid);
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        uint32_t left = (uint32_t)part.left->x, right = (uint32_t)part.right->x;
        uint32_t left_step = (uint32_t)part.left->step, right_step = (uint32_t)part.right->step;
        int32_t lines = part.end - triangle->y;
        triangle->y = (int16_t)part.end;
        do {
            int32_t from = (int32_t)left >> 16, to = (int32_t)right >> 16;
            from = from < 0 ? 0 : from;
            to = to > w ? w : to;
            if (from < to) {
                struct albedo_run run;
                run.depth = (uint16_t *)(void *)depth + from;
                run.end = (uint16_t *)(void *)depth + to;
                run.off = off;
                albedo_line(&p, triangle, laid, &run, from, is_glossy, source);
            }
            ALBEDO_STAY(left);
            ALBEDO_STAY(right);
            ALBEDO_STAY(left_step);
            ALBEDO_STAY(right_step);
            ALBEDO_STAY(depth);
            ALBEDO_STAY(depth_step);
            ALBEDO_STAY(off);
            ALBEDO_STAY(off_step);
            ALBEDO_STAY(lines);
            left += left_step;
            right += right_step;
            depth += depth_step;
            off += off_step;
            albedo_next(&triangle->values, laid, is_glossy, source);
        } while (--lines);
        part.left->x = (int32_t)left;
        part.right->x = (int32_t)right;
    }
}

#define ALBEDO_LINES(name, is_glossy, source)                                                                          \
    static __attribute__((noinline)) void albedo_##name(                                                               \
        const struct glint_tables *tables, struct glint_mesh_triangle *triangle,                                       \
        const struct glint_mesh_target *target, const struct glint_texture *texture)                                   \
    {                                                                                                                  \
        albedo_lines(tables, triangle, target, texture, is_glossy, source);                                            \
    }
#if ALBEDO_APART
ALBEDO_LINES(colours_matt, false, GLINT_MESH_COLOURS)
ALBEDO_LINES(colours_glossy, true, GLINT_MESH_COLOURS)
ALBEDO_LINES(nearest_matt, false, GLINT_MESH_NEAREST)
ALBEDO_LINES(nearest_glossy, true, GLINT_MESH_NEAREST)
#define ALBEDO_OF(name) ((triangle->shine & GLINT_MESH_GLOSSY) ? albedo_##name##_glossy : albedo_##name##_matt)
#else
ALBEDO_LINES(colours, (triangle->shine & GLINT_MESH_GLOSSY) != 0, GLINT_MESH_COLOURS)
#if !ALBEDO_SMALL
ALBEDO_LINES(nearest, (triangle->shine & GLINT_MESH_GLOSSY) != 0, GLINT_MESH_NEAREST)
#endif
#define ALBEDO_OF(name) albedo_##name
#endif

static void albedo_draw(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                        const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    struct glint_mesh_laid *const laid = glint_mesh_albedo_laid(target, triangle, texture);
    if (!texture)
        ALBEDO_OF(colours)(tables, triangle, target, NULL);
#if !ALBEDO_SMALL
    else if (!texture->palette && !texture->is_smooth)
        ALBEDO_OF(nearest)(tables, triangle, target, texture);
#endif
    else
        albedo_lines_of(tables, triangle, target, texture, laid);
}
#endif

/* Has the triangle room for what it has of the texture? */
static bool albedo_has_room(const struct glint_mesh_frame *frame, const struct glint_mesh_triangle *triangle)
{
    const uintptr_t at = (uintptr_t)triangle - (uintptr_t)frame->kept;
    return triangle == &((struct glint_mesh_bench *)frame->memory)->face.triangle ||
           (frame->kept_bytes == GLINT_MESH_LAID_SIZE &&
            at < (uintptr_t)frame->places * (uintptr_t)GLINT_MESH_KEPT_BYTES);
}

/* One that has none is copied. Alone, for the stack. */
static __attribute__((noinline)) void albedo_copied(const struct glint_tables *tables,
                                                    struct glint_mesh_triangle *triangle,
                                                    const struct glint_mesh_target *target,
                                                    const struct glint_texture *texture)
{
    struct glint_mesh_bench *const bench = (struct glint_mesh_bench *)target->frame->memory;
    struct glint_mesh_triangle *const copy = &bench->copy.triangle;
    *copy = *triangle;
    copy->shine &= GLINT_MESH_LAID - 1;
    bench->copy.face = (uint16_t)glint_mesh_face_of(triangle);
    albedo_draw(tables, copy, target, texture);
    copy->shine &= GLINT_MESH_LAID - 1;
    *triangle = *copy;
}

void glint_mesh_albedo_lines(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                             const struct glint_mesh_target *target, const struct glint_texture *texture)
{
    if (texture && target->frame->distance)
        albedo_lines_of(tables, triangle, target, texture, NULL);
    else if (albedo_has_room(target->frame, triangle))
        albedo_draw(tables, triangle, target, texture);
    else
        albedo_copied(tables, triangle, target, texture);
}
#endif
