/* SPDX-License-Identifier: MIT
 * Table 1 by the paper's search, and what wider searches find. */
#include "paper/table.h"

#include <math.h>

#include "base/message.h"
#include "base/output.h"
#include "models/formulas.h"
#include "models/models.h"
#include "paper/figure.h"
#include "paper/q16.h"
#include "paper/family.h"
#include "paper/search.h"

enum { TABLE_ROWS = 5, MSH_ROW = 2 };

/* Table 1 as printed, in the paper's order. */
static const struct search_row printed[TABLE_ROWS] = {
    {{{2, 2, 1, 1, 2}, {2, 1.25, 1, 1, 1.25}}, 0.0063}, {{{3, 2, 1, 1, 3}, {2, 1.25, 1, 1, 1.25}}, 0.0062},
    {{{1, 2, 1, 1, 1}, {2, 1.25, 1, 1, 1.25}}, 0.0066}, {{{2, 2, 1, 1, 3}, {2, 1.25, 1, 1, 1.25}}, 0.0066},
    {{{1, 2, 1, 1, 2}, {2, 1.25, 1, 1, 1.25}}, 0.0070},
};

static bool same_values(const double a[5], const double b[5])
{
    size_t i = 0;
    while (i < 5 && a[i] == b[i])
        i++;
    return i == 5;
}

static bool same_exponents(const struct family *a, const struct family *b)
{
    return same_values(a->b, b->b);
}

static bool same(const struct family *a, const struct family *b)
{
    return same_exponents(a, b) && same_values(a->a, b->a);
}

static const struct search_row *find(const struct search_row *rows, size_t count, const struct family *family)
{
    for (size_t i = 0; i < count; i++)
        if (same_exponents(&rows[i].family, family))
            return &rows[i];
    return NULL;
}

/* Multiplications that the powers c^b1, (...)^b2 and c^b5 take: what the paper calls high powers. */
static int high_powers(const struct family *family)
{
    return (int)(fmax(family->b[0] - 1, 0) + fmax(family->b[1] - 1, 0) + fmax(family->b[4] - 1, 0));
}

static double msh_deviation_q16(void)
{
    double sum = 0;
    for (int angle = 0; angle <= 90; angle++)
        for (int n = 1; n <= 1000; n++) {
            const double x = angle * PI / 180;
            sum += absolute_error(q16_from_t(GLINT_MSH, n, x), model_double(GLINT_BLINN, n, cos(x)));
        }
    return sum / (91.0 * 1000);
}

static void claims_of_table(struct paper *paper, const struct search_result *result)
{
    bool sets = result->count == TABLE_ROWS, coefficients = sets, digits = sets;
    double worst = 0;
    for (int i = 0; i < TABLE_ROWS && sets; i++) {
        const struct search_row *row = find(result->rows, result->count, &printed[i].family);
        sets = row != NULL;
        coefficients = coefficients && row && same(&row->family, &printed[i].family);
        worst = row ? fmax(worst, fabs(row->deviation - printed[i].deviation)) : INFINITY;
    }
    digits = worst <= 0.00005;
    paper_claim(paper, "table1", "table 1",
                "The two-stage search gives these five exponent sets, each with the coefficients 2, 1.25, 1, 1, 1.25, "
                "and mean deviations .0063, .0062, .0066, .0066, .0070",
                verdict_of(sets && coefficients && digits, sets),
                json_sprintf("sets %s, coefficients %s; the deviations differ from the printed ones by %.6f at most",
                             sets ? "all five found" : "not all found", coefficients ? "the same" : "not the same",
                             worst));

    const struct search_row *most = &result->rows[0],
                            *msh = find(result->rows, result->count, &printed[MSH_ROW].family);
    paper_claim(paper, "table1", "table 1", "Model 1 (exponents 3 2 1 1 3) is the most accurate of the five",
                verdict_of(same_exponents(&most->family, &printed[1].family), false),
                json_sprintf("smallest deviation %.6f, with exponents %g %g %g %g %g; MSH, model 2, has %.6f",
                             most->deviation, most->family.b[0], most->family.b[1], most->family.b[2],
                             most->family.b[3], most->family.b[4], msh ? msh->deviation : NAN));
    bool fewest = true;
    for (int i = 0; i < TABLE_ROWS; i++)
        fewest = fewest && (i == MSH_ROW || high_powers(&printed[i].family) > high_powers(&printed[MSH_ROW].family));
    const int powers[3] = {high_powers(&printed[0].family), high_powers(&printed[1].family),
                           high_powers(&printed[2].family)};
    paper_claim(paper, "table1", "text", "Model 1 needs five high powers, model 0 three, model 2 (MSH) one, the fewest",
                verdict_of(powers[1] == 5 && powers[0] == 3 && powers[2] == 1 && fewest, fewest),
                json_sprintf(
                    "multiplications for the powers: model 1 %d, model 0 %d, model 2 %d, model 3 %d, model 4 %d",
                    powers[1], powers[0], powers[2], high_powers(&printed[3].family), high_powers(&printed[4].family)));
    if (msh)
        paper_number(paper, "deviation_msh", msh->deviation);
    paper_number(paper, "deviation_best_of_table", most->deviation);
}

static void choice_of_grid(struct paper *paper)
{
    struct search_options options = search_options_paper();
    options.angles = 901;
    struct search_result result;
    search_run(&options, 2, &result);
    int sets = 0, rows = 0;
    for (int i = 0; i < TABLE_ROWS; i++) {
        const struct search_row *row = find(result.rows, result.count, &printed[i].family);
        sets += row != NULL;
        rows += row && same(&row->family, &printed[i].family);
    }
    const struct search_row *msh = find(result.rows, result.count, &printed[MSH_ROW].family);
    json_t *best = msh ? family_text(msh->family.a) : json_string("not found");
    paper_choice(
        paper, "table1", "how fine a grid of angles is fine enough",
        json_sprintf("the paper's own: whole degrees, 0 to 90; cos 90 degrees as computed, 6.1e-17"),
        json_sprintf("with steps of 0.1 degrees %d of the five exponent sets are the same, %d with the same "
                     "coefficients; best for MSH's exponents are then %s, deviating by %.6f, printed ones by %.6f",
                     sets, rows, json_string_value(best), msh ? msh->deviation : NAN,
                     search_deviation(&options, &printed[MSH_ROW].family)));
    paper_count(paper, "finer_grid_same_sets_of_5", sets);
    paper_count(paper, "finer_grid_same_rows_of_5", rows);
    json_decref(best);
    search_free(&result);
}

void paper_table1(struct paper *paper)
{
    const struct search_options options = search_options_paper();
    struct search_result result;
    search_run(&options, 2, &result);
    if (result.count == 0)
        fail("paper: the search found nothing");

    static const char *const head[] = {
        "model", "b1 b2 b3 b4 b5", "a1 a2 a3 a4 a5", "deviation, paper", "computed", "after stage 1", NULL};
    json_t *table = paper_table_new(paper, "table1", "Table 1: the search, row by row", head);
    struct output *csv = paper_file(paper, "table1.csv");
    fputs("model,b1,b2,b3,b4,b5,a1,a2,a3,a4,a5,deviation_printed,deviation,deviation_stage1,deviation_q16\n",
          csv->stream);
    const double q16 = msh_deviation_q16();
    for (int i = 0; i < TABLE_ROWS; i++) {
        const struct search_row *row = find(result.rows, result.count, &printed[i].family);
        const struct search_row *first = find(result.first, result.first_count, &printed[i].family);
        if (!row || !first)
            continue; /* the claim says so */
        fprintf(csv->stream, "%d,", i);
        family_write(csv->stream, &row->family);
        fprintf(csv->stream, "%.4f,%.9f,%.9f,", printed[i].deviation, row->deviation, first->deviation);
        if (i == MSH_ROW)
            fprintf(csv->stream, "%.9f", q16);
        fputc('\n', csv->stream);
        paper_table_row(table, 6, json_sprintf(i == MSH_ROW ? "%d = MSH" : "%d", i), family_text(row->family.b),
                        family_text(row->family.a), json_sprintf("%.4f", printed[i].deviation),
                        json_sprintf("%.6f", row->deviation), json_sprintf("%.6f", first->deviation));
    }
    output_close(csv);
    json_object_set_new(table, "note",
                        json_sprintf("MSH from the Q16 library deviates by %.9f: the fixed point adds "
                                     "%.1e to the mean.",
                                     q16, q16 - search_deviation(&options, &printed[MSH_ROW].family)));
    paper_number(paper, "deviation_msh_q16", q16);
    claims_of_table(paper, &result);
    choice_of_grid(paper);
    search_free(&result);
}

/* ---- wider searches ---- */

static const double half_steps[] = {-3, -2.5, -2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2, 2.5, 3};
static const double quarters[] = {0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3};

static const struct wider {
    const char *options; /* of glint search, as a user would type them */
    const char *text, *number;
    size_t best;
    bool half, quarter;
} widers[] = {
    {"--exponents -3:3:0.5", "exponents in half steps", "wider_half_steps", 5, true, false},
    {"--coefficients 0.25:3:0.25", "coefficients in quarter steps", "wider_quarter_coefficients", 5, false, true},
    {"--exponents -3:3:0.5 --coefficients 0.25:3:0.25 --best 20", "both, 20 sets kept", "wider_both", 20, true, true},
    {"--best 100", "the paper's lists, 100 sets kept instead of 5", "wider_best_100", 100, false, false},
};

static struct search_options options_of(const struct wider *wider)
{
    struct search_options options = search_options_paper();
    options.best = wider->best;
    if (wider->half)
        options.exponents = (struct search_list){half_steps, sizeof half_steps / sizeof *half_steps};
    if (wider->quarter)
        options.coefficients = (struct search_list){quarters, sizeof quarters / sizeof *quarters};
    return options;
}

void paper_wider(struct paper *paper)
{
    static const char *const head[] = {"search",    "functions", "best row: b1 b2 b3 b4 b5",        "a1 a2 a3 a4 a5",
                                       "deviation", "of MSH's",  "rows better than Table 1's best", NULL};
    json_t *table = paper_table_new(paper, "wider", "What a wider search finds", head);
    struct output *csv = paper_file(paper, "wider.csv");
    fputs("search,b1,b2,b3,b4,b5,a1,a2,a3,a4,a5,deviation\n", csv->stream);
    struct search_options options = search_options_paper();
    const double msh = search_deviation(&options, &printed[MSH_ROW].family);
    const double table_best = search_deviation(&options, &printed[1].family);
    double kept_more = 0;
    int kept_better = 0;
    struct family kept = {{0}, {0}};
    for (size_t i = 0; i < sizeof widers / sizeof *widers; i++) {
        struct search_result result;
        options = options_of(&widers[i]);
        search_run(&options, 2, &result);
        int better = 0;
        for (size_t j = 0; j < result.count; j++) {
            better += result.rows[j].deviation < table_best;
            fprintf(csv->stream, "%s,", widers[i].options);
            family_write(csv->stream, &result.rows[j].family);
            fprintf(csv->stream, "%.9f\n", result.rows[j].deviation);
        }
        const struct search_row *best = &result.rows[0];
        paper_table_row(table, 7, json_sprintf("%s (%s)", widers[i].text, widers[i].options),
                        json_sprintf("%.0f", search_first_size(&options) + search_second_size(&options)),
                        family_text(best->family.b), family_text(best->family.a), json_sprintf("%.6f", best->deviation),
                        json_sprintf("%.0f %%", 100 * best->deviation / msh), json_sprintf("%d", better));
        paper_number(paper, widers[i].number, best->deviation);
        kept = best->family;
        kept_more = best->deviation; /* of the last, which keeps 100 */
        kept_better = better;
        search_free(&result);
    }
    output_close(csv);
    json_object_set_new(
        table, "note",
        json_sprintf("MSH deviates by %.6f, the best of Table 1 by %.6f. With the paper's own lists, but "
                     "100 sets kept after stage 1, the best deviates by %.6f: %s.",
                     msh, table_best, kept_more,
                     kept_more < table_best ? "sets that are poor with all coefficients 1 end up better"
                                            : "no better set was dropped"));
    if (kept_more < table_best)
        paper_finding(
            paper, "wider",
            json_sprintf(
                "The paper's own lists hold better sets than Table 1. Its search keeps five sets of exponents "
                "after the first stage; with 100 kept, %d functions are better than the best of Table 1, whose "
                "mean deviation is %.6f (MSH: %.6f). The best, F = %g c^%g / (%g (%g n^%g - %g (nc)^%g + %g "
                "c^%g)^%g), has %.6f, %.0f %% of MSH's.",
                kept_better, table_best, msh, kept.a[0], kept.b[0], kept.a[1], kept.a[2], kept.b[2], kept.a[3],
                kept.b[3], kept.a[4], kept.b[4], kept.b[1], kept_more, 100 * kept_more / msh));
    paper_count(paper, "wider_best_100_better", kept_better);
}
