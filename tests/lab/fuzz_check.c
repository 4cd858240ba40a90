/* SPDX-License-Identifier: MIT
 * Fuzzes what looks at a PLY, an STL or a glTF before libassimp does: it says what is wrong, or nothing, and reads no byte beyond. Input:
 * the file. */
#include <string.h>
#include <strings.h>

#include "fuzz.h"
#include "mesh/gltf_check.h"
#include "mesh/ply_check.h"
#include "mesh/stl_check.h"

static bool begins(const char *file, size_t len, const char *word)
{
    return len >= strlen(word) && strncasecmp(file, word, strlen(word)) == 0;
}

/* Of what libassimp is given: a binary file ends where its facets do. */
static const char *check_stl(char *file, size_t len)
{
    const size_t binary = stl_binary_len(file, len);
    check(binary <= len && (!binary || stl_binary_len(file, binary) == binary));
    return stl_check(file, len);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    size_t len = size;
    bool has_corner_uv;
    uint64_t triangles = UINT64_MAX;
    char *file = (char *)next_bytes(&input, &len);
    const bool is_stl = begins(file, len, "solid") || begins(file, len, " ") || stl_binary_len(file, len);
    const char *wrong = begins(file, len, "ply") ? ply_check(file, &len, &has_corner_uv)
                        : is_stl                 ? check_stl(file, len)
                                                 : gltf_check(file, len, &triangles);
    free(file);
    if (wrong)
        check(strlen(wrong) > 9 && strlen(wrong) < 256); /* as much as a head's message has room for */
    else if (triangles != UINT64_MAX)
        check(triangles <= (uint64_t)size << 40);
    return 0;
}
