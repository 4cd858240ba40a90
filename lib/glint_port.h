/* SPDX-License-Identifier: MIT
 * Internal. Where machines differ: assembly in the place of C, alignment, constants that are not in the address space. */
#ifndef GLINT_PORT_H
#define GLINT_PORT_H

/* 1: cortex_m0plus_*.S, assembled with the same definition, take the place of the C loops of the same names.
 * Arduino has no flags for a library: there it is 1 for ARMv6-M, unless it is defined. Some cores assemble without -mcpu, which gcc takes
 * for ARMv4T whatever the board. So what is assembled unasked is weak: where C has loops of its own, the linker takes those. */
#ifdef GLINT_CORTEX_M0PLUS_ASM
#define GLINT_CORTEX_M0PLUS_WEAK 0
#elif defined(ARDUINO) && (defined(__ARM_ARCH_6M__) || (defined(__ASSEMBLER__) && defined(__ARM_ARCH_4T__)))
#define GLINT_CORTEX_M0PLUS_ASM 1
#define GLINT_CORTEX_M0PLUS_WEAK 1
#else
#define GLINT_CORTEX_M0PLUS_ASM 0
#define GLINT_CORTEX_M0PLUS_WEAK 0
#endif

/* 1: loops that fuse a source and a paint, in C or assembly. 0: the general way alone, which draws the same pixels. */
#ifndef GLINT_FUSED
#define GLINT_FUSED 1
#endif
#if !GLINT_FUSED
#undef GLINT_CORTEX_M0PLUS_ASM
#define GLINT_CORTEX_M0PLUS_ASM 0
#endif

/* 1: the fused loops of Cortex-M55 and M85 (helium.c), in vectors of 128 bits: where the compiler has Helium (MVE) for integers. */
#if !GLINT_FUSED || !defined(__ARM_FEATURE_MVE) || defined(__ARM_BIG_ENDIAN)
#undef GLINT_HELIUM
#define GLINT_HELIUM 0
#elif !defined(GLINT_HELIUM)
#define GLINT_HELIUM 1
#endif

/* 1: loops of Cortex-M3 and later in Thumb-2, unless GLINT_DSP is set to 0. */
#if GLINT_FUSED && defined(__thumb2__) && !defined(__ARM_BIG_ENDIAN) && (!defined(GLINT_DSP) || GLINT_DSP)
#define GLINT_THUMB2 1
#else
#define GLINT_THUMB2 0
#endif

/* 1: ARMv6-M, where most instructions take eight registers, and where products of 64 bits are functions. */
#if defined(__thumb__) && !defined(__thumb2__)
#define GLINT_THUMB1 1
#else
#define GLINT_THUMB1 0
#endif

/* 1: directions by products of 64 bits, which are one instruction from Cortex-M3 on, unless it is set. They cut less than the products of
 * 32 bits do, so what is said of those holds. 0: products of 32 bits. */
#ifndef GLINT_WIDE
#define GLINT_WIDE GLINT_THUMB2
#endif

/* 1: loops by the DSP extension of Cortex-M4, M7, M33 and later, fused_dsp.c: where the compiler has it, unless it is set. 0: C without it. */
#ifndef GLINT_DSP
#if defined(__ARM_FEATURE_DSP) && defined(__ARM_ARCH_PROFILE) && !defined(__ARM_BIG_ENDIAN)
#if __ARM_FEATURE_DSP && __ARM_ARCH_PROFILE == 'M'
#define GLINT_DSP 1
#endif
#endif
#endif
#ifndef GLINT_DSP
#define GLINT_DSP 0
#endif
#if !GLINT_FUSED || GLINT_HELIUM
#undef GLINT_DSP
#define GLINT_DSP 0
#endif

/* 1: the exact line of RGB565 under MSH, and INT8 normals over COLOUR tables, by loops of fused_riscv.c: where RISC-V has multiplication. 0: by those
 * of any machine. */
#ifndef GLINT_RISCV
#if defined(__riscv_mul) && __riscv_xlen == 32 && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define GLINT_RISCV 1
#else
#define GLINT_RISCV 0
#endif
#endif
#if !GLINT_FUSED || GLINT_HELIUM || GLINT_DSP || GLINT_CORTEX_M0PLUS_ASM
#undef GLINT_RISCV
#define GLINT_RISCV 0
#endif

#ifndef __ASSEMBLER__ /* assembly takes the above alone */

#include <stddef.h>
#include <stdint.h>

/* Is an address or a stride a multiple of what a type requires? On 8-bit machines, whose compilers place everything anywhere, that
 * is 1. */
struct glint_align_16 {
    char before;
    uint16_t at;
};
struct glint_align_32 {
    char before;
    uint32_t at;
};
struct glint_align_pointer {
    char before;
    void *at;
};
#define GLINT_MISALIGNED(address_or_stride, bits)                                                                      \
    ((uintptr_t)(address_or_stride) % offsetof(struct glint_align_##bits, at) != 0)

/* Constants that stay in flash where others are copied to RAM: on AVR, which reads flash with an instruction of its own, and
 * on the ESP8266, which reads flash in aligned words of 32 bits only. Everywhere else GLINT_FLASH is nothing and a read is the
 * value itself.
 *
 *     static const uint8_t steps[4] GLINT_FLASH = {1, 2, 3, 4};
 *     ... GLINT_FLASH_U8(steps[i])
 *
 * A constant of this kind is read by these macros alone. */
#if defined(__AVR__)

#include <avr/pgmspace.h>
#define GLINT_FLASH PROGMEM
#define GLINT_FLASH_U8(value) pgm_read_byte(&(value))
#define GLINT_FLASH_U16(value) pgm_read_word(&(value))
#define GLINT_FLASH_U32(value) pgm_read_dword(&(value))
#define GLINT_FLASH_I64(value) glint_flash_i64(&(value))
#define GLINT_FLASH_POINTER(value) ((__typeof__(value))pgm_read_word(&(value)))
#define GLINT_FLASH_STRUCT(type, value) /* of whole words */                                                           \
    __extension__({                                                                                                    \
        type copy;                                                                                                     \
        memcpy_P(&copy, &(value), sizeof copy);                                                                        \
        copy;                                                                                                          \
    })

static inline int64_t glint_flash_i64(const int64_t *value)
{
    const uint32_t *half = (const uint32_t *)value;
    return (int64_t)((uint64_t)pgm_read_dword(half + 1) << 32 | pgm_read_dword(half));
}

#elif defined(ESP8266) || defined(__ets__)

/* The section's name is that of the linker scripts of the vendor's kits and of Arduino. A switch must not become a table, which
 * would lie in RAM. */
#pragma GCC optimize("no-jump-tables", "no-tree-switch-conversion")
#define GLINT_FLASH __attribute__((section(".irom0.text.glint"), aligned(4)))
#define GLINT_FLASH_U8(value) ((uint8_t)glint_flash_word(&(value)))
#define GLINT_FLASH_U16(value) ((uint16_t)glint_flash_word(&(value)))
#define GLINT_FLASH_U32(value) (value)
#define GLINT_FLASH_I64(value) (value)
#define GLINT_FLASH_POINTER(value) (value)
#define GLINT_FLASH_STRUCT(type, value)                                                                                \
    __extension__({                                                                                                    \
        type copy;                                                                                                     \
        for (unsigned at = 0; at < sizeof copy; at += 4)                                                               \
            ((glint_flash_words *)&copy)[at / 4] = glint_flash_word((const uint8_t *)&(value) + at);                   \
        copy;                                                                                                          \
    })

typedef uint32_t __attribute__((may_alias)) glint_flash_words;

/* The word around it, shifted down; volatile, or the compiler would load the byte alone. */
static inline uint32_t glint_flash_word(const volatile void *value)
{
    const uintptr_t at = (uintptr_t)value;
    return *(const volatile glint_flash_words *)(at & ~(uintptr_t)3) >> (at & 3) * 8;
}

#else

#define GLINT_FLASH
#define GLINT_FLASH_U8(value) (value)
#define GLINT_FLASH_U16(value) (value)
#define GLINT_FLASH_U32(value) (value)
#define GLINT_FLASH_I64(value) (value)
#define GLINT_FLASH_POINTER(value) (value)
#define GLINT_FLASH_STRUCT(type, value) (value)

#endif

#endif

#endif
