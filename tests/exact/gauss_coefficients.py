#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table in lib/lobe_gauss.c: g(t) = exp(-acos(1 - t)^2 / 2) on 0 <= t <= 1 as a polynomial in t, Q1.62.

g is interpolated at the Chebyshev nodes in 60 decimal digits. Its only singularity is at t = 2, so that a degree
of DEGREE leaves less than 2^-60. The first coefficient is g(0) = 1 exactly. Only the standard library is used."""
from decimal import Decimal, getcontext
from fractions import Fraction
from math import comb

DEGREE = 20
getcontext().prec = 60
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459")


def cosine(x):
    term = total = Decimal(1)
    for k in range(1, 60):
        term *= -x * x / ((2 * k - 1) * (2 * k))
        total += term
    return total


def half_square(t):
    """acos(1 - t)^2 / 2 = sum over k >= 1 of (2t)^k / (k^2 C(2k, k)), t < 2."""
    total, power = Decimal(0), Decimal(1)
    for k in range(1, 220):
        power *= 2 * t
        total += power / (k * k * comb(2 * k, k))
    return total


def g(t):
    return (-half_square(t)).exp()


def chebyshev_coefficients(h, count):
    """h(t) at the nodes x_j of [-1, 1], t = (x + 1) / 2."""
    angles = [PI * (2 * j + 1) / (2 * count) for j in range(count)]
    values = [h((cosine(angle) + 1) / 2) for angle in angles]
    return [sum(v * cosine(k * a % (2 * PI)) for v, a in zip(values, angles)) * (1 if k == 0 else 2) / count
            for k in range(count)]


def monomials(chebyshev):
    """Sum of c_k T_k(2t - 1) as coefficients of t^0, t^1, ..."""
    previous, current = [Fraction(1)], [Fraction(-1), Fraction(2)]
    total = [Fraction(0)] * len(chebyshev)
    for k, c in enumerate(chebyshev):
        for i, value in enumerate(previous):
            total[i] += Fraction(c) * value
        following = [Fraction(0)] * (len(current) + 1)
        for i, value in enumerate(current):
            following[i] -= 2 * value
            following[i + 1] += 4 * value
        for i, value in enumerate(previous):
            following[i] -= value
        previous, current = current, following
    return total


if __name__ == "__main__":
    # (g(t) - 1) / t has one degree less than g.
    for value in [Fraction(1)] + monomials(chebyshev_coefficients(lambda t: (g(t) - 1) / t, DEGREE)):
        print("    INT64_C(%d)," % round(value * 2**62))
