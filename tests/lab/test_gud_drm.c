/* SPDX-License-Identifier: MIT
 * glint-gadget under the kernel's own GUD driver: what is drawn through its DRM device arrives bit for bit, in every format,
 * raw and compressed, whole and in odd rectangles; and it survives what happens to USB devices. In the environment: GADGET
 * and FAULTY, the programs. */
#include "unit.h"

#include "card.h"
#include "lab.h"
#include "soon.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/usbdevice_fs.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

enum { WIDTH = 61, HEIGHT = 47 };
#define PICTURE "/run/picture"

/* ---- the gadget ---- */

static struct process gadget;

static void gadget_start(const char *variable, const char *options)
{
    unlink(PICTURE);
    process_start(&gadget, "$%s --size %dx%d -v -o " PICTURE " %s", variable, WIDTH, HEIGHT, options);
}

static char *log_text(void)
{
    size_t size;
    return run_for_output(&size, "tail -12 %s", gadget.output);
}

/* From its last line, when it has ended. */
static void gadget_figures(unsigned long *rectangles, unsigned long long *bytes)
{
    size_t size;
    unsigned long faults;
    char *line = run_for_output(&size, "grep ' rectangles, ' %s", gadget.output);
    assert_int_equal(sscanf(line, "%lu rectangles, %lu with faults, %llu bytes", rectangles, &faults, bytes), 3);
    assert_int_equal(faults, 0);
    free(line);
}

/* ---- pictures ---- */

static uint8_t source[HEIGHT][WIDTH][3], wanted[HEIGHT][WIDTH][3];

enum content { SMOOTH, NOISE };
static void draw(enum content content, unsigned turn, unsigned x0, unsigned y0, unsigned width, unsigned height)
{
    for (unsigned y = y0; y < y0 + height; y++)
        for (unsigned x = x0; x < x0 + width; x++)
            for (unsigned c = 0; c < 3; c++) {
                const unsigned smooth = x / 8 * 37 + 11 * turn + 50 * c, noise = (unsigned)rand() >> 7;
                source[y][x][c] = (uint8_t)(content == SMOOTH ? smooth : noise);
                const uint8_t v = source[y][x][c];
                uint8_t *at = card.pixels + y * card.pitch + x * card_pixel_bytes(card.fourcc);
                if (card.fourcc != DRM_FORMAT_RGB565) {
                    at[2 - c] = v;
                    continue;
                }
                const unsigned word = at[0] | (unsigned)at[1] << 8, shift = (const unsigned[]){11, 5, 0}[c];
                const unsigned most = c == 1 ? 63 : 31, level = v * (most + 1) / 256;
                const unsigned next = (word & ~(most << shift)) | level << shift;
                at[0] = (uint8_t)next;
                at[1] = (uint8_t)(next >> 8);
            }
}

/* What becomes of a colour on a device that shows it in so many levels; the kernel cuts. */
static uint8_t shown(uint8_t value, unsigned most)
{
    return (uint8_t)((value * (most + 1) / 256 * 255 + most / 2) / most);
}

static void want(const char *format)
{
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            const uint8_t *s = source[y][x];
            const unsigned grey = (3u * s[0] + 6u * s[1] + s[2]) / 10;
            for (unsigned c = 0; c < 3; c++)
                if (strcmp(format, "rgb565") == 0)
                    wanted[y][x][c] = shown(s[c], c == 1 ? 63 : 31);
                else if (strcmp(format, "rgb332") == 0)
                    wanted[y][x][c] = shown(s[c], c == 2 ? 3 : 7);
                else if (strcmp(format, "xrgb1111") == 0)
                    wanted[y][x][c] = shown(s[c], 1);
                else if (strcmp(format, "r8") == 0)
                    wanted[y][x][c] = (uint8_t)grey;
                else if (strcmp(format, "r1") == 0)
                    wanted[y][x][c] = shown((uint8_t)grey, 1);
                else
                    wanted[y][x][c] = s[c];
        }
}

static unsigned wrong_pixels(void)
{
    static uint8_t found[HEIGHT][WIDTH][3];
    FILE *file = fopen(PICTURE, "r");
    const bool whole = file && fread(found, sizeof found, 1, file) == 1 && getc(file) == EOF;
    if (file)
        fclose(file);
    unsigned wrong = whole ? 0 : WIDTH * HEIGHT;
    for (unsigned i = 0; whole && i < WIDTH * HEIGHT; i++)
        wrong += memcmp(&found[0][0][3 * i], &wanted[0][0][3 * i], 3) != 0;
    return wrong;
}

/* The kernel flushes when it likes. */
static void arrives(const char *format, const char *what)
{
    want(format);
    unsigned wrong = 1;
    for (unsigned looks = 0; wrong && wait_more(&looks); wrong = wrong_pixels())
        kill(gadget.pid, SIGUSR1);
    if (wrong)
        fail_msg("%s, %s: %u of %u pixels are wrong\n%s", format, what, wrong, WIDTH * HEIGHT, log_text());
}

/* ---- formats ---- */

static void draws_all(const char *format, uint32_t fourcc)
{
    static const unsigned boxes[][4] = {{0, 0, 1, 1},  {60, 46, 1, 1}, {7, 3, 13, 5},
                                        {8, 0, 9, 47}, {1, 20, 59, 1}, {3, 1, 57, 45}};
    card_open(WIDTH, HEIGHT);
    card_show(fourcc);
    draw(SMOOTH, 0, 0, 0, WIDTH, HEIGHT);
    card_dirty(0, 0, WIDTH, HEIGHT);
    arrives(format, "a smooth frame");
    for (unsigned i = 0; i < sizeof boxes / sizeof *boxes; i++) {
        char what[60];
        const unsigned *b = boxes[i];
        draw(i % 2 ? SMOOTH : NOISE, i, b[0], b[1], b[2], b[3]);
        card_dirty(b[0], b[1], b[2], b[3]);
        snprintf(what, sizeof what, "a rectangle at %u,%u of %ux%u", b[0], b[1], b[2], b[3]);
        arrives(format, what);
    }
    draw(NOISE, 0, 0, 0, WIDTH, HEIGHT);
    card_dirty(0, 0, WIDTH, HEIGHT);
    arrives(format, "a frame of noise");
    card_close();
}

static void with(const char *format, uint32_t fourcc, const char *options, unsigned long *rectangles,
                 unsigned long long *bytes)
{
    char all[200];
    snprintf(all, sizeof all, "--formats %s %s", format, options);
    gadget_start("GADGET", all);
    draws_all(format, fourcc);
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
    gadget_figures(rectangles, bytes);
}

/* Raw, compressed (fewer bytes), split (more rectangles), at full speed: 64 bytes a packet. */
static void format_arrives(const char *format, uint32_t fourcc)
{
    unsigned long rectangles, split, few;
    unsigned long long raw, compressed, bytes;
    with(format, fourcc, "--no-lz4", &rectangles, &raw);
    with(format, fourcc, "", &few, &compressed);
    assert_true(compressed < raw);
    with(format, fourcc, "--max-buffer 300 --speed full", &split, &bytes);
    assert_true(split > rectangles + 10 || strcmp(format, "r1") == 0);
}

static void rgb565_arrives(void **state)
{
    (void)state;
    format_arrives("rgb565", DRM_FORMAT_RGB565);
}

static void xrgb8888_arrives_on_an_rgb565_display(void **state)
{
    (void)state;
    format_arrives("rgb565", DRM_FORMAT_XRGB8888);
}

static void rgb888_arrives(void **state)
{
    (void)state;
    format_arrives("rgb888", DRM_FORMAT_RGB888);
}

static void xrgb8888_arrives(void **state)
{
    (void)state;
    format_arrives("xrgb8888", DRM_FORMAT_XRGB8888);
}

static void grey_arrives(void **state)
{
    (void)state;
    format_arrives("r8", DRM_FORMAT_XRGB8888);
}

static void black_and_white_arrives(void **state)
{
    (void)state;
    format_arrives("r1", DRM_FORMAT_XRGB8888);
}

static void eight_colours_arrive(void **state)
{
    (void)state;
    format_arrives("xrgb1111", DRM_FORMAT_XRGB8888);
}

static void rgb332_arrives(void **state)
{
    (void)state;
    format_arrives("rgb332", DRM_FORMAT_XRGB8888);
}

/* ---- what happens to USB devices ---- */

static void is_a_display_again(void)
{
    draws_all("rgb565", DRM_FORMAT_RGB565);
}

static void unbind(const char *gadget_name)
{
    assert_int_equal(run("echo >/sys/kernel/config/usb_gadget/%s/UDC", gadget_name), 0);
}

static void unbound_by_someone_it_binds_again(void **state)
{
    (void)state;
    gadget_start("GADGET", "--formats rgb565");
    is_a_display_again();
    unbind("glint");
    is_a_display_again();
    assert_int_equal(process_end(&gadget, SIGINT), 0);
}

static void after_a_reset_by_the_host_it_is_a_display_again(void **state)
{
    (void)state;
    gadget_start("GADGET", "--formats rgb565");
    is_a_display_again();
    for (unsigned turn = 0; turn < 3; turn++) {
        const int device = open("/sys/bus/usb/devices/1-1/devnum", O_RDONLY);
        char text[16] = "", path[64];
        assert_true(device >= 0 && read(device, text, sizeof text - 1) > 0);
        close(device);
        snprintf(path, sizeof path, "/dev/bus/usb/001/%03d", atoi(text));
        const int usb = open(path, O_WRONLY);
        assert_true(usb >= 0);
        assert_int_equal(ioctl(usb, USBDEVFS_RESET, 0), 0);
        close(usb);
        is_a_display_again();
    }
    assert_int_equal(process_end(&gadget, SIGINT), 0);
}

static void killed_and_started_again_it_cleans_up(void **state)
{
    (void)state;
    gadget_start("GADGET", "--formats rgb565");
    is_a_display_again();
    assert_int_equal(process_end(&gadget, SIGKILL), 128 + SIGKILL);
    gadget_start("GADGET", "--formats rgb565");
    is_a_display_again();
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
    assert_int_equal(access("/sys/kernel/config/usb_gadget/glint", F_OK), -1);
    assert_int_equal(access("/dev/ffs-glint", F_OK), -1);
}

static void unplugged_in_the_middle_of_a_rectangle_and_back_it_is_a_display_again(void **state)
{
    (void)state;
    gadget_start("FAULTY", "--formats rgb565 --fault unplug --after 1500 --back 300");
    card_open(WIDTH, HEIGHT);
    card_show(DRM_FORMAT_RGB565);
    draw(NOISE, 0, 0, 0, WIDTH, HEIGHT);
    struct drm_clip_rect clip = {0, 0, WIDTH, HEIGHT};
    struct drm_mode_fb_dirty_cmd dirty = {.fb_id = card.frame, .num_clips = 1, .clips_ptr = (uintptr_t)&clip};
    (void)ioctl(card.file, DRM_IOCTL_MODE_DIRTYFB, &dirty); /* it may be gone already */
    process_wait_for(&gadget, "unbound");
    card_close();
    usleep(100000); /* of virtual time */
    is_a_display_again();
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
}

/* The framebuffer is another gadget's, as the kernel has it: the picture goes through both. */
static void on_a_framebuffer_it_shows_the_picture(void **state)
{
    (void)state;
    struct process front;
    gadget_start("GADGET", "--formats rgb565 --udc dummy_udc.0");
    wait_for_file("/dev/fb0");
    process_start(&front, "$GADGET --name front --size %dx%d --formats rgb565 --udc dummy_udc.1 --framebuffer /dev/fb0",
                  WIDTH, HEIGHT);
    wait_for_file("/dev/fb1");
    const int file = open("/dev/fb1", O_RDWR);
    struct fb_fix_screeninfo memory;
    assert_true(file >= 0);
    assert_int_equal(ioctl(file, FBIOGET_FSCREENINFO, &memory), 0);
    const size_t bytes = (size_t)HEIGHT * memory.line_length;
    uint8_t *pixels = calloc(1, bytes);
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            const unsigned word = (unsigned)rand() & 0xffff;
            pixels[y * memory.line_length + 2 * x] = (uint8_t)word;
            pixels[y * memory.line_length + 2 * x + 1] = (uint8_t)(word >> 8);
            source[y][x][0] = (uint8_t)(word >> 11 << 3);
            source[y][x][1] = (uint8_t)((word >> 5 & 63) << 2);
            source[y][x][2] = (uint8_t)((word & 31) << 3);
        }
    assert_int_equal(pwrite(file, pixels, bytes, 0), bytes); /* in one: see picture.c */
    free(pixels);
    close(file);
    arrives("rgb565", "a picture through two displays");
    assert_int_equal(process_end(&front, SIGTERM), 0);
    memset(source, 0, sizeof source);
    arrives("rgb565", "black, at the end of the one in front");
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
}

static void a_second_one_is_refused_in_one_line(void **state)
{
    (void)state;
    gadget_start("GADGET", "--formats rgb565");
    card_open(WIDTH, HEIGHT);
    close(card.file);
    static const struct {
        const char *options, *message;
    } tries[] = {
        {"", "glint: in use by another program; end it, or give another --name"},
        {"--name other --udc dummy_udc.0", "dummy_udc.0: in use by another gadget; free it, or name another by --udc"},
        {"--name other --udc no", "--udc: there is no USB device controller 'no' in /sys/class/udc"}};
    for (unsigned i = 0; i < sizeof tries / sizeof *tries; i++) {
        char command[300], text[300] = "";
        snprintf(command, sizeof command, "%s %s 2>&1", getenv("GADGET"), tries[i].options);
        FILE *pipe = popen(command, "r");
        text[fread(text, 1, sizeof text - 1, pipe)] = 0;
        assert_int_equal(WEXITSTATUS(pclose(pipe)), 1);
        if (!strstr(text, tries[i].message) || strchr(text, '\n') != text + strlen(text) - 1)
            fail_msg("%s", text);
    }
    is_a_display_again();
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(rgb565_arrives, lab_clean),
        cmocka_unit_test_teardown(xrgb8888_arrives_on_an_rgb565_display, lab_clean),
        cmocka_unit_test_teardown(rgb888_arrives, lab_clean),
        cmocka_unit_test_teardown(xrgb8888_arrives, lab_clean),
        cmocka_unit_test_teardown(grey_arrives, lab_clean),
        cmocka_unit_test_teardown(black_and_white_arrives, lab_clean),
        cmocka_unit_test_teardown(eight_colours_arrive, lab_clean),
        cmocka_unit_test_teardown(rgb332_arrives, lab_clean),
        cmocka_unit_test_teardown(unbound_by_someone_it_binds_again, lab_clean),
        cmocka_unit_test_teardown(after_a_reset_by_the_host_it_is_a_display_again, lab_clean),
        cmocka_unit_test_teardown(killed_and_started_again_it_cleans_up, lab_clean),
        cmocka_unit_test_teardown(unplugged_in_the_middle_of_a_rectangle_and_back_it_is_a_display_again, lab_clean),
        cmocka_unit_test_teardown(on_a_framebuffer_it_shows_the_picture, lab_clean),
        cmocka_unit_test_teardown(a_second_one_is_refused_in_one_line, lab_clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
