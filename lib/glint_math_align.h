/* SPDX-License-Identifier: MIT
 * Internal. Is an address or a stride a multiple of what a type requires? On 8-bit machines, whose compilers place
 * everything anywhere, that is 1. */
#ifndef GLINT_MATH_ALIGN_H
#define GLINT_MATH_ALIGN_H

#include <stddef.h>
#include <stdint.h>

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

#endif
