/* SPDX-License-Identifier: MIT
 * What USB displays say of themselves that cannot be, or will not say, and what the user reads of it. */
#include "light_protocol.h"
#include "usb_run.h"

/* ---- what it says of itself ---- */

static void assert_says(const char *part)
{
    usb_display_be(&display, &config);
    char whole[256];
    snprintf(whole, sizeof whole, "glint: usb 1-1 (1209:0001): %s", part);
    assert_fails("timeout 20 " STREAM OURS "--frames 1", whole);
}

static void a_missing_display_is_told_with_what_was_looked_for(void **state)
{
    (void)state;
    assert_fails(STREAM, "no USB display: no device has the IDs 1d50:614d, 16d0:10a9 or 1209:4fb3");
    assert_fails(STREAM "--serial 77 --vid-pid 1209:0001", "no USB device with serial number 77 with IDs 1209:0001");
    assert_fails(STREAM "--usb-path 9-1", "no USB device at 9-1");
}

static void a_descriptor_that_is_none_of_guds_is_named(void **state)
{
    (void)state;
    honest();
    config.descriptor[0] ^= 1;
    assert_says("it is not a GUD display: its descriptor begins with 1d50614c, not 1d50614d");
    honest();
    config.descriptor[4] = 2;
    assert_says("it speaks GUD version 2; this glint knows version 1");
    honest();
    config.descriptor_bytes = 12;
    assert_says("it is not a GUD display: its descriptor has 12 bytes, not 30");
}

static void sizes_that_cannot_be_are_refused(void **state)
{
    (void)state;
    honest();
    struct gud_descriptor d = descriptor();
    d.max_width = d.min_width = 0;
    set_descriptor(d);
    assert_says("its descriptor says that it is at most 0x80 pixels");
    honest();
    d = descriptor();
    d.min_height = 81;
    set_descriptor(d);
    assert_says("its descriptor says at least 120x81 and at most 120x80 pixels");
    honest();
    d = descriptor();
    d.max_buffer = 239;
    set_descriptor(d);
    assert_says("it takes 239 bytes a rectangle, and a line has 240");
    honest();
    d = descriptor();
    d.max_height = 79;
    d.min_height = 1;
    set_descriptor(d);
    assert_says("its mode 120x80 is not within its descriptor's 120x1 to 120x79 pixels");
    usb_display_defaults(&config, 65535, 65535);
    assert_says("its mode 65535x65535 is too large");
}

static void lists_that_cannot_be_are_refused(void **state)
{
    (void)state;
    honest();
    config.formats_bytes = 0;
    assert_says("it offers no pixel format");
    honest();
    config.formats[0] = GUD_RGB332;
    config.formats[1] = 0x77;
    config.formats_bytes = 2;
    assert_says("it does not take any format of glint's; it offers rgb332, GUD's 77");
    honest();
    config.connectors_bytes = 0;
    assert_says("it has no connector");
    honest();
    config.connectors_bytes = 7;
    assert_says("its connectors take 7 bytes, which is not a multiple of 5");
    honest();
    config.status = GUD_DISCONNECTED;
    assert_says("no panel is connected to it");
    honest();
    config.status_bytes = 0;
    assert_says("connector 0 has a status of no bytes");
    honest();
    config.modes_bytes = 0;
    assert_says("it has no mode");
    honest();
    config.modes_bytes = 30;
    assert_says("its modes take 30 bytes, which is not a multiple of 24");
}

static void a_huge_max_buffer_and_long_lists_do_no_harm(void **state)
{
    (void)state;
    honest();
    struct gud_descriptor d = descriptor();
    d.max_buffer = 0xffffffff;
    set_descriptor(d);
    config.status = GUD_CONNECTION_UNKNOWN;
    config.connectors_bytes = 60;
    config.formats_bytes = 60;
    for (size_t i = 1; i < 170; i++)
        memcpy(config.modes + i * GUD_MODE_BYTES, config.modes, GUD_MODE_BYTES);
    config.modes_bytes = sizeof config.modes;
    usb_display_be(&display, &config);
    assert_ends(STREAM OURS "--frames 1", 0, "");
    assert_soon(display.seen->rectangles == 1);
}

/* ---- requests that fail ---- */

static void a_refused_request_is_told_with_its_status(void **state)
{
    (void)state;
    honest();
    config.trouble = CONTROL_STALL;
    config.trouble_lasts = true;
    config.trouble_request = GUD_SET_STATE_CHECK;
    config.trouble_status = GUD_PARAMETER;
    assert_says("the mode and format: it refuses (STALL; status 4: invalid parameter)");
    config.trouble_request = GUD_GET_FORMATS;
    config.trouble_status = GUD_BUSY;
    assert_says("its formats: it refuses (STALL; status 1: busy)");
    config.trouble_request = GUD_GET_CONNECTOR_STATUS;
    config.trouble_status = 99;
    assert_says("a connector's status: it refuses (STALL; status 99: an unknown status)");
}

static void a_request_without_answer_ends_after_its_time(void **state)
{
    (void)state;
    honest();
    config.trouble = CONTROL_SILENT;
    config.trouble_ms = 6000;
    config.trouble_request = GUD_GET_CONNECTORS;
    assert_says("its connectors: it does not answer");
}

/* Not that it does not shade by itself, which nobody knows. */
static void a_display_that_does_not_say_whether_it_shades_is_told_apart(void **state)
{
    (void)state;
    honest();
    config.trouble = CONTROL_SILENT;
    config.trouble_ms = 6000;
    config.trouble_request = LIGHT_GET_DESCRIPTOR;
    usb_display_be(&display, &config);
    assert_fails(STREAM OURS "--shade device", "asked whether it shades by itself: it does not answer");
    honest();
    usb_display_be(&display, &config);
    assert_fails(STREAM OURS "--shade device", "it does not shade by itself; leave out --shade");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_missing_display_is_told_with_what_was_looked_for),
        cmocka_unit_test(a_descriptor_that_is_none_of_guds_is_named),
        cmocka_unit_test(sizes_that_cannot_be_are_refused),
        cmocka_unit_test(lists_that_cannot_be_are_refused),
        cmocka_unit_test(a_huge_max_buffer_and_long_lists_do_no_harm),
        cmocka_unit_test(a_refused_request_is_told_with_its_status),
        cmocka_unit_test(a_request_without_answer_ends_after_its_time),
        cmocka_unit_test(a_display_that_does_not_say_whether_it_shades_is_told_apart),
    };
    return cmocka_run_group_tests_name("usb words", tests, scratch_make, clean);
}
