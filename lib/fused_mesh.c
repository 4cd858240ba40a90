/* SPDX-License-Identifier: MIT
 * A triangle by COLOUR tables. Its lines are short, so each pixel is asked for its depth and drawn at once; loops take what dark, matt and glossy
 * pixels need and no more. */
#include "glint_mesh_rows.h"
#include "glint_mesh_strip.h"
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
/* Pixels with their depths, one at least; end: of these. */
static void colour_dark(const struct glint_tables *tables, uint32_t z, uint32_t dz, uint16_t *depth,
                        const uint16_t *end, uint16_t *out)
{
    const uint16_t dark = tables->dark;
    do {
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            *out = dark;
        }
        z += dz;
        out++;
    } while (++depth != end);
}

static void colour_matt(const struct glint_tables *tables, uint32_t z, uint32_t dz, uint32_t nl, uint32_t dnl,
                        uint16_t *depth, const uint16_t *end, uint16_t *out)
{
    const struct glint_look look = glint_look_up(tables);
    do {
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            *out = nl > INT32_MAX ? look.dark : glint_look_colour(&look, glint_look_row(nl));
        }
        z += dz;
        nl += dnl;
        out++;
    } while (++depth != end);
}

#define COLOUR_NEXT (z += dz, nl += dnl, back -= dt, dt += ddt, out++, ++depth != end)
#if __GNUC__ >= 9
#define COLOUR_RARELY(condition) __builtin_expect_with_probability(condition, 0, .999) /* else gcc puts it between */
#else
#define COLOUR_RARELY(condition) __builtin_expect(condition, 0)
#endif
/* Alone, so that what a pixel needs is in registers. Most lines are all past the highlight or all in it: each kind has a loop, which leaves at a
 * pixel that is not so. k: the pixel, from the values' column on; |k| < 2^12. */
static __attribute__((noinline)) void colour_glossy(const struct glint_tables *tables,
                                                    const struct glint_mesh_values *v, int32_t k, uint16_t *depth,
                                                    const uint16_t *end, uint16_t *out)
{
    const struct glint_look look = glint_look_up(tables);
    const uint32_t n = (uint32_t)k, dz = v->zx, dnl = v->nlx, ddt = v->txx;
    uint32_t z = v->z + n * dz, nl = v->nl + n * dnl, dt = v->tx + n * ddt;
    uint32_t back = look.t_max - v->t - n * v->tx - (uint32_t)(k * (k - 1) >> 1) * ddt; /* as glint_look_store has it */
    if (back > look.limit)
        do
            if (z >> 16 < *depth) {
                if (COLOUR_RARELY(back <= look.limit))
                    goto any;
                if (COLOUR_RARELY(nl > INT32_MAX))
                    goto any;
                *depth = (uint16_t)(z >> 16);
                *out = glint_look_colour(&look, glint_look_row(nl));
            }
        while (COLOUR_NEXT);
    else
        do
            if (z >> 16 < *depth) {
                if (COLOUR_RARELY(back > look.t_max))
                    goto any;
                if (COLOUR_RARELY(nl > INT32_MAX))
                    goto any;
                const uint32_t column = look.columns[back >> look.shift]; /* being loaded while the depth is stored */
                *depth = (uint16_t)(z >> 16);
                *out = glint_look_colour(&look, glint_look_row(nl) + column);
            }
        while (COLOUR_NEXT);
    return;
any:;
    const struct glint_look again = glint_look_up(tables);
    do
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            glint_look_store(&again, back, nl, out);
        }
    while (COLOUR_NEXT);
}
#undef COLOUR_RARELY
#undef COLOUR_NEXT

/* Lines of a part, with the edges and steps at hand. In place for each shine, unless code is to be small. */
#ifdef __OPTIMIZE_SIZE__
static __attribute__((noinline)) void
#else
static inline __attribute__((always_inline)) void
#endif
colour_part(const struct glint_tables *tables, struct glint_mesh_triangle *triangle, const struct glint_mesh_part *part,
            const struct glint_mesh_target *target, enum glint_mesh_shine shine)
{
    const struct glint_surface *surface = target->surface;
    const int32_t line = triangle->y - target->y;
    struct glint_mesh_values *v = &triangle->values;
    struct glint_mesh_edge left = *part->left, right = *part->right;
    uint16_t *depth_line = target->depth + target->w * line;
    uint8_t *out_line = (uint8_t *)surface->pixels + surface->stride * line;
    int32_t lines = part->end - triangle->y; /* one at least */
    do {
        int32_t from, to;
        if (glint_mesh_columns(&left, &right, target->w, &from, &to)) {
            uint16_t *depth = depth_line + from, *out = (uint16_t *)(void *)out_line + from;
            const uint16_t *const end = depth_line + to;
            const int32_t k = from - v->x; /* |k| < 2^12 */
            const uint32_t n = (uint32_t)k;
            if (shine == GLINT_MESH_GLOSSY)
                colour_glossy(tables, v, k, depth, end, out);
            else if (shine == GLINT_MESH_MATT)
                colour_matt(tables, v->z + n * v->zx, v->zx, v->nl + n * v->nlx, v->nlx, depth, end, out);
            else
                colour_dark(tables, v->z + n * v->zx, v->zx, depth, end, out);
        }
        glint_mesh_edge_next(&left);
        glint_mesh_edge_next(&right);
        __asm__("" : "+r"(left.x), "+r"(right.x)); /* else what they come to is found by multiplying, too */
        depth_line += target->w;
        out_line += surface->stride;
        if (shine == GLINT_MESH_GLOSSY) {
            glint_mesh_values_next(v);
        } else {
            v->nl += v->nly;
            v->z += v->zy;
        }
    } while (--lines);
    *part->left = left;
    *part->right = right;
    triangle->y = (int16_t)part->end;
}

void glint_mesh_colour(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *target)
{
    const int32_t end = triangle->y_end < target->end ? triangle->y_end : target->end;
    while (triangle->y < end) {
        const struct glint_mesh_part part = glint_mesh_triangle_part(triangle, end);
        if (triangle->shine == GLINT_MESH_GLOSSY)
            colour_part(tables, triangle, &part, target, GLINT_MESH_GLOSSY);
        else if (triangle->shine == GLINT_MESH_MATT)
            colour_part(tables, triangle, &part, target, GLINT_MESH_MATT);
        else
            colour_part(tables, triangle, &part, target, GLINT_MESH_DARK);
    }
}
#else
void glint_mesh_lines_set(const struct glint_mesh_target *target, struct glint_mesh_lines *lines)
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
    glint_mesh_lines_set(target, lines);
    lines->off_first += lines->line_first; /* pixels by themselves */
    lines->off_step += lines->line_step;
    lines->off = (uint32_t)lines->w; /* beside what is read with it */
    lines->colours = look.colours;
    lines->dark = look.dark;
    lines->shift = look.shift;
    lines->limit = look.limit;
    lines->columns = look.columns;
    lines->t_max = look.t_max;
}
#endif
