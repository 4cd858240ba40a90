/* SPDX-License-Identifier: MIT
 * What glint writes for flash, compiled with the library into a program, draws the pixels of glint render. */
#include "files.h"

enum { WIDTH = 12, HEIGHT = 8, PIXELS = WIDTH * HEIGHT };
#define WARN "-Wall -Wextra -Wconversion -pedantic -Werror -I\"$GLINT_SOURCE/lib\" "
#define LOOK "-n 20 --ambient .3 --diffuse .6 --light=-1,2,3 --format rgb565 "

static int make_library(void **state)
{
    if (make_maps(state) != 0)
        return -1;
    return run("mkdir -p o && cd o && gcc -O1 -std=c99 -c \"$GLINT_SOURCE\"/lib/*.c && ar rc ../lib.a *.o")->status;
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
                     "-o out/look.h && $GLINT render --height heights.png --albedo colors.png " LOOK
                     "--path albedo-int8 --image raw -o out/wanted.raw");
        assert_quiet(
            "cat >out/t.c <<'END'\n"
            "#include <stdio.h>\n#include \"stone.h\"\n#include \"look.h\"\n"
            "static uint32_t memory[GLINT_TABLES_ALBEDO_BYTES / 4];\n"
            "static unsigned char pixels[2 * STONE_WIDTH * STONE_STRIP];\n"
            "int main(void) {\n"
            "struct glint_shader shader; struct glint_tables tables; struct glint_tables_light light;\n"
            "material(&shader);\n"
            "if (glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &shader, memory, sizeof memory) != GLINT_OK ||\n"
            "    glint_tables_light_init(&light, &tables, &shader.light) != GLINT_OK) return 1;\n"
            "for (int i = 0; i < STONE_STRIPS; i++) {\n"
            "struct glint_surface surface = {pixels, 2 * STONE_WIDTH, 0, 0};\n"
            "if (glint_tables_albedo_rect(&tables, &light, STONE_FORMAT, STONE_STRIP_START(i), STONE_STRIDE,\n"
            "    STONE_STRIP_ALBEDO(i), STONE_ALBEDO_STRIDE, STONE_WIDTH, STONE_STRIP_LINES(i), &surface) != "
            "GLINT_OK)\n"
            "    return 1;\n"
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_and_albedo_in_strips_draw_the_pixels_of_render),
        cmocka_unit_test(raw_has_the_albedo_after_the_normals),
        cmocka_unit_test(an_albedo_where_there_is_no_place_for_it_is_refused),
    };
    return cmocka_run_group_tests_name("flash", tests, make_library, scratch_remove);
}
