/* SPDX-License-Identifier: MIT
 * The child sends what it read through a pipe, and the parent believes nothing of it. */
#include "mesh/import.h"

#include "base/message.h"

#if GLINT_WITH_MESH
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "glint.h"

#include "base/memory.h"
#include "base/output.h"
#include "mesh/import_child.h"
#include "mesh/import_files.h"
#include "mesh/import_picture.h"
#include "base/child.h"
#include "mesh/import_source.h"

enum { PARTS_MAX = 4096, PICTURES_BYTES_MAX = 1 << 28, PICTURES_PIXELS_MAX = 1 << 26 };

struct reader {
    const struct import_source *source;
    struct child child;
};

static void receive(struct reader *reader, void *to, size_t bytes)
{
    const char *wrong = child_receive(&reader->child, to, bytes);
    if (wrong)
        fail("%s: %s", reader->source->name, wrong);
}

static void receive_files(struct reader *reader, uint64_t count)
{
    struct import_file file;
    if (count > IMPORT_FILES_MAX)
        fail("%s: names more than %d files; export it again, in one file", reader->source->name, IMPORT_FILES_MAX);
    for (uint64_t i = 0; i < count; i++) {
        receive(reader, &file, sizeof file);
        output_never_number(file.device, file.number);
    }
}

/* A texture that cannot be drawn leaves the mesh, in the material's colour. */
static void receive_pictures(struct reader *reader, struct soup *soup)
{
    struct import_picture_head head;
    size_t bytes_left = PICTURES_BYTES_MAX, pixels_left = PICTURES_PIXELS_MAX;
    for (unsigned i = 0; i < soup->picture_count; i++) {
        struct mesh_picture *picture = &soup->pictures[i];
        receive(reader, &head, sizeof head);
        head.message[sizeof head.message - 1] = head.name[sizeof head.name - 1] = 0;
        if (head.len > bytes_left)
            fail("%s: its textures have more than %d MB; save smaller ones", soup->name, PICTURES_BYTES_MAX >> 20);
        bytes_left -= head.len;
        uint8_t *bytes = allocate(head.len + 1, 1);
        receive(reader, bytes, head.len);
        const char *wrong = head.message[0] ? head.message : import_picture_decode(picture, head.name, bytes, head.len);
        free(bytes);
        const size_t pixels = (size_t)picture->width * picture->height; /* which take as long in one that is damaged */
        if (wrong) {
            warn("%s: texture %s is left out: %s", soup->name, head.name, wrong);
            mesh_picture_clear(picture);
        }
        if (pixels > pixels_left)
            fail("%s: its textures have more than %d pixels, those that are left out counted; save smaller ones",
                 soup->name, PICTURES_PIXELS_MAX);
        pixels_left -= pixels;
    }
}

/* What is sent for a bool may be neither. */
static bool truth(const bool *sent)
{
    uint8_t byte;
    memcpy(&byte, sent, sizeof byte);
    return byte != 0;
}

/* Of NaN 0. */
static double in_unit(double sent)
{
    return fmin(1, fmax(0, sent));
}

static void receive_material(struct reader *reader, struct mesh_material *material)
{
    bool *const flags[] = {&material->has_color,     &material->unlit,      &material->has_highlight,
                           &material->has_roughness, &material->is_nearest, &material->clamps};
    receive(reader, material, sizeof *material);
    for (size_t i = 0; i < sizeof flags / sizeof *flags; i++)
        *flags[i] = truth(flags[i]);
    if (material->n > GLINT_N_MAX)
        material->n = GLINT_N_MAX;
    material->roughness = in_unit(material->roughness);
    material->metallic = in_unit(material->metallic);
    for (int k = 0; k < 3; k++)
        material->highlight[k] = in_unit(material->highlight[k]);
}

/* Each is to have its line's end. */
static void say_notes(const char *name, char *notes, size_t size)
{
    notes[size - 1] = 0;
    for (char *end; (end = strchr(notes, '\n')); notes = end + 1) {
        *end = 0;
        warn("%s: %s", name, notes);
    }
}

/* libassimp's places are floats: so far away they have fewer than 4096 steps over the mesh. */
static void say_if_coarse(const struct soup *soup)
{
    enum { SIZES = 2048 };
    double far = 0, size = 0;
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < 3 * soup->face_count; i++) {
            low = fmin(low, soup->faces[i / 3].places[i % 3][k]);
            high = fmax(high, soup->faces[i / 3].places[i % 3][k]);
        }
        far = fmax(far, fmax(fabs(low), fabs(high)));
        size = fmax(size, high - low);
    }
    if (far > SIZES * size)
        warn("%s: lies so far from its origin that its places are rounded; move it there, or export it as OBJ",
             soup->name);
}

static struct soup *receive_soup(struct reader *reader)
{
    struct import_head head;
    receive(reader, &head, sizeof head);
    head.message[sizeof head.message - 1] = 0;
    if (head.message[0])
        fail("%s: %s cannot read this mesh: %s", reader->source->name, reader->child.reader, head.message);
    head.refused[sizeof head.refused - 1] = 0;
    if (head.refused[0])
        warn("%s: names %s, which is left out: %s", reader->source->name, head.refused,
             import_files_outside(reader->source));
    say_notes(reader->source->name, head.notes, sizeof head.notes);
    receive_files(reader, head.file_count);
    soup_check_count(reader->source->name, head.face_count);
    if (head.part_count == 0 || head.part_count > PARTS_MAX)
        fail("%s: has %llu materials; at most %d can be read; join some", reader->source->name,
             (unsigned long long)head.part_count, PARTS_MAX);
    struct soup *soup = allocate(1, sizeof *soup);
    *soup = (struct soup){.name = copied(reader->source->name),
                          .face_count = head.face_count,
                          .has_normals = truth(&head.has_normals),
                          .has_uv = truth(&head.has_uv),
                          .has_colors = truth(&head.has_colors),
                          .has_facet_colors = truth(&head.has_facet_colors),
                          .is_stl = strcmp(reader->source->ending, ".stl") == 0,
                          .part_count = (unsigned)head.part_count};
    if (head.picture_count > 2 * (uint64_t)soup->part_count)
        fail("%s: has more than two textures a material; export it again", soup->name);
    soup->picture_count = (unsigned)head.picture_count;
    soup->materials = allocate(soup->part_count, sizeof *soup->materials);
    soup->pictures = allocate(soup->picture_count + 1, sizeof *soup->pictures);
    soup->faces = allocate(soup->face_count, sizeof *soup->faces);
    for (unsigned i = 0; i < soup->part_count; i++)
        receive_material(reader, &soup->materials[i]);
    receive_pictures(reader, soup);
    receive(reader, soup->faces, soup->face_count * sizeof *soup->faces);
    soup_check_faces(soup);
    if (strcmp(reader->source->ending, ".obj") != 0)
        say_if_coarse(soup);
    return soup;
}

static void run_child(const void *source, int out)
{
    import_child(source, out);
}

/* In the child a folder that is not there would only allow nothing. */
static void check_allowed(const char *folder)
{
    struct stat status;
    if (stat(folder, &status) != 0)
        fail("--allow-files: %s: %s", folder, strerror(errno));
    if (!S_ISDIR(status.st_mode))
        fail("--allow-files: %s: this is a file; name a folder", folder);
}

struct soup *import_soup(const char *path, bool textures, const char *allowed)
{
    if (allowed)
        check_allowed(allowed);
    struct import_source *source = import_source_open(path);
    source->textures = textures;
    source->allowed = allowed;
    struct reader reader = {.source = source};
    child_start(&reader.child, source->name, strcmp(source->ending, ".obj") == 0 ? "glint" : "libassimp", run_child,
                source);
    struct soup *soup = receive_soup(&reader);
    child_end(&reader.child);
    import_source_free(source);
    return soup;
}

#define TEXT(x) #x
#define TEXT_OF(x) TEXT(x)
const char *import_library(void)
{
    return "libassimp " TEXT_OF(GLINT_WITH_MESH);
}

#else

struct soup *import_soup(const char *path, bool textures, const char *allowed)
{
    (void)textures;
    (void)allowed;
    fail("%s: glint was built without libassimp, which reads meshes; install libassimp-dev and build glint again",
         path);
}

const char *import_library(void)
{
    return NULL;
}

#endif
