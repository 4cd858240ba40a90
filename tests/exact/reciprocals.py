#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table in lib/math_root.c: for each 64th of 2^27 <= m < 2^28 the integer y for which y m / 2^35 stays nearest to 1."""
from fractions import Fraction


def farthest(i, y):
    return max(abs(Fraction(y * m, 2**35) - 1) for m in ((64 + i) << 21, (65 + i) << 21))


table = [min(range(128, 256), key=lambda y: farthest(i, y)) for i in range(64)]
assert max(farthest(i, y) for i, y in enumerate(table)) < Fraction("0.00904")  # what the error bounds there build on
print("const uint8_t glint_reciprocals[64] GLINT_FLASH = {")
for i in range(0, 64, 16):
    print("    " + " ".join("%d," % y for y in table[i:i + 16]))
print("};")
