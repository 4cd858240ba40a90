/* SPDX-License-Identifier: MIT
 * Figure 7: how far the highlight reaches, against Blinn's; the cutoff angles (10) (12) (14). */
#include "paper/spots.h"

#include <math.h>

#include "base/output.h"
#include "models/formulas.h"
#include "models/models.h"
#include "paper/figure.h"
#include "paper/q16.h"

/* The surfaces drawn: n = 1, 38, 75 .. 704 .. 1000, q = 1..16. */
enum { N_STEP = 37 };

typedef double (*cutoff_angle)(double n, double q);

#define SCRIPT(figure, name, equation)                                                                                 \
    "set multiplot layout 1,2\n"                                                                                       \
    "set view 60,215,1,1.2\nset pm3d depthorder border lc rgb '#666666' lw 0.2\nset dgrid3d 16,28 qnorm 8\n"           \
    "unset colorbox\nset xyplane 0\nset xlabel 'shininess n'\nset ylabel 'q'\nunset key\n"                             \
    "set xrange [1:1000]\nset yrange [1:16]\nset xtics 200,200,800 offset 0,-0.4\nset ytics 1,3,13 offset 0.6,-0.2\n"  \
    "set zrange [0:*]\nset xlabel offset 0,-1\nset ylabel offset 1,-0.5\n"                                             \
    "set zlabel 'ratio to Blinn' rotate parallel\n"                                                                    \
    "set title 'Fig. " figure ": spot size of " name ", ratio " equation "'\n"                                         \
    "splot FILE using 'n':'q':'ratio' with pm3d\n"                                                                     \
    "unset dgrid3d\nset datafile missing NaN\nset title 'At four q: lines double, circles Q16 library'\n"              \
    "set xlabel offset 0,0\nset ylabel 'ratio to Blinn' offset 0,0\nset xtics 200 offset 0,0\nset ytics auto offset "  \
    "0,0\n"                                                                                                            \
    "set key top left\nset yrange [0:*]\n"                                                                             \
    "plot for [k=4:16:4] FILE using 'n':(column('q')==k ? column('ratio') : NaN) with lines lw 2 lc k/4 "              \
    "title sprintf('q = %d', k), \\\n"                                                                                 \
    "  for [k=4:16:4] FILE using 'n':(column('q')==k ? column('ratio_q16_t') : NaN) with points pt 6 lc k/4 notitle\n" \
    "unset multiplot\n"

static double ratio_at(cutoff_angle angle, double n, double q)
{
    return angle(n, q) / blinn_cutoff_angle(n, q);
}

static json_t *write_ratios(struct paper *paper, const char *file, enum glint_model model, cutoff_angle angle)
{
    struct output *csv = paper_file(paper, file);
    fputs("n,q,angle_rad,blinn_angle_rad,ratio,ratio_q16_t,ratio_q16_c\n", csv->stream);
    double apart_t = 0, apart_c = 0;
    for (int n = 1; n <= 1000; n += N_STEP)
        for (unsigned q = 1; q <= GLINT_Q_MAX; q++) {
            const double ratio = ratio_at(angle, n, q);
            const double from_t = q16_cutoff_angle_t(model, n, q) / q16_cutoff_angle_t(GLINT_BLINN, n, q);
            const double from_c = q16_cutoff_angle_c(model, n, q) / q16_cutoff_angle_c(GLINT_BLINN, n, q);
            fprintf(csv->stream, "%d,%u,%.10g,%.10g,%.10g,%.10g,%.10g\n", n, q, angle(n, q), blinn_cutoff_angle(n, q),
                    ratio, from_t, from_c);
            apart_t = fmax(apart_t, fabs(from_t / ratio - 1));
            apart_c = fmax(apart_c, fabs(from_c / ratio - 1));
        }
    output_close(csv);
    return json_sprintf("Ratios from the library's cutoffs differ from the closed forms by at most %.1e of their value "
                        "for cutoffs in t (Q2.30) and %.1e in c (Q16.16).",
                        apart_t, apart_c);
}

static void shorter_claim(struct paper *paper)
{
    int shorter = 0, pairs = 0, first_good = 1;
    for (int n = 1; n <= 1000; n++) {
        int of_n = 0;
        for (unsigned q = 1; q <= GLINT_Q_MAX; q++)
            of_n += msh_cutoff_angle_stable(n, q) < schlick_cutoff_angle(n, q);
        shorter += of_n;
        pairs += (int)GLINT_Q_MAX;
        if (of_n < (int)GLINT_Q_MAX)
            first_good = n + 1;
    }
    const double msh = ratio_at(msh_cutoff_angle_stable, 704, 8), schlick = ratio_at(schlick_cutoff_angle, 704, 8);
    paper_claim(
        paper, "fig7a", "fig. 7", "The highlight of F_MSH is computed on a shorter interval than that of F_SH",
        verdict_of(shorter == pairs, first_good <= 10),
        json_sprintf("shorter for %d of %d pairs of n in 1..1000 and q in 1..16, for all q from n = %d on; at q = 8, "
                     "n = 704 it is %.2f times Blinn's, Schlick's %.2f times",
                     shorter, pairs, first_good, msh, schlick));
    paper_choice(
        paper, "fig7a", "the range of q",
        json_sprintf("1 to 16, the library's range without q = 0, where Blinn's interval is a point"),
        json_sprintf("q = 0: Schlick's interval is the same point, MSH's is not, since its peak is 1.024: %.2f "
                     "degrees at n = 60",
                     msh_cutoff_angle_stable(60, 0) * 180 / PI));
    paper_number(paper, "spot_ratio_msh_q8_n704", msh);
    paper_number(paper, "spot_ratio_schlick_q8_n704", schlick);
    paper_count(paper, "shorter_from_n", first_good);
}

static void inequality_choice(struct paper *paper)
{
    const double edge = msh_cutoff_angle_stable(60, 8);
    paper_choice(
        paper, "fig7a", "the sense of the inequalities (9) (11) (13), printed F <= 2^-q",
        json_sprintf("F >= 2^-q: the lit part; at n = 60, q = 8 that of MSH reaches from 0 to %.1f degrees, and F "
                     "at its middle is %.3f",
                     edge * 180 / PI, model_double(GLINT_MSH, 60, cos(edge / 2))),
        json_sprintf("as printed it is the dark rest, %.1f to 90 degrees, where F at the middle is %.5f < 2^-8 = "
                     "%.5f; the angles (10) (12) (14) are the same",
                     edge * 180 / PI, model_double(GLINT_MSH, 60, cos((edge + PI / 2) / 2)), exp2(-8)));
}

/* (12) as printed against the library's exact cutoffs, in double and in single precision. */
static void closed_form_choice(struct paper *paper)
{
    int wrong_double = 0, wrong_single = 0, pairs = 0;
    for (int n = 1; n <= 1000; n++)
        for (unsigned q = 0; q <= GLINT_Q_MAX; q++) {
            const double exact = glint_cutoff(GLINT_MSH, (uint32_t)n, q);
            pairs++;
            wrong_double += ceil(msh_cutoff_cosine(n, q) * GLINT_C_ONE) != exact;
            wrong_single += ceil((double)msh_cutoff_cosine_single((float)n, (float)q) * GLINT_C_ONE) != exact;
        }
    const double n = 1.25 * (1 + 1e-7), printed = acos(msh_cutoff_cosine(n, 8)), stable = msh_cutoff_angle_stable(n, 8);
    paper_choice(
        paper, "fig7a", "(12) is 0 / 0 at n = 1.25, where 16n^2 - 40n + 25 = (4n - 5)^2 vanishes",
        json_sprintf("rearranged, c = 4n^2 / (k + sqrt(k^2 + 4n^2 - 5n))^2 with k^2 = 1.6 2^q, nothing cancels: "
                     "%.6f rad at n = 1.25, q = 8; the library finds its cutoffs with integers",
                     msh_cutoff_angle_stable(1.25, 8)),
        json_sprintf("as printed: %.6f at n = 1.25, %.6f at n = 1.25 (1 + 1e-7) (rearranged %.6f); rounded up to "
                     "2^-16 it misses the exact cutoff at %d of %d pairs (n, q) in double and %d in single "
                     "precision",
                     acos(msh_cutoff_cosine(1.25, 8)), printed, stable, wrong_double, pairs, wrong_single));
    paper_finding(
        paper, "fig7a",
        json_sprintf("Equation (12) is 0 / 0 at n = 1.25, and loses its digits near it; c = 4n^2 / (k + sqrt(k^2 + "
                     "4n^2 - 5n))^2 with k^2 = 1.6 2^q is the same without cancellation. In single precision "
                     "the printed form gives another cutoff than the exact one for %d of %d pairs of n and q.",
                     wrong_single, pairs));
    paper_count(paper, "equation_12_wrong_in_single_precision", wrong_single);
    paper_count(paper, "equation_12_wrong_in_double_precision", wrong_double);
}

void paper_figure7a(struct paper *paper)
{
    json_t *caption = write_ratios(paper, "fig7a.csv", GLINT_MSH, msh_cutoff_angle_stable);
    shorter_claim(paper);
    inequality_choice(paper);
    closed_form_choice(paper);
    paper_figure(paper, "fig7a", "Figure 7 A: spot size of MSH against Blinn's", 1100, 500,
                 "FILE = 'fig7a.csv'\n" SCRIPT("7 A", "F_{MSH}", "(16)"), caption);
}

void paper_figure7b(struct paper *paper)
{
    json_t *caption = write_ratios(paper, "fig7b.csv", GLINT_SCHLICK, schlick_cutoff_angle);
    paper_figure(paper, "fig7b", "Figure 7 B: spot size of Schlick against Blinn's", 1100, 500,
                 "FILE = 'fig7b.csv'\n" SCRIPT("7 B", "F_{SH}", "(15)"), caption);
}
