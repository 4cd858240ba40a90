#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the table in lib/math_root.c: for each 2^26 of 2^30 <= a < 2^32 the chord y of 2^31 / sqrt(a) that lies below and above it by as much:
y at its start in the upper 16 bits, times 1, and by how much it falls, times 16."""
from math import sqrt


def chord(i):
    start, middle, end = (2**31 / sqrt((i + part) * 2**26) for part in (0, 0.5, 1))
    down = ((start + end) / 2 - middle) / 2
    return min(round(start - down), 65535), round(16 * (start - end))


for i in range(16, 64, 4):
    print("    " + " ".join("0x%04x%04x," % chord(j) for j in range(i, i + 4)))
