/* SPDX-License-Identifier: MIT
 * Fuzzes the checkpoint of a search, the JSON that glint reads: it is refused, or says what a search of these options can have done. */
#include <math.h>
#include <sys/mman.h>
#include <unistd.h>

#include "paper/search_checkpoint.h"
#include "unwind.h"

static void read_checkpoint(void *of)
{
    static const double lists[2][2] = {{1, 2}, {.5, 4}}, shininess[] = {1, 60};
    const struct search_options options = {.exponents = {lists[0], 2},
                                           .coefficients = {lists[1], 2},
                                           .shininess = {shininess, 2},
                                           .angles = 90,
                                           .best = 4};
    uint64_t done = 0;
    struct best best;
    best_init(&best, options.best);
    checkpoint_read(of, &options, &done, &best);
    check((double)done <= search_first_size(&options) && best.count <= best.room);
    for (size_t i = 0; i < best.count; i++)
        check(best.entries[i].sum >= 0 && isfinite(best.entries[i].sum) && best.entries[i].index < 256);
    best_free(&best);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static int file = -1;
    static char path[64];
    if (file < 0) {
        file = memfd_create("checkpoint", MFD_CLOEXEC);
        snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    }
    check(ftruncate(file, 0) == 0 && pwrite(file, data, size, 0) == (ssize_t)size);
    unwind_run(read_checkpoint, path);
    return 0;
}
