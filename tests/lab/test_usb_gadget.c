/* SPDX-License-Identifier: MIT
 * glint stream to glint-gadget, the firmware's own display: what it holds at the end is the last frame. */
#include "run.h"

#include <stdbool.h>

/* In the environment: GADGET, the program. */

enum { WIDTH = 77, HEIGHT = 53, PIXELS = WIDTH * HEIGHT };

static void read_end(const char *path, uint8_t *bytes, size_t count)
{
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_int_equal(fseek(file, -(long)count, SEEK_END), 0);
    assert_int_equal(fread(bytes, 1, count, file), count);
    fclose(file);
}

static uint8_t widened(unsigned level, unsigned max)
{
    return (uint8_t)((level * 255 + max / 2) / max);
}

/* The pixel of a raw picture as three bytes. */
static void colours_of(const char *format, const uint8_t *raw, unsigned x, unsigned y, uint8_t rgb[3])
{
    const unsigned at = y * WIDTH + x;
    if (strcmp(format, "rgb888") == 0) {
        memcpy(rgb, &raw[3 * at], 3);
    } else if (strcmp(format, "rgb565") == 0) {
        const unsigned pixel = raw[2 * at] | (unsigned)raw[2 * at + 1] << 8;
        rgb[0] = widened(pixel >> 11, 31);
        rgb[1] = widened(pixel >> 5 & 63, 63);
        rgb[2] = widened(pixel & 31, 31);
    } else {
        const bool mono = strcmp(format, "mono") == 0;
        memset(rgb, mono ? (raw[y * ((WIDTH + 7) / 8) + x / 8] >> (7 - x % 8) & 1) * 255 : raw[at], 3);
    }
}

static size_t raw_bytes(const char *format)
{
    return strcmp(format, "rgb888") == 0   ? 3 * PIXELS
           : strcmp(format, "rgb565") == 0 ? 2 * PIXELS
           : strcmp(format, "mono") == 0   ? (WIDTH + 7) / 8 * HEIGHT
                                           : PIXELS;
}

static void check(const char *offered, const char *format, const char *gadget_options)
{
    static uint8_t shown[3 * PIXELS], raw[3 * PIXELS];
    char command[1000];
    snprintf(
        command, sizeof command,
        "rm -f gadget.out; $GADGET --size %dx%d --vid-pid 1209:0001 --formats %s %s -o shown.ppm >gadget.out & pid=$!\n"
        "until [ -s gadget.out ] || ! kill -0 $pid; do sleep .1; done\n"
        "$GLINT stream watchface --to usb --wait --vid-pid 1209:0001 --frames 5 --fps 5 --format %s; status=$?\n"
        "kill $pid; wait $pid; exit $status",
        WIDTH, HEIGHT, offered, gadget_options, format);
    assert_string_equal(assert_ends(command, 0, "")->err, "");
    read_end("shown.ppm", shown, sizeof shown);
    snprintf(command, sizeof command,
             "$GLINT stream watchface --to raw --size %dx%d --frames 5 --fps 5 --format %s >frames.raw", WIDTH, HEIGHT,
             format);
    assert_ends(command, 0, "");
    read_end("frames.raw", raw, raw_bytes(format));
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            uint8_t wanted[3];
            colours_of(format, raw, x, y, wanted);
            if (memcmp(&shown[3 * (y * WIDTH + x)], wanted, 3) != 0)
                fail_msg("%s, %s: pixel %u, %u is %02x %02x %02x, not %02x %02x %02x", offered, gadget_options, x, y,
                         shown[3 * (y * WIDTH + x)], shown[3 * (y * WIDTH + x) + 1], shown[3 * (y * WIDTH + x) + 2],
                         wanted[0], wanted[1], wanted[2]);
        }
}

static void every_format_arrives_at_the_firmwares_display(void **state)
{
    (void)state;
    check("rgb565", "rgb565", "");
    check("rgb888", "rgb888", "");
    check("xrgb8888", "rgb888", "");
    check("r8", "grey8", "");
    check("r1", "mono", "");
}

static void without_lz4_and_with_small_buffers_too(void **state)
{
    (void)state;
    check("rgb565", "rgb565", "--no-lz4");
    check("rgb565", "rgb565", "--max-buffer 1000");
    check("rgb888", "rgb888", "--no-lz4 --max-buffer 700 --speed full");
    check("r1", "mono", "--max-buffer 33");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_arrives_at_the_firmwares_display),
        cmocka_unit_test(without_lz4_and_with_small_buffers_too),
    };
    return cmocka_run_group_tests_name("usb gadget", tests, scratch_make, scratch_remove);
}
