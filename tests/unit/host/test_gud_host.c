/* SPDX-License-Identifier: MIT
 * The host's side of GUD without USB: against the firmware's display, and against displays that lie. */
#include "unit.h"

#include <stdlib.h>
#include <string.h>

#include "gud_device.h"
#include "sinks/gud/choose.h"
#include "sinks/gud/pack.h"

/* ---- an honest display: the firmware's ---- */

enum { WIDTH = 67, HEIGHT = 41, LINE_BYTES = GUD_DEVICE_LINE_BYTES(WIDTH, 4, 3) };

struct honest {
    struct gud_device device;
    struct gud_device_config config;
    uint8_t lines[LINE_BYTES], window[LZ4_BLOCK_REACH];
    uint8_t picture[HEIGHT][WIDTH][3];
    struct glint_box box;
    unsigned line;
    bool on;
};

static void on_window(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    struct honest *honest = context;
    honest->box = (struct glint_box){x, y, width, height};
    honest->line = 0;
}

static void on_line(void *context, const uint8_t *pixels, size_t bytes)
{
    struct honest *honest = context;
    memcpy(honest->picture[honest->box.y + honest->line++][honest->box.x], pixels, bytes);
}

static void on_end(void *context, bool whole)
{
    (void)context;
    assert_true(whole);
}

static void on_display(void *context, bool on, uint8_t brightness)
{
    (void)brightness;
    ((struct honest *)context)->on = on;
}

static const struct gud_device_ops ops = {on_window, on_line, on_end, on_display, NULL};

static int honest_control(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes)
{
    struct honest *honest = context;
    const struct gud_setup setup = {in ? GUD_TYPE_IN : GUD_TYPE_OUT, request, value, 0, bytes};
    uint8_t reply[GUD_REPLY_BYTES];
    const int count = gud_device_setup(&honest->device, &setup, reply);
    if (count < 0)
        return GUD_LINK_STALL;
    if (!in)
        return gud_device_set(&honest->device, &setup, data) ? bytes : GUD_LINK_STALL;
    memcpy(data, reply, (size_t)count);
    return count;
}

static void honest_init(struct honest *honest, const uint8_t *formats, uint8_t count)
{
    memset(honest, 0, sizeof *honest);
    honest->config = (struct gud_device_config){.width = WIDTH,
                                                .height = HEIGHT,
                                                .refresh_hz = 60,
                                                .output = GLINT_RGB888,
                                                .formats = formats,
                                                .format_count = count,
                                                .max_buffer = WIDTH * HEIGHT * 4,
                                                .lines = honest->lines,
                                                .lines_bytes = sizeof honest->lines,
                                                .window = honest->window,
                                                .window_bytes = sizeof honest->window,
                                                .ops = &ops,
                                                .context = honest};
    assert_true(gud_device_init(&honest->device, &honest->config));
}

/* Draws a picture of noise of this format on the device, in boxes. */
static void send_boxes(struct honest *honest, struct gud_link *link, const struct gud_choice *choice,
                       const struct frame *frame)
{
    static const struct glint_box boxes[] = {
        {0, 0, WIDTH, 20}, {0, 20, 16, 21}, {16, 20, WIDTH - 16, 20}, {16, 40, WIDTH - 16, 1}};
    struct gud_problem problem;
    for (size_t i = 0; i < sizeof boxes / sizeof *boxes; i++) {
        static uint8_t data[WIDTH * HEIGHT * 4];
        const size_t bytes = gud_box_bytes(choice->format, &boxes[i]);
        gud_box_pack(choice->format, frame, &boxes[i], data);
        assert_true(gud_rectangle_announce(link, &(struct piece){boxes[i], false, bytes, bytes, data}, &problem));
        assert_int_equal(gud_device_expects(&honest->device), bytes);
        gud_device_bulk(&honest->device, data, bytes);
    }
}

static void the_firmwares_display_shows_what_the_host_packs(void **state)
{
    (void)state;
    static const uint8_t formats[] = {GUD_RGB888, GUD_XRGB8888, GUD_ARGB8888};
    static uint8_t pixels[HEIGHT][WIDTH][3];
    for (size_t i = 0; i < sizeof pixels; i++)
        ((uint8_t *)pixels)[i] = (uint8_t)(i * i >> 3);
    for (size_t i = 0; i < sizeof formats; i++) {
        static struct honest honest;
        honest_init(&honest, &formats[i], 1);
        struct gud_link link = {.context = &honest, .control = honest_control};
        struct gud_display display;
        struct gud_choice choice;
        struct gud_problem problem;
        assert_true(gud_display_read(&link, &display, true, &problem));
        assert_true(gud_choose(&display, &(struct sink_wish){.format = -1}, &choice, &problem));
        assert_int_equal(choice.format, formats[i]);
        assert_true(gud_start(&link, &display, &choice, &problem));
        assert_true(honest.on);
        send_boxes(&honest, &link, &choice, &(struct frame){WIDTH, HEIGHT, GLINT_RGB888, 3 * WIDTH, &pixels[0][0][0]});
        assert_memory_equal(honest.picture, pixels, sizeof pixels);
        assert_true(gud_stop(&link, &problem));
        assert_false(honest.on);
    }
}

static void a_rectangle_that_the_display_refuses_is_told_with_its_status(void **state)
{
    (void)state;
    static const uint8_t format = GUD_RGB565;
    static struct honest honest;
    honest_init(&honest, &format, 1);
    struct gud_link link = {.context = &honest, .control = honest_control};
    struct gud_problem problem;
    const struct piece piece = {{0, 0, 1, 1}, false, 2, 2, NULL};
    assert_false(gud_rectangle_announce(&link, &piece, &problem)); /* no mode was set */
    assert_int_equal(problem.fault, GUD_LINK_STALL);
    assert_non_null(strstr(problem.text, "a rectangle: it refuses (STALL; status "));
}

/* ---- displays that lie ---- */

struct liar {
    uint8_t descriptor[GUD_DESCRIPTOR_BYTES], formats[256], connectors[256], statuses[64], modes[4096];
    uint16_t descriptor_bytes, formats_bytes, connectors_bytes, modes_bytes;
    uint8_t fault_request;
    int fault;
    uint8_t status;
};

static int lie(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes)
{
    struct liar *liar = context;
    const struct {
        uint8_t request;
        const uint8_t *data;
        uint16_t bytes;
    } answers[] = {{GUD_GET_STATUS, &liar->status, 1},
                   {GUD_GET_DESCRIPTOR, liar->descriptor, liar->descriptor_bytes},
                   {GUD_GET_FORMATS, liar->formats, liar->formats_bytes},
                   {GUD_GET_CONNECTORS, liar->connectors, liar->connectors_bytes},
                   {GUD_GET_CONNECTOR_STATUS, &liar->statuses[value], 1},
                   {GUD_GET_CONNECTOR_MODES, liar->modes, liar->modes_bytes}};
    if (liar->fault && request == liar->fault_request)
        return liar->fault;
    for (size_t i = 0; in && i < sizeof answers / sizeof *answers; i++)
        if (answers[i].request == request) {
            const uint16_t count = answers[i].bytes < bytes ? answers[i].bytes : bytes;
            memcpy(data, answers[i].data, count);
            return count;
        }
    return in ? GUD_LINK_STALL : bytes;
}

static void liar_init(struct liar *liar)
{
    *liar = (struct liar){.descriptor_bytes = GUD_DESCRIPTOR_BYTES,
                          .formats = {GUD_R1, GUD_XRGB8888, GUD_RGB565},
                          .formats_bytes = 3,
                          .connectors_bytes = 2 * GUD_CONNECTOR_BYTES,
                          .statuses = {GUD_DISCONNECTED, GUD_CONNECTED},
                          .modes_bytes = 3 * GUD_MODE_BYTES};
    gud_descriptor_pack(liar->descriptor, &(struct gud_descriptor){.max_buffer = 5000,
                                                                   .compression = GUD_COMPRESSION_LZ4,
                                                                   .min_width = 10,
                                                                   .max_width = 320,
                                                                   .min_height = 10,
                                                                   .max_height = 240});
    gud_mode_pack(liar->modes, &(struct gud_mode){.hdisplay = 320, .vdisplay = 240});
    gud_mode_pack(liar->modes + 24, &(struct gud_mode){.hdisplay = 64, .vdisplay = 32, .flags = GUD_MODE_PREFERRED});
    gud_mode_pack(liar->modes + 48, &(struct gud_mode){.hdisplay = 640, .vdisplay = 32});
}

static bool read_liar(struct liar *liar, struct gud_display *display, struct gud_problem *problem)
{
    struct gud_link link = {.context = liar, .control = lie};
    return gud_display_read(&link, display, true, problem);
}

static void the_preferred_mode_and_the_smallest_colour_are_chosen_unless_others_are_named(void **state)
{
    (void)state;
    struct liar liar;
    struct gud_display display;
    struct gud_choice choice;
    struct gud_problem problem;
    liar_init(&liar);
    assert_true(read_liar(&liar, &display, &problem));
    assert_int_equal(display.connector, 1);
    assert_int_equal(display.mode_count, 2); /* 640 is more than the descriptor allows */
    assert_true(gud_choose(&display, &(struct sink_wish){.format = -1}, &choice, &problem));
    assert_int_equal(choice.mode.hdisplay, 64);
    assert_int_equal(choice.format, GUD_RGB565);
    assert_int_equal(choice.max_bytes, 64 * 32 * 2);
    assert_true(choice.lz4);
    const struct sink_wish wish = {.format = GLINT_RGB888, .width = 320, .height = 240};
    assert_true(gud_choose(&display, &wish, &choice, &problem));
    assert_int_equal(choice.format, GUD_XRGB8888);
    assert_int_equal(choice.mode.vdisplay, 240);
    assert_int_equal(choice.max_bytes, 5000);
    assert_true(
        gud_choose(&display, &(struct sink_wish){.format = GLINT_XRGB8888}, &choice, &problem)); /* as it is listed */
    assert_int_equal(choice.format, GUD_XRGB8888);
    assert_int_equal(choice.pixels, GLINT_RGB888);
    assert_false(gud_choose(&display, &(struct sink_wish){.format = GLINT_GREY8}, &choice, &problem));
    assert_string_equal(problem.text, "it does not take grey8; it offers mono, xrgb8888, rgb565");
    assert_false(
        gud_choose(&display, &(struct sink_wish){.format = -1, .width = 640, .height = 32}, &choice, &problem));
    assert_string_equal(problem.text, "it has no mode 640x32; it has 320x240, 64x32");
}

/* In one bit a pixel such sizes keep within GUD's bytes, and would take gigabytes of normals. */
static void a_mode_of_more_pixels_than_glint_shades_is_refused(void **state)
{
    (void)state;
    static const uint16_t sizes[][2] = {{16384, 32767}, {16385, 8}, {8, 16385}, {8192, 4097}, {65535, 65535}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct liar liar;
        struct gud_display display;
        struct gud_choice choice;
        struct gud_problem problem;
        char wanted[100];
        const uint16_t width = sizes[i][0], height = sizes[i][1];
        liar_init(&liar);
        liar.formats_bytes = 1; /* R1 */
        gud_descriptor_pack(liar.descriptor, &(struct gud_descriptor){.max_width = width, .max_height = height});
        gud_mode_pack(liar.modes, &(struct gud_mode){.hdisplay = width, .vdisplay = height});
        liar.modes_bytes = GUD_MODE_BYTES;
        assert_true(read_liar(&liar, &display, &problem));
        assert_false(gud_choose(&display, &(struct sink_wish){.format = -1}, &choice, &problem));
        snprintf(wanted, sizeof wanted,
                 "its mode %ux%u is too large; the most is 16384 pixels a side and 33554432 in all", width, height);
        assert_string_equal(problem.text, wanted);
    }
}

static void a_display_of_whole_frames_gets_no_lz4(void **state)
{
    (void)state;
    struct liar liar;
    struct gud_display display;
    struct gud_choice choice;
    struct gud_problem problem;
    liar_init(&liar);
    liar.descriptor[5] = GUD_FLAG_FULL_UPDATE;
    assert_true(read_liar(&liar, &display, &problem));
    assert_true(gud_choose(&display, &(struct sink_wish){.format = -1}, &choice, &problem));
    assert_false(choice.lz4);
}

static void a_status_that_is_asked_for_counts_as_a_refusal(void **state)
{
    (void)state;
    struct liar liar;
    struct gud_display display;
    struct gud_problem problem;
    liar_init(&liar);
    liar.descriptor[5] = GUD_FLAG_STATUS;
    liar.status = GUD_BUSY;
    struct gud_link link = {.context = &liar, .control = lie};
    assert_true(gud_display_read(&link, &display, true, &problem));
    struct gud_choice choice;
    assert_true(gud_choose(&display, &(struct sink_wish){.format = -1}, &choice, &problem));
    assert_false(gud_start(&link, &display, &choice, &problem));
    assert_string_equal(problem.text, "the mode and format: it refuses (status 1: busy)");
}

/* By a STALL and the status behind it, or by the status that it wants read. */
static void a_display_that_is_busy_may_take_the_picture_later(void **state)
{
    (void)state;
    const struct piece piece = {{0, 0, 1, 1}, false, 2, 2, NULL};
    for (unsigned i = 0; i < 4; i++) {
        const bool stalls = i % 2, busy = i / 2;
        struct liar liar = {.status = busy ? GUD_BUSY : GUD_PARAMETER,
                            .fault_request = GUD_SET_BUFFER,
                            .fault = stalls ? GUD_LINK_STALL : 0};
        struct gud_link link = {.context = &liar, .control = lie, .status_wanted = !stalls};
        struct gud_problem problem;
        assert_false(gud_rectangle_announce(&link, &piece, &problem));
        assert_int_equal(problem.fault, GUD_LINK_STALL);
        assert_int_equal(problem.busy, busy);
    }
}

static void what_is_longer_than_can_be_is_cut(void **state)
{
    (void)state;
    struct liar liar;
    struct gud_display display;
    struct gud_choice choice;
    struct gud_problem problem;
    liar_init(&liar);
    liar.formats_bytes = sizeof liar.formats;
    memset(liar.formats, GUD_RGB332, sizeof liar.formats);
    liar.connectors_bytes = 255;
    for (size_t i = 0; i < 170; i++)
        memcpy(liar.modes + i * GUD_MODE_BYTES, liar.modes, GUD_MODE_BYTES);
    liar.modes_bytes = sizeof liar.modes;
    assert_true(read_liar(&liar, &display, &problem));
    assert_int_equal(display.format_count, GUD_HOST_FORMATS_MAX);
    assert_int_equal(display.mode_count, GUD_HOST_MODES_MAX);
    assert_false(gud_choose(&display, &(struct sink_wish){.format = -1}, &choice, &problem));
    assert_true(strlen(problem.text) < sizeof problem.text);
    assert_false(gud_choose(&display, &(struct sink_wish){.format = -1, .width = 1, .height = 1}, &choice, &problem));
}

static void every_request_that_fails_is_named_with_its_reason(void **state)
{
    (void)state;
    static const struct {
        uint8_t request;
        int fault;
        const char *text;
    } cases[] = {
        {GUD_GET_DESCRIPTOR, GUD_LINK_STALL, "its descriptor: it refuses (STALL; status 0: no reason)"},
        {GUD_GET_FORMATS, GUD_LINK_TIMEOUT, "its formats: it does not answer"},
        {GUD_GET_CONNECTORS, GUD_LINK_ERROR, "its connectors: the transfer failed"},
        {GUD_SET_CONNECTOR_FORCE_DETECT, GUD_LINK_GONE, "looking for a panel: it is no longer there"},
        {GUD_GET_CONNECTOR_STATUS, GUD_LINK_STOPPED, "a connector's status: stopped"},
        {GUD_GET_CONNECTOR_MODES, GUD_LINK_TIMEOUT, "its modes: it does not answer"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct liar liar;
        struct gud_display display;
        struct gud_problem problem;
        liar_init(&liar);
        liar.fault_request = cases[i].request;
        liar.fault = cases[i].fault;
        assert_false(read_liar(&liar, &display, &problem));
        assert_int_equal(problem.fault, cases[i].fault);
        assert_string_equal(problem.text, cases[i].text);
    }
    static const uint8_t starts[] = {GUD_SET_STATE_COMMIT, GUD_SET_CONTROLLER_ENABLE, GUD_SET_DISPLAY_ENABLE};
    static const char *const texts[] = {"the mode's commit: the transfer failed",
                                        "the controller's switch: the transfer failed",
                                        "the display's switch: the transfer failed"};
    for (size_t i = 0; i < sizeof starts; i++) {
        struct liar liar;
        struct gud_display display;
        struct gud_choice choice;
        struct gud_problem problem;
        liar_init(&liar);
        liar.fault_request = starts[i];
        liar.fault = GUD_LINK_ERROR;
        struct gud_link link = {.context = &liar, .control = lie};
        assert_true(gud_display_read(&link, &display, true, &problem));
        assert_true(gud_choose(&display, &(struct sink_wish){.format = -1}, &choice, &problem));
        assert_false(gud_start(&link, &display, &choice, &problem));
        assert_string_equal(problem.text, texts[i]);
    }
}

/* ---- pixels ---- */

static void pixels_take_the_order_that_gud_wants(void **state)
{
    (void)state;
    static const uint8_t rgb[2][6] = {{1, 2, 3, 4, 5, 6}, {7, 8, 9, 10, 11, 12}};
    const struct frame colours = {2, 2, GLINT_RGB888, 6, &rgb[0][0]};
    uint8_t out[8];
    const struct glint_box right = {1, 0, 1, 2};
    gud_box_pack(GUD_RGB888, &colours, &right, out);
    assert_memory_equal(out, ((uint8_t[]){6, 5, 4, 12, 11, 10}), gud_box_bytes(GUD_RGB888, &right));
    gud_box_pack(GUD_XRGB8888, &colours, &right, out);
    assert_memory_equal(out, ((uint8_t[]){6, 5, 4, 255, 12, 11, 10, 255}), gud_box_bytes(GUD_XRGB8888, &right));
    static const uint8_t bits[2][3] = {{0x12, 0x34, 0x50}, {0x67, 0x89, 0xa0}};
    const struct frame mono = {20, 2, GLINT_MONO, 3, &bits[0][0]};
    const struct glint_box end = {8, 0, 12, 2};
    gud_box_pack(GUD_R1, &mono, &end, out);
    assert_memory_equal(out, ((uint8_t[]){0x34, 0x50, 0x89, 0xa0}), gud_box_bytes(GUD_R1, &end));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_firmwares_display_shows_what_the_host_packs),
        cmocka_unit_test(a_rectangle_that_the_display_refuses_is_told_with_its_status),
        cmocka_unit_test(the_preferred_mode_and_the_smallest_colour_are_chosen_unless_others_are_named),
        cmocka_unit_test(a_mode_of_more_pixels_than_glint_shades_is_refused),
        cmocka_unit_test(a_display_of_whole_frames_gets_no_lz4),
        cmocka_unit_test(a_status_that_is_asked_for_counts_as_a_refusal),
        cmocka_unit_test(a_display_that_is_busy_may_take_the_picture_later),
        cmocka_unit_test(what_is_longer_than_can_be_is_cut),
        cmocka_unit_test(every_request_that_fails_is_named_with_its_reason),
        cmocka_unit_test(pixels_take_the_order_that_gud_wants),
    };
    return cmocka_run_group_tests_name("gud host", tests, NULL, NULL);
}
