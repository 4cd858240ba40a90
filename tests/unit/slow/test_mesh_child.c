/* SPDX-License-Identifier: MIT
 * glint bake --mesh with a compiler: what it writes, and what becomes of the child that reads where libassimp fails. */
#include "files.h"

#include <math.h>

#include "mesh/import.h"
#include "mesh/obj.h"

static void a_baked_mesh_compiles_and_is_what_raw_holds(void **state)
{
    (void)state;
    const struct run *result =
        run("$GLINT bake --scene teapot --split 180 -o pot.c >/dev/null && $GLINT bake --scene teapot --split 180 -o "
            "pot.bin && "
            "cat >t.c <<E\n#include <stdio.h>\n#include \"pot.h\"\nint main(void) {\n"
            "  const unsigned head[4] = {pot.vertex_count, pot.face_count, POT_PARTS, 513};\n"
            "  for (int i = 0; i < 4; i++) { putchar(head[i] & 255); putchar(head[i] >> 8); }\n"
            "  fwrite(pot.places, 6, POT_VERTICES, stdout); fwrite(pot.normals8, 3, POT_VERTICES, stdout);\n"
            "  fwrite(pot.faces, 6, POT_FACES, stdout); fwrite(pot.neighbours, 6, POT_FACES, stdout); "
            "putchar(pot.face_count & 255); putchar(pot.face_count >> 8);\n"
            "  fwrite(pot_materials[0].albedo, 3, 1, stdout); putchar(0); return pot_materials[0].n != 60; }\nE\n"
            "for l in 'gcc -std=c99' 'g++ -std=c++11 -x c++'; do $l -Wall -Wextra -Werror "
            "-I\"$GLINT_SOURCE\"/lib t.c pot.c "
            "-o t && ./t | cmp - pot.bin || exit 1; done");
    assert_string_equal(result->err, "");
    assert_int_equal(result->status, 0);
    assert_contains(result->out, "530 vertices, 992 triangles, 1 part, normals as int8: 16674 bytes");
    assert_contains(result->out, "million cycles by COLOUR tables in C, ");
    assert_null(strstr(result->out, "--split"));
    assert_contains(run("$GLINT bake --scene teapot -o pot.raw --as raw")->out,
                    "--split 30 made these of 530 vertices, 992 triangles, 16674 bytes, which --split 98 leaves");
    result = run("$GLINT bake --scene teapot --to int16 --json");
    assert_contains(result->out, "\"before_split\": {");
    assert_contains(result->out, "\"triangles\": 2710");
    const char *cycles = strstr(result->out, "\"predicted_cycles\": ");
    assert_non_null(cycles);
    assert_near(atof(cycles + 20), 5.3e6, .4e6); /* emulated, of 8-bit normals in one pose: 5.9 million */
    assert_int_equal(run("$GLINT bake --scene teapot --split 180 -o pot.uf2")->status, 0);
    struct stat status;
    assert_int_equal(stat("pot.uf2", &status), 0);
    assert_int_equal(status.st_size, 512 * ((8 + 9 * 530 + 12 * 992 + 6 + 255) / 256));
}

#if GLINT_WITH_MESH
/* a.obj, read as C and as C++, drawn by hand at the pose of glint render. $more: options of both. */
static void assert_baked_as_rendered(const char *more)
{
    assert_int_equal(library_make(), 0);
    setenv("more", more, 1);
    const struct run *result = run(
        "$GLINT bake --mesh a.obj $more --to int16 -o a.c >/dev/null && $GLINT material --format rgb888 --name look -o "
        "look.h && "
        "$GLINT render --mesh a.obj $more --size 40x40 --image raw -o wanted.raw && "
        "cat >t.c <<E\n#include <stdio.h>\n#include \"a.h\"\n#include \"look.h\"\n"
        "static uint32_t frame_memory[4096], mesh_memory[2048];\nstatic uint8_t pixels[40 * 120];\n"
        "int main(void) {\n  const struct glint_pose pose = {{32767, 0, 0, 0}, {0, 0, 0}, 320};\n"
        "  const struct glint_surface target = {pixels, 120, 0, 0};\n"
        "  struct glint_paint paint; struct glint_light lights[look_light_count];\n"
        "  struct glint_mesh_frame frame; struct glint_mesh_drawn drawn;\n"
        "  return glint_paint_exact(&paint, &look, &look_output) || look_light(&paint, lights) ||\n"
        "    glint_mesh_begin(&frame, 40, 40, 40, 0, frame_memory, sizeof frame_memory) ||\n"
        "    (frame.outlines = &glint_outlines) == NULL ||\n"
        "    glint_mesh_add(&frame, &drawn, &a, &pose, &paint, mesh_memory, sizeof mesh_memory) ||\n"
        "    glint_mesh_strip(&frame, 0, 40, &target) || fwrite(pixels, 1, sizeof pixels, stdout) != sizeof pixels; "
        "}\nE\n"
        "for l in 'gcc -std=c99' 'g++ -std=c++11 -x c++'; do $l -Wall -Wextra -Werror -I\"$GLINT_SOURCE\"/lib t.c a.c "
        "-x none lib.a -o t && ./t | cmp - wanted.raw || exit 1; done");
    assert_string_equal(result->err, "");
    assert_string_equal(result->out, "");
    assert_int_equal(result->status, 0);
}

static void baked_colours_draw_the_pixels_of_render(void **state)
{
    (void)state;
    write_text("a.obj", "v 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 -1 0 1 1 0\nf 1 2 3\nf 1 4 2\n");
    assert_baked_as_rendered("");
}

static void baked_textures_draw_the_pixels_of_render(void **state)
{
    (void)state;
    uint16_t samples[12 * 8 * 3];
    for (unsigned i = 0; i < 12 * 8 * 3; i++)
        samples[i] = (uint16_t)(i * i % 251);
    make_png("a.png", &(struct made_png){
                          .width = 12, .height = 8, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = samples});
    write_text("a.obj", "mtllib a.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nv 1 -1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt -1 -2\n"
                        "usemtl a\nf 1/1 2/2 3/3\nf 1/1 4/4 2/2\n");
    write_text("a.mtl", "newmtl a\nmap_Kd a.png\n");
    assert_baked_as_rendered("--nearest");
    assert_baked_as_rendered("--smooth");
    assert_baked_as_rendered("--texture-to palette --texture-bytes 640");
}

/* Places in the picture follow the parts, then pictures: see glint bake --help. */
static void raw_textures_are_those_of_the_source(void **state)
{
    (void)state;
    const struct run *result =
        run("cat >r.c <<E\n#include <stdio.h>\n#include \"a.h\"\n"
            "static void put(unsigned x) { putchar(x & 255); putchar(x >> 8); }\n"
            "int main(void) {\n  const struct glint_texture *t = a.textures;\n  const uint8_t *p = t->pixels;\n"
            "  put(a.uv_bits); put(1); for (int i = 0; i < 2 * A_VERTICES; i++) put(a.uv[i]);\n"
            "  put(1); put(t->is_smooth); put(t->w); put(t->h); put(t->levels); put(COLORS);\n"
            "  for (int i = 0; i < COLORS; i++) put(t->palette[i]);\n"
            "  for (int i = 0; i < PIXELS * (COLORS ? 1 : 2); i++) putchar(p[i]);\n"
            "  if (COLORS && PIXELS % 2) putchar(0); return 0; }\nE\n"
            "for o in 'rgb565 0' 'palette 127'; do set -- $o; "
            "$GLINT bake --mesh a.obj --texture-to $1 -o a.c >/dev/null && $GLINT bake --mesh a.obj --texture-to $1 -o "
            "a.bin >/dev/null && n=$(sed -n '/a_palette1\\[/,/};/p' a.c | tr -cd , | wc -c) && "
            "n=$((n + (n > 0))) && "
            "gcc -DCOLORS=$n -DPIXELS=127 -I\"$GLINT_SOURCE\"/lib r.c a.c lib.a -o r || exit 1; "
            "./r >part && tail -c $(stat -c %s part) a.bin | cmp - part || exit 1; "
            "od -A n -t u2 -j 6 -N 2 a.bin; done");
    assert_string_equal(result->err, "");
    assert_int_equal(result->status, 0);
    assert_string_equal(result->out, "  1537\n  1537\n");
}

/* A spiral that crosses itself; not in a child, which has a limit of time, too. */
static void a_face_that_would_take_long_to_cut_is_refused_with_its_line(void **state)
{
    (void)state;
    enum { CORNERS = 20000 };
    char *text = NULL, wrong[120];
    size_t len = 0;
    FILE *obj = open_memstream(&text, &len);
    for (int i = 0; i < CORNERS; i++) {
        const int k = i < CORNERS / 2 ? i : CORNERS - 1 - i;
        const double radius = (1 + k * 20. / CORNERS) * (i < CORNERS / 2 ? 1 : 1.02), angle = k / 20.;
        fprintf(obj, "v %g %g 0\n", radius * cos(angle), radius * sin(angle));
    }
    fputs("f", obj);
    for (int i = 1; i <= CORNERS; i++)
        fprintf(obj, " %d", i);
    fclose(obj);
    assert_null(obj_soup(&(struct obj_source){text, len, false, NULL, NULL, NULL}, wrong));
    assert_string_equal(wrong, "line 20001: a face has too many corners and dents; cut it into triangles");
    free(text);
}

/* A library that does what the file's name says, in place of libassimp. */
static void the_childs_death_is_one_line_and_it_runs_with_limits(void **state)
{
    (void)state;
    write_text(
        "fake.c",
        "#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n#include <sys/resource.h>\n"
        "#include <assimp/cfileio.h>\nconst void *aiImportFileEx(const char *path, unsigned flags, struct aiFileIO "
        "*io) "
        "{\n  char text[64] = {0}; (void)flags;\n  struct aiFile *file = io->OpenProc(io, path, \"rb\");\n"
        "  if (file->ReadProc(file, text, 1, 8) != 8) exit(1);\n  io->CloseProc(io, file); strncat(text, path, 50);\n"
        "  if (strstr(text, \"crash\")) raise_it(); if (strstr(text, \"quit\")) exit(0); if (strstr(text, \"hang\")) "
        "pause(); return NULL; }\n"
        "const char *aiGetErrorString(void) { static char text[200]; struct rlimit cpu, file;\n"
        "  getrlimit(RLIMIT_CPU, &cpu); getrlimit(RLIMIT_FSIZE, &file);\n"
        "  snprintf(text, sizeof text, \"limits %d %d\\n and \\033 odd\", (int)cpu.rlim_cur, "
        "(int)file.rlim_cur); return text; }\n"
        "int aiApplyPostProcessing, aiGetMaterialColor, aiGetMaterialFloatArray, aiGetMaterialIntegerArray, "
        "aiGetMaterialString;\n");
    assert_int_equal(run("sed -i 's/raise_it()/__builtin_trap()/' fake.c && "
                         "gcc -shared -fPIC fake.c -o $(basename $(readlink -f $(gcc -print-file-name=libassimp.so)) | "
                         "sed 's/\\(so\\.[0-9]*\\).*/\\1/')")
                         ->status,
                     0);
    static const char facet[] =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        "endsolid a\n";
    write_text("crash.stl", facet);
    write_text("quit.stl", facet);
    write_text("other.stl", facet);
    assert_fails("LD_LIBRARY_PATH=$PWD $GLINT bake --mesh crash.stl -o no.c", "crash.stl: libassimp crashed on it (");
    assert_fails("LD_LIBRARY_PATH=$PWD $GLINT bake --mesh quit.stl -o no.c", "quit.stl: libassimp broke off");
    assert_fails("LD_LIBRARY_PATH=$PWD $GLINT bake --mesh other.stl -o no.c", "cannot read this mesh: limits 10 0");
    write_text("hang.stl", facet);
    assert_fails("LD_LIBRARY_PATH=$PWD $GLINT bake --mesh hang.stl -o no.c", "did not read it within 10 s");
    assert_fails("printf 'crash%75s\\1\\0\\0\\0%50s' '' '' | LD_LIBRARY_PATH=$PWD $GLINT bake --mesh - -o no.c",
                 "standard input: libassimp crashed on it (");
    assert_fails("cat other.stl | LD_LIBRARY_PATH=$PWD $GLINT bake --mesh - -o no.c",
                 "standard input: libassimp cannot read this mesh: limits 10 0");
    assert_false(exists("no.c"));
    assert_contains(run("$GLINT --version")->out, import_library());
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_baked_mesh_compiles_and_is_what_raw_holds),
#if GLINT_WITH_MESH
        cmocka_unit_test(baked_colours_draw_the_pixels_of_render),
        cmocka_unit_test(baked_textures_draw_the_pixels_of_render),
        cmocka_unit_test(raw_textures_are_those_of_the_source),
        cmocka_unit_test(a_face_that_would_take_long_to_cut_is_refused_with_its_line),
        cmocka_unit_test(the_childs_death_is_one_line_and_it_runs_with_limits),
#endif
    };
    return cmocka_run_group_tests_name("mesh child", tests, scratch_make, scratch_remove);
}
