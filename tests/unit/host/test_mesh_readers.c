/* SPDX-License-Identifier: MIT
 * Files of meshes as programs write them, and damaged ones: what is read as it is meant, and what is refused or left out with one line. */
#include <math.h>

#include "bake/mesh_files.h"
#include "files.h"
#include "mesh/load.h"

#if GLINT_WITH_MESH
/* What `bake --mesh FROM --as raw -o TO` writes, without the quality that the command computes, which takes most of its time; it says nothing.
 * In a process of its own, which ends where the mesh is refused. */
static void assert_baked(const char *from, const char *to)
{
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        if (!freopen("said", "w", stderr))
            _exit(1);
        struct mesh *mesh = mesh_load(&(struct mesh_source){.name = from, .crease = -1, .axes = AXES_USUAL});
        struct fitted *fitted = mesh_fit(mesh, 0);
        struct glint_material *materials = mesh_materials(mesh);
        size_t len;
        uint8_t *raw = bake_mesh_raw(&(struct baked_mesh){mesh, fitted, materials, true}, &len);
        FILE *file = fopen(to, "wb");
        const bool is_written = file && fwrite(raw, 1, len, file) == len && fclose(file) == 0;
        free(raw);
        free(materials);
        fitted_free(fitted);
        mesh_free(mesh);
        exit(is_written ? 0 : 1);
    }
    int status;
    char said[1000];
    assert_int_equal(waitpid(child, &status, 0), child);
    read_text("said", said, sizeof said);
    if (status != 0 || *said)
        fail_msg("%s: status %d, %s", from, status, said);
}

/* `made` makes the file made.* of the ending that `from` has, and both are baked to the same: `from` once, as long as it stays as it is. */
static void assert_same_mesh(const char *from, const char *made)
{
    char line[1000];
    setenv("from", from, 1);
    if (run("cmp -s $from wanted.from")->status != 0) {
        assert_baked(from, "wanted.bin");
        assert_quiet("cp $from wanted.from");
    }
    assert_quiet(made);
    snprintf(line, sizeof line, "made.%s", strrchr(from, '.') + 1);
    assert_baked(line, "made.bin");
    assert_quiet("cmp wanted.bin made.bin");
}

/* Each reader's file, baked by the command. */
static void glint_bake_writes_what_is_compared_here(void **state)
{
    (void)state;
    static const char *const files[] = {"a.ply", "a.stl", "a.obj", "b.gltf"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        setenv("from", files[i], 1);
        assert_baked(files[i], "wanted.bin");
        assert_quiet("$GLINT bake --mesh $from --as raw -o made.bin >report && cmp wanted.bin made.bin");
    }
}

/* The same of what assert_same_mesh made. */
static void assert_same_piped(void)
{
    assert_quiet("cat made.${from##*.} | $GLINT bake --mesh - --as raw -o made.bin >report && cmp wanted.bin made.bin");
}

/* ---- PLY ---- */

#define PLY_VERTICES "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
#define PLY_FACES "element face 2\nproperty list uchar int vertex_indices\nend_header\n"

/* Beside colours, which are drawn. */
static void a_ply_is_read_whatever_it_holds_beside_places_and_faces(void **state)
{
    (void)state;
    static const char *const edits[] = {
        /* columns, with a property and without */
        "s/^element face/property float quality\\nproperty uchar kind\\n&/; s/^[^pef3].*[0-9]$/& .5 255/",
        "s/^property float x/property double confidence\\n&/; s/^[0-9] [0-9] [0-9]$/1 &/", "s/^[0-9] [0-9] [0-9]$/& 9/",
        "s/^3 .*/& 255 0 9/", "s/^end_header/property uchar red\\n&/; s/^3 .*/& 255/",
        "s/^element face/property uchar alpha\\n&/; s/^[0-9] [0-9] [0-9]$/& 99/",
        "s/^property list/property int flags\\n&/; s/^3 /7 &/",
        /* lines of a header among properties and before them */
        "s/^property float [xyz]/comment of a program\\n&/", "s/^property float y/obj_info 4 of them\\n\\n &/",
        "s/^property/\\n&/", "s/^property/ \\t \\n&/", "s/^property list/comment 1\\nobj_info vertex 1\\n&/",
        "s/^format/comment first\\n&/", "s/^format/comment TextureFile\\n&/", "s/^element/comment 2 vertices\\n&/",
        "s/^end_header/comment\\n\\n&/",
        /* elements that nothing is made of, and empty lines */
        "s/^element face/element edge 1\\nproperty int vertex1\\n&/; s/^3 0 1 2/1\\n&/",
        "s/^end_header/element camera 1\\nproperty float view_px\\n&/; $s/$/\\n9/",
        "s/^element face/element camera 0\\n&/", "s/^[0-9].*/\\n&\\n/",
        /* other blanks between words of the header, and behind them */
        "1,/^end/ s/ /  /g", "1,/^end/ s/ /\\t/g", "2,/^end/ s/ / \\v/g", "2,/^end/ s/ /\\f/g", "2,/^end/ s/$/\\v/"};
    write_text("a.ply", PLY_VERTICES PLY_FACES "0 0 0\n2 0 0\n0 1 0\n2 2 1\n3 0 1 2\n3 1 2 3\n");
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) {
        char made[300];
        snprintf(made, sizeof made, "sed '%s' a.ply >made.ply && ! cmp -s a.ply made.ply", edits[i]);
        assert_same_mesh("a.ply", made);
    }
    /* no end of the last line, with longer lines before it */
    assert_same_mesh("a.ply", "sed 's/^2 2 1/2.0 2.0 1.0/; $s/^/ /' a.ply | head -c -1 >made.ply");
    assert_same_mesh("a.ply",
                     "long=$(printf '%5000s' | tr ' ' x) && sed \"s/^property/comment $long\\n&/\" a.ply >made.ply");
}

/* Vertices have a float and a byte that nothing is made of. */
static void a_binary_ply_is_read_whatever_it_holds_beside_places_and_faces(void **state)
{
    (void)state;
    static const char *const formats[] = {"binary_little_endian", "binary_big_endian"};
    for (int big = 0; big < 2; big++) {
        FILE *file = fopen("made.bin.ply", "wb");
        assert_non_null(file);
        fprintf(
            file,
            "ply\ncomment first\nformat %s 1.0\nobj_info 4\nelement vertex 4\ncomment of places\nproperty float x\n\n"
            "obj_info y\nproperty float y\nproperty float z\nproperty float quality\nproperty uchar kind\n"
            "element face 2\ncomment 3\nproperty list uchar int vertex_indices\ncomment last\nend_header\n",
            formats[big]);
        for (unsigned i = 0; i < 16; i++) {
            const uint32_t tops[16] = {0, 0,          0, 0x41, 0x40000000, 0,          0,          0x42,
                                       0, 0x3f800000, 0, 0x43, 0x40000000, 0x40000000, 0x3f800000, 0x44};
            const uint32_t bits = big ? __builtin_bswap32(tops[i]) : tops[i];
            fwrite(&bits, 4, 1, file);
            if (i % 4 == 3)
                fputc(255, file);
        }
        for (unsigned i = 0; i < 6; i++) {
            const uint32_t index = (uint32_t[]){0, 1, 2, 1, 2, 3}[i];
            if (i % 3 == 0)
                fputc(3, file);
            fwrite(&(uint32_t){big ? __builtin_bswap32(index) : index}, 4, 1, file);
        }
        assert_int_equal(fclose(file), 0);
        assert_same_mesh("a.ply", "cp made.bin.ply made.ply");
        if (!big)
            assert_quiet("head -c -94 made.bin.ply >made.bin.head && cp made.bin.ply little.bin.ply");
        if (!big) /* the first byte is 10, by which the number grows hardly */
            assert_same_mesh("a.ply", "{ head -c -94 made.bin.ply; echo; tail -c 93 made.bin.ply; } >made.ply");
    }
}

/* Among them an element that libassimp does not know. */
static void a_ply_is_read_whatever_it_holds_before_places_and_faces(void **state)
{
    (void)state;
    static const char camera[] = "element camera 2\nproperty float view\nproperty list uchar short more\n";
    static const char *const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    static const uint8_t cameras[2][14] = {{0, 0, 0, 65, 2, 1, 0, 2, 0, 65, 65, 65, 65, 0},
                                           {65, 0, 0, 0, 2, 0, 1, 0, 2, 65, 65, 65, 65, 0}};
    for (int format = 0; format < 3; format++) {
        for (int at = 1; at < 8;
             at += at == 2 ? 5 : 1) { /* before places, before faces, after them; lines end in CR, too */
            char head[600] = PLY_VERTICES;
            FILE *file = fopen("made.ply", "wb");
            assert_non_null(file);
            snprintf(head, sizeof head, "ply\nformat %s 1.0\n%s%s%s%s%send_header\n", formats[format],
                     at & 1 ? camera : "", strstr(PLY_VERTICES, "element"), at & 2 ? camera : "",
                     "element face 2\nproperty list uchar int vertex_indices\n", at == 7 ? camera : "");
            for (char *c = head; at >= 4 && (c = strchr(c, '\n'));)
                *c = '\r';
            fputs(head, file);
            for (int part = 0; part < 3; part++) {
                const bool has_camera = part == 2 ? at == 7 : at >> part & 1;
                if (has_camera && !format)
                    fputs("8 2 1 2\n9 0\n", file);
                if (has_camera && format)
                    assert_int_equal(fwrite(cameras[format - 1], 14, 1, file), 1);
                if (!format)
                    fputs(part == 0 ? "0 0 0\n2 0 0\n0 1 0\n2 2 1\n" : part == 1 ? "3 0 1 2\n3 1 2 3\n" : "", file);
                const uint32_t places[12] = {0, 0,          0, 0x40000000, 0,          0,
                                             0, 0x3f800000, 0, 0x40000000, 0x40000000, 0x3f800000},
                               corners[6] = {0, 1, 2, 1, 2, 3};
                for (int i = 0; format && part < 2 && i < (part ? 6 : 12); i++) {
                    const uint32_t word = part ? corners[i] : places[i];
                    if (part && i % 3 == 0)
                        fputc(3, file);
                    fwrite(&(uint32_t){format == 2 ? __builtin_bswap32(word) : word}, 4, 1, file);
                }
            }
            assert_int_equal(fclose(file), 0);
            assert_same_mesh("a.ply", "true");
        }
    }
    /* the first byte of the data is 10, behind a CR */
    assert_same_mesh(
        "a.ply", "tr '\\n' '\\r' <made.bin.head >made.ply && { printf '\\n'; tail -c 93 little.bin.ply; } >>made.ply");
}

/* A comb, of whose teeth libassimp's triangles cover too much. */
static void a_face_with_dents_is_drawn_alike_whatever_the_format(void **state)
{
    (void)state;
    assert_quiet("xy='0 0,8 0,7 1,6 1,5 7,4 1,3 8,2 1,1 1' && echo $xy | tr , '\\n' | sed 's/$/ 0/' >places && "
                 "{ sed 's/^/v /' places; echo f 1 2 3 4 5 6 7 8 9; } >comb.obj && "
                 "{ printf '" PLY_VERTICES PLY_FACES
                 "' | sed 's/vertex 4/vertex 9/; s/face 2/face 1/' && cat places && "
                 "echo 9 0 1 2 3 4 5 6 7 8; } >comb.ply && for i in obj ply; do $GLINT render --mesh comb.$i --color "
                 "200,200,200 "
                 "--size 64x64 -o $i.ppm || exit 1; done; cmp obj.ppm ply.ppm");
}

/* As MeshLab writes them; libassimp gives a vertex the place that its last face has there. */
static void places_in_a_texture_that_faces_of_a_ply_have_of_their_own_are_left_out_with_a_line(void **state)
{
    (void)state;
    assert_quiet(
        "printf '" PLY_VERTICES PLY_FACES "0 0 0\n2 0 0\n0 1 0\n2 2 1\n3 0 1 2\n3 1 2 3\n' >bare.ply && "
        "sed 's/^format.*/&\\ncomment TextureFile none.png/; s/^end_header/property list uchar float "
        "texcoord\\n&/; s/^3 .*/& 6 0 0 .5 0 0 .5/' bare.ply >corners.ply && "
        "for i in bare corners; do $GLINT render --mesh $i.ply --size 64x64 -o $i.ppm 2>$i || exit 1; done; "
        "cmp bare.ppm corners.ppm && ! grep . bare && grep -q 'corners.ply: texcoord, .* is left out' corners");
    assert_quiet("$GLINT render --mesh corners.ply --no-textures --size 64x64 -o corners.ppm");
}

static void a_ply_that_libassimp_would_read_as_another_shape_is_refused(void **state)
{
    (void)state;
    static const char *const edits[][2] = {
        {"s/^0 1 0/0 1\\n0/", "a line of its data has too few numbers"},
        {"s/^3 0 1 2/3 0 1\\n2/", "a line of its data has too few numbers"},
        {"s/^0 1 0/0 \\v1 0/", "a line of its data has too few numbers"},
        {"s/^property list/property uchar a\\n&/; s/^3/1 \\v&/", "a line of its data has too few numbers"},
        {"s/^3 0 1 2/3 0 1.0 2/", "a number is not whole"},
        {"s/^3 0 1 2/+3 0 1 2/", "a list's length is not a number from 0 on"},
        {"s/^property float x/property uchar red\\n&/; s/^[0-9] [0-9] [0-9]$/9.5 &/", "a number is not whole"},
        {"s/^property float x/property uchar red\\n&/; s/^[0-9] [0-9] [0-9]$/+9 &/", "a number is not whole"},
        {"/^0 0 0/N; s/^0 0 0\\n/0 0 0 /", "it ends before all that its header promises"},
        {"s/^property float y/comment TextureFile a.png\\n&/",
         "a comment that names a texture stands among properties"},
        {"s/^end_header/element a 0\\nelement b 0\\nelement c 0\\nelement d 0\\nelement e 0\\nelement f 0\\nelement g "
         "0\\n"
         "element h 0\\nelement i 0\\nelement j 0\\nelement k 0\\nelement l 0\\nelement m 0\\nelement n 0\\nelement o "
         "0\\n&/",
         "its header has more than 16 elements"},
        {"/^element face/,/^property list/d; /^3/d", "it has no faces"},
        {"s/^element face 2/element face 0/; /^3/d", "it has no faces"},
        {"s/vertex_indices/corners/", "it has no faces"},
        {"s/vertex_in/&\\x00/", "its header is damaged"}};
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) {
        char line[500];
        snprintf(line, sizeof line, "sed '%s' a.ply >odd.ply && $GLINT bake --mesh odd.ply -o no.c", edits[i][0]);
        assert_fails(line, edits[i][1]);
    }
    assert_false(exists("no.c"));
}

/* ---- STL ---- */

#define FACET(z) "facet normal 0 0 1\nouter loop\nvertex 0 0 " #z "\nvertex 0 1 1\nvertex 2 0 0\nendloop\nendfacet\n"

static void a_text_stl_without_its_end_is_refused_wherever_it_is_cut(void **state)
{
    (void)state;
    static const char text[] = "solid a\n" FACET(0) "endsolid a\nsolid b\n" FACET(1) FACET(2) "endsolid b";
    static const char *const whole[] = {
        "s/solid.*/solid/", "s/^/  /; $s/$/ \\t \\r\\n\\n \\n/", "s/$/\\r/", "s/endsolid/ENDSOLID/", "s/.*/\\U&/",
        "s/normal 0 0 1/normal -1.#IND 1.#QNAN0 1.#INF/", "s/endsolid/end solid/", "$s/$/\\nfacets: 3/",
        "s/\\(.*solid\\).*/\\1 facet solid/", "s/^solid.*/& facet endsolid solid/", "/^endsolid a/d; /^solid b/d",
        "$s/$/\\x00\\x00/", "1s/^/\\n\\xEF\\xBB\\xBF/; 1s/^\\n//", "1s/^/\\n\\n/",
        /* without normals, or with too few numbers of one */
        "s/ normal 0 0 1//", "s/ normal 0 0 1/ normal/", "s/normal 0 0 1$/normal 0 0/", "0,/ normal/ s/ normal 0 0 1//",
        "s/normal 0 0 1/normal nan(ind) -nan(ind) INF/",
        /* all on one line */
        ":a; N; $!ba; s/\\n/ /g", ":a; N; $!ba; s/\\n/\\t \\t/g; s/solid [ab]/solid/g",
        ":a; N; $!ba; s/\\n/ /g; s/solid a/& facet of a solid/g", ":a; N; $!ba; s/\\n/ /g; s/ normal 0 0 1//2",
        /* a solid behind another's end, and bytes of zero between words */
        ":a; N; $!ba; s/\\nsolid/ solid/", ":a; N; $!ba; s/\\nsolid/ solid solid/", "s/^facet/\\x00&/",
        "s/^facet/\\x00\\x00 \\x00&/; s/^vertex /&\\x00/; s/loop/\\x00&/; s/^endsolid a/&\\x00/"};
    write_text("a.stl", text);
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++) {
        char made[200];
        snprintf(made, sizeof made, "sed '%s' a.stl >made.stl && ! cmp -s a.stl made.stl", whole[i]);
        assert_same_mesh("a.stl", made);
        if (strstr(whole[i], "$!ba"))
            assert_same_piped(); /* no line begins with a word of a facet */
    }
    const size_t ends[] = {(size_t)(strstr(text, "endsolid a") - text), strlen(text) - 2};
    for (size_t cut = 9; cut < ends[1]; cut += 9) {
        char line[200];
        if (cut >= ends[0] + 8 && cut < ends[0] + strlen("endsolid a\nsolid"))
            continue; /* a whole solid */
        snprintf(line, sizeof line, "head -c %zu a.stl >cut.stl && $GLINT bake --mesh cut.stl -o no.c", cut);
        assert_fails(line, "cut.stl: libassimp cannot read this mesh: it ends without endsolid: a part is missing");
    }
    write_text("cut.stl", "solid a\nendsolid a\n");
    assert_fails("$GLINT bake --mesh cut.stl -o no.c", "it has no facets");
    assert_fails("sed 's/ normal 0 0 1//; /loop/d' a.stl >cut.stl && $GLINT bake --mesh cut.stl -o no.c",
                 "a facet has no normal, and no outer loop");
}

static void a_binary_stl_may_have_bytes_behind_its_facets(void **state)
{
    (void)state;
    assert_quiet(
        "{ printf 'solid %074d\\1\\0\\0\\0' 0; head -c 24 /dev/zero; printf '\\0\\0\\200\\077'; head -c 12 /dev/zero; "
        "printf '\\0\\0\\200\\077'; head -c 6 /dev/zero; } >binary.stl");
    assert_same_mesh("binary.stl", "{ cat binary.stl; echo; } >made.stl");
    assert_same_mesh("binary.stl", "{ cat binary.stl; head -c 512 /dev/zero; } >made.stl");
}

static void a_binary_stl_without_facets_or_with_other_bytes_than_its_head_says_is_refused(void **state)
{
    (void)state;
    static const char *const files[][2] = {
        {"head -c 84 /dev/zero", "it has no facets; export it again"},
        {"{ printf 'solid'; head -c 79 /dev/zero; }", "it has no facets; export it again"},
        {"head -c 134 /dev/zero", "its head says that it has no facets, but more follows; export it again"},
        {"head -c -9 binary.stl | sed '1s/solid/about/'",
         "it is neither a text that begins with solid nor as long as its head says"},
        {"echo a", "it is neither a text that begins with solid nor as long as its head says"}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char line[200];
        snprintf(line, sizeof line, "%s >odd.stl && $GLINT bake --mesh odd.stl -o no.c", files[i][0]);
        assert_fails(line, files[i][1]);
    }
}

/* ---- other files ---- */

/* libassimp would read them, unchecked. */
static void a_gltf_that_begins_as_another_format_is_refused(void **state)
{
    (void)state;
    write_text("a.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
    write_text("a.stl", "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0 1\nendloop\n"
                        "endfacet\nendsolid a\n");
    write_text("a.text", "glT");
    write_text("a.blank", " \n \n");
    write_text("a.loop",
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\npropererty list uchar i\n 0 0 2 3\n");
    static const char *const files[] = {"obj", "stl", "ply", "text", "blank", "loop"}, *const endings[] = {"gltf",
                                                                                                           "glb"};
    for (size_t i = 0; i < 2 * sizeof files / sizeof *files; i++) {
        char line[200], wanted[100];
        snprintf(line, sizeof line, "cp a.%s b.%s && $GLINT bake --mesh b.%s -o no.c", files[i / 2], endings[i % 2],
                 endings[i % 2]);
        snprintf(wanted, sizeof wanted, "b.%s: does not begin as a .%s does", endings[i % 2], endings[i % 2]);
        assert_fails(line, wanted);
    }
}

static void a_mesh_that_is_text_in_utf_16_is_said_to_be(void **state)
{
    (void)state;
    static const char *const endings[] = {"obj", "stl", "ply", "gltf"}, *const ways[] = {"utf16.%s", "- <utf16.%s"},
                             *const encodings[] = {"UTF-16", "UTF-16BE"};
    write_text("a.gltf", "{\"asset\":{\"version\":\"2.0\"}}");
    write_text("a.ply", PLY_VERTICES PLY_FACES "0 0 0\n2 0 0\n0 1 0\n2 2 1\n3 0 1 2\n3 1 2 3\n");
    for (size_t i = 0; i < 16; i++) {
        char name[20], line[200];
        snprintf(name, sizeof name, ways[i / 4 % 2], endings[i % 4]);
        snprintf(line, sizeof line,
                 "{ printf '%s'; iconv -f UTF-8 -t %s a.%s; } >utf16.%s && $GLINT bake --mesh %s -o no.c",
                 i / 8 ? "\\376\\377" : "", encodings[i / 8], endings[i % 4], endings[i % 4], name);
        assert_fails(line, "is text in UTF-16; save it as UTF-8");
    }
}

static void a_mark_of_utf_8_may_stand_before_a_mesh(void **state)
{
    (void)state;
    write_text(
        "b.gltf",
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{\"bufferView\":0,"
        "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:;base64,AAAAAAAAAAAAAAAAAAAAQAAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}");
    assert_same_mesh("b.gltf", "{ printf '\\357\\273\\277'; cat b.gltf; } >made.gltf");
    assert_same_piped();
    assert_same_mesh("a.obj", "{ printf '\\357\\273\\277'; cat a.obj; } >made.obj");
    assert_same_mesh("a.ply", "{ printf '\\357\\273\\277'; cat a.ply; } >made.ply");
    assert_same_piped();
}

/* ---- OBJ ---- */

/* Draws a.obj, whose line of MTLs is this, and says the line, or nothing; whether triangles of materials a and b are red and green. */
static void assert_libraries(const char *line, const char *said, bool is_red, bool is_green)
{
    char command[300];
    uint8_t bytes[13 + 40 * 20 * 3];
    setenv("line", line, 1);
    snprintf(
        command, sizeof command,
        "{ echo \"$line\"; cat plain.obj; } >a.obj && $GLINT render --mesh a.obj --size 40x20 --image ppm -o a.ppm");
    const struct run *result = run(command);
    assert_int_equal(result->status, 0);
    assert_string_equal(result->err, said);
    assert_int_equal(read_file("a.ppm", bytes, sizeof bytes), sizeof bytes);
    unsigned red = 0, green = 0;
    for (size_t i = 13; i < sizeof bytes; i += 3) {
        red += bytes[i] > bytes[i + 1] + 60;
        green += bytes[i + 1] > bytes[i] + 60;
    }
    assert_int_equal(red > 20, is_red);
    assert_int_equal(green > 20, is_green);
}

static void an_obj_has_the_materials_of_each_file_that_is_there_and_a_line_for_others(void **state)
{
    (void)state;
    write_text("plain.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nusemtl a\nf 1 2 3\nusemtl b\nf 2 4 3\n");
    write_text("red.mtl", "newmtl a\nKd 1 0 0\n");
    write_text("green.mtl", "newmtl b\nKd 0 1 0\n");
    write_text("two words.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n");
    assert_quiet("truncate -s 17M large.mtl");
    assert_libraries("mtllib red.mtl", "", true, false);
    assert_libraries("mtllib red.mtl green.mtl", "", true, true);
    assert_libraries("mtllib\tred.mtl  ./green.mtl # both", "", true, true);
    assert_libraries("mtllib red.mtl\nmtllib green.mtl", "", true, true);
    assert_libraries("mtllib two words.mtl", "", true, true);
    assert_libraries("mtllib none.mtl\nmtllib none.mtl",
                     "glint: a.obj: names none.mtl, which is left out: No such file or directory\n", false, false);
    assert_libraries("mtllib none.mtl green.mtl",
                     "glint: a.obj: names none.mtl, which is left out: No such file or directory\n", false, true);
    assert_libraries("mtllib no words.mtl",
                     "glint: a.obj: names no words.mtl, which is left out: No such file or directory\n", false, false);
    assert_libraries("mtllib large.mtl", "glint: a.obj: names large.mtl, which is left out: it has more than 16 MB\n",
                     false, false);
}

/* As if the places in the picture were these. */
static void an_mtls_picture_is_scaled_and_moved_and_other_options_are_said(void **state)
{
    (void)state;
    static const char *const same[][2] = {{"-s .5 .25 1", "u * .5, v * .25"},
                                          {"-s .5", "u * .5, v"},
                                          {"-o .5 .25 0", "u + .5, v + .25"},
                                          {"-clamp off -o .25 -s .5 .5", "u * .5 + .25, v * .5"},
                                          {"-mm 0 1 -t 0 0 0 -o 0 0 0 -s 1 1 1 -bm 1", "u, v"}};
    static const char *const said[][2] = {
        {"-mm .5 2 -s 1", "the option -mm of a map_Kd is left out"},
        {"-t 1", "the option -t of a map_Kd is left out"},
        {"-what 1", "the picture behind the unknown option -what of a map_Kd is left out"}};
    static const char square[] =
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt .5 0\nvt .5 .5\nvt 0 .5\nusemtl a\n"
        "f 1/1 2/2 3/3 4/4\n";
    uint16_t samples[64];
    for (unsigned i = 0; i < 64; i++)
        samples[i] = (uint16_t)(i * i * 31 % 256);
    make_png("map.png", &(struct made_png){.width = 8, .height = 8, .bits = 8, .samples = samples});
    write_text("square.obj", square);
    write_text("wanted.mtl", "newmtl a\nmap_Kd map.png\n");
    for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
        setenv("options", same[i][0], 1);
        setenv("places", same[i][1], 1);
        assert_quiet("{ echo mtllib wanted.mtl; awk \"/^vt/ { u = \\$2; v = \\$3; print \\\"vt\\\", $places; next } "
                     "1\" square.obj; } >wanted.obj && "
                     "{ echo mtllib made.mtl; cat square.obj; } >made.obj && printf 'newmtl a\nmap_Kd %s map.png\n' "
                     "\"$options\" >made.mtl && "
                     "for i in wanted made; do $GLINT render --mesh $i.obj --size 40x40 -o $i.ppm || exit 1; done");
        assert_same_file("wanted.ppm", "made.ppm");
    }
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
        setenv("options", said[i][0], 1);
        const struct run *result = run("printf 'newmtl a\nmap_Kd %s map.png\n' \"$options\" >made.mtl && "
                                       "$GLINT render --mesh made.obj --size 40x40 -o made.ppm");
        char line[200];
        snprintf(line, sizeof line, "glint: made.obj: %s\n", said[i][1]);
        assert_string_equal(result->err, line);
        assert_int_equal(result->status, 0);
    }
}

/* The time that the process which reads them has is not enough where each is read to its end again. */
static void an_mtl_of_many_options_or_named_many_times_is_read_soon(void **state)
{
    (void)state;
    assert_quiet(
        "echo 'v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3' >triangle.obj && "
        "{ printf 'newmtl a\nKd .1 .9 .1\nmap_Kd'; yes ' -s 1 1 1' | head -n 400000 | tr -d '\n'; } >long.mtl && "
        "{ echo newmtl a; yes Kd .1 .9 .1 | head -n 80000; } >often.mtl && "
        "{ echo mtllib long.mtl; cat triangle.obj; } >long.obj && "
        "{ yes mtllib often.mtl | head -n 20000; cat triangle.obj; } >often.obj && "
        "$GLINT render --mesh long.obj --size 9x9 -o long.ppm");
    const struct run *result = run("$GLINT render --mesh often.obj --size 9x9 -o often.ppm");
    assert_string_equal(result->err,
                        "glint: often.obj: names more than 64 MB of materials; what comes then is left out\n");
    assert_int_equal(result->status, 0);
    assert_same_file("long.ppm", "often.ppm");
}

/* As maps of the earth have them: floats there are half a metre apart. */
static void a_mesh_far_from_its_origin_is_drawn_as_it_is_or_said_to_be_rounded(void **state)
{
    (void)state;
    write_text("near.obj", "v 0.1 0 0\nv 0.9 0.3 0\nv 0.4 0.8 0\nv 0.7 0.9 0.5\nf 1 3 2\nf 3 4 2\n");
    assert_same_mesh("near.obj", "sed 's/^v 0/v 5412345/' near.obj >made.obj");
    assert_quiet("printf '" PLY_VERTICES PLY_FACES "0 0 0\n2 0 0\n0 1 0\n2 2 1\n3 0 1 2\n3 1 2 3\n' >a.ply && "
                 "sed 's/^\\([02]\\) \\([012] [01]\\)$/4000\\1 \\2/' a.ply >far.ply && "
                 "sed 's/^\\([02]\\) \\([012] [01]\\)$/400\\1 \\2/' a.ply >less.ply && "
                 "for i in far less; do $GLINT render --mesh $i.ply --size 9x9 -o $i.ppm 2>$i || exit 1; done; "
                 "grep -q '^glint: far.ply: lies so far from its origin' far && ! grep . less");
}

static void colours_of_an_objs_vertices_go_to_1_or_to_255(void **state)
{
    (void)state;
    write_text("one.obj", "v 0 0 0 1 .2 0\nv 2 0 0 .4 1 0\nv 0 2 0 0 .6 1\nf 1 2 3\n");
    assert_same_mesh("one.obj",
                     "sed 's/ 1 .2 0$/ 255 51 0/; s/ .4 1 0$/ 102 255 0/; s/ 0 .6 1$/ 0 153 255/' one.obj >made.obj");
    assert_same_mesh("one.obj", "sed 's/ 1 .2 0$/ 1.001 .2 0/' one.obj >made.obj"); /* rounded */
}

/* ---- textures and normals ---- */

static void a_normal_that_is_no_number_is_as_if_it_had_no_length(void **state)
{
    (void)state;
    static const char *const odd[] = {"nan nan nan", "0 nan 1", "0 0 1e999", "inf 0 0", "-1.#IND 1.#QNAN0 1.#INF"};
    write_text("normals.obj",
               "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nvn 0 0 -1\nvn 0 0 0\nf 1//1 2//1 3//2\nf 2//1 4//1 3//1\n");
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
        setenv("odd", odd[i], 1);
        assert_quiet("sed \"s/^vn 0 0 0/vn $odd/\" normals.obj >odd.obj && for i in normals odd; do "
                     "$GLINT bake --mesh $i.obj --flip-faces --to int16 --as raw -o $i.bin 2>said >report || exit 1; "
                     "done; cmp normals.bin odd.bin");
    }
}

/* A corner has its normal where the file has one, and what the faces around it make where it has none. */
static void corners_without_normals_take_none_from_others(void **state)
{
    (void)state;
    write_text("some.obj",
               "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 9 0 0\nv 11 0 0\nv 9 2 0\nvn 0 .6 .8\nf 1//1 2//1 3//1\nf 4 5 6\n");
    assert_same_mesh("some.obj", "sed 's/^f 4 5 6/vn 0 0 1\\nf 4\\/\\/2 5\\/\\/2 6\\/\\/2/' some.obj >made.obj");
    assert_same_mesh("some.obj", "sed 's/^f 4 5 6/vn 0 0 0\\nf 4\\/\\/2 5 6\\/\\/2/' some.obj >made.obj");
}

/* A tube whose normals turn by 40 degrees over an edge, and a triangle that has normals in one file. */
static void normals_of_some_corners_do_not_spare_a_file_its_splits(void **state)
{
    (void)state;
    enum { SIDES = 9 };
    FILE *file = fopen("none.obj", "w");
    assert_non_null(file);
    fputs("vn 1 0 0\nv 9 0 0\nv 9 1 0\nv 9 0 1\n", file);
    for (int i = 0; i < 2 * SIDES; i++)
        fprintf(file, "v %.7f %.7f %d\n", cos(2 * M_PI * (i / 2) / SIDES), sin(2 * M_PI * (i / 2) / SIDES), i % 2);
    for (int i = 0; i < SIDES; i++) {
        const int at = 4 + 2 * i, next = 4 + 2 * ((i + 1) % SIDES);
        fprintf(file, "f %d %d %d %d\n", at, next, next + 1, at + 1);
    }
    fputs("f 1 2 3\n", file);
    assert_int_equal(fclose(file), 0);
    assert_same_mesh("none.obj", "sed 's/^f 1 2 3/f 1\\/\\/1 2\\/\\/1 3\\/\\/1/' none.obj >made.obj");
    assert_contains(run("$GLINT bake --mesh made.obj")->out, "--split 30 made these of");
    assert_same_mesh("none.obj", "sed 's/^f 1 2 3/f 1 2\\/\\/1 3/' none.obj >made.obj");
}

/* A copy of it a colour: 72 million pixels. */
static void textures_in_many_colours_have_a_limit_of_memory(void **state)
{
    (void)state;
    enum { SIDE = 2048, MATERIALS = 18 };
    uint16_t *samples = calloc(SIDE * SIDE, sizeof *samples);
    assert_non_null(samples);
    make_png("big.png", &(struct made_png){.width = SIDE, .height = SIDE, .bits = 1, .samples = samples});
    free(samples);
    FILE *obj = fopen("many.obj", "w"), *mtl = fopen("many.mtl", "w");
    assert_true(obj && mtl);
    fputs("mtllib many.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n", obj);
    for (int i = 0; i < MATERIALS; i++) {
        fprintf(obj, "usemtl m%d\nf 1/1 2/2 3/3\n", i);
        fprintf(mtl, "newmtl m%d\nKd %g .5 .5\nmap_Kd big.png\n", i, (1 + i % 17) / 20.);
    }
    assert_int_equal(fclose(obj) | fclose(mtl), 0);
    assert_fails("$GLINT render --mesh many.obj --size 9x9 -o no.ppm",
                 "many.obj: its textures, one for each colour of a material, have more than 67108864 pixels");
    assert_quiet("$GLINT render --mesh many.obj --no-textures --size 9x9 -o many.ppm");
}

/* It takes as long under each name. */
static void a_damaged_texture_under_many_names_takes_no_endless_time(void **state)
{
    (void)state;
    enum { SIDE = 5792 };
    uint16_t *samples = calloc(SIDE * SIDE, sizeof *samples);
    assert_non_null(samples);
    make_png("whole.png", &(struct made_png){.width = SIDE, .height = SIDE, .bits = 1, .samples = samples});
    free(samples);
    write_text("cut.obj", "mtllib cut.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                          "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\nusemtl c\nf 1/1 2/2 3/3\n");
    write_text("cut.mtl", "newmtl a\nmap_Kd cut.png\nnewmtl b\nmap_Kd ./cut.png\nnewmtl c\nmap_Kd ././cut.png\n");
    const struct run *result = run("head -c -20 whole.png >cut.png && $GLINT render --mesh cut.obj -o no.ppm");
    assert_int_equal(result->status, 1);
    assert_contains(result->err, "cut.obj: texture ./cut.png is left out: damaged PNG");
    assert_contains(result->err,
                    "cut.obj: its textures have more than 67108864 pixels, those that are left out counted");
}

static void places_in_a_picture_matter_only_where_there_is_one(void **state)
{
    (void)state;
    uint16_t samples[4] = {0, 99, 200, 255};
    make_png("small.png", &(struct made_png){.width = 2, .height = 2, .bits = 8, .samples = samples});
    write_text("places.mtl", "newmtl a\nmap_Kd small.png\nnewmtl b\n");
    write_text("places.obj", "mtllib places.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 2 0\nvt 0 0\nvt 1 0\nvt 9e6 nan\n"
                             "usemtl a\nf 1/1 2/2 3/1\nusemtl b\nf 2/3 4/3 3/3\n");
    assert_quiet("$GLINT render --mesh places.obj --size 9x9 -o places.ppm");
    assert_fails("sed 's/usemtl b/usemtl a/' places.obj >odd.obj && $GLINT render --mesh odd.obj --size 9x9 -o no.ppm",
                 "triangle 2 has a texture coordinate that is not a number below 10^6");
}

/* A fan whose blades do not touch but in its middle, and a wall of as many tiles: of these, side by side, few are compared with each other. */
static void the_search_for_edges_side_by_side_has_a_limit_of_steps(void **state)
{
    (void)state;
    assert_quiet(
        "awk 'BEGIN { print \"v 0 0 0\"; for (i = 0; i < 20000; i++) { a = i * 6.283185307 / 20000; b = a + .0002; "
        "print \"v\", cos(a), sin(a), 0; print \"v\", cos(b), sin(b), 0; print \"f 1 -2 -1\" } }' >fan.obj && "
        "awk 'BEGIN { for (i = 0; i < 20000; i++) { y = i % 141; z = int(i / 141); print \"v 0\", y, z; "
        "print \"v 0\", y + .5, z; print \"v 0\", y, z + .5; print \"f -3 -2 -1\" } }' >wall.obj && "
        "$GLINT render --mesh wall.obj --turn 0,90,0 --flip-faces --size 9x9 -o wall.ppm 2>said; ! grep open said");
    const struct run *result = run("$GLINT render --mesh fan.obj --size 9x9 -o fan.ppm");
    assert_int_equal(result->status, 0);
    assert_contains(result->err, "fan.obj: has too many open edges to find which lie side by side");
}
#endif

static void nothing_is_left_behind(void **state)
{
    (void)state;
    assert_false(exists("no.c") || exists("no.h") || exists("no.ppm"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
#if GLINT_WITH_MESH
        cmocka_unit_test(a_ply_is_read_whatever_it_holds_beside_places_and_faces),
        cmocka_unit_test(a_binary_ply_is_read_whatever_it_holds_beside_places_and_faces),
        cmocka_unit_test(a_ply_is_read_whatever_it_holds_before_places_and_faces),
        cmocka_unit_test(a_face_with_dents_is_drawn_alike_whatever_the_format),
        cmocka_unit_test(places_in_a_texture_that_faces_of_a_ply_have_of_their_own_are_left_out_with_a_line),
        cmocka_unit_test(a_ply_that_libassimp_would_read_as_another_shape_is_refused),
        cmocka_unit_test(a_text_stl_without_its_end_is_refused_wherever_it_is_cut),
        cmocka_unit_test(a_binary_stl_may_have_bytes_behind_its_facets),
        cmocka_unit_test(a_binary_stl_without_facets_or_with_other_bytes_than_its_head_says_is_refused),
        cmocka_unit_test(a_gltf_that_begins_as_another_format_is_refused),
        cmocka_unit_test(a_mesh_that_is_text_in_utf_16_is_said_to_be),
        cmocka_unit_test(a_mark_of_utf_8_may_stand_before_a_mesh),
        cmocka_unit_test(glint_bake_writes_what_is_compared_here),
        cmocka_unit_test(an_obj_has_the_materials_of_each_file_that_is_there_and_a_line_for_others),
        cmocka_unit_test(an_mtls_picture_is_scaled_and_moved_and_other_options_are_said),
        cmocka_unit_test(an_mtl_of_many_options_or_named_many_times_is_read_soon),
        cmocka_unit_test(colours_of_an_objs_vertices_go_to_1_or_to_255),
        cmocka_unit_test(a_mesh_far_from_its_origin_is_drawn_as_it_is_or_said_to_be_rounded),
        cmocka_unit_test(a_normal_that_is_no_number_is_as_if_it_had_no_length),
        cmocka_unit_test(corners_without_normals_take_none_from_others),
        cmocka_unit_test(normals_of_some_corners_do_not_spare_a_file_its_splits),
        cmocka_unit_test(textures_in_many_colours_have_a_limit_of_memory),
        cmocka_unit_test(a_damaged_texture_under_many_names_takes_no_endless_time),
        cmocka_unit_test(places_in_a_picture_matter_only_where_there_is_one),
        cmocka_unit_test(the_search_for_edges_side_by_side_has_a_limit_of_steps),
#endif
        cmocka_unit_test(nothing_is_left_behind),
    };
    return cmocka_run_group_tests_name("mesh readers", tests, scratch_make, scratch_remove);
}
