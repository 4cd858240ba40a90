/* SPDX-License-Identifier: MIT
 * What `glint render` writes, and its defaults. */
#include <math.h>
#include <pty.h>
#include <string.h>

#include "draw/paths.h"
#include "image/format.h"
#include "image/levels.h"
#include "image/read.h"
#include "files.h"

#include "image/image.h"
#include "draw/canvas.h"
#include "scene/scenes.h"

static void a_map_becomes_a_picture_of_its_size_and_nothing_is_said(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --height heights.png --albedo colors.png -o out/a.png");
    struct image *image = image_read("out/a.png");
    assert_int_equal(image->width, 12);
    assert_int_equal(image->height, 8);
    assert_int_equal(image->channels, 3);
    image_free(image);
}

static void every_kind_of_file_holds_the_same_picture(void **state)
{
    (void)state;
    static const char *const formats[] = {"rgb888", "rgb565", "rgb565-swapped", "grey8"};
    for (int f = 0; f < 4; f++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT render --scene coin --size 31x20 --format %s -o out/f.png", formats[f]);
        assert_quiet(line);
        snprintf(line, sizeof line, "$GLINT render --scene coin --size 31x20 --format %s -o out/f.ppm", formats[f]);
        assert_quiet(line);
        struct image *png = image_read("out/f.png");
        uint8_t ppm[4096];
        const size_t samples = 31 * 20 * png->channels;
        const size_t len = read_file("out/f.ppm", ppm, sizeof ppm);
        assert_int_equal(ppm[1], png->channels == 1 ? '5' : '6');
        assert_true(len > samples);
        for (size_t i = 0; i < samples; i++)
            assert_int_equal(png->samples[i], 257 * ppm[len - samples + i]);
        image_free(png);
    }
}

/* Rendered whole and in a stream; what has no alpha would show colours that nothing is blended with. */
static void argb8888_keeps_its_alpha_or_is_refused(void **state)
{
    (void)state;
    enum { SIDE = 64 };
    static const char *const pictures[] = {"out/a.png", "out/a0.png"};
    static const char *const without[] = {
        "ppm",
        "y4m"
#if GLINT_WITH_GIF
        ,
        "gif"
#endif
    };
    static uint8_t raw[4 * SIDE * SIDE + 1], qoi[4 * SIDE * SIDE + 1];
    assert_quiet("for to in 'png -o out/a.png' 'qoi -o out/a.qoi' 'raw -o out/a.raw'; do $GLINT render --scene coin "
                 "--size 64x64 --format argb8888 --cut-out --image $to || exit; done; "
                 "$GLINT stream coin --size 64x64 --format argb8888 --cut-out --frames 1 --to png -o out/a%d.png && "
                 "$GLINT stream coin --size 64x64 --format argb8888 --cut-out --frames 1 --to raw >out/a0.raw");
    for (size_t p = 0; p < 2; p++) {
        unsigned soft = 0;
        struct image *image = image_read(pictures[p]);
        assert_int_equal(read_file(p ? "out/a0.raw" : "out/a.raw", raw, sizeof raw), 4 * SIDE * SIDE);
        assert_int_equal(image->channels, 4);
        for (size_t i = 0; i < SIDE * SIDE; i++) {
            soft += raw[4 * i + 3] > 0 && raw[4 * i + 3] < 255;
            for (unsigned k = 0; k < 4; k++)
                assert_int_equal(image->samples[4 * i + k], 257 * raw[4 * i + (k < 3 ? 2 - k : 3)]);
        }
        assert_true(soft > 50);
        image_free(image);
    }
    assert_true(read_file("out/a.qoi", qoi, sizeof qoi) > 14);
    assert_int_equal(qoi[12], 4); /* channels; test_images_write has the rest */
    assert_refused("$GLINT render --scene coin --format argb8888 -o out/b.ppm", "a PPM file has no alpha");
    for (size_t i = 0; i < 2; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT %s --cut-out --format argb8888 --background 16,32,48 %s -o out/b.png",
                 i ? "stream coin" : "render --scene coin", i ? "--frames 1 --to png" : "");
        assert_refused(line, "--background: in --format argb8888 a scene's soft edges are alpha, not blended with it");
    }
    assert_quiet("$GLINT render --scene teapot --size 64x64 --format argb8888 --background 16,32,48 -o out/a.png");
    for (size_t i = 0; i < sizeof without / sizeof *without; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT stream coin --format argb8888 --frames 1 --fps 10 --to %s -o out/b.%s",
                 without[i], without[i]);
        assert_fails(line, "has no alpha; choose another format");
    }
    assert_quiet("! ls out/b.* 2>/dev/null");
}

static void mono_is_written_as_bits(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --scene sphere --size 40x40 --format mono --dither -o out/m.png");
    struct image *image = image_read("out/m.png");
    assert_int_equal(image->bits, 1);
    unsigned white = 0;
    for (int i = 0; i < 40 * 40; i++)
        white += image->samples[i] == 65535;
    assert_true(white > 100 && white < 1000);
    image_free(image);
}

/* The bytes of scene coin, 31 x 20, in a format. */
static size_t raw_coin(const char *format, uint8_t *bytes, size_t room)
{
    char line[400];
    snprintf(line, sizeof line,
             "$GLINT render --scene coin --size 31x20 --format %s --image raw -o out/raw && "
             "$GLINT render --scene coin --size 31x20 --format %s --image raw -o - >out/pipe && "
             "$GLINT render --scene coin --size 31x20 --format %s -o out/f.ppm",
             format, format, format);
    assert_quiet(line);
    assert_same_file("out/raw", "out/pipe");
    return read_file("out/raw", bytes, room);
}

static void raw_is_the_panels_lines_whose_levels_a_picture_has_to_the_nearest_of_255(void **state)
{
    (void)state;
    enum { PIXELS = 31 * 20 };
    static uint8_t raw[4 * PIXELS], swapped[4 * PIXELS], ppm[4 * PIXELS];
    assert_int_equal(raw_coin("rgb565", raw, sizeof raw), 2 * PIXELS);
    const uint8_t *samples = ppm + read_file("out/f.ppm", ppm, sizeof ppm) - 3 * PIXELS;
    for (int i = 0; i < PIXELS; i++) {
        const unsigned word = raw[2 * i] | (unsigned)raw[2 * i + 1] << 8;
        assert_int_equal(samples[3 * i], lround((word >> 11) * 255 / 31.));
        assert_int_equal(samples[3 * i + 1], lround((word >> 5 & 63) * 255 / 63.));
        assert_int_equal(samples[3 * i + 2], lround((word & 31) * 255 / 31.));
    }
    assert_int_equal(raw_coin("rgb565-swapped", swapped, sizeof swapped), 2 * PIXELS);
    for (int i = 0; i < 2 * PIXELS; i++)
        assert_int_equal(swapped[i], raw[i ^ 1]);
    assert_int_equal(raw_coin("rgb888", raw, sizeof raw), 3 * PIXELS);
    samples = ppm + read_file("out/f.ppm", ppm, sizeof ppm) - 3 * PIXELS;
    assert_memory_equal(raw, samples, 3 * PIXELS);
    assert_int_equal(raw_coin("mono", raw, sizeof raw), 4 * 20);
    assert_refused("$GLINT render --scene coin --image jpeg -o out/no", "png, ppm, qoi, raw");
    assert_fails("$GLINT render --scene coin --image raw -o - >/dev/full", "standard output: could not be written");
}

static void the_ending_or_the_option_decides_the_kind(void **state)
{
    (void)state;
    uint8_t head[16];
    assert_quiet("$GLINT render --scene sphere --size 8x8 -o out/k.QOI");
    read_file("out/k.QOI", head, sizeof head);
    assert_memory_equal(head, "qoif", 4);
    assert_quiet("$GLINT render --scene sphere --size 8x8 --image ppm -o out/k.dat");
    read_file("out/k.dat", head, sizeof head);
    assert_memory_equal(head, "P6\n8 8\n", 7);
    assert_quiet("$GLINT render --scene sphere --size 8x8 -o out/k");
    read_file("out/k", head, sizeof head);
    assert_memory_equal(head, "\x89PNG", 4);
    assert_refused("$GLINT render --scene sphere -o out/k.jpg", "k.jpg");
    assert_refused("$GLINT render --scene sphere --image bmp -o out/k.bmp", "png, ppm, qoi");
}

static void a_dash_is_standard_input_and_output(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --height heights.png -o out/named.png");
    assert_quiet("$GLINT render --height - -o - <heights.png >out/piped.png");
    assert_same_file("out/named.png", "out/piped.png");
    assert_fails("$GLINT render --height - -o out/x.png </dev/null", "standard input");
    assert_refused("$GLINT render --height - --albedo - -o out/x.png <heights.png", "standard input");
}

static void a_terminal_is_spared_the_picture(void **state)
{
    (void)state;
    int terminal;
    const pid_t child = forkpty(&terminal, NULL, NULL, NULL);
    assert_true(child >= 0);
    if (child == 0) {
        const char *program = getenv("GLINT");
        execl(program, program, "render", "--scene", "sphere", "-o", "-", (char *)NULL);
        _exit(99);
    }
    char text[4096] = "";
    size_t len = 0;
    for (ssize_t got; len < sizeof text - 1 && (got = read(terminal, text + len, sizeof text - 1 - len)) > 0;)
        len += (size_t)got;
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    close(terminal);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 2);
    assert_non_null(strstr(text, "terminal"));
    assert_null(strstr(text, "PNG"));
}

static void a_map_is_cut_or_repeated_to_the_size(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --height heights.png --wrap --albedo colors.png -o out/whole.png");
    assert_quiet("$GLINT render --height heights.png --albedo colors.png --size 30x5 -o out/sized.png");
    struct image *whole = image_read("out/whole.png"), *sized = image_read("out/sized.png");
    assert_int_equal(sized->width, 30);
    assert_int_equal(sized->height, 5);
    for (unsigned y = 0; y < 5; y++)
        for (unsigned x = 0; x < 30; x++)
            assert_memory_equal(&sized->samples[3 * (y * 30 + x)], &whole->samples[3 * (y * 12 + x % 12)], 6);
    image_free(whole);
    image_free(sized);
}

static void narrow_and_one_bit_maps_are_drawn(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --height line.png -o out/line.png");
    assert_quiet("$GLINT render --height bits.png --albedo bits.png -o out/bits.png");
    struct image *image = image_read("out/line.png");
    assert_int_equal(image->width, 1);
    assert_int_equal(image->height, 8);
    image_free(image);
}

static void a_coloured_height_map_is_drawn_with_a_warning(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT render --height colors.png -o out/c.png");
    assert_int_equal(result->status, 0);
    assert_contains(result->err, "colors.png: this map is in colour");
    assert_true(exists("out/c.png"));
}

static void q_follows_the_format_and_the_space(void **state)
{
    (void)state;
    static const struct {
        const char *options;
        int q;
    } defaults[] = {{"", 8},
                    {"--format rgb565", 6},
                    {"--format rgb565 --dither", 8},
                    {"--format grey8", 8},
                    {"--format mono", 6},
                    {"--space linear", 12},
                    {"--format rgb565 --space linear", 12}};
    for (size_t i = 0; i < sizeof defaults / sizeof *defaults; i++) {
        char line[200];
        for (int change = 0; change < 2; change++) {
            snprintf(line, sizeof line, "$GLINT render --scene sphere --size 64x64 --specular 1 %s -o out/q0.ppm",
                     defaults[i].options);
            assert_quiet(line);
            snprintf(line, sizeof line, "$GLINT render --scene sphere --size 64x64 --specular 1 %s -q %d -o out/q1.ppm",
                     defaults[i].options, change ? 2 : defaults[i].q);
            assert_quiet(line);
            if (change == 0)
                assert_same_file("out/q0.ppm", "out/q1.ppm");
            else if (strcmp(defaults[i].options, "--format mono") != 0) /* too coarse to show it */
                assert_false(same_file("out/q0.ppm", "out/q1.ppm"));
        }
    }
}

static void each_option_of_light_and_material_changes_the_picture(void **state)
{
    (void)state;
    static const char *const options[] = {"--model schlick", "--model blinn", "--model phong",    "--model gauss",
                                          "--model cayley",  "-n 10",         "--light 1,1,1",    "--view 1,0,1",
                                          "--ambient 0",     "--diffuse .1",  "--specular 1,0,0", "--color 1,2,3",
                                          "--dither",        "--space linear"};
    assert_quiet("$GLINT render --scene sphere --size 64x64 -o out/base.ppm");
    for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT render --scene sphere --size 64x64 %s -o out/other.ppm", options[i]);
        assert_quiet(line);
        if (same_file("out/base.ppm", "out/other.ppm"))
            fail_msg("%s changed nothing", options[i]);
    }
    assert_quiet("$GLINT render --scene sphere --size 64x64 --path exact --model msh -n 60 -q 8 --space gamma "
                 "--format rgb888 --light -1,1,1 --view 0,0,1 -o out/other.ppm");
    assert_same_file("out/base.ppm", "out/other.ppm");
}

static void help_explains_every_option_and_fits_a_terminal(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT render --help");
    assert_int_equal(result->status, 0);
    static const char *const options[] = {
        "--height",     "--normals", "--scene",     "--albedo",  "--color",   "--gloss",   "--mask",
        "--scale",      "--wrap",    "--flip-y",    "--size",    "--model",   "-n N",      "-q Q",
        "--light",      "--view",    "--point",     "--spot",    "--ambient", "--diffuse", "--specular",
        "--clamp-peak", "-o FILE",   "--image",     "--format",  "--space",   "--dither",  "--path",
        "--compare",    "--json",    "--error-map", "--against", "Examples:"};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        assert_contains(result->out, options[i]);
    for (size_t i = 0; format_names[i]; i++)
        assert_contains(result->out, format_names[i]);
    for (const char *line = result->out; *line;) {
        const size_t length = strcspn(line, "\n");
        assert_true(length < 80);
        line += length + (line[length] == '\n');
    }
}

static void a_path_leaves_what_is_not_of_full_gloss_to_the_exact_one(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT render --height heights.png --gloss heights.png --format rgb565 --path palette -o out/path.ppm");
    assert_int_equal(result->status, 0);
    assert_contains(result->err,
                    "full gloss, 1 of 96 pixels; the exact path drew the rest"); /* of 96 greys one is white */
}

static void each_path_draws_the_sphere_within_its_error(void **state)
{
    (void)state;
    for (unsigned path = 1; path_names[path]; path++) {
        struct shading shading = {.model = GLINT_MSH,
                                  .n = 60,
                                  .q = 8,
                                  .lamps = {{.direction = {-1, 1, 1}, .color = {1, 1, 1}}},
                                  .lamp_count = 1,
                                  .view = {0, 0, 1},
                                  .ambient = {.15, .15, .15},
                                  .diffuse = {.85, .85, .85},
                                  .specular = {.8, .8, .8},
                                  .format = GLINT_RGB565};
        struct scene *scene = scene_draw("sphere", 96, 96);
        struct levels *exact = shade_scene(scene, &shading);
        shading.path = path;
        assert_null(path_refusal(&shading));
        struct levels *levels = shade_scene(scene, &shading);
        unsigned differ = 0;
        for (size_t p = 0; p < 3 * 96 * 96; p++) {
            const int difference = exact->values[p] - levels->values[p];
            /* in steps of 31 or 63; a curve cut into spans of 16 pixels of so small a ball differs by itself */
            assert_in_range(abs(difference), 0, strstr(path_names[path], "span") ? 4 : 2);
            differ += difference != 0;
        }
        assert_in_range(differ, 1, 96 * 96 * 3 / 2); /* it is another path, and a near one */
        levels_free(exact);
        levels_free(levels);
        scene_free(scene);
    }
}

/* With the coin's albedo, gloss and mask, in alpha, too, under lights of each kind. */
static void exact_from_8_bits_is_exact_over_the_normals_as_they_are_held(void **state)
{
    (void)state;
    enum { SIDE = 64 };
    struct shading shading = {.model = GLINT_PHONG,
                              .n = 60,
                              .q = 8,
                              .lamps = {{.direction = {-1, 1, 1}, .color = {1, .5, 2}},
                                        {.kind = LAMP_POINT, .position = {9, 50, 30}, .range = 90, .color = {1, 1, 1}}},
                              .lamp_count = 2,
                              .view = {.25, 0, 1},
                              .ambient = {.15, .15, .15},
                              .diffuse = {.85, .85, .85},
                              .specular = {.8, .8, .8},
                              .format = GLINT_ARGB8888};
    struct scene *scene = scene_draw("coin", SIDE, SIDE);
    if (!scene->mask)
        scene->mask = malloc(SIDE * SIDE);
    for (int i = 0; i < SIDE * SIDE; i++)
        scene->mask[i] = (uint8_t)(i / 7);
    while (strcmp(path_names[shading.path], "exact-int8") != 0)
        shading.path++;
    uint8_t *found = shade_pixels(scene, &shading);
    struct glint_vec *normals = scene_normals_q15(scene);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const struct glint_vec n =
            glint_normals_unpack(GLINT_NORMALS_INT8, glint_normals_pack(GLINT_NORMALS_INT8, &normals[i]));
        scene->normals[i][0] = n.x / 32768.;
        scene->normals[i][1] = n.y / 32768.;
        scene->normals[i][2] = n.z / 32768.;
    }
    shading.path = 0;
    uint8_t *wanted = shade_pixels(scene, &shading);
    assert_memory_equal(found, wanted, 4 * SIDE * SIDE);
    free(found);
    free(wanted);
    free(normals);
    scene_free(scene);
}

static void an_albedo_path_says_which_light_it_wants(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT render --scene sphere --path albedo-int8 --format rgb565 --diffuse .9,.8,.7 -o out/albedo.png");
    assert_int_equal(result->status, 1);
    assert_contains(result->err, "--path albedo-int8: needs a grey --ambient and --diffuse of at most 1 together");
    assert_int_equal(strcspn(result->err, "\n") + 1, strlen(result->err));
}

static void more_threads_than_a_stack_has_room_for_draw_the_same(void **state)
{
    (void)state;
    assert_quiet("$GLINT render --scene coin --size 99x99 -o out/few.ppm && "
                 "OMP_NUM_THREADS=1000000 $GLINT render --scene coin --size 99x99 -o out/many.ppm");
    assert_same_file("out/few.ppm", "out/many.ppm");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_map_becomes_a_picture_of_its_size_and_nothing_is_said),
        cmocka_unit_test(every_kind_of_file_holds_the_same_picture),
        cmocka_unit_test(argb8888_keeps_its_alpha_or_is_refused),
        cmocka_unit_test(mono_is_written_as_bits),
        cmocka_unit_test(raw_is_the_panels_lines_whose_levels_a_picture_has_to_the_nearest_of_255),
        cmocka_unit_test(the_ending_or_the_option_decides_the_kind),
        cmocka_unit_test(a_dash_is_standard_input_and_output),
        cmocka_unit_test(a_terminal_is_spared_the_picture),
        cmocka_unit_test(a_map_is_cut_or_repeated_to_the_size),
        cmocka_unit_test(narrow_and_one_bit_maps_are_drawn),
        cmocka_unit_test(a_coloured_height_map_is_drawn_with_a_warning),
        cmocka_unit_test(q_follows_the_format_and_the_space),
        cmocka_unit_test(each_option_of_light_and_material_changes_the_picture),
        cmocka_unit_test(help_explains_every_option_and_fits_a_terminal),
        cmocka_unit_test(a_path_leaves_what_is_not_of_full_gloss_to_the_exact_one),
        cmocka_unit_test(each_path_draws_the_sphere_within_its_error),
        cmocka_unit_test(exact_from_8_bits_is_exact_over_the_normals_as_they_are_held),
        cmocka_unit_test(an_albedo_path_says_which_light_it_wants),
        cmocka_unit_test(more_threads_than_a_stack_has_room_for_draw_the_same),
    };
    return cmocka_run_group_tests_name("render", tests, make_maps, scratch_remove);
}
