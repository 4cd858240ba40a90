/* SPDX-License-Identifier: MIT
 * The GUD device's answers and its state. */
#include "gud_board.h"

/* ---- requests ---- */

static void the_descriptor_tells_size_buffer_and_compression(void **state)
{
    (void)state;
    struct gud_descriptor d;
    assert_int_equal(get(GUD_GET_DESCRIPTOR, 30), 30);
    assert_true(gud_descriptor_unpack(&d, reply));
    assert_int_equal(d.flags, 0);
    assert_int_equal(d.compression, GUD_COMPRESSION_LZ4);
    assert_int_equal(d.max_buffer, FRAME_MAX);
    assert_int_equal(d.min_width, WIDTH);
    assert_int_equal(d.max_width, WIDTH);
    assert_int_equal(d.min_height, HEIGHT);
    assert_int_equal(d.max_height, HEIGHT);
    board.config.window = NULL;
    board.config.status_after_set = true;
    assert_int_equal(get(GUD_GET_DESCRIPTOR, 30), 30);
    assert_true(gud_descriptor_unpack(&d, reply));
    assert_int_equal(d.flags, GUD_FLAG_STATUS);
    assert_int_equal(d.compression, 0);
    for (unsigned i = 0; i < 5; i++) { /* magic and version */
        reply[i] ^= 1;
        assert_false(gud_descriptor_unpack(&d, reply));
        reply[i] ^= 1;
    }
}

static void a_mode_keeps_every_byte_on_the_wire(void **state)
{
    (void)state;
    const struct gud_mode mode = {0x01020304, 0x0506, 0x0708, 0x090a, 0x0b0c,
                                  0x0d0e,     0x0f10, 0x1112, 0x1314, 0x15161718};
    uint8_t bytes[GUD_MODE_BYTES + 1];
    bytes[GUD_MODE_BYTES] = 0xee; /* another's */
    gud_mode_pack(bytes, &mode);
    assert_int_equal(bytes[GUD_MODE_BYTES], 0xee);
    assert_memory_equal(bytes, "\4\3\2\1\6\5\x08\7\x0a\x09\x0c\x0b\x0e\x0d\x10\x0f\x12\x11\x14\x13\x18\x17\x16\x15",
                        GUD_MODE_BYTES);
    struct gud_mode again;
    gud_mode_unpack(&again, bytes);
    assert_int_equal(again.flags, mode.flags);
    assert_int_equal(again.clock_khz, mode.clock_khz);
    assert_int_equal(again.vtotal, mode.vtotal);
}

static void the_mode_is_the_panel_at_its_rate(void **state)
{
    (void)state;
    struct gud_mode m;
    assert_int_equal(get(GUD_GET_CONNECTOR_MODES, 3072), GUD_MODE_BYTES);
    gud_mode_unpack(&m, reply);
    assert_int_equal(m.hdisplay, WIDTH);
    assert_int_equal(m.vdisplay, HEIGHT);
    assert_int_equal(m.flags, GUD_MODE_PREFERRED);
    assert_true(m.clock_khz > 0 && m.hsync_start >= WIDTH && m.hsync_end >= m.hsync_start && m.htotal >= m.hsync_end);
    assert_true(m.vsync_start >= HEIGHT && m.vsync_end >= m.vsync_start && m.vtotal >= m.vsync_end);
    static const uint16_t sizes[][3] = {{240, 240, 60}, {135, 240, 50}, {1920, 1080, 30}, {8192, 8192, 60}};
    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        board.config.width = sizes[i][0];
        board.config.height = sizes[i][1];
        board.config.refresh_hz = sizes[i][2];
        assert_int_equal(get(GUD_GET_CONNECTOR_MODES, 3072), GUD_MODE_BYTES);
        gud_mode_unpack(&m, reply);
        const double pixels =
            (double)m.htotal * m.vtotal; /* as the kernel's driver computes the rate, to the nearest */
        assert_int_equal(lround(m.clock_khz * 1000 / pixels), sizes[i][2]);
    }
}

static void a_buffer_may_have_31_bits_and_no_more(void **state)
{
    (void)state;
    struct gud_device device;
    struct gud_device_config config = board.config;
    config.window = NULL;
    config.max_buffer = INT32_MAX;
    assert_true(gud_device_init(&device, &config));
    config.max_buffer++;
    assert_false(gud_device_init(&device, &config));
}

static const struct {
    uint8_t request;
    int bytes;
} gets[] = {{GUD_GET_STATUS, 1},           {GUD_GET_DESCRIPTOR, 30},      {GUD_GET_FORMATS, sizeof all_formats},
            {GUD_GET_PROPERTIES, 0},       {GUD_GET_CONNECTORS, 5},       {GUD_GET_CONNECTOR_PROPERTIES, 10},
            {GUD_GET_CONNECTOR_STATUS, 1}, {GUD_GET_CONNECTOR_MODES, 24}, {GUD_GET_CONNECTOR_EDID, 0}},
  sets[] = {{GUD_SET_CONNECTOR_FORCE_DETECT, 0}, {GUD_SET_BUFFER, 25},           {GUD_SET_STATE_CHECK, 26},
            {GUD_SET_STATE_COMMIT, 0},           {GUD_SET_CONTROLLER_ENABLE, 1}, {GUD_SET_DISPLAY_ENABLE, 1}};
enum { GETS = sizeof gets / sizeof *gets, SETS = sizeof sets / sizeof *sets };

static void each_reply_has_its_length_cut_to_what_the_host_takes(void **state)
{
    (void)state;
    for (unsigned i = 0; i < GETS; i++)
        for (uint16_t length = 1; length < 300; length++) {
            memset(reply, FRESH, sizeof reply);
            const int wanted = gets[i].bytes < length ? gets[i].bytes : length;
            assert_int_equal(get(gets[i].request, length), wanted);
            assert_int_equal(status(), GUD_OK);
        }
}

static void each_reply_says_all_that_it_has_room_for(void **state)
{
    (void)state;
    go(GUD_RGB565);
    memset(reply, FRESH, sizeof reply);
    assert_int_equal(get(GUD_GET_CONNECTORS, 160), GUD_CONNECTOR_BYTES);
    assert_memory_equal(reply, "\0\0\0\0\0", GUD_CONNECTOR_BYTES); /* a panel, no flags */
    memset(reply, FRESH, sizeof reply);
    assert_int_equal(get(GUD_GET_CONNECTOR_PROPERTIES, 320), GUD_PROPERTY_BYTES);
    assert_memory_equal(reply, "\x0c\0\x46\0\0\0\0\0\0\0", GUD_PROPERTY_BYTES); /* brightness, 70 */
    assert_int_equal(get(GUD_GET_FORMATS, 32), sizeof all_formats);
    assert_memory_equal(reply, all_formats, sizeof all_formats);
}

static void unknown_requests_are_unsupported(void **state)
{
    (void)state;
    for (unsigned type = 0; type < 256; type++)
        for (unsigned request = 0; request < 256; request++) {
            bool known = false;
            for (unsigned i = 0; i < GETS; i++)
                known |= type == GUD_TYPE_IN && request == gets[i].request;
            for (unsigned i = 0; i < SETS; i++)
                known |= type == GUD_TYPE_OUT && request == sets[i].request;
            if (known)
                continue;
            const struct gud_setup setup = {(uint8_t)type, (uint8_t)request, 0, INTERFACE, 1};
            assert_int_equal(gud_device_setup(&board.device, &setup, reply), GUD_STALL);
            assert_int_equal(status(), GUD_UNSUPPORTED);
        }
}

static void wrong_lengths_are_protocol_errors(void **state)
{
    (void)state;
    static const uint8_t data[300];
    go(GUD_RGB565);
    for (unsigned i = 0; i < SETS; i++)
        for (uint16_t length = 0; length < 300; length++)
            if (length != sets[i].bytes && !(sets[i].request == GUD_SET_STATE_CHECK && length == GUD_DATA_BYTES))
                assert_int_equal(set(sets[i].request, data, length), GUD_PROTOCOL);
    for (unsigned i = 0; i < GETS; i++) {
        assert_int_equal(get(gets[i].request, 0), GUD_STALL);
        assert_int_equal(status(), GUD_PROTOCOL);
    }
    assert_true(get(GUD_GET_DESCRIPTOR, 30) >= 0); /* a good one leaves no status behind */
    assert_int_equal(status(), GUD_OK);
    board.config.dimmable = false;
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, GUD_DATA_BYTES), GUD_PROTOCOL);
    assert_int_equal(get(GUD_GET_CONNECTOR_PROPERTIES, 320), 0);
}

static void a_request_to_another_interface_is_refused_and_changes_nothing(void **state)
{
    (void)state;
    go(GUD_RGB565);
    draw((struct glint_box){0, 0, 1, 1}, GUD_RGB565, (uint8_t[]){1, 2}, false, false);
    const struct gud_device before = board.device;
    for (unsigned index = 0; index < 65536; index += index < 10 ? 1 : 253) {
        if (index == INTERFACE)
            continue;
        const struct gud_setup buffer = {GUD_TYPE_OUT, GUD_SET_BUFFER, 0, (uint16_t)index, 25},
                               descriptor = {GUD_TYPE_IN, GUD_GET_DESCRIPTOR, 0, (uint16_t)index, 30};
        assert_int_equal(gud_device_setup(&board.device, &buffer, reply), GUD_STALL);
        assert_int_equal(gud_device_setup(&board.device, &descriptor, reply), GUD_STALL);
        assert_memory_equal(&board.device, &before, sizeof before);
    }
}

static void the_display_has_one_connector(void **state)
{
    (void)state;
    for (uint8_t request = GUD_GET_CONNECTORS; request <= GUD_GET_CONNECTOR_EDID; request++) {
        const bool in = request != GUD_SET_CONNECTOR_FORCE_DETECT;
        if (request == 0x52)
            continue;
        const struct gud_setup setup = {in ? GUD_TYPE_IN : GUD_TYPE_OUT, request, 1, INTERFACE, in ? 8 : 0};
        const int result = gud_device_setup(&board.device, &setup, reply);
        assert_int_equal(result == GUD_STALL, request != GUD_GET_CONNECTORS);
        assert_int_equal(status(), request == GUD_GET_CONNECTORS ? GUD_OK : GUD_PARAMETER);
    }
    assert_int_equal(get(GUD_GET_CONNECTOR_STATUS, 1), 1);
    assert_int_equal(reply[0], GUD_CONNECTED);
    assert_int_equal(set(GUD_SET_CONNECTOR_FORCE_DETECT, NULL, 0), GUD_OK); /* it is always there */
}

/* ---- the state ---- */

static void a_state_that_the_panel_lacks_is_refused(void **state)
{
    (void)state;
    static const struct {
        unsigned at;
        uint8_t value;
    } wrong[] = {{4, WIDTH + 1}, {5, 1},  {12, HEIGHT - 1}, {24, 0}, {24, 0x41}, {25, 1},
                 {26, 11},       {27, 1}, {28, 101},        {29, 1}, {35, 1}};
    uint8_t data[GUD_DATA_BYTES];
    for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        state_of(data, GUD_R8);
        assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_OK);
        data[wrong[i].at] = wrong[i].value;
        assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_PARAMETER);
        assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
        assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_PROTOCOL);
    }
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 2), GUD_PARAMETER);
    assert_int_equal(set_byte(GUD_SET_DISPLAY_ENABLE, 255), GUD_PARAMETER);
}

static void a_format_that_is_not_offered_is_refused(void **state)
{
    (void)state;
    uint8_t data[GUD_DATA_BYTES];
    for (board.config.format_count = 1; board.config.format_count < sizeof all_formats; board.config.format_count++) {
        for (unsigned i = 0; i < sizeof all_formats; i++) {
            state_of(data, all_formats[i]);
            assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data),
                             i < board.config.format_count ? GUD_OK : GUD_PARAMETER);
        }
    }
}

static void steps_out_of_order_are_protocol_errors(void **state)
{
    (void)state;
    const struct gud_rectangle pixel = {0, 0, 1, 1, 2, 0, 0};
    uint8_t data[GUD_DATA_BYTES];
    state_of(data, GUD_RGB565);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_PROTOCOL);
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, GUD_STATE_BYTES), GUD_OK);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_PROTOCOL); /* the controller is off */
    assert_int_equal(set_byte(GUD_SET_DISPLAY_ENABLE, 1), GUD_PROTOCOL);
    assert_int_equal(ask(&pixel), GUD_PROTOCOL);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    assert_int_equal(ask(&pixel), GUD_PROTOCOL);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_int_equal(ask(&pixel), GUD_OK);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 0), GUD_OK);
    assert_int_equal(ask(&pixel), GUD_PROTOCOL);
}

static void a_check_changes_nothing_until_its_commit(void **state)
{
    (void)state;
    uint8_t data[GUD_DATA_BYTES];
    go(GUD_RGB565);
    state_of(data, GUD_R8);
    const struct gud_rectangle pixel = {0, 0, 1, 1, 2, 0, 0};
    assert_int_equal(ask(&pixel), GUD_OK);
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_OK);
    send((uint8_t[]){0x34, 0x12}, 2, false);
    assert_memory_equal(board.panel, "\x12\x34", 2);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_int_equal(ask(&pixel), GUD_PARAMETER); /* a pixel is one byte now */
}

static void a_commit_drops_the_rectangle_of_the_earlier_state(void **state)
{
    (void)state;
    uint8_t data[GUD_DATA_BYTES];
    go(GUD_R1);
    const struct gud_rectangle two_lines = {0, 0, WIDTH, 2, 2 * WIDTH / 8, 0, 0};
    assert_int_equal(ask(&two_lines), GUD_OK);
    send((uint8_t[WIDTH / 8]){0}, WIDTH / 8, false);
    state_of(data, GUD_XRGB8888); /* whose lines are longer */
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_OK);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_int_equal(gud_device_expects(&board.device), 0);
    assert_true(board.ends == 1 && board.whole == 0);
    send((uint8_t[WIDTH / 8]){0}, WIDTH / 8, false);
    assert_int_equal(board.row, 1);
}

static void the_display_is_told_what_changes(void **state)
{
    (void)state;
    go(GUD_RGB565);
    assert_true(board.on && board.brightness == 70 && board.displays == 1);
    gud_device_suspend(&board.device);
    assert_true(!board.on && board.displays == 2);
    gud_device_suspend(&board.device);
    assert_int_equal(board.displays, 2);
    gud_device_resume(&board.device);
    assert_true(board.on && board.displays == 3);
    uint8_t data[GUD_DATA_BYTES];
    state_of(data, GUD_RGB565);
    data[GUD_STATE_BYTES + 2] = 5;
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_OK);
    assert_int_equal(board.displays, 3);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_true(board.on && board.brightness == 5 && board.displays == 4);
    assert_int_equal(get(GUD_GET_CONNECTOR_PROPERTIES, 320), 10);
    assert_int_equal(reply[2], 5);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 0), GUD_OK);
    assert_true(!board.on && board.displays == 5);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    assert_int_equal(board.displays, 5); /* the display has to be enabled again, too */
}

static void a_board_whose_display_is_always_on_is_not_told(void **state)
{
    (void)state;
    struct gud_device_ops quiet = *board.config.ops;
    quiet.display = NULL;
    board.config.ops = &quiet;
    go(GUD_RGB565);
    gud_device_suspend(&board.device);
    assert_int_equal(board.displays, 0);
}

static void brightness_is_full_until_a_host_sets_it_and_then_stays(void **state)
{
    (void)state;
    uint8_t data[GUD_DATA_BYTES];
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    assert_int_equal(set_byte(GUD_SET_DISPLAY_ENABLE, 1), GUD_OK);
    assert_true(board.on && board.brightness == 100);
    go(GUD_RGB565);
    assert_int_equal(board.brightness, 70);
    state_of(data, GUD_R8);
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, GUD_STATE_BYTES), GUD_OK); /* without properties */
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_true(board.on && board.brightness == 70);
}

static void a_disabled_controller_drops_its_rectangle(void **state)
{
    (void)state;
    const struct gud_rectangle two_lines = {0, 0, 2, 2, 8, 0, 0};
    go(GUD_RGB565);
    assert_int_equal(ask(&two_lines), GUD_OK);
    send((uint8_t[5]){0}, 5, false);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 0), GUD_OK);
    assert_int_equal(gud_device_expects(&board.device), 0);
    assert_true(board.ends == 1 && board.whole == 0);
    send((uint8_t[3]){0}, 3, false);
    assert_int_equal(board.row, 1);
}

static void a_bus_reset_forgets_what_the_host_had_set(void **state)
{
    (void)state;
    const struct gud_rectangle two_lines = {0, 0, 2, 2, 8, 0, 0};
    go(GUD_RGB565);
    assert_int_equal(ask(&two_lines), GUD_OK);
    send((uint8_t[5]){0}, 5, false);
    gud_device_reset(&board.device);
    assert_true(!board.on && board.ends == 1 && board.whole == 0);
    assert_int_equal(gud_device_expects(&board.device), 0);
    assert_int_equal(ask(&two_lines), GUD_PROTOCOL);
    gud_device_reset(&board.device);
    assert_int_equal(status(), GUD_OK);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_PROTOCOL); /* no state was checked */
    gud_device_suspend(&board.device);
    gud_device_reset(&board.device);
    assert_int_equal(get(GUD_GET_CONNECTOR_PROPERTIES, 320), 10);
    assert_int_equal(reply[2], 100);
    go(GUD_R8);
    assert_true(board.on);
    draw((struct glint_box){0, 0, 1, 1}, GUD_R8, (uint8_t[]){255}, false, false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        DEVICE_TEST(the_descriptor_tells_size_buffer_and_compression),
        DEVICE_TEST(a_mode_keeps_every_byte_on_the_wire),
        DEVICE_TEST(the_mode_is_the_panel_at_its_rate),
        DEVICE_TEST(each_reply_has_its_length_cut_to_what_the_host_takes),
        DEVICE_TEST(each_reply_says_all_that_it_has_room_for),
        DEVICE_TEST(unknown_requests_are_unsupported),
        DEVICE_TEST(wrong_lengths_are_protocol_errors),
        DEVICE_TEST(a_request_to_another_interface_is_refused_and_changes_nothing),
        DEVICE_TEST(the_display_has_one_connector),
        DEVICE_TEST(a_buffer_may_have_31_bits_and_no_more),
        DEVICE_TEST(a_state_that_the_panel_lacks_is_refused),
        DEVICE_TEST(a_format_that_is_not_offered_is_refused),
        DEVICE_TEST(steps_out_of_order_are_protocol_errors),
        DEVICE_TEST(a_check_changes_nothing_until_its_commit),
        DEVICE_TEST(a_commit_drops_the_rectangle_of_the_earlier_state),
        DEVICE_TEST(the_display_is_told_what_changes),
        DEVICE_TEST(a_board_whose_display_is_always_on_is_not_told),
        DEVICE_TEST(brightness_is_full_until_a_host_sets_it_and_then_stays),
        DEVICE_TEST(a_disabled_controller_drops_its_rectangle),
        DEVICE_TEST(a_bus_reset_forgets_what_the_host_had_set),
    };
    return cmocka_run_group_tests_name("gud device", tests, NULL, NULL);
}
