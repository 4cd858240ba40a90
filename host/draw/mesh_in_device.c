/* SPDX-License-Identifier: MIT */
#include "draw/mesh_in_device.h"

#include <math.h>
#include <string.h>

#include "draw/shading_device.h"
#include "mesh_cksum.h"

bool mesh_in_device(const struct light_mesh *there, const struct fitted *fitted)
{
    const struct glint_mesh *mesh = &fitted->mesh;
    return mesh->vertex_count == there->vertices && mesh->face_count == there->faces && mesh->part_count <= 1 &&
           mesh_cksum(mesh) == there->cksum;
}

const char *mesh_in_device_refusal(const struct view *view, const struct shading *shading, const uint8_t *behind,
                                   struct light_material *material)
{
    const struct scene plain = {0};
    const char *refusal = device_refusal(&plain, shading, material);
    if (!refusal && view->distance > 0)
        refusal = "the device draws by parallel projection; leave out --perspective";
    if (!refusal && behind)
        refusal = device_needs_black;
    return refusal;
}

/* Of 16 bits, scaled so that the device comes to the light that is drawn by here; where no scale does, to a neighbour of it. */
static void light_numbers(int16_t out[3], const double direction[3], struct glint_paint *paint)
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    const struct glint_vec l = paint->l, h = paint->h;
    const double longest = fmax(fabs(direction[0]), fmax(fabs(direction[1]), fabs(direction[2])));
    for (int scale = 32767; scale > 8192; scale--) {
        int32_t to_light[3];
        struct glint_light light;
        for (unsigned k = 0; k < 3; k++)
            to_light[k] = (int32_t)lround(direction[k] / longest * scale);
        const bool good = glint_light_directional(&light, to_light) == GLINT_OK &&
                          glint_paint_light(paint, &light, 1, to_viewer) == GLINT_OK &&
                          memcmp(&paint->l, &l, sizeof l) == 0 && memcmp(&paint->h, &h, sizeof h) == 0;
        for (unsigned k = 0; k < 3 && (good || scale == 32767); k++)
            out[k] = (int16_t)to_light[k];
        if (good)
            return;
    }
}

struct light_pose mesh_in_device_pose(const struct view *view, const struct shading *shading)
{
    struct glint_light lights[GLINT_LIGHTS_MAX];
    struct glint_paint paint = shading_paint(shading, lights);
    struct light_pose pose = {.pose = view_pose(view)};
    light_numbers(pose.to_light, shading->lamps[0].direction, &paint);
    return pose;
}
