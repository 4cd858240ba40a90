/* SPDX-License-Identifier: MIT
 * glint-gadget's framebuffers: where pixels lie, in every visual, whatever a driver states. */
#include <string.h>
#include <unistd.h>

#include "unit.h"

#include "../../../firmware/ports/linux/framebuffer.c"

static struct fb_var_screeninfo screen;
static struct fb_fix_screeninfo memory;

/* 32 bits a pixel, x8r8g8b8; 100x50 pixels, twice as high in memory. */
static int reset(void **state)
{
    (void)state;
    screen = (struct fb_var_screeninfo){
        .xres = 100, .yres = 50, .bits_per_pixel = 32, .red = {16, 8, 0}, .green = {8, 8, 0}, .blue = {0, 8, 0}};
    memory = (struct fb_fix_screeninfo){
        .type = FB_TYPE_PACKED_PIXELS, .visual = FB_VISUAL_TRUECOLOR, .line_length = 400, .smem_len = 400 * 100};
    return 0;
}

static const char *layout(struct framebuffer *framebuffer)
{
    return framebuffer_layout(framebuffer, &screen, &memory, 100, 50);
}

/* A pixel of r = 0xfb, g = 0x83, b = 0x27, and nothing beside it. */
static void assert_pixel(const uint8_t *wanted, unsigned bytes)
{
    static const uint8_t rgb[] = {0xfb, 0x83, 0x27};
    uint8_t memory_there[12] = {0};
    struct framebuffer framebuffer;
    screen.bits_per_pixel = 8 * bytes;
    assert_null(layout(&framebuffer));
    framebuffer.pixels = memory_there;
    framebuffer_put(&framebuffer, 1, 0, 1, rgb);
    assert_memory_equal(memory_there + bytes, wanted, bytes);
    for (unsigned i = 0; i < sizeof memory_there; i++)
        assert_true((i >= bytes && i < 2 * bytes) || memory_there[i] == 0);
}

static void pixels_are_rgb_or_bgr_as_the_driver_states(void **state)
{
    assert_pixel((const uint8_t[]){0x27, 0x83, 0xfb, 0}, 4);
    assert_pixel((const uint8_t[]){0x27, 0x83, 0xfb}, 3);
    screen.red.offset = 0;
    screen.blue.offset = 16;
    assert_pixel((const uint8_t[]){0xfb, 0x83, 0x27, 0}, 4);
    assert_pixel((const uint8_t[]){0xfb, 0x83, 0x27}, 3);
    reset(state);
    screen.red = (struct fb_bitfield){11, 5, 0};
    screen.green = (struct fb_bitfield){5, 6, 0};
    screen.blue = (struct fb_bitfield){0, 5, 0};
    assert_pixel((const uint8_t[]){0x04, 0xfc}, 2); /* 11111 100000 00100 */
    screen.red.offset = 0;
    screen.blue.offset = 11;
    assert_pixel((const uint8_t[]){0x1f, 0x24}, 2);
    reset(state);
    screen.red = (struct fb_bitfield){20, 10, 0}; /* ten bits: 0xfb repeated is 0x3ef */
    screen.green = (struct fb_bitfield){10, 10, 0};
    screen.blue = (struct fb_bitfield){0, 10, 0};
    const uint32_t wanted = UINT32_C(0x3ef) << 20 | UINT32_C(0x20e) << 10 | 0x9c;
    assert_pixel(
        (const uint8_t[]){(uint8_t)wanted, (uint8_t)(wanted >> 8), (uint8_t)(wanted >> 16), (uint8_t)(wanted >> 24)},
        4);
}

static void alpha_is_opaque_where_a_pixel_has_it(void **state)
{
    screen.transp = (struct fb_bitfield){24, 8, 0};
    assert_pixel((const uint8_t[]){0x27, 0x83, 0xfb, 0xff}, 4);
    assert_pixel((const uint8_t[]){0x27, 0x83, 0xfb}, 3); /* it does not lie in the pixel */
    screen.transp.offset = 20;                            /* overlaps red, which stays */
    assert_pixel((const uint8_t[]){0x27, 0x83, 0xfb, 0x0f}, 4);
    reset(state);
    screen.red = (struct fb_bitfield){10, 5, 0};
    screen.green = (struct fb_bitfield){5, 5, 0};
    screen.blue = (struct fb_bitfield){0, 5, 0};
    screen.transp = (struct fb_bitfield){15, 1, 0};
    assert_pixel((const uint8_t[]){0x04, 0xfe}, 2); /* 1 11111 10000 00100 */
}

static void black_is_opaque_too(void **state)
{
    (void)state;
    uint8_t memory_there[12];
    struct framebuffer framebuffer;
    screen.transp = (struct fb_bitfield){24, 8, 0};
    assert_null(layout(&framebuffer));
    memset(memory_there, 7, sizeof memory_there);
    framebuffer.pixels = memory_there;
    framebuffer_put(&framebuffer, 1, 0, 1, NULL);
    assert_memory_equal(memory_there, ((const uint8_t[]){7, 7, 7, 7, 0, 0, 0, 0xff, 7, 7, 7, 7}), 12);
}

/* The kernel maps whole pages, from the one in which the memory begins. */
static void memory_may_begin_within_a_page(void **state)
{
    (void)state;
    struct framebuffer framebuffer;
    const unsigned long page = (unsigned long)sysconf(_SC_PAGESIZE);
    memory.smem_start = 5 * page + 48;
    screen.yoffset = 50;
    assert_null(layout(&framebuffer));
    assert_int_equal(framebuffer.offset, 48 + 50 * 400);
    assert_int_equal(framebuffer.bytes, 48 + 400 * 100);
    memory.smem_len = UINT32_MAX - 47;
    assert_non_null(layout(&framebuffer));
}

static void a_picture_outside_the_memory_is_refused(void **state)
{
    struct framebuffer framebuffer;
    (void)state;
    screen.yoffset = 50;
    assert_null(layout(&framebuffer)); /* its last byte is the memory's */
    assert_int_equal(framebuffer.offset, 50 * 400);
    screen.yoffset = 51;
    assert_non_null(layout(&framebuffer));
    screen.yoffset = UINT32_MAX;
    assert_non_null(layout(&framebuffer));
    screen.yoffset = 0;
    screen.xoffset = 1; /* its lines end in the next ones */
    assert_non_null(layout(&framebuffer));
    screen.xoffset = UINT32_MAX;
    assert_non_null(layout(&framebuffer));
    screen.xoffset = 0;
    memory.smem_len = 400 * 50 - 1;
    assert_non_null(layout(&framebuffer));
    memory.line_length = 399;
    assert_non_null(layout(&framebuffer));
    memory.line_length = UINT32_MAX;
    assert_non_null(layout(&framebuffer));
    memory.smem_len = UINT32_MAX;
    screen.yoffset = UINT32_MAX - 47; /* 2^32 + 2 lines, of which the bytes modulo 2^64 would lie in the memory */
    assert_non_null(layout(&framebuffer));
    memory.line_length = 0;
    assert_non_null(layout(&framebuffer));
}

static void visuals_without_three_channels_are_refused(void **state)
{
    struct framebuffer framebuffer;
    memory.visual = FB_VISUAL_PSEUDOCOLOR;
    assert_non_null(layout(&framebuffer));
    reset(state);
    screen.grayscale = 1;
    assert_non_null(layout(&framebuffer));
    reset(state);
    memory.type = FB_TYPE_PLANES;
    assert_non_null(layout(&framebuffer));
    reset(state);
    screen.green.offset = 9; /* overlaps red */
    assert_non_null(layout(&framebuffer));
    reset(state);
    screen.red.offset = 25; /* ends above the pixel */
    assert_non_null(layout(&framebuffer));
    reset(state);
    screen.blue.length = 0;
    assert_non_null(layout(&framebuffer));
    reset(state);
    screen.bits_per_pixel = 8;
    assert_non_null(layout(&framebuffer));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(pixels_are_rgb_or_bgr_as_the_driver_states, reset),
        cmocka_unit_test_setup(alpha_is_opaque_where_a_pixel_has_it, reset),
        cmocka_unit_test_setup(black_is_opaque_too, reset),
        cmocka_unit_test_setup(memory_may_begin_within_a_page, reset),
        cmocka_unit_test_setup(a_picture_outside_the_memory_is_refused, reset),
        cmocka_unit_test_setup(visuals_without_three_channels_are_refused, reset),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
