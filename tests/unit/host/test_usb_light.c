/* SPDX-License-Identifier: MIT
 * A board that shades: what its faults mean to the stream, and which board is waited for. With stand-ins for its USB. */
#include <stdio.h>

#include "unit.h"

#if GLINT_WITH_USB
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sinks/usb/bulk.h"
#include "sinks/usb/choose.h"

static int fake_init(libusb_context **context)
{
    *context = NULL;
    return 0;
}
static void fake_exit(libusb_context *context)
{
    (void)context;
}
#define libusb_init fake_init
#define libusb_exit fake_exit

static struct usb_device there[2]; /* what is plugged in */
static unsigned there_count, looks;

/* Another one is plugged in at first, and this one at the third look. */
static void fake_find(libusb_context *libusb, const struct usb_options *options, double until, struct usb_found *found)
{
    (void)libusb, (void)until;
    *found = (struct usb_found){0};
    looks++;
    for (unsigned i = 0; i < there_count; i++)
        if ((!options->id || options->id == there[i].id) &&
            (!options->serial || strcmp(options->serial, there[i].serial) == 0) && (i == 0 || looks >= 3))
            found->devices[found->count++] = there[i];
}
static void fake_found_free(struct usb_found *found)
{
    (void)found;
}
static enum usb_opened fake_open(struct usb_port *port, libusb_device *device, uint8_t interface, bool *detached,
                                 struct gud_problem *problem)
{
    (void)port, (void)device, (void)interface, (void)detached, (void)problem;
    return USB_OPENED;
}
static void fake_close(struct usb_port *port, bool detached)
{
    (void)port, (void)detached;
}
static int fake_prepare(struct usb_port *port)
{
    (void)port;
    return 0;
}
static void fake_bulk_free(struct usb_port *port)
{
    (void)port;
}
static int bulk_fault;
static int fake_start(struct usb_port *port, const uint8_t *data, size_t bytes)
{
    (void)port, (void)data, (void)bytes;
    return bulk_fault;
}
static int fake_wait(struct usb_port *port)
{
    (void)port;
    return 0;
}
static void fake_pause(long ms)
{
    (void)ms;
}

static int answer(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes);
#define usb_find fake_find
#define usb_found_free fake_found_free
#define usb_port_open fake_open
#define usb_port_close fake_close
#define usb_bulk_prepare fake_prepare
#define usb_bulk_free fake_bulk_free
#define usb_bulk_start fake_start
#define usb_bulk_wait fake_wait
#define usb_pause_ms fake_pause
#define usb_control answer
#include "../../../host/sinks/usb/light.c"

static int to_mesh, to_status; /* its answers to these two requests: bytes, or a fault */

static int answer(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes)
{
    (void)context, (void)in, (void)value;
    if (request == LIGHT_GET_DESCRIPTOR)
        light_descriptor_pack(data, &(struct light_descriptor){8, 4});
    if (request == LIGHT_GET_STATUS && to_status > 0)
        data[0] = GUD_OK;
    return request == LIGHT_GET_MESH ? to_mesh : request == LIGHT_GET_STATUS ? to_status : bytes;
}

static struct light_sink light = {
    .link = {.context = &light.port, .control = answer}, .sink = {.width = 8, .height = 4}, .name = "the board"};

static void plug(unsigned i, const char *serial)
{
    there[i] = (struct usb_device){.id = 0x12090001, .state = USB_DISPLAY, .interface_count = 1};
    strcpy(there[i].serial, serial);
    there_count = i + 1;
}

/* What the sink answers to a light, or 99 where the program ended. */
static int result_of_a_light(void)
{
    fflush(NULL);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        size_t bytes;
        _exit(freopen("/dev/null", "w", stderr) ? (int)send_light(&light.sink, (int32_t[]){0, 0, 1}, &bytes) : 98);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    return WEXITSTATUS(status);
}

enum { ENDED = 1 }; /* by fail(): none of the two results below */

static void a_transfer_that_fails_because_the_board_is_unplugged_is_waited_out(void **state)
{
    (void)state;
    usb_options = (struct usb_options){.wait = true};
    bulk_fault = GUD_LINK_ERROR;
    to_status = GUD_LINK_GONE;
    assert_int_equal(result_of_a_light(), SINK_GONE);
    to_status = 1;
    assert_int_equal(result_of_a_light(), ENDED);
    bulk_fault = 0;
    assert_int_equal(result_of_a_light(), SINK_SENT);
}

static void only_a_board_that_refuses_to_tell_holds_no_mesh(void **state)
{
    (void)state;
    struct light_mesh mesh;
    bool holds_one;
    usb_options = (struct usb_options){.wait = true};
    to_mesh = LIGHT_MESH_BYTES;
    assert_int_equal(find_mesh(&light.sink, &mesh, &holds_one), SINK_SENT);
    assert_true(holds_one);
    to_mesh = GUD_LINK_STALL;
    assert_int_equal(find_mesh(&light.sink, &mesh, &holds_one), SINK_SENT);
    assert_false(holds_one);
    to_mesh = GUD_LINK_GONE;
    assert_int_equal(find_mesh(&light.sink, &mesh, &holds_one), SINK_GONE);
}

static void wait_waits_for_the_board_that_was_unplugged_not_for_another(void **state)
{
    (void)state;
    const struct sink_wish wish = {.format = -1};
    usb_options = (struct usb_options){.wait = true};
    to_status = 1;
    plug(0, "left");
    looks = 0;
    struct sink *sink = usb_shader.open(&wish);
    assert_non_null(sink);
    assert_int_equal(looks, 1);
    usb_shader.close(sink);
    plug(0, "right");
    plug(1, "left");
    looks = 0;
    sink = usb_shader.open(&wish);
    assert_non_null(sink);
    assert_int_equal(looks, 3);
    usb_shader.close(sink);
}
int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_transfer_that_fails_because_the_board_is_unplugged_is_waited_out),
        cmocka_unit_test(only_a_board_that_refuses_to_tell_holds_no_mesh),
        cmocka_unit_test(wait_waits_for_the_board_that_was_unplugged_not_for_another),
    };
    return cmocka_run_group_tests_name("usb light", tests, NULL, NULL);
}
#else
int main(void)
{
    puts("ok 1 - usb light # SKIP it is for libusb");
    return 0;
}
#endif
