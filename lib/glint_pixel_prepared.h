/* SPDX-License-Identifier: MIT
 * The exact pixel, quickly; not for users.
 *
 * Once a shader, material, albedo and the format's largest level fold to P, Q and R a channel, scaled such that a level is the
 * upper bits of V = P + Q nl + R F in 32 bits. All are rounded down and F may be low, so V is low, by at most W, which is known
 * then. Where V and V + W have the same upper bits the level is decided; elsewhere, for one pixel in 200 of RGB565, the
 * 64-bit sequence draws it. */
#ifndef GLINT_PIXEL_PREPARED_H
#define GLINT_PIXEL_PREPARED_H

#include "glint_lobe_near.h"
#include "glint_math_flash.h"

/* Up to GLINT_RUN pixels side by side. */
struct glint_run {
    uint8_t *line;         /* the surface's line */
    uint32_t x;            /* in it, of the first sample */
    uint32_t left, y;      /* on the screen, of the line's first pixel */
    const uint8_t *albedo; /* of the first sample, RGB888; NULL: the material's */
    const uint8_t *gloss;  /* of the first sample; NULL: 255 */
    const uint8_t *mask;   /* of the line's first pixel: alpha; NULL: 255 */
};

struct glint_line_loop;

/* glint_shade_rgb565 and so on: const, one a kind of pixel. */
struct glint_shade_format {
    bool (*draws)(const struct glint_shader *shader);
    void (*fold)(struct glint_prepared *prepared); /* the format's own from the shader */
    /* Stores the samples' pixels; not those that stay open: their bits, the first sample's the lowest. */
    uint32_t (*levels)(const struct glint_prepared *prepared, const struct glint_run *run,
                       const struct glint_sample *samples, unsigned count);
    /* Stores sample i of the run by the 64-bit sequence; F exact and held to the peak. */
    void (*exact)(const struct glint_shader *shader, const struct glint_run *run, unsigned i, uint32_t nl_q16,
                  uint32_t f_q16);
    /* Prepares lines in one loop, over an albedo map or not; false where the shader has none. NULL: there is none. */
    bool (*begin)(struct glint_line_loop *loop, const struct glint_prepared *prepared, bool albedo);
};

/* Fills for a model and a format that suit the shader. */
void glint_prepared_fill(struct glint_prepared *prepared, const struct glint_shader *shader,
                         const struct glint_shade_model *model, const struct glint_shade_format *format);

/* Steps 3 to 8 for samples whose t and nl are there, count 1..GLINT_RUN. The pixels are those of sequence.md. */
void glint_prepared_run(const struct glint_prepared *prepared, const struct glint_run *run,
                        struct glint_sample *samples, unsigned count);

/* The same for sample i of the run, whose t and nl are those of *sample, by the 64-bit sequence. Inline: it would take stack. */
static inline void glint_prepared_exact(const struct glint_prepared *prepared, const struct glint_run *run, unsigned i,
                                        const struct glint_sample *sample)
{
    const struct glint_near *near = &prepared->near;
    const uint32_t f =
        sample->t_q30 < near->t_end ? GLINT_FLASH_POINTER(prepared->model->exact)(near->n, sample->t_q30) : 0;
    GLINT_FLASH_POINTER(prepared->format->exact)
    (&prepared->shader, run, i, sample->nl_q16, f < near->f_max ? f : near->f_max);
}

/* N.L fits 32 bits where |lx| + |ly| + |lz| < 2^16, as it is for every light of length 1. */
static inline bool glint_light_is_wide(const struct glint_light *light)
{
    const int32_t x = light->l.x, y = light->l.y, z = light->l.z;
    return (x < 0 ? -x : x) + (y < 0 ? -y : y) + (z < 0 ? -z : z) > 65535;
}

/* Step 2: nl_q30 of 32 bits. */
static inline uint32_t glint_sample_nl(int32_t nl_q30)
{
    const int32_t nl = ((nl_q30 >> 13) + 1) >> 1; /* (nl_q30 + 2^13) >> 14, which might overflow */
    return nl < 0 ? 0 : nl > 65536 ? 65536 : (uint32_t)nl;
}

#endif
