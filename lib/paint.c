/* SPDX-License-Identifier: MIT
 * A paint: what material, output and the one light's colour fold to, and runs of samples by it. Directional lights; a paint's steps. */
#include "glint_lights.h"
#include "glint_math_vector.h"
#include "glint_port.h"
#include "glint_tables.h"

typedef char
    glint_paint_bytes[sizeof(void *) > 4 || sizeof(struct glint_paint) <= 240 ? 1 : -1]; /* it lies on stacks */

enum glint_err glint_paint_check(const struct glint_material *material, const struct glint_output *output, bool grain)
{
    if (!material || !output || material->n == 0 || (!grain && glint_material_across(material)))
        return GLINT_ERR_ARG;
    return output->format < GLINT_FORMAT_COUNT && output->space <= GLINT_LINEAR ? GLINT_OK : GLINT_ERR_FORMAT;
}

/* The cutoff 2^-q that an output needs where the material names none. */
static uint8_t paint_q(const struct glint_material *material, const struct glint_output *output)
{
    const bool is_coarse = GLINT_FLASH_U8(glint_formats[output->format].max[0]) < 255;
    if (material->q)
        return material->q;
    return output->space == GLINT_LINEAR ? 12 : is_coarse && !output->dither ? 6 : 8;
}

/* A coloured light folds into the material's coefficients, so that it is as fast as a white one. The sequence takes D N and S F of a channel with
 * N = round(c x), x = nl; here D' 2^up x takes the place of D N: D' = floor(D c' / 2^15), c' = floor(c / 2^(up + 1)) <= 2^15.
 *
 * In units of 2^-16, N = c x + a, |a| <= 1/2, and D' 2^up = D c - e, 0 <= e < 3 2^up. So D N - D' 2^up x = D a + e x: from -D / 2 to
 * D / 2 + 3 2^up, as x <= 1; and of S and F, which is up to 33/32, likewise. With M levels V is high by at most M (D + S) / 2 units of
 * 2^(shift - 16), which is taken off thresholds, and W grows by twice that and by 3 65/32 M 2^up. Albedo and gloss, <= 1, only
 * lessen this; in grey the channels' parts of M add up to M. In linear space a unit is 2^shift, and D + S at most 2 of them (tests/proof). */
static void paint_fold_high(struct glint_paint *p, uint32_t max, unsigned up)
{
    const uint32_t high = p->of.exact.high, shift = p->of.exact.shift & 255;
    uint32_t w = (2 * high + ((uint32_t)7 << up)) << shift;
    if (p->output.space == GLINT_GAMMA) {
        w = (4 * high + (max * 25 >> 2 << up) + ((uint32_t)1 << up)) << (shift - 16);
        if (!glint_format_is_grey(p->output.format) &&
            !p->output.dither) /* P has the threshold, if there are no maps */
            for (unsigned k = 0; k < 3; k++)
                p->of.exact.p[k] -= high << (shift - 15);
    }
    p->of.exact.w += w;
    p->of.exact.w_maps += w;
}

void glint_paint_fold(struct glint_paint *p, bool rounds)
{
    const struct glint_material *const m = &p->material;
    struct glint_coefficients c;
    const uint32_t peak = glint_paint_peak(p), max = GLINT_FLASH_U8(glint_formats[p->output.format].max[1]);
    unsigned up = 0;
    uint32_t most = 0, tint = 0; /* most: D + S, <= 2^17 */
    while (peak > (uint32_t)65536 << up)
        up++;
    for (unsigned k = 0; k < 3; k++) {
        const uint32_t color = p->color_q16[k], half = color >> up >> 1; /* of 1.0 it leaves D and S as they are */
        const uint32_t d = glint_coefficient(m->diffuse_q16[k]), s = glint_coefficient(m->specular_q16[k]);
        tint |= color ^ 65536;
        most = d + s > most ? d + s : most;
        c.d[k] = (d * half >> 15) << p->of.exact.nl_down;
        c.s[k] = (s * half >> 15) << p->of.exact.f_down;
    }
    /* 1..640; 0: the light is white. Of a light that has a place x = att nl + b, |b| <= 1/2, is rounded, too: D a - D c b */
    uint32_t high = rounds ? 1 + ((uint32_t)1 << up) : 1;
    if (p->output.space == GLINT_GAMMA)
        high = (max * (most + 1) * high + 262143) >> 18;
    p->of.exact.high = (uint16_t)(tint ? high : 0);
    GLINT_FLASH_POINTER(p->format->fold)(p, &c, up);
    if (tint)
        paint_fold_high(p, max, up);
}

/* For one light, or none. */
static void paint_fold_one(struct glint_paint *p)
{
    p->of.exact.slack = GLINT_FLASH_U8(p->model->slack);
    p->of.exact.nl_down = p->of.exact.f_down = 0;
    glint_paint_fold(p, false);
}

void glint_paint_unlit(struct glint_paint *paint, const struct glint_output *output)
{
    paint->output.format = output->format; /* by fields: no call of memcpy */
    paint->output.space = output->space;
    paint->output.dither = output->dither;
    paint->several = NULL;
    paint->lights = NULL;
    paint->light_count = 255;
    paint->color_q16[0] = paint->color_q16[1] = paint->color_q16[2] = 65536;
}

enum glint_err glint_paint_exact_for(struct glint_paint *paint, const struct glint_material *material,
                                     const struct glint_output *output, const struct glint_use_model *model,
                                     const struct glint_use_format *format)
{
    if (!paint || !model || !format)
        return GLINT_ERR_ARG;
    const enum glint_err err = glint_paint_check(material, output, GLINT_FLASH_POINTER(model->grain) != NULL);
    if (err == GLINT_ERR_ARG || material->model != GLINT_FLASH_U8(model->model))
        return GLINT_ERR_ARG;
    if (err || !GLINT_FLASH_POINTER(format->draws)(output))
        return GLINT_ERR_FORMAT;
    const uint32_t n = material->n < GLINT_N_MAX ? material->n : GLINT_N_MAX;
    paint->material = *material;
    paint->material.q = paint_q(material, output);
    paint->model = model;
    paint->format = format;
    glint_paint_unlit(paint, output);
    paint->of.exact.n = n;
    paint->of.exact.f_max = paint->material.clamp_peak ? 65536 : UINT32_MAX;
    paint->of.exact.t_end = GLINT_FLASH_POINTER(model->cutoff_t)(n, paint->material.q) + 1;
    if (GLINT_FLASH_POINTER(model->fold))
        GLINT_FLASH_POINTER(model->fold)(paint);
    paint_fold_one(paint);
    return GLINT_OK;
}

/* ---- Lit ---- */

/* One directional light, or none: NULL, as a white one of direction 0, where N.L is 0. */
static enum glint_err paint_light_one(struct glint_paint *paint, const struct glint_light *light,
                                      const int32_t v_q30[3])
{
    struct glint_vec h;
    int32_t l_q30[3] = {0, 0, 0};
    uint32_t color[3] = {65536, 65536, 65536}, tint = 0, change = paint->several ? 1 : 0;
    for (unsigned k = 0; k < 3; k++) {
        if (light) {
            l_q30[k] = light->direction_q30[k];
            color[k] = glint_light_color(light, k);
        }
        tint |= color[k] ^ 65536;
        change |= color[k] ^ paint->color_q16[k];
    }
    const bool exact = glint_paint_is_exact(paint);
    if (tint && !exact)
        return GLINT_ERR_ARG;
    if (!glint_light_half(&h, l_q30, v_q30))
        return GLINT_ERR_VECTOR;
    paint->h = h;
    (void)glint_vec_of_q30(&paint->l, l_q30, 0);
    (void)glint_vec_of_q30(&paint->v, v_q30, 0);
    paint->several = NULL;
    for (unsigned k = 0; k < 3; k++)
        paint->color_q16[k] = color[k];
    if (!exact)
        GLINT_FLASH_POINTER(paint->of.tables.filled.use->light)(paint);
    else if (change) /* else the material is folded as it is to be */
        paint_fold_one(paint);
    return GLINT_OK;
}

enum glint_err glint_paint_light_by(struct glint_paint *paint, const struct glint_light *lights, unsigned count,
                                    const int32_t to_viewer[3], const struct glint_use_lights *several)
{
    int32_t v_q30[3];
    if (!paint || !(paint->format || paint->of.tables.filled.use) || !to_viewer || count > GLINT_LIGHTS_MAX ||
        (count && !lights))
        return GLINT_ERR_ARG;
    bool are_several = count > 1;
    for (unsigned i = 0; i < count; i++) {
        const struct glint_light_kind *kind = lights[i].kind;
        if (!kind || GLINT_FLASH_POINTER(kind->check)(&lights[i]))
            return GLINT_ERR_ARG;
        if (GLINT_FLASH_POINTER(kind->several)) {
            several = GLINT_FLASH_POINTER(kind->several);
            are_several = true;
        }
    }
    if (are_several && !(several && glint_paint_is_exact(paint)))
        return GLINT_ERR_ARG;
    if (!glint_unit_q30(v_q30, to_viewer))
        return GLINT_ERR_VECTOR;
    const enum glint_err err = are_several ? GLINT_FLASH_POINTER(several->light)(paint, lights, count, v_q30)
                                           : paint_light_one(paint, count ? lights : NULL, v_q30);
    if (!err)
        paint->light_count = (uint8_t)count;
    return err;
}

/* ---- Runs ---- */

/* Step 3a of one light. */
static __attribute__((noinline)) uint32_t paint_scale(uint32_t color, uint32_t x)
{
    return (uint32_t)(((uint64_t)color * x + 32768) >> 16);
}

/* Alone, for the stack of what finds F. */
__attribute__((noinline)) void glint_paint_sums(const struct glint_paint *paint, const struct glint_run *run,
                                                unsigned i, uint32_t nl, uint32_t f)
{
    const bool apart = paint->of.exact.high != 0; /* of a white light channels are the same */
    struct glint_sample sums[3];
    sums[0].nl_q16 = nl;
    sums[0].f_q16 = f;
    for (unsigned k = 0; apart && k < 3; k++) {
        sums[k].nl_q16 = paint_scale(paint->color_q16[k], nl);
        sums[k].f_q16 = paint_scale(paint->color_q16[k], f);
    }
    glint_run_exact(paint, run, i, sums, apart);
}

void glint_paint_exactly(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                         const struct glint_sample *sample)
{
    glint_paint_sums(paint, run, i, sample->nl_q16, glint_paint_f(paint, sample->t_q30));
}

void glint_paint_run(const struct glint_paint *paint, const struct glint_run *run, struct glint_sample *samples,
                     unsigned count)
{
    GLINT_FLASH_POINTER(paint->model->run)(paint, samples, count);
    uint32_t open = glint_run_levels(paint, run, samples, count);
    for (unsigned i = 0; open; i++, open >>= 1) /* the pixels that the bound leaves open */
        if (open & 1)
            glint_paint_exactly(paint, run, i, samples + i);
}

/* ---- Directional lights ---- */

/* Of a direction of length 1 the sizes sum to at most sqrt(3); more, made by hand, would not fit the loops' N.L. */
static enum glint_err light_check(const struct glint_light *light)
{
    uint32_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t x = light->direction_q30[i];
        const uint32_t size = x < 0 ? 0 - (uint32_t)x : (uint32_t)x;
        if (size > GLINT_T_ONE + 16)
            return GLINT_ERR_ARG;
        sum += size; /* < 2^32 */
    }
    return sum && sum <= UINT32_C(1859775394) + 64 ? GLINT_OK : GLINT_ERR_ARG;
}

static const struct glint_light_kind light_directional GLINT_FLASH = {false, NULL, light_check, NULL, NULL, NULL, NULL};

enum glint_err glint_light_directional(struct glint_light *light, const int32_t to_light[3])
{
    if (!light || !to_light)
        return GLINT_ERR_ARG;
    if (!glint_unit_q30(light->direction_q30, to_light))
        return GLINT_ERR_VECTOR;
    light->kind = &light_directional;
    light->color_q16[0] = light->color_q16[1] = light->color_q16[2] = 65536;
    return GLINT_OK;
}

bool glint_light_half(struct glint_vec *h, const int32_t l_q30[3], const int32_t v_q30[3])
{
    int32_t half[3];
    if (!glint_half_q30(half, l_q30, v_q30))
        return false;
    (void)glint_unit_q30(half, half); /* it is not 0 */
    return glint_vec_of_q30(h, half, 0);
}

/* ---- Steps ---- */

/* What a paint draws without highlight is of N.L alone. Where the ends of a step of N.L, and so all of it, are one pixel the table has
 * this, elsewhere, at one step in eight, 0. The next step's first value is one of the ends: that is what N.L just below it is rounded to. */
enum glint_err glint_paint_steps_for(struct glint_paint *paint, const struct glint_use_format *format, void *memory,
                                     size_t bytes)
{
    uint16_t *const steps = (uint16_t *)memory;
    struct glint_run run = {NULL, 0, 0, 0, NULL, NULL, NULL, 0, NULL, NULL};
    if (!paint || !paint->format || paint->several || !format || !memory || GLINT_MISALIGNED(memory, 16) ||
        bytes < GLINT_STEPS_BYTES)
        return GLINT_ERR_ARG;
    if (!glint_format_is_565(paint->output.format) || paint->output.dither ||
        !GLINT_FLASH_POINTER(format->draws)(&paint->output))
        return GLINT_ERR_FORMAT;
    paint->of.exact.steps = steps;
    run.format = paint->format;
    for (uint32_t i = 0; i <= 65536 >> GLINT_STEPS_LOG; i++) {
        uint8_t ends[2][2];
        struct glint_sample samples[2] = {{UINT32_MAX, i << GLINT_STEPS_LOG, 0}, {UINT32_MAX, 0, 0}};
        samples[1].nl_q16 = samples[0].nl_q16 + (i << GLINT_STEPS_LOG < 65536 ? 1u << GLINT_STEPS_LOG : 0);
        run.line = ends[0];
        steps[i] = 0; /* not the pixels of a table before */
        if (i < 65536 >> GLINT_STEPS_LOG)
            steps[i + 1] = 0;
        const uint32_t open = glint_run_levels(paint, &run, samples, 2);
        for (unsigned k = 0; k < 2; k++)
            if (open >> k & 1)
                glint_paint_sums(paint, &run, k, samples[k].nl_q16, 0);
        const bool one = ends[0][0] == ends[1][0] && ends[0][1] == ends[1][1];
        steps[i] = (uint16_t)(one ? ends[0][0] | (unsigned)ends[0][1] << 8 : 0);
    }
    paint->format = format;
    return GLINT_OK;
}
