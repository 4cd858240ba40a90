/* SPDX-License-Identifier: MIT
 * The exact line of RGB565 under MSH, dithered or not, Schlick, GGX and Cayley, and of RGB888 under MSH, by the DSP extension of Cortex-M4, M7,
 * M33 and later: two pixels at a time, two products an instruction. Like the other exact loops it finds V, which is low by less than W, and leaves
 * open what V and W do not decide. */
#include "glint_fused.h"

#if GLINT_DSP && !defined(GLINT_DSP_MODEL) /* of tests, in C, for the host */

#define DSP_AT(field, offset) (offsetof(struct glint_line_loop, field) == (offset))
typedef char dsp_layout[DSP_AT(turn, 0) && DSP_AT(plain, 28) && DSP_AT(shine, 56) && DSP_AT(v, 56 + 28) &&
                                DSP_AT(up, 56 + 36) && DSP_AT(hh, 56 + 40) && DSP_AT(nh, 56 + 44) &&
                                DSP_AT(t_end, 56 + 48) && DSP_AT(dark, 56 + 52) && DSP_AT(last, 56 + 56) &&
                                DSP_AT(w_green, 56 + 60) && DSP_AT(thresholds, 56 + 64) && DSP_AT(dark_of, 56 + 80) &&
                                DSP_AT(lit, 56 + 96) && DSP_AT(albedo_at, 56 + 120) && sizeof(struct glint_vec) == 6
                            ? 1
                            : -1];
#undef DSP_AT

/* r0: the next normal, r1: the pixel in out, r2: shine, r3: t_end; on the stack turn and, at 28, the last place from which two normals are left.
 *
 * Levels of V in vr, vg, vb: stored, and to 9 where one of them is open: its fraction and W carry. */
#define DSP_LEVELS(format, vr, vg, vb, w, w_green, r, g, b)                                                            \
    ".if " format " == 2\n\t"                                                                                          \
    "usat " r ", #8, " vr ", asr #22\n\t"                                                                              \
    "usat " g ", #8, " vg ", asr #22\n\t"                                                                              \
    "usat " b ", #8, " vb ", asr #22\n\t"                                                                              \
    "strb " r ", [r1], #1\n\t"                                                                                         \
    "strb " g ", [r1], #1\n\t"                                                                                         \
    "strb " b ", [r1], #1\n\t"                                                                                         \
    "cmn " w ", " vr ", lsl #10\n\t"                                                                                   \
    "itt cc\n\t"                                                                                                       \
    "cmncc " w_green ", " vg ", lsl #10\n\t"                                                                           \
    "cmncc " w ", " vb ", lsl #10\n\t"                                                                                 \
    ".else\n\t"                                                                                                        \
    ".if " format " == 3 || " format " == 4\n\t"                                                                       \
    "and " r ", r1, #6\n\t"                                                                                            \
    "add " r ", r2, " r ", lsl #1\n\t"                                                                                 \
    "ldr " r ", [" r ", #64]\n\t"                                                                                      \
    "add " vr ", " vr ", " r "\n\t"                                                                                    \
    "add " vg ", " vg ", " r ", lsr #1\n\t"                                                                            \
    "add " vb ", " vb ", " r "\n\t"                                                                                    \
    ".endif\n\t"                                                                                                       \
    "usat " r ", #5, " vr ", asr #25\n\t"                                                                              \
    "usat " g ", #6, " vg ", asr #24\n\t"                                                                              \
    "usat " b ", #5, " vb ", asr #25\n\t"                                                                              \
    "orr " b ", " b ", " g ", lsl #5\n\t"                                                                              \
    "orr " b ", " b ", " r ", lsl #11\n\t"                                                                             \
    ".if " format " == 1 || " format " == 4 || " format " == 6\n\t"                                                    \
    "rev16 " b ", " b "\n\t"                                                                                           \
    ".endif\n\t"                                                                                                       \
    "strh " b ", [r1], #2\n\t"                                                                                         \
    "cmn " w ", " vr ", lsl #7\n\t"                                                                                    \
    "itt cc\n\t"                                                                                                       \
    "cmncc " w_green ", " vg ", lsl #8\n\t"                                                                            \
    "cmncc " w ", " vb ", lsl #7\n\t"                                                                                  \
    ".endif\n\t"                                                                                                       \
    "bcs 9f\n\t"

/* Channel k of a pixel of s with an albedo map, whose byte is the next one at t. */
#define DSP_LIT(v, s, t, k)                                                                                            \
    "ldrd r5, r8, [r2, #96 + 8 * " k "]\n\t"                                                                           \
    "smmlar r5, r5, " s ", r8\n\t"                                                                                     \
    "ldrb r8, [" t "], #1\n\t"                                                                                         \
    "mla " v ", r5, r8, " v "\n\t"

/* A pixel of s, N.L less 2^13, and T in t. Where it is dark, or N.L above 1.0, to 5n; outside the highlight to 4n; the next one is at 3n. */
#define DSP_PIXEL(wide, format, model, s, t, n)                                                                        \
    "cmp " s ", #0x40000000\n\t"                                                                                       \
    "bhs 5" n "f\n\t"                                                                                                  \
    "cmp " t ", r3\n\t"                                                                                                \
    "bhs 4" n "f\n\t"                                                                                                  \
    "ldrd r5, r8, [r2, #28]\n\t"                                                                                       \
    ".if " model " == 3\n\t"                                                                                           \
    ".if " wide "\n\t"                                                                                                 \
    "smmulr r10, r5, " t "\n\t"                                                                                        \
    "mvn " t ", " t ", lsl #2\n\t"                                                                                     \
    ".else\n\t"                                                                                                        \
    "ldr r11, [r2, #36]\n\t"                                                                                           \
    "lsl r10, " t ", r11\n\t"                                                                                          \
    "smmulr r10, r5, r10\n\t"                                                                                          \
    "mvn " t ", " t ", lsl #1\n\t"                                                                                     \
    ".endif\n\t"                                                                                                       \
    "sub " t ", " t ", r10, lsl #4\n\t"                                                                                \
    "add r8, r8, r10, lsr #12\n\t"                                                                                     \
    ".else\n\t"                                                                                                        \
    ".if " model " == 2 && " wide "\n\t"                                                                               \
    "rsb r10, " t ", #0x40000000\n\t"                                                                                  \
    "smmulr r10, r10, r10\n\t"                                                                                         \
    "lsl r10, r10, #2\n\t"                                                                                             \
    "smmlar r8, r5, r10, r8\n\t"                                                                                       \
    ".elseif " wide " || " model " == 1\n\t"                                                                           \
    "smmlar r8, r5, " t ", r8\n\t"                                                                                     \
    ".else\n\t"                                                                                                        \
    "ldr r11, [r2, #36]\n\t"                                                                                           \
    ".if " model " == 2\n\t"                                                                                           \
    "smmlsr r10, " t ", " t ", " t "\n\t"                                                                              \
    "lsl r10, r10, r11\n\t"                                                                                            \
    ".else\n\t"                                                                                                        \
    "lsl r10, " t ", r11\n\t"                                                                                          \
    ".endif\n\t"                                                                                                       \
    "smmlar r8, r5, r10, r8\n\t"                                                                                       \
    ".endif\n\t"                                                                                                       \
    ".if " model " == 2\n\t"                                                                                           \
    "mvn " t ", #0\n\t"                                                                                                \
    ".elseif " wide "\n\t"                                                                                             \
    "mvn " t ", " t ", lsl #2\n\t"                                                                                     \
    ".else\n\t"                                                                                                        \
    "mvn " t ", " t ", lsl #1\n\t"                                                                                     \
    ".endif\n\t"                                                                                                       \
    ".if " model " != 1\n\t"                                                                                           \
    "smmulr r8, r8, r8\n\t"                                                                                            \
    ".endif\n\t"                                                                                                       \
    ".endif\n\t"                                                                                                       \
    "udiv " t ", " t ", r8\n\t"                                                                                        \
    ".if " model " == 3\n\t" /* its fourth power */                                                                    \
    "mul " t ", " t ", " t "\n\t"                                                                                      \
    "umull r8, " t ", " t ", " t "\n\t"                                                                                \
    "lsr " t ", " t ", #16\n\t"                                                                                        \
    ".endif\n\t"                                                                                                       \
    "str r1, [r2, #56]\n\t"                                                                                            \
    ".if " format " > 4\n\t"                                                                                           \
    "ldmia r2, {r5, r8, r10, r11, r12, lr}\n\t"                                                                        \
    "mla r10, " t ", r5, r10\n\t"                                                                                      \
    "mla r11, " t ", r8, r11\n\t"                                                                                      \
    "mla r12, " t ", lr, r12\n\t"                                                                                      \
    "ldr lr, [r2, #24]\n\t"                                                                                            \
    "cmn lr, #1\n\t"                                                                                                   \
    "beq 7" n "f\n"                                                                                                    \
    "6" n ":\n\t" /* lit */                                                                                            \
    "bfc " s ", #0, #14\n\t"                                                                                           \
    "ldr " t ", [r2, #120]\n\t" DSP_LIT("r10", s, t, "0") DSP_LIT("r11", s, t, "1")                                    \
        DSP_LIT("r12", s, t, "2") "str " t ", [r2, #120]\n\t" DSP_LEVELS(                                              \
            format, "r10", "r11", "r12", "lr", "lr", "r5", s,                                                          \
            "r8") ".else\n\t"                                                                                          \
                  "pkhbt " t ", " t ", " s ", lsl #2\n\t"                                                              \
                  "eor " t ", " t ", #0x80008000\n\t"                                                                  \
                  "ldmia r2, {r5, r7, r8, r10, r11, r12, lr}\n\t"                                                      \
                  "smlad r10, " t ", r5, r10\n\t"                                                                      \
                  "smlad r11, " t ", r7, r11\n\t"                                                                      \
                  "smlad r12, " t ", r8, r12\n\t"                                                                      \
                  "ldr " t                                                                                             \
                  ", [r2, #60]\n\t" DSP_LEVELS(format, "r10", "r11", "r12", "lr", t, "r5", "r7", "r8") ".endif\n3" n   \
                                                                                                       ":\n\t"

/* q0: a register below r8 that is free. */
#define DSP_REST(format, s, q0, q1, n)                                                                                 \
    ".if " format " > 4\n"                                                                                             \
    "4" n ":\n\t"                                                                                                      \
    "ldmdb r2, {r10, r11, r12, lr}\n\t"                                                                                \
    "b 6" n "b\n"                                                                                                      \
    "5" n ":\n\t" /* nl = 0 */                                                                                         \
    "cmp " s ", #0\n\t"                                                                                                \
    "itt mi\n\t"                                                                                                       \
    "movmi " s ", #-1\n\t"                                                                                             \
    "bmi 4" n "b\n"                                                                                                    \
    "7" n ":\n\t"                                                                                                      \
    "adds r1, #2\n\t"                                                                                                  \
    "b 9f\n\t"                                                                                                         \
    ".else\n"                                                                                                          \
    "4" n ":\n\t"                                                                                                      \
    "ldmdb r2, {" q0 ", " q1 ", r8, r10, r11, r12, lr}\n\t"                                                            \
    "lsr " s ", " s ", #14\n\t"                                                                                        \
    "mla r10, " q0 ", " s ", r10\n\t"                                                                                  \
    "mla r11, " q1 ", " s ", r11\n\t"                                                                                  \
    "mla r12, r8, " s                                                                                                  \
    ", r12\n\t" DSP_LEVELS(format, "r10", "r11", "r12", "lr", "lr", q0, q1, "r8") "b 3" n "b\n"                        \
                                                                                  "5" n ":\n\t"                        \
                                                                                  ".if " format " > 2\n\t"             \
                                                                                  "and r5, r1, #6\n\t"                 \
                                                                                  "add r5, r2, r5, lsl #1\n\t"         \
                                                                                  "ldr r5, [r5, #80]\n\t"              \
                                                                                  ".else\n\t"                          \
                                                                                  "ldr r5, [r2, #52]\n\t"              \
                                                                                  ".endif\n\t"                         \
                                                                                  ".if " format " == 2\n\t"            \
                                                                                  "strb r5, [r1], #1\n\t"              \
                                                                                  "lsr r5, r5, #8\n\t"                 \
                                                                                  "strb r5, [r1], #1\n\t"              \
                                                                                  "lsr r5, r5, #8\n\t"                 \
                                                                                  "strb r5, [r1], #1\n\t"              \
                                                                                  ".else\n\t"                          \
                                                                                  "strh r5, [r1], #2\n\t"              \
                                                                                  ".endif\n\t"                         \
                                                                                  "cmp " s ", #0\n\t"                  \
                                                                                  "bmi 3" n "b\n\t"                    \
                                                                                  "b 9f\n\t"                           \
                                                                                  ".endif\n\t"

#define DSP_RUN(name, model, wide, format)                                                                             \
    __attribute__((naked, noinline)) uint8_t *name(                                                                    \
        __attribute__((unused)) const struct glint_vec *normals, __attribute__((unused)) uint8_t *out,                 \
        __attribute__((unused)) uint32_t *shine, __attribute__((unused)) const struct glint_vec *end)                  \
    {                                                                                                                  \
        __asm__("push {r4, r5, r6, r7, r8, r9, r10, r11, lr}\n\t"                                                      \
                "sub sp, #36\n\t"                                                                                      \
                "sub r4, r2, #56\n\t"                                                                                  \
                "ldmia r4, {r5, r6, r7, r8, r9, r10, r11}\n\t"                                                         \
                "stmia sp, {r5, r6, r7, r8, r9, r10, r11}\n\t"                                                         \
                "sub r5, r3, #12\n\t"                                                                                  \
                "str r5, [sp, #28]\n\t"                                                                                \
                "ldr r3, [r2, #48]\n\t"                                                                                \
                "tst r0, #2\n\t" /* pairs are loaded by words */                                                       \
                "bne 8f\n\t"                                                                                           \
                "b 7f\n"                                                                                               \
                "1:\n\t"                                                                                               \
                "ldmia sp, {r7, r8, r9, r10, r11, r12, lr}\n\t"                                                        \
                "ldmia r0!, {r4, r5, r6}\n\t"                                                                          \
                "smlad r7, r4, r7, r10\n\t"                                                                            \
                "smlabb r7, r5, r8, r7\n\t"                                                                            \
                "smlad r9, r6, r9, r10\n\t"                                                                            \
                "smlatt r9, r5, r8, r9\n\t"                                                                            \
                ".if " wide "\n\t"                                                                                     \
                "ldrd r8, r10, [r2, #40]\n\t"                                                                          \
                "smlad r11, r4, r11, r10\n\t"                                                                          \
                "smlabb r11, r5, r12, r11\n\t"                                                                         \
                "smlad r10, r6, lr, r10\n\t"                                                                           \
                "smlatt r10, r5, r12, r10\n\t"                                                                         \
                "smlad r4, r4, r4, r8\n\t"                                                                             \
                "smlabb r4, r5, r5, r4\n\t"                                                                            \
                "smlad r6, r6, r6, r8\n\t"                                                                             \
                "smlatt r6, r5, r5, r6\n\t"                                                                            \
                "rsb r4, r11, r4, asr #1\n\t"                                                                          \
                "rsb r6, r10, r6, asr #1\n\t"                                                                          \
                ".else\n\t"                                                                                            \
                "qsub16 r4, r4, r11\n\t"                                                                               \
                "qsub16 r5, r5, r12\n\t"                                                                               \
                "qsub16 r6, r6, lr\n\t"                                                                                \
                "smuad r4, r4, r4\n\t"                                                                                 \
                "smlabb r4, r5, r5, r4\n\t"                                                                            \
                "smuad r6, r6, r6\n\t"                                                                                 \
                "smlatt r6, r5, r5, r6\n\t"                                                                            \
                ".endif\n\t" DSP_PIXEL(wide, format, model, "r7", "r4", "0") "2:\n\t" DSP_PIXEL(                       \
                    wide, format, model, "r9", "r6", "1") "ldr r5, [sp, #28]\n"                                        \
                                                          "7:\n\t"                                                     \
                                                          "cmp r0, r5\n\t"                                             \
                                                          "bls 1b\n\t"                                                 \
                                                          "add r5, #12\n\t"                                            \
                                                          "cmp r0, r5\n\t"                                             \
                                                          "bne 8f\n\t"                                                 \
                                                          "mov r0, r1\n"                                               \
                                                          "6:\n\t"                                                     \
                                                          "add sp, #36\n\t"                                            \
                                                          "pop {r4, r5, r6, r7, r8, r9, r10, r11, pc}\n"               \
                                                          "8:\n\t" /* one, in the place of the second of a pair */     \
                                                          "ldrh r4, [r0]\n\t"                                          \
                                                          "ldrh r5, [r0, #2]\n\t"                                      \
                                                          "orr r4, r4, r5, lsl #16\n\t"                                \
                                                          "ldrh r5, [r0, #4]\n\t"                                      \
                                                          "adds r0, #6\n\t"                                            \
                                                          "ldmia sp, {r7, r8, r9, r10, r11, r12, lr}\n\t"              \
                                                          "smlad r9, r4, r7, r10\n\t"                                  \
                                                          "smlabb r9, r5, r8, r9\n\t"                                  \
                                                          ".if " wide "\n\t"                                           \
                                                          "ldrd r8, r10, [r2, #40]\n\t"                                \
                                                          "smlad r6, r4, r4, r8\n\t"                                   \
                                                          "smlabb r6, r5, r5, r6\n\t"                                  \
                                                          "smlad r10, r4, r11, r10\n\t"                                \
                                                          "smlabb r10, r5, r12, r10\n\t"                               \
                                                          "rsb r6, r10, r6, asr #1\n\t"                                \
                                                          ".else\n\t"                                                  \
                                                          "qsub16 r4, r4, r11\n\t"                                     \
                                                          "qsub16 r5, r5, r12\n\t"                                     \
                                                          "smuad r6, r4, r4\n\t"                                       \
                                                          "smlabb r6, r5, r5, r6\n\t"                                  \
                                                          ".endif\n\t"                                                 \
                                                          "b 2b\n" DSP_REST(format, "r7", "r4", "r5", "0") DSP_REST(   \
                                                              format, "r9", "r6", "r7", "1") "9:\n\t"                  \
                                                                                             ".if " format " == 2\n\t" \
                                                                                             "subs r0, r1, #3\n\t"     \
                                                                                             ".else\n\t"               \
                                                                                             "subs r0, r1, #2\n\t"     \
                                                                                             ".endif\n\t"              \
                                                                                             "b 6b\n\t");              \
    }

DSP_RUN(glint_dsp_msh, "0", "0", "0")
DSP_RUN(glint_dsp_msh_swapped, "0", "0", "1")
DSP_RUN(glint_dsp_msh_wide, "0", "1", "0")
DSP_RUN(glint_dsp_msh_wide_swapped, "0", "1", "1")
DSP_RUN(glint_dsp_schlick, "1", "0", "0")
DSP_RUN(glint_dsp_schlick_swapped, "1", "0", "1")
DSP_RUN(glint_dsp_schlick_wide, "1", "1", "0")
DSP_RUN(glint_dsp_schlick_wide_swapped, "1", "1", "1")
DSP_RUN(glint_dsp_ggx, "2", "0", "0")
DSP_RUN(glint_dsp_ggx_swapped, "2", "0", "1")
DSP_RUN(glint_dsp_ggx_wide, "2", "1", "0")
DSP_RUN(glint_dsp_ggx_wide_swapped, "2", "1", "1")
DSP_RUN(glint_dsp_cayley, "3", "0", "0")
DSP_RUN(glint_dsp_cayley_swapped, "3", "0", "1")
DSP_RUN(glint_dsp_cayley_wide, "3", "1", "0")
DSP_RUN(glint_dsp_cayley_wide_swapped, "3", "1", "1")
DSP_RUN(glint_dsp_msh_dither, "0", "0", "3")
DSP_RUN(glint_dsp_msh_dither_swapped, "0", "0", "4")
DSP_RUN(glint_dsp_msh_dither_wide, "0", "1", "3")
DSP_RUN(glint_dsp_msh_dither_wide_swapped, "0", "1", "4")
DSP_RUN(glint_dsp_msh_albedo, "0", "0", "5")
DSP_RUN(glint_dsp_msh_albedo_swapped, "0", "0", "6")
DSP_RUN(glint_dsp_888, "0", "0", "2")
DSP_RUN(glint_dsp_888_wide, "0", "1", "2")
#undef DSP_RUN
#undef DSP_REST
#undef DSP_PIXEL
#undef DSP_LIT
#undef DSP_LEVELS
#endif
