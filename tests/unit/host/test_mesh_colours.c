/* SPDX-License-Identifier: MIT
 * Colours of a mesh's vertices, from the file to the pixels. */
#include "files.h"
#include "solids.h"

#include "mesh/import.h"
#include "mesh/order.h"
#include "mesh/polygon.h"
#include "mesh/split.h"
#include "mesh/weld.h"

/* Each corner in a colour of its place, or all in one. */
static struct soup *coloured_cube(bool by_place)
{
    struct soup *soup = soup_cube();
    soup->has_colors = true;
    for (size_t i = 0; i < 9 * soup->face_count; i++)
        soup->faces[i / 9].colors[i / 3 % 3][i % 3] =
            (uint8_t)(by_place ? 100 + 100 * soup->faces[i / 9].places[i / 3 % 3][i % 3] : 7);
    return soup;
}

static void corners_of_different_colours_stay_apart(void **state)
{
    (void)state;
    struct soup *soup = coloured_cube(true);
    struct mesh *mesh = mesh_weld(soup, 180);
    assert_int_equal(mesh->vertex_count, 8);
    for (size_t i = 0; i < 24; i++)
        assert_int_equal(mesh->colors[i / 3][i % 3], 100 + 100 * mesh->places[i / 3][i % 3]);
    mesh_free(mesh);
    soup->faces[0].colors[1][2] ^= 1;
    mesh = mesh_weld(soup, 180);
    assert_int_equal(mesh->vertex_count, 9);
    assert_int_equal(mesh->place_count, 8);
    assert_closed(mesh);
    mesh_free(mesh);
    soup_free(soup);
    soup = soup_cube();
    mesh = mesh_weld(soup, 180);
    assert_null(mesh->colors);
    mesh_free(mesh);
    soup_free(soup);
}

static void a_split_edges_middle_has_the_mean_of_its_ends_and_ordering_keeps_colours(void **state)
{
    (void)state;
    struct soup *soup = coloured_cube(true);
    struct mesh *mesh = mesh_weld(soup, 180);
    mesh_split(mesh, 60);
    mesh_order(mesh);
    assert_true(mesh->vertex_count > 8);
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++) /* linear over the cube, but for roundings */
        assert_near(mesh->colors[i / 3][i % 3], 100 + 100 * mesh->places[i / 3][i % 3], 1.01);
    mesh_free(mesh);
    soup_free(soup);
    soup = coloured_cube(false);
    mesh = mesh_weld(soup, 180);
    mesh_split(mesh, 40);
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++)
        assert_int_equal(mesh->colors[i / 3][i % 3], 7);
    mesh_free(mesh);
    soup_free(soup);
}

/* Stars with many dents, turned any way: no triangle turns the other way, and all of them have the polygon's area. */
static void polygons_with_dents_are_cut_into_triangles_that_cover_them(void **state)
{
    (void)state;
    enum { CORNERS = 23 };
    unsigned seed = 9;
    for (unsigned round = 0; round < 300; round++) {
        double places[CORNERS][3], area[3] = {0}, sum[3] = {0};
        size_t triangles[CORNERS - 2][3];
        const size_t count = 3 + round % (CORNERS - 2);
        const int axis = (int)(round % 3), sense = round / 3 % 2 ? 1 : -1;
        for (size_t i = 0; i < count; i++) {
            seed = seed * 1664525 + 1013904223;
            const double radius = .3 + (seed >> 16) / 65536., angle = 2 * M_PI * (double)i / (double)count;
            places[i][axis] = .1 * radius * cos(angle);
            places[i][(axis + 1) % 3] = radius * cos(angle);
            places[i][(axis + 2) % 3] = sense * radius * sin(angle);
        }
        polygon_cut((const double(*)[3])places, count, triangles);
        for (size_t i = 0; i < count; i++) {
            double part[3];
            mesh_cross(places[i], places[(i + 1) % count], part);
            for (int k = 0; k < 3; k++)
                area[k] += part[k];
        }
        for (size_t i = 0; i < count - 2; i++) {
            double part[3];
            mesh_face_normal(places[triangles[i][0]], places[triangles[i][1]], places[triangles[i][2]], part);
            assert_true(mesh_dot(part, area) >= 0);
            for (int k = 0; k < 3; k++)
                sum[k] += part[k];
        }
        for (int k = 0; k < 3; k++)
            assert_near(sum[k], area[k], 1e-9);
    }
}

static void no_triangle_is_cut_through_a_dent_that_lies_on_its_side(void **state)
{
    (void)state;
    static const double places[5][3] = {{2, 0, 0}, {0, 1, 0}, {-2, 2, 0}, {0, 0, 0}, {0, -1, 0}};
    size_t triangles[3][3];
    double area = 0;
    assert_true(polygon_cut(places, 5, triangles));
    for (size_t i = 0; i < 3; i++) {
        double part[3];
        mesh_face_normal(places[triangles[i][0]], places[triangles[i][1]], places[triangles[i][2]], part);
        area += fabs(part[2]);
    }
    double sum = 0;
    for (size_t i = 0; i < 5; i++)
        sum += places[i][0] * places[(i + 1) % 5][1] - places[(i + 1) % 5][0] * places[i][1];
    assert_near(area, fabs(sum), 1e-9);
}

#if GLINT_WITH_MESH
#define GLTF(attributes, material, accessors)                                                                          \
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"              \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0" attributes "}" material "}]}],"                     \
    "\"buffers\":[{\"byteLength\":72,\"uri\":\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAQAAAAAAAAAAA"  \
    "AAAAAAAAgD8AAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/\"}],"                                            \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":36}],"           \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],"           \
    "\"max\":[2,1,0]}" accessors "]}"
#define COLOURED                                                                                                       \
    GLTF(",\"COLOR_0\":1", ",\"material\":0",                                                                          \
         ",{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}")

/* A triangle, red at 0, 0, green at 2, 0, blue at 0, 1. */
static int make_triangles(void **state)
{
    if (scratch_make(state) != 0)
        return -1;
    write_text("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n2 0 0 0 255 0\n0 1 0 0 0 255\n"
               "3 0 1 2\n");
    write_text("a.obj", "v 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
    write_text("a.gltf", COLOURED);
    return run("sed "
               "'s/\"nodes\":.{\"mesh\"/\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1,1]}}],&/' "
               "a.gltf >b.gltf && sed 's/\\[1,1,1,1\\]/[0.5,0.5,0.5,1]/' b.gltf >half.gltf && mv b.gltf a.gltf")
        ->status;
}

static void colours_of_a_ply_an_obj_and_a_gltf_are_drawn_and_streamed_alike(void **state)
{
    (void)state;
    const struct run *result =
        run("for f in ply obj gltf; do $GLINT render --mesh a.$f --size 60x40 -o $f.ppm || exit 1; done; "
            "$GLINT stream --mesh a.ply --size 60x40 --frames 1 --to ppm -o stream.ppm && "
            "$GLINT render --mesh a.ply --size 60x40 --color 255,0,0 -o red.ppm");
    assert_string_equal(result->err, "");
    assert_int_equal(result->status, 0);
    assert_same_file("ply.ppm", "obj.ppm");
    assert_same_file("ply.ppm", "gltf.ppm");
    assert_same_file("ply.ppm", "stream.ppm");
    assert_false(same_file("ply.ppm", "red.ppm"));
}

/* Linear there, as the vertices' are. */
static void a_gltfs_base_colour_is_times_its_vertices(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT bake --mesh half.gltf --as c -o - 2>report | grep -A 1 baked_colors");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "188, 0, 0, ");
    assert_contains(run("cat report")->out, "3 vertices with colours, 1 triangle");
}

static void colours_are_near_double_precision_by_every_path_that_takes_them(void **state)
{
    (void)state;
    static const struct {
        const char *options;
        double least; /* dB */
    } lines[] = {{"--format rgb888", 48},
                 {"--format rgb888 --perspective --turn 10,50,0", 39}, /* linear on the screen, there in space */
                 {"--format grey8 --space linear", 46},
                 {"--format argb8888", 48},
                 {"--format rgb888 --path exact-int8", 45},
                 {"--format rgb565 --path albedo-int16 --ambient .1 --diffuse .9", 34},
                 {"--format rgb565-swapped --path albedo-int8 --ambient .1 --diffuse .9", 34}};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char line[300];
        double psnr = 0;
        snprintf(line, sizeof line,
                 "$GLINT render --mesh a.ply --size 120x80 %s --json | grep -m 1 psnr_db | tr -dc 0-9.",
                 lines[i].options);
        const struct run *result = run(line);
        if (sscanf(result->out, "%lf", &psnr) != 1 || psnr < lines[i].least)
            fail_msg("%s: '%s' dB; %s", lines[i].options, result->out, result->err);
    }
    assert_contains(run("$GLINT render --mesh a.ply --size 120x80 --gouraud --compare")->out, "msh in double");
}

static void paths_of_one_colour_refuse_them_unless_one_is_given(void **state)
{
    (void)state;
    assert_fails("$GLINT render --mesh a.ply --format rgb565 --path colour-int8 -o no.png",
                 "--path colour-int8: holds one colour, and the mesh has more; choose exact, albedo-int16 or "
                 "albedo-int8, or give one by --color");
    assert_fails("$GLINT stream --mesh a.ply --path colour-int16 --format rgb565 --to none --frames 1",
                 "holds one colour");
    assert_fails("$GLINT render --mesh a.ply --format rgb565 --path albedo-int8 --ambient .9 --diffuse .9 -o no.png",
                 "needs a grey --ambient and --diffuse of at most 1 together");
    assert_refused("$GLINT render --mesh a.ply --path albedo-int8 -o no.png", "needs --format rgb565");
    assert_refused("$GLINT render --mesh a.ply --color 9,9,9 --format rgb565 --path albedo-int8 -o no.png",
                   "is for textures and colours of vertices");
    write_text("plain.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_fails("$GLINT render --mesh plain.obj --format rgb565 --path albedo-int8 -o no.png",
                 "is for textures and colours of vertices, which this mesh has not; choose exact");
    assert_false(exists("no.png"));
    assert_int_equal(
        run("$GLINT render --mesh a.ply --color 9,9,9 --format rgb565 --path colour-int8 -o one.png")->status, 0);
}

static void raw_has_the_colours_behind_the_materials(void **state)
{
    (void)state;
    enum { VERTICES = 3, BEFORE = 8 + 9 * VERTICES + 1 + 6 + 6 + 6 };
    uint8_t bytes[BEFORE + 3 * VERTICES], colors[3] = {0};
    assert_int_equal(run("$GLINT bake --mesh a.ply --to int8 -o a.bin")->status, 0);
    struct stat status;
    assert_int_equal(stat("a.bin", &status), 0);
    assert_int_equal(status.st_size, sizeof bytes);
    assert_int_equal(read_file("a.bin", bytes, sizeof bytes), sizeof bytes);
    assert_int_equal(bytes[6] | bytes[7] << 8, 512 + 256 + 1);
    for (int i = 0; i < 9; i++)
        colors[i % 3] = (uint8_t)(colors[i % 3] + bytes[BEFORE + i]);
    assert_memory_equal(colors, ((uint8_t[]){255, 255, 255}), 3);
}

/* libassimp gives 5 bits of a colour as others. */
/* libassimp calls it white, which is overexposed. */
static void a_mesh_whose_file_tells_no_colour_has_the_usual_one(void **state)
{
    (void)state;
    write_text("plain.stl", "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0 1\n"
                            "endloop\nendfacet\nendsolid a\n");
    write_text("plain.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                            "0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n");
    assert_quiet("for f in stl ply; do $GLINT render --mesh plain.$f --size 40x30 -o own.ppm && "
                 "$GLINT render --mesh plain.$f --size 40x30 --color 200,200,200 -o usual.ppm && "
                 "cmp own.ppm usual.ppm && $GLINT bake --mesh plain.$f --as c -o - 2>/dev/null | "
                 "grep -q '{200, 200, 200}' || exit 1; done");
}

static void an_stls_colours_are_ignored_with_a_word(void **state)
{
    (void)state;
    const float facet[12] = {0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
    const uint32_t one = 1;
    FILE *stl = fopen("a.stl", "wb");
    assert_non_null(stl);
    assert_true(fprintf(stl, "%-80s", "binary") == 80 && fwrite(&one, 4, 1, stl) == 1);
    assert_true(fwrite(facet, sizeof facet, 1, stl) == 1 && fwrite("\x1f\x80", 2, 1, stl) == 1);
    assert_int_equal(fclose(stl), 0);
    const struct run *result = run("$GLINT bake --mesh a.stl -o stl.c");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "a.stl: an STL's colours are ignored: each part has one colour");
}

static void colours_that_are_no_numbers_are_black_and_others_are_held(void **state)
{
    (void)state;
    write_text("odd.obj", "v 0 0 0 nan -3 1e30\nv 2 0 0 nan -3 1e30\nv 0 1 0 nan -3 1e30\nf 1 2 3\n");
    const struct run *result = run("$GLINT bake --mesh odd.obj --as c -o - 2>report | grep -A 1 baked_colors");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "0, 0, 255, 0, 0, 255, 0, 0, 255");
}

/* Ks is a hue: how strong a highlight is the command says. Black, and grey, is what programs write that know of none. */
static void an_objs_highlight_has_its_hue(void **state)
{
    (void)state;
    static const char *const cases[][2] = {{"Ks 1 .9 .6\n", "{32768, 29491, 19661}"},
                                           {"Ks .5 .45 .3\n", "{32768, 29491, 19661}"},
                                           {"Ks 0 0 0\n", "{32768, 32768, 32768}"},
                                           {"Ks .5 .5 .5\n", "{32768, 32768, 32768}"},
                                           {"", "{32768, 32768, 32768}"}};
    write_text("hue.obj", "mtllib hue.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[100];
        snprintf(text, sizeof text, "newmtl a\nNs 80\n%s", cases[i][0]);
        write_text("hue.mtl", text);
        const struct run *result = run("$GLINT bake --mesh hue.obj --as c -o - 2>report");
        assert_int_equal(result->status, 0);
        assert_contains(result->out, "{GLINT_MSH, 0, 80, 0, ");
        assert_contains(result->out, cases[i][1]);
        assert_quiet("$GLINT render --mesh hue.obj --size 40x40 -o hue.ppm; "
                     "$GLINT render --mesh hue.obj --specular .5 --size 40x40 -o grey.ppm");
        assert_int_equal(same_file("hue.ppm", "grey.ppm"), i >= 2);
    }
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_of_different_colours_stay_apart),
        cmocka_unit_test(polygons_with_dents_are_cut_into_triangles_that_cover_them),
        cmocka_unit_test(no_triangle_is_cut_through_a_dent_that_lies_on_its_side),
        cmocka_unit_test(a_split_edges_middle_has_the_mean_of_its_ends_and_ordering_keeps_colours),
#if GLINT_WITH_MESH
        cmocka_unit_test(colours_of_a_ply_an_obj_and_a_gltf_are_drawn_and_streamed_alike),
        cmocka_unit_test(a_gltfs_base_colour_is_times_its_vertices),
        cmocka_unit_test(colours_are_near_double_precision_by_every_path_that_takes_them),
        cmocka_unit_test(paths_of_one_colour_refuse_them_unless_one_is_given),
        cmocka_unit_test(raw_has_the_colours_behind_the_materials),
        cmocka_unit_test(a_mesh_whose_file_tells_no_colour_has_the_usual_one),
        cmocka_unit_test(an_stls_colours_are_ignored_with_a_word),
        cmocka_unit_test(colours_that_are_no_numbers_are_black_and_others_are_held),
        cmocka_unit_test(an_objs_highlight_has_its_hue),
#endif
    };
#if GLINT_WITH_MESH
    return cmocka_run_group_tests_name("mesh colours", tests, make_triangles, scratch_remove);
#else
    return cmocka_run_group_tests_name("mesh colours", tests, scratch_make, scratch_remove);
#endif
}
