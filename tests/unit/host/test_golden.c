/* SPDX-License-Identifier: MIT
 * The golden pictures of tests/golden, drawn again and compared pixel for pixel. */
#include <stdio.h>

#include "image/read.h"
#include "run.h"

#include "image/image.h"

static int draw_all(void **state)
{
    char line[1024];
    snprintf(line, sizeof line, "'%s/tests/golden/draw' \"$GLINT\" .", getenv("GLINT_SOURCE"));
    return scratch_make(state) == 0 && system(line) == 0 ? 0 : -1;
}

static void assert_golden(const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/tests/golden/%s", getenv("GLINT_SOURCE"), name);
    struct image *golden = image_read(path), *drawn = image_read(name);
    assert_int_equal(drawn->width, golden->width);
    assert_int_equal(drawn->height, golden->height);
    assert_int_equal(drawn->channels, golden->channels);
    unsigned differing = 0;
    for (size_t i = 0; i < (size_t)golden->width * golden->height * golden->channels; i++)
        differing += drawn->samples[i] != golden->samples[i];
    if (differing)
        fail_msg("%s: %u samples differ from tests/golden/%s", name, differing, name);
    image_free(golden);
    image_free(drawn);
}

static void the_rock_wall_is_as_it_was(void **state)
{
    (void)state;
    assert_golden("rockwall.png");
}

static void the_sphere_is_as_it_was(void **state)
{
    (void)state;
    assert_golden("sphere.png");
}

static void the_watchface_is_as_it_was(void **state)
{
    (void)state;
    assert_golden("watchface.png");
}

static void the_coin_is_as_it_was(void **state)
{
    (void)state;
    assert_golden("coin.png");
}

static void the_teapot_is_as_it_was_also_by_gouraud(void **state)
{
    (void)state;
    assert_golden("teapot.png");
    assert_golden("teapot-gouraud.png");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rock_wall_is_as_it_was),
        cmocka_unit_test(the_sphere_is_as_it_was),
        cmocka_unit_test(the_watchface_is_as_it_was),
        cmocka_unit_test(the_coin_is_as_it_was),
        cmocka_unit_test(the_teapot_is_as_it_was_also_by_gouraud),
    };
    return cmocka_run_group_tests_name("golden", tests, draw_all, scratch_remove);
}
