/* SPDX-License-Identifier: MIT
 * What the files of the checks share. */
#ifndef CONFORMANCE_PARTS_H
#define CONFORMANCE_PARTS_H

#include "conformance.h"
#include "glint.h"

enum { W = 13, H = 3, LINE = 3 * W + 2 }; /* of a rectangle */

/* Into the hash. */
void conform_add_bytes(const uint8_t *bytes, uint16_t count);
void conform_add(uint32_t value);

/* One call a statement everywhere: within one, the compiler chooses the order. */
uint32_t conform_random_bits(void);
int32_t conform_random_within(int32_t limit); /* -limit..limit */
void conform_random_vector(int32_t v[3], int32_t limit);
void conform_random_shader(struct glint_shader *shader, unsigned model);
void conform_random_normal(struct glint_vec *normal, const struct glint_light *light);

/* The checks. */
void conform_model(unsigned check, const struct conformance_size *size);
void conform_lobes(const struct conformance_size *size);
void conform_every_c(unsigned check);
void conform_vectors(const struct conformance_size *size);
void conform_srgb(const struct conformance_size *size);
void conform_scenes(unsigned format, const struct conformance_size *size);
void conform_small(const struct conformance_size *size);
void conform_colours(const struct conformance_size *size);
void conform_albedo(const struct conformance_size *size);

#endif
