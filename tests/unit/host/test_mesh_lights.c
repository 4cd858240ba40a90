/* SPDX-License-Identifier: MIT
 * Meshes under several lights, coloured ones, points and spots, and by Phong. */
#include "files.h"

#include "image/image.h"
#include "image/read.h"

#define TEAPOT "render --scene teapot --size 90x70 --turn 20,30,0 "

/* Of the picture beside the double render, in dB. */
static double quality_of(const char *options)
{
    char line[400];
    snprintf(line, sizeof line, "$GLINT %s --compare --json", options);
    const struct run *result = run(line);
    assert_int_equal(result->status, 0);
    const char *psnr = strstr(strstr(result->out, "\"unrounded\""), "\"psnr_db\": ");
    assert_non_null(psnr);
    return strtod(psnr + strlen("\"psnr_db\": "), NULL);
}

static void every_kind_of_light_and_phong_compare_well_with_doubles(void **state)
{
    (void)state;
    static const char *const options[] = {
        TEAPOT "--model phong",
        TEAPOT "--light=-1,1,1,.6,.2,.2 --light 1,1,1,.2,.2,.8",
        TEAPOT "--point 20,20,45,75,1,.8,.4",
        TEAPOT "--point 20,20,45,75,1,.8,.4 --perspective",
        TEAPOT "--spot 75,15,56,50,50,150,10,20",
        TEAPOT "--light 0,1,2,.2,.2,.2 --point 5,5,30,90 --point 60,60,60,90,.5,.5,1 --spot 30,70,40,32,32,99,20,30",
        TEAPOT "--model phong --point 20,20,45,75 --light 0,1,2,.2,.2,.2 --path exact-int8 --space linear",
        TEAPOT "--view .2,0,1 --point 20,20,45,75 --zoom 2"};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        if (quality_of(options[i]) < 42)
            fail_msg("%s: %.1f dB", options[i], quality_of(options[i]));
}

static void a_point_beyond_its_range_leaves_the_ambient_light(void **state)
{
    (void)state;
    assert_quiet("$GLINT " TEAPOT "--ambient .3 --point 1e5,1e5,1,2 -o a.ppm");
    assert_quiet("$GLINT " TEAPOT "--ambient .3 --diffuse 0 --specular 0 -o b.ppm");
    assert_same_file("a.ppm", "b.ppm");
}

static void a_spot_lights_the_side_of_the_mesh_that_it_is_aimed_at(void **state)
{
    (void)state;
    assert_quiet("$GLINT " TEAPOT "--ambient 0 --spot 30,45,200,30,45,400,3,5,0,1,0 -o spot.png");
    struct image *image = image_read("spot.png");
    assert_non_null(image);
    unsigned lit = 0;
    for (unsigned y = 0; y < image->height; y++)
        for (unsigned x = 0; x < image->width; x++) {
            const uint16_t *pixel = &image->samples[(y * image->width + x) * image->channels];
            assert_int_equal(pixel[0], 0); /* it is green */
            lit += pixel[1] > 0;
            if (pixel[1])
                assert_in_range(x, 10, 50);
        }
    assert_in_range(lit, 200, 1500);
    image_free(image);
}

static void a_point_is_brighter_where_the_mesh_is_nearer_to_it(void **state)
{
    (void)state;
    assert_quiet("$GLINT " TEAPOT "--ambient 0 --specular 0 --point 45,35,90,150 -o near.png");
    assert_quiet("$GLINT " TEAPOT "--ambient 0 --specular 0 --zoom .5 --point 45,35,90,150 -o far.png");
    struct image *near = image_read("near.png"), *far = image_read("far.png");
    const size_t middle = (35 * 90 + 45) * 3;
    assert_true(near->samples[middle] > far->samples[middle]);
    assert_true(far->samples[middle] > 0);
    image_free(near);
    image_free(far);
}

static void a_frame_of_a_stream_is_what_render_draws(void **state)
{
    (void)state;
#define LIGHTS "--scene teapot --size 60x60 --model phong --light 1,1,1,.4,.3,.2 --point 20,20,40,90 "
    assert_int_equal(run("$GLINT stream " LIGHTS "--frames 2 --fps 2 --period 4 --to ppm -o s%d.ppm")->status, 0);
    assert_quiet("$GLINT render " LIGHTS "-o r.ppm");
    assert_same_file("s0.ppm", "r.ppm");
    assert_false(same_file("s0.ppm", "s1.ppm"));
}

static void every_format_draws_a_mesh_under_several_lights(void **state)
{
    (void)state;
    static const char *const formats[] = {"rgb565", "rgb565-swapped", "bgr888", "grey8", "mono", "argb8888"};
    char line[300];
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        snprintf(line, sizeof line, TEAPOT "--format %s --dither --point 20,20,45,75 --light 0,1,2,.3,.3,.3",
                 formats[i]);
        assert_true(quality_of(line) > (i < 2 ? 30 : i == 4 ? 4 : 45));
    }
}

static void paths_by_tables_refuse_other_lights_and_phong(void **state)
{
    (void)state;
    static const char *const lines[][2] = {
        {"--path colour-int16 --point 1,2,3,4", "--path colour-int16: takes only one --light without a colour"},
        {"--path colour-int8 --light 1,1,1 --light 1,2,1", "other lights need --path exact or exact-int8"},
        {"--path colour-int8 --model phong", "--path colour-int8: cannot draw phong"}};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char line[300];
        snprintf(line, sizeof line, "$GLINT " TEAPOT "--format rgb565 %s -o no.ppm", lines[i][0]);
        assert_refused(line, lines[i][1]);
    }
    assert_false(exists("no.ppm"));
}

static void gouraud_has_the_meshs_grain_and_the_background(void **state)
{
    (void)state;
    static const char *const grains[] = {"brushed:0", "brushed:90", "axis:0,0,1"};
    for (int i = 0; i < 3; i++) {
        char line[300];
        snprintf(line, sizeof line, "render teapot --gouraud --split 10 -n 50 --across 10 --grain %s", grains[i]);
        assert_true(quality_of(line) > 45);
    }
    assert_quiet("$GLINT " TEAPOT "--gouraud --background 16,32,48 -o a.ppm");
    assert_string_equal(run("tail -c 18900 a.ppm | head -c 3 | od -An -tu1")->out, "  16  32  48\n");
}

#if GLINT_WITH_MESH
static void colours_of_vertices_and_materials_of_parts_are_lit_so_too(void **state)
{
    (void)state;
    write_text("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n2 0 0 0 255 0\n0 1 0 0 0 255\n"
               "3 0 1 2\n");
    write_text("a.mtl", "newmtl red\nKd 1 0 0\nNs 20\nnewmtl blue\nKd 0 0 1\nNs 90\n");
    write_text("a.obj",
               "mtllib a.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 2 4 3\n");
    static const char *const meshes[] = {"a.ply", "a.obj"};
    for (size_t i = 0; i < 2; i++) {
        char line[300];
        snprintf(line, sizeof line, "render --mesh %s --size 60x40 --point 30,20,20,60 --light 1,0,1,.3,.3,.3",
                 meshes[i]);
        assert_true(quality_of(line) > 50);
    }
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_of_light_and_phong_compare_well_with_doubles),
        cmocka_unit_test(a_point_beyond_its_range_leaves_the_ambient_light),
        cmocka_unit_test(a_spot_lights_the_side_of_the_mesh_that_it_is_aimed_at),
        cmocka_unit_test(a_point_is_brighter_where_the_mesh_is_nearer_to_it),
        cmocka_unit_test(a_frame_of_a_stream_is_what_render_draws),
        cmocka_unit_test(every_format_draws_a_mesh_under_several_lights),
        cmocka_unit_test(paths_by_tables_refuse_other_lights_and_phong),
        cmocka_unit_test(gouraud_has_the_meshs_grain_and_the_background),
#if GLINT_WITH_MESH
        cmocka_unit_test(colours_of_vertices_and_materials_of_parts_are_lit_so_too),
#endif
    };
    return cmocka_run_group_tests_name("meshes under lights", tests, scratch_make, scratch_remove);
}
