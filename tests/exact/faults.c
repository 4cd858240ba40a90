/* SPDX-License-Identifier: MIT
 * What test_bounds links in the place of the library's (-Wl,--wrap): right unless GLINT_FAULT is its fault's name. */
#include <stdlib.h>
#include <string.h>

#include "glint_math_vector.h"

static bool fault_is(const char *name)
{
    const char *fault = getenv("GLINT_FAULT");
    return fault && !strcmp(fault, name);
}

/* Wrong in the first entry. */
enum { RECIPROCALS = 64 };
extern const uint8_t __real_glint_reciprocals[RECIPROCALS];
uint8_t __wrap_glint_reciprocals[RECIPROCALS];

/* Directions that are off by more than is said of them. */
bool __real_glint_unit_near(struct glint_unit *unit, const int32_t v[3]);
bool __wrap_glint_unit_near(struct glint_unit *unit, const int32_t v[3]);
void __real_glint_unit_front(int32_t h_q30[3], const int32_t l_q30[3]);
void __wrap_glint_unit_front(int32_t h_q30[3], const int32_t l_q30[3]);
static int32_t unit_more, front_more;

__attribute__((constructor)) static void make_faults(void)
{
    memcpy(__wrap_glint_reciprocals, __real_glint_reciprocals, RECIPROCALS);
    if (fault_is("reciprocal"))
        __wrap_glint_reciprocals[0] -= 1;
    if (fault_is("far-reciprocal"))
        __wrap_glint_reciprocals[0] -= 8;
    unit_more = fault_is("unit") ? GLINT_UNIT_SLACK : 0;
    front_more = fault_is("front") ? GLINT_UNIT_FRONT : 0;
}

bool __wrap_glint_unit_near(struct glint_unit *unit, const int32_t v[3])
{
    const bool is_long = __real_glint_unit_near(unit, v);
    for (int i = 0; is_long && i < 3; i++)
        unit->unit_q30[i] += unit_more;
    return is_long;
}

void __wrap_glint_unit_front(int32_t h_q30[3], const int32_t l_q30[3])
{
    __real_glint_unit_front(h_q30, l_q30);
    for (int i = 0; i < 3; i++)
        h_q30[i] += front_more;
}
