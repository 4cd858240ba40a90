/* SPDX-License-Identifier: MIT
 * batch_eval at its edges: counts, alignments, in place, arguments out of range. Its values everywhere: tests/exact. */
#include "unit.h"

#include <stdlib.h>
#include <string.h>

#include "models/batch.h"

enum { MODELS = GLINT_MODEL_COUNT, GUARD = 16, MOST = 70, TABLE = GLINT_C_ONE + 1 }; /* a table pays from TABLE on */
static const uint32_t guard = 0xdeadbeef;

/* All of the range, with both ends and beyond. */
static int32_t some_c(size_t i)
{
    static const int32_t edges[] = {0, 1, -1, 65535, 65536, 65537, INT32_MIN, INT32_MAX, 32896, 65000};
    return i % 3 ? (int32_t)((uint32_t)i * 2654435761u >> 15) : edges[i / 3 % (sizeof edges / sizeof *edges)];
}

static void assert_values(enum glint_model model, uint32_t n, const uint32_t *f_q16, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (f_q16[i] != glint_eval(model, n, some_c(i)))
            fail_msg("model %d, n %u, element %zu of %zu, c %d: %u, not %u", model, n, i, count, some_c(i), f_q16[i],
                     glint_eval(model, n, some_c(i)));
}

/* Input and output from these elements of their arrays on. */
static void check(enum glint_model model, uint32_t n, size_t count, size_t from, size_t to)
{
    int32_t *c_q16 = malloc((count + from + 1) * sizeof *c_q16); /* to its end: a sanitizer sees each read beyond */
    uint32_t *f_q16 = malloc((count + to + GUARD) * sizeof *f_q16);
    assert_non_null(c_q16);
    assert_non_null(f_q16);
    for (size_t i = 0; i < count; i++)
        c_q16[from + 1 + i] = some_c(i);
    for (size_t i = 0; i < count + to + GUARD; i++)
        f_q16[i] = guard;
    batch_eval(model, n, c_q16 + from + 1, f_q16 + to, count);
    assert_values(model, n, f_q16 + to, count);
    for (size_t i = 0; i < to; i++)
        assert_int_equal(f_q16[i], guard);
    for (size_t i = to + count; i < count + to + GUARD; i++)
        assert_int_equal(f_q16[i], guard);
    free(c_q16);
    free(f_q16);
}

static void any_count_and_alignment_writes_its_elements_and_no_other(void **state)
{
    (void)state;
    for (int model = 0; model < MODELS; model++)
        for (size_t count = 0; count <= MOST; count++)
            for (size_t from = 0; from < 8; from++)
                check((enum glint_model)model, 60, count, from, (from * 5 + count) % 8);
}

static void every_model_is_exact_on_both_sides_of_the_table(void **state)
{
    (void)state;
    for (int model = 0; model < MODELS; model++)
        for (size_t count = TABLE - 1; count <= TABLE + 1; count++)
            check((enum glint_model)model, 200, count, 3, 1);
}

static void the_output_may_be_the_input(void **state)
{
    (void)state;
    static const size_t counts[] = {1, 7, 8, 17, 1000, TABLE + 5};
    static union {
        int32_t c_q16[TABLE + 5];
        uint32_t f_q16[TABLE + 5];
    } both;
    for (int model = 0; model < MODELS; model++)
        for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
            for (size_t i = 0; i < counts[k]; i++)
                both.c_q16[i] = some_c(i);
            batch_eval((enum glint_model)model, 10, both.c_q16, both.f_q16, counts[k]);
            assert_values((enum glint_model)model, 10, both.f_q16, counts[k]);
        }
}

static void shininess_out_of_range_is_clamped(void **state)
{
    (void)state;
    static const uint32_t shininess[] = {0, 1, 1000, 1001, UINT32_MAX};
    for (int model = 0; model < MODELS; model++)
        for (size_t k = 0; k < sizeof shininess / sizeof *shininess; k++)
            check((enum glint_model)model, shininess[k], MOST, 0, 0);
}

/* Where F(0) is not 0, as Gauss's and Lyon's for small n: by loops and by tables. */
static void back_facing_cosines_give_0_for_every_model(void **state)
{
    (void)state;
    int32_t *c_q16 = malloc((TABLE + 5) * sizeof *c_q16);
    uint32_t *f_q16 = malloc((TABLE + 5) * sizeof *f_q16);
    assert_non_null(c_q16);
    assert_non_null(f_q16);
    for (size_t i = 0; i < TABLE + 5; i++)
        c_q16[i] = i % 2 ? -1 - (int32_t)i : INT32_MIN + (int32_t)i;
    for (int model = 0; model < MODELS; model++)
        for (size_t count = 17; count <= TABLE + 5; count += TABLE + 5 - 17) {
            memset(f_q16, 1, count * sizeof *f_q16);
            batch_eval((enum glint_model)model, 1, c_q16, f_q16, count);
            for (size_t i = 0; i < count; i++)
                assert_int_equal(f_q16[i], 0);
        }
    free(c_q16);
    free(f_q16);
}

static void an_unknown_model_gives_0(void **state)
{
    (void)state;
    uint32_t *f_q16 = malloc(TABLE * sizeof *f_q16);
    int32_t *c_q16 = malloc(TABLE * sizeof *c_q16);
    assert_non_null(f_q16);
    assert_non_null(c_q16);
    for (size_t i = 0; i < TABLE; i++)
        c_q16[i] = GLINT_C_ONE;
    for (size_t count = 9; count <= TABLE; count += TABLE - 9) {
        memset(f_q16, 1, count * sizeof *f_q16);
        batch_eval((enum glint_model)MODELS, 60, c_q16, f_q16, count);
        for (size_t i = 0; i < count; i++)
            assert_int_equal(f_q16[i], 0);
    }
    free(f_q16);
    free(c_q16);
}

/* Each loop by itself, in place: batch_eval calls only the first. */
static void every_loop_takes_any_count_in_place(void **state)
{
    (void)state;
    union {
        int32_t c_q16[MOST];
        uint32_t f_q16[MOST];
    } both;
    for (size_t k = 0; k < batch_loops_count; k++)
        for (size_t count = 0; batch_loops[k].runs() && count < MOST; count++) {
            static const enum glint_model of[] = {GLINT_MSH, GLINT_SCHLICK, GLINT_GGX};
            batch_loop *const loops[] = {batch_loops[k].msh, batch_loops[k].schlick, batch_loops[k].ggx};
            for (size_t j = 0; j < sizeof of / sizeof *of; j++) {
                for (size_t i = 0; i < MOST; i++)
                    both.c_q16[i] = some_c(i);
                const int32_t beyond = both.c_q16[count];
                loops[j](1, both.c_q16, both.f_q16, count);
                assert_values(of[j], 1, both.f_q16, count);
                assert_int_equal(both.c_q16[count], beyond);
            }
        }
    assert_true(batch_loops[batch_loops_count - 1].runs());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_count_and_alignment_writes_its_elements_and_no_other),
        cmocka_unit_test(every_model_is_exact_on_both_sides_of_the_table),
        cmocka_unit_test(the_output_may_be_the_input),
        cmocka_unit_test(shininess_out_of_range_is_clamped),
        cmocka_unit_test(back_facing_cosines_give_0_for_every_model),
        cmocka_unit_test(an_unknown_model_gives_0),
        cmocka_unit_test(every_loop_takes_any_count_in_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
