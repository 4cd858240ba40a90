/* SPDX-License-Identifier: MIT
 * The materials that an OBJ uses, and what its MTL says of them. */
#ifndef GLINT_MESH_OBJ_MATERIALS_H
#define GLINT_MESH_OBJ_MATERIALS_H

#include "mesh/soup.h"

enum { OBJ_MATERIALS_MAX = 4096 };

struct obj_material {
    char *name, *picture;     /* NULL: it wears none */
    double scale[2], move[2]; /* of u and v, v up, to its place in the picture */
    struct mesh_material look;
    unsigned part; /* from 1, in the order in which they are told; 0: no MTL tells of it */
};
struct obj_materials {
    unsigned count, room, part_count;
    size_t bytes; /* of the MTLs that were read */
    struct obj_material *of;
    void (*note)(const char *text); /* what is left out, as the end of a message */
};
void obj_materials_free(struct obj_materials *materials);
/* The number of the one of this name, which is there from now on; OBJ_MATERIALS_MAX where there are too many. `of` may move. */
unsigned obj_materials_find(struct obj_materials *materials, const char *name);
/* Ks, Ns, Kd, illum 0 and map_Kd with -clamp, -s and -o; what it does not understand it leaves. */
void obj_materials_read(struct obj_materials *materials, const char *text, size_t len);
/* The parts of the soup, and the names of its pictures, if they are wanted; behind the materials that were told one for all others. */
void obj_materials_give(const struct obj_materials *materials, struct soup *soup, bool pictures);

#endif
