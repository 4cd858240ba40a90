#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the tables in lib/math_srgb.c: the sRGB transfer function (IEC 61966-2-1) in 1/65535, to nearest.

decoded[i]: the linear value of i / 255. encodings[j]: the encoding of (32 + j % 32) << (2 + j / 32), j = 0..288,
that is of 32 steps an octave from 128 on."""
from decimal import Decimal, getcontext

getcontext().prec = 40


def decode(e):
    if e <= Decimal("0.04045"):
        return e / Decimal("12.92")
    return ((e + Decimal("0.055")) / Decimal("1.055")) ** Decimal("2.4")


def encode(v):
    if v <= Decimal("0.0031308"):
        return v * Decimal("12.92")
    return Decimal("1.055") * v ** (1 / Decimal("2.4")) - Decimal("0.055")


def show(name, values):
    print("static const uint16_t %s[%d] GLINT_FLASH = {" % (name, len(values)))
    for i in range(0, len(values), 16):
        print("    " + " ".join("%d," % v for v in values[i:i + 16]))
    print("};")


show("decoded", [round(65535 * decode(Decimal(i) / 255)) for i in range(256)])
linear = [Decimal((32 + j % 32) << (2 + j // 32)) / 65535 for j in range(289)]
show("encodings", [min(65535, round(65535 * encode(v))) for v in linear])
