/* SPDX-License-Identifier: MIT
 * The registers' header as C firmware uses it, on a bus of its user's. */
#include "unit_registers.h"

#define GLINT_UNIT_WRITE(unit, offset, value) bus_write((unit) + (offset), value)
#define GLINT_UNIT_READ(unit, offset) bus_read((unit) + (offset))
#include "glint_span_unit.h"

void unit_set_shader(const struct glint_shader *shader)
{
    glint_unit_set_shader(0, shader);
}

void unit_shade_span(const struct glint_span *span)
{
    glint_unit_shade_span(0, span);
}
