/* SPDX-License-Identifier: MIT
 * glint_shade_lights beside the reference: the same bytes and box for up to four lamps, likely or hostile. GLINT_PIXELS: as
 * cases.h has it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "cases.h"
#include "reference_lights.h"

enum { W = 37, H = 5, LINE = 4 * W + 13, SIZE = (H + 2) * LINE, GUARD = 0xa5, FAR = GLINT_LAMP_FAR };

struct scene {
    struct glint_vec normals[W * H];
    uint8_t albedo[3 * W * H], gloss[W * H], mask[W * H], out[SIZE], expected[SIZE];
};

static int32_t within(uint64_t *seed, int32_t limit)
{
    return (int32_t)BELOW(2 * (uint32_t)limit + 1) - limit;
}

/* A place: a pixel's own, near it, over it, on the viewer's side far away, or at the limits. */
static void place(uint64_t *seed, const struct glint_surface *surface, int32_t at[3])
{
    const int32_t x = 16 * (int32_t)(surface->x + BELOW(W)) + 8, y = 16 * (int32_t)(surface->y + BELOW(H)) + 8;
    const int32_t size = (int32_t)(UINT32_C(2) << BELOW(21));
    at[0] = x;
    at[1] = y;
    at[2] = 0;
    switch (BELOW(6)) {
    case 0:
        break;
    case 1: /* straight above or below */
        at[2] = within(seed, size);
        break;
    case 2:
        for (int i = 0; i < 3; i++)
            at[i] = ONE_IN(2) ? FAR : -FAR;
        break;
    default:
        at[0] += within(seed, size);
        at[1] += within(seed, size);
        at[2] = ONE_IN(4) ? within(seed, size) : (int32_t)BELOW((uint32_t)size + 1);
    }
    for (int i = 0; i < 3; i++)
        at[i] = at[i] > FAR ? FAR : at[i] < -FAR ? -FAR : at[i];
}

static int32_t cosine(uint64_t *seed)
{
    const int32_t one = 1 << 30;
    return ONE_IN(8)   ? (ONE_IN(2) ? one : -one)
           : ONE_IN(2) ? one - (int32_t)BELOW(UINT32_C(1) << BELOW(31))
                       : within(seed, one);
}

static void point_or_spot(uint64_t *seed, struct glint_lamp *lamp, const struct glint_surface *surface)
{
    const uint32_t far = (uint32_t)FAR;
    lamp->kind = (uint8_t)(GLINT_POINT + BELOW(2));
    place(seed, surface, lamp->position);
    lamp->range = 1 + BELOW(ONE_IN(2) ? far : UINT32_C(1) << BELOW(24));
    int32_t target[3];
    place(seed, surface, target);
    int32_t a = cosine(seed), b = ONE_IN(8) ? a : ONE_IN(4) ? a - (int32_t)BELOW(100) : cosine(seed);
    b = b < -(1 << 30) ? -(1 << 30) : b;
    lamp->cos_inner_q30 = a > b ? a : b;
    lamp->cos_outer_q30 = a > b ? b : a;
    struct glint_lamp spot;
    if (glint_lamp_spot(&spot, lamp->position, target, lamp->range, lamp->cos_inner_q30, lamp->cos_outer_q30) ==
        GLINT_OK)
        memcpy(lamp->axis_q30, spot.axis_q30, sizeof spot.axis_q30);
    if (ONE_IN(16)) /* filled by hand */
        for (int i = 0; i < 3; i++)
            lamp->axis_q30[i] = ONE_IN(4) ? INT32_MIN : (int32_t)(BELOW(UINT32_MAX) >> BELOW(8)) * (ONE_IN(2) ? 1 : -1);
}

static struct glint_lamp lamp_of(uint64_t *seed, const struct glint_shader *shader, const struct glint_surface *surface)
{
    static const uint32_t colors[] = {0, 1, 65535, 65536, 65537, 1 << 20, UINT32_MAX, 32768};
    struct glint_lamp lamp;
    memset(&lamp, 0, sizeof lamp);
    lamp.light = shader->light;
    if (ONE_IN(4)) {
        lamp.light.l = case_vector(seed);
        lamp.light.h = case_vector(seed);
    }
    if (BELOW(4))
        point_or_spot(seed, &lamp, surface);
    const bool white = ONE_IN(2);
    const unsigned bits = 14 + BELOW(7);
    for (int k = 0; k < 3; k++) {
        lamp.color_q16[k] = ONE_IN(3) ? colors[BELOW(8)] : BELOW(UINT32_C(1) << bits);
        if (white)
            lamp.color_q16[k] = lamp.color_q16[0];
    }
    return lamp;
}

/* Near the half vector of a lamp at a pixel, so that it shines there. */
static struct glint_vec towards(uint64_t *seed, const struct glint_lamp *lamp, const struct glint_shader *shader,
                                const struct glint_surface *surface, int pixel)
{
    struct glint_light light = lamp->light;
    if (lamp->kind != GLINT_DIRECTIONAL) {
        const struct glint_vec l = case_unit(
            (const double[3]){(double)lamp->position[0] - 16 * (surface->x + pixel % W) - 8,
                              16 * (surface->y + pixel / W) + 8 - (double)lamp->position[1], lamp->position[2]});
        const struct glint_vec v =
            case_unit((const double[3]){shader->light.v.x, shader->light.v.y, shader->light.v.z});
        light.h = case_unit((const double[3]){l.x + v.x, l.y + v.y, l.z + v.z});
    }
    return case_normal(seed, &light, 1 + (int)BELOW(UINT32_C(1) << BELOW(15)));
}

static unsigned lights_case(uint64_t *seed, void *memory)
{
    struct scene *s = memory;
    struct glint_shader sh = case_shader(seed);
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    const unsigned count = ONE_IN(2) ? 1 : BELOW(5);
    const bool up = ONE_IN(4);
    const ptrdiff_t start = (up ? H : 1) * LINE + (ptrdiff_t)BELOW(3), stride = up ? -LINE : LINE - (ptrdiff_t)BELOW(3);
    struct glint_surface surface = {s->out + start, stride, (uint16_t)BELOW(65536), (uint16_t)BELOW(65536)};
    if (BELOW(4))
        surface.x = (uint16_t)BELOW(400), surface.y = (uint16_t)BELOW(400);
    if (sh.light.v.x == 0 && sh.light.v.y == 0 && sh.light.v.z == 0)
        sh.light.v.z = 1;
    for (unsigned i = 0; i < count; i++)
        lamps[i] = lamp_of(seed, &sh, &surface);
    for (int i = 0; i < W * H; i++) {
        s->normals[i] = count ? towards(seed, &lamps[BELOW(count)], &sh, &surface, i) : case_vector(seed);
        s->gloss[i] = (uint8_t)(ONE_IN(2) ? 255 : BELOW(256));
        s->mask[i] = BELOW(5) != 0;
        for (int k = 0; k < 3; k++)
            s->albedo[3 * i + k] = (uint8_t)BELOW(256);
    }
    const uint16_t w = (uint16_t)BELOW(W + 1), h = (uint16_t)BELOW(H + 1);
    struct glint_source source = {s->normals, 6 * W, NULL, 3 * W, NULL, W, NULL, W};
    source.albedo = ONE_IN(2) ? s->albedo : NULL;
    source.gloss = ONE_IN(3) ? s->gloss : NULL;
    source.mask = ONE_IN(3) ? s->mask : NULL;
    memset(s->out, GUARD, SIZE);
    memset(s->expected, GUARD, SIZE);
    struct glint_box box = {0, 0, 0, 0}, expected = {0, 0, 0, 0};
    const bool boxed = ONE_IN(2);
    if (glint_shade_lights(&sh, lamps, count, &source, w, h, &surface, boxed ? &box : NULL))
        return 0;
    surface.pixels = s->expected + start;
    reference_lights(&sh, lamps, count, &source, w, h, &surface, boxed ? &expected : NULL);
    return !memcmp(s->out, s->expected, SIZE) && !memcmp(&box, &expected, sizeof box) ? (unsigned)w * h + 1 : 0;
}

static void several_lights_have_the_reference_pixels_and_box(void **state)
{
    (void)state;
    assert_true(cases_pass(lights_case, sizeof(struct scene), 30));
}

/* The output is the albedo map or the gloss map: read before it is written. */
static unsigned shared_case(uint64_t *seed, void *memory)
{
    struct scene *s = memory;
    struct glint_shader sh = case_shader(seed);
    struct glint_lamp lamps[2];
    struct glint_surface surface = {s->out, 3 * W, (uint16_t)BELOW(400), (uint16_t)BELOW(400)};
    const bool gloss = ONE_IN(2);
    sh.format = gloss ? GLINT_GREY8 : GLINT_RGB888;
    sh.light.v.z |= 1;
    for (int i = 0; i < 2; i++) {
        lamps[i] = lamp_of(seed, &sh, &surface);
        point_or_spot(seed, &lamps[i], &surface);
    }
    for (int i = 0; i < SIZE; i++)
        s->out[i] = s->expected[i] = (uint8_t)(ONE_IN(3) ? 0 : BELOW(256));
    for (int i = 0; i < W * H; i++)
        s->normals[i] = towards(seed, &lamps[BELOW(2)], &sh, &surface, i);
    struct glint_source source = {s->normals, 6 * W, NULL, 3 * W, NULL, 3 * W, NULL, W};
    struct glint_box box, expected;
    source.albedo = gloss ? NULL : s->out;
    source.gloss = gloss ? s->out : NULL;
    if (glint_shade_lights(&sh, lamps, 2, &source, W, H, &surface, &box))
        return 0;
    surface.pixels = s->expected;
    source.albedo = gloss ? NULL : s->expected;
    source.gloss = gloss ? s->expected : NULL;
    reference_lights(&sh, lamps, 2, &source, W, H, &surface, &expected);
    return !memcmp(s->out, s->expected, SIZE) && !memcmp(&box, &expected, sizeof box) ? W * H : 0;
}

static void a_map_may_be_the_output_itself(void **state)
{
    (void)state;
    assert_true(cases_pass(shared_case, sizeof(struct scene), 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(several_lights_have_the_reference_pixels_and_box),
        cmocka_unit_test(a_map_may_be_the_output_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
