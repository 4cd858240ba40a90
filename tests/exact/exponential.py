#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table in lib/lobe_sg.c, exp(-t) by its own series, Q1.62: of (-1)^k / k! a degree of 20 leaves less than 1 / 21! < 2^-65 on
0 <= t <= 1; and the table in lib/math_power.c, 2^-(i / 32) in Q32, the first held to 32 bits."""
from decimal import Decimal
from fractions import Fraction
from math import factorial

for k in range(21):
    print("    INT64_C(%d)," % round(Fraction((-1)**k * 2**62, factorial(k))))
fractions = [min(2**32 - 1, round(Decimal(2)**(32 - Decimal(i) / 32))) for i in range(32)]
print("const uint32_t glint_exp2_fractions[32] GLINT_FLASH = {")
for i in range(0, 32, 8):
    print("    " + " ".join("%d," % value for value in fractions[i:i + 8]))
print("};")
