/* SPDX-License-Identifier: MIT
 * glint with meshes from files: what is read and what is refused. */
#include <malloc.h>
#include <math.h>

#include "files.h"

#include "mesh/import.h"
#include "mesh/obj_materials.h"

static void the_teapot_is_drawn_baked_and_streamed_without_a_file(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT render --scene teapot --size 120x90 --compare -o a.ppm && "
                                   "$GLINT stream teapot --size 120x90 --frames 1 --to ppm -o b.ppm && "
                                   "$GLINT stream teapot --size 120x90 --period 2 --fps 4 --to ppm -o c%d.ppm");
    assert_int_equal(result->status, 0);
    assert_string_equal(result->err, "");
    assert_contains(result->out, "msh in double, rounded");
    assert_contains(result->out, "pixels; ");
    assert_same_file("a.ppm", "b.ppm");
    assert_same_file("a.ppm", "c0.ppm");
    assert_false(same_file("c0.ppm", "c1.ppm"));
    assert_true(exists("c7.ppm") && !exists("c8.ppm")); /* one turn */
    assert_int_equal(run("$GLINT render --scene teapot --size 120x90 --turn 25,60,0 -o d.ppm")->status, 0);
    assert_same_file("c2.ppm", "d.ppm"); /* a quarter */
}

static void every_path_that_draws_meshes_is_near_double_precision(void **state)
{
    (void)state;
    static const char *const lines[] = {"--format rgb888",
                                        "--format mono --dither",
                                        "--format grey8 --space linear",
                                        "--format rgb565 --path colour-int16",
                                        "--format rgb565-swapped --path colour-int8 --dither",
                                        "--path exact-int8",
                                        "--format grey8 --path exact-int8",
                                        "--perspective --model schlick -n 20",
                                        "--perspective=2 --zoom .7 --model gauss"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char line[300];
        double psnr = 0;
        snprintf(line, sizeof line,
                 "$GLINT render --scene teapot --size 96x96 %s --json | grep -m 1 psnr_db | tr -dc 0-9.", lines[i]);
        const struct run *result = run(line);
        if (sscanf(result->out, "%lf", &psnr) != 1 || psnr < (strstr(lines[i], "mono") ? 15 : 36))
            fail_msg("%s: '%s' dB; %s", lines[i], result->out, result->err);
    }
}

static void options_that_do_not_fit_a_mesh_are_refused(void **state)
{
    (void)state;
    static const char *const lines[][2] = {
        {"render --scene coin --turn 1,2,3 -o a.png", "need a mesh"},
        {"render --scene coin --split 3 -o a.png", "--split needs --mesh"},
        {"render --scene teapot --mesh a.obj -o a.png", "give only one of"},
        {"render --mesh a.obj --scene teapot -o a.png", "give only one of"},
        {"render --scene coin --gouraud -o a.png", "--gouraud needs a mesh"},
        {"render --scene teapot --gouraud --image raw -o a", "cannot be used with --gouraud"},
        {"render --scene teapot --gouraud --format argb8888 -o a.png",
         "--gouraud draws no alpha; choose another --format than argb8888"},
        {"render --scene teapot --gloss a.png -o a.png", "--gloss is for maps"},
        {"render --mesh - --height - -o a.png", "give only one of"},
        {"stream --mesh - --lights - --to none", "only one of --lights, the maps and the mesh can come"},
        {"render --scene teapot --path span -o a.png", "--path span: cannot draw a mesh; choose"},
        {"render --scene teapot --axes z-up -o a.png", "--axes is for a mesh's file"},
        {"bake --scene teapot --to palette", "--to palette is for maps"},
        {"bake --scene teapot --size 9x9", "--size is for maps"},
        {"bake --scene coin --unit 3", "--unit needs --mesh"}};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char line[300];
        snprintf(line, sizeof line, "$GLINT %s", lines[i][0]);
        assert_refused(line, lines[i][1]);
    }
    assert_fails("$GLINT render --scene teapot --size 3000x3000 -o a.png", "give a smaller --size");
    assert_fails("$GLINT render --scene teapot --zoom 100 -o a.png", "give a smaller --zoom");
    assert_fails("$GLINT render --scene teapot --size 2000x2000 --perspective=50 -o a.png", "smaller --perspective");
    assert_false(exists("a.png"));
}

#if GLINT_WITH_MESH
#define CUBE                                                                                                           \
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\nvt 0 0\n"                     \
    "usemtl red\nf 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nusemtl blue\nf 3/1 7/1 8/1 4/1\nf 1 3 4 2\nf 5 6 8 7\n"

static void an_obj_has_its_materials(void **state)
{
    (void)state;
    write_text("cube.obj", "mtllib cube.mtl\n" CUBE);
    write_text("cube.mtl", "newmtl red\nKd 1 0 0\nNs 90\nillum 2\nnewmtl blue\nKd 0 0 1\nillum 0\n");
    const struct run *result = run("$GLINT bake --mesh cube.obj -o cube.c && tail -8 cube.c && grep PARTS cube.h");
    assert_int_equal(result->status, 0);
    assert_string_equal(result->err, "");
    assert_contains(result->out, "24 vertices, 12 triangles, 2 parts");
    assert_contains(result->out, "{GLINT_MSH, 0, 90, 0, {13107, 13107, 13107}, {58982, 58982, 58982}, {32768, 32768, "
                                 "32768}, {255, 0, 0}, false},");
    assert_contains(result->out, "{65536, 65536, 65536}, {0, 0, 0}, {0, 0, 0}, {0, 0, 255}, false}"); /* unlit */
    assert_contains(result->out, "#define CUBE_PARTS 2");
    /* Straight at its front, the unlit one. */
    assert_int_equal(run("$GLINT render --mesh cube.obj --size 9x9 -o cube.ppm")->status, 0);
    uint8_t bytes[11 + 243];
    assert_int_equal(read_file("cube.ppm", bytes, sizeof bytes), sizeof bytes);
    assert_memory_equal(&bytes[11 + 3 * 40], ((uint8_t[]){0, 0, 255}), 3);
    assert_contains(run("$GLINT render --mesh cube.obj --size 99x99 --turn 20,70,0 --compare")->out,
                    "rounded          no difference");
}

/* The same pyramid as STL, with z up, and as PLY and glTF. */
static void stl_ply_and_gltf_are_read_and_axes_turn_what_is_up(void **state)
{
    (void)state;
    write_text("a.stl", "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0 1\nendloop\n"
                        "endfacet\nendsolid a\n");
    write_text("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n");
    write_text(
        "a.gltf",
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"buffers\":[{\"byteLength\":36,\"uri\":"
        "\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAQAAAAAAAAAAAAAAAAAAAgD8AAAAA\"}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
        "\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[2,1,0]}]}");
    const struct run *result = run(
        "for f in stl ply gltf; do $GLINT render --mesh a.$f --color 9,99,199 --size 40x30 -o $f.ppm || exit 1; done; "
        "$GLINT render --mesh a.ply --axes z-up --turn 90,0,0 --color 9,99,199 --size 40x30 -o z.ppm && "
        "$GLINT render --mesh a.ply --axes z-up --color 9,99,199 --size 40x30 -o y.ppm");
    assert_string_equal(result->err, "");
    assert_int_equal(result->status, 0);
    assert_same_file("stl.ppm", "ply.ppm");
    assert_same_file("stl.ppm", "gltf.ppm");
    assert_same_file("stl.ppm", "z.ppm");
    assert_false(same_file("stl.ppm", "y.ppm"));
}

static void write_bytes(FILE *file, const void *bytes, size_t len)
{
    assert_int_equal(fwrite(bytes, 1, len, file), len);
}

/* The pyramid again: a binary STL whose comment begins as a text STL does, and a.gltf in a binary glTF. */
static void write_binary_meshes(void)
{
    char *text = whole_file("a.gltf"), *uri = strstr(text, ",\"uri\""), *rest = strstr(text, "}],\"bufferViews\"");
    assert_true(uri && rest);
    memmove(uri, rest, strlen(rest) + 1);
    const uint32_t len = (uint32_t)strlen(text), whole = (len + 3) / 4 * 4, one = 1;
    const uint32_t head[] = {0x46546c67, 2, 28 + whole + 36, whole, 0x4e4f534a}; /* "glTF", "JSON" */
    const uint32_t part[] = {36, 0x004e4942};                                    /* "BIN" */
    const float places[9] = {0, 0, 0, 2, 0, 0, 0, 1, 0};
    const float facet[12] = {0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
    FILE *glb = fopen("a.glb", "wb"), *stl = fopen("b.stl", "wb");
    assert_true(glb && stl);
    write_bytes(glb, head, sizeof head);
    write_bytes(glb, text, len);
    write_bytes(glb, "   ", whole - len);
    write_bytes(glb, part, sizeof part);
    write_bytes(glb, places, sizeof places);
    assert_true(fprintf(stl, "%-80s", "solid b") == 80);
    write_bytes(stl, &one, sizeof one);
    write_bytes(stl, facet, sizeof facet);
    write_bytes(stl, "\0", 2);
    assert_int_equal(fclose(glb) | fclose(stl), 0);
    free(text);
}

static void standard_input_is_known_by_its_bytes_and_read_as_a_file_is(void **state)
{
    (void)state;
    write_binary_meshes();
    write_text("b.obj", "\n# a comment\nv 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
    const struct run *result =
        run("tr '\\n' '\\r' <b.obj >c.obj; { printf %-80s a; tail -c +81 b.stl; printf xyz; } >c.stl; for f in a.stl "
            "b.stl c.stl a.ply a.gltf "
            "a.glb b.obj c.obj; do "
            "$GLINT render --mesh $f --turn 9,0,0 --color 9,99,199 --size 40x30 -o file.ppm && "
            "$GLINT render --mesh - --turn 9,0,0 --color 9,99,199 --size 40x30 -o input.ppm <$f && "
            "cmp file.ppm input.ppm || exit 1; "
            "[ $f = a.stl ] || cmp file.ppm first.ppm || exit 1; cp file.ppm first.ppm; done");
    assert_string_equal(result->err, "");
    assert_string_equal(result->out, "");
    assert_int_equal(result->status, 0);
    result = run("cat a.ply | $GLINT bake --mesh - -o - 2>report && $GLINT bake --mesh a.ply -o a.c >/dev/null");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "static const struct glint_mesh baked");
    assert_int_equal(
        run("cat a.ply | $GLINT stream --mesh - --size 40x30 --frames 2 --fps 4 --to ppm -o t%d.ppm")->status, 0);
    assert_false(same_file("t0.ppm", "t1.ppm"));
}

static void what_standard_input_holds_wrong_is_one_line(void **state)
{
    (void)state;
    static const char *const inputs[][2] = {
        {"</dev/null", "standard input: is empty; send a mesh"},
        {"<&-", "standard input: could not be read: "},
        {"<.", "standard input: could not be read: "},
        {"</dev/zero", "standard input: has more than 256 MB; simplify the mesh"},
        {"<$GLINT", "standard input: this is not an OBJ, STL, PLY or glTF"},
        {"<<<'vertices, but no mesh'", "standard input: this is not an OBJ, STL, PLY or glTF"},
        {"<<<'{}'", "standard input: libassimp cannot read this mesh: it is damaged"},
        {"<<<'v 0 0 0'", "standard input: "},
        {"< <(head -c 160 a.ply)", "standard input: libassimp cannot read this mesh: it ends before all that"},
        {"<nan.obj", "standard input: triangle 1 has a coordinate that is not a number below 10^30"}};
    write_text("nan.obj", "v 0 0 0\nv nan 1 0\nv 1 1 0\nf 1 2 3\n");
    for (size_t i = 0; i < sizeof inputs / sizeof *inputs; i++) {
        char line[200];
        snprintf(line, sizeof line, "bash -c \"\\$GLINT bake --mesh - -o no.c %s\"", inputs[i][0]);
        assert_fails(line, inputs[i][1]);
    }
    assert_fails("cp a.ply a.bin; $GLINT bake --mesh - -o a.bin <a.bin", "a.bin: ");
    assert_same_file("a.ply", "a.bin");
    assert_false(exists("no.c") || exists("no.h"));
}

/* libassimp fills up what is missing, or reads what lies behind. */
static void a_ply_that_is_cut_or_names_vertices_that_it_does_not_have_is_refused(void **state)
{
    (void)state;
    static const char head[] = "ply\nformat %s 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                               "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
    static const char text[] = "0 0 0\n2 0 0\n0 1 0\n2 2 1\n3 0 1 2\n3 1 2 3\n";
    static const char *const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    char bytes[400];
    for (int k = 0; k < 3; k++) {
        size_t len = (size_t)snprintf(bytes, sizeof bytes, head, formats[k]);
        const size_t whole = len + (k ? 4 * 12 + 2 * 13 : strlen(text) - 1); /* the last line's end may be missing */
        if (k == 0)
            memcpy(bytes + len, text, sizeof text);
        for (unsigned i = 0; k && i < 12; i++, len += 4) {
            const uint32_t bits = (uint32_t[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1}[i] * 0x3f800000;
            memcpy(bytes + len, &(uint32_t){k == 2 ? __builtin_bswap32(bits) : bits}, 4);
        }
        for (unsigned i = 0; k && i < 6; i++, len += 4) {
            const uint32_t index = (uint32_t[]){0, 1, 2, 1, 2, 3}[i];
            if (i % 3 == 0)
                bytes[len++] = 3;
            memcpy(bytes + len, &(uint32_t){k == 2 ? __builtin_bswap32(index) : index}, 4);
        }
        for (size_t cut = 1; cut <= whole + 1; cut += cut < whole - 3 ? 7 : 1) {
            const size_t now = cut < whole ? cut : whole;
            FILE *file = fopen("cut.ply", "wb");
            assert_non_null(file);
            write_bytes(file, bytes, now);
            assert_int_equal(fclose(file), 0);
            if (now < whole)
                assert_fails("$GLINT bake --mesh cut.ply -o no.c", "it ends before all that its header promises");
            else
                assert_contains(run("$GLINT bake --mesh cut.ply")->out, "2 triangles");
        }
    }
    static const char begins[] =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty int x\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n\n123\003\0\0\0\0\0\0\0\0\0\0\0";
    FILE *odd = fopen("odd.ply", "wb");
    assert_non_null(odd);
    write_bytes(odd, begins, sizeof begins);
    assert_int_equal(fclose(odd), 0);
    assert_fails("$GLINT bake --mesh odd.ply -o no.c", "its data begin with the byte 10");
    static const char *const wrong[] = {"s/3 1 2 3/3 1 2 4/", "s/3 1 2 3/3 1 2 -1/", "s/3 1 2 3/3 1 2 999999/"};
    write_text("whole.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                            "0 0 0\n2 0 0\n0 1 0\n2 2 1\n3 0 1 2\n3 1 2 3\n");
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[200];
        snprintf(line, sizeof line, "sed '%s' whole.ply >odd.ply && $GLINT bake --mesh odd.ply -o no.c", wrong[i]);
        assert_fails(line, "a face names a vertex that the file does not have");
    }
    static const char *const damaged[] = {
        "s/list uchar/list float/",      "s/float y/floaty y/", "s/vertex 4/vertex 4x/", "s/face 2/face -2/",
        "s/element face/elephant face/", "s/ascii/morse/",      "s/^ply/plywood/"};
    for (size_t i = 0; i < sizeof damaged / sizeof *damaged; i++) {
        char line[200];
        snprintf(line, sizeof line, "sed '%s' whole.ply >odd.ply && $GLINT bake --mesh odd.ply -o no.c", damaged[i]);
        assert_fails(line, "its header is damaged");
    }
    assert_quiet(
        "sed 's/element vertex/comment of a PLY\\ncomment\\nobj_info x 1\\n&/; s/$/\\r/' whole.ply >crlf.ply && "
        "for f in whole crlf; do $GLINT bake --mesh $f.ply --as raw -o - 2>said >$f.bin; done; "
        "cmp whole.bin crlf.bin && test -s crlf.bin");
    assert_fails("sed 's/3 1 2 3/-3 1 2 3/' whole.ply >odd.ply && $GLINT bake --mesh odd.ply -o no.c",
                 "a list's length is not a number");
    assert_false(exists("no.c") || exists("no.h"));
}

/* A mesh may lie in several files, of which the user names one. */
static void an_output_that_is_a_file_of_the_mesh_is_refused_and_kept(void **state)
{
    (void)state;
    static const char *const lines[][2] = {{"bake --mesh m.obj --as raw -o m.obj", "m.obj"},
                                           {"bake --mesh m.obj --as c -o m.mtl", "m.mtl"},
                                           {"bake --mesh m.obj --as raw -o hard.mtl", "hard.mtl"},
                                           {"render --mesh m.obj --size 9x9 --image ppm -o m.mtl", "m.mtl"},
                                           {"bake --mesh m.gltf -o m.bin", "m.bin"},
                                           {"stream --mesh m.gltf --size 9x9 --frames 1 --to y4m -o m.bin", "m.bin"}};
    write_text("m.obj", "mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    write_text("m.mtl", "newmtl red\nKd 1 0 0\n");
    assert_quiet("tail -c 36 a.glb >m.bin && ln m.mtl hard.mtl && "
                 "sed 's|data:application/octet-stream;base64,[^\"]*|m.bin|' a.gltf >m.gltf && grep -q m.bin m.gltf && "
                 "mkdir kept && cp m.obj m.mtl m.gltf m.bin kept");
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char line[200], message[100];
        snprintf(line, sizeof line, "$GLINT %s", lines[i][0]);
        snprintf(message, sizeof message, "%s: this file is also an input; name another for the output", lines[i][1]);
        assert_fails(line, message);
        assert_quiet("for f in m.obj m.mtl m.gltf m.bin; do cmp $f kept/$f || exit 1; done");
    }
    assert_int_equal(run("$GLINT bake --mesh m.gltf -o other.bin")->status, 0);
    /* A pipe in the place of the materials is not waited for: the mesh has none. */
    const struct run *result = run("rm m.mtl && mkfifo m.mtl && $GLINT render --mesh m.obj --size 9x9 -o pipe.ppm");
    assert_int_equal(result->status, 0);
    assert_string_equal(result->err, "glint: m.obj: names m.mtl, which is left out: it is not a regular file\n");
}

static void materials_take_the_memory_of_those_that_are_there(void **state)
{
    (void)state;
    struct obj_materials materials = {0};
    for (unsigned i = 0; i <= OBJ_MATERIALS_MAX; i++) {
        char name[8];
        snprintf(name, sizeof name, "m%u", i);
        assert_int_equal(obj_materials_find(&materials, name), i);
        assert_true(malloc_usable_size(materials.of) < (2 * i + 50) * sizeof *materials.of);
    }
    assert_int_equal(obj_materials_find(&materials, "m0"), 0);
    obj_materials_free(&materials);
}

static void a_mesh_that_faces_inwards_is_drawn_with_a_warning(void **state)
{
    (void)state;
    write_text("cube.obj", CUBE);
    const struct run *result =
        run("sed 's/^f \\([^ ]*\\) \\([^ ]*\\) \\([^ ]*\\) /f \\3 \\2 \\1 /; /^vt/d; s|/1||g' cube.obj >inside.obj && "
            "$GLINT render --mesh inside.obj --size 9x9 -o inside.ppm");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "inside.obj: most triangles seem to face inwards");
    result =
        run("sed '/^vt/d; s|/1||g' cube.obj >outside.obj && $GLINT render --mesh outside.obj --size 9x9 -o inside.ppm");
    assert_string_equal(result->err, "");
}

static void hostile_files_are_one_line(void **state)
{
    (void)state;
    static const char *const files[][3] = {
        {"nan.obj", "v 0 0 0\nv nan 1 0\nv 1 1 0\nf 1 2 3\n",
         "triangle 1 has a coordinate that is not a number below 10^30"},
        {"far.obj", "v 0 0 0\nv 1e38 1 0\nv 1 1 0\nf 1 2 3\n", "not a number below 10^30"},
        {"point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "all its corners are at one place"},
        {"line.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", "has no triangle with an area"},
        {"lines.obj", "v 0 0 0\nv 1 1 1\nl 1 2\n", "has no triangles"},
        {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n", "line 4: a face names what the file does not have"},
        {"empty.ply", "", "this file is empty; name a mesh"},
        {"text.stl", "This is not a mesh at all, whatever its name says.\n", "libassimp cannot read this mesh: "},
        {"huge.ply",
         "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 4000000000\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n",
         "huge.ply: "}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char line[200];
        write_text(files[i][0], files[i][1]);
        snprintf(line, sizeof line, "$GLINT bake --mesh %s -o no.c", files[i][0]);
        assert_fails(line, files[i][2]);
    }
    assert_fails("$GLINT bake --mesh none.obj", "none.obj: No such file");
    assert_fails("$GLINT bake --mesh . ", "a mesh's name ends in .obj");
    assert_fails("mkdir d.obj; $GLINT bake --mesh d.obj", "d.obj: this is not a regular file");
    assert_fails(
        "(printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\n'; yes 'f 1 2 3' | head -65535) >many.obj; $GLINT bake --mesh many.obj",
        "has 65535 triangles, and at most 65534 can be drawn");
    write_text("cube.obj", CUBE);
    assert_fails("$GLINT bake --mesh cube.obj --crease 180 --split 1 -o no.c", "give a larger angle");
    assert_fails("$GLINT bake --mesh cube.obj --unit 40000 -o no.c", "places are beyond 32767");
    assert_false(exists("no.c") || exists("no.h"));
}

static void an_obj_is_read_in_any_spelling(void **state)
{
    (void)state;
    static const char *const files[] = {
        "v 0 0 0\nv 1 0 0\nv .5 1 0\nv .5 1 2\nv 0 2 0\nv 3 3 3\nf 1 2 3\nf 1 3 4\n",
        "v 0. 0 0\nv +1 0 0\nv 5e-1 +1. -0.0\nv 0.5 10E-1 2e+0\nv 00 2 0\nv 3 3 3\nf 1 2 3\nf -6 -4 -3",
        "\xEF\xBB\xBF \\\n v 0 0 0\r\n\tv 1 \\\r\n 0 0\r\nv .5 1 0 # a comment\r\nv\t.5\t1\t2\r\n# \\\r\nv 0 2 0\r\nv "
        "3 3 "
        "3\r\n"
        "f 1 2 \\\r\n3\r\nf +1 3/ 4//\r\n",
        "v 0 0 0 1\nv 1 0 0 1\nv 1 2 0 2\nv .5 1 2 1.\nv 0 2 0\nv 3 3 3\nvt .5\nvn 0 0 +1\nf 1 2 3\nf 1/1/1 3//-1 "
        "4/-1\n"};
    static const char *const refused[][2] = {{"v 0 0 0\nv 1 0\n", "line 2: a vertex has three numbers"},
                                             {"v 0 0 0\nv 1 \\\n0 1 1 1\n", "line 3: a vertex has three numbers"},
                                             {"v 0 0 one\n", "line 1: a vertex has three numbers"},
                                             {"v 0 0 1e\n", "line 1: a vertex has three numbers"},
                                             {"v 0 0 .\n", "line 1: a vertex has three numbers"},
                                             {"vt 1 2 3 4\n", "line 1: a place in a texture has two numbers"},
                                             {"vn 1 2\n", "line 1: a normal has three numbers"},
                                             {"v 0 0 0 0\n", "line 1: a vertex has three numbers"},
                                             {"f 1 2 3\n\nv 0 0 0\nv 1 1 1\n", "line 1: a face names what"},
                                             {"v 0 0 0\nf 1 -2 1\n", "line 2: a face has numbers of vertices"},
                                             {"v 0 0 0\nf 1 0 1\n", "line 2: a face has numbers of vertices"},
                                             {"v 0 0 0\nf 1 1/1/1/1 1\n", "line 2: a face has numbers of vertices"},
                                             {"v 0 0 0\nf 1 a 1\n", "line 2: a face has numbers of vertices"}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        write_text("a.obj", files[i]);
        assert_int_equal(run(i ? "$GLINT bake --mesh a.obj --split 180 --crease 180 --as raw -o a.bin"
                               : "sed 's/ \\./ 0./g' a.obj >b.obj; for i in a b; do $GLINT bake --mesh $i.obj --split "
                                 "180 --crease 180 --as raw -o "
                                 "$i.bin || exit 1; done")
                             ->status,
                         0);
        assert_same_file("a.bin", "b.bin");
    }
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        write_text("a.obj", refused[i][0]);
        assert_fails("$GLINT bake --mesh a.obj -o no.c", refused[i][1]);
    }
    /* Colours with alpha, which some programs write, are colours. */
    assert_int_equal(
        run("for a in '' ' .5'; do printf \"v 0 0 0 1 0 0$a\\nv 2 0 0 0 1 0$a\\nv 0 1 0 0 0 1$a\\nf 1 2 3\\n\" >a.obj; "
            "$GLINT render --mesh a.obj --size 9x9 -o \"c$a.ppm\" || exit 1; done")
            ->status,
        0);
    assert_same_file("c.ppm", "c .5.ppm");
}

/* A ring with round sides of `sides` corners, which face inwards where `flipped`, with normals that point out or, as `normals` says, in. */
static void write_ring(const char *path, int sides, bool flipped, int normals)
{
    enum { AROUND = 48 };
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (int i = 0; i < AROUND * sides; i++) {
        const double u = 2 * M_PI * (i / sides) / AROUND, v = 2 * M_PI * (i % sides) / sides, r = 2 + .8 * cos(v);
        fprintf(file, "v %.7f %.7f %.7f\n", r * cos(u), .8 * sin(v), r * sin(u));
        if (normals)
            fprintf(file, "vn %.7f %.7f %.7f\n", normals * cos(v) * cos(u), normals * sin(v),
                    normals * cos(v) * sin(u));
    }
    for (int i = 0; i < AROUND * sides; i++) {
        const int u = i / sides, v = i % sides, next = (u + 1) % AROUND;
        const int quad[4] = {i + 1, u * sides + (v + 1) % sides + 1, next * sides + (v + 1) % sides + 1,
                             next * sides + v + 1};
        for (int k = 1; k < 3; k++) {
            const int corners[3] = {quad[0], quad[flipped ? k + 1 : k], quad[flipped ? k : k + 1]};
            fputc('f', file);
            for (int j = 0; j < 3; j++)
                fprintf(file, normals ? " %d//%d" : " %d", corners[j], corners[j]);
            fputc('\n', file);
        }
    }
    assert_int_equal(fclose(file), 0);
}

static void a_mesh_that_is_inside_out_is_turned_by_flip_faces(void **state)
{
    (void)state;
    static const int normals[][2] = {{1, 1}, {1, -1}, {0, 0}}; /* of the right one, and of the flipped */
    for (size_t i = 0; i < 3; i++) {
        write_ring("right.obj", 12, false, normals[i][0]);
        write_ring("flipped.obj", 12, true, normals[i][1]);
        assert_quiet("$GLINT render --mesh right.obj --size 60x60 -o right.ppm && "
                     "$GLINT render --mesh flipped.obj --flip-faces --size 60x60 -o a.ppm");
        assert_same_file("right.ppm", "a.ppm");
        assert_contains(run("$GLINT render --mesh flipped.obj --size 60x60 -o a.ppm")->err, "--flip-faces");
        assert_false(same_file("right.ppm", "a.ppm"));
    }
    assert_refused("$GLINT render --scene teapot --flip-faces -o no.ppm", "--flip-faces is for a mesh's file");
    assert_refused("$GLINT render --scene coin --flip-faces -o no.ppm", "--flip-faces needs --mesh");
}

static void a_file_whose_own_normals_are_smooth_enough_is_not_split(void **state)
{
    (void)state;
    write_ring("smooth.obj", 9, false, 1); /* 40 degrees */
    assert_contains(run("$GLINT bake --mesh smooth.obj")->out, "432 vertices, 864 triangles");
    assert_contains(run("$GLINT bake --mesh smooth.obj --split 30")->out,
                    "--split 30 made these of 432 vertices, 864 triangles, 14256 bytes, which --split ");
    assert_contains(run("$GLINT bake --mesh smooth.obj --crease 60")->out, "--split 30 made these of");
    write_ring("made.obj", 9, false, 0);
    assert_contains(run("$GLINT bake --mesh made.obj")->out, "--split 30 made these of");
    write_ring("edged.obj", 7, false, 1); /* 51 degrees */
    assert_contains(run("$GLINT bake --mesh edged.obj")->out, "--split 45 made these of");
    /* The angle that it names leaves the mesh as it is; the one below does not. */
    assert_quiet("angle=$($GLINT bake --mesh edged.obj | sed -n 's/.*which --split \\([0-9]*\\) leaves/\\1/p') && "
                 "$GLINT bake --mesh edged.obj --split $angle | head -1 | grep -q ' 672 triangles' && "
                 "! $GLINT bake --mesh edged.obj --split $((angle - 1)) | head -1 | grep -q ' 672 triangles'");
}

/* A file of the user's that the mesh has no business with: ../out.mtl and, by a link, in/link.mtl. */
static void a_mesh_names_files_in_its_folder_or_below_only(void **state)
{
    (void)state;
    static const char *const elsewhere[] = {"../out.mtl", "link.mtl", "./below/../../out.mtl"};
    const struct run *result;
    static const char *const within[] = {"red.mtl", "below/red.mtl", "below/../red.mtl", "inner.mtl"};
    assert_quiet("mkdir -p in/below && printf 'newmtl red\\nKd 1 0 0\\n' >out.mtl && cp out.mtl in/below/red.mtl && cp "
                 "out.mtl in/red.mtl && "
                 "ln -s ../out.mtl in/link.mtl && ln -s below/red.mtl in/inner.mtl && ln -s in/red.obj outer.obj");
    write_text("in/plain.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    assert_quiet("(echo mtllib red.mtl; cat in/plain.obj) >in/red.obj; for i in plain red; do "
                 "$GLINT render "
                 "--mesh in/$i.obj --size 20x20 -o $i.ppm; done; ! cmp -s plain.ppm red.ppm");
    for (size_t i = 0; i < sizeof elsewhere / sizeof *elsewhere; i++) {
        setenv("name", elsewhere[i], 1);
        result = run("sed \"s|red.mtl|$name|\" in/red.obj >in/a.obj; "
                     "$GLINT render --mesh in/a.obj --size 20x20 -o a.ppm");
        assert_int_equal(result->status, 0);
        assert_one_line(result->err);
        assert_contains(result->err, "which is left out: it lies outside the mesh's folder");
        assert_same_file("a.ppm", "plain.ppm");
        assert_quiet("$GLINT render --mesh in/a.obj --allow-files $PWD/in/.. --size 20x20 -o a.ppm");
        assert_same_file("a.ppm", "red.ppm");
    }
    for (size_t i = 0; i < sizeof within / sizeof *within; i++) {
        setenv("name", within[i], 1);
        assert_quiet(
            "sed \"s|red.mtl|$name|\" in/red.obj >in/a.obj; $GLINT render --mesh in/a.obj --size 20x20 -o a.ppm");
        assert_same_file("a.ppm", "red.ppm");
    }
    assert_quiet(
        "cp out.mtl red.mtl && $GLINT render --mesh outer.obj --size 20x20 -o a.ppm"); /* a link that the user names */
    assert_same_file("a.ppm", "red.ppm");
    result = run("cd in && $GLINT render --mesh - --size 20x20 -o ../a.ppm <red.obj");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "red.mtl, which is left out: it is a file, and the mesh comes from standard input");
    assert_same_file("a.ppm", "plain.ppm");
    assert_refused("$GLINT render --mesh - --allow-files in -o a.ppm <in/red.obj", "--allow-files needs --mesh");
    assert_fails("$GLINT render --mesh in/red.obj --allow-files nothing -o a.ppm",
                 "--allow-files: nothing: No such file");
    assert_fails("$GLINT render --mesh in/red.obj --allow-files in/red.mtl -o a.ppm", "this is a file; name a folder");
    /* What is no MTL is nobody's business. */
    write_text("in/red.mtl", "secret: red\nKd\nnewmtl\nillum secret\nKd secret\n");
    assert_null(strstr(run("$GLINT render --mesh in/red.obj --size 20x20 -o a.ppm")->err, "secret"));
}

/* Numbers, too, which would be drawn. */
static void a_gltf_names_files_in_its_folder_or_below_only(void **state)
{
    (void)state;
    write_text(
        "in/a.gltf",
        "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"buffers\":[{\"byteLength\":36,\"uri\":"
        "\"../a.bin\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,"
        "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}]}");
    const float places[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    FILE *file = fopen("a.bin", "wb");
    assert_true(file && fwrite(places, sizeof places, 1, file) == 1 && fclose(file) == 0);
    assert_fails("$GLINT render --mesh in/a.gltf --size 9x9 -o no.ppm", "a.bin: it lies outside the mesh's folder");
    assert_quiet("$GLINT render --mesh in/a.gltf --allow-files . --size 9x9 -o a.ppm");
    assert_quiet(
        "cp a.bin in; sed -i 's|../a.bin|a.bin|' in/a.gltf; $GLINT render --mesh in/a.gltf --size 9x9 -o b.ppm");
    assert_same_file("a.ppm", "b.ppm");
    assert_quiet("mkdir in/b%20c; cp a.bin 'in/b%20c/a b.bin'; sed 's|a.bin|a%20b.bin|' in/a.gltf >in/b%20c/a.gltf; "
                 "$GLINT render --mesh in/b%20c/a.gltf --size 9x9 -o b.ppm");
    assert_same_file("a.ppm", "b.ppm");
    assert_fails("$GLINT render --mesh - --size 9x9 -o no.ppm <in/a.gltf",
                 "standard input: libassimp cannot read this mesh");
}

#else
static void a_mesh_is_refused_with_what_to_install(void **state)
{
    (void)state;
    write_text("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_fails("$GLINT render --mesh a.obj -o no.png", "install libassimp-dev");
    assert_contains(run("$GLINT --version")->out, "mesh files");
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_teapot_is_drawn_baked_and_streamed_without_a_file),
        cmocka_unit_test(every_path_that_draws_meshes_is_near_double_precision),
        cmocka_unit_test(options_that_do_not_fit_a_mesh_are_refused),
#if GLINT_WITH_MESH
        cmocka_unit_test(an_obj_has_its_materials),
        cmocka_unit_test(a_mesh_that_is_inside_out_is_turned_by_flip_faces),
        cmocka_unit_test(a_file_whose_own_normals_are_smooth_enough_is_not_split),
        cmocka_unit_test(stl_ply_and_gltf_are_read_and_axes_turn_what_is_up),
        cmocka_unit_test(standard_input_is_known_by_its_bytes_and_read_as_a_file_is),
        cmocka_unit_test(what_standard_input_holds_wrong_is_one_line),
        cmocka_unit_test(a_ply_that_is_cut_or_names_vertices_that_it_does_not_have_is_refused),
        cmocka_unit_test(an_output_that_is_a_file_of_the_mesh_is_refused_and_kept),
        cmocka_unit_test(materials_take_the_memory_of_those_that_are_there),
        cmocka_unit_test(a_mesh_that_faces_inwards_is_drawn_with_a_warning),
        cmocka_unit_test(hostile_files_are_one_line),
        cmocka_unit_test(an_obj_is_read_in_any_spelling),
        cmocka_unit_test(a_mesh_names_files_in_its_folder_or_below_only),
        cmocka_unit_test(a_gltf_names_files_in_its_folder_or_below_only),
#else
        cmocka_unit_test(a_mesh_is_refused_with_what_to_install),
#endif
    };
    return cmocka_run_group_tests_name("mesh files", tests, scratch_make, scratch_remove);
}
