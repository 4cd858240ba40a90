/* SPDX-License-Identifier: MIT
 * `glint render` with --light, --point and --spot. */
#include "image/read.h"
#include "files.h"

#include "image/image.h"

enum { SIDE = 64 };

/* Group set-up: besides the scratch folder a flat height map. */
static int flat_map(void **state)
{
    static const uint16_t samples[SIDE * SIDE];
    if (scratch_make(state) != 0 || system("mkdir out") != 0)
        return -1;
    make_png("flat.png", &(struct made_png){SIDE, SIDE, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, samples, NULL, 0});
    return 0;
}

static struct image *flat_under(const char *lights)
{
    char line[300];
    snprintf(line, sizeof line,
             "$GLINT render --height flat.png --ambient 0 --diffuse 1 --specular 0 --color 255,255,255 %s -o out/f.png "
             "2>out/flat.txt", /* which says that the map has no heights */
             lights);
    assert_quiet(line);
    return image_read("out/f.png");
}

static unsigned sample(const struct image *image, unsigned x, unsigned y, unsigned k)
{
    return image->samples[(y * SIDE + x) * image->channels + k];
}

static void a_flat_surface_is_brightest_under_the_point_light(void **state)
{
    (void)state;
    struct image *image = flat_under("--point 10.5,40.5,20,60");
    const unsigned top = sample(image, 10, 40, 0);
    for (unsigned y = 0; y < SIDE; y++)
        for (unsigned x = 0; x < SIDE; x++)
            if (x != 10 || y != 40)
                assert_true(sample(image, x, y, 0) < top || (x > 7 && x < 14 && y > 37 && y < 44));
    assert_int_equal(sample(image, 63, 1, 0), 0);                         /* beyond the range */
    assert_int_equal(sample(image, 10, 38, 0), sample(image, 10, 42, 0)); /* the same on all sides */
    assert_int_equal(sample(image, 8, 40, 0), sample(image, 12, 40, 0));
    image_free(image);
}

static void a_spot_lights_what_it_is_aimed_at(void **state)
{
    (void)state;
    struct image *image = flat_under("--spot 10.5,10.5,30,40.5,50.5,200,5,10,0,1,0");
    assert_true(sample(image, 40, 50, 1) > 0);
    assert_int_equal(sample(image, 40, 50, 0), 0); /* it is green */
    assert_int_equal(sample(image, 10, 10, 1), 0); /* nothing straight below */
    assert_int_equal(sample(image, 50, 40, 1), 0);
    image_free(image);
}

static void one_white_light_may_come_with_its_colour(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --scene coin --size 64x64 --light=1,2,3 -o out/a.ppm");
    assert_quiet("$GLINT render --scene coin --size 64x64 --light=1,2,3,1,1,1 -o out/b.ppm");
    assert_quiet("$GLINT render --scene coin --size 64x64 --light=1,2,3,1,1,.5 -o out/c.ppm");
    assert_quiet("$GLINT render --scene coin --size 64x64 --light=1,2,3 --light=1,2,3,0,0,0 -o out/d.ppm");
    assert_same_file("out/a.ppm", "out/b.ppm");
    assert_same_file("out/a.ppm", "out/d.ppm");
    assert_false(same_file("out/a.ppm", "out/c.ppm"));
}

static void a_point_light_takes_the_place_of_the_default_light(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --scene coin --size 64x64 --point 1e5,1e5,1,2 --ambient .3 -o out/dark.ppm");
    assert_quiet("$GLINT render --scene coin --size 64x64 --diffuse 0 --specular 0 --ambient .3 -o out/ambient.ppm");
    assert_same_file("out/dark.ppm", "out/ambient.ppm");
}

static void four_lights_compare_well_with_doubles(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT render --scene coin --size 64x64 -q 16 --compare --light 1,1,1,.2,.2,.2 --point 5,5,30,90 "
            "--point 60,60,30,90,.5,.5,1 --spot 30,70,40,32,32,99,20,30 --json");
    assert_int_equal(result->status, 0);
    const char *largest = strstr(strstr(result->out, "\"unrounded\""), "\"largest\": ");
    assert_non_null(largest);
    assert_in_range((int)(1000 * strtod(largest + strlen("\"largest\": "), NULL)), 400, 600);
}

static void places_count_to_a_sixteenth_of_a_pixel_for_the_reference_too(void **state)
{
    (void)state;
    const char *const scene = "$GLINT render --scene sphere --size 40x40 --json --point ";
    char line[200];
    snprintf(line, sizeof line, "%s 20,10,30,90", scene);
    char *exact = strdup(run(line)->out);
    assert_non_null(exact);
    assert_contains(exact, "psnr");
    snprintf(line, sizeof line, "%s 20.03,9.97,30.03,90.03", scene);
    assert_string_equal(run(line)->out, exact);
    free(exact);
}

static void wrong_lights_are_refused_with_what_is_allowed(void **state)
{
    (void)state;
    static const struct {
        const char *options, *about;
    } wrong[] = {
        {"--path span --point 1,2,3,4",
         "--path span: takes only one --light without a colour; other lights need --path exact or exact-int8"},
        {"--path colour-int16 --format rgb565 --light 1,1,1 --light 1,2,1", "takes only one --light"},
        {"--point 1,2,3", "--point: '1,2,3' is not 4 numbers separated by commas, or 7 with a colour"},
        {"--point 1,2,3,4,5", "or 7"},
        {"--point 1,2,3,x", "--point: '1,2,3,x'"},
        {"--point 1,2,3,", "--point: '1,2,3,'"},
        {"--point 1,2,3,0", "the range must be from 1/16"},
        {"--point 1,2,3,-5", "the range must be from 1/16"},
        {"--point 1,2,3,600000", "to 524288"},
        {"--point 1,2,600000,5", "more than 524288 pixels away"},
        {"--point 1,2,3,4,1,1,17", "from 0 to 16"},
        {"--point 1,2,3,4,1,1,-1", "from 0 to 16"},
        {"--light 1,2,3,4", "not 3 numbers separated by commas, or 6 with a colour"},
        {"--light 1,2,3,1,1,99", "from 0 to 16"},
        {"--light 1,1,1 --light 0,0,-1", "opposite"},
        {"--spot 1,2,3,4,5,6,7", "not 8 numbers"},
        {"--spot 1,2,3,4,5,6,20,10", "INNER <= OUTER"},
        {"--spot 1,2,3,4,5,6,-1,10", "0 <= INNER"},
        {"--spot 1,2,3,4,5,6,20,190", "180 degrees"},
        {"--spot 1,2,0,1,2,6,10,20", "own place"},
        {"--spot 1,2,3,4,700000,6,10,20", "the target is more than"},
        {"--spot 1,2,3,4,5,0,10,20", "the range must be"},
        {"--light 1,1,1 --light 1,1,1 --point 1,2,3,4 --light 1,1,1 --point 5,2,3,4",
         "--point: more than 4 lights; give --light, --point and --spot at most 4 times in all"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT render --scene sphere -o out/u.png %s", wrong[i].options);
        assert_refused(line, wrong[i].about);
        assert_false(exists("out/u.png"));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flat_surface_is_brightest_under_the_point_light),
        cmocka_unit_test(a_spot_lights_what_it_is_aimed_at),
        cmocka_unit_test(one_white_light_may_come_with_its_colour),
        cmocka_unit_test(a_point_light_takes_the_place_of_the_default_light),
        cmocka_unit_test(four_lights_compare_well_with_doubles),
        cmocka_unit_test(places_count_to_a_sixteenth_of_a_pixel_for_the_reference_too),
        cmocka_unit_test(wrong_lights_are_refused_with_what_is_allowed),
    };
    return cmocka_run_group_tests_name("render lights", tests, flat_map, scratch_remove);
}
