/* SPDX-License-Identifier: MIT
 * A long stream takes no more memory and no more descriptors than a short one. (`make soak` measures hours.) */
#include <sys/resource.h>

#include "files.h"

/* The most memory that the command takes at once, in KB, with no more than `descriptors` open. */
static long most_memory_kb(const char *command, unsigned descriptors)
{
    struct rusage usage;
    int status;
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        setrlimit(RLIMIT_NOFILE, &(struct rlimit){descriptors, descriptors});
        setenv("OMP_NUM_THREADS", "1", 1);
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    assert_int_equal(wait4(pid, &status, 0, &usage), pid);
    if (status != 0)
        fail_msg("%s: status %d", command, status);
    return usage.ru_maxrss;
}

static void a_stream_of_700_frames_takes_what_one_of_70_does(void **state)
{
    (void)state;
    enum { DESCRIPTORS = 16, GROWTH_MAX_KB = 300 };
    static const char *const sinks[] = {
        "none --stats",
        "panel -o out/panel.png",
        "ppm -o out/%03d.ppm",
        "raw",
        "y4m -o -",
#if GLINT_WITH_GIF
        "gif -o out/all.gif",
#endif
    };
    for (size_t i = 0; i < sizeof sinks / sizeof *sinks; i++) {
        long kb[2];
        for (unsigned k = 0; k < 2; k++) {
            char line[300];
            snprintf(line, sizeof line, "exec $GLINT stream coin --size 40x30 --frames %u --to %s >.out", k ? 700 : 70,
                     sinks[i]);
            kb[k] = most_memory_kb(line, DESCRIPTORS);
        }
#if !defined(__SANITIZE_ADDRESS__) /* which keeps what is freed */
        if (kb[1] - kb[0] > GROWTH_MAX_KB)
            fail_msg("--to %s: %ld KB after 70 frames, %ld KB after 700", sinks[i], kb[0], kb[1]);
#endif
        assert_quiet("rm -rf out && mkdir out");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stream_of_700_frames_takes_what_one_of_70_does),
    };
    return cmocka_run_group_tests(tests, make_maps, scratch_remove);
}
