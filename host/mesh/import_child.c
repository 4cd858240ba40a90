/* SPDX-License-Identifier: MIT */
#include "mesh/import_child.h"

#if GLINT_WITH_MESH
#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "glint_mesh.h"
#include "mesh/import_files.h"

/* Loaded here only: commands that read no mesh start without it. */
#define FUNCTIONS(X)                                                                                                   \
    X(aiImportFileEx)                                                                                                  \
    X(aiGetErrorString)                                                                                                \
    X(aiGetMaterialColor)                                                                                              \
    X(aiGetMaterialFloatArray)                                                                                         \
    X(aiGetMaterialIntegerArray)
#define POINTER(name) __typeof__(name) *name;
static struct {
    FUNCTIONS(POINTER)
} lib;
#define TEXT(x) #x
#define TEXT_OF(x) TEXT(x)
#define LIBRARY "libassimp.so." TEXT_OF(GLINT_WITH_MESH)

static bool load(void)
{
    void *handle = dlopen(LIBRARY, RTLD_NOW);
    bool good = handle != NULL;
#define FIND(name) good = good && (*(void **)&lib.name = dlsym(handle, #name)) != NULL;
    FUNCTIONS(FIND)
    return good;
}

/* The parent may be gone: then there is nobody to tell. */
static void send(int out, const void *from, size_t bytes)
{
    for (const uint8_t *at = from; bytes;) {
        const ssize_t sent = write(out, at, bytes);
        if (sent <= 0)
            _exit(1);
        at += sent;
        bytes -= (size_t)sent;
    }
}

static void send_message(int out, const char *text)
{
    struct import_head head = {.face_count = 0};
    snprintf(head.message, sizeof head.message, "%s", text[0] ? text : "it is damaged");
    send(out, &head, sizeof head);
}

/* glTF's colours are linear, the others' as encoded. */
static uint8_t level(double part, bool linear)
{
    double value = fmin(1, fmax(0, part)); /* of NaN 0 */
    if (linear)
        value = value <= .0031308 ? 12.92 * value : 1.055 * pow(value, 1 / 2.4) - .055;
    return (uint8_t)lround(255 * value);
}

static struct mesh_material material_of(const struct aiMaterial *from, bool linear)
{
    struct mesh_material material = {.has_color = false};
    struct aiColor4D color;
    float n = 0;
    int shading = 0;
    unsigned one = 1;
    if (lib.aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &color) == aiReturn_SUCCESS) {
        const float parts[3] = {color.r, color.g, color.b};
        material.has_color = true;
        for (int k = 0; k < 3; k++)
            material.color[k] = level((double)parts[k], linear);
    }
    if (!linear && lib.aiGetMaterialFloatArray(from, AI_MATKEY_SHININESS, &n, &one) == aiReturn_SUCCESS && n >= 1)
        material.n = (unsigned)fmin(1000, (double)n); /* an OBJ's Ns; a glTF has another model */
    one = 1;
    if (lib.aiGetMaterialIntegerArray(from, AI_MATKEY_SHADING_MODEL, &shading, &one) == aiReturn_SUCCESS)
        material.unlit = shading == aiShadingMode_NoShading; /* glTF's unlit, too */
    return material;
}

/* Of a mesh with its material: the colours of its vertices, which a glTF's base colour is times and which else stand in the place of the
 * material's; without them the material's. */
struct colors {
    const struct aiColor4D *of_vertices;
    double times[3];
    uint8_t own[3];
    bool linear;
};

static struct colors colors_of(const struct aiScene *scene, const struct aiMesh *mesh, bool linear)
{
    struct colors colors = {mesh->mColors[0], {1, 1, 1}, {255, 255, 255}, linear};
    struct aiColor4D base;
    if (mesh->mMaterialIndex >= scene->mNumMaterials)
        return colors; /* the parent refuses it */
    const struct aiMaterial *from = scene->mMaterials[mesh->mMaterialIndex];
    const struct mesh_material material = material_of(from, linear);
    if (material.has_color)
        memcpy(colors.own, material.color, sizeof colors.own);
    if (linear && lib.aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &base) == aiReturn_SUCCESS) {
        colors.times[0] = (double)base.r;
        colors.times[1] = (double)base.g;
        colors.times[2] = (double)base.b;
    }
    return colors;
}

static void set_color(uint8_t out[3], const struct colors *colors, unsigned vertex)
{
    memcpy(out, colors->own, sizeof colors->own);
    if (!colors->of_vertices)
        return;
    const struct aiColor4D *color = &colors->of_vertices[vertex];
    const double parts[3] = {(double)color->r, (double)color->g, (double)color->b};
    for (int k = 0; k < 3; k++)
        out[k] = level(parts[k] * colors->times[k], colors->linear);
}

static void send_faces(int out, const struct aiMesh *mesh, const struct import_head *head, const struct colors *colors)
{
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *from = &mesh->mFaces[i];
        struct soup_face face = {.part = mesh->mMaterialIndex};
        if (from->mNumIndices != 3)
            continue; /* points and lines */
        for (int k = 0; k < 3; k++) {
            const struct aiVector3D *place = &mesh->mVertices[from->mIndices[k]];
            const double at[3] = {(double)place->x, (double)place->y, (double)place->z};
            memcpy(face.places[k], at, sizeof at);
            if (head->has_colors)
                set_color(face.colors[k], colors, from->mIndices[k]);
            if (!head->has_normals)
                continue;
            const struct aiVector3D *normal = &mesh->mNormals[from->mIndices[k]];
            const double points[3] = {(double)normal->x, (double)normal->y, (double)normal->z};
            memcpy(face.normals[k], points, sizeof points);
        }
        send(out, &face, sizeof face);
    }
}

/* What libassimp makes of an STL's colours of facets is not what is in the file. */
static struct import_head head_of(const struct aiScene *scene, bool is_stl)
{
    struct import_head head = {.has_normals = true, .part_count = scene->mNumMaterials};
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        for (unsigned k = 0; k < mesh->mNumFaces; k++)
            head.face_count += mesh->mFaces[k].mNumIndices == 3;
        head.has_normals &= mesh->mNormals != NULL;
        head.has_textures |= mesh->mTextureCoords[0] != NULL;
        head.has_colors |= mesh->mColors[0] != NULL && !is_stl;
        head.has_facet_colors |= mesh->mColors[0] != NULL && is_stl;
    }
    return head;
}

static const struct aiScene *read_scene(const struct import_source *source)
{
    const unsigned steps = aiProcess_Triangulate | aiProcess_PreTransformVertices;
    char input[32];
    snprintf(input, sizeof input, "%s%s", import_files_input, source->ending);
    return lib.aiImportFileEx(source->path ? source->path : input, steps, import_files(source));
}

void import_child(const struct import_source *source, int out)
{
    const bool linear = strcmp(source->ending, ".gltf") == 0 || strcmp(source->ending, ".glb") == 0;
    if (!load()) {
        send_message(out, LIBRARY " cannot be loaded; install libassimp5");
        return;
    }
    if (!freopen("/dev/null", "w", stderr) || !freopen("/dev/null", "w", stdout))
        _exit(1);
    const struct aiScene *scene = read_scene(source);
    if (!scene) {
        const char *text = lib.aiGetErrorString();
        send_message(out,
                     !source->path && strstr(text, import_files_input) ? "" : text); /* the message names it already */
        return;
    }
    struct import_head head = head_of(scene, strcmp(source->ending, ".stl") == 0);
    const struct import_file *files;
    head.file_count = import_files_read(&files);
    send(out, &head, sizeof head);
    send(out, files, head.file_count * sizeof *files);
    if (head.face_count > GLINT_MESH_FACES_MAX)
        return; /* the parent says so */
    for (unsigned i = 0; i < scene->mNumMaterials; i++) {
        const struct mesh_material material = material_of(scene->mMaterials[i], linear);
        send(out, &material, sizeof material);
    }
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct colors colors = colors_of(scene, scene->mMeshes[i], linear);
        send_faces(out, scene->mMeshes[i], &head, &colors);
    }
}

#else

void import_child(const struct import_source *source, int out)
{
    (void)source;
    (void)out;
}

#endif
