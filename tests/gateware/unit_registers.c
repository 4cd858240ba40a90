/* SPDX-License-Identifier: MIT
 * The registers' header as C firmware uses it, on a bus of its user's. */
#include "unit_registers.h"

#define GLINT_UNIT_WRITE(unit, offset, value) bus_write((unit) + (offset), value)
#define GLINT_UNIT_READ(unit, offset) bus_read((unit) + (offset))
#include "glint_span_unit.h"

enum glint_err unit_set_material(const struct glint_material *material, const struct glint_output *output)
{
    return glint_unit_set_material(0, material, output);
}

enum glint_err unit_shade_span(const struct glint_span *span)
{
    return glint_unit_shade_span(0, span);
}
