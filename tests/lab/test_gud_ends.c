/* SPDX-License-Identifier: MIT
 * However glint-gadget ends, it leaves no gadget and no mount behind. In the environment: GADGET, the program. */
#include "unit.h"

#include "lab.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define FOLDER "/sys/kernel/config/usb_gadget/glint"
#define ANOTHER "/sys/kernel/config/usb_gadget/another"
#define MOUNT "/dev/ffs-glint"
#define OPTIONS "--size 61x47 --formats rgb565"

static struct process gadget;

static void assert_nothing_is_left(const char *after)
{
    if (access(FOLDER, F_OK) == 0 || access(MOUNT, F_OK) == 0)
        fail_msg("%s: a gadget is left", after);
}

/* In the middle of making the gadget, when most of it is still to come. */
static void interrupted_while_it_starts_it_leaves_nothing(void **state)
{
    (void)state;
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    for (unsigned turn = 0; turn < 8; turn++) {
        process_start(&gadget, "$GADGET " OPTIONS);
        for (unsigned i = 0; access(FOLDER, F_OK) != 0; i++) {
            assert_true(i < 100000);
            nanosleep(&(struct timespec){.tv_nsec = 100000}, NULL);
        }
        assert_int_equal(process_end(&gadget, signals[turn % 4]), 0);
        assert_nothing_is_left(strsignal(signals[turn % 4]));
    }
}

/* Its messages go to a pipe whose reader leaves after the first line. */
static void that_nobody_reads_its_messages_does_not_end_it(void **state)
{
    (void)state;
    process_start(&gadget, "sh -c 'mkfifo /run/messages; head -n 1 /run/messages & "
                           "exec $GADGET " OPTIONS " -v >/run/messages 2>&1'");
    wait_for_file("/dev/fb0"); /* the kernel has asked for this and that, and each request is a message */
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
    assert_nothing_is_left("messages that nobody reads");
    unlink("/run/messages");
}

/* Else a message would be an answer to the host. */
static void closed_streams_are_no_endpoints(void **state)
{
    (void)state;
    process_start(&gadget, "sh -c 'exec $GADGET " OPTIONS " <&- >&- 2>&-'");
    wait_for_file("/dev/fb0");
    for (int i = STDIN_FILENO; i <= STDERR_FILENO; i++) {
        char path[64], file[256] = "";
        snprintf(path, sizeof path, "/proc/%d/fd/%d", (int)gadget.pid, i);
        assert_true(readlink(path, file, sizeof file - 1) > 0);
        assert_string_equal(file, "/dev/null");
    }
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
    assert_nothing_is_left("closed streams");
}

static void a_last_picture_that_cannot_be_written_is_told_by_the_status(void **state)
{
    (void)state;
    assert_int_equal(run("mkdir /run/pictures"), 0);
    process_start(&gadget, "$GADGET " OPTIONS " -o /run/pictures/last.png");
    process_wait_for(&gadget, "on the bus");
    wait_for_file("/dev/fb0");
    assert_int_equal(run("rm -r /run/pictures"), 0);
    assert_int_equal(process_end(&gadget, SIGTERM), 1);
    process_wait_for(&gadget, "glint-gadget: /run/pictures/last.png: No such file or directory");
    assert_nothing_is_left("a picture that could not be written");
}

/* Of another program, with a function that is not ours; the folders are named as this one names its own. */
static void a_gadget_of_the_same_name_is_left_alone(void **state)
{
    (void)state;
    static const char *const parts[] = {"functions/ffs.another", "strings/0x409", "configs/c.1",
                                        "configs/c.1/strings/0x409"};
    enum { PARTS = sizeof parts / sizeof *parts };
    assert_int_equal(run("mountpoint -q /sys/kernel/config || mount -t configfs none /sys/kernel/config"), 0);
    for (unsigned i = 0; i < PARTS; i++)
        assert_int_equal(run("mkdir -p " FOLDER "/%s", parts[i]), 0);
    process_start(&gadget, "$GADGET " OPTIONS);
    process_wait_for(&gadget, FOLDER ": File exists; it is not this program's: give another --name");
    assert_int_equal(process_end(&gadget, 0), 1);
    for (unsigned i = 0; i < PARTS; i++)
        assert_int_equal(run("test -d " FOLDER "/%s", parts[i]), 0);
    for (unsigned i = PARTS; i--;)
        assert_int_equal(run("rmdir " FOLDER "/%s", parts[i]), 0);
    assert_int_equal(run("rmdir " FOLDER), 0);
}

/* Of another gadget, whose function has the same name. */
static void a_mount_of_another_program_is_left_alone(void **state)
{
    (void)state;
    assert_int_equal(run("mountpoint -q /sys/kernel/config || mount -t configfs none /sys/kernel/config"), 0);
    assert_int_equal(run("mkdir -p " ANOTHER "/functions/ffs.glint " MOUNT " && mount -t functionfs glint " MOUNT), 0);
    process_start(&gadget, "$GADGET " OPTIONS);
    assert_int_equal(process_end(&gadget, 0), 1);
    assert_int_equal(run("mountpoint -q " MOUNT), 0);
    assert_int_equal(access(FOLDER, F_OK), -1);
    assert_int_equal(run("umount " MOUNT " && rmdir " MOUNT " " ANOTHER "/functions/ffs.glint " ANOTHER), 0);
}

/* Killed after its first step, and before its last. */
static void what_one_that_was_killed_left_does_not_hold_up_the_next(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        assert_int_equal(run("mkdir " FOLDER), 0);
        if (i)
            assert_int_equal(run("echo 0x1d50 >" FOLDER "/idVendor"), 0);
        process_start(&gadget, "$GADGET " OPTIONS);
        process_wait_for(&gadget, "on the bus");
        assert_int_equal(process_end(&gadget, SIGTERM), 0);
        assert_nothing_is_left("one that was killed");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(interrupted_while_it_starts_it_leaves_nothing, lab_clean),
        cmocka_unit_test_teardown(that_nobody_reads_its_messages_does_not_end_it, lab_clean),
        cmocka_unit_test_teardown(closed_streams_are_no_endpoints, lab_clean),
        cmocka_unit_test_teardown(a_last_picture_that_cannot_be_written_is_told_by_the_status, lab_clean),
        cmocka_unit_test_teardown(a_gadget_of_the_same_name_is_left_alone, lab_clean),
        cmocka_unit_test_teardown(a_mount_of_another_program_is_left_alone, lab_clean),
        cmocka_unit_test_teardown(what_one_that_was_killed_left_does_not_hold_up_the_next, lab_clean),
    };
    return cmocka_run_group_tests_name("gud ends", tests, NULL, NULL);
}
