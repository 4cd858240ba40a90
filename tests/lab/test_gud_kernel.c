/* SPDX-License-Identifier: MIT */
/* The Linux kernel's own driver for USB displays draws on glint-gadget, and what it draws arrives. In the environment:
 * GADGET, the program. */
#include "unit.h"

#include "known.h"
#include "soon.h"

#include <fcntl.h>
#include <linux/fb.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { WIDTH = 100, HEIGHT = 37, PIXELS = WIDTH * HEIGHT, PICTURE_BYTES = 3 * PIXELS };
#define PICTURE "/run/tmp/picture"

/* A format as the kernel makes it of its own 16 or 32 bits: what of r, g, b arrives. */
struct format {
    const char *name;
    uint8_t masks[3];
    bool grey;
};

static uint8_t grey(const uint8_t rgb[3])
{
    return (uint8_t)((3 * rgb[0] + 6 * rgb[1] + rgb[2]) / 10);
}

/* The kernel's frame buffer, as it is. */
struct buffer {
    int fd;
    unsigned bytes; /* a pixel */
    size_t line;
};

static struct buffer open_buffer(void)
{
    wait_for_file("/dev/fb0");
    struct buffer buffer = {.fd = open("/dev/fb0", O_RDWR)};
    assert_true(buffer.fd >= 0);
    struct fb_var_screeninfo variable;
    struct fb_fix_screeninfo fixed;
    assert_int_equal(ioctl(buffer.fd, FBIOGET_VSCREENINFO, &variable), 0);
    assert_int_equal(ioctl(buffer.fd, FBIOGET_FSCREENINFO, &fixed), 0);
    assert_int_equal(variable.xres, WIDTH);
    assert_int_equal(variable.yres, HEIGHT);
    assert_true(variable.bits_per_pixel == 16 || variable.bits_per_pixel == 32);
    buffer.bytes = variable.bits_per_pixel / 8;
    buffer.line = fixed.line_length;
    return buffer;
}

/* Draws count pixels from (x, y) on, of another pattern for every seed, and notes what they are. In one call, as the
 * kernel (6.1) takes a write that is within a line and ends with it for nothing. */
static void draw(const struct buffer *buffer, uint8_t *picture, unsigned x, unsigned y, unsigned count, unsigned seed)
{
    uint8_t bytes[4 * PIXELS];
    assert_int_equal(buffer->line, WIDTH * buffer->bytes);
    for (unsigned i = 0; i < count; i++) {
        const unsigned v = known_pixel(seed + (size_t)y * WIDTH + x + i);
        uint8_t *rgb = picture + 3 * (y * WIDTH + x + i);
        if (buffer->bytes == 2) {
            rgb[0] = (uint8_t)(v >> 8 & 0xf8);
            rgb[1] = (uint8_t)(v >> 3 & 0xfc);
            rgb[2] = (uint8_t)(v << 3 & 0xf8);
            bytes[2 * i] = (uint8_t)v;
            bytes[2 * i + 1] = (uint8_t)(v >> 8);
        } else {
            rgb[0] = bytes[4 * i + 2] = (uint8_t)(v >> 8);
            rgb[1] = bytes[4 * i + 1] = (uint8_t)v;
            rgb[2] = bytes[4 * i] = (uint8_t)(v * 37 >> 4);
            bytes[4 * i + 3] = 0;
        }
    }
    const size_t size = count * buffer->bytes;
    assert_int_equal(pwrite(buffer->fd, bytes, size, (off_t)(y * buffer->line + x * buffer->bytes)), size);
}

/* The first byte that did not arrive; PICTURE_BYTES: all did. */
static size_t first_difference(const struct format *format, const uint8_t *wanted, const uint8_t *found)
{
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        const uint8_t byte = format->grey ? grey(wanted + i / 3 * 3) : wanted[i];
        if ((byte ^ found[i]) & format->masks[i % 3])
            return i;
    }
    return PICTURE_BYTES;
}

/* The kernel sends when it likes. */
static void wait_for_picture(const struct process *gadget, const struct format *format, const uint8_t *wanted)
{
    size_t different = 0;
    uint8_t found[PICTURE_BYTES] = {0};
    for (unsigned looks = 0; wait_more(&looks);) {
        kill(gadget->pid, SIGUSR1);
        FILE *file = fopen(PICTURE, "r");
        const size_t size = file ? fread(found, 1, sizeof found, file) : 0;
        if (file)
            fclose(file);
        if (size == sizeof found && (different = first_difference(format, wanted, found)) == PICTURE_BYTES)
            return;
    }
    fail_msg("%s: byte %zu of the picture is not %02x but %02x", format->name, different, wanted[different],
             found[different]);
}

static void kernel_draws(const struct format *format, const char *options)
{
    static uint8_t wanted[PICTURE_BYTES];
    struct process gadget;
    unlink(PICTURE);
    process_start(&gadget, "$GADGET --size %dx%d --formats %s -o " PICTURE " %s", WIDTH, HEIGHT, format->name, options);
    process_wait_for(&gadget, "on the bus");
    if (strstr(options, "usbip"))
        usbip_attach();
    const struct buffer buffer = open_buffer();
    draw(&buffer, wanted, 0, 0, PIXELS, 0);
    wait_for_picture(&gadget, format, wanted);
    /* within a line the kernel sends no more than that */
    draw(&buffer, wanted, 13, 5, 29, 7);
    wait_for_picture(&gadget, format, wanted);
    draw(&buffer, wanted, WIDTH - 2, HEIGHT - 1, 1, 3);
    wait_for_picture(&gadget, format, wanted);
    close(buffer.fd);
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
}

static const struct format RGB565 = {"rgb565", {0xf8, 0xfc, 0xf8}, false}, RGB888 = {"rgb888", {255, 255, 255}, false},
                           XRGB8888 = {"xrgb8888", {255, 255, 255}, false},
                           RGB332 = {"rgb332", {0xe0, 0xe0, 0xc0}, false},
                           XRGB1111 = {"xrgb1111", {0x80, 0x80, 0x80}, false}, R8 = {"r8", {255, 255, 255}, true},
                           R1 = {"r1", {0x80, 0x80, 0x80}, true};

static void the_kernels_driver_draws_in_every_format(void **state)
{
    (void)state;
    static const struct format *const FORMATS[] = {&RGB565, &RGB888, &XRGB8888, &RGB332, &XRGB1111, &R8, &R1};
    for (size_t i = 0; i < sizeof FORMATS / sizeof *FORMATS; i++) {
        kernel_draws(FORMATS[i], "");
        kernel_draws(FORMATS[i], "--no-lz4");
    }
}

static void rectangles_larger_than_the_buffer_arrive_in_parts(void **state)
{
    (void)state;
    kernel_draws(&RGB565, "--max-buffer 1000");
    kernel_draws(&XRGB8888, "--no-lz4 --max-buffer 400");
}

static void over_usb_ip_it_is_the_same(void **state)
{
    (void)state;
    kernel_draws(&RGB565, "--udc usbip-vudc.0");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(the_kernels_driver_draws_in_every_format, lab_clean),
        cmocka_unit_test_teardown(rectangles_larger_than_the_buffer_arrive_in_parts, lab_clean),
        cmocka_unit_test_teardown(over_usb_ip_it_is_the_same, lab_clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
