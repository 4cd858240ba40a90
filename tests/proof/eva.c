/* SPDX-License-Identifier: MIT
 * What Frama-C's Eva runs: each function of the library with every argument that its declaration allows, and those it clamps. */
#include "glint.h"
#include "glint_sample.h"

volatile uint32_t any;
volatile int32_t any_signed;

#define MODEL_own(name)                                                                                                \
    uint32_t eva_##name(void)                                                                                          \
    {                                                                                                                  \
        return glint_##name(any, any_signed);                                                                          \
    }                                                                                                                  \
    uint32_t eva_##name##_t(void)                                                                                      \
    {                                                                                                                  \
        return glint_##name##_t(any, any);                                                                             \
    }                                                                                                                  \
    uint32_t eva_##name##_cutoff(void)                                                                                 \
    {                                                                                                                  \
        return glint_##name##_cutoff(any, any);                                                                        \
    }                                                                                                                  \
    uint32_t eva_##name##_cutoff_t(void)                                                                               \
    {                                                                                                                  \
        return glint_##name##_cutoff_t(any, any);                                                                      \
    }
#define MODEL_shared(name)
#define MODEL(number, name, function, use, grain) MODEL_##use(name)
GLINT_MODELS(MODEL)

static struct glint_vec vector(void)
{
    const struct glint_vec v = {(int16_t)any, (int16_t)any, (int16_t)any};
    return v;
}

/* Of an exact paint, lit or not, by one light or several. */
enum glint_err eva_span_init(void)
{
    struct glint_paint paint;
    const struct glint_vec first = vector(), last = vector();
    struct glint_span span;
    paint.format = &glint_use_rgb565;
    paint.several = any & 1 ? &glint_use_lights : NULL;
    paint.l = vector();
    paint.h = vector();
    paint.light_count = (uint8_t)any;
    return glint_span_init(&span, &paint, &first, &last, (uint16_t)any);
}

uint32_t eva_normals_pack(void)
{
    const struct glint_vec v = vector();
    return glint_normals_pack((enum glint_normals)any, &v);
}

int eva_normals_unpack(void)
{
    const struct glint_vec v = glint_normals_unpack((enum glint_normals)any, any);
    return v.x + v.y + v.z;
}

/* A pixel's place in a map of either format, and of a format that there is not: its bytes lie in the map. */
void eva_normals_window(void)
{
    enum { WIDE = 3, HIGH = 2, MOST = 6 };
    static uint8_t map[MOST * WIDE * HIGH];
    for (unsigned format = 0; format < 3; format++) {
        const size_t size = glint_normals_size((uint8_t)format);
        const uint8_t *const at =
            glint_normals_window((enum glint_normals)format, map, (ptrdiff_t)(size * WIDE), any % WIDE, any % HIGH);
        /*@ assert \valid_read(at + (0 .. size - 1)); */
    }
}

uint8_t eva_shininess_code(void)
{
    return glint_shininess_code(any);
}

uint32_t eva_shininess_n(void)
{
    return glint_shininess_n((uint8_t)any);
}

uint16_t eva_srgb_decode(void)
{
    return glint_srgb_decode((uint8_t)any);
}

uint16_t eva_srgb_encode(void)
{
    return glint_srgb_encode((uint16_t)any);
}

uint32_t eva_lobe_eval(void)
{
    const struct glint_lobe lobe = {(uint8_t)any, (uint8_t)any, (uint16_t)any, any, any};
    return glint_lobe_eval(&lobe, any_signed) + glint_lobe_eval_t(&lobe, any);
}
