/* SPDX-License-Identifier: MIT
 * What glint writes for flash, compiled with the library into a program, draws the pixels of glint render. */
#include "files.h"

enum { WIDTH = 12, HEIGHT = 8, PIXELS = WIDTH * HEIGHT };
#define WARN "-Wall -Wextra -Wconversion -pedantic -Werror -I\"$GLINT_SOURCE/lib\" "
#define LOOK "-n 20 --ambient .3 --diffuse .6 --light=-1,2,3 --format rgb565 "

static int make_library(void **state)
{
    return make_maps(state) == 0 ? library_make() : -1;
}

/* Compiles out/t.c, sources beside it and the library as C and as C++; what it writes is the file `wanted`. */
static void assert_draws(const char *sources, const char *wanted)
{
    char line[600];
    snprintf(line, sizeof line,
             "cd out && gcc -std=c99 " WARN "t.c %s ../lib.a -o t && ./t >c.raw && "
             "g++ -std=c++11 " WARN "-x c++ t.c %s -x none ../lib.a -o t && ./t >cxx.raw",
             sources, sources);
    assert_quiet(line);
    assert_same_file("out/c.raw", wanted);
    assert_same_file("out/cxx.raw", wanted);
}

static void normals_and_albedo_in_strips_draw_the_pixels_of_render(void **state)
{
    (void)state;
    for (int strip = 3; strip <= HEIGHT; strip += 5) {
        char line[400];
        snprintf(line, sizeof line,
                 "$GLINT bake --height heights.png --albedo colors.png --strip %d -o out/stone.c >out/log", strip);
        assert_quiet(line);
        assert_quiet("$GLINT material " LOOK
                     "--name look -o out/look.h && $GLINT render --height heights.png --albedo colors.png " LOOK
                     "--path albedo-int8 --image raw -o out/wanted.raw");
        assert_quiet(
            "cat >out/t.c <<'END'\n"
            "#include <stdio.h>\n#include \"stone.h\"\n#include \"look.h\"\n"
            "static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];\n"
            "static unsigned char pixels[2 * STONE_WIDTH * STONE_STRIP];\n"
            "int main(void) {\n"
            "struct glint_paint paint; struct glint_light lights[look_light_count];\n"
            "if (glint_paint_tables(&paint, GLINT_TABLES_ALBEDO, &look, &look_output, memory, sizeof memory) || "
            "look_light(&paint, lights)) return 1;\n"
            "for (int i = 0; i < STONE_STRIPS; i++) {\n"
            "const struct glint_surface target = {pixels, 2 * STONE_WIDTH, 0, 0};\n"
            "static struct glint_maps maps;\n"
            "maps.normals = STONE_STRIP_START(i); maps.normals_stride = STONE_STRIDE; "
            "maps.normals_format = STONE_FORMAT;\n"
            "maps.albedo = (const uint8_t *)STONE_STRIP_ALBEDO(i); maps.albedo_stride = STONE_ALBEDO_STRIDE; "
            "maps.albedo_format = GLINT_RGB565;\n"
            "if (glint_draw_rect(&paint, &maps, STONE_WIDTH, STONE_STRIP_LINES(i), &target, NULL)) return 1;\n"
            "fwrite(pixels, 2 * STONE_WIDTH, STONE_STRIP_LINES(i), stdout); }\n"
            "return 0; }\nEND");
        assert_draws("stone.c", "out/wanted.raw");
    }
}

static void raw_has_the_albedo_after_the_normals(void **state)
{
    (void)state;
    static uint8_t plain[8 * PIXELS], both[8 * PIXELS];
    assert_quiet("$GLINT bake --height heights.png -o out/plain.bin >out/log && "
                 "$GLINT bake --height heights.png --albedo colors.png -o out/both.bin >out/log");
    assert_int_equal(read_file("out/plain.bin", plain, sizeof plain), 4 * PIXELS);
    assert_int_equal(read_file("out/both.bin", both, sizeof both), 6 * PIXELS);
    assert_memory_equal(both, plain, 4 * PIXELS);
    /* The first colour is 100, 101, 102, of 255: 12, 25 and 12 of 31, 63 and 31. */
    assert_int_equal(both[4 * PIXELS] | both[4 * PIXELS + 1] << 8, 12 << 11 | 25 << 5 | 12);
    assert_quiet(
        "$GLINT bake --height heights.png --albedo colors.png --name both -o out/both.h >out/log && "
        "printf '#include <stdio.h>\n#include \"both.h\"\nint main(void) { fwrite(both, 1, sizeof both, stdout); "
        "fwrite(both_albedo, 1, sizeof both_albedo, stdout); return 0; }\n' >out/t.c");
    assert_draws("", "out/both.bin");
}

static void an_albedo_where_there_is_no_place_for_it_is_refused(void **state)
{
    (void)state;
    assert_refused("$GLINT bake --height heights.png --albedo colors.png", "give -o FILE");
    assert_refused("$GLINT bake --height heights.png --albedo colors.png --to palette -o out/no.c", "--to palette");
    assert_refused("$GLINT bake --height heights.png --albedo colors.png -o out/no.uf2", "--as uf2");
    assert_fails("$GLINT bake --height heights.png --albedo small.png -o out/no.c", "small.png: 4x4");
    assert_false(exists("out/no.c") || exists("out/no.uf2"));
}

/* A program that draws the baked heights with tables of the name `shine` under the light of look.h. */
static const char tables_program[] =
    "cat >out/t.c <<'END'\n"
    "#include <stdio.h>\n#include \"stone.h\"\n#include \"look.h\"\n#include \"shine.h\"\n"
    "static unsigned char pixels[2 * STONE_WIDTH * STONE_HEIGHT];\n"
    "int main(void) {\n"
    "struct glint_paint paint; struct glint_light lights[look_light_count];\n"
    "const struct glint_surface target = {pixels, 2 * STONE_WIDTH, 0, 0};\n"
    "static struct glint_maps maps;\n"
    "maps.normals = stone; maps.normals_stride = STONE_STRIDE; maps.normals_format = STONE_FORMAT;\n"
    "if (glint_paint_tables_filled(&paint, &shine, &look_output) || look_light(&paint, lights)) return 1;\n"
    "if (shine.kind == GLINT_TABLES_ALBEDO) {\n"
    "maps.albedo = (const uint8_t *)stone_albedo; maps.albedo_stride = STONE_ALBEDO_STRIDE; "
    "maps.albedo_format = GLINT_RGB565; }\n"
    "if (glint_draw_rect(&paint, &maps, STONE_WIDTH, STONE_HEIGHT, &target, NULL)) return 1;\n"
    "fwrite(pixels, 1, sizeof pixels, stdout);\n"
    "return 0; }\nEND";

static void tables_in_flash_draw_what_tables_filled_at_run_time_draw(void **state)
{
    (void)state;
    static const struct {
        const char *kind, *look, *maps;
    } cases[] = {
        {"colour", "-n 20 --color 200,90,20 --format rgb565", ""},
        {"colour", "--model cayley -n 300 -q 9 --space linear --specular 1,.5,.2 --format rgb565-swapped", ""},
        {"colour", "-n 40 --dither --color 20,190,220 --format rgb565", ""},
        {"colour", "--model schlick -n 5 --color 0,250,99 --ambient .1,.2,.3 --format rgb565", ""},
        {"colour", "-n 100 --dither --format rgb565-swapped", ""},
        {"albedo", "-n 20 --ambient .3 --diffuse .6 --specular .8,.7,.1 --format rgb565", "--albedo colors.png"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char line[900];
        snprintf(line, sizeof line,
                 "$GLINT bake --height heights.png --albedo colors.png -o out/stone.c >out/log && "
                 "$GLINT material %s --name look -o out/look.h && $GLINT table --kind %s %s -o out/shine.%s && "
                 "$GLINT render --height heights.png %s %s --path %s-int8 --image raw -o out/wanted.raw",
                 cases[i].look, cases[i].kind, cases[i].look, i == 0 ? "h --name shine" : "c", cases[i].look,
                 cases[i].maps, cases[i].kind);
        assert_quiet(line);
        assert_quiet(tables_program);
        assert_draws(i == 0 ? "stone.c" : "stone.c shine.c", "out/wanted.raw");
    }
}

/* What the tables name is all that is linked of loops. */
static void tables_in_flash_name_what_is_linked(void **state)
{
    (void)state;
    static const struct {
        const char *options, *use;
    } cases[] = {{"--kind colour", "glint_use_colour"},
                 {"--kind colour --dither", "glint_use_colour_dithered"},
                 {"--kind albedo --ambient .1 --diffuse .9", "glint_use_albedo"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char line[300];
        snprintf(line, sizeof line,
                 "$GLINT table %s --name shine -o out/shine.c && cd out && gcc -std=c99 " WARN
                 "-c shine.c -o shine.o && nm -u shine.o | tr -d ' U'",
                 cases[i].options);
        const struct run *result = run(line);
        assert_int_equal(strncmp(result->out, cases[i].use, strlen(cases[i].use)), 0);
        assert_string_equal(result->out + strlen(cases[i].use), "\n");
    }
}

static void tables_in_flash_take_no_ram(void **state)
{
    (void)state;
    assert_quiet("$GLINT table --kind colour --name shine -o out/colour.c && cd out && "
                 "gcc -std=c99 -fno-pic " WARN "-c colour.c -o c.o && g++ -std=c++11 -fno-pic " WARN
                 "-x c++ -c colour.c -o cxx.o");
    static const char *const objects[] = {"c.o", "cxx.o"};
    for (int i = 0; i < 2; i++) {
        char line[300];
        snprintf(line, sizeof line,
                 "size -A out/%s | awk '/^\\.(data|bss)/ { ram += $2 } /^\\.rodata/ { rom += $2 } "
                 "END { print ram + 0, (rom >= 20480) }'",
                 objects[i]);
        assert_string_equal(run(line)->out, "0 1\n");
    }
}

static void tables_that_cannot_be_are_refused_with_the_reason(void **state)
{
    (void)state;
    const int before = files_in("out");
    assert_fails("$GLINT table --kind colour --format grey8 -o out/no.c", "--kind colour: needs --format rgb565");
    assert_fails("$GLINT table --kind albedo --space linear -o out/no.c", "--kind albedo: needs --space gamma");
    assert_fails("$GLINT table --kind albedo --dither -o out/no.c", "--kind albedo: cannot draw with --dither");
    assert_fails("$GLINT table --kind colour --model phong -o out/no.c", "cannot draw phong");
    /* The defaults are too bright for it: the line shows what to write instead, and that is taken, below. */
    assert_fails(
        "$GLINT table --kind albedo -o out/no.c",
        "--kind albedo: needs a grey --ambient and --diffuse of at most 1 together, as --ambient .1 --diffuse .9");
    assert_refused("$GLINT table --kind grey -o out/no.c", "colour, albedo");
    assert_refused("$GLINT table --kind colour --entries 9 -o out/no.c", "--entries");
    assert_refused("$GLINT table --kind colour --raw -o out/no.bin", "--raw");
    assert_refused("$GLINT table --ambient .3 -o out/no.c", "need --kind");
    assert_int_equal(files_in("out"), before);
    assert_quiet("$GLINT table --kind albedo --ambient .1 --diffuse .9 -o out/yes.c");
}

/* The look-ups of the header are those of the single file. */
static void a_highlight_in_flash_links_and_looks_up_the_same(void **state)
{
    (void)state;
    assert_quiet(
        "$GLINT table -n 20 --entries 40 -o out/one.h --name shine && mv out/one.h out/shine.h && "
        "printf '#include <stdio.h>\n#include \"shine.h\"\nint main(void) { for (uint32_t x = 0; x < 1u << 30; x += "
        "1234567) printf(\"%%d %%d\\\\n\", shine_nearest(x), shine_linear(x)); return 0; }\n' >out/t.c && "
        "cd out && gcc -std=c99 " WARN "t.c -o t && ./t >wanted.raw");
    assert_quiet(
        "$GLINT table -n 20 --entries 40 -o out/shine.c && grep -q '^#define SHINE_ENTRIES 40$' out/shine.h && "
        "grep -q 'extern const uint16_t shine\\[SHINE_ENTRIES\\];' out/shine.h");
    assert_draws("shine.c", "out/wanted.raw");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_and_albedo_in_strips_draw_the_pixels_of_render),
        cmocka_unit_test(raw_has_the_albedo_after_the_normals),
        cmocka_unit_test(tables_in_flash_draw_what_tables_filled_at_run_time_draw),
        cmocka_unit_test(tables_in_flash_name_what_is_linked),
        cmocka_unit_test(tables_in_flash_take_no_ram),
        cmocka_unit_test(tables_that_cannot_be_are_refused_with_the_reason),
        cmocka_unit_test(a_highlight_in_flash_links_and_looks_up_the_same),
        cmocka_unit_test(an_albedo_where_there_is_no_place_for_it_is_refused),
    };
    return cmocka_run_group_tests_name("flash", tests, make_library, scratch_remove);
}
