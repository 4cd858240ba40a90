/* SPDX-License-Identifier: MIT
 * glint bake: what it refuses, and its help. */
#include "baked.h"

static void wrong_usage_is_said_with_what_is_allowed_and_ends_with_2(void **state)
{
    (void)state;
    static const struct {
        const char *options, *about;
    } wrong[] = {
        {"-o out/u.h", "--scene NAME"},
        {"--scene sphere --height heights.png -o out/u.h", "only one of"},
        {"--scene ball -o out/u.h", "sphere, watchface, coin"},
        {"--scene sphere --to int12 -o out/u.h", "int16, int8, palette"},
        {"--scene sphere --to palette: -o out/u.h", "2 to 32767"},
        {"--scene sphere --to palette:1 -o out/u.h", "2 to 32767"},
        {"--scene sphere --to palette:32768 -o out/u.h", "2 to 32767"},
        {"--scene sphere --to palette:9x -o out/u.h", "2 to 32767"},
        {"--scene sphere -o out/u.png", ".c, .h, .bin or .uf2"},
        {"--scene sphere -o out/u", "--as"},
        {"--scene sphere -o ''", "the file name is empty"},
        {"--scene sphere --as elf -o out/u.h", "c, raw, uf2"},
        {"--scene sphere --as raw", "give -o FILE"},
        {"--scene sphere --name int -o out/u.h", "--name: 'int'"},
        {"--scene sphere --name glint_vec -o out/u.h", "--name: 'glint_vec'"},
        {"--scene sphere --name x -o out/u.bin", "--name is for C source"},
        {"--scene sphere -o out/my-dial.c", "--name: 'my-dial' is not a C name"},
        {"--scene sphere --name u -o 'out/a\"b.c'", "cannot be included in C; name the file without quotes"},
        {"--scene sphere --name u -o 'out/a\\b.c'", "cannot be included in C"},
        {"--scene sphere --name u -o 'out/a\nb.c'", "cannot be included in C"},
        {"--scene sphere -o out/int8.c", "'int8' would define INT8_WIDTH"},
        {"--scene sphere --strip 4 -o out/u.h", "--strip is for C source in a FILE.c"},
        {"--scene sphere --strip 4 -o -", "--strip is for C source in a FILE.c"},
        {"--scene sphere --strip 4", "give -o FILE"},
        {"--scene sphere --strip 0 -o out/u.c", "--strip: '0'"},
        {"--scene sphere --address 0x10100000 -o out/u.bin", "--address is for UF2"},
        {"--scene sphere --address 0x10100100 -o out/u.uf2", "multiple of 4096"},
        {"--scene sphere --address 0x20000000 -o out/u.uf2", "0x10000000"},
        {"--scene sphere --address flash -o out/u.uf2", "--address: 'flash'"},
        {"--scene sphere --address '' -o out/u.uf2", "--address: ''"},
        {"--scene sphere --address 0x -o out/u.uf2", "--address: '0x'"},
        {"--scene sphere --grain brushed:30 -o out/u.h", "struct glint_maps, by grain_kind and grain_at"},
        {"--scene sphere --grain spun", "--grain: of grain a FILE alone is baked"},
        {"--scene teapot --grain axis:0,0,1 -o out/u.h", "struct glint_mesh, by grain and use_grain"},
        {"--scene sphere --wrap -o out/u.h", "--wrap needs --height"},
        {"heights.png -o out/u.h", "'heights.png'"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT bake %s", wrong[i].options);
        assert_refused(line, wrong[i].about);
    }
    static const char *const endings[] = {"c", "h", "bin", "uf2", "png"};
    for (int i = 0; i < 5; i++) {
        char name[16];
        snprintf(name, sizeof name, "out/u.%s", endings[i]);
        assert_false(exists(name));
    }
}

static void what_cannot_be_read_or_written_is_said_and_leaves_nothing_behind(void **state)
{
    (void)state;
    bake_to(MASKED, "int8", "out/kept.bin");
    bake_to(MASKED, "int8", "out/copy.bin");
    const int before = files_in("out");
    assert_fails("$GLINT bake --height missing.png -o out/kept.bin", "missing.png");
    assert_fails("$GLINT bake --height heights.png --mask small.png -o out/kept.bin", "small.png: 4x4");
    assert_fails("$GLINT bake " MASKED " -o out/missing/x.h", "out/missing/x.h");
    assert_fails("$GLINT bake " MASKED " --as c -o out", "out: this is a folder");
    assert_fails("$GLINT bake " MASKED " --as raw -o /dev/full", "/dev/full: could not be written");
    assert_fails("$GLINT bake " MASKED " -o - >/dev/full", "standard output: could not be written");
    assert_fails("$GLINT bake " MASKED " -o out/kept.bin >/dev/full", "standard output: the quality");
    assert_fails("(ulimit -f 1; exec $GLINT bake --scene coin --size 64x64 --to int16 -o out/kept.bin)", "kept.bin");
    assert_fails("$GLINT bake --scene sphere --address 0x10fff000 -o out/kept.uf2", "do not fit");
    assert_int_equal(files_in("out"), before);
    assert_same_file("out/kept.bin", "out/copy.bin");
}

static void help_explains_every_option_and_fits_a_terminal(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT bake --help");
    static const char *const options[] = {"--height", "--normals", "--scene", "--mask",  "--scale",  "--wrap",
                                          "--flip-y", "--size",    "--to",    "-o FILE", "--as",     "--name",
                                          "--strip",  "--address", "--json",  "4096",    "Examples:"};
    assert_int_equal(result->status, 0);
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        assert_contains(result->out, options[i]);
    for (const char *line = result->out; *line;) {
        const size_t length = strcspn(line, "\n");
        assert_true(length < 80);
        line += length + (line[length] == '\n');
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wrong_usage_is_said_with_what_is_allowed_and_ends_with_2),
        cmocka_unit_test(what_cannot_be_read_or_written_is_said_and_leaves_nothing_behind),
        cmocka_unit_test(help_explains_every_option_and_fits_a_terminal),
    };
    return cmocka_run_group_tests_name("bake usage", tests, make_masked, scratch_remove);
}
