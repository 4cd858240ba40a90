/* SPDX-License-Identifier: MIT
 * Textures of meshes, from the files to the pixels. */
#include "files.h"
#include "solids.h"

#include "mesh/fit.h"
#include "mesh/import_picture.h"
#include "mesh/order.h"
#include "mesh/split.h"
#include "mesh/surface.h"
#include "mesh/weld.h"
#if GLINT_WITH_JPEG
#include <jpeglib.h>
#endif

/* ---- soups ---- */

static struct mesh_picture picture_made(uint32_t w, uint32_t h)
{
    struct mesh_picture picture = {strdup("made.png"), w, h, calloc((size_t)w * h, 3)};
    assert_true(picture.name && picture.rgb);
    for (uint32_t i = 0; i < 3 * w * h; i++)
        picture.rgb[i] = (uint8_t)(i * i / 7);
    return picture;
}

/* Each side of the cube wears the picture, moved by so many repeats. */
static struct soup *textured_cube(double repeats)
{
    static const double at[2][3][2] = {{{0, 1}, {1, 1}, {1, 0}}, {{0, 1}, {1, 0}, {0, 0}}};
    struct soup *soup = soup_cube();
    soup->has_uv = true;
    soup->picture_count = 1;
    soup->pictures = calloc(1, sizeof *soup->pictures);
    assert_non_null(soup->pictures);
    soup->pictures[0] = picture_made(64, 64);
    soup->materials[0].picture = 1;
    for (int k = 0; k < 3; k++)
        soup->materials[0].factor[k] = 1;
    for (size_t i = 0; i < 6 * soup->face_count; i++)
        soup->faces[i / 6].uv[i / 2 % 3][i % 2] = at[i / 6 % 2][i / 2 % 3][i % 2] + repeats;
    return soup;
}

static struct mesh *mesh_of(struct soup *soup, struct texture_wish wish)
{
    const struct mesh_source source = {.wish = wish};
    mesh_surface_begin(soup, &source);
    struct mesh *mesh = mesh_weld(soup, 180);
    mesh_surface_end(mesh, soup, &source);
    soup_free(soup);
    return mesh;
}

static void corners_of_different_places_in_a_picture_stay_apart(void **state)
{
    (void)state;
    struct mesh *mesh = mesh_of(textured_cube(0), (struct texture_wish){0});
    assert_int_equal(mesh->place_count, 8);
    assert_true(mesh->vertex_count > 8 && mesh->vertex_count <= 24);
    assert_closed(mesh);
    mesh_free(mesh);
    struct soup *soup = textured_cube(0);
    soup->materials[0].picture = 0; /* and where there is no picture they do not */
    mesh = mesh_of(soup, (struct texture_wish){0});
    assert_int_equal(mesh->vertex_count, 8);
    assert_null(mesh->uv);
    mesh_free(mesh);
}

/* On the top side u is (x + 1) / 2 and v (1 - z) / 2 or the like: a linear function of the place, whatever was split. */
static void splitting_and_ordering_keep_places_in_the_picture(void **state)
{
    (void)state;
    struct mesh *mesh = mesh_of(textured_cube(0), (struct texture_wish){0});
    const size_t before = mesh->vertex_count;
    mesh_split(mesh, 40);
    mesh_order(mesh);
    assert_true(mesh->vertex_count > before);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        for (int k = 0; k < 2; k++) {
            bool met = false; /* as far from an edge as one of the place's numbers is */
            for (int j = 0; j < 3; j++)
                met |= fabs(fabs(2 * mesh->uv[i][k] - 1) - fabs(mesh->places[i][j])) < 1e-9;
            assert_true(met && mesh->uv[i][k] >= 0 && mesh->uv[i][k] <= 1);
        }
    mesh_free(mesh);
}

static void places_are_moved_by_whole_repeats_and_as_fine_as_fits(void **state)
{
    (void)state;
    struct mesh *mesh = mesh_of(textured_cube(-37), (struct texture_wish){0});
    struct fitted *fitted = mesh_fit(mesh, 0);
    assert_int_equal(fitted->mesh.uv_bits, 15);
    for (size_t i = 0; i < 2 * mesh->vertex_count; i++)
        assert_int_equal(fitted->uv[i / 2][i % 2], 32768 * mesh->uv[i / 2][i % 2]);
    fitted_free(fitted);
    mesh_free(mesh);
    struct soup *soup = textured_cube(0);
    for (size_t i = 0; i < 6 * soup->face_count; i++)
        soup->faces[i / 6].uv[i / 2 % 3][i % 2] *= 5;
    mesh = mesh_of(soup, (struct texture_wish){0});
    fitted = mesh_fit(mesh, 0);
    assert_int_equal(fitted->mesh.uv_bits, 13); /* 5 2^13 < 2^16 < 5 2^14 */
    fitted_free(fitted);
    mesh_free(mesh);
}

/* ---- textures ---- */

static struct fitted *fitted_picture(struct mesh_picture picture, struct texture_wish wish)
{
    struct soup *soup = textured_cube(0);
    mesh_picture_clear(&soup->pictures[0]);
    soup->pictures[0] = picture;
    struct mesh *mesh = mesh_of(soup, wish);
    struct fitted *fitted = mesh_fit(mesh, 0);
    fitted->textures[0].name = NULL; /* the mesh's */
    mesh_free(mesh);
    return fitted;
}

static void textures_fit_their_budget_and_powers_of_two_stay_such(void **state)
{
    (void)state;
    static const struct {
        uint32_t w, h;
        size_t bytes;
        bool palette;
        unsigned want_w, want_h; /* 0: any */
    } cases[] = {{64, 64, 0, false, 64, 64},      {64, 64, 10922, false, 64, 64}, {64, 64, 10921, false, 32, 32},
                 {64, 16, 1000, false, 32, 8},    {100, 60, 4000, false, 0, 0},   {64, 64, 5973, true, 64, 64},
                 {64, 64, 5972, true, 32, 32},    {4096, 2, 0, false, 2048, 1},   {1, 1, 2, false, 1, 1},
                 {3000, 1000, 65536, true, 0, 0}, {33, 7, 100, false, 0, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct texture_wish wish = {.bytes = cases[i].bytes, .palette = cases[i].palette};
        struct fitted *fitted = fitted_picture(picture_made(cases[i].w, cases[i].h), wish);
        const struct glint_texture *texture = &fitted->mesh.textures[0];
        const size_t bytes = texture_bytes(&fitted->textures[0]);
        if (cases[i].bytes && (bytes > cases[i].bytes || bytes * 5 < cases[i].bytes))
            fail_msg("case %zu: %zu bytes of %zu", i, bytes, cases[i].bytes);
        if (cases[i].want_w) {
            assert_int_equal(texture->w, cases[i].want_w);
            assert_int_equal(texture->h, cases[i].want_h);
        } else { /* in proportion */
            assert_near(texture->h, (double)texture->w * cases[i].h / cases[i].w, 1);
        }
        unsigned side = texture->w > texture->h ? texture->w : texture->h, levels = 1;
        for (; side > 1; side /= 2)
            levels++;
        assert_int_equal(texture->levels, levels);
        assert_int_equal(glint_mesh_check(&fitted->mesh), GLINT_OK);
        fitted_free(fitted);
    }
}

/* Black and white in equal parts are 188 of 255, as much light as the half. */
static void smaller_pictures_are_means_in_linear_light(void **state)
{
    (void)state;
    struct mesh_picture picture = picture_made(4, 4);
    for (unsigned i = 0; i < 48; i++)
        picture.rgb[i] = (i / 3 + i / 12) % 2 ? 255 : 0;
    struct fitted *fitted = fitted_picture(picture, (struct texture_wish){0});
    assert_int_equal(fitted->mesh.textures[0].levels, 3);
    for (long level = 0; level < 3; level++) {
        double rgb[3];
        texture_color(&fitted->mesh.textures[0], (unsigned)level, 1, 0, rgb);
        for (int k = 0; k < 3; k++)
            assert_near(rgb[k], level ? 188 : 255, 4.2); /* half a level of 31 */
    }
    fitted_free(fitted);
    picture = picture_made(3, 1); /* a third and a half of the middle one each */
    for (unsigned i = 0; i < 9; i++)
        picture.rgb[i] = i / 3 == 1 ? 255 : 0;
    fitted = fitted_picture(picture, (struct texture_wish){0});
    double rgb[3];
    texture_color(&fitted->mesh.textures[0], 1, 0, 0, rgb);
    assert_near(rgb[1], 255 * texture_encode(1. / 3), 2.1);
    fitted_free(fitted);
}

static void a_palette_of_few_colours_is_exact_and_one_of_many_is_near(void **state)
{
    (void)state;
    enum { FEW = 1000, MANY = 1 << 14 };
    static uint16_t pixels[MANY], palette[TEXTURE_COLORS];
    static uint8_t indices[MANY];
    for (unsigned i = 0; i < FEW; i++)
        pixels[i] = (uint16_t)(i % 256 * 257);
    assert_int_equal(texture_palette(pixels, FEW, palette, indices), 256);
    for (unsigned i = 0; i < FEW; i++)
        assert_int_equal(palette[indices[i]], pixels[i]);
    double sum = 0; /* a plane of 128 x 128 colours: 16 x 16 squares of 8 x 8 are 5.3 levels from their middles */
    for (unsigned i = 0; i < MANY; i++)
        pixels[i] = (uint16_t)((i % 128 / 4) << 11 | (i / 128 / 2) << 5 | 9);
    assert_true(texture_palette(pixels, MANY, palette, indices) <= TEXTURE_COLORS);
    for (unsigned i = 0; i < MANY; i++) {
        const int red = palette[indices[i]] >> 11, green = palette[indices[i]] >> 5 & 63;
        sum += hypot((red - (pixels[i] >> 11)) * 255. / 31, (green - (pixels[i] >> 5 & 63)) * 255. / 63);
        assert_int_equal(palette[indices[i]] & 31, 9);
    }
    assert_near(sum / MANY, 0, 7);
}

/* ---- files ---- */

#if GLINT_WITH_MESH
#define FLAT " --size 64x64 --ambient 1 --diffuse 0 --specular 0 --nearest "
static const uint16_t four[12] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};

/* Red, green; blue, white; and a grey height map of 2 x 2. */
static void make_four(const char *path)
{
    make_png(path,
             &(struct made_png){.width = 2, .height = 2, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = four});
}

/* A square that faces the viewer, the picture upright on it. */
static void make_square(const char *path, const char *materials)
{
    char text[300];
    snprintf(text, sizeof text,
             "mtllib %s\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl a\n"
             "f 1/1 2/2 3/3 4/4\n",
             materials);
    write_text(path, text);
}

/* In the middle of the quarter x, y. */
static void assert_quarter(const char *ppm, unsigned x, unsigned y, const uint8_t rgb[3], double tolerance)
{
    enum { HEAD = 13, SIDE = 64 };
    uint8_t bytes[HEAD + 3 * SIDE * SIDE];
    assert_int_equal(read_file(ppm, bytes, sizeof bytes), sizeof bytes);
    for (unsigned k = 0; k < 3; k++)
        assert_near(bytes[HEAD + 3 * (SIDE * (21 + 22 * y) + 21 + 22 * x) + k], rgb[k], tolerance);
}

static void assert_four(const char *ppm)
{
    for (unsigned i = 0; i < 4; i++)
        assert_quarter(ppm, i % 2, i / 2,
                       (uint8_t[]){(uint8_t)four[3 * i], (uint8_t)four[3 * i + 1], (uint8_t)four[3 * i + 2]}, 0);
}

static void an_obj_wears_the_picture_that_its_material_names(void **state)
{
    (void)state;
    make_four("four.png");
    make_square("a.obj", "a.mtl");
    write_text("a.mtl", "newmtl a\nKd 0 0 0\nmap_Kd four.png\n");
    assert_quiet("$GLINT render --mesh a.obj" FLAT "-o a.ppm");
    assert_four("a.ppm");
    assert_quiet("cd / && $GLINT render --mesh $OLDPWD/a.obj" FLAT "-o $OLDPWD/b.ppm");
    assert_same_file("a.ppm", "b.ppm");
    /* In a folder below, with the other system's separators; times the material's colour. */
    write_text("b.mtl", "newmtl a\nKd 1 1 .502\nmap_Kd maps\\four.png\n");
    make_square("b.obj", "b.mtl");
    assert_quiet("mkdir maps && mv four.png maps");
    assert_quiet("$GLINT render --mesh b.obj" FLAT "-o b.ppm");
    assert_quarter("b.ppm", 0, 0, (uint8_t[]){255, 0, 0}, 0);
    assert_quarter("b.ppm", 1, 1, (uint8_t[]){255, 255, 128}, 4.2);
    /* --no-textures, --color: without. */
    assert_quiet("$GLINT render --mesh b.obj --no-textures --color 9,99,199" FLAT "-o a.ppm");
    assert_quiet("$GLINT render --mesh b.obj --color 9,99,199" FLAT "-o b.ppm");
    assert_same_file("a.ppm", "b.ppm");
    assert_quarter("b.ppm", 1, 1, (uint8_t[]){9, 99, 199}, 0);
    assert_quiet("mv maps/four.png .");
    /* Options before the name, which may have blanks, and begin as what is not a number does. */
    static const char *const options[] = {"-s 1 1 -o 1 the four.png", "-clamp off -blendu on the four.png",
                                          "-mm 0 1 -bm .5 -s 1 1 1 the four.png", "-s 1 1 infant.png", "-o 0 nan.png"};
    assert_quiet("cp four.png 'the four.png'; cp four.png infant.png; cp four.png nan.png");
    for (unsigned i = 0; i < sizeof options / sizeof *options; i++) {
        char text[100];
        snprintf(text, sizeof text, "newmtl a\n\tmap_Kd %s\n", options[i]);
        write_text("c.mtl", text);
        make_square("c.obj", "c.mtl");
        assert_quiet("$GLINT render --mesh c.obj" FLAT "-o c.ppm");
        assert_four("c.ppm");
    }
    assert_quiet("$GLINT stream --mesh a.obj" FLAT "--frames 1 --to ppm -o s.ppm");
    assert_four("s.ppm");
}

static void a_texture_that_one_colour_hides_is_named_in_a_line(void **state)
{
    (void)state;
    static const char *const hiding[] = {"--color 9,99,199", "--material brass"}, *const commands[] = {
                                                                                      "render",
                                                                                      "stream --frames 1 --to png"};
    make_four("four.png");
    for (unsigned i = 0; i < 4; i++) {
        char line[200], said[100];
        snprintf(line, sizeof line, "$GLINT %s teapot --size 9x9 --texture four.png %s -o hidden.png", commands[i / 2],
                 hiding[i % 2]);
        snprintf(said, sizeof said, "glint: --texture is left out: %.*s draws a mesh in one colour\n",
                 (int)strcspn(hiding[i % 2], " "), hiding[i % 2]);
        const struct run *drawn = run(line);
        assert_int_equal(drawn->status, 0);
        assert_string_equal(drawn->err, said);
    }
}

static char *base64_of(const char *path)
{
    char line[100];
    snprintf(line, sizeof line, "base64 -w 0 %s", path);
    char *text = strdup(run(line)->out);
    assert_true(text && *text);
    return text;
}

/* The same square; its numbers are in square.bin. `material`: more of it, `texture`: more of its picture's. */
static void make_gltf(const char *path, const char *material, const char *picture, const char *texture,
                      const char *more)
{
    static const float numbers[20] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0, 1, 1, 1, 1, 0, 0, 0};
    static const uint16_t corners[6] = {0, 1, 2, 0, 2, 3};
    FILE *bin = fopen("square.bin", "wb"), *file = fopen(path, "w");
    assert_true(bin && file);
    assert_true(fwrite(numbers, sizeof numbers, 1, bin) == 1 && fwrite(corners, sizeof corners, 1, bin) == 1);
    fprintf(
        file,
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"indices\":2,\"material\":0}]}"
        "],"
        "\"materials\":[{\"pbrMetallicRoughness\":{%s\"baseColorTexture\":{\"index\":0%s}}}],"
        "\"textures\":[{\"source\":0%s],\"images\":[{%s}],"
        "\"buffers\":[{\"byteLength\":92,\"uri\":\"square.bin\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},"
        "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":32},{\"buffer\":0,\"byteOffset\":80,\"byteLength\":12}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"min\":[-1,-1,0],"
        "\"max\":[1,1,0]},{\"bufferView\":1,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},"
        "{\"bufferView\":2,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}]}",
        material, texture, more, picture);
    assert_int_equal(fclose(bin) | fclose(file), 0);
}

/* The glTF with its numbers and its picture in one file. */
static void make_glb(const char *path, const char *gltf, const char *png)
{
    char *text = whole_file(gltf), *uri = strstr(text, ",\"uri\":\"square.bin\""), *image, whole[3000];
    struct stat status;
    assert_true(uri && stat(png, &status) == 0);
    memmove(uri, uri + strlen(",\"uri\":\"square.bin\""), strlen(uri + strlen(",\"uri\":\"square.bin\"")) + 1);
    assert_non_null(image = strstr(text, "\"uri\":\"four.png\""));
    *image = 0;
    char *rest = image + strlen("\"uri\":\"four.png\""), *views = strstr(rest, "\"byteOffset\":80,\"byteLength\":12}");
    assert_non_null(views);
    views += strlen("\"byteOffset\":80,\"byteLength\":12}");
    const unsigned bytes = 92 + (unsigned)status.st_size;
    char *length = strstr(rest, "\"byteLength\":92");
    assert_non_null(length);
    snprintf(whole, sizeof whole,
             "%s\"bufferView\":3,\"mimeType\":\"image/png\"%.*s\"byteLength\":%u%.*s,{\"buffer\":0,\"byteOffset\":92,"
             "\"byteLength\":%u}%s",
             text, (int)(length - rest), rest, bytes, (int)(views - length - 15), length + 15, (unsigned)status.st_size,
             views);
    while (strlen(whole) % 4)
        strcat(whole, " ");
    const uint32_t json = (uint32_t)strlen(whole), padded = (bytes + 3) / 4 * 4;
    const uint32_t head[] = {0x46546c67, 2, 28 + json + padded, json, 0x4e4f534a}, part[] = {padded, 0x004e4942};
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fwrite(head, sizeof head, 1, file);
    fwrite(whole, json, 1, file);
    fwrite(part, sizeof part, 1, file);
    assert_int_equal(fclose(file), 0);
    char line[200];
    snprintf(line, sizeof line, "cat square.bin %s >>%s && truncate -s %u %s", png, path, head[2], path);
    assert_quiet(line);
    free(text);
}

static void a_gltf_names_its_picture_or_holds_it(void **state)
{
    (void)state;
    make_four("four.png");
    char *data = base64_of("four.png"), uri[2000];
    snprintf(uri, sizeof uri, "\"uri\":\"data:image/png;base64,%s\"", data);
    make_gltf("named.gltf", "", "\"uri\":\"four.png\"", "", "}");
    make_gltf("held.gltf", "", uri, "", "}");
    make_gltf("spaced.gltf", "", "\"uri\":\"four%20th.png\"", "", "}");
    make_glb("binary.glb", "named.gltf", "four.png");
    assert_quiet("cp four.png 'four th.png'");
    assert_quiet("for f in named.gltf held.gltf spaced.gltf binary.glb; do "
                 "$GLINT render --mesh $f" FLAT "-o $f.ppm && cmp $f.ppm named.gltf.ppm || exit 1; done; "
                 "$GLINT render --mesh -" FLAT "-o input.ppm <binary.glb && cmp input.ppm named.gltf.ppm");
    assert_four("named.gltf.ppm");
    free(data);
}

static void a_gltf_says_how_its_picture_is_taken(void **state)
{
    (void)state;
    make_four("four.png");
    make_gltf("a.gltf", "", "\"uri\":\"four.png\"", "", ",\"sampler\":0}],\"samplers\":[{\"magFilter\":9728}");
    make_gltf("b.gltf", "", "\"uri\":\"four.png\"", "", ",\"sampler\":0}],\"samplers\":[{\"magFilter\":9729}");
    assert_quiet("for f in a b; do for o in '' --nearest --smooth; do "
                 "$GLINT render --mesh $f.gltf --size 64x64 $o -o $f$o.ppm || exit 1; done; done");
    assert_same_file("a.ppm", "b--nearest.ppm");
    assert_same_file("b.ppm", "a--smooth.ppm");
    assert_false(same_file("a.ppm", "b.ppm"));
    /* The base colour is times the picture, in linear light. */
    make_gltf("c.gltf", "\"baseColorFactor\":[1,0.5,0,1],", "\"uri\":\"four.png\"", "", "}");
    assert_quiet("$GLINT render --mesh c.gltf" FLAT "-o c.ppm");
    assert_quarter("c.ppm", 0, 0, (uint8_t[]){255, 0, 0}, 0);
    assert_quarter("c.ppm", 1, 1, (uint8_t[]){255, 188, 0}, 2.1);
    /* Moved by half the picture, upright and in both directions. */
    make_gltf("d.gltf", "", "\"uri\":\"four.png\"",
              ",\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0.5,0],\"scale\":[1,1]}}", "}");
    make_gltf("e.gltf", "", "\"uri\":\"four.png\"",
              ",\"extensions\":{\"KHR_texture_transform\":{\"rotation\":1.5707963267948966}}", "}");
    assert_quiet("for f in d e; do sed -i '1s/{/{\"extensionsUsed\":[\"KHR_texture_transform\"],/' $f.gltf; "
                 "$GLINT render --mesh $f.gltf" FLAT "-o $f.ppm || exit 1; done");
    assert_quarter("d.ppm", 0, 0, (uint8_t[]){0, 255, 0}, 0);
    assert_quarter("d.ppm", 0, 1, (uint8_t[]){255, 255, 255}, 0);
    assert_quarter("e.ppm", 0, 0, (uint8_t[]){0, 0, 255}, 0); /* u there is v here: 0, and v is 1 - u */
    assert_quarter("e.ppm", 1, 0, (uint8_t[]){255, 0, 0}, 0);
    /* A picture that is not to repeat, and does. */
    make_gltf("f.gltf", "", "\"uri\":\"four.png\"", ",\"extensions\":{\"KHR_texture_transform\":{\"scale\":[2,2]}}",
              ",\"sampler\":0}],\"samplers\":[{\"wrapS\":33071,\"wrapT\":33071}");
    const struct run *result = run("sed -i '1s/{/{\"extensionsUsed\":[\"KHR_texture_transform\"],/' f.gltf; "
                                   "$GLINT render --mesh f.gltf" FLAT "-o f.ppm");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "f.gltf: texture four.png repeats here beyond its edges");
}

static void roughness_and_metal_become_shininess_and_highlight(void **state)
{
    (void)state;
    make_four("four.png");
    static const char *const cases[][2] = {
        {"", "{GLINT_MSH, 0, 60, 0, {13107, 13107, 13107}, {58982, 58982, 58982}, {32768, 32768, 32768}, "},
        {"\"metallicFactor\":0,\"roughnessFactor\":0.5,", "{GLINT_MSH, 0, 30, 0, {13107, 13107, 13107}, {58982, 58982, "
                                                          "58982}, {10486, 10486, 10486}, "}, /* .04 / 4 r^4 */
        {"\"metallicFactor\":0,",
         "{GLINT_MSH, 0, 1, 0, {13107, 13107, 13107}, {58982, 58982, 58982}, {655, 655, 655}, "},
        {"\"roughnessFactor\":0.7,\"baseColorFactor\":[1,0,0,1],",
         "{GLINT_MSH, 0, 6, 0, {13107, 13107, 13107}, {29491, 29491, 29491}, {"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        make_gltf("m.gltf", cases[i][0], "\"uri\":\"four.png\"", "", "}");
        const struct run *result = run("$GLINT bake --mesh m.gltf -o - 2>report");
        assert_int_equal(result->status, 0);
        assert_contains(result->out, cases[i][1]);
    }
    make_gltf("g.gltf", "\"roughnessFactor\":0.3,\"baseColorFactor\":[1,0.5,0,1],", "\"uri\":\"none.png\"", "", "}");
    assert_contains(run("$GLINT bake --mesh g.gltf --no-textures -o - 2>report")->out, /* 188 / 255 */
                    "{GLINT_MSH, 0, 245, 0, {13107, 13107, 13107}, {29491, 29491, 29491}, {65536, 48317, 0}, ");
    /* A metal's highlight has its colour: here that of the picture's mean, without green and blue. */
    assert_contains(run("$GLINT bake --mesh m.gltf -o - 2>report")->out, ", 0, 0}, {255, 0, 0}, false}");
    /* A picture of them counts by its mean: green and blue are a half each. */
    make_gltf("n.gltf", "\"metallicRoughnessTexture\":{\"index\":0},", "\"uri\":\"four.png\"", "", "}");
    assert_contains(run("$GLINT bake --mesh n.gltf -o - 2>report")->out,
                    "{GLINT_MSH, 0, 30, 0, {13107, 13107, 13107}, {44237, 44237, 44237}, {");
    make_gltf("m.gltf", "\"metallicFactor\":0,\"roughnessFactor\":0.2,", "\"uri\":\"four.png\"", "", "}");
    const struct run *result = run("$GLINT bake --mesh m.gltf -o m.c");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "m.gltf: a roughness below .211");
    assert_contains(run("cat m.c")->out, "{GLINT_MSH, 0, 1000, 0, ");
    assert_quiet(
        "$GLINT render --mesh m.gltf -n 60 --specular .5 --ambient .2 --diffuse .9 --size 64x64 -o a.ppm 2>words; "
        "sed 's/\"metallicFactor\":0,\"roughnessFactor\":0.2,//' m.gltf >n.gltf; "
        "$GLINT render --mesh n.gltf --size 64x64 -o b.ppm && cmp a.ppm b.ppm");
}

/* What is wrong with a texture that a file names is one line, and the mesh is drawn without it. */
static void a_texture_that_cannot_be_drawn_is_left_out_with_one_line(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"none.png", "none.png is left out: No such file"},
        {"../four.png", "../four.png is left out: it lies outside the mesh's folder"},
        {"below/../../four.png", "it lies outside the mesh's folder"},
        {"/etc/passwd", "it lies outside the mesh's folder"},
        {"C:/pictures/four.png", "it lies outside the mesh's folder"},
        {"link.png", "it lies outside the mesh's folder"},
        {"below", "it is not a regular file"},
        {"pipe", "it is not a regular file"},
        {"text.png", "this is not a PNG or JPEG picture"},
        {"empty.png", "this is not a PNG or JPEG picture"},
        {"short.png", "damaged PNG: "},
        {"wide.png", "65536x65536 pixels; at most 16384 a side"},
        {"short.jpg", GLINT_WITH_JPEG ? "damaged JPEG: " : "without libjpeg"}};
    /* A header of 65536 x 65536 pixels, its checksum made here. */
    uint8_t wide[45] = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\0\0\0\1\0\0\10\2\0\0\0....\0\0\0\4IDAT";
    uint32_t sum = UINT32_MAX;
    for (unsigned i = 8 * 12; i < 8 * 29; i++)
        sum = (sum >> 1) ^ (((sum ^ wide[i / 8] >> i % 8) & 1) ? 0xedb88320 : 0);
    sum = ~sum;
    for (int i = 0; i < 4; i++)
        wide[29 + i] = (uint8_t)(sum >> (24 - 8 * i));
    assert_quiet("mkdir in in/below && mkfifo in/pipe && ln -s ../four.png in/link.png && echo text >in/text.png && "
                 ": >in/empty.png && printf '\\377\\330\\377\\340' >in/short.jpg");
    make_four("four.png");
    assert_quiet("head -c 50 four.png >in/short.png");
    FILE *file = fopen("in/wide.png", "wb");
    assert_true(file && fwrite(wide, sizeof wide, 1, file) == 1 && fclose(file) == 0);
    make_square("in/a.obj", "a.mtl");
    write_text("in/a.mtl", "newmtl a\nKd 1 .5 0\n");
    assert_quiet("$GLINT render --mesh in/a.obj" FLAT "-o without.ppm");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[100];
        snprintf(text, sizeof text, "newmtl a\nKd 1 .5 0\nmap_Kd %s\n", cases[i][0]);
        write_text("in/a.mtl", text);
        const struct run *result = run("$GLINT render --mesh in/a.obj" FLAT "-o a.ppm");
        assert_int_equal(result->status, 0);
        assert_contains(result->err, cases[i][1]);
        assert_one_line(result->err);
        assert_same_file("a.ppm", "without.ppm");
        assert_quiet("$GLINT render --mesh in/a.obj --no-textures" FLAT "-o a.ppm");
    }
    /* Without places in the picture. */
    make_four("in/four.png");
    write_text("in/a.mtl", "newmtl a\nKd 1 .5 0\nmap_Kd four.png\n");
    const struct run *result =
        run("sed -i 's|/[1-4]||g; /^vt/d' in/a.obj; $GLINT render --mesh in/a.obj" FLAT "-o a.ppm");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "names a texture, but has no texture coordinates");
    assert_same_file("a.ppm", "without.ppm");
}

static void an_output_that_is_a_texture_of_the_mesh_is_refused_and_kept(void **state)
{
    (void)state;
    make_four("four.png");
    make_square("a.obj", "a.mtl");
    write_text("a.mtl", "newmtl a\nmap_Kd four.png\n");
    assert_quiet("cp four.png kept.png");
    assert_fails("$GLINT render --mesh a.obj --size 9x9 -o four.png", "four.png: this file is also an input");
    assert_fails("$GLINT render --scene teapot --texture four.png --size 9x9 -o four.png",
                 "this file is also an input");
    assert_same_file("four.png", "kept.png");
}

/* Made by hand, with a comment's worth of what real files have. */
#if GLINT_WITH_JPEG
static void a_jpeg_is_read_as_a_png_is(void **state)
{
    (void)state;
    enum { SIDE = 32 };
    uint8_t line[3 * SIDE];
    struct jpeg_compress_struct info;
    struct jpeg_error_mgr errors;
    FILE *file = fopen("four.jpg", "wb");
    assert_non_null(file);
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    jpeg_stdio_dest(&info, file);
    info.image_width = info.image_height = SIDE;
    info.input_components = 3;
    info.in_color_space = JCS_RGB;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, 100, TRUE);
    jpeg_start_compress(&info, TRUE);
    for (unsigned y = 0; y < SIDE; y++) {
        for (unsigned i = 0; i < 3 * SIDE; i++)
            line[i] = (uint8_t)four[3 * (2 * (2 * y / SIDE) + 2 * (i / 3) / SIDE) + i % 3];
        jpeg_write_scanlines(&info, (JSAMPROW[]){line}, 1);
    }
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    assert_int_equal(fclose(file), 0);
    make_square("j.obj", "j.mtl");
    write_text("j.mtl", "newmtl a\nmap_Kd four.jpg\n");
    assert_quiet("$GLINT render --mesh j.obj" FLAT "-o j.ppm");
    for (unsigned i = 0; i < 4; i++)
        assert_quarter("j.ppm", i % 2, i / 2,
                       (uint8_t[]){(uint8_t)four[3 * i], (uint8_t)four[3 * i + 1], (uint8_t)four[3 * i + 2]}, 9);
    assert_contains(run("$GLINT --version")->out, import_picture_library());
    assert_fails("head -c 400 four.jpg >half.jpg; $GLINT render --scene teapot --texture half.jpg --size 9x9 -o no.png",
                 "half.jpg: damaged JPEG: ");
}
#endif

static void colours_of_vertices_give_way_to_textures_with_a_word(void **state)
{
    (void)state;
    make_four("four.png");
    make_square("a.obj", "a.mtl");
    write_text("a.mtl", "newmtl a\nKd 1 1 1\nmap_Kd four.png\n");
    const struct run *result =
        run("sed 's/^v \\(.*\\) 1 0$/v \\1 1 0 1 0 0/; s/^v \\(.*\\) -1 0$/v \\1 -1 0 0 1 0/' a.obj >b.obj && "
            "$GLINT render --mesh b.obj" FLAT "-o b.ppm");
    assert_int_equal(result->status, 0);
    assert_one_line(result->err);
    assert_contains(result->err, "the colours are left out");
    assert_four("b.ppm");
    /* One colour throughout is times the picture. */
    assert_quiet("sed 's/^v .*/& 1 1 0/' a.obj >c.obj && $GLINT render --mesh c.obj" FLAT "-o c.ppm");
    assert_quarter("c.ppm", 1, 1, (uint8_t[]){255, 255, 0}, 0);
}
#endif

/* ---- one picture for all ---- */

static void make_checker(const char *path)
{
    static uint16_t samples[64 * 64 * 3];
    for (unsigned i = 0; i < sizeof samples / sizeof *samples; i++)
        samples[i] = (i / 24 + i / (192 * 8)) % 2 ? 230 : (uint16_t)(40 + 80 * (i % 3));
    make_png(path, &(struct made_png){
                       .width = 64, .height = 64, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = samples});
}

static double number_in(const char *text, const char *name)
{
    const char *at = strstr(text, name);
    if (!at)
        fail_msg("no %s in '%s'", name, text);
    at = strchr(at + strlen(name), ':');
    return strtod(at + 1, NULL);
}

/* The same texture in double precision, rounded. */
static void a_textured_teapot_is_near_double_precision(void **state)
{
    (void)state;
    static const struct {
        const char *options;
        double psnr, mean;
    } cases[] = {{"--nearest", 51, .4},
                 {"--nearest --perspective", 51, .4},
                 {"--nearest --format rgb565", 44, .4},
                 {"--nearest --perspective --texture-to palette", 51, .4},
                 {"--smooth", 45, .5},
                 {"--smooth --perspective", 42, .6},
                 {"--nearest --path albedo-int8 --format rgb565 --ambient .2 --diffuse .8", 36, 2},
                 {"--smooth --path albedo-int16 --format rgb565 --ambient .2 --diffuse .8", 36, 2.1}};
    make_checker("checker.png");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char line[300];
        snprintf(line, sizeof line, "$GLINT render --scene teapot --texture checker.png --size 240x240 %s --json",
                 cases[i].options);
        const struct run *result = run(line);
        assert_string_equal(result->err, "");
        const double psnr = number_in(result->out, "\"psnr_db\""), mean = number_in(result->out, "\"mean\"");
        if (psnr < cases[i].psnr || mean > cases[i].mean)
            fail_msg("%s: %g dB, mean %g", cases[i].options, psnr, mean);
        /* Texels differ at their edges only: the place of a corner is of 1/16 pixel. */
        const double covered = number_in(result->out, "\"covered\""), other = number_in(result->out, "\"other_texel\"");
        if (covered < 10000 || other > covered / 8 || (strstr(cases[i].options, "smooth") && other > 0))
            fail_msg("%s: of %g pixels %g show another texel", cases[i].options, covered, other);
    }
}

static void options_of_textures_are_checked(void **state)
{
    (void)state;
    static const char *const lines[][2] = {
        {"render --scene coin --texture a.png -o no.png", "--texture needs --mesh"},
        {"render --scene coin --nearest -o no.png", "--nearest needs --mesh"},
        {"render --scene coin --smooth -o no.png", "--smooth needs --mesh"},
        {"render --scene coin --texture-bytes 99 -o no.png", "--texture-bytes needs --mesh"},
        {"render --scene coin --texture-to palette -o no.png", "--texture-to needs --mesh"},
        {"render --scene teapot --texture a.png --no-textures -o no.png",
         "give only one of --texture and --no-textures"},
        {"render --scene teapot --nearest --smooth -o no.png", "give only one of --nearest and --smooth"},
        {"render --scene teapot --texture - -o no.png", "cannot come from standard input"},
        {"render --scene teapot --texture-to rgb888 -o no.png", "--texture-to"},
        {"render --scene teapot --texture-bytes 1 -o no.png", "--texture-bytes"}};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char line[200];
        snprintf(line, sizeof line, "$GLINT %s", lines[i][0]);
        assert_refused(line, lines[i][1]);
    }
    make_checker("checker.png");
    assert_fails("$GLINT render --scene teapot --texture none.png -o no.png", "none.png: No such file");
    assert_fails("$GLINT render --scene teapot --texture . -o no.png", ".: this is not a regular file");
    assert_fails("echo >a.png; $GLINT render --scene teapot --texture a.png -o no.png", "a.png: this is not a PNG");
    assert_fails(
        "$GLINT render --scene teapot --texture checker.png --texture-bytes 600 --texture-to palette -o no.png "
        "--format rgb565 --path colour-int8",
        "holds one colour, and the mesh has more");
    assert_fails("$GLINT bake --scene teapot --texture checker.png --texture-bytes 400 --texture-to palette",
                 "its textures do not fit in 400 bytes");
    assert_fails("$GLINT render --scene teapot --texture checker.png --gouraud -o no.png",
                 "--gouraud draws no textures");
#if GLINT_WITH_MESH
    write_text("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_fails("$GLINT render --mesh plain.obj --texture checker.png -o no.png",
                 "plain.obj: has no texture coordinates, which --texture needs");
#endif
    assert_false(exists("no.png"));
    const struct run *result = run("$GLINT bake --scene teapot --texture checker.png --texture-to palette --json");
    assert_contains(result->out, "\"picture\": \"checker.png\"");
    assert_contains(result->out, "\"format\": \"palette\"");
    assert_int_equal(number_in(result->out, "\"width\""), 64);
    result = run("name=$(printf 'r\\351d.png') && cp checker.png \"$name\" && "
                 "$GLINT bake --scene teapot --texture \"$name\" --json");
    assert_contains(result->out, "\"picture\": \"r?d.png\"");
    assert_contains(run("$GLINT bake --scene teapot --texture checker.png")->out,
                    "texture checker.png: 64x64, rgb565, 7 pictures, each of half the size: 10922 bytes of these");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_of_different_places_in_a_picture_stay_apart),
        cmocka_unit_test(splitting_and_ordering_keep_places_in_the_picture),
        cmocka_unit_test(places_are_moved_by_whole_repeats_and_as_fine_as_fits),
        cmocka_unit_test(textures_fit_their_budget_and_powers_of_two_stay_such),
        cmocka_unit_test(smaller_pictures_are_means_in_linear_light),
        cmocka_unit_test(a_palette_of_few_colours_is_exact_and_one_of_many_is_near),
#if GLINT_WITH_MESH
        cmocka_unit_test(an_obj_wears_the_picture_that_its_material_names),
        cmocka_unit_test(a_texture_that_one_colour_hides_is_named_in_a_line),
        cmocka_unit_test(a_gltf_names_its_picture_or_holds_it),
        cmocka_unit_test(a_gltf_says_how_its_picture_is_taken),
        cmocka_unit_test(roughness_and_metal_become_shininess_and_highlight),
        cmocka_unit_test(a_texture_that_cannot_be_drawn_is_left_out_with_one_line),
        cmocka_unit_test(an_output_that_is_a_texture_of_the_mesh_is_refused_and_kept),
#if GLINT_WITH_JPEG
        cmocka_unit_test(a_jpeg_is_read_as_a_png_is),
#endif
        cmocka_unit_test(colours_of_vertices_give_way_to_textures_with_a_word),
#endif
        cmocka_unit_test(a_textured_teapot_is_near_double_precision),
        cmocka_unit_test(options_of_textures_are_checked),
    };
    return cmocka_run_group_tests_name("mesh textures", tests, scratch_make, scratch_remove);
}
