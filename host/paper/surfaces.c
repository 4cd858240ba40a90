/* SPDX-License-Identifier: MIT
 * Figures 5 and 6: the absolute error and the derivative as surfaces over n and x. */
#include "paper/surfaces.h"

#include <math.h>

#include "base/output.h"
#include "models/formulas.h"
#include "models/models.h"
#include "paper/figure.h"
#include "paper/q16.h"

/* The surfaces drawn: n = 1, 28, 55 .. 1000 and x in quarter degrees. Claims are tested on finer grids. */
enum { N_STEP = 27, ANGLE_STEPS = 360 };

static double angle_at(int i)
{
    return PI / 2 * i / ANGLE_STEPS;
}

/* ---- figure 5 ---- */

#define SURFACE                                                                                                        \
    "near(x) = x <= 20 ? x : NaN\nset pm3d depthorder border lc rgb '#666666' lw 0.2\nset dgrid3d 81,38 qnorm "        \
    "8\nunset colorbox\nset xyplane 0\n"                                                                               \
    "set xlabel 'shininess n'\nset ylabel 'x, degrees'\nset xrange [1:1000]\nset yrange [0:20]\nset xtics "            \
    "200,200,800 offset 0,-0.4\nset ytics 5,5,20 offset 0.6,-0.2\nset xlabel offset 0,-1\nset ylabel offset "          \
    "1,-0.5\nunset key\n"

static const char figure5_script[] =
    "set multiplot layout 2,2 title 'Fig. 5: absolute error |F - F_B|'\n" SURFACE
    "set view 60,35,1,1.3\nset zrange [0:0.22]\nset cbrange [0:0.22]\n"
    "set title 'Schlick'\nsplot 'fig5.csv' using 'n':(near(column('angle_deg'))):'schlick_error' with pm3d\n"
    "set title 'MSH'\nsplot 'fig5.csv' using 'n':(near(column('angle_deg'))):'msh_error' with pm3d\n"
    "unset dgrid3d\nunset pm3d\nset colorbox\nset xtics 200 offset 0,0\nset ytics 10 offset 0,0\nset xlabel offset "
    "0,0\n"
    "set ylabel offset 0,0\nset yrange [0:90]\nset cbrange [-1:1]\nset cblabel 'units of 2^{-16}'\n"
    "set palette defined (-1 '#0072b2', 0 'white', 1 '#d55e00')\n"
    "set title 'Schlick: Q16 less double'\n"
    "plot 'fig5.csv' using 'n':'angle_deg':((column('schlick_error_q16')-column('schlick_error'))*65536) with image\n"
    "set title 'MSH: Q16 less double'\n"
    "plot 'fig5.csv' using 'n':'angle_deg':((column('msh_error_q16')-column('msh_error'))*65536) with image\n"
    "unset multiplot\n";

/* The largest absolute error for shininess `first` to 1000. */
static double largest_error(enum glint_model model, int first, double angle_step_deg)
{
    double largest = 0;
    const int steps = (int)lround(90 / angle_step_deg);
    for (int n = first; n <= 1000; n++)
        for (int i = 0; i <= steps; i++) {
            const double c = cos(PI / 2 * i / steps);
            largest = fmax(largest, absolute_error(model_double(model, n, c), model_double(GLINT_BLINN, n, c)));
        }
    return largest;
}

static double write_figure5(struct output *csv)
{
    double fixed_point = 0;
    fputs("n,angle_deg,msh_error,schlick_error,msh_error_q16,schlick_error_q16\n", csv->stream);
    for (int n = 1; n <= 1000; n += N_STEP)
        for (int i = 0; i <= ANGLE_STEPS; i++) {
            const double x = angle_at(i), blinn = model_double(GLINT_BLINN, n, cos(x));
            const double blinn_q16 = q16_from_t(GLINT_BLINN, n, x);
            const double msh = absolute_error(model_double(GLINT_MSH, n, cos(x)), blinn);
            const double schlick = absolute_error(model_double(GLINT_SCHLICK, n, cos(x)), blinn);
            const double msh_q16 = absolute_error(q16_from_t(GLINT_MSH, n, x), blinn_q16);
            const double schlick_q16 = absolute_error(q16_from_t(GLINT_SCHLICK, n, x), blinn_q16);
            fprintf(csv->stream, "%d,%g,%.10g,%.10g,%.10g,%.10g\n", n, x * 180 / PI, msh, schlick, msh_q16,
                    schlick_q16);
            fixed_point = fmax(fixed_point, fmax(fabs(msh_q16 - msh), fabs(schlick_q16 - schlick)));
        }
    return fixed_point * GLINT_C_ONE;
}

void paper_figure5(struct paper *paper)
{
    struct output *csv = paper_file(paper, "fig5.csv");
    const double fixed_point = write_figure5(csv);
    output_close(csv);

    const double msh = largest_error(GLINT_MSH, 2, 0.1), schlick = largest_error(GLINT_SCHLICK, 2, 0.1);
    const double msh_one = largest_error(GLINT_MSH, 1, 0.1);
    paper_claim(paper, "fig5", "fig. 5", "The largest absolute error of F_MSH is about half of F_SH's",
                verdict_of(msh_one / schlick <= 0.55, msh / schlick <= 0.55),
                json_sprintf("%.4f against %.4f, %.2f times, for n in 2..1000; with n = 1, %.4f, it is %.2f times", msh,
                             schlick, msh / schlick, msh_one, msh_one / schlick));
    paper_choice(paper, "fig5", "which n and which angles the largest error is taken over",
                 json_sprintf("n in 2..1000, as for fig. 4, and steps of 0.1 degrees: %.4f and %.4f", msh, schlick),
                 json_sprintf("n from 1: %.4f and %.4f; whole degrees, n from 2: %.4f and %.4f", msh_one,
                              largest_error(GLINT_SCHLICK, 1, 0.1), largest_error(GLINT_MSH, 2, 1),
                              largest_error(GLINT_SCHLICK, 2, 1)));
    paper_number(paper, "largest_error_msh", msh);
    paper_number(paper, "largest_error_schlick", schlick);
    paper_number(paper, "largest_error_ratio", msh / schlick);
    paper_number(paper, "largest_error_msh_from_n1", msh_one);
    paper_number(paper, "largest_error_ratio_from_n1", msh_one / schlick);
    paper_figure(
        paper, "fig5", "Figure 5: absolute error over n and x", 1000, 900, figure5_script,
        json_sprintf("Above: double, one scale for both. Below: what the Q16 library adds, %.2f units of 2^-16 "
                     "at the most. Beyond 20 degrees see fig5.csv.",
                     fixed_point));
}

/* ---- figure 6 ---- */

static const char figure6_script[] = "set multiplot layout 1,2\n" SURFACE "set view 50,60,1,1\nset ztics -20,5,0\n"
                                     "set xtics offset -0.6,-0.3\nset xlabel offset -4,-1\n"
                                     "set zlabel 'dF/dx, per radian' rotate parallel\n"
                                     "set title 'Fig. 6: derivative (8) of F_{MSH}, double'\n"
                                     "splot 'fig6.csv' using 'n':(near(column('angle_deg'))):'derivative' with pm3d\n"
                                     "set title 'From Q16: differences of the library over a quarter of a degree'\n"
                                     "splot 'fig6.csv' using 'n':(near(column('angle_deg'))):'slope_q16' with pm3d\n"
                                     "unset multiplot\n";

struct slopes {
    double steepest, q16_apart;
    long rising_q16;
};

static struct slopes write_figure6(struct output *csv)
{
    struct slopes slopes = {0, 0, 0};
    fputs("n,angle_deg,derivative,slope,slope_q16\n", csv->stream);
    for (int n = 1; n <= 1000; n += N_STEP)
        for (int i = 0; i < ANGLE_STEPS; i++) {
            const double x = angle_at(i), next = angle_at(i + 1);
            const double slope =
                (model_double(GLINT_MSH, n, cos(next)) - model_double(GLINT_MSH, n, cos(x))) / (next - x);
            const double q16 = (q16_from_t(GLINT_MSH, n, next) - q16_from_t(GLINT_MSH, n, x)) / (next - x);
            fprintf(csv->stream, "%d,%g,%.10g,%.10g,%.10g\n", n, x * 180 / PI, msh_derivative(n, x), slope, q16);
            slopes.steepest = fmin(slopes.steepest, msh_derivative(n, x));
            slopes.q16_apart = fmax(slopes.q16_apart, fabs(q16 - slope));
            slopes.rising_q16 += q16 > 0;
        }
    return slopes;
}

static void zero_claim(struct paper *paper)
{
    double at_one = 0, before = INFINITY;
    uint32_t at_one_q16 = 0;
    for (int n = 1; n <= 1000; n++) {
        at_one = fmax(at_one, fabs(model_double(GLINT_MSH, n, 0)));
        at_one_q16 |= glint_eval(GLINT_MSH, (uint32_t)n, 0) | glint_eval_t(GLINT_MSH, (uint32_t)n, GLINT_T_ONE);
        before = fmin(before, model_double(GLINT_MSH, n, cos(1.5707)));
    }
    paper_claim(paper, "fig6", "text", "F_MSH reaches zero at x = 1.570796 (pi/2)",
                verdict_of(at_one == 0 && at_one_q16 == 0 && before > 0, at_one < 1e-6),
                json_sprintf("F_MSH = %g for every n at c = 0, from the library too (%u), and at least %.1e at "
                             "x = 1.5707; pi/2 = %.6f",
                             at_one, (unsigned)at_one_q16, before, PI / 2));
    paper_number(paper, "msh_zero_angle", PI / 2);
}

void paper_figure6(struct paper *paper)
{
    struct output *csv = paper_file(paper, "fig6.csv");
    const struct slopes slopes = write_figure6(csv);
    output_close(csv);
    zero_claim(paper);
    long tested = 0, negative = 0;
    for (int n = 1; n <= 1000; n++)
        for (int i = 1; i <= 900; i++) {
            tested++;
            negative += msh_derivative(n, PI / 2 * i / 900) < 0;
        }
    paper_claim(paper, "fig6", "fig. 6", "F_MSH falls monotonically on [0, pi/2]: its derivative (8) is negative",
                verdict_of(negative == tested && slopes.rising_q16 == 0, negative == tested),
                json_sprintf("negative at %ld of %ld points, n = 1..1000, x in steps of 0.1 degrees (0 at x = 0); the "
                             "library's values rise nowhere in fig6.csv: %ld rises",
                             negative, tested, slopes.rising_q16));
    paper_count(paper, "derivative_points_not_negative", tested - negative);
    paper_figure(
        paper, "fig6", "Figure 6: the derivative over n and x", 1100, 500, figure6_script,
        json_sprintf("The steepest slope in the grid is %.2f per radian. Slopes from the Q16 library differ from "
                     "the same differences in double by at most %.5f per radian.",
                     slopes.steepest, slopes.q16_apart));
}
