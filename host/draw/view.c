/* SPDX-License-Identifier: MIT */
#include "draw/view.h"

#include <math.h>
#include <string.h>

/* Half angles: each turn is a quaternion about one axis, and the later ones are multiplied from the left. */
static void quaternion(const struct view *view, double q[4])
{
    static const int axes[3] = {1, 0, 2};
    double all[4] = {1, 0, 0, 0};
    for (int i = 0; i < 3; i++) {
        const int axis = axes[i];
        const double half = view->turn[axis] * M_PI / 360, w = cos(half), s = sin(half);
        double v[3] = {0, 0, 0}, next[4];
        v[axis] = s;
        next[0] = w * all[0] - v[0] * all[1] - v[1] * all[2] - v[2] * all[3];
        for (int k = 0; k < 3; k++) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            next[1 + k] = w * all[1 + k] + v[k] * all[0] + v[a] * all[1 + b] - v[b] * all[1 + a];
        }
        memcpy(all, next, sizeof all);
    }
    memcpy(q, all, sizeof all);
}

void view_rotation(const struct view *view, double m[3][3])
{
    double q[4];
    quaternion(view, q);
    const double w = q[0], *v = q + 1;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i][j] = 2 * v[i] * v[j] + (i == j ? 2 * w * w - 1 : 0);
    for (int k = 0; k < 3; k++) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        m[b][a] += 2 * w * v[k];
        m[a][b] -= 2 * w * v[k];
    }
}

double view_radius(const struct view *view)
{
    return view->zoom * fmin(view->width, view->height) / 2;
}

/* 1/16 pixel, of the library's 32768 units. */
static double scale_of(const struct view *view)
{
    return round(16 * view_radius(view) * 32768 / 32767);
}

static double distance_of(const struct view *view)
{
    return round(16 * view_radius(view) * view->distance);
}

struct glint_pose view_pose(const struct view *view)
{
    struct glint_pose pose = {.scale = (uint16_t)scale_of(view)};
    double q[4];
    quaternion(view, q);
    for (int k = 0; k < 4; k++)
        pose.turn[k] = (int16_t)lround(32767 * q[k]);
    return pose;
}

uint16_t view_distance(const struct view *view)
{
    return (uint16_t)distance_of(view);
}

const char *view_refusal(const struct view *view)
{
    if (view->width > GLINT_MESH_SIZE_MAX || view->height > GLINT_MESH_SIZE_MAX)
        return "a mesh's picture has at most 2040 pixels a side; give a smaller --size";
    if (scale_of(view) > UINT16_MAX)
        return "the mesh is drawn too large; give a smaller --zoom or --size";
    if (distance_of(view) > UINT16_MAX)
        return "the camera is too far away; give a smaller --perspective, --zoom or --size";
    return NULL;
}
