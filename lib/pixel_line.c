/* SPDX-License-Identifier: MIT
 * What a rectangle folds to for the line in assembly (cortex_m0plus_rgb565.S). */
#include "glint_pixel_line.h"

#if GLINT_CORTEX_M0PLUS_ASM
#include "glint_math_reciprocal.h"
#include "glint_pixel_offsets.h"

#define LINE_AT(field, offset) (offsetof(struct glint_line_loop, field) == (offset))
typedef char glint_line_layout[LINE_AT(l, GLINT_AT_LINE_L) && LINE_AT(t_end, GLINT_AT_LINE_T_END) &&
                                       LINE_AT(base, GLINT_AT_LINE_BASE) && LINE_AT(r, GLINT_AT_LINE_R) &&
                                       LINE_AT(k, GLINT_AT_LINE_K) && LINE_AT(reciprocals, GLINT_AT_LINE_RECIPROCALS) &&
                                       LINE_AT(f_max, GLINT_AT_LINE_F_MAX) && LINE_AT(dark, GLINT_AT_LINE_DARK) &&
                                       LINE_AT(minus_h, GLINT_AT_LINE_MINUS_H) &&
                                       LINE_AT(limit, GLINT_AT_LINE_MINUS_H + 12) && LINE_AT(out, GLINT_AT_LINE_OUT) &&
                                       LINE_AT(w, GLINT_AT_LINE_OUT + 4) && LINE_AT(mask, GLINT_AT_LINE_OUT + 8) &&
                                       LINE_AT(normals, GLINT_AT_LINE_OUT + 12) &&
                                       LINE_AT(albedo, GLINT_AT_LINE_OUT + 16) && LINE_AT(first, GLINT_AT_LINE_LIT) &&
                                       LINE_AT(last, GLINT_AT_LINE_LIT + 4) && sizeof(struct glint_vec) == 6
                                   ? 1
                                   : -1];
#undef LINE_AT

bool glint_line_begin(struct glint_line_loop *loop, const struct glint_prepared *p, bool albedo)
{
    const struct glint_shader *shader = &p->shader;
    const struct glint_light *light = &shader->light;
    if (GLINT_FLASH_U8(p->model->model) != GLINT_MSH || p->shift != GLINT_LINE_SHIFT || shader->dither ||
        glint_light_is_wide(light))
        return false;
    const struct glint_vec l = light->l, h = light->h;
    loop->l[0] = l.x, loop->l[1] = l.y, loop->l[2] = l.z;
    loop->minus_h[0] = -h.x, loop->minus_h[1] = -h.y, loop->minus_h[2] = -h.z;
    loop->t_end = 2 * p->near.t_end;
    loop->f_max = p->near.f_max;
    for (int k = 0; k < 3; k++) {
        loop->base[k].nl = albedo ? p->diffuse[k] : p->q[k];
        loop->base[k].one = albedo ? p->ambient[k] : p->p[k];
        loop->r[k] = p->r[k];
        loop->k[k] = p->near.k[k];
    }
    loop->k[2]--;
    loop->reciprocals = glint_reciprocals;
    loop->limit = 0 - ((albedo ? p->w_maps : p->w) << (32 - GLINT_LINE_SHIFT));
    const bool swapped = shader->format == GLINT_RGB565_SWAPPED;
    loop->draw = albedo    ? swapped ? glint_line_rgb565_albedo_swapped : glint_line_rgb565_albedo
                 : swapped ? glint_line_rgb565_swapped
                           : glint_line_rgb565;
    return true;
}
#endif
