/* SPDX-License-Identifier: MIT
 * glint_linear_levels(pixels, samples, count, channels): pixel_linear.c's linear_sum_rgb and linear_encode of three channels, undithered, where V is not shifted down. What may
 * be another level at V + W is a little more here, and is settled in C, to the same level.
 *
 * A level is the upper bits of fine max + bias, 2^-24 of it. fine is the chord in 2^-8, rounded down. Step 7 rounds the chord, up or down by
 * 128 at most. Step 8 divides by 65535, not by 65536, for at most 256 max more, and its threshold is at most 257 low. As bias has
 * 128 255 + 257 taken off, the sum is never high, and low by less than 385 max + 128 255 + 257 < 128 (3 max + 260). To V + W the chord rises by
 * as many steps as that is, at most, of its octave's first chord, the steepest: 256 max each. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

/* *channels. */
#define AT_OF GLINT_AT_CHANNELS_OF /* P, then Q, then R, of three channels each */
#define AT_STEPS GLINT_AT_CHANNELS_STEPS
#define AT_ENTRIES GLINT_AT_CHANNELS_ENTRIES
#define AT_NEAR GLINT_AT_CHANNELS_NEAR /* a channel's largest level, then the bits of what is near */

/* The stack: the first pixel's level of the channel, END of them. */
#define OUR_CHANNELS 0
#define OUR_SAMPLES 4
#define OUR_FIRST 8
#define OUR_END 12
#define OUR_R 16
#define OUR_R_LOW 20
#define OUR_BYTES 24

at      .req r0
sample  .req r1
x       .req r2
y       .req r3
z       .req r4
t       .req r5
bits    .req r6
max     .req r7
q       .req r8
q_low   .req r9
p       .req r10
bias    .req r11
chords  .req r12
margin  .req lr

function glint_linear_levels
    enter OUR_BYTES
    str r0, [sp, #OUR_FIRST]
    str r1, [sp, #OUR_SAMPLES]
    lsls r2, r2, #2
    adds r2, r2, r0
    str r2, [sp, #OUR_END]
    str r3, [sp, #OUR_CHANNELS]
    ldr t, .Lbias
    mov bias, t
    movs max, #0
.Lchannel:                          /* r3 is *channels */
    lsls r1, at, #30
    lsrs r1, r1, #28                /* 4 times the channel's number */
    ldr r2, [r3, #AT_OF]
    adds r2, r2, r1
    adds r3, r3, r1
    ldr r1, [r2]                    /* P, and 1/2 */
    movs r4, #1
    lsls r4, r4, #GLINT_LINEAR_SHIFT - 1
    adds r1, r1, r4
    mov p, r1
    ldr r4, [r2, #GLINT_AT_EXACT_Q]               /* Q, as its upper bits and the lower ones */
    lsrs r1, r4, #GLINT_LINEAR_FRACTION
    mov q, r1
    lsls r4, r4, #32 - GLINT_LINEAR_FRACTION
    lsrs r4, r4, #32 - GLINT_LINEAR_FRACTION
    mov q_low, r4
    ldr r4, [r2, #GLINT_AT_EXACT_R]               /* R */
    lsrs r1, r4, #GLINT_LINEAR_FRACTION
    str r1, [sp, #OUR_R]
    lsls r4, r4, #32 - GLINT_LINEAR_FRACTION
    lsrs r4, r4, #32 - GLINT_LINEAR_FRACTION
    str r4, [sp, #OUR_R_LOW]
    movs r4, #0
    ldr t, [r3, #AT_NEAR]
    str r4, [r3, #AT_NEAR]
    cmp t, max
    beq 1f                  /* the octave is at hand, with its margin */
    movs max, t
    movs bits, #16          /* none: x >> 16 is 0 */
1:
    ldr sample, [sp, #OUR_SAMPLES]
.Lpixel:
    ldr y, [sample, #GLINT_AT_SAMPLE_NL]     /* N.L */
    ldr z, [sample, #GLINT_AT_SAMPLE_NL + 4]     /* F */
    mov x, q
    muls x, y
    mov t, q_low
    muls y, t
    add x, p
    cmp z, #0
    beq 1f
    ldr t, [sp, #OUR_R]
    muls t, z
    adds x, x, t
    ldr t, [sp, #OUR_R_LOW]
    muls t, z
    adds y, y, t
1:
    lsrs y, y, #GLINT_LINEAR_FRACTION
    adds x, x, y
    lsrs x, x, #GLINT_LINEAR_SHIFT
    lsrs t, x, #16
    bne .Lbright
.Lheld:
    rors x, x, bits         /* the chord's number is below, what lies beyond its beginning is on top */
    uxth y, x
    subs y, y, #32
    cmp y, #32
    bhs .Loctave
    lsrs x, x, #16
.Lchord:
    adds y, y, y
    add y, chords
    ldrh z, [y]
    ldrh y, [y, #2]
    subs y, y, z
    muls x, y
    lsls z, z, #16
    adds x, x, z
    lsrs x, x, #8
.Lfine:
    muls x, max
    add x, bias
    mov t, margin
    adds t, t, x
    eors t, t, x
    lsrs t, t, #24
    bne .Lnear
    lsrs x, x, #24
    strb x, [at]
.Lnext:
    adds at, at, #4
    adds sample, sample, #GLINT_SAMPLE_SIZE
    ldr t, [sp, #OUR_END]
    cmp at, t
    bne .Lpixel
    adds t, t, #1
    str t, [sp, #OUR_END]
    ldr at, [sp, #OUR_FIRST]
    adds at, at, #1
    str at, [sp, #OUR_FIRST]
    ldr r3, [sp, #OUR_CHANNELS]
    lsls t, at, #30
    lsrs t, t, #30
    cmp t, #3
    bne .Lchannel
    leave OUR_BYTES

.Lbright:
    ldr x, .Lone
    b .Lheld

.Lnear:
    ldr t, [sp, #OUR_FIRST]
    subs y, at, t
    lsrs y, y, #2
    movs x, #1
    lsls x, x, y
    ldr y, [sp, #OUR_CHANNELS]
    lsls t, t, #30
    lsrs t, t, #28
    adds y, y, t
    ldr t, [y, #AT_NEAR]
    orrs t, t, x
    str t, [y, #AT_NEAR]
    b .Lnext

/* x, turned by bits, is of another octave, or below all. */
.Loctave:
    movs t, #32
    subs t, t, bits
    rors x, x, t
    movs bits, #2
    lsrs y, x, #8
    lsrs t, y, #4
    beq 1f
    movs bits, #6
    movs y, t
1:
    lsrs t, y, #2
    beq 1f
    adds bits, #2
    movs y, t
1:
    cmp y, #2
    bls 1f
    movs y, #2
1:
    adds bits, bits, y
    subs y, bits, #2
    lsls y, y, #6           /* 32 entries an octave */
    ldr z, [sp, #OUR_CHANNELS]
    ldr z, [z, #AT_ENTRIES]
    adds z, z, y
    mov chords, z
    ldrh y, [z]
    ldrh z, [z, #2]
    subs z, z, y
    lsrs z, z, bits
    adds z, z, #1
    ldr t, [sp, #OUR_CHANNELS]
    ldr t, [t, #AT_STEPS]
    muls z, t
    lsls z, z, #1
    adds z, z, #3
    lsrs t, z, #16          /* half of what there is: more than a level */
    beq 1f
    movs z, #1
    lsls z, z, #16
1:
    muls z, max
    movs t, #65
    lsls t, t, #2
    adds z, z, t
    lsls z, z, #7
    mov margin, z
    cmp x, #128
    blo .Ldark
    rors x, x, bits
    uxth y, x
    subs y, y, #32
    lsrs x, x, #16
    b .Lchord

.Ldark:
    ldr t, .Lslope
    muls x, t
    adds x, x, #128
    lsrs x, x, #8
    lsls x, x, #8
    b .Lfine

    .balign 4
.Lbias:
    .word (16 << 19) - (128 * 255 + 257)
.Lone:
    .word 65535
.Lslope:
    .word 3308
#endif
