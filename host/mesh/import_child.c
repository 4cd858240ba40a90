/* SPDX-License-Identifier: MIT */
#include "mesh/import_child.h"

#if GLINT_WITH_MESH
#include <assimp/GltfMaterial.h>
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

#include "base/memory.h"
#include "glint_mesh.h"
#include "mesh/gltf_check.h"
#include "mesh/import_files.h"
#include "mesh/import_obj.h"
#include "mesh/import_picture.h"
#include "base/child.h"
#include "mesh/import_texture.h"
#include "mesh/ply_check.h"
#include "mesh/polygon.h"
#include "mesh/stl_check.h"

/* Loaded here only: commands that read no mesh start without it. */
#define FUNCTIONS(X)                                                                                                   \
    X(aiImportFileEx)                                                                                                  \
    X(aiApplyPostProcessing)                                                                                           \
    X(aiGetErrorString)                                                                                                \
    X(aiGetMaterialColor)                                                                                              \
    X(aiGetMaterialFloatArray)                                                                                         \
    X(aiGetMaterialIntegerArray)                                                                                       \
    X(aiGetMaterialString)
enum { GLTF_NEAREST = 9728 };
#define POINTER(name) __typeof__(name) *name;
static struct {
    FUNCTIONS(POINTER)
} lib;
#define FUNCTION(name) {#name, (void **)&lib.name},
static const struct {
    const char *name;
    void **at;
} functions[] = {FUNCTIONS(FUNCTION)};
#define TEXT(x) #x
#define TEXT_OF(x) TEXT(x)
#define LIBRARY "libassimp.so." TEXT_OF(GLINT_WITH_MESH)

static bool load(void)
{
    void *handle = dlopen(LIBRARY, RTLD_NOW);
    bool good = handle != NULL;
    for (size_t i = 0; good && i < sizeof functions / sizeof *functions; i++)
        good = (*functions[i].at = dlsym(handle, functions[i].name)) != NULL;
    return good;
}

/* A head with what is wrong, as the end of a message. */
static void send_message(int out, const char *text)
{
    struct import_head head = {.face_count = 0};
    snprintf(head.message, sizeof head.message, "%s", text[0] ? text : "it is damaged");
    child_send(out, &head, sizeof head);
}

/* glTF's colours are linear, the others' as encoded. */
static uint8_t level(double part, bool linear)
{
    const double value = fmin(1, fmax(0, part)); /* of NaN 0 */
    return mesh_level(!linear ? value : value <= .0031308 ? 12.92 * value : 1.055 * pow(value, 1 / 2.4) - .055);
}

/* Both are 1 where the file says nothing. */
static void set_roughness(const struct aiMaterial *from, struct mesh_material *material)
{
    float metallic = 1, roughness = 1;
    unsigned one = 1;
    if (lib.aiGetMaterialFloatArray(from, AI_MATKEY_METALLIC_FACTOR, &metallic, &one) != aiReturn_SUCCESS)
        metallic = 1;
    one = 1;
    if (lib.aiGetMaterialFloatArray(from, AI_MATKEY_ROUGHNESS_FACTOR, &roughness, &one) != aiReturn_SUCCESS)
        roughness = 1;
    material->metallic = fmin(1, fmax(0, (double)metallic));
    material->roughness = fmin(1, fmax(0, (double)roughness));
    material->has_roughness = material->metallic < 1 || material->roughness < 1;
}

static struct mesh_material material_of(const struct aiMaterial *from, bool linear)
{
    struct mesh_material material = {.factor = {1, 1, 1}};
    struct aiColor4D color;
    int shading = 0;
    unsigned one = 1;
    if (lib.aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &color) == aiReturn_SUCCESS) {
        const float parts[3] = {color.r, color.g, color.b};
        material.has_color = true;
        for (int k = 0; k < 3; k++)
            material.color[k] = level((double)parts[k], linear);
    }
    /* of an STL or a PLY that tells none; full white would be overexposed */
    if (!linear && (material.color[0] & material.color[1] & material.color[2]) == 255)
        material.has_color = false;
    if (linear)
        set_roughness(from, &material);
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

/* Which of the coordinates are a picture's, and how they lead to it: v down, turned and scaled about 0, 0, then moved. */
struct placing {
    unsigned channel;
    double move[2], scale[2], cosine, sine;
};
static const struct placing plain_placing = {0, {0, 0}, {1, 1}, 1, 0};

/* A glTF's KHR_texture_transform, which libassimp keeps with v up and about other places, but does not carry out right. */
static void set_placing(const struct aiMaterial *from, enum aiTextureType type, struct placing *placing)
{
    float t[5]; /* a move, a scale, a turn */
    unsigned count = 5;
    if (lib.aiGetMaterialFloatArray(from, AI_MATKEY_UVTRANSFORM(type, 0), t, &count) != aiReturn_SUCCESS || count != 5)
        return;
    const double sx = (double)t[2], sy = (double)t[3], c = cos((double)t[4]), s = -sin((double)t[4]);
    *placing = (struct placing){placing->channel,
                                {(double)t[0] - sx * (1 + s - c) / 2, 1 - sy + sy * (s + c - 1) / 2 - (double)t[1]},
                                {sx, sy},
                                c,
                                s};
}

static void lead(const struct placing *placing, const struct aiVector3D *from, double uv[2])
{
    const double u = placing->scale[0] * (double)from->x, v = placing->scale[1] * (1 - (double)from->y);
    uv[0] = placing->move[0] + placing->cosine * u + placing->sine * v;
    uv[1] = placing->move[1] - placing->sine * u + placing->cosine * v;
}

static void send_faces(int out, const struct aiMesh *mesh, const struct import_head *head, const struct colors *colors,
                       const struct placing *placing)
{
    const struct aiVector3D *uv =
        placing->channel < AI_MAX_NUMBER_OF_TEXTURECOORDS ? mesh->mTextureCoords[placing->channel] : NULL;
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *from = &mesh->mFaces[i];
        struct soup_face face = {.part = mesh->mMaterialIndex};
        if (from->mNumIndices != 3)
            continue; /* points and lines */
        for (int k = 0; k < 3; k++) {
            const struct aiVector3D *place = &mesh->mVertices[from->mIndices[k]];
            const double at[3] = {(double)place->x, (double)place->y, (double)place->z};
            memcpy(face.places[k], at, sizeof at);
            if (uv)
                lead(placing, &uv[from->mIndices[k]], face.uv[k]);
            if (head->has_colors)
                set_color(face.colors[k], colors, from->mIndices[k]);
            if (!mesh->mNormals)
                continue;
            const struct aiVector3D *normal = &mesh->mNormals[from->mIndices[k]];
            const double points[3] = {(double)normal->x, (double)normal->y, (double)normal->z};
            memcpy(face.normals[k], points, sizeof points);
        }
        child_send(out, &face, sizeof face);
    }
}

/* Faces of more corners become triangles, which are never freed; libassimp's own leave what has dents in part, and cover what is beside it. */
static bool cut_face(const struct aiMesh *mesh, const struct aiFace *from, struct aiFace *to)
{
    const size_t count = from->mNumIndices;
    double(*places)[3] = allocate(count, sizeof *places);
    size_t(*triangles)[3] = allocate(count - 2, sizeof *triangles);
    unsigned *corners = allocate(count - 2, 3 * sizeof *corners);
    for (size_t i = 0; i < count; i++) {
        const struct aiVector3D *place = &mesh->mVertices[from->mIndices[i]];
        places[i][0] = (double)place->x;
        places[i][1] = (double)place->y;
        places[i][2] = (double)place->z;
    }
    const bool is_cut = polygon_cut((const double(*)[3])places, count, triangles);
    for (size_t i = 0; is_cut && i < count - 2; i++) {
        to[i] = (struct aiFace){3, corners + 3 * i};
        for (int k = 0; k < 3; k++)
            corners[3 * i + (size_t)k] = from->mIndices[triangles[i][k]];
    }
    free(places);
    free(triangles);
    return is_cut;
}

static bool cut_faces(struct aiMesh *mesh)
{
    size_t count = 0, most = 0, sum = 0;
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const size_t corners = mesh->mFaces[i].mNumIndices;
        most = corners > most ? corners : most;
        sum += corners > 2 ? corners - 2 : 0;
    }
    if (most <= 3)
        return true;
    struct aiFace *faces = allocate(sum, sizeof *faces);
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const size_t corners = mesh->mFaces[i].mNumIndices;
        if (corners > 2 && !cut_face(mesh, &mesh->mFaces[i], faces + count))
            return false;
        count += corners > 2 ? corners - 2 : 0;
    }
    mesh->mFaces = faces;
    mesh->mNumFaces = (unsigned)sum;
    return true;
}

/* Returns what is wrong, or NULL. */
static const char *cut_scene(const struct aiScene *scene)
{
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        if (!cut_faces(scene->mMeshes[i]))
            return "a face has too many corners and dents; cut it into triangles";
    return NULL;
}

/* What libassimp makes of an STL's colours of facets is not what is in the file. */
static void add_scene(struct import_head *head, const struct aiScene *scene, bool is_stl)
{
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        const uint64_t before = head->face_count;
        for (unsigned k = 0; k < mesh->mNumFaces; k++)
            head->face_count += mesh->mFaces[k].mNumIndices > 2 ? mesh->mFaces[k].mNumIndices - 2 : 0;
        if (head->face_count == before)
            continue; /* points and lines */
        head->has_normals |= mesh->mNormals != NULL;
        head->has_uv |= mesh->mTextureCoords[0] != NULL;
        head->has_colors |= mesh->mColors[0] != NULL && !is_stl;
        head->has_facet_colors |= mesh->mColors[0] != NULL && is_stl;
    }
}

/* The picture of a material's colour, if it has one. */
static void set_texture(const struct aiMaterial *from, bool linear, struct import_pictures *pictures,
                        struct mesh_material *material, struct placing *placing)
{
    static const enum aiTextureType types[] = {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR};
    struct aiString name;
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        const enum aiTextureType type = types[i];
        int channel = 0, wrap[2] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap}, filter = 0;
        struct aiColor4D color;
        if (lib.aiGetMaterialString(from, AI_MATKEY_TEXTURE(type, 0), &name) != aiReturn_SUCCESS || !name.length)
            continue;
        lib.aiGetMaterialIntegerArray(from, AI_MATKEY_UVWSRC(type, 0), &channel, NULL);
        lib.aiGetMaterialIntegerArray(from, AI_MATKEY_MAPPINGMODE_U(type, 0), &wrap[0], NULL);
        lib.aiGetMaterialIntegerArray(from, AI_MATKEY_MAPPINGMODE_V(type, 0), &wrap[1], NULL);
        lib.aiGetMaterialIntegerArray(from, AI_MATKEY_GLTF_MAPPINGFILTER_MAG(type, 0), &filter, NULL);
        material->picture = import_pictures_find(pictures, name.data) + 1;
        material->clamps = wrap[0] != aiTextureMapMode_Wrap || wrap[1] != aiTextureMapMode_Wrap;
        material->is_nearest = filter == GLTF_NEAREST;
        if (!linear) {
            mesh_material_set_factor(material);
        } else if (lib.aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &color) == aiReturn_SUCCESS) {
            const float parts[3] = {color.r, color.g, color.b};
            for (int k = 0; k < 3; k++)
                material->factor[k] = fmin(1, fmax(0, (double)parts[k]));
        }
        placing->channel = (unsigned)channel;
        if (linear)
            set_placing(from, type, placing);
        return;
    }
}

/* The picture of a glTF's roughness and metal. */
static void set_look(const struct aiMaterial *from, struct import_pictures *pictures, struct mesh_material *material)
{
    struct aiString name;
    if (lib.aiGetMaterialString(from, AI_MATKEY_TEXTURE(aiTextureType_UNKNOWN, 0), &name) == aiReturn_SUCCESS &&
        name.length)
        material->look_picture = import_pictures_find(pictures, name.data) + 1;
}

static bool has_corner_uv; /* of a PLY, left out */

/* libassimp believes what a file says of its own length, and misreads what of a glTF it does not know. It reads these bytes from now on. */
static const char *check_file(struct import_source *source, bool is_gltf, uint64_t *triangles)
{
    const char *wrong = NULL;
    const bool is_ply = strcmp(source->ending, ".ply") == 0;
    if (!is_gltf && !is_ply && strcmp(source->ending, ".stl") != 0)
        return NULL;
    import_files(source);
    FILE *stream = source->bytes ? NULL : import_files_open(source->path, &source->len, &wrong);
    if (stream)
        source->bytes = import_files_read_all(stream, &source->len);
    if (wrong)
        return wrong;
    if (is_gltf)
        return gltf_check(source->bytes, source->len, triangles);
    if (is_ply) {
        wrong = ply_check(source->bytes, &source->len, &has_corner_uv);
        source->bytes[source->len++] = '\n'; /* without, libassimp takes what an earlier line had there */
        return wrong;
    }
    const size_t binary = stl_binary_len(source->bytes, source->len);
    if (binary)
        source->len = binary;
    return stl_check(source->bytes, source->len);
}

static const char no_such_vertex[] =
    "a face names a vertex that the file does not have; repair the mesh, or export it again";

/* It believes faces, too. */
static bool names_what_is_there(const struct aiScene *scene)
{
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        for (unsigned k = 0; k < scene->mMeshes[i]->mNumFaces; k++)
            for (unsigned j = 0; j < scene->mMeshes[i]->mFaces[k].mNumIndices; j++)
                if (scene->mMeshes[i]->mFaces[k].mIndices[j] >= scene->mMeshes[i]->mNumVertices)
                    return false;
    return true;
}

/* How nodes place their meshes. */
enum { PLAIN = 1, MIRRORED = 2, FLAT = 4 };

static void hide(struct aiNode *node)
{
    node->mNumMeshes = 0;
    for (unsigned i = 0; i < node->mNumChildren; i++)
        hide(node->mChildren[i]);
}

/* The ways of a node and of those below it; `keep`: in which of them meshes stay. Where all is one point, nothing is drawn. */
static unsigned keep_ways(struct aiNode *node, double parent, unsigned keep)
{
    const struct aiMatrix4x4 *m = &node->mTransformation;
    const double a[3] = {(double)m->a1, (double)m->a2, (double)m->a3},
                 b[3] = {(double)m->b1, (double)m->b2, (double)m->b3},
                 c[3] = {(double)m->c1, (double)m->c2, (double)m->c3};
    double normal[3];
    if (mesh_dot(a, a) + mesh_dot(b, b) + mesh_dot(c, c) == 0) {
        hide(node);
        return 0;
    }
    mesh_cross(a, b, normal);
    const double scale = parent * mesh_dot(normal, c);
    const unsigned way = scale > 0 ? PLAIN : scale < 0 ? MIRRORED : FLAT;
    unsigned ways = node->mNumMeshes ? way : 0;
    if (!(way & keep))
        node->mNumMeshes = 0;
    for (unsigned i = 0; i < node->mNumChildren; i++)
        ways |= keep_ways(node->mChildren[i], way == PLAIN ? 1 : way == MIRRORED ? -1 : 0, keep);
    return ways;
}

static void turn_triangles(const struct aiScene *scene)
{
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        for (unsigned k = 0; k < scene->mMeshes[i]->mNumFaces; k++) {
            const struct aiFace *face = &scene->mMeshes[i]->mFaces[k];
            if (face->mNumIndices != 3)
                continue;
            const unsigned corner = face->mIndices[1];
            face->mIndices[1] = face->mIndices[2];
            face->mIndices[2] = corner;
        }
}

static const struct aiScene *import_scene(const struct import_source *source, const char **wrong)
{
    struct aiFileIO *files = import_files(source);
    char input[32];
    snprintf(input, sizeof input, "%s%s", import_files_input, source->ending);
    const struct aiScene *scene = lib.aiImportFileEx(source->path ? source->path : input, 0, files);
    if (scene && !names_what_is_there(scene))
        *wrong = no_such_vertex;
    return *wrong ? NULL : scene;
}

/* libassimp moves what is mirrored, but leaves its triangles' corners in their order, and nodes may share a mesh. So a glTF with both is two
 * scenes: of what is not mirrored, and of what is. Returns how many; 0: *wrong says why, or where it is NULL libassimp. Of a glTF *triangles is how many
 * there should be. */
static unsigned read_scenes(const struct import_source *of, bool is_gltf, const struct aiScene *scenes[2],
                            uint64_t *triangles, const char **wrong)
{
    const unsigned steps = aiProcess_PreTransformVertices;
    static struct import_source source; /* libassimp's files are read from it later, too */
    unsigned count = 0;
    source = *of;
    *wrong = check_file(&source, is_gltf, triangles);
    const struct aiScene *scene = *wrong ? NULL : import_scene(&source, wrong);
    const unsigned ways = scene && is_gltf ? keep_ways(scene->mRootNode, 1, PLAIN | MIRRORED) : PLAIN;
    if (ways & FLAT)
        *wrong = "its nodes make parts flat; apply their transforms before you export it";
    if (scene && ways == (PLAIN | MIRRORED)) {
        keep_ways(scene->mRootNode, 1, PLAIN);
        scenes[count++] = lib.aiApplyPostProcessing(scene, steps);
        scene = scenes[0] ? import_scene(&source, wrong) : NULL;
        if (scene)
            keep_ways(scene->mRootNode, 1, MIRRORED);
    }
    if (scene && ways & MIRRORED)
        turn_triangles(scene);
    scenes[count++] = scene && !*wrong ? lib.aiApplyPostProcessing(scene, steps) : NULL;
    return scenes[count - 1] ? count : 0;
}

/* libassimp quotes what it does not understand: of other files that is for nobody's eyes. The message names standard input already. */
static void send_error(const struct import_source *source, int out)
{
    const struct import_file *files;
    const char *text = lib.aiGetErrorString(), *refused = import_files_refused();
    struct import_head head;
    if (refused) {
        snprintf(head.message, sizeof head.message, "it names %.120s: %s", refused, import_files_outside(source));
        text = head.message;
    } else if (import_files_read(&files) > 1) {
        text = "it, or a file that it names, is damaged";
    } else if (!source->path && strstr(text, import_files_input)) {
        text = "";
    }
    send_message(out, text);
}

void import_child(const struct import_source *source, int out)
{
    const bool linear = strcmp(source->ending, ".gltf") == 0 || strcmp(source->ending, ".glb") == 0;
    if (strcmp(source->ending, ".obj") == 0) {
        const char *const wrong = import_obj(source, out);
        if (wrong)
            send_message(out, wrong);
        return;
    }
    if (!load()) {
        send_message(out, LIBRARY " cannot be loaded; install libassimp5");
        return;
    }
    const char *wrong;
    uint64_t triangles = 0;
    const struct aiScene *scenes[2];
    const unsigned count = read_scenes(source, linear, scenes, &triangles, &wrong);
    if (!count && wrong)
        send_message(out, wrong);
    else if (!count)
        send_error(source, out);
    if (!count)
        return;
    const struct aiScene *scene = scenes[0]; /* materials are the same in both */
    struct import_head head = {.part_count = scene->mNumMaterials};
    for (unsigned i = 0; i < count; i++)
        add_scene(&head, scenes[i], strcmp(source->ending, ".stl") == 0);
    if (linear && head.face_count != triangles) { /* libassimp leaves out those of a glTF */
        send_message(out, no_such_vertex);
        return;
    }
    for (unsigned i = 0; i < count && !wrong && head.face_count <= GLINT_MESH_FACES_MAX; i++)
        wrong = cut_scene(scenes[i]);
    if (wrong) {
        send_message(out, wrong);
        return;
    }
    struct mesh_material *materials = allocate(scene->mNumMaterials, sizeof *materials);
    struct placing *placings = allocate(scene->mNumMaterials + 1, sizeof *placings);
    struct import_pictures pictures = {scene, source, 0, allocate(scene->mNumMaterials, 2 * sizeof *pictures.of)};
    for (unsigned i = 0; i < scene->mNumMaterials; i++) {
        materials[i] = material_of(scene->mMaterials[i], linear);
        placings[i] = plain_placing;
        if (source->textures && linear)
            set_look(scene->mMaterials[i], &pictures, &materials[i]);
        if (source->textures)
            set_texture(scene->mMaterials[i], linear, &pictures, &materials[i], &placings[i]);
    }
    const struct import_file *files;
    head.file_count = import_files_read(&files);
    if (import_files_refused())
        snprintf(head.refused, sizeof head.refused, "%.*s", (int)sizeof head.refused - 1, import_files_refused());
    if (has_corner_uv && source->textures)
        snprintf(head.notes, sizeof head.notes,
                 "texcoord, where each face's corners lie in a texture, is left out; export it as OBJ or glTF\n");
    head.picture_count = pictures.count;
    child_send(out, &head, sizeof head);
    child_send(out, files, head.file_count * sizeof *files);
    if (head.face_count > GLINT_MESH_FACES_MAX)
        return; /* the parent says so */
    child_send(out, materials, scene->mNumMaterials * sizeof *materials);
    import_pictures_send(&pictures, out);
    for (unsigned i = 0; i < count; i++)
        for (unsigned k = 0; k < scenes[i]->mNumMeshes; k++) {
            const struct aiMesh *mesh = scenes[i]->mMeshes[k];
            const struct colors colors = colors_of(scene, mesh, linear);
            send_faces(out, mesh, &head, &colors,
                       mesh->mMaterialIndex < scene->mNumMaterials ? &placings[mesh->mMaterialIndex] : &plain_placing);
        }
}

#else

void import_child(const struct import_source *source, int out)
{
    (void)source;
    (void)out;
}

#endif
