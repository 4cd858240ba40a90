#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table of the quick Gauss in lib/lobe_gauss.c: b(t) = log2(e) acos(1 - t)^2 / (2 t) on 0 <= t <= 1 as a polynomial
of degree 7 in t, interpolated at the Chebyshev nodes, magnitudes in Q31."""
from decimal import Decimal
from gauss_coefficients import chebyshev_coefficients, half_square, monomials

TWO = Decimal(2)


def print_table(name, values, line):
    print("static const uint32_t %s[%d] GLINT_FLASH = {" % (name, len(values)))
    for i in range(0, len(values), line):
        print("    " + " ".join("%d," % value for value in values[i:i + line]))
    print("};")


b = monomials(chebyshev_coefficients(lambda t: half_square(t) / t / TWO.ln(), 8))
assert [value > 0 for value in b] == [True] * 6 + [False, True]  # as lib/lobe_gauss.c adds and subtracts them
print_table("gauss_exponents", [abs(round(value * 2**31)) for value in b], 8)
