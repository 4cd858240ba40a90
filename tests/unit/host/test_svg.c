/* SPDX-License-Identifier: MIT
 * SVG pictures: drawn where glint was built with librsvg, else refused with how to convert them. */
#include "files.h"

#include "image/image.h"
#include "image/read.h"
#include "image/svg.h"

/* 8x4: the left half red, of the right half the upper line half covered in black, the rest clear. */
#define DRAWING                                                                                                        \
    "<rect width='4' height='4' fill='#ff0000'/><rect x='4' width='4' height='1' fill='#000000' fill-opacity='.5'/>"

static void make_svg(const char *path, const char *attributes, const char *drawing)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "\n<svg xmlns='http://www.w3.org/2000/svg' %s>%s</svg>\n", attributes, drawing);
    assert_int_equal(fclose(file), 0);
}

#if GLINT_WITH_SVG
static void assert_sample(const struct image *image, unsigned x, unsigned y, const int rgba[4])
{
    for (unsigned k = 0; k < 4; k++)
        assert_near(image->samples[(y * image->width + x) * 4 + k] / 257., rgba[k], 1);
}

static void a_drawing_is_read_at_its_own_size_with_its_alpha(void **state)
{
    (void)state;
    static const char *const sizes[] = {"width='8' height='4'", "viewBox='0 0 8 4'",
                                        "width='6pt' height='3pt' viewBox='0 0 8 4'"};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        make_svg("a.svg", sizes[i], DRAWING);
        struct image *image = image_read("a.svg");
        assert_int_equal(image->width, 8);
        assert_int_equal(image->height, 4);
        assert_int_equal(image->channels, 4);
        assert_sample(image, 0, 0, (int[]){255, 0, 0, 255});
        assert_sample(image, 3, 3, (int[]){255, 0, 0, 255});
        assert_sample(image, 4, 0, (int[]){0, 0, 0, 128});
        assert_sample(image, 7, 3, (int[]){0, 0, 0, 0});
        image_free(image);
    }
}

static void size_scales_a_drawing_in_proportion_and_centers_it(void **state)
{
    (void)state;
    make_svg("a.svg", "width='8' height='4'", DRAWING);
    struct image *image = image_read_sized("a.svg", 80, 80);
    assert_int_equal(image->width, 80);
    assert_int_equal(image->height, 80);
    assert_sample(image, 5, 19, (int[]){0, 0, 0, 0});
    assert_sample(image, 5, 20, (int[]){255, 0, 0, 255});
    assert_sample(image, 39, 59, (int[]){255, 0, 0, 255});
    assert_sample(image, 40, 31, (int[]){0, 0, 0, 0});
    assert_sample(image, 5, 60, (int[]){0, 0, 0, 0});
    image_free(image);
}

static void a_logo_in_svg_is_a_bevel_and_a_mask(void **state)
{
    (void)state;
    make_svg("a.svg", "width='40' height='40'", "<circle cx='20' cy='20' r='15'/>");
    const struct run *result = run("$GLINT render --height a.svg --bevel 5 --mask a.svg --size 80x80 -o a.ppm && "
                                   "$GLINT render --height - --bevel 5 --mask a.svg --size 80x80 -o b.ppm <a.svg");
    assert_int_equal(result->status, 0);
    assert_contains(result->err, "a.svg: its alpha is the mask");
    assert_same_file("a.ppm", "b.ppm");
    struct stat status;
    assert_int_equal(stat("a.ppm", &status), 0);
    assert_int_equal(status.st_size, 15 + 3 * 80 * 80 - 2); /* P6, 80 80, 255 */
}

static void what_cannot_be_drawn_is_one_line(void **state)
{
    (void)state;
    make_svg("broken.svg", "width='8' height='4'", "<g>");
    assert_fails("$GLINT render --height broken.svg -o no.png", "broken.svg: this is not an SVG that can be drawn");
    assert_fails("echo '<html></html>' | $GLINT render --height - -o no.png", "standard input: this is not an SVG");
    assert_fails("printf '<' | $GLINT render --height - -o no.png", "standard input: this is not an SVG");
    make_svg("huge.svg", "width='100000' height='4'", DRAWING);
    assert_fails("$GLINT render --height huge.svg -o no.png", "huge.svg: this SVG states 100000x4 pixels");
    make_svg("endless.svg", "", DRAWING);
    assert_fails("$GLINT render --height endless.svg -o no.png", "give --size WxH");
    assert_fails("$GLINT render --height endless.svg --size 250x240 --filter 64 -o no.png",
                 "endless.svg: drawn at 16000x15360 pixels");
    assert_fails("$GLINT bake --height endless.svg --size 16x16384 --filter 64 -o no.c",
                 "endless.svg: drawn at 1024x1048576 pixels");
    assert_false(exists("no.png"));
}

static void the_version_names_librsvg(void **state)
{
    (void)state;
    assert_contains(run("$GLINT --version")->out, svg_library());
}
#else
static void an_svg_is_refused_with_how_to_convert_it(void **state)
{
    (void)state;
    make_svg("a.svg", "width='8' height='4'", DRAWING);
    assert_fails("$GLINT render --height a.svg -o no.png", "rsvg-convert -o logo.png logo.svg");
    assert_contains(run("$GLINT --version")->out, "SVG");
    assert_false(exists("no.png"));
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
#if GLINT_WITH_SVG
        cmocka_unit_test(a_drawing_is_read_at_its_own_size_with_its_alpha),
        cmocka_unit_test(size_scales_a_drawing_in_proportion_and_centers_it),
        cmocka_unit_test(a_logo_in_svg_is_a_bevel_and_a_mask),
        cmocka_unit_test(what_cannot_be_drawn_is_one_line),
        cmocka_unit_test(the_version_names_librsvg),
#else
        cmocka_unit_test(an_svg_is_refused_with_how_to_convert_it),
#endif
    };
    return cmocka_run_group_tests_name("svg", tests, scratch_make, scratch_remove);
}
