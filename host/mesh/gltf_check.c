/* SPDX-License-Identifier: MIT */
#include "mesh/gltf_check.h"

#include <ctype.h>
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 1000, COUNT_MAX = 1 << 28, POINTS_TO_LINE_STRIP = 3, TRIANGLES = 4, TRIANGLE_FAN = 6 };
enum { GLB_HEAD = 12, CHUNK_HEAD = 8 };
static const uint64_t none = UINT64_MAX, sum_max = (uint64_t)1 << 40;

struct gltf {
    const json_t *root;
    uint64_t *of_meshes, *of_nodes; /* triangles; none: not counted yet */
};

static const char damaged[] = "it is damaged; export it again",
                  misread[] = "it has numbers of a kind that libassimp misreads; export it with floats",
                  large[] = "it has a number that is too large; export it again",
                  not_text[] = "it has text that is not UTF-8, which a glTF's has to be; export it again",
                  bad_uri[] = "the data URI of a buffer is not base64; export it again",
                  old[] = "it is a glTF 1; export it as glTF 2.0",
                  doubled[] = "its indices are packed by Draco and plain; export it without Draco",
                  elsewhere[] = "a GLB's first buffer is in itself, and this one's is elsewhere; export it again",
                  moved[] = "a texture's transform names other coordinates than the texture; export it with the same",
                  skinned[] = "it has a skeleton; export it without",
                  morphed[] = "its morph targets have weights; apply them before you export it";

/* ---- JSON, which may have anything in the place of anything ---- */

/* A whole number from 0 on, `other` where there is none. False: it is something else. */
static bool take(const json_t *object, const char *key, uint64_t other, uint64_t *number)
{
    const json_t *value = json_object_get(object, key);
    const json_int_t whole = json_integer_value(value);
    *number = value ? (uint64_t)whole : other;
    return !value || (json_is_integer(value) && whole >= 0 && whole <= UINT32_MAX);
}

/* NULL: there is none. */
static const json_t *item(const struct gltf *gltf, const char *list, uint64_t index)
{
    const json_t *object = json_array_get(json_object_get(gltf->root, list), (size_t)index);
    return json_is_object(object) ? object : NULL;
}

/* ---- a primitive's numbers ---- */

static uint64_t bytes_of(const char *type, uint64_t component)
{
    const uint64_t bytes = component == 5121 ? 1 : component == 5123 ? 2 : 4;
    return bytes * (strcmp(type, "SCALAR") == 0 ? 1 : (uint64_t)(type[3] - '0'));
}

/* Do so many numbers, each of so many bytes, lie in the view that an object names? */
static bool lie_in_view(const struct gltf *gltf, const json_t *object, uint64_t count, uint64_t bytes, bool may_stride)
{
    uint64_t index, offset, length, stride;
    if (!take(object, "bufferView", none, &index) || !take(object, "byteOffset", 0, &offset))
        return false;
    const json_t *view = item(gltf, "bufferViews", index);
    if (!take(view, "byteLength", 0, &length) || !take(view, "byteStride", bytes, &stride))
        return false;
    return (stride == bytes || (may_stride && stride > bytes)) &&
           offset + stride * (count - 1) + bytes <= length; /* < 2^61 */
}

/* Where numbers are sparse, libassimp takes no steps, and trusts. */
static bool is_sparse_good(const struct gltf *gltf, const json_t *accessor, uint64_t count, uint64_t bytes)
{
    const json_t *sparse = json_object_get(accessor, "sparse"), *indices = json_object_get(sparse, "indices");
    uint64_t few, component;
    return take(sparse, "count", 0, &few) && few >= 1 && few <= count &&
           take(indices, "componentType", none, &component) &&
           (component == 5121 || component == 5123 || component == 5125) &&
           lie_in_view(gltf, indices, few, bytes_of("SCALAR", component), false) &&
           lie_in_view(gltf, json_object_get(sparse, "values"), few, bytes, false) &&
           (!json_object_get(accessor, "bufferView") || lie_in_view(gltf, accessor, count, bytes, false));
}

/* kinds: those that libassimp takes for what they are, each with a blank at both ends. */
static const char *check_accessor(const struct gltf *gltf, uint64_t index, const char *kinds, bool draco,
                                  uint64_t *count)
{
    const json_t *accessor = item(gltf, "accessors", index);
    const char *type = json_string_value(json_object_get(accessor, "type"));
    uint64_t component;
    char kind[32];
    if (!type || !take(accessor, "componentType", none, &component) || !take(accessor, "count", 0, count) ||
        *count < 1 || *count > COUNT_MAX)
        return damaged;
    snprintf(kind, sizeof kind, " %.7s %llu ", type, (unsigned long long)component);
    if (!strstr(kinds, kind))
        return misread;
    const uint64_t bytes = bytes_of(type, component);
    if (json_object_get(accessor, "sparse"))
        return is_sparse_good(gltf, accessor, *count, bytes) ? NULL : misread;
    if (draco && !json_object_get(accessor, "bufferView"))
        return NULL;
    if (draco && component == 5125) /* of which libassimp takes those that are not packed */
        return doubled;
    return lie_in_view(gltf, accessor, *count, bytes, true) ? NULL : damaged;
}

static const char *check_attributes(const struct gltf *gltf, const json_t *attributes, bool draco, uint64_t *count)
{
    static const char *const kinds[][2] = {
        {"NORMAL", " VEC3 5126 "},
        {"TEXCOORD_", " VEC2 5126 "},
        {"COLOR_0", " VEC3 5126 VEC4 5126 VEC3 5121 VEC4 5121 VEC3 5123 VEC4 5123 "}};
    uint64_t index, others;
    const char *key;
    json_t *value;
    if (!take(attributes, "POSITION", none, &index))
        return damaged;
    const char *wrong = check_accessor(gltf, index, " VEC3 5126 ", draco, count);
    json_object_foreach((json_t *)(uintptr_t)attributes, key, value)
    {
        for (size_t i = 0; i < sizeof kinds / sizeof *kinds && !wrong; i++) {
            if (strncmp(key, kinds[i][0], strlen(kinds[i][0])) != 0)
                continue;
            wrong = take(attributes, key, none, &index) ? check_accessor(gltf, index, kinds[i][1], draco, &others)
                                                        : damaged;
            if (!wrong && others != *count)
                wrong = damaged; /* libassimp leaves them out */
        }
    }
    return wrong;
}

/* Points and lines are not drawn. */
static const char *count_primitive(const struct gltf *gltf, const json_t *primitive, uint64_t *triangles)
{
    uint64_t mode, indices, count;
    const bool draco = json_object_get(json_object_get(primitive, "extensions"), "KHR_draco_mesh_compression") != NULL;
    *triangles = 0;
    if (!json_is_object(primitive) || !take(primitive, "mode", TRIANGLES, &mode) || mode > TRIANGLE_FAN ||
        !take(primitive, "indices", none, &indices))
        return damaged;
    if (mode <= POINTS_TO_LINE_STRIP)
        return NULL;
    const char *wrong = check_attributes(gltf, json_object_get(primitive, "attributes"), draco, &count);
    if (!wrong && indices != none)
        wrong = check_accessor(gltf, indices, " SCALAR 5121 SCALAR 5123 SCALAR 5125 ", draco, &count);
    if (!wrong && count < 3)
        wrong = damaged;
    if (!wrong)
        *triangles = mode == TRIANGLES ? count / 3 : count - 2;
    return wrong;
}

/* ---- the scene ---- */

static const char *count_mesh(struct gltf *gltf, uint64_t index, uint64_t *triangles)
{
    const json_t *mesh = item(gltf, "meshes", index);
    const json_t *primitives = json_object_get(mesh, "primitives");
    const char *wrong = NULL;
    uint64_t sum = 0;
    if (!mesh || !json_is_array(primitives))
        return damaged;
    for (size_t i = 0; i < json_array_size(primitives) && gltf->of_meshes[index] == none && !wrong; i++) {
        wrong = count_primitive(gltf, json_array_get(primitives, i), triangles);
        sum += *triangles;
    }
    if (gltf->of_meshes[index] == none)
        gltf->of_meshes[index] = sum;
    *triangles = gltf->of_meshes[index];
    return wrong;
}

/* Is the mesh changed by morph targets, which libassimp keeps to itself? Without weights it is as its primitives are. */
static bool is_morphed(const struct gltf *gltf, const json_t *node, uint64_t mesh)
{
    const json_t *own = json_object_get(node, "weights");
    const json_t *weights = own ? own : json_object_get(item(gltf, "meshes", mesh), "weights");
    for (size_t i = 0; i < json_array_size(weights); i++)
        if (json_number_value(json_array_get(weights, i)) != 0)
            return true;
    return false;
}

/* Such parts are not drawn, and neither is what is below them: programs hide parts so. */
static bool is_hidden(const json_t *node)
{
    static const size_t of_matrix[] = {0, 1, 2, 4, 5, 6, 8, 9, 10};
    const json_t *scale = json_object_get(node, "scale"), *matrix = json_object_get(node, "matrix");
    bool is_zero = json_array_size(matrix ? matrix : scale) == (matrix ? 16 : 3);
    for (size_t i = 0; is_zero && i < (matrix ? 9 : 3); i++)
        is_zero = (float)json_number_value(json_array_get(matrix ? matrix : scale, matrix ? of_matrix[i] : i)) == 0;
    return is_zero;
}

/* A node may be that of several others, or, in a damaged file, its own. */
static const char *count_node(struct gltf *gltf, const json_t *at, unsigned depth, uint64_t *triangles)
{
    const uint64_t index = (uint64_t)json_integer_value(at);
    const json_t *node = json_is_integer(at) ? item(gltf, "nodes", index) : NULL;
    const json_t *children = json_object_get(node, "children");
    const char *wrong = NULL;
    uint64_t mesh, sum = 0, more;
    if (!node || depth > DEPTH_MAX || !take(node, "mesh", none, &mesh))
        return damaged;
    *triangles = gltf->of_nodes[index];
    if (*triangles != none)
        return NULL;
    if (is_hidden(node)) {
        *triangles = gltf->of_nodes[index] = 0;
        return NULL;
    }
    if (json_object_get(node, "skin"))
        return skinned;
    if (mesh != none && is_morphed(gltf, node, mesh))
        return morphed;
    if (mesh != none)
        wrong = count_mesh(gltf, mesh, &sum);
    for (size_t i = 0; i < json_array_size(children) && !wrong; i++) {
        wrong = count_node(gltf, json_array_get(children, i), depth + 1, &more);
        sum = wrong || sum + more > sum_max ? sum_max : sum + more;
    }
    *triangles = gltf->of_nodes[index] = sum;
    return wrong;
}

static const char *count_scene(struct gltf *gltf, uint64_t *triangles)
{
    uint64_t scene, more;
    const char *wrong = NULL;
    if (!take(gltf->root, "scene", 0, &scene))
        return damaged;
    const json_t *nodes = json_object_get(item(gltf, "scenes", scene), "nodes");
    for (size_t i = 0; i < json_array_size(nodes) && !wrong; i++) {
        wrong = count_node(gltf, json_array_get(nodes, i), 0, &more);
        *triangles += wrong ? 0 : more;
    }
    return wrong;
}

/* ---- the file ---- */

/* What a file needs and is not carried out. */
static const char *check_required(const json_t *root)
{
    static const char carried_out[] = " KHR_materials_unlit KHR_texture_transform KHR_draco_mesh_compression ";
    static char needs[100];
    const json_t *list = json_object_get(root, "extensionsRequired");
    for (size_t i = 0; i < json_array_size(list); i++) {
        const char *name = json_string_value(json_array_get(list, i));
        char word[64];
        if (!name)
            return damaged;
        snprintf(word, sizeof word, " %.60s ", name);
        if (strstr(carried_out, word))
            continue;
        snprintf(needs, sizeof needs, "it needs %.60s; export it without", name);
        return needs;
    }
    return NULL;
}

/* libassimp takes any character for one of base64. */
static bool is_base64(const char *data)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const size_t len = strspn(data, digits);
    return len + strspn(data + len, "=") == strlen(data) && strlen(data) - len <= 2;
}

static const char *check_buffers(const json_t *root)
{
    const json_t *buffers = json_object_get(root, "buffers");
    for (size_t i = 0; i < json_array_size(buffers); i++) {
        const char *uri = json_string_value(json_object_get(json_array_get(buffers, i), "uri"));
        const char *data = uri && strncmp(uri, "data:", 5) == 0 ? strchr(uri, ',') : uri;
        if (data != uri && (!data || data - uri < 7 || strncmp(data - 7, ";base64", 7) != 0 || !is_base64(data + 1)))
            return bad_uri;
    }
    return NULL;
}

/* libassimp does not look which coordinates a transform names. */
static const char *check_transforms(const json_t *root)
{
    const json_t *materials = json_object_get(root, "materials");
    for (size_t i = 0; i < json_array_size(materials); i++) {
        const json_t *look = json_object_get(json_array_get(materials, i), "pbrMetallicRoughness");
        const json_t *texture = json_object_get(look, "baseColorTexture");
        const json_t *transform = json_object_get(json_object_get(texture, "extensions"), "KHR_texture_transform");
        uint64_t plain, named;
        if (!take(texture, "texCoord", 0, &plain) || !take(transform, "texCoord", plain, &named))
            return damaged;
        if (named != plain)
            return moved;
    }
    return NULL;
}

static const char *check_root(const json_t *root, uint64_t *triangles)
{
    const char *version = json_string_value(json_object_get(json_object_get(root, "asset"), "version"));
    if (!version)
        return damaged;
    if (strncmp(version, "2", 1) != 0)
        return old;
    const char *wrong = check_required(root);
    if (!wrong)
        wrong = check_buffers(root);
    if (!wrong)
        wrong = check_transforms(root);
    const size_t meshes = json_array_size(json_object_get(root, "meshes"));
    const size_t nodes = json_array_size(json_object_get(root, "nodes"));
    struct gltf gltf = {root, malloc((meshes + nodes + 1) * sizeof *gltf.of_meshes), NULL};
    if (!gltf.of_meshes)
        return damaged;
    gltf.of_nodes = gltf.of_meshes + meshes;
    memset(gltf.of_meshes, 255, (meshes + nodes) * sizeof *gltf.of_meshes);
    if (!wrong)
        wrong = count_scene(&gltf, triangles);
    free(gltf.of_meshes);
    return wrong;
}

static uint32_t word_at(const char *at)
{
    const uint8_t *bytes = (const uint8_t *)at;
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/* Whole numbers beyond those of jansson become others, which libassimp takes them for: the last digits become an exponent. */
static void shorten_numbers(char *bytes, size_t len)
{
    enum { DIGITS = 19, CUT = 4 };
    bool in_text = false;
    for (size_t i = 0, end; i < len; i = end) {
        bool is_whole = true;
        in_text ^= bytes[i] == '"';
        end = i + 1 + (in_text && bytes[i] == '\\');
        if (in_text || !isdigit((unsigned char)bytes[i]))
            continue;
        for (; end < len && (isalnum((unsigned char)bytes[end]) || memchr("+-.", bytes[end], 3)); end++)
            is_whole &= isdigit((unsigned char)bytes[end]) != 0;
        if (is_whole && end - i >= DIGITS)
            memcpy(bytes + end - CUT, "e004", CUT);
    }
}

/* *wrong is set where there is none. */
static json_t *read_text(char *bytes, size_t len, const char **wrong)
{
    const size_t flags = JSON_REJECT_DUPLICATES | JSON_DISABLE_EOF_CHECK | JSON_ALLOW_NUL;
    json_error_t error;
    json_t *root = json_loadb(bytes, len, flags, &error);
    if (!root && json_error_code(&error) == json_error_numeric_overflow) {
        shorten_numbers(bytes, len);
        root = json_loadb(bytes, len, flags, &error);
    }
    if (root)
        return root;
    const enum json_error_code code = json_error_code(&error);
    *wrong = code == json_error_numeric_overflow ? large : code == json_error_invalid_utf8 ? not_text : damaged;
    return NULL;
}

const char *gltf_check(char *bytes, size_t len, uint64_t *triangles)
{
    if (len >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0) /* of UTF-8 */
        memset(bytes, ' ', 3);
    const bool is_binary = len >= GLB_HEAD + CHUNK_HEAD && memcmp(bytes, "glTF", 4) == 0;
    *triangles = 0;
    if (is_binary) {
        const uint32_t version = word_at(bytes + 4), text = word_at(bytes + GLB_HEAD), whole = word_at(bytes + 8);
        if (version == 1)
            return old;
        const bool is_cut = whole > len;
        bytes += GLB_HEAD + CHUNK_HEAD;
        len -= GLB_HEAD + CHUNK_HEAD;
        if (text > len || (is_cut && len - text < CHUNK_HEAD)) /* for which libassimp looks among its other readers */
            return damaged;
        len = text;
    }
    const char *wrong = NULL;
    json_t *root = read_text(bytes, len, &wrong);
    if (root)
        wrong = check_root(root, triangles);
    if (!wrong && is_binary && json_object_get(json_array_get(json_object_get(root, "buffers"), 0), "uri"))
        wrong = elsewhere; /* libassimp does not look there */
    json_decref(root);
    return wrong;
}
