/* SPDX-License-Identifier: MIT */
#include "mesh/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "mesh/import_picture.h"
#include "mesh/texture.h"
#include "models/models.h"

enum { MULTIPLIED_PIXELS_MAX = 1 << 26 };
static const double white[3] = {1, 1, 1};

/* ---- pictures ---- */

static void use_one_picture(struct soup *soup, const char *path)
{
    if (!soup->has_uv)
        fail("%s: has no texture coordinates, which --texture needs; unwrap it where the file was made", soup->name);
    mesh_pictures_free(soup->pictures, soup->picture_count);
    soup->picture_count = 1;
    soup->pictures = allocate(1, sizeof *soup->pictures);
    soup->pictures[0] = import_picture(path);
    for (unsigned i = 0; i < soup->part_count; i++) {
        struct mesh_material *material = &soup->materials[i];
        material->picture = 1;
        material->is_nearest = material->clamps = false;
        for (int k = 0; k < 3; k++)
            material->factor[k] = 1;
    }
}

/* A picture of roughness and metal becomes its mean: a part has one shininess. */
static void take_look(const struct soup *soup, unsigned picture)
{
    const struct mesh_picture *from = &soup->pictures[picture];
    const size_t pixels = (size_t)from->width * from->height;
    double sum[3] = {0};
    for (size_t i = 0; from->rgb && i < 3 * pixels; i++)
        sum[i % 3] += from->rgb[i];
    for (unsigned i = 0; from->rgb && i < soup->part_count; i++) {
        struct mesh_material *material = &soup->materials[i];
        if (material->look_picture != picture + 1)
            continue;
        material->has_roughness = true;
        material->roughness *= sum[1] / (255 * (double)pixels);
        material->metallic *= sum[2] / (255 * (double)pixels);
    }
}

/* Parts whose picture is not there have none. Returns whether any has. */
static bool find_pictures(struct soup *soup)
{
    bool any = false, unplaced = false;
    for (unsigned i = 0; i < soup->part_count; i++) {
        struct mesh_material *material = &soup->materials[i];
        if (material->picture > soup->picture_count || !material->picture || !soup->pictures[material->picture - 1].rgb)
            material->picture = 0;
        unplaced |= material->picture && !soup->has_uv;
        any |= material->picture && soup->has_uv;
    }
    if (unplaced)
        warn("%s: names a texture, but has no texture coordinates; it is drawn without", soup->name);
    return any;
}

static unsigned picture_of(const struct soup *soup, size_t face)
{
    return soup->materials[soup->faces[face].part].picture;
}

/* Where a part has no picture, no place in one keeps corners apart. */
static void forget_places(struct soup *soup)
{
    for (size_t i = 0; i < soup->face_count; i++)
        if (!picture_of(soup, i))
            memset(soup->faces[i].uv, 0, sizeof soup->faces[i].uv);
}

static void say_what_repeats(const struct soup *soup)
{
    for (size_t i = 0; i < 6 * soup->face_count; i++) {
        const struct soup_face *face = &soup->faces[i / 6];
        const struct mesh_material *material = &soup->materials[face->part];
        if (!material->clamps || fabs(face->uv[i / 2 % 3][i % 2] - .5) < .501)
            continue;
        warn("%s: texture %s repeats here beyond its edges, and should not; keep texture coordinates within 0..1",
             soup->name, soup->pictures[material->picture - 1].name);
        return;
    }
}

/* ---- colours ---- */

/* A picture is in the place of colours of vertices: where a part has one colour throughout, that colours its picture. Elsewhere the mean is
 * taken; `differs`: by more than a few levels. */
static void part_color(const struct soup *soup, unsigned part, uint8_t color[3], bool *differs)
{
    double sum[3] = {0}, count = 0;
    uint8_t low[3] = {255, 255, 255}, high[3] = {0};
    for (size_t i = 0; i < 3 * soup->face_count; i++) {
        const struct soup_face *face = &soup->faces[i / 3];
        if (face->part != part)
            continue;
        count++;
        for (int k = 0; k < 3; k++) {
            const uint8_t level = face->colors[i % 3][k];
            sum[k] += level;
            low[k] = level < low[k] ? level : low[k];
            high[k] = level > high[k] ? level : high[k];
        }
    }
    *differs = false;
    for (int k = 0; k < 3 && count > 0; k++) {
        color[k] = (uint8_t)lround(sum[k] / count);
        *differs |= high[k] - low[k] > 4;
    }
}

static void fold_colors(struct soup *soup)
{
    bool lost = false;
    for (unsigned i = 0; i < soup->part_count; i++) {
        struct mesh_material *material = &soup->materials[i];
        uint8_t color[3] = {255, 255, 255};
        bool differs;
        part_color(soup, i, color, &differs);
        lost |= differs;
        if (!material->picture) {
            material->has_color = true;
            memcpy(material->color, color, sizeof color);
        }
        for (int k = 0; k < 3 && material->picture && !differs; k++)
            material->factor[k] = texture_decode(color[k] / 255.);
    }
    soup->has_colors = false;
    if (lost)
        warn("%s: has textures and colours of vertices; the colours are left out", soup->name);
}

static bool is_factor(const double factor[3], const double other[3])
{
    return factor[0] == other[0] && factor[1] == other[1] && factor[2] == other[2];
}

/* The picture times the factor, in linear light. */
static void multiply(struct mesh_picture *picture, const struct mesh_picture *from, const double factor[3])
{
    uint8_t levels[3][256];
    const size_t samples = (size_t)3 * from->width * from->height;
    *picture = (struct mesh_picture){copied(from->name), from->width, from->height, allocate(samples, 1)};
    for (int i = 0; i < 3 * 256; i++) {
        const double value = fmin(1, fmax(0, factor[i / 256])) * texture_decode(i % 256 / 255.);
        levels[i / 256][i % 256] = (uint8_t)lround(255 * texture_encode(value));
    }
    for (size_t i = 0; i < samples; i++)
        picture->rgb[i] = levels[i % 3][from->rgb[i]];
}

/* Whether some part before has the same picture and factor. */
static bool is_repeated(const struct soup *soup, unsigned part)
{
    const struct mesh_material *of = soup->materials;
    unsigned same = 0;
    while (same < part && (of[same].picture != of[part].picture || !is_factor(of[same].factor, of[part].factor)))
        same++;
    return same < part;
}

static void check_pixels(const struct soup *soup)
{
    size_t left = MULTIPLIED_PIXELS_MAX;
    for (unsigned i = 0; i < soup->part_count; i++) {
        const struct mesh_material *material = &soup->materials[i];
        if (!material->picture || is_factor(material->factor, white) || is_repeated(soup, i))
            continue;
        const struct mesh_picture *picture = &soup->pictures[material->picture - 1];
        const size_t pixels = (size_t)picture->width * picture->height;
        if (pixels > left)
            fail("%s: its textures, one for each colour of a material, have more than %d pixels; save smaller ones, or "
                 "give --no-textures",
                 soup->name, MULTIPLIED_PIXELS_MAX);
        left -= pixels;
    }
}

/* Of each picture and factor one picture. */
static void multiply_pictures(struct soup *soup)
{
    const unsigned count = soup->picture_count;
    struct mesh_picture *all = allocate(count + soup->part_count, sizeof *all);
    unsigned *from = allocate(soup->part_count, sizeof *from);
    memcpy(all, soup->pictures, count * sizeof *all);
    free(soup->pictures);
    soup->pictures = all;
    for (unsigned i = 0; i < soup->part_count; i++) {
        struct mesh_material *material = &soup->materials[i];
        unsigned same = 0;
        from[i] = material->picture;
        if (!material->picture || is_factor(material->factor, white))
            continue;
        while (same < i && (from[same] != from[i] || !is_factor(soup->materials[same].factor, material->factor)))
            same++;
        if (same == i)
            multiply(&all[soup->picture_count++], &all[material->picture - 1], material->factor);
        material->picture = same < i ? soup->materials[same].picture : soup->picture_count;
    }
    free(from);
}

/* Pictures that no part has any more go. */
static void forget_pictures(struct soup *soup)
{
    unsigned kept = 0;
    for (unsigned i = 0; i < soup->picture_count; i++) {
        bool is_used = false;
        for (unsigned j = 0; j < soup->part_count; j++)
            is_used |= soup->materials[j].picture == i + 1;
        if (!is_used) {
            mesh_picture_clear(&soup->pictures[i]);
            continue;
        }
        for (unsigned j = 0; j < soup->part_count && kept < i; j++)
            if (soup->materials[j].picture == i + 1)
                soup->materials[j].picture = kept + 1;
        if (kept < i) {
            soup->pictures[kept] = soup->pictures[i];
            soup->pictures[i] = (struct mesh_picture){.name = NULL};
        }
        kept++;
    }
    soup->picture_count = kept;
}

/* ---- materials ---- */

static void mean_of(const struct mesh_picture *picture, uint8_t color[3])
{
    double decoded[256], sum[3] = {0};
    const size_t pixels = (size_t)picture->width * picture->height;
    for (int i = 0; i < 256; i++)
        decoded[i] = texture_decode(i / 255.);
    for (size_t i = 0; i < 3 * pixels; i++)
        sum[i % 3] += decoded[picture->rgb[i]];
    for (int k = 0; k < 3; k++)
        color[k] = (uint8_t)lround(255 * texture_encode(sum[k] / (double)pixels));
}

/* Without a picture the highlight of a metal has the part's colour, with one its mean. */
static void settle_materials(struct soup *soup)
{
    bool too_smooth = false;
    uint8_t(*means)[3] = allocate(soup->picture_count + 1, sizeof *means);
    for (unsigned i = 0; i < soup->picture_count; i++)
        mean_of(&soup->pictures[i], means[i]); /* parts may share a picture */
    for (unsigned i = 0; i < soup->part_count; i++) {
        struct mesh_material *material = &soup->materials[i];
        if (material->picture)
            memcpy(material->tint, means[material->picture - 1], sizeof material->tint);
        else
            memcpy(material->tint, material->color, sizeof material->tint);
        if (!material->has_roughness)
            continue;
        const double n = shininess_of_roughness(material->roughness);
        material->n = shininess_held(n);
        too_smooth |= n > 1000.5;
    }
    free(means);
    if (too_smooth)
        warn("%s: a roughness below .211 is more than the largest shininess, 1000, which is drawn", soup->name);
}

void mesh_surface_begin(struct soup *soup, const struct mesh_source *source)
{
    if (source->texture)
        use_one_picture(soup, source->texture);
    else
        for (unsigned i = 0; i < soup->picture_count; i++)
            take_look(soup, i);
    soup->has_uv = find_pictures(soup);
    if (soup->has_uv) {
        forget_places(soup);
        soup_check_uv(soup);
        say_what_repeats(soup);
        if (soup->has_colors)
            fold_colors(soup);
        check_pixels(soup);
        multiply_pictures(soup);
    }
    forget_pictures(soup);
    settle_materials(soup);
}

/* ---- places in pictures ---- */

static uint32_t set_of(uint32_t *sets, uint32_t vertex)
{
    while (sets[vertex] != vertex)
        vertex = sets[vertex] = sets[sets[vertex]];
    return vertex;
}

/* All that hangs together by faces is moved by the same number of repeats, so that no face is torn. */
static void move_places(struct mesh *mesh)
{
    uint32_t *sets = allocate(mesh->vertex_count, sizeof *sets);
    double(*low)[2] = allocate(mesh->vertex_count, sizeof *low);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        sets[i] = i;
        low[i][0] = low[i][1] = INFINITY;
    }
    for (size_t i = 0; i < 3 * mesh->face_count; i++)
        sets[set_of(sets, mesh->faces[i / 3][i % 3])] = set_of(sets, mesh->faces[i / 3][0]);
    for (uint32_t i = 0; i < mesh->vertex_count; i++)
        for (int k = 0; k < 2; k++) {
            double *least = &low[set_of(sets, i)][k];
            *least = fmin(*least, mesh->uv[i][k]);
        }
    for (uint32_t i = 0; i < mesh->vertex_count; i++)
        for (int k = 0; k < 2; k++)
            mesh->uv[i][k] -= floor(low[set_of(sets, i)][k] + 1e-4); /* below 0 by rounding only */
    free(sets);
    free(low);
}

void mesh_surface_end(struct mesh *mesh, struct soup *soup, const struct mesh_source *source)
{
    mesh->pictures = soup->pictures;
    mesh->picture_count = soup->picture_count;
    soup->pictures = NULL;
    soup->picture_count = 0;
    mesh->wish = source->wish;
    if (!mesh->wish.bytes)
        mesh->wish.bytes = TEXTURE_BYTES_USUAL;
    if (mesh->uv)
        move_places(mesh);
}
