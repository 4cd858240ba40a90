/* SPDX-License-Identifier: MIT
 * The registers' header as C firmware uses it, on a bus of its user's. */
#include "unit_registers.h"

#define GLINT_UNIT_WRITE(unit, offset, value) bus_write((unit) + (offset), value)
#define GLINT_UNIT_READ(unit, offset) bus_read((unit) + (offset))
#include "glint_span_unit.h"

enum glint_err unit_set_shader(const struct glint_shader *shader)
{
    return glint_unit_set_shader(0, shader);
}

enum glint_err unit_shade_span(const struct glint_span *span)
{
    return glint_unit_shade_span(0, span);
}
