/* SPDX-License-Identifier: MIT
 * OBJ: v (with colours), vt, vn, f, usemtl and mtllib, in any spelling of numbers, places in lists from -1 back, continued lines. Other lines say nothing
 * that is drawn. */
#ifndef GLINT_MESH_OBJ_H
#define GLINT_MESH_OBJ_H

#include "mesh/soup.h"

struct obj_materials;
struct obj_source {
    const char *text;
    size_t len;
    bool textures; /* are its pictures wanted? */
    /* For an MTL that it names: hands its text to obj_materials_read. False: it cannot be read; nothing is said. */
    bool (*library)(struct obj_materials *materials, const char *name);
    void (*missing)(const char *name); /* such an MTL */
    void (*note)(const char *text);    /* what is left out, as the end of a message */
};
/* Pictures have names only; where there are more triangles than can be drawn none are there, but their count is. NULL: `wrong` says why, as the end of
 * a message. */
struct soup *obj_soup(const struct obj_source *source, char wrong[120]);

#endif
