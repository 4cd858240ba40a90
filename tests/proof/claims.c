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

/* ---- Several lights ---- */

CLAIM(coefficients_are_doubled_to_at_most_1_and_sums_halved_to_no_less)
{
    const uint32_t q16[3] = {any_u32(), any_u32(), any_u32()}, total = any_u32();
    const unsigned down = lights_down(q16, total);
    show(down <= 16);
    show(down == 0 || total >> down >= 65536);
    for (int k = 0; k < 3; k++)
        show(glint_coefficient(q16[k]) << down <= 65536);
}

static void claim_lights(struct glint_light lights[GLINT_LIGHTS_MAX])
{
    for (unsigned i = 0; i < GLINT_LIGHTS_MAX; i++)
        for (unsigned k = 0; k < 3; k++)
            lights[i].color_q16[k] = any_u32();
}

CLAIM(lights_sum_to_at_most_64)
{
    struct glint_light lights[GLINT_LIGHTS_MAX];
    claim_lights(lights);
    show(lights_total(lights, GLINT_LIGHTS_MAX, 65536) <= 64 * 65536);
}

CLAIM(a_slack_of_several_lights_fits_in_16_bits)
{
    struct glint_light lights[GLINT_LIGHTS_MAX];
    claim_lights(lights);
    show(lights_total(lights, GLINT_LIGHTS_MAX, UINT8_MAX) <
         UINT16_MAX - 2); /* the largest of a model: a smaller one sums to less */
}

/* A run of claim_count pixels, of which those of claim_open are to be drawn again. */
enum { CLAIM_RUN = 4 };
static uint32_t claim_count, claim_open;

static void claim_lights_sum(struct glint_lights *lights, unsigned from, unsigned count, bool exact, bool is_one)
{
    (void)lights;
    show(!is_one && from + count <= claim_count);
    show(exact ? count == 1 && (claim_open >> from & 1) : from == 0 && count == claim_count);
}

static bool claim_lights_note(struct glint_lights *lights, unsigned from, unsigned count)
{
    (void)lights;
    show(from + count <= claim_count);
    return any_u32() & 1;
}

static bool claim_lights_fit(struct glint_lights *lights, unsigned count)
{
    (void)lights;
    show(count == claim_count);
    return any_u32() & 1;
}

static uint32_t claim_levels(const struct glint_paint *paint, const struct glint_run *run,
                             const struct glint_sample *samples, unsigned count)
{
    (void)paint, (void)run, (void)samples;
    show(count == claim_count);
    claim_open = any_u32();
    given(claim_open >> claim_count == 0);
    return claim_open;
}

static void claim_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                        const struct glint_sample *sums, unsigned apart)
{
    (void)paint, (void)run, (void)sums, (void)apart;
    show(i < claim_count && (claim_open >> i & 1));
    claim_open &= ~((uint32_t)1 << i);
}

static const struct glint_use_format claim_format = {NULL, NULL, claim_levels, claim_exact, NULL};

CLAIM(several_lights_draw_each_pixel_that_is_left_open_once_more_and_no_other)
{
    struct glint_paint paint;
    struct glint_lights lights;
    struct glint_run run;
    INSTEAD_OF(lights_sum, claim_lights_sum);
    INSTEAD_OF(lights_note, claim_lights_note);
    INSTEAD_OF(lights_fit, claim_lights_fit);
    INSTEAD_OF(glint_levels_apart, claim_levels);
    paint.format = run.format = &claim_format;
    paint.light_count = 2;
    paint.output.format = GLINT_RGB565;
    paint.output.space = GLINT_GAMMA;
    paint.of.exact.high = 0;
    run.apart = 0;
    run.line = NULL;
    run.x = 0;
    run.coverage = NULL;
    lights.paint = &paint;
    lights.run = &run;
    lights.is_boxed = any_u32() & 1;
    lights.channels = any_u32() & 1 ? 1 : 3;
    claim_count = any_u32();
    given(1 <= claim_count && claim_count <= CLAIM_RUN);
    claim_open = ((uint32_t)1 << claim_count) - 1;
    lights_run(&lights, claim_count);
    show(claim_open == 0);
}

static void claim_lights_begin(struct glint_lights *lights, const struct glint_paint *paint, bool is_boxed)
{
    (void)paint, (void)is_boxed;
    lights->length = CLAIM_RUN;
}

static void claim_lines_set(struct glint_lines *lines, uint32_t y)
{
    (void)y;
    lines->run.x = 0;
}

/* One run. */
static bool claim_lines_next(struct glint_lines *lines)
{
    lines->count = (uint16_t)claim_count;
    show(lines->most == CLAIM_RUN);
    return lines->run.x == 0;
}

static const struct glint_vec *claim_normals(const struct glint_lines *lines, struct glint_vec *unpacked)
{
    (void)lines;
    return unpacked;
}

static void claim_lights_run(struct glint_lights *lights, unsigned count)
{
    show(count == claim_count);
    claim_open = any_u32();
    given(claim_open >> claim_count == 0);
    lights->shines = claim_open;
}

static void claim_bounds_add(struct glint_bounds *bounds, uint32_t x, uint32_t y)
{
    (void)bounds;
    show(x < claim_count && y == 0 && (claim_open >> x & 1));
    claim_open &= ~((uint32_t)1 << x);
}

CLAIM(what_shines_under_several_lights_is_added_to_the_box_and_nothing_else)
{
    static const struct glint_use_model model = {.grain = NULL};
    struct glint_paint paint;
    struct glint_lines lines;
    struct glint_box box;
    INSTEAD_OF(lights_begin, claim_lights_begin);
    INSTEAD_OF(glint_lines_set, claim_lines_set);
    INSTEAD_OF(glint_lines_next, claim_lines_next);
    INSTEAD_OF(glint_lines_normals, claim_normals);
    INSTEAD_OF(lights_run, claim_lights_run);
    INSTEAD_OF(glint_bounds_add, claim_bounds_add);
    paint.model = &model;
    claim_count = any_u32();
    given(1 <= claim_count && claim_count <= CLAIM_RUN);
    lights_draw(&paint, &lines, NULL, 1, &box);
    show(claim_open == 0);
}

/* ---- Coverage over tables ---- */

/* A line, pixels before and behind it, which nothing is to touch, and coverage of the line alone; what is drawn is any. */
enum { CLAIM_WIDE = GLINT_RUN + 2, CLAIM_GUARD = 0x5a };
static uint8_t claim_line[2 * (1 + CLAIM_WIDE + 1)], claim_coverage[CLAIM_WIDE];

static void claim_table_pixels(uint32_t x, uint32_t end)
{
    show(x < end && end <= CLAIM_WIDE && end - x <= GLINT_RUN); /* what is kept of the line before */
    for (uint8_t *at = claim_line + 2 + 2 * x; at != claim_line + 2 + 2 * end; at++)
        *at = (uint8_t)any_u16();
}

static void claim_table_line(const struct glint_paint *paint, const struct glint_lines *lines, uint32_t x, uint32_t end)
{
    (void)paint, (void)lines;
    claim_table_pixels(x, end);
}

static void claim_table_run(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raws,
                            unsigned count)
{
    (void)paint, (void)raws;
    claim_table_pixels(run->x, run->x + count);
}

static const struct glint_use_tables claim_tables = {.line = claim_table_line, .pixels = claim_table_run};

static uint16_t claim_over(uint32_t p, uint32_t q, uint32_t m)
{
    show(p >> 16 == 0 && q >> 16 == 0 && m < 255);
    return any_u16();
}

static void claim_covered(struct glint_paint *paint, struct glint_run *run, uint8_t format, uint8_t least)
{
    for (unsigned i = 0; i < sizeof claim_line; i++)
        claim_line[i] = i < 2 || i >= sizeof claim_line - 2 ? CLAIM_GUARD : (uint8_t)any_u16();
    for (unsigned i = 0; i < CLAIM_WIDE; i++) {
        claim_coverage[i] = (uint8_t)any_u16();
        given(least <= claim_coverage[i] && claim_coverage[i] < 255);
    }
    INSTEAD_OF(glint_over, claim_over);
    paint->of.tables.filled.use = &claim_tables;
    paint->output.format = format;
    run->line = claim_line + 2;
    run->coverage = claim_coverage;
    run->gloss = NULL;
}

static void show_guards(void)
{
    const uint8_t *const end = claim_line + sizeof claim_line;
    show(claim_line[0] == CLAIM_GUARD && claim_line[1] == CLAIM_GUARD && end[-1] == CLAIM_GUARD &&
         end[-2] == CLAIM_GUARD);
}

CLAIM(a_line_by_tables_is_blended_where_it_lies_in_runs_that_fit)
{
    struct glint_paint paint;
    struct glint_lines lines;
    claim_covered(&paint, &lines.run, GLINT_RGB565, 1);
    lines.run.x = 0;
    lines.count = CLAIM_WIDE;
    coverage_line(&paint, &lines);
    show_guards();
}

CLAIM(a_run_by_tables_is_blended_where_it_lies)
{
    struct glint_paint paint;
    struct glint_run run;
    claim_covered(&paint, &run, GLINT_RGB565_SWAPPED, 0);
    run.x = CLAIM_WIDE - GLINT_RUN;
    coverage_pixels(&run, &paint, NULL, GLINT_RUN);
    show_guards();
}
