/* SPDX-License-Identifier: MIT
 * The exact paint under up to four lights beside the reference: the same bytes and box for lights that are likely or hostile. GLINT_PIXELS: as
 * cases.h has it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "cases.h"

enum { FAR = GLINT_LIGHT_FAR };

static int32_t within(uint64_t *seed, int32_t limit)
{
    return (int32_t)BELOW(2 * (uint32_t)limit + 1) - limit;
}

/* A place: a pixel's own, near it, over it, on the viewer's side far away, or at the limits. */
static void place(uint64_t *seed, const struct glint_surface *surface, int32_t at[3])
{
    const int32_t x = 16 * (int32_t)(surface->x + BELOW(CASE_W)) + 8,
                  y = 16 * (int32_t)(surface->y + BELOW(CASE_H)) + 8;
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

static void point_or_spot(uint64_t *seed, struct glint_light *light, const struct glint_surface *target)
{
    const uint32_t far = (uint32_t)FAR;
    int32_t position[3], aim[3];
    place(seed, target, position);
    place(seed, target, aim);
    const uint32_t range = 1 + BELOW(ONE_IN(2) ? far : UINT32_C(1) << BELOW(24));
    int32_t a = cosine(seed), b = ONE_IN(8) ? a : ONE_IN(4) ? a - (int32_t)BELOW(100) : cosine(seed);
    b = b < -(1 << 30) ? -(1 << 30) : b;
    if (ONE_IN(2) || glint_light_spot(light, position, aim, range, a > b ? a : b, a > b ? b : a))
        (void)glint_light_point(light, position, range);
    else if (ONE_IN(16)) /* an axis filled by hand */
        for (int i = 0; i < 3; i++)
            light->direction_q30[i] =
                ONE_IN(4) ? INT32_MIN : (int32_t)(BELOW(UINT32_MAX) >> BELOW(8)) * (ONE_IN(2) ? 1 : -1);
}

static struct glint_light light_of(uint64_t *seed, const struct reference *look, const struct glint_surface *target)
{
    struct glint_light light = look->lights[0];
    struct glint_vec lvh[3];
    if (ONE_IN(4)) {
        const int32_t to_light[3] = {within(seed, 100), within(seed, 100), within(seed, 100)};
        struct glint_light other;
        if (!glint_light_directional(&other, to_light) && reference_directions(look, &other, lvh))
            light = other;
    }
    if (BELOW(4))
        point_or_spot(seed, &light, target);
    case_color(seed, &light);
    return light;
}

/* Near the half vector of a light at a pixel, so that it shines there. */
static struct glint_vec towards(uint64_t *seed, const struct glint_light *light, const struct reference *look,
                                const struct glint_surface *target, int pixel)
{
    struct glint_vec lvh[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 32767}};
    if (reference_kind(light) == REFERENCE_DIRECTIONAL) {
        (void)reference_directions(look, light, lvh);
    } else {
        const struct glint_vec l = case_unit(
            (const double[3]){(double)light->position[0] - 16 * (target->x + pixel % CASE_W) - 8,
                              16 * (target->y + pixel / CASE_W) + 8 - (double)light->position[1], light->position[2]});
        const struct glint_vec v =
            case_unit((const double[3]){look->to_viewer[0], look->to_viewer[1], look->to_viewer[2]});
        lvh[2] = case_unit((const double[3]){l.x + v.x, l.y + v.y, l.z + v.z});
    }
    return case_normal(seed, lvh[2], 1 + (int)BELOW(UINT32_C(1) << BELOW(15)));
}

/* Lights, and normals that they make shine. */
static void light_scene(uint64_t *seed, struct case_scene *s, struct reference *look, unsigned count,
                        const struct glint_surface *target)
{
    const struct reference one = *look;
    look->count = count;
    for (unsigned i = 0; i < count; i++)
        look->lights[i] = light_of(seed, &one, target);
    for (int i = 0; i < CASE_W * CASE_H; i++) {
        s->normals[i] = count ? towards(seed, &look->lights[BELOW(count)], look, target, i) : case_vector(seed);
        s->words[i] = ONE_IN(30) ? 0 : glint_normals_pack(GLINT_NORMALS_INT8, &s->normals[i]);
    }
}

static unsigned lights_case(uint64_t *seed, void *memory)
{
    struct case_scene *s = memory;
    struct glint_vec lvh[3];
    struct reference look = case_look(seed, lvh);
    const uint16_t w = (uint16_t)BELOW(CASE_W + 1), h = (uint16_t)BELOW(CASE_H + 1);
    struct glint_surface target = case_target(seed, s);
    if (BELOW(4))
        target.x = (uint16_t)BELOW(400), target.y = (uint16_t)BELOW(400);
    light_scene(seed, s, &look, ONE_IN(2) ? 1 : BELOW(5), &target);
    struct glint_maps maps = case_maps(seed, s, w, h);
    case_grain(seed, s, &look.material, true, &maps);
    const bool is_8 = ONE_IN(4);
    maps.normals = is_8 ? (const void *)s->words : s->normals;
    maps.normals_format = is_8 ? GLINT_NORMALS_INT8 : GLINT_NORMALS_INT16;
    maps.normals_stride = CASE_W * (is_8 ? 4 : 6);
    const struct glint_surface wanted = case_expected(s, &target);
    struct glint_box box = {0, 0, 0, 0}, expected = {0, 0, 0, 0};
    const bool boxed = ONE_IN(2);
    struct glint_paint paint;
    if (case_paint(&paint, &look) || glint_draw_rect(&paint, &maps, w, h, &target, boxed ? &box : NULL))
        return 0;
    reference_rect(&look, &maps, w, h, &wanted, boxed ? &expected : NULL);
    return case_same(s, &box, &expected) ? (unsigned)w * h + 1 : 0;
}

static void several_lights_have_the_reference_pixels_and_box(void **state)
{
    (void)state;
    assert_true(cases_pass(lights_case, sizeof(struct case_scene), 30));
}

/* The output is the albedo map or the gloss map: read before it is written. */
static unsigned shared_case(uint64_t *seed, void *memory)
{
    struct case_scene *s = memory;
    struct glint_vec lvh[3];
    struct reference look = case_look(seed, lvh);
    struct glint_surface target = {s->out, 3 * CASE_W, (uint16_t)BELOW(400), (uint16_t)BELOW(400)};
    const bool gloss = ONE_IN(2);
    look.output.format = gloss ? GLINT_GREY8 : GLINT_RGB888;
    light_scene(seed, s, &look, 1 + BELOW(2), &target);
    for (int i = 0; i < CASE_SIZE; i++)
        s->out[i] = s->expected[i] = (uint8_t)(ONE_IN(4) ? 0 : BELOW(256));
    struct glint_box box, expected;
    struct glint_maps maps = {.normals = s->normals, .normals_stride = 6 * CASE_W, .albedo_format = GLINT_RGB888};
    maps.albedo_stride = maps.gloss_stride = 3 * CASE_W;
    maps.albedo = gloss ? NULL : s->out;
    maps.gloss = gloss ? s->out : NULL;
    struct glint_paint paint;
    if (case_paint(&paint, &look) || glint_draw_rect(&paint, &maps, CASE_W, CASE_H, &target, &box))
        return 0;
    target.pixels = s->expected;
    maps.albedo = gloss ? NULL : s->expected;
    maps.gloss = gloss ? s->expected : NULL;
    reference_rect(&look, &maps, CASE_W, CASE_H, &target, &expected);
    return case_same(s, &box, &expected) ? CASE_W * CASE_H : 0;
}

static void a_map_may_be_the_output_itself(void **state)
{
    (void)state;
    assert_true(cases_pass(shared_case, sizeof(struct case_scene), 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(several_lights_have_the_reference_pixels_and_box),
        cmocka_unit_test(a_map_may_be_the_output_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
