/* SPDX-License-Identifier: MIT
 * Fuzzes what glint takes from the child that reads a mesh, which the file may have taken over: a mesh that is whole comes of it, or a reason. Input: which mesh and how it is
 * made ready (1), then what the child sends, shorter: counts in few bytes, coordinates by sixteenths, and anything where they are told to be so. */
#include <math.h>

#include "fuzz_child.h"
#include "mesh/import_child.h"
#include "mesh/import_files.h"
#include "mesh/import_picture.h"
#include "mesh/load.h"

static unsigned how;
enum { FACES_SPLIT = 200 }; /* more take long */

/* ---- for import.c ---- */

struct import_source *import_source_open(const char *path)
{
    static const char *const endings[] = {".obj", ".stl", ".ply", ".gltf"};
    struct import_source *source = calloc(1, sizeof *source);
    *source = (struct import_source){.name = path, .path = path, .ending = endings[how & 3]};
    return source;
}

void import_source_free(struct import_source *source)
{
    free(source);
}

void import_child(const struct import_source *source, int out)
{
    (void)source;
    (void)out;
}

const char *import_files_outside(const struct import_source *source)
{
    (void)source;
    return "it lies outside";
}

const char *import_picture_decode(struct mesh_picture *picture, const char *name, const void *bytes, size_t len)
{
    const uint8_t *of = bytes;
    if (len < 2 || of[0] == 0 || of[0] > 8 || of[1] == 0 || of[1] > 8)
        return "it is damaged";
    *picture = (struct mesh_picture){strdup(name), of[0], of[1], malloc((size_t)3 * of[0] * of[1])};
    memset(picture->rgb, of[len - 1], (size_t)3 * of[0] * of[1]);
    return NULL;
}

struct mesh_picture import_picture(const char *path)
{
    (void)path; /* no --texture is given */
    abort();
}

/* ---- */

static void send_bytes(struct input *input, void *to, size_t len)
{
    for (size_t i = 0; i < len; i++)
        ((uint8_t *)to)[i] = (uint8_t)next_byte(input);
    child_send(0, to, len);
}

static uint64_t next_count(struct input *input)
{
    const unsigned count = next_byte(input);
    return count < 200 ? count : (uint64_t)next_word(input) << (count - 200);
}

static double next_number(struct input *input)
{
    const unsigned sixteenths = next_byte(input);
    return sixteenths < 250    ? ((double)sixteenths - 125) / 16
           : sixteenths == 250 ? NAN
                               : pow(10, next_byte(input) * 1.2);
}

static void send_face(struct input *input, uint64_t parts)
{
    struct soup_face face = {.part = 0};
    for (int k = 0; k < 9; k++) {
        face.places[k / 3][k % 3] = next_number(input);
        face.colors[k / 3][k % 3] = (uint8_t)next_byte(input);
    }
    for (int k = 0; k < 9; k++)
        face.normals[k / 3][k % 3] = next_number(input);
    for (int k = 0; k < 6; k++)
        face.uv[k / 2][k % 2] = next_number(input);
    face.part = (uint32_t)next_byte(input);
    face.part = face.part < 200 && parts ? face.part % (uint32_t)parts : face.part;
    child_send(0, &face, sizeof face);
}

/* As far as the input goes: what is missing the child has not sent. */
static void send_all(struct input *input)
{
    struct import_head head = {.message = ""};
    const unsigned words = next_byte(input);
    memset(head.message, words & 1 ? 'm' : 0, words & 2 ? sizeof head.message : 9);
    memset(head.refused, words & 4 ? 'r' : 0, words & 8 ? sizeof head.refused : 9);
    memset(head.notes, words & 16 ? 'n' : 0, words & 32 ? sizeof head.notes : 9);
    head.notes[99] = words & 64 ? '\n' : head.notes[99];
    head.face_count = next_count(input);
    head.part_count = next_count(input);
    head.file_count = next_count(input);
    head.picture_count = next_count(input);
    bool *const flags[] = {&head.has_normals, &head.has_uv, &head.has_colors, &head.has_facet_colors};
    for (int i = 0; i < 4; i++)
        memcpy(flags[i], &(uint8_t){(uint8_t)next_byte(input)}, 1);
    child_send(0, &head, sizeof head);
    for (uint64_t i = 0; i < head.file_count && input->at < input->end; i++)
        send_bytes(input, &(struct import_file){0}, sizeof(struct import_file));
    for (uint64_t i = 0; i < head.part_count && input->at < input->end; i++)
        send_bytes(input, &(struct mesh_material){0}, sizeof(struct mesh_material));
    for (uint64_t i = 0; i < head.picture_count && input->at < input->end; i++) {
        struct import_picture_head of = {.len = next_count(input)};
        uint8_t bytes[8];
        memset(of.name, 'n', next_byte(input) & 1 ? sizeof of.name : 5);
        memset(of.message, 'm', next_byte(input) & 1 ? sizeof of.message : 0);
        child_send(0, &of, sizeof of);
        send_bytes(input, bytes, of.len < sizeof bytes ? of.len : sizeof bytes);
    }
    for (uint64_t i = 0; i < head.face_count && input->at < input->end; i++)
        send_face(input, head.part_count);
}

static void load(void *of)
{
    struct input *input = of;
    const struct mesh_source source = {.name = "a mesh",
                                       .crease = how & 4 ? 40 : -1,
                                       .split = how & 8 ? 20 : 0,
                                       .flipped = how & 16,
                                       .axes = how & 32 ? AXES_Z_UP : AXES_USUAL,
                                       .no_textures = how & 64,
                                       .wish = {.palette = how & 128},
                                       .faces_most = FACES_SPLIT};
    send_all(input);
    child.answers = true;
    struct mesh *mesh = mesh_load(&source);
    if (!mesh)
        return;
    check(mesh->vertex_count && mesh->face_count && mesh->part_count &&
          mesh->ends[mesh->part_count - 1] == mesh->face_count);
    for (size_t i = 0; i < 3 * mesh->face_count; i++)
        check(mesh->faces[i / 3][i % 3] < mesh->vertex_count);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        check(mesh->at[i] < mesh->place_count);
        check(fabs(mesh_dot(mesh->normals[i], mesh->normals[i]) - 1) < 1e-6);
    }
    for (unsigned i = 0; i < mesh->part_count; i++) {
        double look[3][3] = {{0}};
        check(mesh->materials[i].picture <= mesh->picture_count && mesh->materials[i].n <= GLINT_N_MAX);
        mesh_material_look(&mesh->materials[i], look[0], look[1], look[2]);
        for (unsigned k = 0; k < 9; k++)
            check(look[k / 3][k % 3] >= 0 && look[k / 3][k % 3] <= 1);
    }
    mesh_free(mesh);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    how = next_byte(&input);
    unwind_run(load, &input);
    child_forget();
    return 0;
}
