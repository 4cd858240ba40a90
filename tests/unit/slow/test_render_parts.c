/* SPDX-License-Identifier: MIT
 * glint render of pictures that are drawn in parts: as one drawn at once, in little memory. */
#include "files.h"

/* --compare keeps the whole picture. 16384 pixels wide, a part has 64 lines. */
static void a_picture_in_parts_is_that_drawn_at_once(void **state)
{
    (void)state;
    static const char *const scenes[] = {"--height heights.png --albedo colors.png",
                                         "--height heights.png --wrap --format rgb565 --dither --point 9000,70,60,400",
                                         "--normals n.png --format grey8 --path exact-int8",
                                         "--scene sphere --cut-out --background 20,30,40 --format xrgb8888",
                                         "--scene sphere --cut-out --format argb8888",
                                         "--scene sunray --format mono --dither"};
    uint16_t samples[12 * 8 * 3];
    for (unsigned i = 0; i < 12 * 8 * 3; i++)
        samples[i] = (uint16_t)(i % 3 == 2 ? 200 : 90 + i * 7 % 70);
    make_png("n.png", &(struct made_png){
                          .width = 12, .height = 8, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = samples});
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        char line[400];
        snprintf(line, sizeof line,
                 "for i in raw qoi png; do for j in '' --compare; do $GLINT render %s --size 16384x81 $j --image $i -o "
                 "a$j.$i >/dev/null || exit 1; done; cmp a.$i a--compare.$i || exit 1; done",
                 scenes[i]);
        assert_int_equal(run(line)->status, 0);
    }
}

static void a_large_picture_takes_little_memory(void **state)
{
    (void)state;
    assert_quiet("ulimit -v 400000; OMP_NUM_THREADS=2 $GLINT render --height heights.png --albedo colors.png "
                 "--size 16384x2049 --format rgb565 --image raw -o - | wc -c | grep -qx 67141632");
    /* What is not drawn in parts says so. */
    static const char *const whole[] = {"--scene coin --compare", "--scene coin --path span",
                                        "--height heights.png --bevel 2", "--height heights.png --filter 2",
                                        "--scene teapot"};
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT render %s --size 8192x8192 -o out/no.ppm", whole[i]);
        assert_refused(line, "a picture has at most 33554432 pixels in all");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_picture_in_parts_is_that_drawn_at_once),
        cmocka_unit_test(a_large_picture_takes_little_memory),
    };
    return cmocka_run_group_tests_name("render parts", tests, make_maps, scratch_remove);
}
