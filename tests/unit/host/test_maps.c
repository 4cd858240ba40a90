/* SPDX-License-Identifier: MIT
 * Maps as they come from artists: logos, alpha as a mask, green that points down; what is said about them. */
#include <math.h>

#include "base/memory.h"
#include "files.h"
#include "image/read.h"
#include "scene/bevel.h"
#include "scene/curl.h"
#include "scene/logo.h"
#include "scene/normals.h"

/* ---- distances and bevels ---- */

static uint32_t random_state = 1;

static unsigned below(unsigned limit)
{
    random_state = random_state * 1664525 + 1013904223;
    return (unsigned)((uint64_t)random_state * limit >> 32);
}

static double nearest_by_search(const double *coverage, int width, int height, int at)
{
    double nearest = INFINITY;
    for (int i = 0; i < width * height; i++)
        if (coverage[i] < .5)
            nearest = fmin(nearest, hypot(i % width - at % width, i / width - at / width));
    return nearest;
}

static void distances_are_those_of_a_search_over_all_pixels(void **state)
{
    (void)state;
    enum { LARGEST = 40 };
    double coverage[LARGEST * LARGEST];
    for (int round = 0; round < 300; round++) {
        const int width = 1 + (int)below(LARGEST), height = 1 + (int)below(LARGEST);
        const unsigned holes = 1 + below(round % 3 ? 5 : 200);
        for (int i = 0; i < width * height; i++)
            coverage[i] = 1;
        for (unsigned k = 0; k < holes; k++)
            coverage[below((unsigned)(width * height))] = 0;
        double *distances = bevel_distances(coverage, (uint32_t)width, (uint32_t)height);
        for (int i = 0; i < width * height; i++) {
            const double nearest = nearest_by_search(coverage, width, height, i);
            assert_near(distances[i], coverage[i] == 0 ? 0 : nearest - .5, 1e-12);
        }
        free(distances);
    }
}

static void a_pixel_half_covered_moves_the_edge_within_it(void **state)
{
    (void)state;
    const double sharp[] = {1, 1, 1, .8, 0, 0}, faint[] = {1, 1, 1, .3, 0, 0};
    double *distances = bevel_distances(sharp, 6, 1);
    for (int x = 0; x < 4; x++)
        assert_near(distances[x], 3.3 - x, 1e-12);
    free(distances);
    distances = bevel_distances(faint, 1, 6);
    for (int y = 0; y < 3; y++)
        assert_near(distances[y], 2.8 - y, 1e-12);
    assert_near(distances[3], 0, 0);
    free(distances);
}

enum { SIDE = 64, PIXELS = SIDE * SIDE, EDGE = 20, BEVEL = 16 };

/* A black logo on a transparent ground, the same in white on black, and in black on white: right of EDGE. */
static void make_logos(void)
{
    static uint16_t alpha[2 * PIXELS], white[PIXELS], black[PIXELS];
    for (int i = 0; i < PIXELS; i++) {
        const int x = i % SIDE, y = i / SIDE;
        const bool inside = x >= EDGE && x < SIDE - 2 && y >= 2 && y < SIDE - 2;
        alpha[2 * i + 1] = white[i] = inside ? 255 : 0;
        black[i] = inside ? 0 : 255;
    }
    make_png("logo.png", &(struct made_png){SIDE, SIDE, 8, PNG_COLOR_TYPE_GRAY_ALPHA, .samples = alpha});
    make_png("white.png", &(struct made_png){SIDE, SIDE, 8, .samples = white});
    make_png("black.png", &(struct made_png){SIDE, SIDE, 8, .samples = black});
}

static void a_bevel_rises_as_a_quarter_of_a_circle_to_a_plateau(void **state)
{
    (void)state;
    make_logos();
    struct image *logo = image_read("logo.png");
    double *heights = bevel_heights(logo, BEVEL);
    const double *line = &heights[SIDE / 2 * SIDE];
    for (int x = 0; x < EDGE - 2; x++)
        assert_near(line[x], 0, 0);
    for (int x = EDGE + 4; x < EDGE + BEVEL + 4; x++) {
        const double left = fmax(0, 1 - (x - EDGE + .5) / BEVEL);
        assert_near(line[x], sqrt(1 - left * left), .01); /* smoothed */
    }
    assert_near(line[EDGE + BEVEL + 3], 1, 1e-12);
    struct scene *scene = scene_from_relief(heights, SIDE, SIDE, BEVEL, false);
    for (int x = EDGE + 3; x < EDGE + BEVEL - 2; x++) { /* on a circle the normal's x is the way to its middle */
        const double *n = scene->normals[SIDE / 2 * SIDE + x];
        assert_near(n[0], -(1 - (x - EDGE + .5) / BEVEL), .04);
        assert_near(n[1], 0, 1e-12);
    }
    scene_free(scene);
    free(heights);
    image_free(logo);
}

static void a_logo_in_alpha_in_white_and_in_black_has_the_same_bevel(void **state)
{
    (void)state;
    make_logos();
    assert_quiet("$GLINT render --height logo.png --bevel 9 -o alpha.ppm && "
                 "$GLINT render --height white.png --bevel 9 -o white.ppm && "
                 "$GLINT render --height black.png --bevel 9 --scale 9 -o black.ppm && "
                 "$GLINT render --height black.png --bevel 9 --scale=-9 -o sunk.ppm");
    assert_same_file("alpha.ppm", "white.ppm");
    assert_same_file("alpha.ppm", "black.ppm");
    assert_false(same_file("alpha.ppm", "sunk.ppm"));
}

static void a_bevel_without_a_shape_is_one_line(void **state)
{
    (void)state;
    static const uint16_t grey[2 * PIXELS] = {0};
    make_png("clear.png", &(struct made_png){SIDE, SIDE, 8, PNG_COLOR_TYPE_GRAY_ALPHA, .samples = grey});
    make_png("grey.png", &(struct made_png){SIDE, SIDE, 8, .samples = grey});
    assert_fails("$GLINT render --height grey.png --bevel 4 -o no.png", "grey.png: --bevel: the picture has no shape");
    assert_fails("$GLINT render --height clear.png --bevel 4 -o no.png", "has no shape");
    assert_false(exists("no.png"));
    assert_refused("$GLINT render --scene coin --bevel 4 -o no.png", "--bevel needs --height");
    assert_refused("$GLINT render --height grey.png --wrap --bevel 4 -o no.png", "--wrap cannot be used with --bevel");
    assert_refused("$GLINT render --height grey.png --bevel 0 -o no.png", "--bevel");
}

/* ---- logos of any size ---- */

static double coverage_at(const struct image *fitted, uint32_t x, uint32_t y)
{
    return fitted->samples[(size_t)y * fitted->width + x] / 65535.;
}

/* The columns, or lines, of the picture in which the shape covers half of a pixel. */
static void find_extent(const struct image *fitted, bool down, uint32_t *first, uint32_t *last)
{
    *first = UINT32_MAX;
    for (uint32_t y = 0; y < fitted->height; y++)
        for (uint32_t x = 0; x < fitted->width; x++) {
            const uint32_t at = down ? y : x;
            if (coverage_at(fitted, x, y) < .5)
                continue;
            *first = at < *first ? at : *first;
            *last = at > *last || *first == at ? at : *last;
        }
}

static void a_fitted_logo_is_in_the_middle_and_takes_the_percent_of_the_side_that_is_full_first(void **state)
{
    (void)state;
    make_logos(); /* its shape: 42x60 */
    static const struct {
        uint32_t width, height;
        double percent;
    } fits[] = {{62, 62, 100}, {240, 240, 70}, {240, 240, 100}, {320, 90, 50},
                {40, 300, 80}, {33, 20, 60},   {8, 8, 100}};
    struct image *logo = image_read("white.png");
    for (size_t i = 0; i < sizeof fits / sizeof *fits; i++) {
        const uint32_t width = fits[i].width, height = fits[i].height;
        struct image *fitted = logo_fitted(logo, width, height, fits[i].percent);
        const double scale = fmin((width - 2) / 42., (height - 2) / 60.) * fits[i].percent / 100;
        uint32_t left, right, top, bottom;
        find_extent(fitted, false, &left, &right);
        find_extent(fitted, true, &top, &bottom);
        assert_near(right - left + 1, 42 * scale, 1.01);
        assert_near(bottom - top + 1, 60 * scale, 1.01);
        assert_near((left + right) / 2., (width - 1) / 2., .51);
        assert_near((top + bottom) / 2., (height - 1) / 2., .51);
        double area = 0;
        for (uint32_t y = 0; y < height; y++)
            for (uint32_t x = 0; x < width; x++)
                area += coverage_at(fitted, x, y);
        assert_near(area / (42 * 60 * scale * scale), 1, 1.1 / fmin(width, height));
        image_free(fitted);
    }
    image_free(logo);
}

static void a_logo_that_fits_as_it_is_keeps_every_pixel_and_alpha_and_brightness_fit_alike(void **state)
{
    (void)state;
    make_logos();
    struct image *logo = image_read("white.png"), *fitted = logo_fitted(logo, 62, 62, 100);
    for (uint32_t y = 0; y < 62; y++)
        for (uint32_t x = 0; x < 52; x++)
            assert_int_equal(fitted->samples[62 * y + x], logo->samples[SIDE * (y + 1) + x + 10]);
    image_free(logo);
    image_free(fitted);
    assert_quiet("$GLINT render --height logo.png --bevel 5 --fit 70 --size 50x40 -o alpha.ppm && "
                 "$GLINT render --height black.png --bevel 5 --fit 70 --size 50x40 -o black.ppm && "
                 "$GLINT render --height black.png --bevel 5 --size 50x40 -o cut.ppm");
    assert_same_file("alpha.ppm", "black.ppm");
    assert_false(same_file("alpha.ppm", "cut.ppm"));
}

/* A line of 2x60 pixels. */
static void a_fitted_logo_thinner_than_a_pixel_covers_what_it_covers(void **state)
{
    (void)state;
    enum { SMALL = 16 };
    static uint16_t line[PIXELS];
    for (int i = 0; i < PIXELS; i++)
        line[i] = i % SIDE / 2 == 15 && i / SIDE >= 2 && i / SIDE < 62 ? 255 : 0;
    make_png("line.png", &(struct made_png){SIDE, SIDE, 8, .samples = line});
    const double scale = (SMALL - 2) / 60.;
    struct image *logo = image_read("line.png"), *fitted = logo_fitted(logo, SMALL, SMALL, 100);
    double *coverage = bevel_coverage(fitted), area = 0;
    for (size_t i = 0; i < SMALL * SMALL; i++)
        area += coverage[i];
    assert_near(area / (2 * 60 * scale * scale), 1, .05);
    free(coverage);
    image_free(logo);
    image_free(fitted);
    const char *const command =
        "$GLINT render --height line.png --bevel 2 --fit 100 --size 16x16 --ambient 1 --diffuse 0 "
        "--specular 0 --color 255,255,255 --background 0,0,0 --image raw -o - | od -An -tu1 -v | tr -s ' ' '\\n' | "
        "sort -n | tail -1";
    const int most = atoi(run(command)->out);
    assert_in_range(most, 255 * scale - 1, 255 * 2 * scale + 1); /* it may lie between two pixels */
}

static void what_cannot_be_fitted_is_refused(void **state)
{
    (void)state;
    make_logos();
    static const char *const wrong[][2] = {
        {"--height logo.png --fit 70 --size 50x40", "--fit needs a logo, with --bevel"},
        {"--scene coin --fit 70 --size 50x40", "--fit needs a logo, with --bevel"},
        {"--height logo.png --bevel 4 --fit 70", "--fit needs --size, of at least 8x8"},
        {"--height logo.png --bevel 4 --fit 70 --size 50x7", "--fit needs --size, of at least 8x8"},
        {"--height logo.png --bevel 4 --fit 70 --size 50x40 --wrap", "--wrap cannot be used with --bevel"},
        {"--height logo.png --bevel 4 --fit 0 --size 50x40", "--fit: '0' is not a number from 1 to 100"},
        {"--height logo.png --bevel 4 --fit 101 --size 50x40", "--fit: '101' is not a number from 1 to 100"},
        {"--height logo.png --bevel 4 --fit 70 --size 500x400 --filter 32", "--fit: with --filter 32"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[160];
        snprintf(line, sizeof line, "$GLINT render %s -o no.png", wrong[i][0]);
        assert_refused(line, wrong[i][1]);
    }
    assert_fails("$GLINT render --height logo.png --bevel 4 --fit 70 --size 50x40 --albedo black.png -o no.png",
                 "black.png: 64x64 pixels, but the height map has 50x40");
}

static void a_height_map_without_heights_says_so_and_names_bevel(void **state)
{
    (void)state;
    make_logos();
    const struct run *result = run("$GLINT render --height logo.png -o flat.png");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "logo.png: has no heights");
    assert_contains(result->err, "--bevel WIDTH");
    assert_quiet("$GLINT render --height white.png -o relief.png");
}

/* ---- alpha ---- */

static void the_alpha_of_a_mask_is_the_mask_and_that_is_said_once(void **state)
{
    (void)state;
    make_logos();
    assert_quiet("$GLINT render --scene coin --size 64x64 --mask white.png -o white.ppm");
    const struct run *result = run("$GLINT render --scene coin --size 64x64 --mask logo.png -o alpha.ppm");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "logo.png: its alpha is the mask");
    assert_same_file("alpha.ppm", "white.ppm");
    assert_one_line(run("$GLINT stream coin --size 64x64 --mask logo.png --to none --frames 3 >out.txt")->err);
}

static void a_mask_whose_alpha_leaves_nothing_out_counts_by_brightness(void **state)
{
    (void)state;
    make_logos();
    static uint16_t opaque[2 * PIXELS];
    for (int i = 0; i < PIXELS; i++) {
        opaque[2 * i] = i % SIDE < EDGE || i % SIDE >= SIDE - 2 || i / SIDE < 2 || i / SIDE >= SIDE - 2 ? 0 : 255;
        opaque[2 * i + 1] = 255;
    }
    make_png("opaque.png", &(struct made_png){SIDE, SIDE, 8, PNG_COLOR_TYPE_GRAY_ALPHA, .samples = opaque});
    assert_quiet("$GLINT render --scene coin --size 64x64 --mask white.png -o white.ppm && "
                 "$GLINT render --scene coin --size 64x64 --mask opaque.png -o opaque.ppm");
    assert_same_file("opaque.ppm", "white.ppm");
}

static void the_alpha_of_a_normal_map_is_its_mask(void **state)
{
    (void)state;
    const uint16_t with_alpha[] = {128, 128, 255, 255, 128, 127, 128, 0}, plain[] = {128, 128, 255, 128, 128, 255};
    const uint16_t mask[] = {255, 0};
    make_png("alpha.png", &(struct made_png){2, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, .samples = with_alpha});
    make_png("plain.png", &(struct made_png){2, 1, 8, PNG_COLOR_TYPE_RGB, .samples = plain});
    make_png("mask.png", &(struct made_png){2, 1, 8, .samples = mask});
    const struct run *result = run("$GLINT render --normals alpha.png -o alpha.ppm");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "alpha.png: its alpha is the mask");
    assert_quiet("$GLINT render --normals plain.png --mask mask.png -o plain.ppm");
    assert_same_file("alpha.ppm", "plain.ppm");
}

/* ---- green ---- */

/* The stone wall's normals as 8-bit RGB, green up or down. */
static void make_normal_map(const char *path, bool down, bool across_only)
{
    char wall[400];
    snprintf(wall, sizeof wall, "%s/tests/data/rockwall-height.png", getenv("GLINT_SOURCE"));
    struct image *heights = image_read(wall);
    struct scene *scene = scene_from_heights(heights, 8, true);
    const uint32_t width = scene->width, height = scene->height;
    uint16_t *samples = allocate((size_t)width * height, 3 * sizeof *samples);
    for (size_t i = 0; i < (size_t)width * height; i++) {
        const double *n = scene->normals[across_only ? i % width : i];
        const uint16_t green = (uint16_t)lround(127.5 + 127.5 * (across_only ? 0 : n[1]));
        samples[3 * i] = (uint16_t)lround(127.5 + 127.5 * n[0]);
        samples[3 * i + 1] = down ? (uint16_t)(255 - green) : green;
        samples[3 * i + 2] = (uint16_t)lround(127.5 + 127.5 * n[2]);
    }
    make_png(path, &(struct made_png){width, height, 8, PNG_COLOR_TYPE_RGB, .samples = samples});
    free(samples);
    scene_free(scene);
    image_free(heights);
}

static void green_that_points_down_is_noticed(void **state)
{
    (void)state;
    make_normal_map("up.png", false, false);
    make_normal_map("down.png", true, false);
    assert_quiet("$GLINT render --normals up.png -o up.ppm");
    const struct run *result = run("$GLINT render --normals down.png -o down.ppm");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "down.png: green seems to point down");
    assert_contains(result->err, "with --flip-y");
    assert_quiet("$GLINT render --normals down.png --flip-y -o flipped.ppm");
    assert_same_file("flipped.ppm", "up.ppm");
    assert_one_line(run("$GLINT bake --normals up.png --flip-y -o up.bin >out.txt")->err);
    assert_contains(run("$GLINT bake --normals up.png --flip-y -o up.bin >out.txt")->err, "without --flip-y");
}

static void where_no_way_fits_better_nothing_is_said(void **state)
{
    (void)state;
    make_normal_map("grooves.png", false, true);
    assert_quiet("$GLINT render --normals grooves.png -o grooves.ppm && "
                 "$GLINT render --normals grooves.png --flip-y -o grooves.ppm");
    static uint16_t noise[3 * PIXELS];
    for (int i = 0; i < PIXELS; i++) {
        noise[3 * i] = (uint16_t)(98 + below(60));
        noise[3 * i + 1] = (uint16_t)(98 + below(60));
        noise[3 * i + 2] = 250;
    }
    make_png("noise.png", &(struct made_png){SIDE, SIDE, 8, PNG_COLOR_TYPE_RGB, .samples = noise});
    assert_quiet("$GLINT render --normals noise.png -o noise.ppm && "
                 "$GLINT render --normals noise.png --flip-y -o noise.ppm");
}

static void what_the_mask_leaves_out_does_not_tell_which_way_green_points(void **state)
{
    (void)state;
    struct scene *scene = scene_new(SIDE, SIDE);
    static uint8_t mask[PIXELS];
    for (int i = 0; i < PIXELS; i++) { /* a saddle, green down: only where the mask is 0 */
        const int x = i % SIDE - SIDE / 2, y = i / SIDE - SIDE / 2;
        mask[i] = x < 0;
        const double n[3] = {mask[i] ? 0 : -y / 64., mask[i] ? 0 : -x / 64., 1};
        memcpy(scene->normals[i], n, sizeof n);
    }
    assert_true(curl_says_flipped(scene, NULL));
    assert_false(curl_says_flipped(scene, mask));
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_are_those_of_a_search_over_all_pixels),
        cmocka_unit_test(a_pixel_half_covered_moves_the_edge_within_it),
        cmocka_unit_test(a_bevel_rises_as_a_quarter_of_a_circle_to_a_plateau),
        cmocka_unit_test(a_logo_in_alpha_in_white_and_in_black_has_the_same_bevel),
        cmocka_unit_test(a_bevel_without_a_shape_is_one_line),
        cmocka_unit_test(a_fitted_logo_is_in_the_middle_and_takes_the_percent_of_the_side_that_is_full_first),
        cmocka_unit_test(a_fitted_logo_thinner_than_a_pixel_covers_what_it_covers),
        cmocka_unit_test(a_logo_that_fits_as_it_is_keeps_every_pixel_and_alpha_and_brightness_fit_alike),
        cmocka_unit_test(what_cannot_be_fitted_is_refused),
        cmocka_unit_test(a_height_map_without_heights_says_so_and_names_bevel),
        cmocka_unit_test(the_alpha_of_a_mask_is_the_mask_and_that_is_said_once),
        cmocka_unit_test(a_mask_whose_alpha_leaves_nothing_out_counts_by_brightness),
        cmocka_unit_test(the_alpha_of_a_normal_map_is_its_mask),
        cmocka_unit_test(green_that_points_down_is_noticed),
        cmocka_unit_test(where_no_way_fits_better_nothing_is_said),
        cmocka_unit_test(what_the_mask_leaves_out_does_not_tell_which_way_green_points),
    };
    return cmocka_run_group_tests_name("maps", tests, make_maps, scratch_remove);
}
