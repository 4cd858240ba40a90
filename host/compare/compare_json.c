/* SPDX-License-Identifier: MIT */
#include "compare/compare_json.h"

#include <inttypes.h>
#include <jansson.h>
#include <math.h>

#include "base/json.h"
#include "base/message.h"
#include "image/format.h"
#include "models/models.h"

static json_t *difference_json(const struct difference *d, unsigned channels)
{
    const double psnr = difference_psnr_db(d);
    return json_pack("{s:o, s:f, s:f, s:{s:i, s:i, s:s}, s:I, s:I}", "psnr_db",
                     isinf(psnr) ? json_null() : json_real(psnr), "mean", difference_mean(d), "largest", d->largest,
                     "at", "x", (int)d->x, "y", (int)d->y, "channel", difference_channel(d, channels), "samples",
                     (json_int_t)d->samples, "differing", (json_int_t)d->differing);
}

void comparison_print_json(const struct comparison *c, const struct shading *shading, const struct levels *levels,
                           const struct mesh_coverage *coverage, FILE *stream)
{
    const unsigned channels = levels->channels;
    json_t *root = json_pack(
        "{s:i, s:i, s:s, s:b, s:s, s:s, s:i, s:i, s:i, s:{s:o, s:o, s:o}, s:{s:o, s:o}}", "width", (int)levels->width,
        "height", (int)levels->height, "format", format_names[shading->format], "dither", (int)shading->dither, "space",
        space_names[shading->space], "model", model_names[shading->model], "n", (int)shading->n, "q", (int)shading->q,
        "levels_of", 255, "same_model", "rounded", difference_json(&c->rounded, channels), "unrounded",
        difference_json(&c->unrounded, channels), "rounding_alone", difference_json(&c->rounding, channels), "blinn",
        "rounded", difference_json(&c->blinn_rounded, channels), "unrounded",
        difference_json(&c->blinn_unrounded, channels));
    bool good = root != NULL;
    if (good && coverage)
        good = json_object_set_new(root, "mesh",
                                   json_pack("{s:I, s:I, s:I}", "covered", (json_int_t)coverage->drawn, "not_compared",
                                             (json_int_t)coverage->different, "other_texel",
                                             (json_int_t)coverage->texels)) == 0;
    if (!good || json_dumpf(root, stream, JSON_INDENT(2) | JSON_REAL_PRECISION(6)) != 0)
        fail("the comparison could not be written as JSON");
    fputc('\n', stream);
    json_decref(root);
}

/* Adds the rows to `root`, prints and frees it. */
static void print_rows(json_t *root, const struct quality *rows, FILE *stream)
{
    bool good = root && json_object_set_new(root, "levels_of", json_integer(255)) == 0 &&
                json_object_set_new(root, "quality", json_array()) == 0;
    for (int i = 0; good && i < QUALITY_ROWS; i++) {
        const struct difference *d = &rows[i].difference;
        json_t *psnr = d->differing ? json_real(difference_psnr_db(d)) : json_null();
        good = json_array_append_new(json_object_get(root, "quality"),
                                     json_pack("{s:i, s:f, s:f, s:o}", "n", (int)rows[i].n, "largest", d->largest,
                                               "mean", difference_mean(d), "psnr_db", psnr)) == 0;
    }
    if (!good || json_dumpf(root, stream, JSON_INDENT(2) | JSON_REAL_PRECISION(6)) != 0)
        fail("the quality could not be written as JSON");
    fputc('\n', stream);
    json_decref(root);
}

void quality_print_json(const struct baked *baked, const struct quality rows[QUALITY_ROWS], FILE *stream)
{
    json_t *root = json_pack("{s:s, s:i, s:i, s:I}", "format", bake_format_names[baked->format], "width",
                             (int)baked->width, "height", (int)baked->height, "bytes", (json_int_t)baked_bytes(baked));
    if (root && baked->format == BAKE_PALETTE)
        json_object_set_new(root, "entries", json_integer(baked->entries));
    print_rows(root, rows, stream);
}

static json_t *textures_json(const struct fitted *fitted)
{
    json_t *all = json_array();
    for (unsigned i = 0; all && i < fitted->texture_count; i++) {
        const struct texture *texture = &fitted->textures[i];
        if (texture->name)
            json_array_append_new(all, json_pack("{s:o, s:s, s:i, s:i, s:i, s:I}", "picture", json_text(texture->name),
                                                 "format", texture->colors ? "palette" : "rgb565", "width",
                                                 texture->texture.w, "height", texture->texture.h, "levels",
                                                 texture->texture.levels, "bytes", (json_int_t)texture_bytes(texture)));
    }
    return all;
}

void quality_print_mesh_json(const struct baked_mesh *baked, const struct quality rows[QUALITY_ROWS],
                             struct mesh_cycles cycles, FILE *stream)
{
    const struct glint_mesh *mesh = &baked->fitted->mesh;
    json_t *root = json_pack("{s:s, s:i, s:i, s:i, s:I, s:f, s:f}", "format", baked->normals8 ? "int8" : "int16",
                             "vertices", (int)mesh->vertex_count, "triangles", (int)mesh->face_count, "parts",
                             (int)mesh->part_count, "bytes", (json_int_t)baked_mesh_bytes(baked), "predicted_cycles",
                             cycles.c, "predicted_cycles_assembly", cycles.assembly);
    if (root && baked->mesh->face_count > baked->mesh->whole_face_count)
        json_object_set_new(root, "before_split",
                            json_pack("{s:I, s:I, s:I, s:f}", "vertices", (json_int_t)baked->mesh->whole_vertex_count,
                                      "triangles", (json_int_t)baked->mesh->whole_face_count, "bytes",
                                      (json_int_t)fitted_whole_bytes(baked->fitted, baked->mesh, baked->normals8),
                                      "left_by_split", ceil(baked->mesh->whole_turn)));
    if (root && mesh->textures)
        json_object_set_new(root, "textures", textures_json(baked->fitted));
    print_rows(root, rows, stream);
}
