/* SPDX-License-Identifier: MIT
 * Exhaustive: the host's batch loops against the library: every c_q16, every n, every loop that runs here. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#include "models/batch.h"

enum { CODES = GLINT_C_ONE + 1, ALL = CODES * (int)GLINT_N_MAX }; /* an odd number: rounds and a remainder */

static long count_wrong(batch_loop *loop, uint32_t (*exact)(uint32_t n, int32_t c_q16), uint32_t from_n)
{
    static int32_t c_q16[CODES];
    for (int32_t c = 0; c < CODES; c++)
        c_q16[c] = c;
    long wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
    for (uint32_t n = from_n; n <= GLINT_N_MAX; n++) {
        uint32_t f_q16[CODES];
        loop(n, c_q16, f_q16, CODES);
        for (int32_t c = 0; c < CODES; c++)
            wrong += f_q16[c] != exact(n, c);
    }
    return wrong;
}

static void every_loop_gives_the_librarys_value_for_every_cosine_and_shininess(void **state)
{
    (void)state;
    for (size_t i = 0; i < batch_loops_count; i++) {
        const struct batch_loops *loops = &batch_loops[i];
        if (!loops->runs()) {
            printf("# %s: not on this processor\n", loops->name);
            continue;
        }
        const long msh = count_wrong(loops->msh, glint_msh, 1), schlick = count_wrong(loops->schlick, glint_schlick, 1);
        const long cayley = count_wrong(loops->cayley, glint_cayley, 5), lyon = count_wrong(loops->lyon, glint_lyon, 1);
        const long ggx = count_wrong(loops->ggx, glint_ggx, 1);
        const long power = loops->power ? count_wrong(loops->power, glint_blinn, 1) : 0;
        printf("# %s: msh %ld, schlick %ld, cayley %ld, lyon %ld, ggx %ld, power %ld wrong of %d\n", loops->name, msh,
               schlick, cayley, lyon, ggx, power, ALL);
        assert_int_equal(msh + schlick + cayley + lyon + ggx + power, 0);
    }
}

/* An entry that tells its place, and is never 0. */
static void every_lookup_takes_the_cosines_entry_and_is_0_below_it(void **state)
{
    (void)state;
    static uint32_t table[CODES], f_q16[CODES + 2];
    static int32_t c_q16[CODES + 2];
    for (int32_t c = 0; c < CODES; c++)
        table[c] = (uint32_t)c * 3 + 1;
    for (int32_t i = 0; i < CODES + 2; i++)
        c_q16[i] = i - 1; /* -1 .. 65537 */
    for (size_t k = 0; k < batch_loops_count; k++) {
        if (!batch_loops[k].runs())
            continue;
        batch_loops[k].lookup(table, c_q16, f_q16, CODES + 2);
        assert_int_equal(f_q16[0], 0); /* back-facing */
        assert_int_equal(f_q16[CODES + 1], table[CODES - 1]);
        assert_memory_equal(f_q16 + 1, table, sizeof table);
    }
}

/* The comparison can fail. */
static void another_models_values_count_as_wrong(void **state)
{
    (void)state;
    assert_true(count_wrong(batch_loops[batch_loops_count - 1].msh, glint_schlick, 1) > ALL / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_loop_gives_the_librarys_value_for_every_cosine_and_shininess),
        cmocka_unit_test(every_lookup_takes_the_cosines_entry_and_is_0_below_it),
        cmocka_unit_test(another_models_values_count_as_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
