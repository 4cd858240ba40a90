/* SPDX-License-Identifier: MIT
 * glint search --joint: the bound gives nothing up, ranks and threads change no row, checkpoints go on. */
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "run.h"

#include "base/clock.h"
#include "commands/commands.h"
#include "paper/search_bound.h"
#include "paper/search_joint.h"

static bool is_killed;

/* Takes the place of the host's, which is asked after a checkpoint, too. */
double seconds_now(void)
{
    struct timespec now;
    if (is_killed && access("joint.json", F_OK) == 0)
        raise(SIGKILL);
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static const double few_exponents[] = {-1, 0, 0.5, 1, 2.25, 3}, few_coefficients[] = {0.5, 1, 1.25, 2};
static const double few_n[] = {1, 2, 5, 20, 100, 500, 1000}, falling_n[] = {1000, 500, 100, 20, 5, 2, 1};

static struct search_options reduced(const double *n)
{
    return (struct search_options){.exponents = {few_exponents, 6},
                                   .coefficients = {few_coefficients, 4},
                                   .shininess = {n, 7},
                                   .angles = 31,
                                   .best = 8};
}

static struct search_result search(const struct search_options *options)
{
    const struct ranks alone = {0, 1};
    struct search_result result;
    search_joint(options, &alone, NULL, &result);
    return result;
}

/* ---- against every function, one by one ---- */

static const double *at(const double *values, int i, int power, int count)
{
    for (; power > 0; power--)
        i /= count;
    return &values[i % count];
}

static struct family family_of(int exponents, int coefficients)
{
    const double *b = few_exponents, *a = few_coefficients;
    return (struct family){{*at(b, exponents, 3, 6), *at(b, exponents, 2, 6), *at(b, exponents, 1, 6),
                            *at(b, exponents, 1, 6), *at(b, exponents, 0, 6)},
                           {*at(a, coefficients, 3, 4), *at(a, coefficients, 2, 4), *at(a, coefficients, 1, 4),
                            *at(a, coefficients, 1, 4), *at(a, coefficients, 0, 4)}};
}

static void no_function_is_nearer_than_the_rows_found(void **state)
{
    (void)state;
    const struct search_options options = reduced(few_n);
    struct search_result result = search(&options);
    assert_int_equal(result.count, 8);
    const double last = result.rows[7].deviation;
    size_t nearer = 0;
    for (int b = 0; b < 6 * 6 * 6 * 6; b++)
        for (int a = 0; a < 4 * 4 * 4 * 4; a++) {
            const struct family family = family_of(b, a);
            if (search_deviation(&options, &family) < last - 1e-12) {
                bool found = false; /* itself, or the row of the same function */
                for (size_t i = 0; i < result.count; i++)
                    found |= memcmp(family.b, result.rows[i].family.b, sizeof family.b) == 0 &&
                             fabs(search_deviation(&options, &family) - result.rows[i].deviation) < 1e-12;
                assert_true(found);
                nearer++;
            }
        }
    assert_true(nearer >= 7);
    for (size_t i = 0; i < result.count; i++)
        assert_near(search_deviation(&options, &result.rows[i].family), result.rows[i].deviation, 1e-15);
    search_free(&result);
}

static void a_list_of_n_in_any_order_gives_the_same_functions(void **state)
{
    (void)state;
    const struct search_options rising = reduced(few_n), falling = reduced(falling_n);
    struct search_result one = search(&rising), other = search(&falling);
    assert_int_equal(one.count, other.count);
    for (size_t i = 0; i < one.count; i++) {
        assert_near(one.rows[i].deviation, other.rows[i].deviation, 1e-15);
        assert_memory_equal(&one.rows[i].family, &other.rows[i].family, sizeof one.rows[i].family);
    }
    search_free(&one);
    search_free(&other);
}

static void the_bound_is_never_above_the_deviation(void **state)
{
    (void)state;
    const struct search_options options = reduced(few_n);
    struct grid grid;
    struct bound_grid bounds;
    struct bound bound;
    grid_init(&grid, &options, options.exponents);
    bound_grid_init(&bounds, &grid);
    bound_init(&bound, &bounds);
    int known = 0;
    for (size_t b = 0; b < 6 * 6 * 6 * 6; b++)
        for (int k = 0; k < 8; k++) {
            struct candidate candidate = {b / 216, b / 36 % 6, b / 6 % 6, b % 6, 1, 0.25 * (k + 1)};
            bound_begin(&bound, &candidate);
            candidate.scale = 0.3 * (k + 1);
            const double sum = candidate_sum(&grid, &candidate, INFINITY);
            if (isinf(sum))
                continue;
            assert_true(bound_allows(&bound, candidate.scale, sum));
            known += !bound_allows(&bound, candidate.scale, sum / 2);
        }
    assert_true(known > 5000); /* and it is good for something */
    bound_free(&bound);
    bound_grid_free(&bounds);
    grid_free(&grid);
}

static void equal_functions_are_one_row(void **state)
{
    (void)state;
    const struct search_options options = reduced(few_n);
    struct search_result result = search(&options);
    for (size_t i = 1; i < result.count; i++) {
        const struct family *a = &result.rows[i - 1].family, *b = &result.rows[i].family;
        assert_true(memcmp(a->b, b->b, sizeof a->b) != 0 || a->a[4] / a->a[2] != b->a[4] / b->a[2] ||
                    result.rows[i - 1].deviation != result.rows[i].deviation);
    }
    search_free(&result);
}

/* ---- the command ---- */

static void the_joint_search_finds_what_two_stages_give_up(void **state)
{
    (void)state;
    const struct run *result = run("$GLINT search --joint --exponents 0:3 --best 1");
    assert_int_equal(result->status, 0);
    assert_string_equal(result->out, "3 3 1 1 1 0.5 0.25 0.5 0.5 1.25 0.00399858\n");
}

#define SLICE "search --joint --exponents 0:3 --coefficients 0.5:2:0.5 --best 6"

static bool has_ranks(void)
{
    return run("$GLINT --version | grep -q Open.MPI && command -v mpirun")->status == 0;
}

/* Open MPI itself leaves memory to the end of the process: no leaks are looked for under mpirun. */
static void the_rows_do_not_depend_on_ranks_and_threads(void **state)
{
    (void)state;
    if (!has_ranks())
        skip(); /* built without MPI, or mpirun is not installed: make setup-unit */
    char *wanted = strdup(run("OMP_NUM_THREADS=1 $GLINT " SLICE)->out);
    assert_true(strlen(wanted) > 100);
    assert_string_equal(run("OMP_NUM_THREADS=3 $GLINT " SLICE)->out, wanted);
    static const char *const ranks[] = {"1", "3", "4"};
    for (int i = 0; i < 3; i++) {
        char command[256];
        snprintf(command, sizeof command,
                 "ASAN_OPTIONS=detect_leaks=0 OMP_NUM_THREADS=1 mpirun --allow-run-as-root --oversubscribe -n %s "
                 "$GLINT " SLICE,
                 ranks[i]);
        const struct run *result = run(command);
        assert_int_equal(result->status, 0);
        assert_string_equal(result->out, wanted);
    }
    free(wanted);
}

#define SLOW "search --joint --exponents 0:3:0.5 --coefficients 0.5:2:0.5 --checkpoint joint.json"

static void a_killed_search_goes_on_from_its_checkpoint(void **state)
{
    (void)state;
    char *wanted = strdup(run("rm -f joint.json; $GLINT " SLOW)->out);
    assert_true(strlen(wanted) > 100);
    const struct run *result = run("rm joint.json; \"$KILLED\" " SLOW " >lost; [ $? = 137 ] || echo 0; "
                                   "sed 's/.*sets_done\":\\([0-9]*\\).*/\\1/' joint.json; $GLINT " SLOW);
    const long done = strtol(result->out, NULL, 10);
    assert_in_range(done, 1, 7 * 7 * 7 * 7 - 1);
    assert_string_equal(strchr(result->out, '\n') + 1, wanted);
    free(wanted);
}

/* What searches writes its checkpoint anew, as another file. */
static void a_finished_checkpoint_prints_its_rows_without_a_search(void **state)
{
    (void)state;
    char *wanted = strdup(run("$GLINT " SLICE " --checkpoint done.json && ln done.json first.json")->out);
    assert_string_equal(run("$GLINT " SLICE " --checkpoint done.json")->out, wanted);
    assert_int_equal(run("test done.json -ef first.json")->status, 0);
    free(wanted);
}

static void checkpoints_of_others_are_refused_and_kept(void **state)
{
    (void)state;
    run("echo text >text; echo '{}' >empty.json; $GLINT " SLICE " --checkpoint other.json");
    assert_fails("$GLINT " SLICE " --checkpoint text", "text is not a checkpoint of glint search");
    assert_fails("mkfifo pipe; $GLINT " SLICE " --checkpoint pipe", "pipe is not a checkpoint of glint search");
    assert_fails("$GLINT " SLICE " --checkpoint empty.json", "empty.json is not a checkpoint");
    assert_fails("$GLINT " SLICE " --angles 31 --checkpoint other.json",
                 "other.json is of a search with other options");
    run("sed 's/\"sum\":/\"sum\":-/' other.json >damaged.json");
    assert_fails("$GLINT " SLICE " --checkpoint damaged.json", "damaged.json is damaged");
    assert_fails("$GLINT " SLICE " --checkpoint nowhere/joint.json", "nowhere/joint.json");
    assert_string_equal(run("cat text")->out, "text\n");
}

static void options_that_do_not_go_together_are_refused(void **state)
{
    (void)state;
    assert_refused("$GLINT search --checkpoint joint.json", "--checkpoint: only --joint");
    assert_refused("$GLINT search --joint --stage 1", "--stage: --joint has no stages");
    assert_refused("$GLINT search --joint --exponents -4:4:0.01", "at most 200");
    assert_refused("$GLINT search --joint --coefficients 1:21", "at most 20");
    assert_refused("$GLINT search --joint --checkpoint -", "not standard output");
    assert_refused("ln -s new.json link.json; $GLINT search --joint --checkpoint new.json -o link.json",
                   "--checkpoint: this is the file of -o, too; name another");
    assert_int_equal(access("new.json", F_OK), -1);
    assert_refused("OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=0 $GLINT search", "only --joint is spread");
}

static void bad_options_under_mpirun_are_one_line(void **state)
{
    (void)state;
    if (!has_ranks())
        skip();
    const struct run *result = run("mpirun --allow-run-as-root --oversubscribe -n 3 $GLINT search --joint --best 0");
    assert_int_not_equal(result->status, 0);
    const char *line = strstr(result->err, "glint");
    assert_non_null(line);
    assert_contains(line, "--best: ");
    assert_null(strstr(strstr(line, "--best: ") + 1, "--best: "));
}

/* KILLED, instead of GLINT, is this program: it ends by SIGKILL when it has a checkpoint. */
int main(int count, char **words)
{
    if (count > 1) {
        is_killed = true;
        return command_search(count - 1, words + 1);
    }
    setenv("KILLED", realpath("/proc/self/exe", NULL), 1);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_function_is_nearer_than_the_rows_found),
        cmocka_unit_test(a_list_of_n_in_any_order_gives_the_same_functions),
        cmocka_unit_test(the_bound_is_never_above_the_deviation),
        cmocka_unit_test(equal_functions_are_one_row),
        cmocka_unit_test(the_joint_search_finds_what_two_stages_give_up),
        cmocka_unit_test(the_rows_do_not_depend_on_ranks_and_threads),
        cmocka_unit_test(a_killed_search_goes_on_from_its_checkpoint),
        cmocka_unit_test(a_finished_checkpoint_prints_its_rows_without_a_search),
        cmocka_unit_test(checkpoints_of_others_are_refused_and_kept),
        cmocka_unit_test(options_that_do_not_go_together_are_refused),
        cmocka_unit_test(bad_options_under_mpirun_are_one_line),
    };
    return cmocka_run_group_tests_name("search_joint", tests, scratch_make, scratch_remove);
}
