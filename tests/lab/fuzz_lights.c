/* SPDX-License-Identifier: MIT
 * Fuzzes the lines of `glint stream --lights -`: each is a direction with which a paint can be lit, or the program ends with a reason. */
#include <math.h>

#include "stream/light.h"
#include "unwind.h"

static void read_lines(void *of)
{
    (void)of;
    struct stream_options options = {.lights = "-", .orbit = NAN};
    struct shading *shading = &options.look.shading;
    *shading = (struct shading){.model = GLINT_MSH, .n = 60, .q = 8, .view = {0, 0, 1}, .lamp_count = 1};
    shading->lamps[0] = (struct lamp){.kind = LAMP_DIRECTIONAL, .direction = {-1, 1, 1}, .color = {1, 1, 1}};
    struct light_path *path = light_path_new(&options);
    light_path_start(path, &options, shading, 32, 32);
    for (double seconds = 0; light_path_next(path, seconds, shading); seconds++) {
        struct glint_light light;
        check(shading_light(shading, 0, &light) == GLINT_OK);
        for (int k = 0; k < 3; k++)
            check(isfinite(shading->lamps[0].direction[k]));
    }
    light_path_free(path);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    FILE *const before = stdin;
    stdin = unwind_stream(data, size);
    unwind_run(read_lines, NULL);
    fclose(stdin);
    stdin = before;
    return 0;
}
