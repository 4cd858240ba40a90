/* SPDX-License-Identifier: MIT
 * The paper's formulas beyond the models themselves, in double precision; numbers in brackets are its equations.
 * x: the angle in radians, c = cos x, n: shininess, q: the cutoff 2^-q. */
#ifndef GLINT_FORMULAS_H
#define GLINT_FORMULAS_H

/* One function of the general family (3); with b[3] = b[2], a[3] = a[2] it is (4).
 * a1 c^b1 / (a2 (a3 n^b3 - a4 (n c)^b4 + a5 c^b5)^b2), counted from 0 here. */
struct family {
    double b[5], a[5];
};

double epicentre_angle(double n);                          /* (6), F_B = e^-1.2 = 0.3012 there */
double epicentre_angle_exact(double n);                    /* where F_B = 0.3 */
double absolute_error(double f, double reference);         /* (7) */
double msh_derivative(double n, double x);                 /* (8), dF_MSH / dx */
double schlick_cutoff_angle(double n, double q);           /* (10) */
double msh_cutoff_cosine(double n, double q);              /* (12) as printed, before the acos: 0 / 0 at n = 1.25 */
float msh_cutoff_cosine_single(float n, float q);          /* the same, as single precision gives it */
double msh_cutoff_angle_stable(double n, double q);        /* (12) rearranged: no singularity for n >= 1, q >= 0 */
double blinn_cutoff_angle(double n, double q);             /* (14) */
double relative_error_percent(double f, double reference); /* (17) */

/* Not the paper's, to compare with: the spherical Gaussian fitted to c^n. */
double spherical_gaussian_double(double n, double c); /* exp(-(n + 0.775) (1-c)) */

#endif
