/* SPDX-License-Identifier: MIT
 * What the files of the sweep share. */
#ifndef GLINT_SWEEP_PARTS_H
#define GLINT_SWEEP_PARTS_H

#include "glint.h"
#include "sweep.h"

enum { MODEL_COUNT = GLINT_CAYLEY + 1 };
enum { W = 13, H = 3, LINE = 3 * W + 2 }; /* of a rectangle */

/* Into the hash. */
void sweep_add_bytes(const uint8_t *bytes, uint16_t count);
void sweep_add(uint32_t value);
void sweep_add_tables(const struct sweep_size *size);

/* One call a statement everywhere: within one, the compiler chooses the order. */
uint32_t sweep_random_bits(void);
int32_t sweep_random_within(int32_t limit); /* -limit..limit */
void sweep_random_shader(struct glint_shader *shader, unsigned model);
void sweep_random_normal(struct glint_vec *normal, const struct glint_light *light);

#endif
