/* SPDX-License-Identifier: MIT
 * Figures 3 and 4: the functions themselves, and their error at the epicentre of the highlight. */
#include "paper/lobes.h"

#include <math.h>

#include "base/output.h"
#include "models/formulas.h"
#include "models/models.h"
#include "paper/figure.h"
#include "paper/q16.h"

/* ---- figure 3: F over x at n = 60 ---- */

enum { FIGURE3_N = 60, FIGURE3_STEPS = 360, FADING_STEPS = 500 };

static const enum glint_model shown[3] = {GLINT_BLINN, GLINT_SCHLICK, GLINT_MSH};

static const char figure3_script[] =
    "set multiplot layout 2,1\n"
    "set title 'Fig. 3: MSH, Schlick and Blinn at n = 60'\n"
    "set xlabel 'angle x between N and H, degrees'\nset ylabel 'F'\nset xrange [0:45]\nset yrange [0:1.1]\n"
    "set key top right\n"
    "plot 'fig3.csv' using 'angle_deg':'blinn' with lines lw 2 lc rgb '#000000' title 'Blinn F_B', \\\n"
    "  '' using 'angle_deg':'schlick' with lines lw 2 lc rgb '#d55e00' title 'Schlick F_{SH}', \\\n"
    "  '' using 'angle_deg':'msh' with lines lw 2 lc rgb '#0072b2' title 'MSH F_{MSH}', \\\n"
    "  '' using 'angle_deg':'blinn_q16_t' every 6 with points pt 6 lc rgb '#000000' title 'Blinn, Q16', \\\n"
    "  '' using 'angle_deg':'schlick_q16_t' every 6 with points pt 6 lc rgb '#d55e00' title 'Schlick, Q16', \\\n"
    "  '' using 'angle_deg':'msh_q16_t' every 6 with points pt 6 lc rgb '#0072b2' title 'MSH, Q16'\n"
    "set title 'The same: Q16 library less double formula (from t; from c it is larger, see the text)'\n"
    "set ylabel 'difference, units of 2^{-16}'\nset yrange [-1:1]\n"
    "plot 'fig3.csv' using 'angle_deg':((column('blinn_q16_t')-column('blinn'))*65536) with points pt 7 ps 0.4 "
    "lc rgb '#000000' title 'Blinn', \\\n"
    "  '' using 'angle_deg':((column('schlick_q16_t')-column('schlick'))*65536) with points pt 7 ps 0.4 "
    "lc rgb '#d55e00' title 'Schlick', \\\n"
    "  '' using 'angle_deg':((column('msh_q16_t')-column('msh'))*65536) with points pt 7 ps 0.4 "
    "lc rgb '#0072b2' title 'MSH'\n"
    "unset multiplot\n";

/* Over the angles from the epicentre to 90 degrees: the mean of |F - F_B|. */
static double fading_error(enum glint_model model, double n)
{
    const double start = epicentre_angle(n);
    double sum = 0;
    for (int i = 0; i <= FADING_STEPS; i++) {
        const double c = cos(start + (PI / 2 - start) * i / FADING_STEPS);
        sum += absolute_error(model_double(model, n, c), model_double(GLINT_BLINN, n, c));
    }
    return sum / (FADING_STEPS + 1);
}

static void fading_claim(struct paper *paper)
{
    int better = 0;
    for (int n = 2; n <= 1000; n++)
        better += fading_error(GLINT_MSH, n) < fading_error(GLINT_SCHLICK, n);
    const double msh = fading_error(GLINT_MSH, FIGURE3_N), schlick = fading_error(GLINT_SCHLICK, FIGURE3_N);
    paper_claim(
        paper, "fig3", "fig. 3", "F_MSH reproduces the fading zone better than F_SH (shown at n = 60)",
        verdict_of(msh < schlick && better == 999, msh < schlick),
        json_sprintf("mean error from the epicentre to 90 degrees at n = 60: MSH %.4f, Schlick %.4f (%.1f times); "
                     "MSH is nearer for %d of the 999 n in 2..1000",
                     msh, schlick, schlick / msh, better));
    paper_choice(
        paper, "fig3", "where the fading zone begins, and how nearness is measured",
        json_sprintf("from the epicentre (6) to 90 degrees, mean absolute error"),
        json_sprintf("one angle instead, where F_B = 2^-8 at n = 1000: MSH is %.1f times Blinn there, Schlick %.1f",
                     256 * model_double(GLINT_MSH, 1000, exp2(-8.0 / 1000)),
                     256 * model_double(GLINT_SCHLICK, 1000, exp2(-8.0 / 1000))));
    paper_number(paper, "fading_error_msh_n60", msh);
    paper_number(paper, "fading_error_schlick_n60", schlick);
    paper_number(paper, "tail_msh_times_blinn_n1000", 256 * model_double(GLINT_MSH, 1000, exp2(-8.0 / 1000)));
}

void paper_figure3(struct paper *paper)
{
    struct output *csv = paper_file(paper, "fig3.csv");
    fputs("angle_deg,blinn,schlick,msh,blinn_q16_t,schlick_q16_t,msh_q16_t,blinn_q16_c,schlick_q16_c,msh_q16_c\n",
          csv->stream);
    double worst_t = 0, worst_c = 0;
    for (int i = 0; i <= FIGURE3_STEPS; i++) {
        const double x = PI / 2 * i / FIGURE3_STEPS;
        double value[3], from_t[3], from_c[3];
        for (int k = 0; k < 3; k++) {
            value[k] = model_double(shown[k], FIGURE3_N, cos(x));
            from_t[k] = q16_from_t(shown[k], FIGURE3_N, x);
            from_c[k] = q16_from_c(shown[k], FIGURE3_N, x);
            worst_t = fmax(worst_t, fabs(from_t[k] - value[k]) * GLINT_C_ONE);
            worst_c = fmax(worst_c, fabs(from_c[k] - value[k]) * GLINT_C_ONE);
        }
        fprintf(csv->stream, "%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g\n", x * 180 / PI, value[0],
                value[1], value[2], from_t[0], from_t[1], from_t[2], from_c[0], from_c[1], from_c[2]);
    }
    output_close(csv);
    fading_claim(paper);
    paper_number(paper, "fig3_q16_t_largest_ulp", worst_t);
    paper_number(paper, "fig3_q16_c_largest_ulp", worst_c);
    paper_figure(paper, "fig3", "Figure 3: F over the angle, n = 60", 900, 800, figure3_script,
                 json_sprintf("Lines: double; circles: Q16 library. The library differs from the double formulas by at "
                              "most %.3f units of 2^-16 from t (Q2.30), by %.1f from c (Q16.16), whose step is coarse.",
                              worst_t, worst_c));
}

/* ---- figure 4: error at the epicentre over n ---- */

typedef double (*value_at)(enum glint_model model, double n, double x);

static double double_at(enum glint_model model, double n, double x)
{
    return model_double(model, n, cos(x));
}

static double epicentre_error(value_at value, enum glint_model model, double n, double x)
{
    return relative_error_percent(value(model, n, x), value(GLINT_BLINN, n, x));
}

static const char figure4_script[] =
    "set multiplot layout 2,1\n"
    "set title 'Fig. 4: relative error at the epicentre (6) of the highlight'\n"
    "set xlabel 'shininess n'\nset ylabel 'error, percent of F_B'\nset xrange [1:1000]\nset logscale x\nset yrange "
    "[0:60]\n"
    "set key at graph 0.98,0.7\n"
    "shown(n) = n <= 10 || (n <= 100 && int(n) % 10 == 0) || int(n) % 100 == 0\n"
    "plot 'fig4.csv' using 'n':'schlick_percent' with lines lw 2 lc rgb '#d55e00' title 'Schlick', \\\n"
    "  '' using 'n':'msh_percent' with lines lw 2 lc rgb '#0072b2' title 'MSH', \\\n"
    "  '' using 'n':(shown(column('n')) ? column('schlick_q16_percent') : NaN) with points pt 6 lc rgb '#d55e00' title "
    "'Schlick, Q16', \\\n"
    "  '' using 'n':(shown(column('n')) ? column('msh_q16_percent') : NaN) with points pt 6 lc rgb '#0072b2' title "
    "'MSH, Q16', \\\n"
    "  52 with lines dt 2 lc rgb '#d55e00' title 'claimed: at most 52 %', \\\n"
    "  16 with lines dt 2 lc rgb '#0072b2' title 'claimed: at most 16 %'\n"
    "set title 'The same: Q16 library less double formula'\n"
    "set ylabel 'difference, percentage points'\nset yrange [-0.01:0.01]\nset key default\n"
    "plot 'fig4.csv' using 'n':(column('schlick_q16_percent')-column('schlick_percent')) with points pt 7 ps 0.3 "
    "lc rgb '#d55e00' title 'Schlick', \\\n"
    "  '' using 'n':(column('msh_q16_percent')-column('msh_percent')) with points pt 7 ps 0.3 "
    "lc rgb '#0072b2' title 'MSH'\n"
    "unset multiplot\n";

struct largest {
    double value;
    int n;
};

static void note(struct largest *largest, double value, int n)
{
    if (n >= 2 && value > largest->value) /* the paper's range */
        *largest = (struct largest){value, n};
}

void paper_figure4(struct paper *paper)
{
    struct output *csv = paper_file(paper, "fig4.csv");
    fputs("n,msh_percent,schlick_percent,msh_q16_percent,schlick_q16_percent,msh_exact_percent,schlick_exact_percent\n",
          csv->stream);
    struct largest msh = {0}, schlick = {0}, msh_exact = {0}, schlick_exact = {0};
    double fixed_point = 0;
    for (int n = 1; n <= 1000; n++) {
        const double x = epicentre_angle(n), exact = epicentre_angle_exact(n);
        const double row[6] = {
            epicentre_error(double_at, GLINT_MSH, n, x),     epicentre_error(double_at, GLINT_SCHLICK, n, x),
            epicentre_error(q16_from_t, GLINT_MSH, n, x),    epicentre_error(q16_from_t, GLINT_SCHLICK, n, x),
            epicentre_error(double_at, GLINT_MSH, n, exact), epicentre_error(double_at, GLINT_SCHLICK, n, exact),
        };
        fprintf(csv->stream, "%d,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g\n", n, row[0], row[1], row[2], row[3], row[4],
                row[5]);
        note(&msh, row[0], n);
        note(&schlick, row[1], n);
        note(&msh_exact, row[4], n);
        note(&schlick_exact, row[5], n);
        fixed_point = fmax(fixed_point, fmax(fabs(row[2] - row[0]), fabs(row[3] - row[1])));
    }
    output_close(csv);
    const bool by_6 = msh.value <= 16 && schlick.value <= 52;
    const bool by_exact = msh_exact.value <= 16 && schlick_exact.value <= 52;
    paper_claim(
        paper, "fig4", "fig. 4", "The error at the epicentre is at most 16 % (MSH) and 52 % (Schlick), n in [2, 1000]",
        verdict_of(by_6 && by_exact, by_6 || by_exact),
        json_sprintf("MSH %.1f %% at n = %d, Schlick %.1f %% at n = %d", msh.value, msh.n, schlick.value, schlick.n));
    const double one = epicentre_angle(1);
    paper_choice(paper, "fig4", "the epicentre: F_B = 0.3 in the text, but (6) gives e^-1.2 = 0.3012",
                 json_sprintf("(6): MSH %.1f %%, Schlick %.1f %% at most", msh.value, schlick.value),
                 json_sprintf("F_B = 0.3 exactly: %.1f %% and %.1f %%; n = 1, which the paper leaves out: %.1f %% and "
                              "%.1f %% by (6)",
                              msh_exact.value, schlick_exact.value, epicentre_error(double_at, GLINT_MSH, 1, one),
                              epicentre_error(double_at, GLINT_SCHLICK, 1, one)));
    paper_number(paper, "epicentre_msh_percent", msh.value);
    paper_count(paper, "epicentre_msh_n", msh.n);
    paper_number(paper, "epicentre_schlick_percent", schlick.value);
    paper_count(paper, "epicentre_schlick_n", schlick.n);
    paper_number(paper, "epicentre_exact_msh_percent", msh_exact.value);
    paper_number(paper, "epicentre_exact_schlick_percent", schlick_exact.value);
    paper_figure(paper, "fig4", "Figure 4: error at the epicentre", 900, 800, figure4_script,
                 json_sprintf("Lines: double; circles: both F and F_B from the Q16 library. The fixed point moves the "
                              "curves by at most %.4f percentage points.",
                              fixed_point));
}
