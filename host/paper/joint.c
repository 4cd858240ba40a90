/* SPDX-License-Identifier: MIT
 * What the paper's two stages give up: a slice of the joint grid, and how long the whole would take here. */
#include "paper/joint.h"

#include "base/clock.h"
#include "base/output.h"
#include "paper/family.h"
#include "paper/search_joint.h"

static const double exponents[] = {0, 1, 2, 3};

void paper_joint(struct paper *paper)
{
    static const char *const head[] = {"b1 b2 b3 b4 b5", "a1 a2 a3 a4 a5", "deviation", NULL};
    json_t *table = paper_table_new(paper, "joint", "Exponents and coefficients searched together", head);
    struct search_options options = search_options_joint();
    const double whole = search_joint_size(&options);
    options.exponents = (struct search_list){exponents, sizeof exponents / sizeof *exponents};
    options.quiet = true;
    const struct ranks alone = {0, 1};
    struct search_result result;
    const double start = seconds_now();
    search_joint(&options, &alone, NULL, &result);
    const double seconds = seconds_now() - start, functions = search_joint_size(&options);
    struct output *csv = paper_file(paper, "joint.csv");
    fputs("b1,b2,b3,b4,b5,a1,a2,a3,a4,a5,deviation\n", csv->stream);
    for (size_t i = 0; i < result.count; i++) {
        const struct search_row *row = &result.rows[i];
        family_write(csv->stream, &row->family);
        fprintf(csv->stream, "%.9f\n", row->deviation);
        paper_table_row(table, 3, family_text(row->family.b), family_text(row->family.a),
                        json_sprintf("%.6f", row->deviation));
    }
    output_close(csv);
    json_object_set_new(
        table, "note",
        json_sprintf(
            "`glint search --joint --exponents 0:3`: each of 256 exponent sets with each of 10,000 coefficient "
            "sets, %.0f functions, without the choice of sets between the paper's stages. It took %.1f s here; "
            "at that speed the whole grid of `glint search --joint`, %.2e functions, would take %.0f minutes "
            "(predicted), and under mpirun as much less as there are ranks.",
            functions, seconds, whole, seconds * whole / functions / 60));
    paper_number(paper, "joint_best", result.rows[0].deviation);
    search_free(&result);
}
