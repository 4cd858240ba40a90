/* SPDX-License-Identifier: MIT
 * How much of a lamp reaches a pixel, and from where. In 32 bits all is known but for a few units of 2^-30; where that leaves open
 * to what something is rounded, for one pixel in 200, the sequence follows in 64 bits. */
#include "glint_lamp.h"
#include "glint_math_multiply.h"
#include "glint_math_unit.h"
#include "glint_math_vector.h"

/* lamp_cosine may be so much low or high. */
enum { LAMP_COSINE_LOW = 8, LAMP_COSINE_HIGH = 12 };
/* Those of an axis of length 1 are below 1.74 2^30. */
#define LAMP_AXIS_SUM ((uint32_t)7 << 28)

static uint32_t lamp_inverse(uint64_t x, int8_t *exponent)
{
    *exponent = 0;
    for (; x >> 32; x >>= 1)
        ++*exponent;
    for (; !(x >> 31); x <<= 1)
        --*exponent;
    return (uint32_t)((((uint64_t)1 << 63) - 1) / x);
}

void glint_reach_init(struct glint_reach *reach, const struct glint_lamp *lamp)
{
    reach->blur = 0;
    if (lamp->kind == GLINT_DIRECTIONAL)
        return;
    reach->range_inverse = lamp_inverse((uint64_t)lamp->range * lamp->range, &reach->range_exponent); /* of 1 .. 2^46 */
    const uint32_t width = (uint32_t)lamp->cos_inner_q30 - (uint32_t)lamp->cos_outer_q30;             /* <= 2^31 */
    if (lamp->kind == GLINT_POINT || width <= LAMP_COSINE_LOW + LAMP_COSINE_HIGH)
        return;
    uint32_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t size = lamp->axis_q30[i] < 0 ? 0 - (uint32_t)lamp->axis_q30[i] : (uint32_t)lamp->axis_q30[i];
        if (size > GLINT_T_ONE + 64)
            return;
        sum += size;
    }
    if (sum > LAMP_AXIS_SUM)
        return;
    reach->width_inverse = lamp_inverse(width, &reach->width_exponent);
    /* This product is low by < 4, and so will lamp_cone's be. < 2^31 + 8, as width is more */
    reach->blur = glint_mulhi_near((uint32_t)(LAMP_COSINE_LOW + LAMP_COSINE_HIGH) << -reach->width_exponent,
                                   reach->width_inverse) +
                  4 + 4;
}

/* floor(a 2^16 / b), and what is left, for a < b < 2^63; 32 bits for b <= 2^31. Digit by digit: a call of a division takes
 * more stack. */
static inline uint32_t lamp_divide(uint64_t a, uint64_t b, uint64_t *rest)
{
    uint32_t quotient = 0;
    for (int digit = 0; digit < 16; digit++) {
        a <<= 1;
        quotient <<= 1;
        if (a >= b) {
            a -= b;
            quotient++;
        }
    }
    *rest = a;
    return quotient;
}

/* att of u. Its square is 2^32 only where u = 0. */
static uint32_t lamp_falloff(uint32_t u)
{
    const uint32_t rest = 65536 - u;
    return rest >> 16 ? rest : (rest * rest + 32768) >> 16;
}

/* x = |e|^2 / range^2: u = floor(x 2^16 + 1/2). square and inverse multiply to x 2^30 2^shift 2^32. The square is low by < 1, the
 * inverse by 2^-31 of it or high by as much, and the product's upper half, < 2^32, by < 3 of its own, the shift's floor by 1: together -7 .. 2. */
enum { LAMP_FALLOFF_LOW = 8, LAMP_FALLOFF_HIGH = 3 };

static uint32_t lamp_falloff_near(const struct glint_reach *reach, const struct glint_unit *e)
{
    const int32_t shift = reach->range_exponent - e->exponent + 1;
    if (shift < 0)
        return 0; /* x > 2^30 2^-32 2^2 */
    const uint32_t x = shift > 31 ? 0 : glint_mulhi_near(e->square, reach->range_inverse) >> shift;
    if (x >= GLINT_T_ONE + LAMP_FALLOFF_HIGH)
        return 0;
    const uint32_t low = x + (1u << 13) - LAMP_FALLOFF_HIGH, high = x + (1u << 13) + LAMP_FALLOFF_LOW;
    return (low ^ high) >> 14 ? GLINT_REACH_OPEN : lamp_falloff(low >> 14);
}

/* -l.axis, Q2.30. With l = 2^15 l1 + l0 and the axis likewise, l.axis 2^-30 sums l1 a1, and (l1 a0 + l0 a1) 2^-15, < 2^31 2^-15,
 * of which 2^-2 are summed: all but the cosine's own size, < 2^31, may wrap. l0 a0, < 3, and the last floor are left out: this is
 * high by < 4.1. l is off by GLINT_UNIT_SLACK in each component, l.axis by 1.75 times that, 7; and 0.5 of rounding. */
static int32_t lamp_cosine(const struct glint_lamp *lamp, const int32_t l_q30[3])
{
    uint32_t upper = 0;
    int32_t middle = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t l1 = l_q30[i] >> 15, l0 = l_q30[i] & 0x7fff;
        const int32_t a1 = lamp->axis_q30[i] >> 15, a0 = lamp->axis_q30[i] & 0x7fff;
        upper += (uint32_t)(l1 * a1);
        middle += (l1 * a0 + l0 * a1) >> 2;
    }
    return -(int32_t)(upper + (uint32_t)(middle >> 13));
}

/* The smooth step from the outer cone to the inner, Q16.16, for a cosine from low to high, which differ or are exact. */
static uint32_t lamp_cone(const struct glint_reach *reach, const struct glint_lamp *lamp, int32_t low, int32_t high)
{
    const int32_t inner = lamp->cos_inner_q30, outer = lamp->cos_outer_q30;
    if (low >= inner)
        return 65536;
    if (high <= outer)
        return 0;
    if (low <= outer || high >= inner)
        return GLINT_REACH_OPEN;
    const uint32_t above = (uint32_t)low - (uint32_t)outer; /* < width */
    uint32_t part;                                          /* < 2^16 */
    if (low == high) {
        uint64_t rest;
        part = lamp_divide(above, (uint32_t)inner - (uint32_t)outer, &rest);
    } else {
        part = glint_mulhi_near(above << -reach->width_exponent, reach->width_inverse); /* 2^31 = 1 */
        if ((part ^ (part + reach->blur)) >> 15)
            return GLINT_REACH_OPEN;
        part >>= 15;
    }
    return (uint32_t)(glint_multiply(part * part, 196608 - 2 * part) >> 32);
}

/* att for a spot; only 65536^2 does not fit. */
static uint32_t lamp_scale(uint32_t att, uint32_t cone)
{
    return cone >> 16 ? att : att >> 16 ? cone : (att * cone + 32768) >> 16;
}

/* H of l, which is overwritten; false where it is open. */
static inline bool lamp_half(struct glint_light *light, struct glint_unit *unit, const int32_t v[3])
{
    int32_t *const l = unit->unit_q30;
    int32_t slack = GLINT_UNIT_FRONT;
    if (!(v[0] | v[1]) && v[2] > 0 && l[2] >= 0) {
        glint_unit_front(l, l);
    } else {
        for (int i = 0; i < 3; i++) /* off by up to 2, and far from 0 where up is small; the sum may not fit */
            l[i] = (l[i] & v[i]) + ((l[i] ^ v[i]) >> 1);
        if (!glint_unit_near(unit, l) || unit->up > 8)
            return false;
        slack = GLINT_UNIT_SLACK + (GLINT_UNIT_GROWS * GLINT_UNIT_SLACK / 2 << unit->up);
    }
    return glint_vec_near(&light->h, l, slack);
}

uint32_t glint_reach_near(const struct glint_reach *reach, const struct glint_lamp *lamp,
                          const struct glint_sight *sight, struct glint_light *light)
{
    struct glint_unit unit;
    if (!glint_unit_near(&unit, sight->e))
        return GLINT_REACH_OPEN;
    uint32_t att = lamp_falloff_near(reach, &unit);
    if (att == 0 || att == GLINT_REACH_OPEN)
        return att;
    if (lamp->kind == GLINT_SPOT) {
        if (!reach->blur)
            return GLINT_REACH_OPEN;
        const int32_t c = lamp_cosine(lamp, unit.unit_q30);
        const uint32_t cone = lamp_cone(reach, lamp, c - LAMP_COSINE_HIGH, c + LAMP_COSINE_LOW);
        if (cone == GLINT_REACH_OPEN)
            return cone;
        att = lamp_scale(att, cone);
        if (att == 0)
            return 0;
    }
    if (!glint_vec_near(&light->l, unit.unit_q30, GLINT_UNIT_SLACK))
        return GLINT_REACH_OPEN;
    return lamp_half(light, &unit, sight->v_q30) ? att : GLINT_REACH_OPEN;
}

uint32_t glint_reach_exact(const struct glint_reach *reach, const struct glint_lamp *lamp,
                           const struct glint_sight *sight, struct glint_light *light)
{
    const uint64_t range2 = (uint64_t)lamp->range * lamp->range; /* <= 2^46 */
    uint64_t d2 = 0;                                             /* < 2^50 */
    for (int i = 0; i < 3; i++)
        d2 += (uint64_t)((int64_t)sight->e[i] * sight->e[i]);
    int32_t l[3];
    if (d2 >= range2 || !glint_unit_q30(l, sight->e))
        return 0;
    uint64_t rest;
    const uint32_t u = lamp_divide(d2, range2, &rest);
    uint32_t att = lamp_falloff(u + (2 * rest >= range2));
    if (lamp->kind == GLINT_SPOT) {
        int64_t sum = (int64_t)1 << 29; /* |l| <= 1 + 2^-28, the axis's components any: < 2^63 */
        for (int i = 0; i < 3; i++)
            sum -= (int64_t)l[i] * lamp->axis_q30[i];
        sum >>= 30;
        /* beyond +-1 as far as the cones go */
        const int32_t c = sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : (int32_t)sum;
        att = lamp_scale(att, lamp_cone(reach, lamp, c, c));
    }
    (void)glint_vec_of_q30(&light->l, l, 0);
    if (att == 0 || !glint_half_q30(l, l, sight->v_q30) || !glint_unit_q30(l, l))
        return 0;
    (void)glint_vec_of_q30(&light->h, l, 0);
    return att;
}
