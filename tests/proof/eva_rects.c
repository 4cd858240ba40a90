/* SPDX-License-Identifier: MIT
 * For Eva: rectangles and spans of a prepared shader, of any normals, maps, masks, places and spans; runs of pixels as eva_pixels.c
 * has them stand for every kind of pixel and model, so that here it is RGB565 by Lyon.
 * eva: -eva-precision 1 -eva-min-loop-unroll 17 -eva-slevel 20 -eva-use-spec glint_msh_t,glint_schlick_t,glint_blinn_t,glint_gauss_t,glint_cayley_t,glint_lyon_t */
#include "eva.h"
#include "glint_pixel_prepared.h"

enum { WIDE = 17, HIGH = 2 }; /* a run of 15 and one of 2 */
static uint8_t pixels[2 * WIDE * HIGH], albedo[3 * WIDE * HIGH], gloss[WIDE * HIGH], mask[WIDE * HIGH];
static struct glint_vec normals[WIDE * HIGH];
static struct glint_prepared prepared;

static void prepare(void)
{
    const struct glint_shader shader = any_shader(GLINT_RGB565, GLINT_GAMMA, any & 1);
    glint_prepared_fill(&prepared, &shader, &glint_shade_lyon, &glint_shade_rgb565);
}

static void rect(uint16_t w, bool maps, const uint8_t *masked)
{
    prepare();
    ANY_BYTES(normals);
    ANY_BYTES(albedo);
    ANY_BYTES(gloss);
    const struct glint_source source = {
        normals, w * (ptrdiff_t)sizeof *normals, maps ? albedo : NULL, 3 * w, maps ? gloss : NULL, w, masked, w};
    const struct glint_surface surface = {pixels, 2 * w, (uint16_t)any, (uint16_t)any};
    struct glint_box box;
    (void)glint_shade_prepared_rect(&prepared, &source, w, HIGH, &surface, &box);
    (void)glint_shade_prepared_rect(&prepared, &source, w, HIGH, &surface, NULL);
}
void eva_rect(void)
{
    rect(WIDE, false, NULL);
}
void eva_rect_maps(void)
{
    rect(WIDE, true, NULL);
}
/* Every mask of two lines of two pixels. */
void eva_rect_masked(void)
{
    for (unsigned bits = 0; bits < 16; bits++) {
        for (unsigned i = 0; i < 4; i++)
            mask[i] = bits >> i & 1 ? 255 : 0;
        rect(2, true, mask);
    }
}

enum glint_err eva_prepared_span(void)
{
    prepare();
    const struct glint_span span = {any, any, any, any_signed, any_signed, WIDE};
    const struct glint_surface surface = {pixels, 0, (uint16_t)any, (uint16_t)any};
    struct glint_box box;
    return glint_shade_prepared_span(&prepared, &span, &surface, &box);
}

/* Every kind of pixel, as it is one at a time. */
enum glint_err eva_span_c16(void)
{
    static uint8_t wide[4 * WIDE];
    const struct glint_span span = {any, any, any, any_signed, any_signed, WIDE};
    const struct glint_surface surface = {wide, 0, (uint16_t)any, (uint16_t)any};
    struct glint_box box;
    enum glint_err err = GLINT_OK;
    for (uint8_t format = 0; format <= GLINT_FORMAT_COUNT; format++) {
        const struct glint_shader shader = any_shader(format, GLINT_GAMMA, any & 1);
        const struct glint_shader linear = any_shader(format, GLINT_LINEAR, any & 1);
        err = glint_shade_span_c16(&shader, &span, &surface, &box);
        err = glint_shade_span_c16(&linear, &span, &surface, &box);
    }
    return err;
}

/* Any model and format, also those that there are not. */
enum glint_err eva_prepare(void)
{
    const struct glint_shader shader = any_shader((uint8_t)any, (uint8_t)any, any & 1);
    return glint_shade_prepare(&prepared, &shader);
}

uint32_t eva_lobe_eval(void)
{
    const struct glint_lobe lobe = {(uint8_t)any, (uint8_t)any, (uint16_t)any, any, any};
    return glint_lobe_eval(&lobe, any_signed) + glint_lobe_eval_t(&lobe, any);
}
