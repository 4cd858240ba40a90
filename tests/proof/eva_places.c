/* SPDX-License-Identifier: MIT
 * For Eva: lights of any direction and place, over what is said of directions, which eva_vectors.c and test_words show: parts
 * of glint_unit_near end at 2^30 + 4 and those of glint_unit_front at 2^30 + 8; square and shift are those of its words.
 * eva: -eva-precision 3 -eva-slevel 60 -eva-split-return auto -eva-domains octagon -eva-octagon-through-calls -eva-use-spec glint_unit_q30,glint_unit_near,glint_unit_front */
#include "eva.h"
#include "eva_directions.h"
#include "glint_lights.h"
#include "glint_math_vector.h"

/*@ assigns *unit, \result \from v[0 .. 2];
    ensures \result == 0 || \result == 1;
    ensures \initialized(&unit->unit_q30[0 .. 2]) && \initialized(&unit->up) && \initialized(&unit->square) && \initialized(&unit->exponent);
    ensures unit->up <= 29 && unit->square >= 0x40000000 && -30 <= unit->exponent <= 30;
    ensures -0x40000008 <= unit->unit_q30[0] <= 0x40000008;
    ensures -0x40000008 <= unit->unit_q30[1] <= 0x40000008;
    ensures -0x40000008 <= unit->unit_q30[2] <= 0x40000008; */
bool glint_unit_near(struct glint_unit *unit, const int32_t v[3]);

/*@ assigns h_q30[0 .. 2] \from l_q30[0 .. 2];
    ensures \initialized(h_q30 + (0 .. 2));
    ensures -0x40000008 <= h_q30[0] <= 0x40000008;
    ensures -0x40000008 <= h_q30[1] <= 0x40000008;
    ensures -0x40000008 <= h_q30[2] <= 0x40000008; */
void glint_unit_front(int32_t h_q30[3], const int32_t l_q30[3]);

enum glint_err eva_vec_normalize(void)
{
    const int32_t v[3] = {any_signed, any_signed, any_signed};
    struct glint_vec out;
    return glint_vec_normalize(&out, v);
}

/* Of any light that glint_light_directional makes, H for any viewer. */
enum glint_err eva_light_directional(void)
{
    const int32_t l[3] = {any_signed, any_signed, any_signed}, v[3] = {any_signed, any_signed, any_signed};
    int32_t v_q30[3];
    struct glint_light light;
    struct glint_vec h;
    const enum glint_err err = glint_light_directional(&light, l);
    if (!err && glint_unit_q30(v_q30, v))
        (void)glint_light_half(&h, light.direction_q30, v_q30);
    return err;
}

enum glint_err eva_light_point(void)
{
    const int32_t at[3] = {any_signed, any_signed, any_signed};
    struct glint_light light;
    return glint_light_point(&light, at, any);
}

static int32_t within(int32_t most)
{
    const int32_t v = any_signed;
    return v > most ? most : v < -most ? -most : v;
}

enum glint_err eva_light_spot(void)
{
    const int32_t far = GLINT_LIGHT_FAR, at[3] = {within(far), within(far), within(far)},
                  to[3] = {within(far), within(far), within(far)};
    struct glint_light light;
    return glint_light_spot(&light, at, to, any, any_signed, any_signed);
}

/* Places that are refused. */
enum glint_err eva_light_spot_far(void)
{
    const int32_t place[3] = {any_signed, any_signed, any_signed},
                  far[3] = {GLINT_LIGHT_FAR + 1, any_signed, any_signed};
    struct glint_light light;
    const enum glint_err err = glint_light_spot(&light, place, far, any, any_signed, any_signed);
    return err + glint_light_spot(&light, far, place, any, any_signed, any_signed);
}

/* A light by hand is checked, whatever its numbers are. */
enum glint_err eva_light_check(void)
{
    static const int32_t ahead[3] = {0, 0, 1}, right[3] = {1, 0, 0};
    struct glint_light made[3];
    if (glint_light_directional(&made[0], ahead) || glint_light_point(&made[1], ahead, 1) ||
        glint_light_spot(&made[2], ahead, right, 1, 1, 0))
        return GLINT_ERR_ARG;
    int sum = 0;
    for (unsigned i = 0; i < 3; i++) {
        const struct glint_light light = any_light(made[i].kind);
        sum += light.kind->check(&light);
    }
    return (enum glint_err)sum;
}

/* What of a light reaches a pixel, its kind as `made` has it. */
static void reaches(const struct glint_light *made, int32_t outer)
{
    const int32_t far = GLINT_LIGHT_FAR, one = GLINT_T_ONE, inner = within(one);
    const struct glint_light light = {made->kind,
                                      {any, any, any},
                                      {within(one + 64), within(one + 64), within(one + 64)},
                                      {within(far), within(far), within(far)},
                                      1 + any % GLINT_LIGHT_FAR,
                                      inner < outer ? outer : inner,
                                      outer};
    static struct glint_reach reach;
    struct glint_view view = any_view();
    const struct glint_sight sight = {{within(one), within(one), within(one)},
                                      {within(3 * far), within(3 * far), within(3 * far)}};
    light.kind->begin(&reach, &light);
    (void)light.kind->near(&reach, &light, &sight, &view);
    (void)light.kind->exact(&light, &sight, &view);
}
void eva_reach_point(void)
{
    static const int32_t at[3] = {0, 0, 1};
    struct glint_light light;
    if (!glint_light_point(&light, at, 1))
        reaches(&light, 0);
}
void eva_reach_spot(void)
{
    static const int32_t at[3] = {0, 0, 1}, to[3] = {1, 0, 0};
    struct glint_light light;
    if (!glint_light_spot(&light, at, to, 1, 1, 0))
        reaches(&light, within(GLINT_T_ONE));
}
