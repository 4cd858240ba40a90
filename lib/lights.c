/* SPDX-License-Identifier: MIT
 * The exact paint under several lights, or under one that has a place, in runs of pixels. Each light fills samples as one light does, and
 * adds what it sends to the run's sums. Those are samples of their own, whose F is low by more: the format's loop decides their levels.
 * Pixels that this leaves open are summed again with exact F, and drawn by the 64-bit sequence. */
#include "glint_grain.h"
#include "glint_lights.h"
#include "glint_pixel.h"
#include "glint_math_vector.h"

/* So that what two functions hold is not on the stack together. */
#define LIGHTS_ALONE __attribute__((noinline)) static

/* ---- What a light adds ---- */

/* (color att x + 2^31) >> 32; color <= 2^20, att <= 2^16, x <= 67109. Where att x = 2^16 p1 + p0 fits 32 bits, color = 2^16 high + low:
 * s = floor(low att x / 2^16) fits, too, and high p0 < 2^20. */
static inline uint32_t lights_scale(uint32_t color, uint32_t att, uint32_t x)
{
#if GLINT_WIDE
    const uint64_t both = (uint64_t)color * att;
    uint64_t sum = (uint64_t)((uint32_t)(both >> 32) * x) << 32 | (uint32_t)1 << 31;
    sum += (uint64_t)(uint32_t)both * x;
    return (uint32_t)(sum >> 32);
#else
    if (x >> 16)
        return (uint32_t)(((uint64_t)color * att * x + ((uint64_t)1 << 31)) >> 32);
    const uint32_t p = att * x, p1 = p >> 16, p0 = p & 0xffff, high = color >> 16, low = color & 0xffff;
    if (color == 65536)
        return p1 + (p0 >> 15);
    const uint32_t s = low * p1 + (low * p0 >> 16);
    return high * p1 + (s >> 16) + ((high * p0 + (s & 0xffff) + 32768) >> 16);
#endif
}

static bool lights_has_place(const struct glint_light *light)
{
    return GLINT_FLASH_POINTER(light->kind->several) != NULL;
}

/* Steps 1 and 2 under light number `at` for pixels from the run's pixel `from` on. */
LIGHTS_ALONE void lights_sample(struct glint_lights *lights, unsigned at, unsigned from, unsigned count,
                                struct glint_sample *sample)
{
    const struct glint_light *light = &lights->paint->lights[at];
    const struct glint_vec *normal = lights->normals + from;
    glint_geometry *const geometry = lights->geometry;
    uint16_t *arriving = lights->arriving;
    struct glint_view *const view = &lights->view;
    view->v = lights->v;
    if (!lights_has_place(light)) {
        view->v = lights->paint->v;
        (void)glint_vec_of_q30(&view->l, light->direction_q30, 0);
        view->h = lights->paint->of.exact.halves[at];
        geometry(&view->l, &view->v, &view->h, normal, sample, count);
        while (count--)
            *arriving++ = UINT16_MAX;
        return;
    }
    struct glint_sight *const sight = &lights->sight;
    const int32_t *position = light->position;
    sight->e[0] = position[0] - 16 * (int32_t)(lights->run->left + lights->run->x + from) - 8;
    sight->e[1] = 16 * (int32_t)lights->run->y + 8 - position[1];
    sight->e[2] = position[2];
    glint_light_front *const front = GLINT_WIDE && lights->is_front && geometry == glint_samples_half
                                         ? GLINT_FLASH_POINTER(light->kind->front)
                                         : NULL;
    for (unsigned i = from; i < from + count; i++, sample++, normal++) {
        if (GLINT_WIDE && front) {
            const unsigned open = front(lights, at, i, from + count, sample, arriving);
            sample += open - i;
            arriving += open - i;
            normal += open - i;
            i = open;
            if (i == from + count)
                break;
        }
        if (lights->places) {
            sight->e[0] = position[0] - lights->places[i][0];
            sight->e[1] = lights->places[i][1] - position[1];
            sight->e[2] = position[2] - lights->places[i][2];
        }
        uint32_t att = GLINT_FLASH_POINTER(light->kind->near)(&lights->reach[at], light, sight, view);
        if (att == GLINT_REACH_OPEN)
            att = GLINT_FLASH_POINTER(light->kind->exact)(light, sight, view);
        *arriving++ = (uint16_t)(att - 1);
        sight->e[0] -= 16;
        if (att) {
            geometry(&view->l, &view->v, &view->h, normal, sample, 1);
        } else {
            sample->t_q30 = sample->f_q16 = UINT32_MAX;
            sample->nl_q16 = 0;
        }
    }
}

/* What of a sample the light sends to a channel: of its color, as far as t_end. */
static inline struct glint_sample lights_send(const struct glint_sample *sample, uint32_t color, uint32_t att,
                                              uint32_t t_end)
{
    struct glint_sample part = {UINT32_MAX, 0, 0};
    const uint32_t nl = sample->nl_q16, f = sample->f_q16;
    if (nl) {
        part.t_q30 = sample->t_q30 < t_end ? 0 : UINT32_MAX;
        part.nl_q16 = lights_scale(color, att, nl);
        if (GLINT_WIDE || f)
            part.f_q16 = lights_scale(color, att, f);
    }
    return part;
}

/* Adds what light number `at` sends to the sums; the first light's are the sums. The last channel first: red's sums may be the samples. */
LIGHTS_ALONE void lights_add(struct glint_lights *lights, unsigned at, unsigned count,
                             const struct glint_sample *samples)
{
    for (unsigned k = lights->channels; k-- > 0;) {
        const uint32_t color = lights->is_folded ? 65536 : glint_light_color(&lights->paint->lights[at], k);
        const uint32_t t_end = color ? lights->paint->of.exact.t_end : 0;
        const uint16_t *arriving = lights->arriving;
        struct glint_sample *sum = lights->slots + k * lights->length;
        const struct glint_sample *sample = samples, *const end = sum + count;
        if (at == 0) {
            for (; sum != end; sum++)
                *sum = lights_send(sample++, color, *arriving++ + UINT32_C(1), t_end);
            continue;
        }
        for (; sum != end; sum++) {
            const struct glint_sample part = lights_send(sample++, color, *arriving++ + UINT32_C(1), t_end);
            sum->t_q30 &= part.t_q30;
            sum->nl_q16 += part.nl_q16;
            sum->f_q16 += part.f_q16;
        }
    }
}

/* ---- A run ---- */

/* The sums of pixels from the run's pixel `from` on, with F as the model's loop has it, a little low; exact ones of a single pixel. */
LIGHTS_ALONE void lights_sum(struct glint_lights *lights, unsigned from, unsigned count, bool exact, bool is_one)
{
    const struct glint_paint *p = lights->paint;
    struct glint_sample *const samples = lights->slots + (p->light_count > 1 ? lights->channels * lights->length : 0);
    for (unsigned at = 0; at < p->light_count; at++) {
        lights_sample(lights, at, from, count, samples);
        if (lights->shade)
            lights->shade(lights, samples, count, exact);
        else if (exact)
            samples->f_q16 = glint_paint_f(p, samples->t_q30);
        else
            GLINT_FLASH_POINTER(p->model->run)(p, samples, count);
        if (!is_one)
            lights_add(lights, at, count, samples);
    }
}

/* Notes which of the run's pixels shine, from `from` on. False where one does not, but might with exact F. */
LIGHTS_ALONE bool lights_note(struct glint_lights *lights, unsigned from, unsigned count)
{
    const uint8_t *gloss = lights->run->gloss;
    bool sure = true;
    for (unsigned i = 0; i < count; i++) {
        const struct glint_sample *sum = lights->slots + i;
        uint32_t f = 0, none = UINT32_MAX;
        for (unsigned k = 0; k < lights->channels; k++, sum += lights->length) {
            f |= sum->f_q16;
            none &= sum->t_q30;
        }
        if (lights->is_folded) { /* of a colour below 1.0 F may round to 0, and 1 may come of rounding twice */
            f = (uint32_t)(((uint64_t)glint_paint_peak(lights->paint) * f + 32768) >> 16);
            sure = sure && (f > 1 || none);
        }
        sure = sure && (f || none);
        if (f && (!gloss || gloss[from + i])) /* now: gloss may be the output */
            lights->shines |= (uint32_t)1 << (from + i);
    }
    return sure;
}

/* Brings the sums to what the format folded for. Does it take them? Where nl comes to 0 it was, and F is, as under one light. */
LIGHTS_ALONE bool lights_fit(struct glint_lights *lights, unsigned count)
{
    const struct glint_paint *p = lights->paint;
    const unsigned nl_down = p->of.exact.nl_down, f_down = p->of.exact.f_down;
    const uint32_t most = p->of.exact.most, most_f = most + (most >> 5);
    uint32_t over = 0; /* its upper bit; sums are < 2^31 */
    for (unsigned k = 0; k < lights->channels; k++) {
        struct glint_sample *sum = lights->slots + k * lights->length;
        for (const struct glint_sample *end = sum + count; sum != end; sum++) {
            const uint32_t nl = sum->nl_q16 >> nl_down;
            if (nl == 0 && (sum->nl_q16 || !sum->t_q30))
                return false;
            sum->nl_q16 = nl;
            sum->f_q16 >>= f_down;
            over |= (most - sum->nl_q16) | (most_f - sum->f_q16);
        }
    }
    return !(over >> 31);
}

#if GLINT_WIDE
/* lights_add and lights_fit of one light whose channels are the same, where no box is asked for: nobody reads t then. */
LIGHTS_ALONE bool lights_fit_one(struct glint_lights *lights, unsigned count)
{
    const struct glint_paint *p = lights->paint;
    const unsigned nl_down = p->of.exact.nl_down, f_down = p->of.exact.f_down;
    const uint32_t most = p->of.exact.most, most_f = most + (most >> 5);
    const uint32_t color = lights->is_folded ? 65536 : glint_light_color(p->lights, 0);
    const uint16_t *arriving = lights->arriving;
    uint32_t over = 0; /* its upper bit */
    struct glint_sample *sum = lights->slots;
    for (const struct glint_sample *end = sum + count; sum != end; sum++) {
        const uint32_t att = *arriving++ + UINT32_C(1), lit = lights_scale(color, att, sum->nl_q16),
                       nl = lit >> nl_down;
        if (nl == 0) {
            if (lit || (sum->nl_q16 && sum->t_q30 < p->of.exact.t_end))
                return false;
            sum->nl_q16 = sum->f_q16 = 0;
            continue;
        }
        sum->nl_q16 = nl;
        sum->f_q16 = lights_scale(color, att, sum->f_q16) >> f_down;
        over |= (most - sum->nl_q16) | (most_f - sum->f_q16);
    }
    return !(over >> 31);
}
#else
#define lights_fit_one lights_fit /* which is not asked */
#endif

/* The channels of one coloured light, which is folded, are apart in exact sums only. */
static inline void lights_part(struct glint_lights *lights, bool exact)
{
    if (lights->paint->of.exact.high) {
        lights->is_folded = !exact;
        lights->channels = exact ? 3 : 1;
        lights->length = (uint8_t)(GLINT_LIGHTS_SLOTS / lights->channels);
        lights->run->apart = exact ? lights->length : 0;
    }
}

/* Draws a run: all of it, then each pixel that this leaves open. */
static void lights_run(struct glint_lights *lights, unsigned count)
{
    const struct glint_paint *p = lights->paint;
    uint32_t open = ((uint32_t)1 << count) - 1;
    unsigned i = 0, end = count;
    lights->shines = 0;
    for (bool exact = false;; exact = true) {
        lights_part(lights, exact);
        const bool is_one = GLINT_WIDE && !exact && !lights->is_boxed && p->light_count == 1 && lights->channels == 1;
        lights_sum(lights, i, end - i, exact, is_one);
        const bool sure = !lights->is_boxed || lights_note(lights, i, end - i);
        if (exact) {
            glint_run_exact(p, lights->run, i, lights->slots, lights->run->apart);
            glint_store_alpha(p->output.format, lights->run->line, lights->run->x + i, 1, lights->run->coverage);
            open &= ~((uint32_t)1 << i);
        } else if (is_one ? lights_fit_one(lights, count) : sure && lights_fit(lights, count)) {
            open = lights->channels > 1 && p->output.space == GLINT_GAMMA && lights->run->format == p->format
                       ? glint_levels_apart(p, lights->run, lights->slots, count)
                       : glint_run_levels(p, lights->run, lights->slots, count);
        }
        if (!open)
            break;
        for (i = 0; !(open >> i & 1);)
            i++;
        end = i + 1;
    }
    lights_part(lights, false);
}

static bool lights_are_white(const struct glint_light *lights, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        for (unsigned k = 1; k < 3; k++)
            if (glint_light_color(&lights[i], k) != glint_light_color(&lights[i], 0))
                return false;
    return true;
}

static void lights_begin(struct glint_lights *lights, const struct glint_paint *paint, bool is_boxed)
{
    const int32_t viewer[3] = {paint->v.x, paint->v.y, paint->v.z};
    lights->paint = paint;
    lights->is_boxed = is_boxed;
    lights->channels = lights_are_white(paint->lights, paint->light_count) ? 1 : 3;
    lights->length = (uint8_t)(GLINT_LIGHTS_SLOTS / (lights->channels + (paint->light_count > 1)));
    lights->run->apart = glint_lights_apart(lights);
    lights->is_folded = false;
    lights_part(lights, false);
    lights->places = NULL;
    lights->shade = NULL;
    glint_geometry *const own = GLINT_FLASH_POINTER(paint->model->geometry);
    lights->geometry = own ? own : glint_samples_half;
    (void)glint_unit_q30(lights->sight.v_q30, viewer);
    lights->is_front = GLINT_WIDE && !(viewer[0] | viewer[1]) && viewer[2] > 0;
    lights->v = paint->v;
    for (unsigned i = 0; i < paint->light_count; i++)
        if (lights_has_place(&paint->lights[i])) {
            (void)glint_vec_of_q30(&lights->v, lights->sight.v_q30, 0);
            GLINT_FLASH_POINTER(paint->lights[i].kind->begin)(&lights->reach[i], &paint->lights[i]);
        }
}

LIGHTS_ALONE void lights_draw(const struct glint_paint *paint, struct glint_lines *lines, struct glint_span *at,
                              uint32_t h, struct glint_box *highlight)
{
    struct glint_lights lights;
    struct glint_vec unpacked[GLINT_LIGHTS_SLOTS];
    struct glint_bounds bounds;
    (void)at; /* there is none */
    glint_bounds_begin(&bounds);
    lights.run = &lines->run;
    lights_begin(&lights, paint, highlight != NULL);
    const struct glint_use_grain *grain = GLINT_FLASH_POINTER(paint->model->grain);
    if (grain)
        GLINT_FLASH_POINTER(grain->light)(&lights, lines);
    lines->most = lights.length;
    for (uint32_t y = 0; y < h; y++) {
        for (glint_lines_set(lines, y); glint_lines_next(lines); lines->run.x += lines->count) {
            lights.normals = glint_lines_normals(lines, unpacked);
            lights_run(&lights, lines->count);
            for (uint32_t i = 0; lights.shines >> i; i++)
                if (lights.shines >> i & 1)
                    glint_bounds_add(&bounds, lines->run.x + i, y);
        }
    }
    glint_bounds_box(&bounds, highlight);
}

/* ---- A paint is lit ---- */

/* The lights' colours times x, each rounded up to a whole: <= 64 x. */
static uint32_t lights_total(const struct glint_light *lights, unsigned count, uint32_t x)
{
    uint32_t sum = 0;
    for (unsigned i = 0; i < count; i++)
        sum += (uint32_t)(((uint64_t)x * glint_light_peak(&lights[i]) + 65535) >> 16);
    return sum;
}

/* How often a coefficient can be doubled, and sums halved instead: the pixels of a material that is dark under lights that are bright have sums
 * as those of a bright one under dim lights. Sums are left at 1.0 at least. */
static uint8_t lights_down(const uint32_t q16[3], uint32_t total)
{
    uint32_t most = 1;
    for (unsigned k = 0; k < 3; k++)
        most = glint_coefficient(q16[k]) > most ? glint_coefficient(q16[k]) : most;
    unsigned down = 0;
    while (most << (down + 1) <= 65536 && total >> (down + 1) >= 65536)
        down++;
    return (uint8_t)down;
}

/* Sums, shifted down, may reach so much, <= 2.0: where the lights do, and V < 2^32 - 2^20 remains. W, <= 2^(shift - 1) at 1.0, grows no more
 * than they, and enough (tests/proof). Linear space has less room. */
static uint32_t lights_most(struct glint_paint *p, uint32_t total)
{
    uint32_t most = total < 131072 ? total : 131072;
    if (p->output.space == GLINT_LINEAR)
        return 65536;
    for (int k = 0; k < 3; k++) { /* P <= 2 ambient and a threshold, Q <= 2 diffuse, with maps, too */
        const uint32_t room = UINT32_C(0xfff00000) - ((uint32_t)1 << p->of.exact.shift) - 2 * p->of.exact.ambient[k];
        const uint32_t unit = 2 * p->of.exact.diffuse[k] + p->of.exact.r[k] + (p->of.exact.r[k] >> 5) + 1;
        most = room / unit < most ? room / unit : most;
    }
    if (most <= 65536)
        return 65536; /* for which there always is room */
    p->of.exact.w += (p->of.exact.w >> 16) * (most - 65536) + most;
    p->of.exact.w_maps += (p->of.exact.w_maps >> 16) * (most - 65536) + most;
    return most;
}

static enum glint_err lights_light(struct glint_paint *paint, const struct glint_light *lights, unsigned count,
                                   const int32_t v_q30[3])
{
    struct glint_vec halves[GLINT_LIGHTS_MAX];
    for (unsigned i = 0; i < count; i++)
        if (!lights_has_place(&lights[i]) && !glint_light_half(&halves[i], lights[i].direction_q30, v_q30))
            return GLINT_ERR_VECTOR;
    const uint32_t total = lights_total(lights, count, 65536);
    const uint32_t slack = lights_total(lights, count, GLINT_FLASH_U8(paint->model->slack));
    /* One light's colour folds, so that it is as fast as a white one. */
    const bool is_one = count == 1 && total <= 4 * 65536 && !lights_are_white(lights, count);
    unsigned nl_down = 0, f_down = 0;
    if (!is_one) {
        nl_down = lights_down(paint->material.diffuse_q16, total);
        f_down = lights_down(paint->material.specular_q16, total);
    }
    paint->of.exact.nl_down = (uint8_t)nl_down;
    paint->of.exact.f_down = (uint8_t)f_down;
    paint->of.exact.slack = (uint16_t)(is_one   ? GLINT_FLASH_U8(paint->model->slack)
                                       : f_down ? (slack >> f_down) + 2
                                                : slack);
    for (unsigned k = 0; k < 3; k++)
        paint->color_q16[k] = is_one ? glint_light_color(lights, k) : 65536;
    glint_paint_fold(paint, is_one);
    paint->of.exact.most = is_one ? 65536 : lights_most(paint, total >> (nl_down < f_down ? nl_down : f_down));
    for (unsigned i = 0; i < count; i++)
        paint->of.exact.halves[i] = halves[i];
    (void)glint_vec_of_q30(&paint->v, v_q30, 0);
    /* A mesh sets its faces up by these of one light: alike, whatever the memory held. */
    paint->l.x = paint->l.y = paint->l.z = 0;
    paint->h = paint->l;
    paint->several = &glint_use_lights;
    paint->lights = lights;
    return GLINT_OK;
}

const struct glint_use_lights glint_use_lights GLINT_FLASH = {lights_light, lights_draw, lights_begin, lights_run};
