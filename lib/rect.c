/* SPDX-License-Identifier: MIT
 * The exact rectangle: each line in runs of pixels that the mask leaves. */
#include "glint_rect.h"
#include "glint_math_align.h"
#include "glint_pixel_line.h"
#include "glint_pixel_prepared.h"

bool glint_rect_can(const struct glint_source *source, const struct glint_surface *surface)
{
    return source && surface && source->normals && surface->pixels && !GLINT_MISALIGNED(source->normals, 16) &&
           !GLINT_MISALIGNED(source->normals_stride, 16);
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

/* Steps 1 and 2, t by the half vector. In 32 bits N.L fits where |lx| + |ly| + |lz| < 2^16, as for every light of
 * length 1; `wide` is for others. Differences of coordinates are below 2^16, so their squares fit; a sum that does not is a t
 * beyond every lobe, as is any where nl is 0. */
static inline __attribute__((always_inline)) void rect_geometry(const struct glint_light *light,
                                                                const struct glint_vec *normal,
                                                                struct glint_sample *sample, unsigned count, bool wide)
{
    const struct glint_sample *end = sample + count;
    do {
        const int32_t x = normal->x, y = normal->y, z = normal->z;
        int32_t nl;
        if (wide) {
            const int64_t sum = (int64_t)(x * light->l.x) + y * light->l.y + z * light->l.z;
            nl = (int32_t)glint_sample_nl(sum > INT32_MAX ? INT32_MAX : sum < 0 ? 0 : (int32_t)sum);
        } else {
            nl = (((x * light->l.x + y * light->l.y + z * light->l.z) >> 13) + 1) >> 1;
        }
        uint32_t t = UINT32_MAX;
        if (nl <= 0) {
            nl = 0;
        } else {
            const int32_t dx = x - light->h.x, dy = y - light->h.y, dz = z - light->h.z;
            const uint32_t xx = (uint32_t)dx * (uint32_t)dx, yy = (uint32_t)dy * (uint32_t)dy;
            const uint32_t zz = (uint32_t)dz * (uint32_t)dz, xy = xx + yy, sum = xy + zz;
            if (xy >= xx && sum >= zz)
                t = sum >> 1;
            nl = nl < 65536 ? nl : 65536;
        }
        sample->t_q30 = t;
        sample->nl_q16 = (uint32_t)nl;
        normal++;
    } while (++sample != end);
}

void glint_samples_unit(const struct glint_light *light, const struct glint_vec *normals, struct glint_sample *samples,
                        unsigned count)
{
    rect_geometry(light, normals, samples, count, false);
}

void glint_samples_wide(const struct glint_light *light, const struct glint_vec *normals, struct glint_sample *samples,
                        unsigned count)
{
    rect_geometry(light, normals, samples, count, true);
}

/* The samples that are lit go to the bounds. Not inlined, for the stack of what is called beside it. */
static __attribute__((noinline)) void rect_note(struct glint_bounds *bounds, const struct glint_sample *sample,
                                                unsigned count, const struct glint_prepared *prepared,
                                                const struct glint_run *run, uint16_t y)
{
    for (unsigned i = 0; i < count; i++)
        if (sample[i].t_q30 < prepared->near.t_end && (!run->gloss || run->gloss[i]))
            glint_bounds_add(bounds, (uint16_t)(run->x + i), y);
}

/* Samples at a time: fewer than might be, for the stack. */
enum { RECT_RUN = 15 };
typedef char glint_rect_run[RECT_RUN <= GLINT_RUN ? 1 : -1];

unsigned glint_rect_length(const uint8_t *mask, uint32_t x, uint32_t w, unsigned most)
{
    unsigned count = 1;
    if (w - x < most)
        most = (unsigned)(w - x);
    if (!mask)
        return most;
    mask += x;
    while (count < most && mask[count])
        count++;
    return count;
}

/* What a line is drawn with. */
union rect_work {
    struct glint_sample samples[RECT_RUN];
#if GLINT_CORTEX_M0PLUS_ASM
    struct glint_line_loop loop;
#endif
};

#if GLINT_CORTEX_M0PLUS_ASM
/* Can the format draw whole lines? Then the loop is prepared. */
static bool rect_begin(struct glint_line_loop *loop, const struct glint_prepared *prepared,
                       const struct glint_source *source, const struct glint_surface *surface, struct glint_run *run)
{
    const struct glint_shade_format *format = prepared->format;
    if (!GLINT_FLASH_POINTER(format->begin) || source->gloss || GLINT_MISALIGNED(surface->pixels, 16) ||
        GLINT_MISALIGNED(surface->stride, 16) ||
        !GLINT_FLASH_POINTER(format->begin)(loop, prepared, source->albedo != NULL))
        return false;
    run->line = (uint8_t *)&loop->dark; /* the pixel where N.L <= 0 */
    loop->sample.t_q30 = UINT32_MAX;
    loop->sample.nl_q16 = loop->sample.f_q16 = 0;
    if (GLINT_FLASH_POINTER(format->levels)(prepared, run, &loop->sample, 1))
        glint_prepared_exact(prepared, run, 0, &loop->sample);
    return true;
}

/* A line by the loop; pixels that this leaves open by the 64-bit sequence. */
static void rect_line(struct glint_line_loop *loop, const struct glint_prepared *prepared,
                      const struct glint_line *line, struct glint_run *run, uint32_t w, struct glint_bounds *bounds,
                      uint16_t y)
{
    loop->out = run->line;
    loop->w = w;
    loop->mask = line->mask;
    loop->normals = line->normals;
    loop->albedo = line->albedo;
    loop->first = (const uint8_t *)UINTPTR_MAX;
    loop->last = NULL;
    for (uint32_t x = 0; (x = loop->draw(loop, x)) < w; x++) {
        run->x = x;
        run->albedo = line->albedo ? line->albedo + 3 * x : NULL;
        glint_samples_unit(&prepared->shader.light, line->normals + x, &loop->sample, 1);
        glint_prepared_exact(prepared, run, 0, &loop->sample);
    }
    if (loop->last) {
        glint_bounds_add(bounds, (uint16_t)((loop->first - run->line) / 2), y);
        glint_bounds_add(bounds, (uint16_t)((loop->last - run->line) / 2), y);
    }
}
#endif

enum glint_err glint_shade_prepared_rect(const struct glint_prepared *prepared, const struct glint_source *source,
                                         uint16_t w, uint16_t h, const struct glint_surface *surface,
                                         struct glint_box *highlight)
{
    if (!prepared || !glint_rect_can(source, surface))
        return GLINT_ERR_ARG;
    const struct glint_light *light = &prepared->shader.light;
    const bool wide = glint_light_is_wide(light);
    void (*samples_of)(const struct glint_light *light, const struct glint_vec *normals, struct glint_sample *samples,
                       unsigned count) = GLINT_FLASH_POINTER(prepared->model->geometry)
                                             ? GLINT_FLASH_POINTER(prepared->model->geometry)
                                         : wide ? glint_samples_wide
                                                : glint_samples_unit;
    struct glint_bounds bounds;
    bounds.left = bounds.right = bounds.top = bounds.bottom = 0;
    bounds.any = false;
    union rect_work work;
    struct glint_run run = {NULL, 0, surface->x, 0, NULL, NULL, NULL};
#if GLINT_CORTEX_M0PLUS_ASM
    if (rect_begin(&work.loop, prepared, source, surface, &run))
        samples_of = NULL;
#endif
    for (uint16_t y = 0; y < h; y++) {
        const struct glint_line line = glint_line_at(source, y);
        run.line = (uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)y;
        run.y = (uint32_t)surface->y + y;
        run.mask = line.mask;
#if GLINT_CORTEX_M0PLUS_ASM
        if (!samples_of) { /* whole lines */
            rect_line(&work.loop, prepared, &line, &run, w, &bounds, y);
            continue;
        }
#endif
        for (uint32_t x = 0;;) {
            if (line.mask)
                while (x < w && !line.mask[x])
                    x++;
            if (x >= w)
                break;
            const unsigned count = glint_rect_length(line.mask, x, w, RECT_RUN);
            run.x = x;
            run.albedo = line.albedo ? line.albedo + 3 * x : NULL;
            run.gloss = line.gloss ? line.gloss + x : NULL;
            samples_of(light, line.normals + x, work.samples, count);
            if (highlight) /* before gloss is drawn over, where it is the output */
                rect_note(&bounds, work.samples, count, prepared, &run, y);
            glint_prepared_run(prepared, &run, work.samples, count);
            x += count;
        }
    }
    glint_bounds_box(&bounds, highlight);
    return GLINT_OK;
}
