/* SPDX-License-Identifier: MIT
 * glint_span_unit.h's functions compiled as C, for a test in C++ that is their bus. */
#ifndef UNIT_REGISTERS_H
#define UNIT_REGISTERS_H

#include "glint.h"

#ifdef __cplusplus
extern "C" {
#endif

void bus_write(uintptr_t address, uint32_t value);
uint32_t bus_read(uintptr_t address);

enum glint_err unit_set_material(const struct glint_material *material, const struct glint_output *output);
enum glint_err unit_shade_span(const struct glint_span *span);

#ifdef __cplusplus
}
#endif

#endif
