/* SPDX-License-Identifier: MIT
 * Fuzzes what looks at a PLY or a glTF before libassimp does: it says what is wrong, or nothing, and reads no byte beyond. Input: the file. */
#include <string.h>

#include "fuzz.h"
#include "mesh/gltf_check.h"
#include "mesh/ply_check.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    size_t len = size;
    uint64_t triangles = UINT64_MAX;
    char *file = (char *)next_bytes(&input, &len);
    const char *wrong =
        len > 3 && memcmp(file, "ply", 3) == 0 ? ply_check(file, len) : gltf_check(file, len, &triangles);
    free(file);
    if (wrong)
        check(strlen(wrong) > 9 && strlen(wrong) < 256); /* as much as a head's message has room for */
    else if (triangles != UINT64_MAX)
        check(triangles <= (uint64_t)size << 40);
    return 0;
}
