/* SPDX-License-Identifier: MIT
 * Unknown values: what was meant. */
#include "base/closest.h"
#include "run.h"

static const char *const names[] = {"msh",    "schlick", "blinn",    "phong", "spi", "panel",
                                    "st7789", "rgb565",  "terminal", "int10", "c",   NULL};

static void a_slip_of_the_fingers_finds_the_name_that_is_meant(void **state)
{
    (void)state;
    static const struct {
        const char *text, *meant;
    } slips[] = {
        {"mhs", "msh"},         {"MSH", "msh"},          {"mshh", "msh"},       {"ms", "msh"},
        {"blin", "blinn"},      {"phogn", "phong"},      {"shlick", "schlick"}, {"schlikc", "schlick"},
        {"schilck", "schlick"}, {"terminl", "terminal"}, {"Panle", "panel"},    {"trminl", "terminal"},
    };
    for (size_t i = 0; i < sizeof slips / sizeof *slips; i++) {
        const char *found = closest_name(slips[i].text, names);
        if (!found)
            fail_msg("'%s' finds nothing", slips[i].text);
        assert_string_equal(found, slips[i].meant);
    }
}

static void what_is_not_close_finds_nothing(void **state)
{
    (void)state;
    static const char *const others[] = {"",        "foo",
                                         "x",       "gpio",
                                         "mono",    "st7735",
                                         "rgb888",  "int8",
                                         "blunt",   "phonon",
                                         "termite", "pixel",
                                         "cc",      "a name that is longer than any of those that the program has"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        const char *found = closest_name(others[i], names);
        if (found)
            fail_msg("'%s' finds '%s'", others[i], found);
    }
}

static void every_list_of_choices_has_one_wording(void **state)
{
    (void)state;
    assert_refused("$GLINT rendr", "glint: unknown command 'rendr'; did you mean 'render'? choose from render, eval, ");
    assert_refused("$GLINT stream coin --to terminl", "glint stream: --to: unknown sink 'terminl'; ");
    assert_refused("$GLINT render --scene coni -o x.png",
                   "glint render: --scene: unknown scene 'coni'; did you mean 'coin'? choose from sphere, ");
    assert_refused("$GLINT render --scene coin --format rgb -o x.png",
                   "--format: unknown format 'rgb'; choose from rgb565, ");
    assert_refused("$GLINT render --scene coin --image gif -o x",
                   "--image: unknown file format 'gif'; choose from png, ");
    assert_refused("$GLINT render --scene coin --model shlick -o x.png",
                   "--model: unknown model 'shlick'; did you mean 'schlick'? ");
    assert_refused("$GLINT bake --scene coin --to int9", "--to: unknown format 'int9'; choose from int16, ");
}

static void an_unknown_option_comes_with_the_closest(void **state)
{
    (void)state;
    assert_refused("$GLINT render --formt rgb565",
                   "glint render: unknown option '--formt' (did you mean '--format'?); see");
    assert_refused("$GLINT render --formt=rgb565", "unknown option '--formt' (did you mean '--format'?); see");
    assert_refused("$GLINT eval -n 60 -Z 1", "glint eval: unknown option '-Z'; see");
    assert_refused("$GLINT eval -.5", "glint eval: unknown option '-.' (negative numbers come after the word --); see");
    assert_refused("$GLINT eval -n 60 1 --model", "glint eval: option '--model' needs a value: NAME; see");
    assert_refused("$GLINT stream coin --light-from", "glint stream: option '--light-from' needs a value: FILE; see");
    assert_refused("$GLINT list usb extra", "unexpected argument 'usb'");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slip_of_the_fingers_finds_the_name_that_is_meant),
        cmocka_unit_test(what_is_not_close_finds_nothing),
        cmocka_unit_test(every_list_of_choices_has_one_wording),
        cmocka_unit_test(an_unknown_option_comes_with_the_closest),
    };
    return cmocka_run_group_tests_name("unknown values", tests, scratch_make, scratch_remove);
}
