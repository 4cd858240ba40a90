/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "base/argp.h"
#include "base/parse.h"
#include "options/mesh_options.h"
#include "options/scene_options.h"

/* Beyond those of scene_options.c. */
enum key {
    KEY_MESH = 576,
    KEY_CREASE,
    KEY_SPLIT,
    KEY_AXES,
    KEY_TEXTURE,
    KEY_NO_TEXTURES,
    KEY_NEAREST,
    KEY_SMOOTH,
    KEY_TEXTURE_BYTES,
    KEY_TEXTURE_TO,
    KEY_NO_OUTLINES,
    KEY_ALLOW_FILES,
    KEY_FLIP_FACES
};

static const char *const texture_formats[] = {"rgb565", "palette", NULL};

static const struct argp_option argp_options[] = {
    {"mesh", KEY_MESH, "FILE", 0,
     "A mesh of triangles: OBJ, STL, PLY or glTF (- is standard input). Its colours, of materials or vertices, "
     "and its textures are used",
     1},

    {NULL, 0, NULL, 0, "The mesh:", 7}, /* below the commands' own groups */
    {"crease", KEY_CREASE, "DEGREES", 0,
     "Normals are made from the mesh's faces, and edges that turn by more than this stay sharp (default: the file's "
     "own normals; 60 where it has none, and for an STL)",
     7},
    {"split", KEY_SPLIT, "DEGREES", 0,
     "Split a mesh's edges over which the normal turns by more than this, 1..180 (default 30, or 45 where each corner "
     "has its own normal). More triangles place highlights better but take bytes and time; glint bake prints how many. "
     "180 splits none",
     7},
    {"axes", KEY_AXES, "NAME", 0,
     "Which way is up in the mesh's file: y-up or z-up (default: z-up for an STL, else y-up)", 7},
    {"flip-faces", KEY_FLIP_FACES, NULL, 0,
     "Turn a mesh's file inside out: for one whose triangles show their inner side. Its own normals are turned where "
     "they point inwards then",
     7},
    {"no-outlines", KEY_NO_OUTLINES, NULL, 0,
     "Do not smooth a mesh's outlines; glint bake then leaves out each triangle's neighbours (6 bytes a triangle)", 7},
    {"texture", KEY_TEXTURE, "FILE", 0,
     "A picture (PNG or JPEG) for all parts of a mesh that has texture coordinates, in the place of its own textures; "
     "the built-in mesh has them, too",
     7},
    {"no-textures", KEY_NO_TEXTURES, NULL, 0, "Leave a mesh's textures out: each part has its colour", 7},
    {"allow-files", KEY_ALLOW_FILES, "DIR", 0,
     "Let a mesh name files (materials, textures, a glTF's numbers) in this folder or below, too, beside those in its "
     "own folder or below",
     7},
    {"nearest", KEY_NEAREST, NULL, 0,
     "Draw the nearest pixel of a texture, faster than --smooth (default: as the file says)", 7},
    {"smooth", KEY_SMOOTH, NULL, 0, "Blend the four pixels around (the default where the file says nothing)", 7},
    {"texture-bytes", KEY_TEXTURE_BYTES, "N", 0,
     "Scale textures down until all of them, each with its halves, quarters and so on, fit in N bytes (default 196608)",
     7},
    {"texture-to", KEY_TEXTURE_TO, "FORMAT", 0,
     "Keep textures as rgb565 (default), or as palette: 256 colours of RGB565 and 8 bits a pixel", 7},
    {NULL, 0, NULL, 0, NULL, 0}};

/* An option of textures that was given; NULL: none. */
static const char *texture_option(const struct mesh_source *mesh)
{
    return mesh->texture           ? "--texture"
           : mesh->no_textures     ? "--no-textures"
           : mesh->wish.is_nearest ? "--nearest"
           : mesh->wish.is_smooth  ? "--smooth"
           : mesh->wish.bytes      ? "--texture-bytes"
           : mesh->wish.palette    ? "--texture-to"
                                   : NULL;
}

static void check(const struct argp_state *state, struct scene_options *o)
{
    struct mesh_source *mesh = &o->mesh;
    if (!mesh->name &&
        (mesh->crease >= 0 || mesh->split > 0 || mesh->axes != AXES_USUAL || mesh->flipped || mesh->stepped))
        refuse(state, "%s needs --mesh",
               mesh->crease >= 0          ? "--crease"
               : mesh->split > 0          ? "--split"
               : mesh->axes != AXES_USUAL ? "--axes"
               : mesh->flipped            ? "--flip-faces"
                                          : "--no-outlines");
    if (!mesh->name && texture_option(mesh))
        refuse(state, "%s needs --mesh", texture_option(mesh));
    if (mesh->allowed && (!mesh->name || mesh->built_in || strcmp(mesh->name, "-") == 0))
        refuse(state, "--allow-files needs --mesh with a file's name");
    if (mesh->texture && mesh->no_textures)
        refuse(state, "give only one of --texture and --no-textures");
    if (mesh->wish.is_nearest && mesh->wish.is_smooth)
        refuse(state, "give only one of --nearest and --smooth");
    if (mesh->texture && strcmp(mesh->texture, "-") == 0)
        refuse(state, "--texture: name a file; a picture for a mesh cannot come from standard input");
    if (mesh->built_in && (mesh->axes != AXES_USUAL || mesh->flipped))
        refuse(state, "%s is for a mesh's file; leave it out with a built-in mesh",
               mesh->flipped ? "--flip-faces" : "--axes");
    if (mesh->name && (o->albedo || o->gloss || o->mask))
        refuse(state, "%s is for maps; it cannot be used with a mesh",
               o->albedo ? "--albedo"
               : o->mask ? "--mask"
                         : "--gloss");
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct scene_options *o = state->input;
    switch (key) {
    case KEY_MESH:
        o->mesh.name = text;
        o->mesh.built_in = false;
        return 0;
    case KEY_CREASE:
        o->mesh.crease = parse_real(state, "--crease", text, 0, 180);
        return 0;
    case KEY_SPLIT:
        o->mesh.split = parse_real(state, "--split", text, 1, 180);
        return 0;
    case KEY_AXES:
        o->mesh.axes = (enum mesh_axes)parse_choice(state, "--axes", "axes", text, mesh_axes_names);
        return 0;
    case KEY_FLIP_FACES:
        o->mesh.flipped = true;
        return 0;
    case KEY_NO_OUTLINES:
        o->mesh.stepped = true;
        return 0;
    case KEY_TEXTURE:
        o->mesh.texture = text;
        return 0;
    case KEY_NO_TEXTURES:
        o->mesh.no_textures = true;
        return 0;
    case KEY_ALLOW_FILES:
        o->mesh.allowed = text;
        return 0;
    case KEY_NEAREST:
        o->mesh.wish.is_nearest = true;
        return 0;
    case KEY_SMOOTH:
        o->mesh.wish.is_smooth = true;
        return 0;
    case KEY_TEXTURE_BYTES:
        o->mesh.wish.bytes = (size_t)parse_integer(state, "--texture-bytes", text, 2, 1 << 26);
        return 0;
    case KEY_TEXTURE_TO:
        o->mesh.wish.palette = parse_choice(state, "--texture-to", "format", text, texture_formats) == 1;
        return 0;
    case ARGP_KEY_END:
        check(state, o);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp mesh_options_argp = {argp_options, parse_option, NULL, NULL, NULL, NULL, NULL};
