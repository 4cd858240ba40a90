/* SPDX-License-Identifier: MIT
 * libfixmath over an array. */
#include "../fixmath.c"
#include "methods.h"

#define METHOD(name, peer)                                                                                             \
    void name(uint32_t n, const void *restrict in, void *restrict out, size_t count)                                   \
    {                                                                                                                  \
        const uint32_t *c = in;                                                                                        \
        uint32_t *f = out;                                                                                             \
        for (size_t i = 0; i < count; i++)                                                                             \
            f[i] = peer(n, c[i]);                                                                                      \
    }

METHOD(fixmath_msh, peer_msh_fixmath)
METHOD(fixmath_schlick, peer_schlick_fixmath)
METHOD(fixmath_blinn, peer_blinn_fixmath)
