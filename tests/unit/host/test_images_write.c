/* SPDX-License-Identifier: MIT
 * Writing PNG, PPM, PBM and QOI. */
#include <string.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#define QOI_IMPLEMENTATION
#define QOI_NO_STDIO
#include <qoi.h>
#pragma GCC diagnostic pop

#include "files.h"

#include "base/output.h"
#include "image/image.h"
#include "image/levels.h"
#include "image/picture.h"
#include "image/read.h"
#include "image/write.h"

static const uint8_t color_samples[] = {0, 1, 2, 255, 254, 253, 128, 0, 255, 7, 7, 7, 1, 2, 3, 250, 100, 0};
static const struct picture color_picture = {3, 2, 3, false, (uint8_t *)color_samples};
enum { MONO_WIDTH = 11 };
static const uint8_t mono_samples[2 * MONO_WIDTH] = {255, 0, 0, 255, 0, 0, 0, 255, 255, 0, 255,
                                                     0,   0, 0, 255, 0, 0, 0, 0,   255, 0, 0};
static const struct picture mono_picture = {MONO_WIDTH, 2, 1, true, (uint8_t *)mono_samples};
static const struct picture grey_picture = {MONO_WIDTH, 2, 1, false, (uint8_t *)mono_samples};

static void write_picture(const struct picture *picture, const char *path, enum image_kind kind)
{
    struct output *output = output_open(path);
    picture_write(picture, output, kind);
    output_close(output);
}

static void a_written_png_reads_back(void **state)
{
    (void)state;
    write_picture(&color_picture, "color.png", IMAGE_PNG);
    struct image *image = image_read("color.png");
    assert_int_equal(image->width, 3);
    assert_int_equal(image->height, 2);
    uint8_t *rgb = image_rgb8(image);
    assert_memory_equal(rgb, color_samples, sizeof color_samples);
    free(rgb);
    image_free(image);
}

static void mono_is_a_one_bit_png_and_grey_an_eight_bit_one(void **state)
{
    (void)state;
    write_picture(&mono_picture, "mono.png", IMAGE_PNG);
    write_picture(&grey_picture, "grey.png", IMAGE_PNG);
    struct image *mono = image_read("mono.png"), *grey = image_read("grey.png");
    assert_int_equal(mono->bits, 1);
    assert_int_equal(grey->bits, 8);
    for (size_t i = 0; i < sizeof mono_samples; i++) {
        assert_int_equal(mono->samples[i], 257 * mono_samples[i]);
        assert_int_equal(grey->samples[i], 257 * mono_samples[i]);
    }
    image_free(mono);
    image_free(grey);
}

static size_t read_bytes(const char *path, uint8_t *bytes, size_t room)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t len = fread(bytes, 1, room, file);
    fclose(file);
    return len;
}

static void a_ppm_holds_the_samples_after_its_head(void **state)
{
    (void)state;
    uint8_t bytes[128];
    write_picture(&color_picture, "color.ppm", IMAGE_PPM);
    size_t len = read_bytes("color.ppm", bytes, sizeof bytes);
    assert_int_equal(len, 11 + sizeof color_samples);
    assert_memory_equal(bytes, "P6\n3 2\n255\n", 11);
    assert_memory_equal(bytes + 11, color_samples, sizeof color_samples);
    write_picture(&grey_picture, "grey.ppm", IMAGE_PPM);
    len = read_bytes("grey.ppm", bytes, sizeof bytes);
    assert_int_equal(len, 12 + sizeof mono_samples);
    assert_memory_equal(bytes, "P5\n11 2\n255\n", 12);
    assert_memory_equal(bytes + 12, mono_samples, sizeof mono_samples);
}

static void a_pbm_has_a_bit_for_black(void **state)
{
    (void)state;
    uint8_t bytes[64];
    write_picture(&mono_picture, "mono.ppm", IMAGE_PPM);
    assert_int_equal(read_bytes("mono.ppm", bytes, sizeof bytes), 8 + 4);
    assert_memory_equal(bytes, "P4\n11 2\n", 8);
    for (int i = 0; i < 2 * MONO_WIDTH; i++) {
        const int x = i % MONO_WIDTH, y = i / MONO_WIDTH;
        assert_int_equal(bytes[8 + 2 * y + x / 8] >> (7 - x % 8) & 1, mono_samples[i] == 0);
    }
}

/* In parts of any size, too: of noise, of slow slopes and of runs that lines and parts end; of RGB and of RGBA. */
static void a_qoi_has_the_bytes_of_its_reference_encoder(void **state)
{
    (void)state;
    enum { WIDTH = 61, HEIGHT = 40 };
    static uint8_t samples[4 * WIDTH * HEIGHT], bytes[1 << 16];
    uint32_t random = 1;
    for (unsigned turn = 0; turn < 8; turn++) {
        const unsigned kind = turn / 2, channels = 3 + turn % 2;
        for (size_t i = 0; i < sizeof samples; i++) {
            random = random * 1664525 + 1013904223;
            samples[i] = (uint8_t)(kind == 0   ? random >> 24
                                   : kind == 1 ? i / channels % WIDTH * (1 + i % channels) + (random >> 30)
                                   : kind == 2 ? (i / channels / 150) % 3 * 80
                                   : i >= channels && (random >> 29) ? samples[i - channels]
                                                                     : random >> 24);
        }
        struct output *output = output_open("parts.qoi");
        struct picture part = {WIDTH, 1, channels, false, samples};
        struct picture_file *file = picture_file_begin(output, IMAGE_QOI, &part, HEIGHT);
        for (uint32_t y = 0; y < HEIGHT; y += part.height) {
            part.height = HEIGHT - y < 7 ? HEIGHT - y : 1 + y % 7;
            part.samples = samples + (size_t)channels * WIDTH * y;
            picture_file_add(file, &part);
        }
        picture_file_end(file);
        output_close(output);
        int len;
        void *wanted = qoi_encode(samples, &(qoi_desc){WIDTH, HEIGHT, (uint8_t)channels, QOI_SRGB}, &len);
        assert_int_equal(read_bytes("parts.qoi", bytes, sizeof bytes), len);
        assert_memory_equal(bytes, wanted, (size_t)len);
        free(wanted);
    }
}

static void a_qoi_decodes_to_the_samples_and_grey_to_equal_ones(void **state)
{
    (void)state;
    uint8_t bytes[512];
    qoi_desc desc;
    write_picture(&color_picture, "color.qoi", IMAGE_QOI);
    uint8_t *rgb = qoi_decode(bytes, (int)read_bytes("color.qoi", bytes, sizeof bytes), &desc, 3);
    assert_non_null(rgb);
    assert_int_equal(desc.width, 3);
    assert_int_equal(desc.height, 2);
    assert_int_equal(desc.channels, 3);
    assert_memory_equal(rgb, color_samples, sizeof color_samples);
    free(rgb);
    write_picture(&grey_picture, "grey.qoi", IMAGE_QOI);
    rgb = qoi_decode(bytes, (int)read_bytes("grey.qoi", bytes, sizeof bytes), &desc, 3);
    assert_non_null(rgb);
    for (size_t i = 0; i < 3 * sizeof mono_samples; i++)
        assert_int_equal(rgb[i], mono_samples[i / 3]);
    free(rgb);
}

static void levels_widen_by_their_bits_again_where_that_is_asked_for(void **state)
{
    (void)state;
    uint8_t values[64][3], mono[] = {0, 1};
    for (unsigned i = 0; i < 64; i++)
        memcpy(values[i], (const uint8_t[]){(uint8_t)(i / 2), (uint8_t)i, (uint8_t)(i / 2)}, 3);
    const struct levels levels = {64, 1, 3, {31, 63, 31}, values[0]}, bits = {2, 1, 1, {1}, mono};
    struct picture *again = levels_picture(&levels, WIDEN_REPLICATE);
    for (unsigned i = 0; i < 64; i++) {
        const unsigned five = i / 2;
        assert_int_equal(again->samples[3 * i], five << 3 | five >> 2);
        assert_int_equal(again->samples[3 * i + 1], i << 2 | i >> 4);
    }
    struct picture *black_white = levels_picture(&bits, WIDEN_REPLICATE);
    assert_int_equal(black_white->samples[0], 0);
    assert_int_equal(black_white->samples[1], 255);
    picture_free(again);
    picture_free(black_white);
}

static void replicate_changes_the_picture_and_is_refused_where_there_is_none(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --scene coin --size 40x40 --format rgb565 -o a.png");
    assert_quiet("$GLINT render --scene coin --size 40x40 --format rgb565 --replicate -o b.png");
    assert_int_equal(run("cmp -s a.png b.png")->status, 1);
    assert_refused("$GLINT render --scene coin --replicate --image raw -o c",
                   "--replicate cannot be used with --image raw");
    assert_refused("$GLINT render --scene coin --replicate --compare", "give -o FILE");
    assert_refused("$GLINT render --scene coin --replicate -o c.png", "--replicate needs --format rgb565");
}

static void the_kind_follows_the_ending(void **state)
{
    (void)state;
    assert_int_equal(image_kind_by_ending("a.png"), IMAGE_PNG);
    assert_int_equal(image_kind_by_ending("dir.qoi/a.PPM"), IMAGE_PPM);
    assert_int_equal(image_kind_by_ending("a.b.qoi"), IMAGE_QOI);
    assert_int_equal(image_kind_by_ending("dir.jpg/a"), IMAGE_PNG);
    assert_int_equal(image_kind_by_ending("-"), IMAGE_PNG);
    assert_int_equal(image_kind_by_ending("dir/.hidden"), IMAGE_PNG);
    assert_int_equal(image_kind_by_ending(".."), IMAGE_PNG);
    assert_int_equal(image_kind_by_ending("a.jpg"), IMAGE_KINDS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_written_png_reads_back),
        cmocka_unit_test(mono_is_a_one_bit_png_and_grey_an_eight_bit_one),
        cmocka_unit_test(a_ppm_holds_the_samples_after_its_head),
        cmocka_unit_test(a_pbm_has_a_bit_for_black),
        cmocka_unit_test(a_qoi_has_the_bytes_of_its_reference_encoder),
        cmocka_unit_test(a_qoi_decodes_to_the_samples_and_grey_to_equal_ones),
        cmocka_unit_test(levels_widen_by_their_bits_again_where_that_is_asked_for),
        cmocka_unit_test(replicate_changes_the_picture_and_is_refused_where_there_is_none),
        cmocka_unit_test(the_kind_follows_the_ending),
    };
    return cmocka_run_group_tests_name("images written", tests, scratch_make, scratch_remove);
}
