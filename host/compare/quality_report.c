/* SPDX-License-Identifier: MIT */
#include "compare/quality_report.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/message.h"
#include "base/text.h"
#include "mesh/load.h"

static void print_rows(const struct quality *rows, const char *what, FILE *stream)
{
    fprintf(stream, "   n  largest     mean  PSNR dB  in levels of 255, %s\n", what);
    for (int i = 0; i < QUALITY_ROWS; i++) {
        const struct difference *d = &rows[i].difference;
        fprintf(stream, "%4u  %7.0f  %7.4f  ", rows[i].n, d->largest, difference_mean(d));
        if (d->differing)
            fprintf(stream, "%7.2f\n", difference_psnr_db(d));
        else
            fputs("no difference\n", stream);
    }
}

void quality_print(const struct baked *baked, const struct quality rows[QUALITY_ROWS], FILE *stream)
{
    fprintf(stream, "%s, %" PRIu32 "x%" PRIu32 ", %zu bytes", bake_format_names[baked->format], baked->width,
            baked->height, baked_bytes(baked));
    if (baked->format == BAKE_PALETTE)
        fprintf(stream, ", %" PRIu32 " entries (the first is no surface)", baked->entries);
    fputc('\n', stream);
    if (rows[0].difference.samples == 0)
        fputs("no surface: the mask leaves every pixel out\n", stream);
    else
        print_rows(rows, "the highlight alone", stream);
}

static void print_texture(const struct texture *texture, FILE *stream)
{
    if (!texture->name)
        return;
    fputs("texture ", stream);
    text_print(stream, texture->name);
    fprintf(stream, ": %ux%u, ", texture->texture.w, texture->texture.h);
    if (texture->colors)
        fprintf(stream, "palette of %u colours", texture->colors);
    else
        fputs("rgb565", stream);
    fprintf(stream, ", %u pictures, each of half the size: %zu bytes of these\n", texture->texture.levels,
            texture_bytes(texture));
}

/* What splitting edges cost, and from which angle on it costs nothing. */
static void print_split(const struct baked_mesh *baked, FILE *stream)
{
    const struct mesh *mesh = baked->mesh;
    if (mesh->face_count > mesh->whole_face_count)
        fprintf(stream, "--split %g made these of %zu vertices, %zu triangles, %zu bytes, which --split %.0f leaves\n",
                mesh->split, mesh->whole_vertex_count, mesh->whole_face_count,
                fitted_whole_bytes(baked->fitted, mesh, baked->normals8), ceil(mesh->whole_turn));
    else if (mesh->has_own_normals && mesh->whole_turn > SPLIT_USUAL)
        fprintf(stream,
                "no edge is split: the file's own normals turn by at most %.0f degrees over an edge; --split %d splits "
                "some\n",
                ceil(mesh->whole_turn), SPLIT_USUAL);
}

void quality_print_mesh(const struct baked_mesh *baked, const struct quality rows[QUALITY_ROWS],
                        struct mesh_cycles cycles, FILE *stream)
{
    const struct glint_mesh *mesh = &baked->fitted->mesh;
    fprintf(stream, "%u vertices%s, %u triangles, %u part%s, normals as %s: %zu bytes\n", mesh->vertex_count,
            baked->fitted->colors ? " with colours" : "", mesh->face_count, mesh->part_count,
            mesh->part_count > 1 ? "s" : "", baked->normals8 ? "int8" : "int16", baked_mesh_bytes(baked));
    print_split(baked, stream);
    for (unsigned i = 0; i < baked->fitted->texture_count && mesh->textures; i++)
        print_texture(&baked->fitted->textures[i], stream);
    print_rows(rows,
               mesh->textures ? "pictures of 240x240 from three sides, without textures"
                              : "pictures of 240x240 from three sides",
               stream);
    fprintf(
        stream,
        "such a picture takes a Cortex-M0+ %.1f million cycles by COLOUR tables%s in C, %.1f in assembly (predicted)\n",
        cycles.c / 1e6, baked->fitted->colors || mesh->textures ? " in one colour" : "", cycles.assembly / 1e6);
}

void quality_printed(FILE *stream)
{
    if (fflush(stream) != 0 || ferror(stream))
        fail("standard %s: the quality could not be written: %s", stream == stderr ? "error" : "output",
             strerror(errno));
}
