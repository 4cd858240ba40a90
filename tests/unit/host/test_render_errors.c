/* SPDX-License-Identifier: MIT
 * What `glint render` says to wrong usage and where it cannot read or write, and how it ends. */
#include "files.h"

static void a_map_of_another_size_is_named_with_both_sizes(void **state)
{
    (void)state;
    static const char *const maps[] = {"--albedo", "--gloss", "--mask"};
    for (int i = 0; i < 3; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT render --height heights.png %s small.png -o out/none.png", maps[i]);
        assert_fails(line, "small.png: 4x4");
        assert_fails(line, "12x8");
    }
    assert_fails("$GLINT render --scene sphere --albedo small.png -o out/none.png", "320x320");
    assert_false(exists("out/none.png"));
}

static void wrong_usage_is_said_with_what_is_allowed_and_ends_with_2(void **state)
{
    (void)state;
    static const struct {
        const char *options, *about;
    } wrong[] = {
        {"", "--scene NAME"},
        {"--scene sphere", "-o FILE"},
        {"--scene sphere --height heights.png -o out/u.png", "only one of"},
        {"--scene sphere -n 0 -o out/u.png", "-n: '0' is not a whole number from 1 to 1000"},
        {"--scene sphere -n 1001 -o out/u.png", "1 to 1000"},
        {"--scene sphere -n 6.5 -o out/u.png", "1 to 1000"},
        {"--scene sphere -n '' -o out/u.png", "1 to 1000"},
        {"--scene sphere -q 17 -o out/u.png", "0 to 16"},
        {"--scene sphere -q -1 -o out/u.png", "0 to 16"},
        {"--scene sphere --model oren -o out/u.png", "msh, schlick, blinn"},
        {"--scene sphere --format rgb -o out/u.png", "rgb565, rgb565-swapped, rgb888, grey8, mono"},
        {"--scene sphere --space srgb -o out/u.png", "gamma, linear"},
        {"--scene sphere --path fast -o out/u.png", "exact"},
        {"--scene sphere --path small-int16 -o out/u.png", "exact, exact-int8, span, colour-int16"},
        {"--scene sphere --path exact-int10 -o out/u.png", "exact, exact-int8, span, colour-int16"},
        {"--scene sphere --path colour-int8 -o out/u.png", "--format rgb565"},
        {"--scene sphere --path colour-int8 --format rgb565 --dither --space linear -o out/u.png", "--space gamma"},
        {"--scene sphere --path albedo-int8 --format rgb565 --dither -o out/u.png", "--dither"},
        {"--scene sphere --path colour-int8 --format rgb565 --view 1,0,3 -o out/u.png", "--view 0,0,1"},
        {"--scene sphere --path albedo-int16 --format rgb565 --space linear -o out/u.png", "--space gamma"},
        {"--scene sphere --path albedo-int8 --format rgb565 --view 1,0,3 -o out/u.png", "--view 0,0,1"},
        {"--scene sphere --path albedo-span -o out/u.png", "--format rgb565"},
        {"--scene sphere --path palette --format rgb565 --dither -o out/u.png", "--dither"},
        {"--scene sphere --path span --model phong -o out/u.png", "phong"},
        {"--scene sphere --path span --format mono -o out/u.png", "mono"},
        {"--scene sphere --light 1,2 -o out/u.png", "--light"},
        {"--scene sphere --light 1,2,nan -o out/u.png", "--light"},
        {"--scene sphere --light 0,0,0 -o out/u.png", "--light: the direction must not be 0,0,0"},
        {"--scene sphere --view 0,0,0 -o out/u.png", "--view"},
        {"--scene sphere --light 0,0,-1 -o out/u.png", "opposite"},
        {"--scene sphere --ambient 2 -o out/u.png", "--ambient"},
        {"--scene sphere --diffuse 1,1 -o out/u.png", "--diffuse"},
        {"--scene sphere --specular red -o out/u.png", "--specular"},
        {"--scene sphere --color 256,0,0 -o out/u.png", "0 to 255"},
        {"--scene sphere --size 0x10 -o out/u.png", "WxH"},
        {"--scene sphere --size 10 -o out/u.png", "WxH"},
        {"--scene sphere --size 10x10x10 -o out/u.png", "WxH"},
        {"--scene sphere --size -10x10 -o out/u.png", "WxH"},
        {"--scene sphere --size 99999x10 -o out/u.png", "16384"},
        {"--scene sphere --size 16384x16384 --compare -o out/u.png", "pixels in all"},
        {"--scene sphere --scale 3 -o out/u.png", "--scale needs --height"},
        {"--scene sphere --wrap -o out/u.png", "--wrap needs --height"},
        {"--height heights.png --flip-y -o out/u.png", "--flip-y needs --normals"},
        {"--height heights.png --scale high -o out/u.png", "--scale"},
        {"--height heights.png --albedo colors.png --color 1,1,1 -o out/u.png", "--color"},
        {"--scene sphere --error-map - -o out/u.png", "--error-map: name a file; only the picture of -o"},
        {"--scene sphere --error-map out/u.png -o out/u.png", "the file of -o"},
        {"--scene sphere --against blinn -o out/u.png", "--error-map"},
        {"'height\ns.png' -o out/u.png", "'height?s.png'"}, /* one line, whatever is quoted */
        {"--scene 'sph\nere' -o out/u.png", "'sph?ere'"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT render %s", wrong[i].options);
        assert_refused(line, wrong[i].about);
        assert_false(exists("out/u.png"));
    }
    assert_refused("$GLINT render --scene sphere --shiny -o out/u.png", "--shiny");
    assert_false(exists("out/u.png"));
}

static void a_full_disk_gives_one_line_whatever_the_kind(void **state)
{
    (void)state;
    static const char *const kinds[] = {"png", "ppm", "qoi"};
    for (int i = 0; i < 3; i++) {
        char line[200];
        for (int side = 8; side <= 256; side *= 32) { /* less than a stream's buffer, and more */
            snprintf(line, sizeof line, "$GLINT render --scene sphere --size %dx%d --image %s -o /dev/full", side, side,
                     kinds[i]);
            assert_fails(line, "/dev/full: could not be written: No space left");
        }
        snprintf(line, sizeof line, "$GLINT render --scene sphere --image %s -o - >/dev/full", kinds[i]);
        assert_fails(line, "standard output: could not be written: No space left");
    }
}

static void what_cannot_be_written_leaves_nothing_behind(void **state)
{
    (void)state;
    const int before = files_in("out");
    assert_fails("$GLINT render --scene sphere -o out/missing/x.png", "out/missing/x.png");
    assert_fails("$GLINT render --scene sphere -o out", "out: this is a folder");
    assert_fails("$GLINT render --scene sphere -o out/..", "this is a folder");
    assert_int_equal(files_in("out"), before);
}

static void a_failure_keeps_the_picture_that_was_there(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --scene sphere --size 16x16 -o out/kept.png");
    assert_quiet("$GLINT render --scene sphere --size 16x16 -o out/copy.png");
    assert_fails("$GLINT render --height missing.png -o out/kept.png", "missing.png");
    assert_same_file("out/kept.png", "out/copy.png");
    const int before = files_in("out");
    /* A limit on file size ends the write half-way, as a full disk does. */
    assert_fails("(ulimit -f 1; exec $GLINT render --scene coin -o out/kept.png)", "kept.png");
    assert_int_equal(files_in("out"), before);
    assert_same_file("out/kept.png", "out/copy.png");
}

static void two_pictures_are_both_written_or_neither(void **state)
{
    (void)state;
    const int before = files_in("out");
    assert_fails("$GLINT render --scene sphere -o out/pair.png --error-map out/missing/e.png", "out/missing/e.png");
    assert_fails("$GLINT render --scene sphere -o out/missing/o.png --error-map out/pair.png", "out/missing/o.png");
    assert_fails("$GLINT render --scene sphere -o out/pair.png --error-map out", "out: this is a folder");
    assert_fails(
        "(ulimit -f 64; exec $GLINT render --scene sphere --format mono -o out/pair.png --error-map out/e.ppm)",
        "out/e.ppm: could not be written");
    assert_fails("$GLINT render --scene sphere -o out/pair.png --compare >/dev/full", "standard output");
    assert_int_equal(files_in("out"), before);
    assert_int_equal(run("$GLINT render --scene sphere -o out/pair.png --error-map out/e.png")->status, 0);
    assert_int_equal(files_in("out"), before + 2);
    assert_int_equal(run("rm out/pair.png out/e.png")->status, 0);
}

static void one_file_for_both_pictures_is_refused_whatever_its_names(void **state)
{
    (void)state;
    static const struct {
        const char *first, *second;
    } names[] = {
        {"out/new.png", "out/new.png"},
        {"out/new.png", "./out/new.png"},
        {"out/../out/new.png", "out//new.png"},
        {"out/dangling.png", "out/new.png"},
        {"out/new.png", "link/new.png"},
        {"out/there.png", "./out/there.png"},
        {"out/symbolic.png", "out/there.png"},
        {"out/hard.png", "out/there.png"},
        {"new.png", "./new.png"},
        {"out/dangling.png", "link/new.png"},
    };
    assert_int_equal(run("echo old >out/there.png; ln -s there.png out/symbolic.png; ln -s new.png out/dangling.png;"
                         "ln out/there.png out/hard.png; ln -s out link")
                         ->status,
                     0);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT render --scene sphere -o %s --error-map %s", names[i].first,
                 names[i].second);
        assert_refused(line, "--error-map: this is the file of -o, too");
        snprintf(line, sizeof line, "$GLINT render --scene sphere -o %s --error-map %s", names[i].second,
                 names[i].first);
        assert_refused(line, "--error-map: this is the file of -o, too");
    }
    assert_string_equal(run("cat out/there.png")->out, "old\n");
    assert_int_equal(run("$GLINT render --scene sphere -o out/x.png --error-map ./x.png && rm out/x.png x.png")->status,
                     0);
    assert_int_equal(run("rm out/*.png link")->status, 0);
}

static void a_failure_is_one_line_after_a_height_map_in_colour_too(void **state)
{
    (void)state;
    assert_fails("$GLINT render --height colors.png --albedo small.png -o out/x.png", "small.png: 4x4 pixels");
    assert_fails("$GLINT render --height colors.png --mask small.png -o out/x.png", "small.png: 4x4 pixels");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_map_of_another_size_is_named_with_both_sizes),
        cmocka_unit_test(wrong_usage_is_said_with_what_is_allowed_and_ends_with_2),
        cmocka_unit_test(a_full_disk_gives_one_line_whatever_the_kind),
        cmocka_unit_test(what_cannot_be_written_leaves_nothing_behind),
        cmocka_unit_test(two_pictures_are_both_written_or_neither),
        cmocka_unit_test(one_file_for_both_pictures_is_refused_whatever_its_names),
        cmocka_unit_test(a_failure_keeps_the_picture_that_was_there),
        cmocka_unit_test(a_failure_is_one_line_after_a_height_map_in_colour_too),
    };
    return cmocka_run_group_tests_name("$GLINT render errors", tests, make_maps, scratch_remove);
}
