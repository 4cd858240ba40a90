/* SPDX-License-Identifier: MIT
 * For Eva: lights and lamps of any direction and place, over what is said of directions, which eva_vectors.c and test_words show: parts
 * of glint_unit_near end at 2^30 + 4 and those of glint_unit_front at 2^30 + 8; square and shift are those of its words.
 * eva: -eva-precision 3 -eva-slevel 60 -eva-split-return auto -eva-use-spec glint_unit_q30,glint_unit_near,glint_unit_front */
#include "eva.h"
#include "eva_directions.h"
#include "glint_lamp.h"
#include "glint_math_unit.h"

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

enum glint_err eva_light_init(void)
{
    const int32_t l[3] = {any_signed, any_signed, any_signed}, v[3] = {any_signed, any_signed, any_signed};
    struct glint_light light;
    return glint_light_init(&light, l, v);
}

enum glint_err eva_lamp_directional(void)
{
    const int32_t l[3] = {any_signed, any_signed, any_signed}, v[3] = {any_signed, any_signed, any_signed};
    struct glint_lamp lamp;
    return glint_lamp_directional(&lamp, l, v);
}

static int32_t within(int32_t most)
{
    const int32_t v = any_signed;
    return v > most ? most : v < -most ? -most : v;
}

enum glint_err eva_lamp_spot(void)
{
    const int32_t far = GLINT_LAMP_FAR, at[3] = {within(far), within(far), within(far)},
                  to[3] = {within(far), within(far), within(far)};
    struct glint_lamp lamp;
    return glint_lamp_spot(&lamp, at, to, any, any_signed, any_signed);
}

/* Places that are refused. */
enum glint_err eva_lamp_spot_far(void)
{
    const int32_t place[3] = {any_signed, any_signed, any_signed},
                  far[3] = {GLINT_LAMP_FAR + 1, any_signed, any_signed};
    struct glint_lamp lamp;
    const enum glint_err err = glint_lamp_spot(&lamp, place, far, any, any_signed, any_signed);
    return err + glint_lamp_spot(&lamp, far, place, any, any_signed, any_signed);
}

static void reaches(uint8_t kind, int32_t outer)
{
    const int32_t far = GLINT_LAMP_FAR, one = GLINT_T_ONE, inner = within(one);
    const struct glint_lamp lamp = {kind,
                                    {any, any, any},
                                    any_light(),
                                    {within(far), within(far), within(far)},
                                    1 + any % GLINT_LAMP_FAR,
                                    {within(one + 64), within(one + 64), within(one + 64)},
                                    inner < outer ? outer : inner,
                                    outer};
    static struct glint_reach reach;
    struct glint_light light;
    const struct glint_sight sight = {{within(one), within(one), within(one)},
                                      {within(3 * far), within(3 * far), within(3 * far)}};
    glint_reach_init(&reach, &lamp);
    (void)glint_reach_near(&reach, &lamp, &sight, &light);
    (void)glint_reach_exact(&reach, &lamp, &sight, &light);
}
void eva_reach_point(void)
{
    reaches(GLINT_POINT, 0);
}
void eva_reach_spot(void)
{
    reaches(GLINT_SPOT, within(GLINT_T_ONE));
}
