/* SPDX-License-Identifier: MIT */
#include "mesh/mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void mesh_picture_clear(struct mesh_picture *picture)
{
    free(picture->name);
    free(picture->rgb);
    *picture = (struct mesh_picture){.name = NULL};
}

void mesh_pictures_free(struct mesh_picture *pictures, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        mesh_picture_clear(&pictures[i]);
    free(pictures);
}

void mesh_free(struct mesh *mesh)
{
    if (!mesh)
        return;
    free(mesh->name);
    free(mesh->places);
    free(mesh->normals);
    free(mesh->colors);
    free(mesh->at);
    free(mesh->faces);
    free(mesh->ends);
    free(mesh->materials);
    free(mesh->uv);
    mesh_pictures_free(mesh->pictures, mesh->picture_count);
    free(mesh);
}

unsigned mesh_part_of(const struct mesh *mesh, size_t face)
{
    unsigned part = 0;
    while (part + 1 < mesh->part_count && face >= mesh->ends[part])
        part++;
    return part;
}

/* A metal scatters nothing, but mirrors what is around it, of which nothing is known here: the part of its diffuse light that stays stands for
 * that. The highlight's peak is that of a microfacet surface under one light, F0 (n + 2) / 8 where n = 2 / r^4 - 2. */
void mesh_material_look(const struct mesh_material *material, double ambient[3], double diffuse[3], double specular[3])
{
    const double metal_diffuse = .5, plastic_f0 = .04, metal = material->metallic, r = fmax(material->roughness, .1);
    double f0[3], most = 0;
    for (int k = 0; k < 3; k++) {
        f0[k] = plastic_f0 * (1 - metal) + metal * material->tint[k] / 255.;
        most = fmax(most, f0[k]);
    }
    const double times = fmin(1 / most, 1 / (4 * r * r * r * r)); /* no channel above 1, and the colour stays */
    for (int k = 0; k < 3; k++) {
        if (material->has_roughness) {
            diffuse[k] *= 1 - metal * (1 - metal_diffuse);
            specular[k] = times * f0[k];
        }
        if (material->has_highlight)
            specular[k] *= material->highlight[k];
        if (material->unlit) {
            ambient[k] = 1;
            diffuse[k] = specular[k] = 0;
        }
    }
}

uint8_t mesh_level(double part)
{
    return (uint8_t)lround(255 * fmin(1, fmax(0, part)));
}

static double linear_of(uint8_t encoded)
{
    const double value = encoded / 255.;
    return value <= .04045 ? value / 12.92 : pow((value + .055) / 1.055, 2.4);
}

void mesh_material_set_factor(struct mesh_material *material)
{
    const bool is_said = memcmp(material->color, "\0\0", 3) != 0 && memcmp(material->color, "\x99\x99\x99", 3) != 0;
    for (int k = 0; k < 3; k++)
        material->factor[k] = is_said ? linear_of(material->color[k]) : 1;
}

double mesh_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void mesh_cross(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* By a power of two, near 1, so that squares neither vanish nor overflow. */
static void scale(double v[3])
{
    const double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    int exponent = 0;
    if (largest < INFINITY)
        frexp(largest, &exponent);
    for (int k = 0; k < 3; k++)
        v[k] = ldexp(v[k], -exponent);
}

bool mesh_normalize(double v[3])
{
    double length = sqrt(mesh_dot(v, v));
    if (!(length > 1e-30 && length < 1e30)) {
        scale(v);
        length = sqrt(mesh_dot(v, v));
    }
    if (!(length > 0 && length < INFINITY))
        return false;
    for (int k = 0; k < 3; k++)
        v[k] /= length;
    return true;
}

void mesh_face_normal(const double a[3], const double b[3], const double c[3], double out[3])
{
    double p[3], q[3];
    for (int k = 0; k < 3; k++) {
        p[k] = b[k] - a[k];
        q[k] = c[k] - a[k];
    }
    mesh_cross(p, q, out);
}

double mesh_cosine(double degrees)
{
    return degrees >= 180 ? -2 : cos(degrees * M_PI / 180) - 1e-12; /* rounding decides nothing */
}
