/* SPDX-License-Identifier: MIT
 * glint-gadget's pictures: what the device draws, in files of which there are never more than --each says. */
#include <stdio.h>
#include <string.h>

#include "files.h"

#include "../../../firmware/ports/linux/framebuffer.c"
#include "../../../firmware/ports/linux/message.c"
#include "../../../firmware/ports/linux/picture_file.c"
#include "../../../firmware/ports/linux/picture.c"

static void draw(struct picture *drawn, uint16_t x, uint16_t y, uint8_t grey, bool whole)
{
    const uint8_t pixel[3] = {grey, grey, grey};
    picture_ops.window(drawn, x, y, 1, 1);
    picture_ops.line(drawn, pixel, sizeof pixel);
    picture_ops.end(drawn, whole);
}

static void no_more_files_are_written_than_each_allows(void **state)
{
    (void)state;
    const struct options options = {.width = 3, .height = 2, .output = "out/frame.ppm", .each = 4};
    struct picture drawn;
    picture_open(&drawn, &options);
    draw(&drawn, 0, 0, 9, false); /* cut short: no file */
    assert_int_equal(files_in("out"), 0);
    for (unsigned i = 0; i < 10; i++)
        draw(&drawn, (uint16_t)(i % 3), (uint16_t)(i / 3 % 2), (uint8_t)(10 + i), true);
    assert_int_equal(files_in("out"), 4);
    static const uint8_t greys[] = {10, 11, 12, 13, 0, 0};
    uint8_t bytes[64];
    const size_t head = strlen("P6 3 2 255\n");
    assert_int_equal(read_file("out/frame-000004.ppm", bytes, sizeof bytes), head + 3 * sizeof greys);
    for (size_t i = 0; i < 3 * sizeof greys; i++)
        assert_int_equal(bytes[head + i], greys[i / 3]);
    assert_false(exists("out/frame-000005.ppm"));
    assert_true(picture_write(&drawn)); /* the last picture is none of them */
    assert_true(exists("out/frame.ppm"));
    free(drawn.pixels);
}

static void assert_shown(const uint8_t *memory, const uint8_t greys[6])
{
    for (unsigned i = 0; i < 6; i++)
        for (unsigned k = 0; k < 4; k++)
            assert_int_equal(memory[4 * i + k], k == 3 ? 0xff : greys[i]);
}

static void a_display_that_is_off_is_black_and_on_again_has_its_picture(void **state)
{
    (void)state;
    uint8_t memory[3 * 2 * 4];
    const struct options options = {.width = 3, .height = 2};
    const struct fb_var_screeninfo screen = {.xres = 3,
                                             .yres = 2,
                                             .bits_per_pixel = 32,
                                             .red = {16, 8, 0},
                                             .green = {8, 8, 0},
                                             .blue = {0, 8, 0},
                                             .transp = {24, 8, 0}};
    const struct fb_fix_screeninfo fixed = {
        .type = FB_TYPE_PACKED_PIXELS, .visual = FB_VISUAL_TRUECOLOR, .line_length = 12, .smem_len = sizeof memory};
    struct picture drawn;
    picture_open(&drawn, &options);
    assert_null(framebuffer_layout(&drawn.framebuffer, &screen, &fixed, 3, 2));
    drawn.framebuffer.pixels = memory;
    picture_ops.display(&drawn, true, 100);
    draw(&drawn, 1, 0, 50, true);
    assert_shown(memory, (const uint8_t[]){0, 50, 0, 0, 0, 0});
    picture_ops.display(&drawn, false, 100);
    assert_shown(memory, (const uint8_t[6]){0});
    draw(&drawn, 2, 1, 60, true); /* hosts may draw on a display that is off */
    assert_shown(memory, (const uint8_t[6]){0});
    picture_ops.display(&drawn, true, 100);
    assert_shown(memory, (const uint8_t[]){0, 50, 0, 0, 0, 60});
    free(drawn.pixels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_display_that_is_off_is_black_and_on_again_has_its_picture),
        cmocka_unit_test(no_more_files_are_written_than_each_allows),
    };
    return cmocka_run_group_tests_name("picture", tests, make_maps, scratch_remove);
}
