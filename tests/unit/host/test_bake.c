/* SPDX-License-Identifier: MIT
 * glint bake: what its files hold. */
#include "bake/bake.h"
#include "baked.h"
#include "glint.h"

static uint32_t word_at(const uint8_t *bytes, unsigned size)
{
    uint32_t word = 0;
    for (unsigned i = size; i-- > 0;)
        word = word << 8 | bytes[i];
    return word;
}

static struct glint_vec vec_at(const uint8_t *bytes)
{
    return (struct glint_vec){(int16_t)word_at(bytes, 2), (int16_t)word_at(bytes + 2, 2),
                              (int16_t)word_at(bytes + 4, 2)};
}

static void read_normals(const char *options, struct glint_vec normals[PIXELS])
{
    static uint8_t bytes[6 * PIXELS + 1];
    bake_to(options, "int16", "out/normals.bin");
    assert_int_equal(read_file("out/normals.bin", bytes, sizeof bytes), 6 * PIXELS);
    for (int i = 0; i < PIXELS; i++)
        normals[i] = vec_at(bytes + 6 * i);
}

static void the_16_bit_normals_are_of_length_1_and_0_where_the_mask_is_black(void **state)
{
    (void)state;
    struct glint_vec normals[PIXELS];
    read_normals(MASKED, normals);
    for (int i = 0; i < PIXELS; i++) {
        const struct glint_vec v = normals[i];
        const int64_t square = (int64_t)v.x * v.x + (int64_t)v.y * v.y + (int64_t)v.z * v.z;
        if (drawn(i))
            assert_true(llabs(square - (1 << 30)) < 1 << 17);
        else
            assert_true(square == 0);
    }
}

static void words_are_what_packing_gives(void **state)
{
    (void)state;
    struct glint_vec normals[PIXELS];
    static uint8_t bytes[4 * PIXELS + 1];
    read_normals("--height heights.png", normals);
    bake_to("--height heights.png", "int8", "out/words.bin");
    assert_int_equal(read_file("out/words.bin", bytes, sizeof bytes), 4 * PIXELS);
    for (int i = 0; i < PIXELS; i++)
        assert_int_equal(word_at(bytes + 4 * i, 4), glint_normals_pack(GLINT_NORMALS_INT8, &normals[i]));
}

static void a_word_without_surface_counts_those_up_to_the_next_surface_in_its_line(void **state)
{
    (void)state;
    struct glint_vec normals[PIXELS];
    static uint8_t bytes[4 * PIXELS + 1];
    read_normals(MASKED, normals);
    bake_to(MASKED, "int8", "out/words.bin");
    read_file("out/words.bin", bytes, sizeof bytes);
    int longest = 0;
    for (int i = 0; i < PIXELS; i++) {
        int run = 0;
        while (i % WIDTH + run < WIDTH && normals[i + run].z == 0)
            run++;
        const uint32_t word = word_at(bytes + 4 * i, 4);
        assert_int_equal(word, run ? (uint32_t)run : glint_normals_pack(GLINT_NORMALS_INT8, &normals[i]));
        longest = run > longest ? run : longest;
    }
    assert_true(longest > 1 && longest < WIDTH);
}

static void a_palette_with_room_for_all_is_exact_and_its_first_entry_is_no_surface(void **state)
{
    (void)state;
    struct glint_vec normals[PIXELS];
    static uint8_t bytes[8 * PIXELS + 7];
    read_normals(MASKED, normals);
    bake_to(MASKED, "palette", "out/palette.bin");
    const size_t len = read_file("out/palette.bin", bytes, sizeof bytes), entries = (len - 2 * PIXELS) / 6;
    assert_int_equal(len, 6 * entries + 2 * PIXELS);
    for (int i = 0; i < PIXELS; i++) {
        const uint32_t offset = word_at(bytes + 6 * entries + 2 * i, 2);
        assert_int_equal(offset % 2, 0);
        assert_true(offset / 2 < entries);
        assert_int_equal(offset == 0, normals[i].z == 0);
        const struct glint_vec found = vec_at(bytes + 3 * offset);
        assert_memory_equal(&found, &normals[i], sizeof found);
    }
}

#define WARN "-Wall -Wextra -Wconversion -pedantic -Werror -I\"$GLINT_SOURCE/lib\" "

static void c_source_compiles_in_c_and_cxx_and_holds_the_raw_bytes(void **state)
{
    (void)state;
    static const struct {
        const char *format, *writes;
    } cases[] = {
        {"int16", "put(stone, sizeof stone);"},
        {"int8", "put(stone, sizeof stone);"},
        {"palette:9", "put(stone_normals, sizeof stone_normals); put(stone, sizeof stone);"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char line[900];
        bake_to(MASKED " --name stone", cases[i].format, "out/stone.h");
        bake_to(MASKED, cases[i].format, "out/stone.bin");
        snprintf(line, sizeof line,
                 "printf '#include <stdio.h>\n#include \"stone.h\"\n"
                 "static void put(const void *from, size_t len) { fwrite(from, 1, len, stdout); }\n"
                 "int main(void) { %s return !(stone_width == %d && stone_height == %d); }\n' >out/t.c\n"
                 "gcc -std=c99 " WARN "out/t.c -o out/t && out/t >out/c.bin &&\n"
                 "g++ -std=c++11 " WARN "-x c++ out/t.c -o out/t && out/t >out/cxx.bin",
                 cases[i].writes, WIDTH, HEIGHT);
        assert_quiet(line);
        assert_same_file("out/c.bin", "out/stone.bin");
        assert_same_file("out/cxx.bin", "out/stone.bin");
    }
}

/* The header is included by two sources, of which one is compiled as C++; the definitions once as each. */
static void a_source_and_its_header_link_in_c_and_cxx_and_hold_the_raw_bytes(void **state)
{
    (void)state;
    static const struct {
        const char *format, *writes, *macro;
    } cases[] = {
        {"int16", "put(stone, sizeof stone)", "STONE_FORMAT == GLINT_NORMALS_INT16 && STONE_STRIDE == 6 * STONE_WIDTH"},
        {"int8", "put(stone, sizeof stone)", "STONE_FORMAT == GLINT_NORMALS_INT8 && STONE_STRIDE == 4 * STONE_WIDTH"},
        {"palette:9", "put(stone_normals, sizeof stone_normals), put(stone, sizeof stone)",
         "STONE_ENTRIES == 9 && STONE_STRIDE == 2 * STONE_WIDTH"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char line[1400];
        bake_to(MASKED, cases[i].format, "out/stone.c");
        bake_to(MASKED, cases[i].format, "out/stone.bin");
        snprintf(
            line, sizeof line,
            "printf '#include <stdint.h>\n#include <stdio.h>\n#include \"stone.h\"\n#include \"stone.h\"\n"
            "static void put(const void *from, size_t len) { fwrite(from, 1, len, stdout); }\n"
            "int main(void) { %s; return !(STONE_WIDTH == %d && STONE_HEIGHT == %d && (uintptr_t)stone %%%% 4 == 0 && "
            "%s); }\n' >out/t.c\n"
            "cd out && gcc -std=c99 " WARN "-c stone.c -o stone.o && g++ -std=c++11 " WARN
            "-x c++ -c stone.c -o stonexx.o &&\n"
            "gcc -std=c99 " WARN "t.c stone.o -o t && ./t >c.bin &&\n"
            "g++ -std=c++11 " WARN "-x c++ t.c -x none stonexx.o -o t && ./t >cxx.bin",
            cases[i].writes, WIDTH, HEIGHT, cases[i].macro);
        assert_quiet(line);
        assert_same_file("out/c.bin", "out/stone.bin");
        assert_same_file("out/cxx.bin", "out/stone.bin");
    }
}

static void strips_of_any_height_cover_the_map(void **state)
{
    (void)state;
    for (int strip = 1; strip <= HEIGHT + 1; strip++) {
        char line[900];
        snprintf(line, sizeof line, "$GLINT bake " MASKED " --strip %d -o out/strip.c >out/log", strip);
        assert_quiet(line);
        snprintf(line, sizeof line,
                 "printf '#include \"strip.h\"\n"
                 "int main(void) { int lines = 0;\n"
                 "for (int i = 0; i < STRIP_STRIPS; i++) {\n"
                 "if (STRIP_STRIP_START(i) != strip + lines * STRIP_WIDTH || STRIP_STRIP_LINES(i) > %d) return 1;\n"
                 "lines += STRIP_STRIP_LINES(i); }\n"
                 "return lines != STRIP_HEIGHT || STRIP_STRIP != %d; }\n' >out/t.c\n"
                 "cd out && gcc -std=c99 " WARN "t.c strip.c -o t && ./t",
                 strip, strip);
        assert_quiet(line);
    }
}

static void uf2_blocks_are_well_formed_and_hold_the_raw_bytes(void **state)
{
    (void)state;
    static uint8_t uf2[1 << 16], raw[1 << 14];
    bake_to(MASKED " --address 0x10200000", "int8", "out/words.uf2");
    bake_to(MASKED, "int8", "out/words.bin");
    const size_t len = read_file("out/words.bin", raw, sizeof raw), blocks = (len + 255) / 256;
    assert_true(len % 256 != 0); /* the last block is not full */
    assert_int_equal(read_file("out/words.uf2", uf2, sizeof uf2), 512 * blocks);
    for (uint32_t i = 0; i < blocks; i++) {
        const uint8_t *block = uf2 + 512 * i;
        const uint32_t wanted[] = {0x0a324655, 0x9e5d5157, 0x2000,           0x10200000 + 256 * i,
                                   256,        i,          (uint32_t)blocks, 0xe48bff56};
        for (int k = 0; k < 8; k++)
            assert_int_equal(word_at(block + 4 * k, 4), wanted[k]);
        assert_int_equal(word_at(block + 508, 4), 0x0ab16f30);
        for (uint32_t k = 0; k < 476; k++)
            assert_int_equal(block[32 + k], k < 256 && 256 * i + k < len ? raw[256 * i + k] : 0);
    }
    bake_to(MASKED, "int8", "out/default.uf2");
    assert_int_equal(read_file("out/default.uf2", uf2, sizeof uf2), 512 * blocks);
    assert_int_equal(word_at(uf2 + 12, 4), 0x10100000);
}

static void the_ending_or_the_option_decides_what_is_written(void **state)
{
    (void)state;
    bake_to(MASKED, "int8", "out/a.bin");
    bake_to(MASKED " --as raw", "int8", "out/a");
    assert_same_file("out/a", "out/a.bin");
    bake_to(MASKED, "int8", "out/a.H");
    bake_to(MASKED " --as c", "int8", "out/a.bin2");
    assert_same_file("out/a.H", "out/a.bin2");
    const struct run *result = run("$GLINT bake " MASKED " -o - >out/a.stdout");
    assert_int_equal(result->status, 0);
    assert_contains(result->err, "int8, 12x8, 384 bytes");
    assert_same_file("out/a.H", "out/a.stdout");
}

static void the_same_normals_give_the_same_palette_whatever_the_threads(void **state)
{
    (void)state;
    bake_to("--scene coin --size 64x64", "palette:200", "out/one.bin");
    assert_int_equal(
        run("OMP_NUM_THREADS=1 $GLINT bake --scene coin --size 64x64 --to palette:200 -o out/two.bin")->status, 0);
    assert_same_file("out/one.bin", "out/two.bin");
    struct stat status;
    assert_int_equal(stat("out/one.bin", &status), 0);
    assert_int_equal(status.st_size, 200 * 6 + 64 * 64 * 2);
}

static void the_smallest_palette_has_one_normal(void **state)
{
    (void)state;
    static uint8_t bytes[8 * PIXELS];
    bake_to(MASKED, "palette:2", "out/two.bin");
    assert_int_equal(read_file("out/two.bin", bytes, sizeof bytes), 2 * 6 + 2 * PIXELS);
    assert_int_equal(vec_at(bytes).z, 0);
    assert_true(vec_at(bytes + 6).z > 0);
}

static void a_mask_that_leaves_nothing_is_said(void **state)
{
    (void)state;
    static const uint16_t black[PIXELS];
    make_png("black.png", &(struct made_png){.width = WIDTH, .height = HEIGHT, .bits = 8, .samples = black});
    for (int f = 0; f < BAKE_FORMATS; f++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT bake --height heights.png --mask black.png --to %s -o out/none.bin",
                 bake_format_names[f]);
        const struct run *result = run(line);
        assert_int_equal(result->status, 0);
        assert_contains(result->out, "no surface");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_16_bit_normals_are_of_length_1_and_0_where_the_mask_is_black),
        cmocka_unit_test(words_are_what_packing_gives),
        cmocka_unit_test(a_word_without_surface_counts_those_up_to_the_next_surface_in_its_line),
        cmocka_unit_test(a_palette_with_room_for_all_is_exact_and_its_first_entry_is_no_surface),
        cmocka_unit_test(c_source_compiles_in_c_and_cxx_and_holds_the_raw_bytes),
        cmocka_unit_test(a_source_and_its_header_link_in_c_and_cxx_and_hold_the_raw_bytes),
        cmocka_unit_test(strips_of_any_height_cover_the_map),
        cmocka_unit_test(uf2_blocks_are_well_formed_and_hold_the_raw_bytes),
        cmocka_unit_test(the_ending_or_the_option_decides_what_is_written),
        cmocka_unit_test(the_same_normals_give_the_same_palette_whatever_the_threads),
        cmocka_unit_test(the_smallest_palette_has_one_normal),
        cmocka_unit_test(a_mask_that_leaves_nothing_is_said),
    };
    return cmocka_run_group_tests_name("bake", tests, make_masked, scratch_remove);
}
