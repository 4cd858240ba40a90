/* SPDX-License-Identifier: MIT
 * The exact rectangle under several lights, in runs of pixels. Each lamp fills samples as one light does, and adds what it sends
 * to the run's sums. Those are samples of their own, whose F is low by more: the format's loop decides their levels. Pixels that
 * this leaves open are summed again with exact F, and drawn by the 64-bit sequence. */
#include "glint_lights.h"
#include "glint_lights_apart.h"
#include "glint_lights_fold.h"
#include "glint_math_vector.h"
#include "glint_pixel.h"

/* Draws pixel i of the run, whose sums are the first ones, by the 64-bit sequence; channel by channel, to keep the stack low. */
static GLINT_LIGHTS_ALONE void lights_store(const struct glint_lights *lights, unsigned i)
{
    static const uint8_t luma[3] GLINT_FLASH = {GLINT_LUMA_RED, GLINT_LUMA_GREEN, GLINT_LUMA_BLUE};
    const struct glint_shader *shader = &lights->prepared->shader;
    const struct glint_run *run = &lights->run;
    const uint8_t *albedo = run->albedo ? run->albedo + 3 * i : shader->material.albedo;
    const uint32_t gloss = (run->gloss ? run->gloss[i] : 255) * 257u;
    const uint32_t weight = glint_exact_weight(shader, run->left + run->x + i, run->y);
    const bool grey = glint_format_is_grey(shader->format);
    const struct glint_sample *sum = lights->slots;
    uint64_t parts = 0;
    uint8_t levels[4];
    for (int k = 0; k < 3; k++, sum += lights->prepared->apart) {
        const uint64_t v = glint_pixel_value(shader, k, albedo[k], sum->nl_q16, (uint64_t)gloss * sum->f_q16);
        parts = grey ? parts + v * GLINT_FLASH_U8(luma[k]) : v << 8;
        levels[k] = glint_pixel_level(shader, parts >> 8, k, weight);
    }
    levels[0] = levels[grey ? 2 : 0];
    glint_exact_store(shader->format, run->line, run->x + i, levels);
    glint_exact_alpha(shader->format, run->line, run->x + i, 1, run->mask);
}

/* Do formats take the run's sums? Not where nl is 0 and F is not, as under one light. */
static GLINT_LIGHTS_ALONE bool lights_fit(const struct glint_lights *lights, unsigned count)
{
    const uint32_t most = lights->most, most_f = most + (most >> 5);
    uint32_t over = 0; /* its upper bit; sums are < 2^31 */
    for (unsigned k = 0; k < lights->channels; k++) {
        const struct glint_sample *sum = lights->slots + k * lights->length;
        for (const struct glint_sample *end = sum + count; sum != end; sum++) {
            over |= (most - sum->nl_q16) | (most_f - sum->f_q16);
            if (sum->nl_q16 == 0 && !sum->t_q30)
                return false;
        }
    }
    return !(over >> 31);
}

/* A lone coloured lamp's channels are apart in exact sums only: else it is folded. */
static inline void lights_part(struct glint_lights *lights, bool exact)
{
    if (lights->prepared->high) {
        lights->channels = exact ? 3 : 1;
        lights->length = exact ? GLINT_LIGHTS_SLOTS / 3 : GLINT_LIGHTS_SLOTS;
    }
}

/* Notes which of the run's pixels shine, from `from` on. False where one does not, but might with exact F. */
static GLINT_LIGHTS_ALONE bool lights_note(struct glint_lights *lights, unsigned from, unsigned count)
{
    const uint8_t *gloss = lights->run.gloss;
    bool sure = true;
    for (unsigned i = 0; i < count; i++) {
        const struct glint_sample *sum = lights->slots + i;
        uint32_t f = 0, none = UINT32_MAX;
        for (unsigned k = 0; k < lights->channels; k++, sum += lights->length) {
            f |= sum->f_q16;
            none &= sum->t_q30;
        }
        sure = sure && (f || none);
        if (f && (!gloss || gloss[from + i])) /* now: gloss may be the output */
            lights->shines |= (uint32_t)1 << (from + i);
    }
    return sure;
}

/* The sums of pixels from the run's pixel `from` on, with F or what the model's loop has of it; exact ones of a single pixel. */
static inline __attribute__((always_inline)) void lights_sum(struct glint_lights *lights, unsigned from, unsigned count,
                                                             bool exact)
{
    const struct glint_prepared *p = lights->prepared;
    const struct glint_near *near = &p->near;
    struct glint_sample *const samples = lights->slots + (lights->count > 1 ? lights->channels * lights->length : 0);
    for (unsigned at = 0; at < lights->count; at++) {
        glint_lights_sample(lights, at, from, count, samples);
        if (!exact) {
            GLINT_FLASH_POINTER(p->model->run)(near, samples, count);
        } else {
            const uint32_t f =
                samples->t_q30 < near->t_end ? GLINT_FLASH_POINTER(p->model->exact)(near->n, samples->t_q30) : 0;
            samples->f_q16 = f < near->f_max ? f : near->f_max;
        }
        glint_lights_add(lights, at, count, samples);
    }
}

/* Draws a run: all of it, then each pixel that this leaves open. */
static inline __attribute__((always_inline)) void lights_draw(struct glint_lights *lights, unsigned count)
{
    const struct glint_prepared *p = lights->prepared;
    uint32_t open = ((uint32_t)1 << count) - 1;
    unsigned i = 0, end = count;
    lights->shines = 0;
    for (bool exact = false;; exact = true) {
        lights_part(lights, exact);
        lights_sum(lights, i, end - i, exact);
        const bool sure = !lights->boxed || lights_note(lights, i, end - i);
        if (exact) {
            lights_store(lights, i);
            open &= ~((uint32_t)1 << i);
        } else if (sure && lights_fit(lights, count)) {
            open = lights->channels > 1 && p->shader.space == GLINT_GAMMA
                       ? glint_apart_levels(p, &lights->run, lights->slots, count)
                       : GLINT_FLASH_POINTER(p->format->levels)(p, &lights->run, lights->slots, count);
        }
        if (!open)
            break;
        for (i = 0; !(open >> i & 1);)
            i++;
        end = i + 1;
    }
    lights_part(lights, false);
}

static bool lights_is_white(const struct glint_lamp *lamp)
{
    const uint32_t red = glint_lights_color(lamp, 0);
    return glint_lights_color(lamp, 1) == red && glint_lights_color(lamp, 2) == red;
}

/* The lamps' colours times x, each rounded up to a whole: <= 64 x. */
static uint32_t lights_total(const struct glint_lamp *lamps, unsigned count, uint32_t x)
{
    uint32_t sum = 0;
    for (unsigned i = 0; i < count; i++)
        sum += (uint32_t)(((uint64_t)x * glint_lights_peak(&lamps[i]) + 65535) >> 16);
    return sum;
}

/* Sums may reach so much, <= 2.0: where the lamps do, and V < 2^32 - 2^20 remains. W, <= 2^(shift - 1) at 1.0, grows no more than
 * they, and enough (tests/proof). Linear space has less room. */
static GLINT_LIGHTS_ALONE uint32_t lights_most(struct glint_prepared *p, uint32_t total)
{
    uint32_t most = total < 131072 ? total : 131072;
    if (p->shader.space == GLINT_LINEAR)
        return 65536;
    for (int k = 0; k < 3; k++) { /* P <= 2 ambient and a threshold, Q <= 2 diffuse, with maps, too */
        const uint32_t room = UINT32_C(0xfff00000) - ((uint32_t)1 << p->shift) - 2 * p->ambient[k];
        const uint32_t unit = 2 * p->diffuse[k] + p->r[k] + (p->r[k] >> 5) + 1;
        most = room / unit < most ? room / unit : most;
    }
    if (most <= 65536)
        return 65536; /* for which there always is room */
    p->w += (p->w >> 16) * (most - 65536) + most;
    p->w_maps += (p->w_maps >> 16) * (most - 65536) + most;
    return most;
}

/* What the lamps are for all pixels. */
static GLINT_LIGHTS_ALONE void lights_prepare(struct glint_lights *lights, const struct glint_lamp *lamps,
                                              unsigned count)
{
    struct glint_prepared *const p = lights->prepared;
    const struct glint_vec v = p->shader.light.v;
    const int32_t viewer[3] = {v.x, v.y, v.z};
    const struct glint_sample none = {UINT32_MAX, 0, 0};
    lights->most = lights_most(p, lights_total(lamps, count, 65536));
    lights->lamps = lamps;
    lights->count = (uint8_t)count;
    lights->channels = 1;
    for (unsigned i = 0; i < count; i++) {
        if (!lights_is_white(&lamps[i]))
            lights->channels = 3;
        glint_reach_init(&lights->reach[i], &lamps[i]);
    }
    lights->length = (uint8_t)(GLINT_LIGHTS_SLOTS / (lights->channels + (count > 1)));
    for (unsigned i = 0; i < GLINT_LIGHTS_SLOTS; i++)
        lights->slots[i] = none;                     /* as they stay without lamps */
    if (glint_unit_q30(lights->sight.v_q30, viewer)) /* else no lamp has a place */
        (void)glint_vec_of_q30(&p->shader.light.v, lights->sight.v_q30, 0);
    p->apart = lights->channels == 1 ? 0 : lights->length;
    if (p->apart && p->shader.space == GLINT_LINEAR && glint_format_is_grey(p->shader.format))
        lights->most = 0; /* no loop has channels of their own there: all but the dark is left to the 64 bits */
    lights_part(lights, false);
}

/* Takes the next run of a line: false at its end. */
static GLINT_LIGHTS_ALONE bool lights_next(struct glint_lights *lights, const struct glint_source *source, uint16_t w,
                                           uint16_t y)
{
    struct glint_run *const run = &lights->run;
    const struct glint_line line = glint_line_at(source, y);
    uint32_t x = run->x;
    while (line.mask && x < w && !line.mask[x])
        x++;
    run->x = x;
    if (x >= w)
        return false;
    lights->pixels = (uint8_t)glint_rect_length(line.mask, x, w, lights->length);
    lights->normals = line.normals + x;
    run->albedo = line.albedo ? line.albedo + 3 * x : NULL;
    run->gloss = line.gloss ? line.gloss + x : NULL;
    run->mask = line.mask;
    return true;
}

static void lights_lines(struct glint_lights *lights, const struct glint_source *source, uint16_t w, uint16_t h,
                         const struct glint_surface *surface)
{
    struct glint_run *const run = &lights->run;
    run->left = surface->x;
    for (uint16_t y = 0; y < h; y++) {
        run->line = (uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)y;
        run->y = (uint32_t)surface->y + y;
        for (run->x = 0; lights_next(lights, source, w, y); run->x += lights->pixels) {
            lights_draw(lights, lights->pixels);
            for (uint32_t i = 0; lights->shines >> i; i++)
                if (lights->shines >> i & 1)
                    glint_bounds_add(&lights->bounds, (uint16_t)(run->x + i), y);
        }
    }
}

static GLINT_LIGHTS_ALONE void lights_rect(struct glint_prepared *prepared, const struct glint_lamp *lamps,
                                           unsigned count, const struct glint_source *source, uint16_t w, uint16_t h,
                                           const struct glint_surface *surface, struct glint_box *highlight)
{
    struct glint_lights lights;
    lights.prepared = prepared;
    lights.boxed = highlight != NULL;
    lights.bounds.any = false;
    lights_prepare(&lights, lamps, count);
    lights_lines(&lights, source, w, h, surface);
    glint_bounds_box(&lights.bounds, highlight);
}

enum { LIGHTS_ALONE = 1 };

/* Prepares for sums: GLINT_OK; for one white directional lamp as for its light: LIGHTS_ALONE. Else what is wrong: lamps that have a
 * place need a viewer. */
static GLINT_LIGHTS_ALONE int lights_begin(struct glint_prepared *p, const struct glint_shader *shader,
                                           const struct glint_lamp *lamps, unsigned count)
{
    const enum glint_err err = glint_shade_prepare(p, shader);
    if (err)
        return err;
    if (count > GLINT_LAMPS_MAX || (count && !lamps))
        return GLINT_ERR_ARG;
    const struct glint_vec v = shader->light.v;
    for (unsigned i = 0; i < count; i++) {
        const enum glint_err wrong = glint_lamp_check(&lamps[i]);
        if (wrong)
            return wrong;
        if (lamps[i].kind != GLINT_DIRECTIONAL && !(v.x | v.y | v.z))
            return GLINT_ERR_VECTOR;
    }
    if (count == 1 && lamps->kind == GLINT_DIRECTIONAL && glint_lights_color(lamps, 0) == 65536 &&
        lights_is_white(lamps)) {
        p->shader.light = lamps->light;
        return LIGHTS_ALONE;
    }
    p->slack = (uint16_t)lights_total(lamps, count, p->slack);
    if (count == 1 && p->shader.space == GLINT_GAMMA && !lights_is_white(lamps))
        glint_lights_fold(p, lamps);
    else
        GLINT_FLASH_POINTER(p->format->fold)(p);
    return GLINT_OK;
}

enum glint_err glint_shade_lights(const struct glint_shader *shader, const struct glint_lamp *lamps, unsigned count,
                                  const struct glint_source *source, uint16_t w, uint16_t h,
                                  const struct glint_surface *surface, struct glint_box *highlight)
{
    struct glint_prepared prepared;
    if (!glint_rect_can(source, surface))
        return GLINT_ERR_ARG;
    const int found = lights_begin(&prepared, shader, lamps, count);
    if (found < 0)
        return (enum glint_err)found;
    if (found == LIGHTS_ALONE)
        return glint_shade_prepared_rect(&prepared, source, w, h, surface, highlight);
    lights_rect(&prepared, lamps, count, source, w, h, surface, highlight);
    return GLINT_OK;
}

enum glint_err glint_lights_init(struct glint_lights *lights, struct glint_prepared *prepared,
                                 const struct glint_shader *shader, const struct glint_lamp *lamps, unsigned count)
{
    const int found = lights_begin(prepared, shader, lamps, count);
    if (found < 0)
        return (enum glint_err)found;
    lights->prepared = prepared;
    lights->boxed = false;
    lights_prepare(lights, lamps, count);
    return GLINT_OK;
}

void glint_lights_pixel(struct glint_lights *lights, const struct glint_vec *normal)
{
    lights->normals = normal;
    lights_draw(lights, 1);
}
