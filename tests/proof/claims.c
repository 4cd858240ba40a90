/* SPDX-License-Identifier: MIT
 * Claims about the library's functions, for all values: test_claims compiles them with all of lib/ and runs each with words that are not known
 * (bits.py). Beside what is shown here, no sum overflows, no shift is by too much and no divisor is 0 in what is run.
 *
 * What a claim needs is also left out: then it must not hold. A function may be taken for what is said of it, which stands beside the
 * name of who shows that. */
#include <stdbool.h>
#include <stdint.h>

/* Any word. */
extern uint64_t any_u64(void);
extern uint32_t any_u32(void);
extern uint16_t any_u16(void);
extern int32_t any_i32(void);
extern int16_t any_i16(void);
/* What is so by what a function asks of its callers, or by mathematics; what the claim needs of that; what it claims. */
extern void given(bool holds);
extern void needed(bool holds);
extern void show(bool holds);
/* From here on a call of one is a call of the other. */
extern void instead_of(void (*function)(void), void (*other)(void));
#define INSTEAD_OF(function, other) instead_of((void (*)(void))(function), (void (*)(void))(other))
#define CLAIM(name) void claim_##name(void)

static uint32_t claim_size(int32_t x)
{
    return x < 0 ? 0 - (uint32_t)x : (uint32_t)x;
}

/* ---- Directions ---- */

CLAIM(half_of_a_sum_fits_and_is_rounded_down)
{
    const int32_t l = any_i32(), v = any_i32(), half = glint_half_sum(l, v);
    show(half == ((int64_t)l + v) >> 1);
}

/* A quotient of a size by a length that is no less: 1 and no rest, or its digits up to here, at most claim_most, and twice a rest. */
static uint32_t claim_most;
static unsigned claim_digits;

static bool claim_quotient_is_kept(uint32_t part, uint32_t size, uint32_t length)
{
    return ((size == 0) & (part <= claim_most + 1)) |
           ((size < 2 * length) & (part <= claim_most)); /* one path, not four */
}

CLAIM(from_digit_to_digit_a_quotient_of_at_most_1_stays_so)
{
    uint32_t part = any_u32(), size = any_u32();
    const uint32_t length = any_u32();
    given(0 < length && length < (uint32_t)1 << 31);
    claim_most = any_u32();
    given(claim_most < (uint32_t)1 << 29);
    needed(claim_quotient_is_kept(part, size, length));
    vector_digit(&part, &size, length);
    claim_most = 2 * claim_most + 1;
    show(claim_quotient_is_kept(part, size, length));
}

static void claim_digit(uint32_t *part, uint32_t *size, uint32_t length)
{
    if (claim_digits++ == 0) {
        show(*part == 0 && *size <= length); /* a_first_digit_is_that_of_a_quotient_of_at_most_1 */
    } else {
        show(claim_quotient_is_kept(*part, *size, length));
        claim_most = 2 * claim_most + 1;
    }
    *part = any_u32();
    *size = any_u32();
    given(claim_quotient_is_kept(*part, *size, length)); /* the claim above */
}

CLAIM(a_part_of_a_length_is_at_most_2_30)
{
    const uint32_t size = any_u32(), length = any_u32();
    INSTEAD_OF(vector_digit, claim_digit);
    claim_most = claim_digits = 0;
    given(0 < length && length < (uint32_t)1 << 31);
    needed(size <= length);
    show(vector_part(size, length) <= (uint32_t)1 << 30);
}

CLAIM(a_first_digit_is_that_of_a_quotient_of_at_most_1)
{
    uint32_t part = 0, size = any_u32();
    const uint32_t length = any_u32();
    given(0 < length && length < (uint32_t)1 << 31);
    needed(size <= length);
    vector_digit(&part, &size, length);
    claim_most = 0;
    show(claim_quotient_is_kept(part, size, length));
}

CLAIM(a_root_keeps_a_rest_of_at_most_twice_itself)
{
    uint32_t root = any_u32(), rest = any_u32();
    const uint32_t two = any_u32();
    given(root < (uint32_t)1 << 29 && two < 4);
    needed(rest <= 2 * root);
    root_digit(&root, &rest, two);
    show(rest <= 2 * root && root < (uint32_t)1 << 30);
}

/* Of squares that sum: no less than any of those; claim_places has the sizes. */
static int32_t *claim_places;

static uint32_t claim_root(uint64_t sum)
{
    const uint32_t length = any_u32();
    (void)sum;
    given(length < (uint32_t)1 << 31);
    for (int i = 0; i < 3; i++) {
        show(claim_size(claim_places[i]) <= (uint32_t)1 << 30);
        given(claim_size(claim_places[i]) <= length);
    }
    return length;
}

static uint32_t claim_part(uint32_t size, uint32_t length)
{
    const uint32_t part = any_u32();
    show(size <= length && length < (uint32_t)1 << 31);
    given(part <= (uint32_t)1 << 30); /* a_part_of_a_length_is_at_most_2_30 */
    return part;
}

CLAIM(a_direction_is_made_of_sizes_up_to_2_30)
{
    const int32_t v[3] = {any_i32(), any_i32(), any_i32()};
    int32_t out[3];
    claim_places = out;
    INSTEAD_OF(glint_root, claim_root);
    INSTEAD_OF(vector_part, claim_part);
    if (glint_unit_q30(out, v))
        for (int i = 0; i < 3; i++)
            show(claim_size(out[i]) <= (uint32_t)1 << 30);
    else
        show(v[0] == 0 && v[1] == 0 && v[2] == 0);
}

/* Quick directions: what glint_unit_near makes of three sizes. */
static struct {
    uint32_t size[3], mantissa, inverse;
    unsigned count, parts;
    bool is_small;
} claim_near;

static void claim_square(struct unit_squares *squares, uint32_t size)
{
    show(size < (uint32_t)1 << 30);
    claim_near.size[claim_near.count++] = size;
    squares->ones++;
}

static uint32_t claim_mantissa(const struct unit_squares *sum, bool *small)
{
    show(sum->ones == 3 && sum->mixed == 0 && sum->rests == 0); /* of three sizes */
    claim_near.is_small = any_u32() & 1;
    claim_near.mantissa = any_u32();
    *small = claim_near.is_small;
    return claim_near.mantissa;
}

static uint32_t claim_inverse(uint32_t a)
{
    show(a == claim_near.mantissa);
    claim_near.inverse = any_u32();
    return claim_near.inverse;
}

static int32_t claim_unit_part(int32_t v, uint32_t size, uint32_t r)
{
    (void)v;
    show(size == claim_near.size[claim_near.parts++]);
    show(r == (claim_near.is_small ? claim_near.inverse : claim_near.inverse >> 1));
    return any_i32();
}

CLAIM(a_quick_direction_is_made_of_sizes_of_2_29_up_to_2_30)
{
    const int32_t v[3] = {any_i32(), any_i32(), any_i32()};
    struct glint_unit unit;
    INSTEAD_OF(unit_square, claim_square);
    INSTEAD_OF(unit_mantissa, claim_mantissa);
    INSTEAD_OF(unit_inverse, claim_inverse);
    INSTEAD_OF(unit_part, claim_unit_part);
    claim_near.count = claim_near.parts = 0;
    if (!glint_unit_near(&unit, v))
        return;
    show(unit.up < 30 && claim_near.count == 3 && claim_near.parts == 3);
    show((claim_near.size[0] | claim_near.size[1] | claim_near.size[2]) >> 29 == 1);
    for (int i = 0; i < 3; i++)
        show(claim_near.size[i] >> unit.up == claim_size(v[i]) && claim_near.size[i] == claim_size(v[i]) << unit.up);
    show(unit.square == claim_near.mantissa);
    show(unit.exponent + 2 * (int32_t)unit.up == (claim_near.is_small ? 28 : 30));
}

/* ---- Lamps ---- */

/* For test_directions. */
static uint32_t claim_falloff(uint32_t square, uint32_t range_inverse, int32_t shift)
{
    const struct glint_unit e = {.square = square, .exponent = 0};
    const struct glint_reach reach = {.range_inverse = range_inverse, .range_exponent = (int8_t)(shift - 1)};
    return place_falloff_near(&reach, &e);
}
