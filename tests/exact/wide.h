/* SPDX-License-Identifier: MIT
 * WIDE: before a function of loops over arrays, which take a third of the time where the processor has AVX2. */
#ifndef GLINT_TEST_WIDE_H
#define GLINT_TEST_WIDE_H

#if defined __x86_64__ && defined __GNUC__
#define WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WIDE
#endif

#endif
