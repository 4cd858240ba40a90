/* SPDX-License-Identifier: MIT
 * A fault that the fuzzer of OBJ is to find. */
#include "fault.h"
#include "mesh/polygon.h"

bool __real_polygon_cut(const double (*places)[3], size_t count, size_t (*triangles)[3]);
bool __wrap_polygon_cut(const double (*places)[3], size_t count, size_t (*triangles)[3]);

/* Names the corner behind the last one. */
bool __wrap_polygon_cut(const double (*places)[3], size_t count, size_t (*triangles)[3])
{
    const bool good = __real_polygon_cut(places, count, triangles);
    if (fault_is("polygon_cut"))
        triangles[count - 3][2] = count;
    return good;
}
