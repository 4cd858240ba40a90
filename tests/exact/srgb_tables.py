#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the tables in lib/srgb.c: the sRGB transfer function (IEC 61966-2-1) in 1/65535, to nearest.

decoded[i]: the linear value of i / 255. encoded[j]: the encoding of 2^(7 + j / 32) stepped linearly within an octave,
that is of (32 + j % 32) << (2 + j / 32), j = 0..288, where 65535 = 1.0."""
from decimal import Decimal, getcontext

getcontext().prec = 40


def decode(e):
    return e / Decimal("12.92") if e <= Decimal("0.04045") else ((e + Decimal("0.055")) / Decimal("1.055")) ** Decimal("2.4")


def encode(v):
    return v * Decimal("12.92") if v <= Decimal("0.0031308") else \
        Decimal("1.055") * v ** (1 / Decimal("2.4")) - Decimal("0.055")


def show(name, values):
    print("static const uint16_t %s[%d] = {" % (name, len(values)))
    for i in range(0, len(values), 16):
        print("    " + " ".join("%d," % v for v in values[i:i + 16]))
    print("};")


show("decoded", [round(65535 * decode(Decimal(i) / 255)) for i in range(256)])
show("encoded", [min(65535, round(65535 * encode(Decimal((32 + j % 32) << (2 + j // 32)) / 65535))) for j in range(289)])
