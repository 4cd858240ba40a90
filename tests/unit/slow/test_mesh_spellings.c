/* SPDX-License-Identifier: MIT
 * Meshes from files, whatever program wrote them: random ones in each format and in every spelling of numbers have one shape. */
#include "files.h"

#include "mesh/import.h"

#if GLINT_WITH_MESH
enum { VERTICES_MAX = 12, FACES_MAX = 10, MILLIONTHS = 15625 /* a 64th */ };
struct random_mesh {
    unsigned vertices, faces;
    int places[VERTICES_MAX][3]; /* in 64ths */
    unsigned corners[FACES_MAX][3];
};

static unsigned state = 20261;
static unsigned below(unsigned n)
{
    state = state * 1664525 + 1013904223;
    return (state >> 10) % n;
}

static struct random_mesh next_mesh(void)
{
    struct random_mesh mesh = {.vertices = 3 + below(VERTICES_MAX - 2), .faces = 1 + below(FACES_MAX)};
    for (unsigned i = 0; i < 3 * mesh.vertices; i++)
        mesh.places[i / 3][i % 3] = (int)below(1025) - 512;
    for (unsigned i = 0; i < mesh.faces; i++) {
        const unsigned first = below(mesh.vertices), second = 1 + below(mesh.vertices - 2);
        const unsigned third = second + 1 + below(mesh.vertices - 1 - second);
        mesh.corners[i][0] = first;
        mesh.corners[i][1] = (first + second) % mesh.vertices;
        mesh.corners[i][2] = (first + third) % mesh.vertices;
    }
    return mesh;
}

/* .5, 5., +1, -0.25, 1e-3, 12.5E+01, 007 and the like, of a number in 64ths; exact. */
static const char *spelled(int in_64ths)
{
    static char text[64];
    char digits[40], exponent[16] = "";
    const int power = below(3) ? 0 : (int)below(9) - 4;
    sprintf(digits, "%020lld", llabs((long long)in_64ths * MILLIONTHS));
    const int point = 20 - 6 - power; /* so many of the digits stand before it */
    const char *before = digits;
    char *behind = strdup(digits + point);
    digits[point] = 0;
    const size_t keep = below(4) ? 0 : 1 + below(3); /* zeros in front */
    before += strspn(before, "0");
    for (size_t i = 0; i < keep && before > digits; i++)
        before--;
    size_t len = strlen(behind);
    while (len > 0 && behind[len - 1] == '0' && below(8))
        len--;
    behind[len] = 0;
    if (!*before && (!len || below(2)))
        before = "0";
    if (power)
        sprintf(exponent, "%c%s%d", below(2) ? 'e' : 'E', power > 0 && below(2) ? "+" : "", power);
    snprintf(text, sizeof text, "%s%s%s%s%s",
             in_64ths < 0 ? "-"
             : below(6)   ? ""
                          : "+",
             before, len || !below(3) ? "." : "", behind, exponent);
    free(behind);
    return text;
}

static const char *blanks(void)
{
    static const char *const kinds[] = {" ", " ", " ", "  ", "\t", " \\\n ", " \\\r\n\t"};
    return kinds[below(sizeof kinds / sizeof *kinds)];
}

static void write_obj(const struct random_mesh *mesh, FILE *file)
{
    static const char *const ends[] = {"\n", "\n", "\r\n", " \n", "\n\n", "\n# v 9 9 9\n", " # v\n"};
    for (unsigned i = 0; i < mesh->vertices; i++) {
        const char *const first = below(8) ? "" : "  ";
        fprintf(file, "%sv", first);
        for (int k = 0; k < 3; k++)
            fprintf(file, "%s%s", blanks(), spelled(mesh->places[i][k]));
        fprintf(file, "%s", ends[below(sizeof ends / sizeof *ends)]);
    }
    for (unsigned i = 0; i < mesh->faces; i++) {
        fprintf(file, "f");
        for (int k = 0; k < 3; k++) {
            const int corner = (int)mesh->corners[i][k];
            fprintf(file, "%s%d", blanks(), below(3) ? corner + 1 : corner - (int)mesh->vertices);
        }
        fprintf(file, "%s", i + 1 < mesh->faces || below(2) ? ends[below(sizeof ends / sizeof *ends)] : "");
    }
}

static void write_ply(const struct random_mesh *mesh, FILE *file)
{
    fprintf(file, "ply\nformat ascii 1.0\nelement vertex %u\nproperty float x\nproperty float y\nproperty float z\n",
            mesh->vertices);
    fprintf(file, "element face %u\nproperty list uchar int vertex_indices\nend_header\n", mesh->faces);
    for (unsigned i = 0; i < mesh->vertices; i++)
        for (int k = 0; k < 3; k++)
            fprintf(file, "%s%c", spelled(mesh->places[i][k]), " \n"[k == 2]);
    for (unsigned i = 0; i < mesh->faces; i++)
        fprintf(file, "3 %u %u %u\n", mesh->corners[i][0], mesh->corners[i][1], mesh->corners[i][2]);
}

static void write_stl(const struct random_mesh *mesh, FILE *file)
{
    fprintf(file, "solid a\n");
    for (unsigned i = 0; i < mesh->faces; i++) {
        fprintf(file, " facet normal 0 0 0\n  outer loop\n");
        for (int k = 0; k < 3; k++) {
            fprintf(file, "   vertex");
            for (int j = 0; j < 3; j++)
                fprintf(file, " %s", spelled(mesh->places[mesh->corners[i][k]][j]));
            fprintf(file, "\n");
        }
        fprintf(file, "  endloop\n endfacet\n");
    }
    fprintf(file, "endsolid a\n");
}

static void write_gltf(const struct random_mesh *mesh, FILE *file)
{
    const unsigned bytes = 12 * mesh->vertices;
    FILE *numbers = fopen("a.bin", "wb");
    assert_non_null(numbers);
    for (unsigned i = 0; i < 3 * mesh->vertices; i++) {
        const float place = (float)mesh->places[i / 3][i % 3] / 64;
        fwrite(&place, 4, 1, numbers);
    }
    for (unsigned i = 0; i < 3 * mesh->faces; i++)
        fwrite(&mesh->corners[i / 3][i % 3], 4, 1, numbers);
    assert_int_equal(fclose(numbers), 0);
    fprintf(file,
            "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
            "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
            "\"buffers\":[{\"byteLength\":%u,\"uri\":\"a.bin\"}],"
            "\"bufferViews\":[{\"buffer\":0,\"byteLength\":%u},{\"buffer\":0,\"byteOffset\":%u,\"byteLength\":%u}],"
            "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%u,\"type\":\"VEC3\","
            "\"min\":[-8,-8,-8],\"max\":[8,8,8]},"
            "{\"bufferView\":1,\"componentType\":5125,\"count\":%u,\"type\":\"SCALAR\"}]}",
            bytes + 12 * mesh->faces, bytes, bytes, 12 * mesh->faces, mesh->vertices, 3 * mesh->faces);
}

static void assert_shape(const struct random_mesh *mesh, const char *path)
{
    struct soup *soup = import_soup(path, false, NULL);
    assert_int_equal(soup->face_count, mesh->faces);
    for (unsigned i = 0; i < 9 * mesh->faces; i++) {
        const double place = soup->faces[i / 9].places[i / 3 % 3][i % 3];
        const int wanted = mesh->places[mesh->corners[i / 9][i / 3 % 3]][i % 3];
        if (place - wanted / 64. > 1e-5 || place - wanted / 64. < -1e-5)
            fail_msg("%s: triangle %u, corner %u: %g instead of %g; %s", path, i / 9, i / 3 % 3, place, wanted / 64.,
                     whole_file(path));
    }
    soup_free(soup);
}

static void one_mesh_has_one_shape_in_every_format_and_spelling(void **unused)
{
    (void)unused;
    static const struct {
        const char *path;
        void (*write)(const struct random_mesh *mesh, FILE *file);
    } formats[] = {{"a.obj", write_obj}, {"a.ply", write_ply}, {"a.obj", write_obj},
                   {"a.stl", write_stl}, {"a.obj", write_obj}, {"a.gltf", write_gltf}};
    for (unsigned i = 0; i < 1000; i++) {
        const struct random_mesh mesh = next_mesh();
        for (unsigned k = 2 * (i % 3); k < 2 * (i % 3) + 2; k++) {
            FILE *file = fopen(formats[k].path, "w");
            assert_non_null(file);
            formats[k].write(&mesh, file);
            assert_int_equal(fclose(file), 0);
            assert_shape(&mesh, formats[k].path);
        }
    }
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
#if GLINT_WITH_MESH
        cmocka_unit_test(one_mesh_has_one_shape_in_every_format_and_spelling),
#endif
        {NULL, NULL, NULL, NULL, NULL}
    };
    return _cmocka_run_group_tests("mesh spellings", tests, sizeof tests / sizeof *tests - 1, scratch_make,
                                   scratch_remove);
}
