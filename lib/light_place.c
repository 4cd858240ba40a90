/* SPDX-License-Identifier: MIT
 * Points and spots: how much of one reaches a pixel, and from where. In 32 bits all is known but for a few units of 2^-30; where that leaves open
 * to what something is rounded, for one pixel in 200, the sequence follows in 64 bits. */
#include "glint_lights.h"
#include "glint_math.h"
#include "glint_math_vector.h"

/* place_cosine may be so much low or high. */
enum { PLACE_COSINE_LOW = 8, PLACE_COSINE_HIGH = 12 };
/* Those of an axis of length 1 are below 1.74 2^30. */
#define PLACE_AXIS_SUM ((uint32_t)7 << 28)

/* a b / 2^32, low by less than 3. */
static inline uint32_t place_multiply(uint32_t a, uint32_t b)
{
#if GLINT_WIDE
    return (uint32_t)((uint64_t)a * b >> 32);
#else
    return glint_mulhi_near(a, b);
#endif
}

static uint32_t place_inverse(uint64_t x, int8_t *exponent)
{
    *exponent = 0;
    for (; x >> 32; x >>= 1)
        ++*exponent;
    for (; !(x >> 31); x <<= 1)
        --*exponent;
    return (uint32_t)((((uint64_t)1 << 63) - 1) / x);
}

static void place_begin(struct glint_reach *reach, const struct glint_light *light)
{
    reach->blur = 0;
    reach->range_inverse =
        place_inverse((uint64_t)light->range * light->range, &reach->range_exponent);       /* of 1 .. 2^46 */
    const uint32_t width = (uint32_t)light->cos_inner_q30 - (uint32_t)light->cos_outer_q30; /* <= 2^31 */
    if (!GLINT_FLASH_U8(light->kind->is_spot) || width == 0)
        return;
    uint32_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t size =
            light->direction_q30[i] < 0 ? 0 - (uint32_t)light->direction_q30[i] : (uint32_t)light->direction_q30[i];
        if (size > GLINT_T_ONE + 64)
            return;
        sum += size;
    }
    if (sum > PLACE_AXIS_SUM)
        return;
    reach->width_inverse = place_inverse(width, &reach->width_exponent);
    /* This product is low by < 4, and so will place_cone's be. Only of a width of more than 21, whose blur is < 2^31 + 8, is there a cosine
     * that is between the cones with all that it may be. */
    reach->blur = place_multiply((uint32_t)(PLACE_COSINE_LOW + PLACE_COSINE_HIGH) << -reach->width_exponent,
                                 reach->width_inverse) +
                  4 + 4;
}

/* floor(a 2^16 / b), and what is left, for a < b < 2^63; 32 bits for b <= 2^31. Digit by digit: a call of a division takes
 * more stack. */
static inline uint32_t place_divide(uint64_t a, uint64_t b, uint64_t *rest)
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
static inline uint32_t place_falloff(uint32_t u)
{
    const uint32_t rest = 65536 - u;
    return rest >> 16 ? rest : (rest * rest + 32768) >> 16;
}

/* x = |e|^2 / range^2: u = floor(x 2^16 + 1/2). square and inverse multiply to x 2^30 2^shift 2^32. The square is low by < 1, the
 * inverse by 2^-31 of it or high by as much, and the product's upper half, < 2^32, by < 3 of its own, the shift's floor by 1: together -7 .. 2. */
enum { PLACE_FALLOFF_LOW = 8, PLACE_FALLOFF_HIGH = 3 };

GLINT_VECTOR_INLINE uint32_t place_falloff_near(const struct glint_reach *reach, const struct glint_unit *e)
{
    const int32_t shift = reach->range_exponent - e->exponent + 1;
    if (shift < 0)
        return 0; /* x > 2^30 2^-32 2^2 */
    const uint32_t x = shift > 31 ? 0 : place_multiply(e->square, reach->range_inverse) >> shift;
    if (x >= GLINT_T_ONE + PLACE_FALLOFF_HIGH)
        return 0;
    const uint32_t low = x + (1u << 13) - PLACE_FALLOFF_HIGH, high = x + (1u << 13) + PLACE_FALLOFF_LOW;
    return (low ^ high) >> 14 ? GLINT_REACH_OPEN : place_falloff(low >> 14);
}

/* -l.axis, Q2.30. With l = 2^15 l1 + l0 and the axis likewise, l.axis 2^-30 sums l1 a1, and (l1 a0 + l0 a1) 2^-15, < 2^31 2^-15,
 * of which 2^-2 are summed: all but the cosine's own size, < 2^31, may wrap. l0 a0, < 3, and the last floor are left out: this is
 * high by < 4.1. l is off by GLINT_UNIT_SLACK in each component, l.axis by 1.75 times that, 7; and 0.5 of rounding. */
static int32_t place_cosine(const struct glint_light *light, const int32_t l_q30[3])
{
    uint32_t upper = 0;
    int32_t middle = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t l1 = l_q30[i] >> 15, l0 = l_q30[i] & 0x7fff;
        const int32_t a1 = light->direction_q30[i] >> 15, a0 = light->direction_q30[i] & 0x7fff;
        upper += (uint32_t)(l1 * a1);
        middle += (l1 * a0 + l0 * a1) >> 2;
    }
    return -(int32_t)(upper + (uint32_t)(middle >> 13));
}

/* att by the smooth step from the outer cone to the inner, for a cosine from low to high, which differ or are exact. */
static uint32_t place_cone(const struct glint_reach *reach, const struct glint_light *light, uint32_t att, int32_t low,
                           int32_t high)
{
    const int32_t inner = light->cos_inner_q30, outer = light->cos_outer_q30;
    if (low >= inner)
        return att;
    if (high <= outer)
        return 0;
    if (low <= outer || high >= inner)
        return GLINT_REACH_OPEN;
    const uint32_t above = (uint32_t)low - (uint32_t)outer; /* < width */
    uint32_t part;                                          /* < 2^16 */
    if (low == high) {
        uint64_t rest;
        part = place_divide(above, (uint32_t)inner - (uint32_t)outer, &rest);
    } else {
        part = place_multiply(above << -reach->width_exponent, reach->width_inverse); /* 2^31 = 1 */
        if ((part ^ (part + reach->blur)) >> 15)
            return GLINT_REACH_OPEN;
        part >>= 15;
    }
    const uint32_t cone = (uint32_t)(glint_multiply(part * part, 196608 - 2 * part) >> 32); /* < 65536 */
    return (att * cone + 32768) >> 16;                                                      /* att <= 65536 */
}

/* H of l, which is overwritten; false where it is open. */
static inline bool place_half(struct glint_view *view, struct glint_unit *unit, const int32_t v[3])
{
    int32_t *const l = unit->unit_q30;
    int32_t slack = GLINT_UNIT_FRONT;
    if (!(v[0] | v[1]) && v[2] == (int32_t)GLINT_T_ONE && l[2] >= 0) {
        glint_unit_front(l, l);
    } else {
        l[0] = glint_half_sum(l[0], v[0]); /* off by up to 2, and far from 0 where up is small */
        l[1] = glint_half_sum(l[1], v[1]);
        l[2] = glint_half_sum(l[2], v[2]);
        if (!glint_unit_near(unit, l) || unit->up > 8)
            return false;
        slack = GLINT_UNIT_SLACK + (GLINT_UNIT_GROWS * GLINT_UNIT_SLACK / 2 << unit->up);
    }
    return glint_vec_near(&view->h, l, slack);
}

static uint32_t place_near(const struct glint_reach *reach, const struct glint_light *light,
                           const struct glint_sight *sight, struct glint_view *view)
{
    struct glint_unit unit;
    if (!glint_unit_near(&unit, sight->e))
        return GLINT_REACH_OPEN;
    uint32_t att = place_falloff_near(reach, &unit);
    if (att == 0 || att == GLINT_REACH_OPEN)
        return att;
    if (GLINT_FLASH_U8(light->kind->is_spot)) {
        if (!reach->blur)
            return GLINT_REACH_OPEN;
        const int32_t c = place_cosine(light, unit.unit_q30);
        att = place_cone(reach, light, att, c - PLACE_COSINE_HIGH, c + PLACE_COSINE_LOW);
        if (att == 0 || att == GLINT_REACH_OPEN)
            return att;
    }
    if (!glint_vec_near(&view->l, unit.unit_q30, GLINT_UNIT_SLACK))
        return GLINT_REACH_OPEN;
    return place_half(view, &unit, sight->v_q30) ? att : GLINT_REACH_OPEN;
}

static uint32_t place_exact(const struct glint_light *light, const struct glint_sight *sight, struct glint_view *view)
{
    const uint64_t range2 = (uint64_t)light->range * light->range; /* <= 2^46 */
    uint64_t d2 = 0;                                               /* < 2^50 */
    for (int i = 0; i < 3; i++)
        d2 += (uint64_t)((int64_t)sight->e[i] * sight->e[i]);
    int32_t l[3];
    if (d2 >= range2 || !glint_unit_q30(l, sight->e))
        return 0;
    uint64_t rest;
    const uint32_t u = place_divide(d2, range2, &rest);
    uint32_t att = place_falloff(u + (2 * rest >= range2));
    if (GLINT_FLASH_U8(light->kind->is_spot)) {
        int64_t sum = (int64_t)1 << 29; /* |l| <= 1 + 2^-28, the axis's components any: < 2^63 */
        for (int i = 0; i < 3; i++)
            sum -= (int64_t)l[i] * light->direction_q30[i];
        sum >>= 30;
        /* beyond +-1 as far as the cones go */
        const int32_t c = sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : (int32_t)sum;
        att = place_cone(NULL, light, att, c, c);
    }
    (void)glint_vec_of_q30(&view->l, l, 0);
    if (att == 0 || !glint_half_q30(l, l, sight->v_q30))
        return 0;
    (void)glint_unit_q30(l, l); /* it is not 0 */
    (void)glint_vec_of_q30(&view->h, l, 0);
    return att;
}

#if GLINT_WIDE

/* ---- A run in one loop ---- */

/* To Q1.15 and open where that might be another: glint_vec_near of a component. */
GLINT_VECTOR_INLINE int32_t place_round(int32_t v, int32_t slack, bool *open)
{
    const int32_t high = v + (1 << 14) + slack;
    *open = *open || (uint32_t)high << 17 < (uint32_t)(2 * slack) << 17;
    return glint_vec_cut(high);
}

static unsigned place_front(struct glint_lights *lights, unsigned at, unsigned from, unsigned end,
                            struct glint_sample *sample, uint16_t *arriving)
{
    const struct glint_reach reach = lights->reach[at];
    const struct glint_vec *normal = lights->normals + from;
    const struct glint_sample *const begin = sample, *const last = sample + (end - from);
    int32_t e[3] = {lights->sight.e[0], lights->sight.e[1], lights->sight.e[2]};
    for (; sample != last; sample++, normal++) {
        struct glint_unit unit;
        bool open = false;
        if (lights->places) {
            const int32_t *position = lights->paint->lights[at].position,
                          *place = lights->places[normal - lights->normals];
            e[0] = position[0] - place[0];
            e[1] = place[1] - position[1];
            e[2] = position[2] - place[2];
        }
        if (!glint_wide_unit(&unit, e))
            break;
        const uint32_t att = place_falloff_near(&reach, &unit);
        if (att == GLINT_REACH_OPEN)
            break;
        uint32_t t = UINT32_MAX;
        int32_t nl = 0;
        if (att) {
            const int32_t x = normal->x, y = normal->y, z = normal->z;
            const int32_t lx = place_round(unit.unit_q30[0], GLINT_UNIT_SLACK, &open),
                          ly = place_round(unit.unit_q30[1], GLINT_UNIT_SLACK, &open),
                          lz = place_round(unit.unit_q30[2], GLINT_UNIT_SLACK, &open);
            if (open)
                break;
            nl = ((x * lx + y * ly + z * lz) >> 13) + 1;
            nl = nl < 2 ? 0 : nl < 2 * 65536 ? nl >> 1 : 65536;
            if (nl) {
                if (unit.unit_q30[2] < 0)
                    break;
                glint_wide_front(unit.unit_q30, unit.unit_q30);
                const int32_t dx = x - place_round(unit.unit_q30[0], GLINT_UNIT_FRONT, &open),
                              dy = y - place_round(unit.unit_q30[1], GLINT_UNIT_FRONT, &open),
                              dz = z - place_round(unit.unit_q30[2], GLINT_UNIT_FRONT, &open);
                if (open)
                    break;
                const uint64_t sum =
                    (uint64_t)((int64_t)dx * dx) + (uint64_t)((int64_t)dy * dy) + (uint64_t)((int64_t)dz * dz);
                t = sum >> 32 ? UINT32_MAX : (uint32_t)sum >> 1;
            }
        }
        sample->t_q30 = t;
        sample->nl_q16 = (uint32_t)nl;
        *arriving++ = (uint16_t)(att - 1);
        e[0] -= 16;
    }
    lights->sight.e[0] = e[0];
    return from + (unsigned)(sample - begin);
}
#define PLACE_FRONT place_front
#else
#define PLACE_FRONT NULL
#endif

/* ---- Set up ---- */

static bool place_is_far(const int32_t place[3])
{
    for (int i = 0; i < 3; i++)
        if (place[i] > GLINT_LIGHT_FAR || place[i] < -GLINT_LIGHT_FAR)
            return true;
    return false;
}

static enum glint_err place_check(const struct glint_light *light)
{
    const int32_t one = (int32_t)GLINT_T_ONE;
    if (place_is_far(light->position) || light->range < 1 || light->range > (uint32_t)GLINT_LIGHT_FAR)
        return GLINT_ERR_ARG;
    if (GLINT_FLASH_U8(light->kind->is_spot) &&
        (light->cos_outer_q30 < -one || light->cos_outer_q30 > light->cos_inner_q30 || light->cos_inner_q30 > one))
        return GLINT_ERR_ARG;
    return GLINT_OK;
}

static const struct glint_light_kind place_point GLINT_FLASH = {false,      &glint_use_lights, place_check, place_begin,
                                                                place_near, place_exact,       PLACE_FRONT};
static const struct glint_light_kind place_spot GLINT_FLASH = {true,       &glint_use_lights, place_check, place_begin,
                                                               place_near, place_exact,       NULL};

static void place_set(struct glint_light *light, const struct glint_light_kind *kind, const int32_t position[3],
                      uint32_t range)
{
    light->kind = kind;
    for (int i = 0; i < 3; i++) {
        light->color_q16[i] = 65536;
        light->position[i] = position[i];
    }
    light->range = range;
}

enum glint_err glint_light_point(struct glint_light *light, const int32_t position[3], uint32_t range)
{
    if (!light || !position)
        return GLINT_ERR_ARG;
    struct glint_light point;
    place_set(&point, &place_point, position, range);
    const enum glint_err err = place_check(&point);
    if (!err)
        *light = point;
    return err;
}

enum glint_err glint_light_spot(struct glint_light *light, const int32_t position[3], const int32_t target[3],
                                uint32_t range, int32_t cos_inner_q30, int32_t cos_outer_q30)
{
    if (!light || !position || !target || place_is_far(target))
        return GLINT_ERR_ARG;
    struct glint_light spot;
    place_set(&spot, &place_spot, position, range);
    spot.cos_inner_q30 = cos_inner_q30;
    spot.cos_outer_q30 = cos_outer_q30;
    const enum glint_err err = place_check(&spot);
    if (err)
        return err;
    const int32_t axis[3] = {target[0] - position[0], position[1] - target[1], target[2] - position[2]};
    if (!glint_unit_q30(spot.direction_q30, axis))
        return GLINT_ERR_VECTOR;
    *light = spot;
    return GLINT_OK;
}
