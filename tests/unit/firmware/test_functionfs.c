/* SPDX-License-Identifier: MIT
 * glint-gadget's loop over requests, with sockets instead of FunctionFS's files. */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "unit.h"

/* The port's file calls these instead. */
static int fake_open(const char *path, int flags);
static int fake_poll(struct pollfd *files, unsigned long count, int ms);
static ssize_t fake_read(int file, void *bytes, size_t count);
static int fake_timedwait(pthread_cond_t *cond, pthread_mutex_t *mutex, const struct timespec *until);
#define open fake_open
#define poll fake_poll
#define read fake_read
#define pthread_cond_timedwait fake_timedwait
#include "../../../firmware/ports/linux/functionfs.c"
#undef open
#undef poll
#undef read
#undef pthread_cond_timedwait
#include "../../../firmware/ports/linux/message.c"

static void (*plugged)(void);
bool configfs_plug(void)
{
    if (plugged)
        plugged();
    return true;
}
bool configfs_unplug(void)
{
    return true;
}
bool configfs_is_lost(void)
{
    return false;
}
const char *configfs_udc(void)
{
    return "none";
}

static int kernel[2]; /* the other ends of ep0 and ep1 */

static int fake_open(const char *path, int flags)
{
    int ends[2];
    const bool is_bulk = strstr(path, "ep1") != NULL;
    assert_true(flags & O_RDWR);
    assert_int_equal(socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends), 0);
    kernel[is_bulk] = ends[1];
    return ends[0];
}

static bool read_fails; /* of bulk, once */
static void (*failed)(void);
static ssize_t fake_read(int file, void *bytes, size_t count)
{
    if (file != bulk_out || !read_fails)
        return read(file, bytes, count);
    read_fails = false;
    failed();
    errno = EPROTO;
    return -1;
}

/* Time that passes while bytes are awaited would tell how busy the machine is: then it stands still. */
static unsigned awaited;
static void (*waits)(void);
static int fake_timedwait(pthread_cond_t *cond, pthread_mutex_t *mutex, const struct timespec *until)
{
    if (waits)
        waits();
    return awaited ? pthread_cond_wait(cond, mutex) : pthread_cond_timedwait(cond, mutex, until);
}

static unsigned stale;

/* As some kernels (6.1) do: ep0 is ready, and then its event is gone. After that a signal ends the run. */
static int fake_poll(struct pollfd *files, unsigned long count, int ms)
{
    if (stale == 3)
        kill(getpid(), SIGTERM);
    if (stale++ >= 3)
        return poll(files, count, ms);
    files[0].revents = POLLIN;
    files[1].revents = 0;
    return 1;
}

static int no_setup(void *context, const struct gud_setup *setup, uint8_t *reply)
{
    (void)context, (void)setup, (void)reply;
    return GUD_STALL;
}
static bool no_set(void *context, const struct gud_setup *setup, const uint8_t *data)
{
    (void)context, (void)setup, (void)data;
    return false;
}
static uint32_t expects_nothing(void *context)
{
    (void)context;
    return 0;
}
static void no_bulk(void *context, const uint8_t *bytes, size_t count)
{
    (void)context, (void)bytes, (void)count;
}
static void no_event(void *context, enum usb_event event)
{
    (void)context, (void)event;
}
static void no_dump(void *context)
{
    (void)context;
}

static void an_event_that_is_gone_when_it_is_read_does_not_hold_up_signals(void **state)
{
    (void)state;
    const struct usb_function silent = {no_setup, no_set, expects_nothing, no_bulk, no_event, NULL};
    functionfs_hold_signals();
    functionfs_run("/nowhere", &silent, false, no_dump);
    assert_true(stale > 3);
}

/* ---- a host that asks for the next rectangle while bytes of this one go on coming, few at a time ---- */

enum { BYTES_MAX = 1000000 };
static pthread_t host;
static volatile bool is_asked, is_in_time;

static void tell(struct usb_functionfs_event event)
{
    assert_int_equal(send(kernel[0], &event, sizeof event, 0), sizeof event);
}

static void *trickle(void *nothing)
{
    tell((struct usb_functionfs_event){.type = FUNCTIONFS_ENABLE});
    assert_int_equal(send(kernel[1], "", 1, 0), 1);
    tell((struct usb_functionfs_event){.type = FUNCTIONFS_SETUP,
                                       .u.setup = {.bRequestType = GUD_TYPE_OUT, .bRequest = GUD_SET_BUFFER}});
    for (unsigned count = 0; count < BYTES_MAX && !is_asked;) {
        const bool is_taken = send(kernel[1], "", 1, MSG_DONTWAIT) == 1;
        count += is_taken;
        if (!is_taken)
            sched_yield();
    }
    is_in_time = is_asked;
    kill(getpid(), SIGTERM);
    return nothing;
}

static void begin_to_trickle(void)
{
    assert_int_equal(pthread_create(&host, NULL, trickle, NULL), 0);
}

static int note_setup(void *context, const struct gud_setup *setup, uint8_t *reply)
{
    is_asked |= setup->request == GUD_SET_BUFFER;
    return no_setup(context, setup, reply);
}
static uint32_t expects_many(void *context)
{
    (void)context;
    return 1 << 20;
}

static void bytes_that_go_on_coming_do_not_hold_up_the_next_rectangle(void **state)
{
    (void)state;
    const struct usb_function endless = {note_setup, no_set, expects_many, no_bulk, no_event, NULL};
    plugged = begin_to_trickle;
    ending = false;
    functionfs_run("/nowhere", &endless, false, no_dump);
    pthread_join(host, NULL);
    assert_true(is_in_time);
}

/* ---- rectangles that end otherwise ---- */

static uint32_t expects_awaited(void *context)
{
    (void)context;
    return awaited;
}

static void begin_with_a_byte(void)
{
    tell((struct usb_functionfs_event){.type = FUNCTIONFS_ENABLE});
    assert_int_equal(send(kernel[1], "", 1, 0), 1);
}

/* The rest is under way when the program is about to end. */
static void send_the_rest(void)
{
    waits = NULL;
    for (unsigned i = awaited; i > 0; i--)
        assert_int_equal(send(kernel[1], "", 1, 0), 1);
}

static void end_within_the_rectangle(void *context, const uint8_t *bytes, size_t count)
{
    (void)context, (void)bytes;
    if (awaited == 5)
        kill(getpid(), SIGTERM);
    awaited -= (unsigned)count;
}

static void a_rectangle_that_is_under_way_at_the_end_is_taken_whole(void **state)
{
    (void)state;
    const struct usb_function ends = {no_setup, no_set, expects_awaited, end_within_the_rectangle, no_event, NULL};
    awaited = 5;
    plugged = begin_with_a_byte;
    waits = send_the_rest;
    ending = false;
    functionfs_run("/nowhere", &ends, false, no_dump);
    waits = NULL;
    assert_int_equal(awaited, 0);
}

static unsigned got;

static void only_enable(void)
{
    tell((struct usb_functionfs_event){.type = FUNCTIONFS_ENABLE});
}

static void announce_another(void)
{
    tell((struct usb_functionfs_event){.type = FUNCTIONFS_SETUP,
                                       .u.setup = {.bRequestType = GUD_TYPE_OUT, .bRequest = GUD_SET_BUFFER}});
}

static int send_for_it(void *context, const struct gud_setup *setup, uint8_t *reply)
{
    assert_int_equal(send(kernel[1], "", 1, 0), 1);
    kill(getpid(), SIGTERM);
    return no_setup(context, setup, reply);
}

static void count_bulk(void *context, const uint8_t *bytes, size_t count)
{
    (void)context, (void)bytes;
    got += (unsigned)count;
    awaited = 0;
}

static void after_a_read_that_failed_the_next_rectangle_is_read(void **state)
{
    (void)state;
    const struct usb_function next = {send_for_it, no_set, expects_awaited, count_bulk, no_event, NULL};
    awaited = 1;
    read_fails = true;
    failed = announce_another;
    plugged = only_enable;
    ending = false;
    functionfs_run("/nowhere", &next, false, no_dump);
    assert_int_equal(got, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_event_that_is_gone_when_it_is_read_does_not_hold_up_signals),
        cmocka_unit_test(bytes_that_go_on_coming_do_not_hold_up_the_next_rectangle),
        cmocka_unit_test(a_rectangle_that_is_under_way_at_the_end_is_taken_whole),
        cmocka_unit_test(after_a_read_that_failed_the_next_rectangle_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
