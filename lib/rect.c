/* SPDX-License-Identifier: MIT
 * The exact rectangle path. */
#include "glint_rect.h"
#include "glint_math_align.h"
#include "glint_pixel.h"

enum glint_err glint_rect_check(const struct glint_shader *shader, const struct glint_source *source,
                                const struct glint_surface *surface)
{
    if (!shader || !source || !surface || !source->normals || !surface->pixels ||
        GLINT_MISALIGNED(source->normals, 16) || GLINT_MISALIGNED(source->normals_stride, 16))
        return GLINT_ERR_ARG;
    return glint_pixel_check(shader);
}

void glint_bounds_add(struct glint_bounds *b, uint16_t x, uint16_t y)
{
    if (!b->any) {
        b->left = b->right = x;
        b->top = y;
        b->any = true;
    }
    b->left = x < b->left ? x : b->left;
    b->right = x > b->right ? x : b->right;
    b->bottom = y;
}

void glint_bounds_box(const struct glint_bounds *b, struct glint_box *box)
{
    if (!box)
        return;
    const struct glint_box none = {0, 0, 0, 0};
    *box = none;
    if (b->any) {
        box->x = b->left;
        box->y = b->top;
        box->w = (uint16_t)(b->right - b->left + 1);
        box->h = (uint16_t)(b->bottom - b->top + 1);
    }
}

enum glint_err glint_shade_rect(const struct glint_shader *shader, const struct glint_source *source, uint16_t w,
                                uint16_t h, const struct glint_surface *surface, struct glint_box *highlight)
{
    const enum glint_err err = glint_rect_check(shader, source, surface);
    if (err)
        return err;
    struct glint_bounds bounds = {0, 0, 0, 0, false};
    for (uint16_t y = 0; y < h; y++) {
        const struct glint_line line = glint_line_at(source, y);
        for (uint16_t x = 0; x < w; x++) {
            if (line.mask && !line.mask[x])
                continue;
            const struct glint_vec *normal = &line.normals[x];
            if (glint_pixel(shader, surface, x, y, glint_pixel_t(&shader->lobe, &shader->light, normal),
                            glint_dot(normal, &shader->light.l),
                            line.albedo ? line.albedo + 3 * (ptrdiff_t)x : shader->material.albedo,
                            line.gloss ? line.gloss[x] : 255))
                glint_bounds_add(&bounds, x, y);
        }
    }
    glint_bounds_box(&bounds, highlight);
    return GLINT_OK;
}
