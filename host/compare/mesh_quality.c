/* SPDX-License-Identifier: MIT */
#include "compare/mesh_quality.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "compare/compare.h"
#include "compare/mesh_scene.h"
#include "draw/mesh_canvas.h"
#include "draw/paths.h"
#include "scene/scene.h"

enum { SIDE = 240 };
const struct view mesh_views[MESH_VIEWS] = {
    {SIDE, SIDE, {25, -30, 0}, 1, 0}, {SIDE, SIDE, {-20, 100, 0}, 1, 0}, {SIDE, SIDE, {50, 215, 0}, 1, 0}};
static const unsigned shininess[QUALITY_ROWS] = {10, 60, 200, 1000};

static struct shading shading_with(unsigned n)
{
    struct shading shading = {.model = GLINT_MSH,
                              .n = n,
                              .q = 8,
                              .view = {0, 0, 1},
                              .lamps = {{.kind = LAMP_DIRECTIONAL, .direction = {-1, 1, 1}, .color = {1, 1, 1}}},
                              .lamp_count = 1,
                              .color = {200, 200, 200},
                              .format = GLINT_RGB888};
    memcpy(shading.ambient, plain_finish.ambient, sizeof shading.ambient);
    memcpy(shading.diffuse, plain_finish.diffuse, sizeof shading.diffuse);
    memcpy(shading.specular, plain_finish.specular, sizeof shading.specular);
    return shading;
}

static void add_view(const struct fitted *fitted, const struct view *view, const struct scene *scene, unsigned parts,
                     struct quality *row)
{
    struct shading *shadings = allocate(parts, sizeof *shadings);
    for (unsigned i = 0; i < parts; i++)
        shadings[i] = shading_with(row->n);
    struct mesh_canvas *canvas = mesh_canvas_new(fitted, shadings);
    uint8_t *pixels = allocate((size_t)SIDE * SIDE, 3);
    mesh_canvas_draw_stepped(canvas, view, pixels);
    struct levels *levels = levels_of_pixels(SIDE, SIDE, GLINT_RGB888, pixels);
    struct comparison comparison;
    compare(scene, shadings, levels, &comparison);
    difference_merge(&row->difference, &comparison.rounded);
    levels_free(levels);
    free(pixels);
    mesh_canvas_free(canvas);
    free(shadings);
}

void mesh_quality(const struct mesh *mesh, const struct fitted *fitted, bool normals8,
                  struct quality rows[QUALITY_ROWS])
{
    struct fitted chosen = *fitted;
    chosen.colors = NULL; /* the shading's one colour */
    chosen.mesh.textures = NULL;
    if (normals8)
        chosen.mesh.normals = NULL;
    for (int i = 0; i < QUALITY_ROWS; i++)
        rows[i] = (struct quality){.n = shininess[i]};
    for (int v = 0; v < MESH_VIEWS; v++) {
        struct mesh_coverage coverage;
        struct scene *scene = mesh_scene(mesh, &chosen, &mesh_views[v], NULL, &coverage);
        for (int i = 0; i < QUALITY_ROWS; i++)
            add_view(&chosen, &mesh_views[v], scene, mesh->part_count, &rows[i]);
        scene_free(scene);
    }
}
