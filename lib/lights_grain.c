/* SPDX-License-Identifier: MIT
 * Grain under several lights: what takes the place of a model's geometry and of its F, where that is of t and m. */
#include "glint_grain.h"
#include "glint_lights.h"

static const struct glint_use_grain *grained_use(const struct glint_lights *lights)
{
    return GLINT_FLASH_POINTER(lights->paint->model->grain);
}

/* Steps 1, 2 and 2a of the view at hand; l is the view's. */
static void grained_geometry(const struct glint_vec *l, const struct glint_vec *v, const struct glint_vec *h,
                             const struct glint_vec *normals, struct glint_sample *samples, unsigned count)
{
    const struct glint_lights *lights =
        (const struct glint_lights *)(const void *)((const uint8_t *)l - offsetof(struct glint_lights, view.l));
    (void)v;
    (void)h;
    GLINT_FLASH_POINTER(grained_use(lights)->sample)
    (lights->paint, lights->grained, NULL, &lights->view, normals, samples, (unsigned)(normals - lights->normals),
     count);
}

/* Step 3: f_q16, which is m. A t that shines is below every cutoff's. */
static void grained_shade(const struct glint_lights *lights, struct glint_sample *sample, unsigned count, bool exact)
{
    const struct glint_use_grain *grain = grained_use(lights);
    if (exact)
        sample->f_q16 = GLINT_FLASH_POINTER(grain->f)(lights->paint, sample->f_q16, sample->t_q30);
    else
        GLINT_FLASH_POINTER(grain->run)(lights->paint, sample, count);
    for (; count--; sample++)
        sample->t_q30 = sample->f_q16 ? 0 : UINT32_MAX;
}

void glint_grain_light(struct glint_lights *lights, struct glint_lines *lines)
{
    if (!glint_grain_is_drawn(lights->paint, lines->maps))
        return;
    lights->grained = lines;
    lights->geometry = grained_geometry;
    lights->shade = grained_shade;
    glint_grain_begin(lines);
}
