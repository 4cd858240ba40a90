/* SPDX-License-Identifier: MIT
 * What libassimp makes of a glTF that is not what the file says is refused, or made right. */
#include "files.h"

#if GLINT_WITH_MESH
#define VIEW(from, bytes, more) "{\"buffer\":0,\"byteOffset\":" #from ",\"byteLength\":" #bytes more "}"
#define ACCESSOR(view, kind, count, type)                                                                              \
    "{\"bufferView\":" #view ",\"componentType\":" #kind ",\"count\":" #count ",\"type\":\"" type "\"}"

/* Four triangles about four places, with all that the tests put in their place. */
static int make_base(void **state)
{
    static const float places[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1.5f}},
                       normals[4][3] = {{-.6f, -.6f, -.5f}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                       uv[4][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    static const uint16_t corners[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, /* and each triangle the other way */
        turned[12] = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}, odd[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 4};
    static const int8_t bytes[4][4] = {{-76, -76, -64}, {127, 0, 0}, {0, 127, 0}, {0, 0, 127}};
    float steps[4][5] = {{0}}, mirrored[4][3];
    if (scratch_make(state) != 0)
        return -1;
    for (int i = 0; i < 12; i++)
        steps[i / 3][i % 3] = places[i / 3][i % 3], mirrored[i / 3][i % 3] = (i % 3 ? 1 : -1) * places[i / 3][i % 3];
    FILE *file = fopen("base.bin", "wb");
    const bool good = fwrite(places, 48, 1, file) && fwrite(corners, 24, 1, file) && fwrite(normals, 48, 1, file) &&
                      fwrite(uv, 32, 1, file) && fwrite(bytes, 16, 1, file) && fwrite(steps, 80, 1, file) &&
                      fwrite(odd, 24, 1, file) && fwrite(turned, 24, 1, file) && fwrite(mirrored, 48, 1, file);
    if (!good || fclose(file) != 0)
        return -1;
    write_text("base.gltf",
               "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
               "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":2},\"indices\":1}]}],"
               "\"buffers\":[{\"byteLength\":344,\"uri\":\"base.bin\"}],\"bufferViews\":[" VIEW(0, 48, "") "," VIEW(
                   48, 24, "") "," VIEW(72, 48,
                                        "") "," VIEW(120, 32,
                                                     "") "," VIEW(152, 16,
                                                                  ",\"byteStride\":4") "," VIEW(168,
                                                                                                80, ",\"byteStride\":20") "," VIEW(248, 24, "") "," VIEW(272, 24, "") "," VIEW(296, 48, "") "],\"accessors\":[" ACCESSOR(0, 5126, 4, "VEC3") "," ACCESSOR(1, 5123, 12, "SCALAR") "," ACCESSOR(2,
                                                                                                                                                                                                                                                                                              5126,
                                                                                                                                                                                                                                                                                              4,
                                                                                                                                                                                                                                                                                              "VEC3") "," ACCESSOR(3,
                                                                                                                                                                                                                                                                                                                   5126,
                                                                                                                                                                                                                                                                                                                   4,
                                                                                                                                                                                                                                                                                                                   "VEC2") "," ACCESSOR(4, 5120, 4, "VEC3") "," ACCESSOR(4, 5121, 4, "VEC2") "," ACCESSOR(5,
                                                                                                                                                                                                                                                                                                                                                                                                          5126, 4, "VEC3") "," ACCESSOR(6, 5123, 12, "SCALAR") "," ACCESSOR(7,
                                                                                                                                                                                                                                                                                                                                                                                                                                                                            5123,
                                                                                                                                                                                                                                                                                                                                                                                                                                                                            12,
                                                                                                                                                                                                                                                                                                                                                                                                                                                                            "SCALAR") "," ACCESSOR(8,
                                                                                                                                                                                                                                                                                                                                                                                                                                                                                                   5126,
                                                                                                                                                                                                                                                                                                                                                                                                                                                                                                   4,
                                                                                                                                                                                                                                                                                                                                                                                                                                                                                                   "VEC3") "]}");
    return 0;
}

/* With one angle of splits: the usual one depends on whether all parts have normals. */
#define RENDER "$GLINT render --size 60x50 --turn 20,30,0 --split 45 --mesh "

/* `edit`: sed's, of base.gltf. */
static void assert_edited_fails(const char *edit, const char *part)
{
    char line[400];
    snprintf(line, sizeof line, "sed '%s' base.gltf >a.gltf; ! cmp -s a.gltf base.gltf && " RENDER "a.gltf -o no.ppm",
             edit);
    assert_fails(line, part);
}

static void assert_drawn_alike(const char *edit, const char *other)
{
    char line[800];
    snprintf(line, sizeof line,
             "sed '%s' base.gltf >a.gltf; sed '%s' base.gltf >b.gltf; " RENDER "a.gltf -o a.ppm && " RENDER
             "b.gltf -o b.ppm && cmp a.ppm b.ppm",
             edit, other);
    assert_quiet(line);
}

static void numbers_that_libassimp_takes_for_others_are_refused(void **state)
{
    (void)state;
    static const char kind[] = "it has numbers of a kind that libassimp misreads; export it with floats";
    assert_edited_fails("s/\"NORMAL\":2/\"NORMAL\":4/", kind);
    assert_edited_fails("s/\"NORMAL\":2/\"TEXCOORD_0\":5/", kind);
    assert_edited_fails("s/\"NORMAL\":2/\"TEXCOORD_0\":3,\"TEXCOORD_1\":5/", kind);
    assert_edited_fails("s/\"NORMAL\":2/\"COLOR_0\":4/", kind);
    assert_edited_fails("s/5126/5122/", kind); /* places */
    assert_edited_fails("s/5123/5122/", kind); /* indices */
    assert_edited_fails("s/5126/\"5126\"/", "it is damaged");
    assert_edited_fails("s/\"count\":4/\"count\":4.0/", "it is damaged");
    assert_drawn_alike("s/\"POSITION\":0/\"POSITION\":6/", ""); /* steps of 20 bytes */
    assert_drawn_alike("s/\"NORMAL\":2/&,\"TANGENT\":4,\"_OWN\":5/", "");
}

static void numbers_beyond_their_view_or_too_few_are_refused(void **state)
{
    (void)state;
    assert_edited_fails("s/\"accessors\":.{/&\"byteOffset\":12,/", "it is damaged; export it again");
    assert_edited_fails("s/\"byteStride\":20/\"byteStride\":24/;s/\"POSITION\":0/\"POSITION\":6/", "it is damaged");
    assert_edited_fails("s/\"byteStride\":20/\"byteStride\":4/;s/\"POSITION\":0/\"POSITION\":6/", "it is damaged");
    assert_edited_fails("s/\"count\":4/\"count\":3/2", "it is damaged"); /* normals, which would be left out */
    assert_edited_fails("s/\"count\":4/\"count\":0/", "it is damaged");
    assert_edited_fails("s/\"indices\":1/\"indices\":99/", "it is damaged");
    assert_edited_fails("s/\"mesh\":0/\"mesh\":1/", "it is damaged");
    assert_edited_fails("s/{\"mesh\":0}/{\"mesh\":0,\"children\":[0]}/", "it is damaged");
    assert_edited_fails("s/\"accessors\":.{\"bufferView\":0,/\"accessors\":[{/", "it is damaged");
    assert_edited_fails("s/\"accessors\":.{/&\"byteOffset\":-4,/", "it is damaged");
    assert_edited_fails("s/\"byteLength\":48/\"byteLength\":\"48\"/", "it is damaged");
    assert_edited_fails("s/\"byteStride\":20/\"byteStride\":null/;s/\"POSITION\":0/\"POSITION\":6/", "it is damaged");
    assert_edited_fails("s/\"count\":12/\"count\":2/", "it is damaged"); /* not a triangle */
    assert_edited_fails("s/\"type\":\"VEC3\"/\"type\":3/", "it is damaged");
}

static void what_is_not_what_a_gltf_has_there_is_refused(void **state)
{
    (void)state;
    static const char *const edits[] = {"s/\"POSITION\":0,//",
                                        "s/\"NORMAL\":2/\"NORMAL\":\"2\"/",
                                        "s/\"attributes\":{[^}]*}/\"attributes\":7/",
                                        "s/\"primitives\":.{/\"primitives\":[7,{/",
                                        "s/\"indices\":1/&,\"mode\":7/",
                                        "s/\"indices\":1/&,\"mode\":\"4\"/",
                                        "s/\"indices\":1/\"indices\":-1/",
                                        "s/\"primitives\":.\\(.*\\)],\"buffers\"/\"primitives\":{}}],\"buffers\"/",
                                        "s/\"nodes\":.0./\"nodes\":[0.5]/",
                                        "s/\"nodes\":.0./\"nodes\":[1]/",
                                        "s/\"mesh\":0/\"mesh\":[0]/",
                                        "s/\"scene\":0/\"scene\":{}/",
                                        "s/\"asset\":{[^}]*}/\"asset\":{}/"};
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++)
        assert_edited_fails(edits[i], "it is damaged");
}

static void a_triangle_with_a_corner_that_the_file_does_not_have_is_refused(void **state)
{
    (void)state;
    static const char part[] = "a face names a vertex that the file does not have; repair the mesh, or export it again";
    assert_edited_fails("s/\"indices\":1/\"indices\":7/", part);
    assert_edited_fails("s/\"indices\":1/\"indices\":7,\"mode\":5/", part);
    assert_edited_fails("s/\"indices\":1}/&,{\"attributes\":{\"POSITION\":0},\"indices\":7}/", part);
    assert_edited_fails("s/{\"mesh\":0}/{\"children\":[1,1]},{\"mesh\":0}/;s/\"indices\":1/\"indices\":7/", part);
}

static void what_a_gltf_requires_and_glint_does_not_carry_out_is_refused(void **state)
{
    (void)state;
    assert_edited_fails("s/{/&\"extensionsRequired\":[\"KHR_materials_unlit\",\"EXT_meshopt_compression\"],/",
                        "it needs EXT_meshopt_compression; export it without");
    assert_edited_fails("s/{/&\"extensionsRequired\":[\"KHR_mesh_quantization\"],/", "it needs KHR_mesh_quantization");
    assert_edited_fails("s/{/&\"extensionsRequired\":[7],/", "it is damaged");
    assert_drawn_alike("s/{/&\"extensionsRequired\":[\"KHR_materials_unlit\",\"KHR_texture_transform\"],/", "");
    assert_drawn_alike("s/{/&\"extensionsUsed\":[\"EXT_meshopt_compression\"],/", "");
}

#define MATERIAL(coordinates, of_transform)                                                                            \
    "s/{/&\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"texCoord\":" coordinates       \
    ",\"extensions\":{\"KHR_texture_transform\":{\"texCoord\":" of_transform "}}}}}],/"

static void a_transform_that_names_other_coordinates_than_its_texture_is_refused(void **state)
{
    (void)state;
    assert_edited_fails(MATERIAL("0", "1"), "a texture's transform names other coordinates");
    assert_edited_fails(MATERIAL("1", "0"), "a texture's transform names other coordinates");
    assert_edited_fails(MATERIAL("0", "-1"), "it is damaged");
    assert_drawn_alike(MATERIAL("1", "1"), "");
}

static void skeletons_and_morph_targets_with_weights_are_refused(void **state)
{
    (void)state;
    static const char target[] = "s/\"indices\":1/&,\"targets\":[{\"POSITION\":2}]/;";
    char edit[200];
    assert_edited_fails("s/\"mesh\":0/&,\"skin\":0/", "it has a skeleton; export it without");
    snprintf(edit, sizeof edit, "%ss/{\"primitives\"/{\"weights\":[0.5],\"primitives\"/", target);
    assert_edited_fails(edit, "its morph targets have weights; apply them before you export it");
    snprintf(edit, sizeof edit, "%ss/\"mesh\":0/&,\"weights\":[1]/", target);
    assert_edited_fails(edit, "its morph targets have weights");
    snprintf(edit, sizeof edit,
             "%ss/{\"primitives\"/{\"weights\":[0.5],\"primitives\"/;s/\"mesh\":0/&,\"weights\":[0]/", target);
    assert_drawn_alike(edit, "");
    assert_drawn_alike(target, "");
}

static void mirrored_parts_show_their_outer_side(void **state)
{
    (void)state;
    static const char by_hand[] =
        "s/\"NORMAL\":2/\"TEXCOORD_0\":3/;s/\"POSITION\":0/\"POSITION\":9/;s/\"indices\":1/\"indices\":8/";
    assert_drawn_alike("s/\"NORMAL\":2/\"TEXCOORD_0\":3/;s/\"mesh\":0/&,\"scale\":[-1,1,1]/", by_hand);
    assert_drawn_alike("s/\"NORMAL\":2/\"TEXCOORD_0\":3/;"
                       "s/{\"mesh\":0}/{\"children\":[1],\"scale\":[1,1,-1]},{\"mesh\":0,\"scale\":[-1,1,-1]}/;"
                       "s/\"POSITION\":0/\"POSITION\":9/;s/\"indices\":1/\"indices\":8/",
                       "s/\"NORMAL\":2/\"TEXCOORD_0\":3/"); /* mirrored twice, by its parent, too, and by hand */
    assert_drawn_alike("s/\"NORMAL\":2/\"TEXCOORD_0\":3/;"  /* one mesh, both ways */
                       "s/{\"mesh\":0}/{\"children\":[1,2]},{\"mesh\":0},{\"mesh\":0,\"scale\":[-1,1,1]}/",
                       "s/\"NORMAL\":2/\"TEXCOORD_0\":3/;"
                       "s/\"indices\":1}/&,{\"attributes\":{\"POSITION\":9,\"TEXCOORD_0\":3},\"indices\":8}/");
    assert_edited_fails("s/\"mesh\":0/&,\"scale\":[1,1,0]/",
                        "its nodes make parts flat; apply their transforms before you export it");
}

static void parts_that_are_scaled_to_0_are_hidden(void **state)
{
    (void)state;
    assert_drawn_alike("s/{\"mesh\":0}/{\"children\":[1,2]},&,{\"children\":[3],\"scale\":[0,0,0]},{\"mesh\":0}/", "");
    assert_drawn_alike(
        "s/{\"mesh\":0}/{\"children\":[1,2]},&,{\"mesh\":0,\"matrix\":[0,0,0,0,0,0,0,0,0,0,0,0,1,2,3,1]}/", "");
    assert_drawn_alike(
        "s/{\"mesh\":0}/{\"children\":[1,2,3]},&,{\"mesh\":0,\"scale\":[0,0,0]},{\"mesh\":0,\"scale\":[-1,1,1]}/",
        "s/{\"mesh\":0}/{\"children\":[1,2]},&,{\"mesh\":0,\"scale\":[-1,1,1]}/");
}

static void bones_may_stand_a_thousand_deep(void **state)
{
    (void)state;
    static const char chain[] =
        "seq 1 %d | sed 's/.*/{\"children\":[&]},/' | tr -d '\\n' >chain; "
        "sed \"s/{\\\"mesh\\\":0}/$(cat chain)&/\" base.gltf >deep.gltf && " RENDER "deep.gltf -o a.ppm";
    char line[400];
    snprintf(line, sizeof line, chain, 1000);
    strcat(line, " && " RENDER "base.gltf -o b.ppm && cmp a.ppm b.ppm");
    assert_quiet(line);
    snprintf(line, sizeof line, chain, 1001);
    assert_fails(line, "it is damaged");
}

static void points_and_lines_take_no_normals_away(void **state)
{
    (void)state;
    assert_drawn_alike("s/\"indices\":1}/&,{\"attributes\":{\"POSITION\":0},\"mode\":1}/", "");
    assert_drawn_alike("s/\"indices\":1}/&,{\"attributes\":{\"POSITION\":0},\"mode\":0}/", "");
}

/* The second part is small, in the first one. */
static void parts_without_normals_take_none_from_others(void **state)
{
    (void)state;
#define WITH_SMALL(normal)                                                                                             \
    "s/\"nodes\":.0/&,1/; s/{\"mesh\":0}/&,{\"mesh\":1,\"scale\":[0.001,0.001,0.001],"                                 \
    "\"translation\":[0.2,0.2,0.2]}/; s/],\"buffers\"/,{\"primitives\":[{\"attributes\":{\"POSITION\":0" normal        \
    "},\"indices\":1}]}&/"
    assert_drawn_alike(WITH_SMALL(""), WITH_SMALL(",\"NORMAL\":2"));
}

static void numbers_of_any_size_may_stand_beside(void **state)
{
    (void)state;
    assert_drawn_alike("s/\"scene\":0/&,\"extras\":{\"a \\\\\\\\\\\\\" "
                       "b\":-123456789012345678901234567890,\"c\":[9223372036854775808]}/",
                       "s/x/x/");
    assert_edited_fails("s/\"scene\":0/&,\"extras\":1e999/", "it has a number that is too large");
    assert_edited_fails("s/\"scene\":0/\"scene\":9223372036854775808/", "damaged");
}

static void text_that_is_not_utf_8_is_said_to_be(void **state)
{
    (void)state;
    assert_edited_fails("s/\"scene\":0/&,\"extras\":\"K\\xE4se\"/", "it has text that is not UTF-8");
}

/* libassimp would take these characters for others. */
static void a_data_uri_is_base64_or_refused(void **state)
{
    (void)state;
    static const char *const edits[] = {"s/base64,....../&!/; s/!./!/", "s/base64,....../&-/; s/-./-/", "s/;base64//",
                                        "s/base64,/&=/"};
    assert_quiet("data=$(base64 -w0 base.bin) && sed \"s|base.bin|data:application/octet-stream;base64,$data|\" "
                 "base.gltf >data.gltf && " RENDER "data.gltf -o a.ppm && " RENDER
                 "base.gltf -o b.ppm && cmp a.ppm b.ppm");
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) {
        char line[300];
        snprintf(line, sizeof line,
                 "sed '%s' data.gltf >a.gltf; ! cmp -s a.gltf data.gltf && " RENDER "a.gltf -o no.ppm", edits[i]);
        assert_fails(line, "the data URI of a buffer is not base64");
    }
}

#define SPARSE(count, few, more)                                                                                       \
    ",\"sparse\":{\"count\":" #few ",\"indices\":{\"bufferView\":1,\"componentType\":5121},\"values\":{"               \
    "\"bufferView\":0" more "}}"

/* Numbers 0, 0, 2 are replaced by those of the first places: 0, 0 and, at last, 2. */
static void sparse_numbers_are_read_where_libassimp_reads_them(void **state)
{
    (void)state;
    static const char kind[] = "it has numbers of a kind that libassimp misreads";
    assert_drawn_alike("s/\"VEC3\"/&" SPARSE(4, 1, "") "/", "");
    assert_edited_fails("s/\"VEC3\"/&" SPARSE(4, 5, "") "/", kind);
    assert_edited_fails("s/\"VEC3\"/&" SPARSE(4, 1, ",\"byteOffset\":40") "/", kind);
    assert_edited_fails("s/\"VEC3\"/&" SPARSE(4, 0, "") "/", kind);
    assert_edited_fails("s/\"VEC3\"/&" SPARSE(4, "1", "") "/", kind);
    assert_edited_fails("s/\"VEC3\"/&" SPARSE(4, 1, "") "/;s/5121},\"values\"/5126},\"values\"/", kind);
    assert_edited_fails("s/\"VEC3\"/&" SPARSE(4, 1, "") "/;s/,\"componentType\":5121},\"values\"/},\"values\"/", kind);
    assert_edited_fails("s/\"VEC3\"/&" SPARSE(4, 1, "") "/;s/\"values\":{\"bufferView\":0}/\"values\":{}/", kind);
    assert_drawn_alike("s/\"VEC3\"/&" SPARSE(4, 1, "") "/;s/\"bufferView\":1,\"componentType\":5121/"
                                                       "\"bufferView\":1,\"byteOffset\":0,\"componentType\":5123/",
                       "");
    assert_edited_fails("s/\"bufferView\":0,\\(.*\"count\":4,\"type\":\"VEC3\"\\)},{\"bufferView\":1/"
                        "\"bufferView\":5,\\1" SPARSE(4, 1, "") "},{\"bufferView\":1/", /* in steps */
                        kind);
}

static void binary_gltf_is_checked_as_text_is(void **state)
{
    (void)state;
    static const char make[] = /* the same as GLB: its text, which is padded, then base.bin */
        "glb() { n=$(($(wc -c <$1) + 3 & ~3)); le() { for v; do for s in 0 8 16 24; do "
        "printf \"\\\\$(printf %o $((v >> s & 255)))\"; done; done; }; "
        "{ printf glTF; le $2 $((28 + n + 344)) $n 1313821514; cat $1; printf \"%$((n - $(wc -c <$1)))s\" ''; "
        "le 344 5130562; cat base.bin; } >a.glb; }; ";
    static const char *const cases[][2] = {
        {"sed 's/\"NORMAL\":2/\"NORMAL\":4/;s/,\"uri\":\"base.bin\"//' base.gltf >t; glb t 2",
         "it has numbers of a kind"},
        {"cp base.gltf t; glb t 2", "a GLB's first buffer is in itself, and this one's is elsewhere; export it again"},
        {"cp base.gltf t; glb t 1", "it is a glTF 1; export it as glTF 2.0"},
        {"cp base.gltf t; glb t 2; truncate -s 500 a.glb", "it is damaged; export it again"},
        {"cp base.gltf t; glb t 2; truncate -s -345 a.glb", "it is damaged; export it again"},
        {"sed 's/:/;/' base.gltf >t; glb t 2", "it is damaged; export it again"}};
    char line[1500];
    snprintf(line, sizeof line,
             "%ssed 's/,\"uri\":\"base.bin\"//' base.gltf >t; glb t 2; " RENDER "a.glb -o a.ppm && " RENDER
             "base.gltf -o b.ppm && cmp a.ppm b.ppm && " RENDER "- -o c.ppm <a.glb && cmp a.ppm c.ppm",
             make);
    assert_quiet(line);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        snprintf(line, sizeof line, "%s%s; " RENDER "a.glb -o no.ppm", make, cases[i][0]);
        assert_fails(line, cases[i][1]);
    }
    assert_drawn_alike("s/^/\\xEF\\xBB\\xBF/", "");
    assert_edited_fails("s/2[.]0/1.0/", "it is a glTF 1; export it as glTF 2.0");
    assert_edited_fails("s/\"meshes\":/\"meshes\":[],&/", "it is damaged"); /* which of them? */
}
#endif

int main(void)
{
#if GLINT_WITH_MESH
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_that_libassimp_takes_for_others_are_refused),
        cmocka_unit_test(numbers_beyond_their_view_or_too_few_are_refused),
        cmocka_unit_test(what_is_not_what_a_gltf_has_there_is_refused),
        cmocka_unit_test(a_triangle_with_a_corner_that_the_file_does_not_have_is_refused),
        cmocka_unit_test(what_a_gltf_requires_and_glint_does_not_carry_out_is_refused),
        cmocka_unit_test(a_transform_that_names_other_coordinates_than_its_texture_is_refused),
        cmocka_unit_test(skeletons_and_morph_targets_with_weights_are_refused),
        cmocka_unit_test(mirrored_parts_show_their_outer_side),
        cmocka_unit_test(parts_that_are_scaled_to_0_are_hidden),
        cmocka_unit_test(bones_may_stand_a_thousand_deep),
        cmocka_unit_test(points_and_lines_take_no_normals_away),
        cmocka_unit_test(parts_without_normals_take_none_from_others),
        cmocka_unit_test(numbers_of_any_size_may_stand_beside),
        cmocka_unit_test(text_that_is_not_utf_8_is_said_to_be),
        cmocka_unit_test(a_data_uri_is_base64_or_refused),
        cmocka_unit_test(sparse_numbers_are_read_where_libassimp_reads_them),
        cmocka_unit_test(binary_gltf_is_checked_as_text_is),
    };
    return cmocka_run_group_tests_name("glTF", tests, make_base, scratch_remove);
#else
    return 0;
#endif
}
