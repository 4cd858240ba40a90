/* SPDX-License-Identifier: MIT
 * Every public function over a spread of arguments, as one number: equal numbers mean equal results. */
#ifndef GLINT_SWEEP_H
#define GLINT_SWEEP_H

#include <stdint.h>

/* 0: without the COLOUR tables, for machines whose RAM is less than their 20 KB. */
#ifndef SWEEP_COLOUR
#define SWEEP_COLOUR 1
#endif

struct sweep_size {
    uint16_t n_stride; /* of the list of shininess values */
    uint16_t c_step;   /* Q16.16 */
    uint16_t t_count;  /* random arguments a model and shininess */
    uint8_t q_step;
    uint8_t scenes; /* random rectangles and spans a format, space, dither and model */
    uint16_t random_vectors;
};
extern const struct sweep_size sweep_whole; /* for a desktop: some millions of values */
extern const struct sweep_size sweep_small; /* for an emulated microcontroller: some thousands */

uint64_t sweep(const struct sweep_size *size);      /* FNV-1a of all results */
void sweep_print(uint64_t hash, void (*put)(char)); /* 16 digits and a new line */

#endif
