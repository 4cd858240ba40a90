/* SPDX-License-Identifier: MIT
 * What `glint stream` refuses, in which words, and its help. */
#include "files.h"

#include "sinks/sinks.h"

#define SPHERE "$GLINT stream sphere --size 60x40 --to png "

static void wrong_usage_is_said_with_what_is_allowed_and_ends_with_2(void **state)
{
    (void)state;
    static const struct {
        const char *options, *about;
    } wrong[] = {
        {"--to png -o out/x%d.png", "no surface"},
        {"sphere coin --to png -o out/x%d.png", "unexpected argument 'coin'; one scene is enough"},
        {"--scene sphere coin --to png -o out/x%d.png", "unexpected argument 'coin'; one scene is enough"},
        {"wall.png --to png -o out/x%d.png", "unexpected argument 'wall.png'; name files by --height"},
        {"wall --to png -o out/x%d.png", "unknown scene 'wall'; choose from sphere, "},
        {"sphere --to tv -o out/x%d.png", "--to: unknown sink 'tv'; choose from"},
        {"sphere --to png", "name it: -o frame-%04d.png"},
        {"sphere --to ppm", "name it: -o frame-%04d.ppm"},
        {"sphere --to png -o ''", "the file name is empty"},
        {"sphere --to png -o -", "a file for each frame; for standard output choose --to raw"},
        {"sphere --to png -o out/x.png", "--frames 1"},
        {"sphere --to png -o out/x%d-%d.png", "2 places"},
        {"sphere --to png -o out/x%s.png", "neither %d nor %04d"},
        {"sphere --to png -o out/x%n.png", "neither %d nor %04d"},
        {"sphere --to png -o out/x%12d.png", "neither %d nor %04d"},
        {"sphere --to png -o out/x%*d.png", "neither %d nor %04d"},
        {"sphere --to png -o out/x%", "neither %d nor %04d"},
        {"sphere --to raw -o out/x%d.png", "writes no files"},
        {"sphere --to png -o out/x%d.png --fps -1", "--fps: '-1' is not a number from 0 to 1000"},
        {"sphere --to png -o out/x%d.png --fps 1e-300", "--fps: '1e-300' is too small; give 0, or 1e-06 or more"},
        {"sphere --to png -o out/x%d.png --period 9e-7", "--period: '9e-7' is too small"},
        {"sphere --to png -o out/x%d.png --frames 0", "--frames: '0' is not a whole number from 1"},
        {"sphere --to png -o out/x%d.png --orbit 180", "from 0 to 179"},
        {"sphere --to png -o out/x%d.png --period -4", "--period"},
        {"sphere --to png -o out/x%d.png --lights l --orbit 3", "leave out --orbit"},
        {"sphere --to png -o out/x%d.png --lights l --period 3", "leave out --period"},
        {"sphere --to png -o out/x%d.png --lights l --point 1,1,1,9", "moves a --light"},
        {"sphere --to png -o out/x%d.png --orbit 9 --point 1,1,1,9", "--orbit: is for a --light"},
        {"--height - --to png -o out/x%d.png --lights -", "only one of --lights, the maps"},
        {"sphere --to png -o out/x%d.png --path colour-int8 --format rgb888", "needs --format rgb565"},
        {"sphere --to png -o out/x%d.png --light 0,0,-1", "opposite"},
        {"sphere --to none --link-rate 0", "--link-rate: '0' is not a number from 0.001"},
        {"sphere --to none --link-rectangle -1", "--link-rectangle: '-1' is not a number from 0"},
        {"sphere --to none --lights ''", "--lights: the file name is empty"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT stream %s", wrong[i].options);
        assert_refused(line, wrong[i].about);
    }
    assert_refused("$GLINT list usb", "unexpected argument 'usb'");
    assert_int_equal(files_in("out"), 0);
}

static void a_signal_ends_lines_of_lights_that_never_end(void **state)
{
    (void)state;
    const struct run *result =
        run("yes '' | timeout --foreground --preserve-status -s INT .5 " SPHERE "--to none --lights -");
    assert_int_equal(result->status, 130);
    assert_string_equal(result->err, "");
}

static void a_wrong_line_of_lights_is_named_by_its_number(void **state)
{
    (void)state;
    static const struct {
        const char *lines, *about;
    } wrong[] = {
        {"1 1 1\\n\\n1 1\\n", "lights.txt, line 3: '1 1' is not a direction"},
        {"1 1 1 1\\n", "line 1"},
        {"1,,1,1\\n", "line 1"},
        {"1-1-1\\n", "line 1"},
        {"one 1 1\\n", "'one 1 1'"},
        {"1 1 inf\\n", "line 1"},
        {"0x10 1 1\\n", "line 1: '0x10 1 1' is not a direction"},
        {"0 0 0\\n", "line 1: '0 0 0' has no direction"},
        {"1 1 1\\n0 0 -2\\n", "line 2: '0 0 -2' is straight opposite"},
        {"1 1 1\\0001\\n", "line 1"},
        {"1 1 1\\n\\000-1 1 1\\n", "line 2"},
        {"# nothing\\n", "lights.txt: holds no direction"},
        {"", "lights.txt: holds no direction"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[200];
        snprintf(line, sizeof line, "printf '%s' >lights.txt; " SPHERE "--to raw --lights lights.txt >frames",
                 wrong[i].lines);
        assert_fails(line, wrong[i].about);
    }
    assert_fails(SPHERE "--to raw --lights - </dev/null", "standard input: holds no direction");
    assert_fails("printf %01000d 1 | " SPHERE "--to raw --lights -", "standard input, line 1: has more than 999");
    assert_fails(SPHERE "--to raw --lights none.txt >frames", "none.txt: cannot be read: No such file");
    assert_fails(SPHERE "--to raw --lights . >frames", ".: cannot be read: Is a directory");
}

static void options_of_another_sink_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *options, *about;
    } wrong[] = {
        {"--to raw --link-rate 500", "--link-rate: is for --to none; leave it out for --to raw"},
        {"--to png -o out/%d.png --panel ili9341", "--panel: is for --to panel"},
#if GLINT_WITH_USB
        {"--usb-path 1-3", "--usb-path: is for --to usb; leave it out for --to panel"},
        {"--to none --detach --wait", "--detach: is for --to usb"},
        {"--to usb --link-raw", "--link-raw: is for --to none; leave it out for --to usb"},
#endif
#if GLINT_WITH_GPIO
        {"--to png -o out/%d.png --bgr", "--bgr: is for --to panel, gpio, spi; leave it out for --to png"},
        {"--bus-config pins.ini", "--bus-config: is for --to gpio, spi; leave it out for --to panel"},
        {"--to spi --lines dc=A --bus 8080", "--bus: is for --to gpio; leave it out for --to spi"},
        {"--to gpio --bus 8080 --spidev /dev/null", "--spidev: is for --to spi; leave it out for --to gpio"},
        {"--to gpio --spi-hz 4000000", "--spi-hz: is for --to spi; leave it out for --to gpio"},
#endif
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT stream sphere --frames 1 %s", wrong[i].options);
        assert_refused(line, wrong[i].about);
    }
    assert_quiet("$GLINT stream sphere --frames 1 --panel ili9341 --bgr=no --to panel -o out/p.png && rm out/p.png");
    assert_int_equal(files_in("out"), 0);
}

static void panels_take_no_format_but_their_own(void **state)
{
    (void)state;
    assert_fails("$GLINT stream sphere --frames 1 --format mono -o out/p.png",
                 "--format: the panel's pixels are rgb565, not mono");
    assert_int_equal(files_in("out"), 0);
    assert_quiet("$GLINT stream sphere --frames 1 --format rgb565 -o out/p.png && rm out/p.png");
}

static void the_help_has_one_block_of_examples_that_fit_a_line(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT stream --help");
    const char *examples = strstr(result->out, "\nExamples:\n");
    assert_non_null(examples);
    assert_null(strstr(examples + 1, "\nExamples:\n"));
    char *lines = strdup(examples + 1);
    unsigned count = 0;
    for (char *line = strtok(lines, "\n"); (line = strtok(NULL, "\n")); count++)
        if (strncmp(line, "  ", 2) != 0) /* what was wrapped begins at the left */
            fail_msg("not an example, or more than a line: '%s'", line);
    assert_true(count > 4);
    free(lines);
}

/* --help and `glint list` print these, and refusals are made of them. */
static void every_sink_says_what_it_is_and_what_o_means(void **state)
{
    (void)state;
    for (unsigned i = 0; sink_kinds[i]; i++) {
        const struct sink_kind *kind = sink_kinds[i];
        const struct sink_output *to = kind->output;
        assert_true(kind->name && kind->summary && kind->pixels.open && kind->pixels.send && kind->pixels.close);
        assert_true(!to || to->word);
        assert_int_equal(to && to->written, to && to->example);
        assert_true(!kind->usual_output || (to && to->written));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wrong_usage_is_said_with_what_is_allowed_and_ends_with_2),
        cmocka_unit_test(a_signal_ends_lines_of_lights_that_never_end),
        cmocka_unit_test(a_wrong_line_of_lights_is_named_by_its_number),
        cmocka_unit_test(options_of_another_sink_are_refused),
        cmocka_unit_test(panels_take_no_format_but_their_own),
        cmocka_unit_test(every_sink_says_what_it_is_and_what_o_means),
        cmocka_unit_test(the_help_has_one_block_of_examples_that_fit_a_line),
    };
    return cmocka_run_group_tests(tests, make_maps, scratch_remove);
}
