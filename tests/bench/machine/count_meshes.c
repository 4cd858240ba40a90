/* SPDX-License-Identifier: MIT
 * Counts pictures of the teapot. Records: mesh; name; n; count of a picture. */
#include "clock.h"
#include "mesh.h"

#include "machine.h"

static void count_picture(const char *name, enum mesh_way way, unsigned which)
{
    int error = mesh_begin(way);
    const uint32_t start = clock_now();
    error |= mesh_frame(which);
    for (unsigned y = 0; y < MESH_HEIGHT; y += MESH_LINES)
        error |= mesh_strip(y);
    const uint32_t counted = clock_now() - start;
    print_text(error ? "error" : "mesh");
    print_text(name);
    print_number(60);
    print_number(counted);
    print_end();
}

bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    clock_begin();
    print_calibration();
    count_picture("mesh teapot", MESH_BY_TABLES, 0);
    count_picture("mesh teapot split", MESH_BY_TABLES, 1);
    count_picture("mesh teapot exact", MESH_EXACT, 0);
    count_picture("mesh teapot split exact", MESH_EXACT, 1);
    count_picture("mesh teapot gouraud", MESH_GOURAUD, 0);
    count_picture("mesh teapot split gouraud", MESH_GOURAUD, 1);
    return true;
}
