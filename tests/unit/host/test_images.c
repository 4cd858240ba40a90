/* SPDX-License-Identifier: MIT
 * Reading PNG of every kind, and what is no picture. */
#include <math.h>
#include <string.h>

#include "files.h"

#include "image/picture.h"
#include "image/read.h"
#include "image/image.h"

/* ---- reading ---- */

static struct image *read_made(const struct made_png *made)
{
    make_png("made.png", made);
    return image_read("made.png");
}

static void eight_bits_become_sixteen_by_repetition(void **state)
{
    (void)state;
    const uint16_t samples[] = {0, 1, 128, 255};
    struct image *image = read_made(&(struct made_png){.width = 2, .height = 2, .bits = 8, .samples = samples});
    assert_int_equal(image->channels, 1);
    assert_int_equal(image->bits, 8);
    for (int i = 0; i < 4; i++)
        assert_int_equal(image->samples[i], 257 * samples[i]);
    image_free(image);
}

static void sixteen_bits_are_read_whole(void **state)
{
    (void)state;
    const uint16_t samples[] = {0, 1, 0x1234, 65535, 40000, 258};
    struct image *image = read_made(
        &(struct made_png){.width = 1, .height = 2, .bits = 16, .color_type = PNG_COLOR_TYPE_RGB, .samples = samples});
    assert_int_equal(image->channels, 3);
    assert_memory_equal(image->samples, samples, sizeof samples);
    image_free(image);
}

static void low_depths_span_black_to_white(void **state)
{
    (void)state;
    const uint16_t samples[] = {0, 1, 3, 2};
    for (int bits = 1; bits <= 4; bits *= 2) {
        const int max = (1 << bits) - 1;
        uint16_t cut[4];
        for (int i = 0; i < 4; i++)
            cut[i] = (uint16_t)(samples[i] & max);
        struct image *image = read_made(&(struct made_png){.width = 4, .height = 1, .bits = bits, .samples = cut});
        for (int i = 0; i < 4; i++)
            assert_int_equal(image->samples[i], cut[i] * 65535 / max);
        assert_int_equal(image->bits, bits);
        image_free(image);
    }
}

static void a_palette_is_read_as_its_colours(void **state)
{
    (void)state;
    const png_color palette[] = {{10, 20, 30}, {200, 100, 50}};
    const uint16_t samples[] = {1, 0};
    struct image *image = read_made(&(struct made_png){.width = 2,
                                                       .height = 1,
                                                       .bits = 8,
                                                       .color_type = PNG_COLOR_TYPE_PALETTE,
                                                       .samples = samples,
                                                       .palette = palette,
                                                       .palette_count = 2});
    assert_true(image->palette);
    uint8_t *rgb = image_rgb8(image);
    const uint8_t wanted[] = {200, 100, 50, 10, 20, 30};
    assert_memory_equal(rgb, wanted, sizeof wanted);
    free(rgb);
    image_free(image);
}

static void alpha_is_dropped_from_colour_and_from_grey(void **state)
{
    (void)state;
    const uint16_t grey[] = {77, 0}, color[] = {1, 2, 3, 0};
    struct image *image = read_made(&(struct made_png){
        .width = 1, .height = 1, .bits = 8, .color_type = PNG_COLOR_TYPE_GRAY_ALPHA, .samples = grey});
    assert_int_equal(image->channels, 2);
    uint8_t *rgb = image_rgb8(image);
    assert_memory_equal(rgb, ((const uint8_t[]){77, 77, 77}), 3);
    free(rgb);
    image_free(image);
    image = read_made(&(struct made_png){
        .width = 1, .height = 1, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB_ALPHA, .samples = color});
    assert_int_equal(image->channels, 4);
    rgb = image_rgb8(image);
    assert_memory_equal(rgb, ((const uint8_t[]){1, 2, 3}), 3);
    free(rgb);
    image_free(image);
}

static void an_interlaced_picture_is_the_same_picture(void **state)
{
    (void)state;
    enum { WIDTH = 13, HEIGHT = 11 };
    uint16_t samples[WIDTH * HEIGHT];
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        samples[i] = (uint16_t)(i * 419);
    struct made_png made = {.width = WIDTH, .height = HEIGHT, .bits = 16, .samples = samples};
    struct image *plain = read_made(&made);
    made.interlace = PNG_INTERLACE_ADAM7;
    struct image *interlaced = read_made(&made);
    assert_memory_equal(plain->samples, samples, sizeof samples);
    assert_memory_equal(interlaced->samples, samples, sizeof samples);
    image_free(plain);
    image_free(interlaced);
}

static void grey_of_grey_keeps_sixteen_bits(void **state)
{
    (void)state;
    const uint16_t samples[] = {12345, 12346};
    struct image *image = read_made(&(struct made_png){.width = 2, .height = 1, .bits = 16, .samples = samples});
    double *grey = image_grey(image);
    for (int i = 0; i < 2; i++)
        assert_true(fabs(grey[i] - samples[i] / 65535.) < 1e-12);
    free(grey);
    image_free(image);
}

static void grey_of_a_colour_weighs_green_most(void **state)
{
    (void)state;
    const uint16_t samples[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
    struct image *image = read_made(
        &(struct made_png){.width = 4, .height = 1, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = samples});
    assert_false(image_is_grey(image));
    uint8_t *grey = image_grey8(image);
    assert_memory_equal(grey, ((const uint8_t[]){54, 182, 19, 255}), 4);
    free(grey);
    image_free(image);
}

static void a_colour_that_differs_in_one_channel_is_no_grey(void **state)
{
    (void)state;
    for (unsigned k = 0; k < 3; k++) {
        uint16_t samples[3] = {7, 7, 7};
        samples[k] = 8;
        struct image *image = read_made(&(struct made_png){
            .width = 1, .height = 1, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = samples});
        assert_false(image_is_grey(image));
        image_free(image);
    }
}

/* ---- what is no picture ---- */

static void write_bytes(const char *path, const void *bytes, size_t len)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, len, file), len);
    assert_int_equal(fclose(file), 0);
}

static void assert_not_read(const char *path, const char *what)
{
    char command[128];
    snprintf(command, sizeof command, "$GLINT render --height %s -o out.png", path);
    assert_fails(command, what);
    assert_fails(command, path);
    assert_false(exists("out.png"));
}

static void a_missing_file_is_named_in_one_line(void **state)
{
    (void)state;
    assert_not_read("missing.png", "No such file");
}

static void a_directory_is_named_in_one_line(void **state)
{
    (void)state;
    assert_not_read("/usr", "directory");
}

static void an_empty_file_is_named_in_one_line(void **state)
{
    (void)state;
    write_bytes("empty.png", "", 0);
    assert_not_read("empty.png", "this file is empty");
}

static void other_files_are_called_what_they_are(void **state)
{
    (void)state;
    write_bytes("photo.png", "\xFF\xD8\xFF\xE0....JFIF", 12);
    assert_not_read("photo.png", "a JPEG");
    write_bytes("text.png", "hello\n", 6);
    assert_not_read("text.png", "not a PNG");
}

/* Every length of a small file but the whole is an error, and never a crash. */
static void a_file_cut_anywhere_is_refused(void **state)
{
    (void)state;
    uint16_t samples[6 * 5 * 3];
    for (int i = 0; i < 6 * 5 * 3; i++)
        samples[i] = (uint16_t)(i / 3 * 37 % 256);
    make_png(
        "whole.png",
        &(struct made_png){.width = 6, .height = 5, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = samples});
    static char bytes[4096];
    FILE *file = fopen("whole.png", "rb");
    assert_non_null(file);
    const size_t len = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    assert_true(len > 60 && len < sizeof bytes);
    for (size_t cut = 1; cut < len; cut += 3) {
        write_bytes("cut.png", bytes, cut);
        assert_not_read("cut.png", "ends within the picture");
    }
    assert_quiet("$GLINT render --height whole.png -o out.png");
    assert_int_equal(remove("out.png"), 0);
}

static void a_flipped_byte_is_refused(void **state)
{
    (void)state;
    uint16_t samples[16 * 16];
    for (int i = 0; i < 16 * 16; i++)
        samples[i] = (uint16_t)(i * i % 251);
    make_png("whole.png", &(struct made_png){.width = 16, .height = 16, .bits = 8, .samples = samples});
    static char bytes[4096];
    FILE *file = fopen("whole.png", "rb");
    assert_non_null(file);
    const size_t len = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    assert_true(len > 100);
    bytes[len / 2] ^= 0x10;
    write_bytes("damaged.png", bytes, len);
    assert_not_read("damaged.png", "damaged PNG");
}

/* 65535 x 65535 pixels in a hundred bytes: refused by its size, before memory is asked for. */
/* A PNG that says so, and holds nothing. */
static void write_head(const char *path, uint32_t width, uint32_t height)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_write_chunk(png, (png_const_bytep) "IDAT", (png_const_bytep) "data", 4);
    png_destroy_write_struct(&png, &info);
    assert_int_equal(fclose(file), 0);
}

static void a_picture_too_large_is_refused_by_its_size(void **state)
{
    (void)state;
    write_head("huge.png", 65535, 65535);
    assert_not_read("huge.png", "65535x65535");
    write_head("wide.png", SIDE_MAX + 1, 1);
    assert_not_read("wide.png", "16385x1 pixels; at most 16384 a side");
    write_head("tall.png", 1, SIDE_MAX + 1);
    assert_not_read("tall.png", "1x16385 pixels; at most 16384 a side");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eight_bits_become_sixteen_by_repetition),
        cmocka_unit_test(sixteen_bits_are_read_whole),
        cmocka_unit_test(low_depths_span_black_to_white),
        cmocka_unit_test(a_palette_is_read_as_its_colours),
        cmocka_unit_test(alpha_is_dropped_from_colour_and_from_grey),
        cmocka_unit_test(an_interlaced_picture_is_the_same_picture),
        cmocka_unit_test(grey_of_grey_keeps_sixteen_bits),
        cmocka_unit_test(grey_of_a_colour_weighs_green_most),
        cmocka_unit_test(a_missing_file_is_named_in_one_line),
        cmocka_unit_test(a_directory_is_named_in_one_line),
        cmocka_unit_test(an_empty_file_is_named_in_one_line),
        cmocka_unit_test(other_files_are_called_what_they_are),
        cmocka_unit_test(a_file_cut_anywhere_is_refused),
        cmocka_unit_test(a_flipped_byte_is_refused),
        cmocka_unit_test(a_colour_that_differs_in_one_channel_is_no_grey),
        cmocka_unit_test(a_picture_too_large_is_refused_by_its_size),
    };
    return cmocka_run_group_tests_name("images", tests, scratch_make, scratch_remove);
}
