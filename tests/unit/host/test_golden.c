/* SPDX-License-Identifier: MIT
 * The golden pictures of tests/golden, drawn again and compared pixel for pixel; the mesh's by how they look. */
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

/* Conformance tests hold the bits of meshes; here is what one sees. */
static void the_teapot_looks_as_it_did_also_by_gouraud(void **state)
{
    (void)state;
    static const char *const names[] = {"teapot.png", "teapot-gouraud.png"};
    for (int i = 0; i < 2; i++) {
        char path[1024];
        double sum = 0;
        snprintf(path, sizeof path, "%s/tests/golden/%s", getenv("GLINT_SOURCE"), names[i]);
        struct image *golden = image_read(path), *drawn = image_read(names[i]);
        assert_int_equal(drawn->width * 1000 + drawn->height, 256192);
        assert_int_equal(drawn->channels, golden->channels);
        for (size_t k = 0; k < (size_t)256 * 192 * drawn->channels; k++)
            sum += abs(golden->samples[k] - drawn->samples[k]) / 257.;
        assert_true(sum / (256 * 192 * 3) < .02); /* levels; n = 61 in the place of 60 makes it .04 */
        image_free(golden);
        image_free(drawn);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rock_wall_is_as_it_was),
        cmocka_unit_test(the_sphere_is_as_it_was),
        cmocka_unit_test(the_watchface_is_as_it_was),
        cmocka_unit_test(the_coin_is_as_it_was),
        cmocka_unit_test(the_teapot_looks_as_it_did_also_by_gouraud),
    };
    return cmocka_run_group_tests_name("golden", tests, draw_all, scratch_remove);
}
