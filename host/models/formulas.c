/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "models/formulas.h"

double epicentre_angle(double n)
{
    return acos(exp(-1.2 / n));
}

double epicentre_angle_exact(double n)
{
    return acos(pow(0.3, 1 / n));
}

double absolute_error(double f, double reference)
{
    return fabs(f - reference);
}

double msh_derivative(double n, double x)
{
    const double c = cos(x), s = sin(x), d = n - n * c + 1.25 * c;
    return -1.6 * s / (d * d) - 3.2 * c * (n * s - 1.25 * s) / (d * d * d);
}

double schlick_cutoff_angle(double n, double q)
{
    return acos(n / (exp2(q) + n - 1));
}

double msh_cutoff_cosine(double n, double q)
{
    const double root = sqrt(8 + 20 * exp2(-q) * n * n - 25 * exp2(-q) * n);
    const double numerator = 4 * (16 * exp2(q) + 20 * n * n - 25 * n - 4 * exp2(q + 0.5) * root);
    return numerator / (5 * (16 * n * n - 40 * n + 25));
}

float msh_cutoff_cosine_single(float n, float q)
{
    const float root = sqrtf(8 + 20 * exp2f(-q) * n * n - 25 * exp2f(-q) * n);
    const float numerator = 4 * (16 * exp2f(q) + 20 * n * n - 25 * n - 4 * exp2f(q + 0.5f) * root);
    return numerator / (5 * (16 * n * n - 40 * n + 25));
}

/* F = 2^-q is quadratic in c: (n-1.25)^2 c^2 - (2n(n-1.25) + k^2) c + n^2 = 0 with k^2 = 1.6 2^q. Its smaller root,
 * with the radical moved into the denominator, where nothing cancels. */
double msh_cutoff_angle_stable(double n, double q)
{
    const double k = sqrt(1.6 * exp2(q)), root = k + sqrt(k * k + 4 * n * n - 5 * n);
    return acos(4 * n * n / (root * root));
}

double blinn_cutoff_angle(double n, double q)
{
    return acos(exp2(-q / n));
}

double relative_error_percent(double f, double reference)
{
    return fabs(100 * (f - reference) / reference);
}

double spherical_gaussian_double(double n, double c)
{
    return exp(-(n + 0.775) * (1 - c));
}
