/* SPDX-License-Identifier: MIT
 * Fuzzes the page's reader of STL: triangles that are whole come of it, or a reason. */
#include <math.h>

#include "../../host/page/module/files.h"
#include "../../host/page/module/gltf.h"
#include "mesh/import.h"
#include "unwind.h"

static struct input file;

const uint8_t *files_mesh(const char *name, size_t *len)
{
    (void)name;
    *len = (size_t)(file.end - file.at);
    return file.at;
}

/* It comes with no OBJ. */
bool files_has_image(const char *name)
{
    (void)name;
    return false;
}

/* The page's own numbers. */
bool gltf_is(const uint8_t *bytes, size_t len)
{
    (void)bytes;
    (void)len;
    return false;
}

struct soup *gltf_soup(const char *name, const double *numbers, bool textures)
{
    (void)name;
    (void)numbers;
    (void)textures;
    abort();
}

static void read_mesh(void *of)
{
    (void)of;
    struct soup *soup = import_soup("a.stl", false, NULL);
    check(soup->face_count && soup->part_count == 1 && soup->is_stl);
    for (size_t i = 0; i < 9 * soup->face_count; i++)
        check(fabs(soup->faces[i / 9].places[i / 3 % 3][i % 3]) < 1e30 && soup->faces[i / 9].part == 0);
    soup_free(soup);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t len = size;
    struct input input = {data, data + size};
    uint8_t *const bytes = next_bytes(&input, &len);
    file = (struct input){bytes, bytes + len};
    unwind_run(read_mesh, NULL);
    free(bytes);
    return 0;
}
