#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Of MSH's quotient, as compiled: what depends on the mantissa alone. Printed as C, for test_finite.c to run for every mantissa;
the rest is proved with these values unknown but for the bounds that are found there."""
import math
import re

import contracts
from library import library

NAME, MANTISSA = "msh_quotient", "%1"


def slice_of(functions):
    """Lines that depend on no other argument, and the registers that others take from them."""
    (block,) = functions[NAME][1].values()
    registers, lines, used = {MANTISSA}, [], []
    for line in block:
        target, text = (line.split(" = ", 1) + [""])[:2] if " = " in line else ("", line)
        of = re.findall(r"%\d+", text)
        if target and of and all(r in registers for r in of):
            registers.add(target)
            lines.append(line)
        else:
            used += [r for r in of if r in registers and r != MANTISSA and r not in used]
    return lines, [line.split(" = ")[0] for line in lines if line.split(" = ")[0] in used]


def root_power(j):
    """2^(64 - j / 512), rounded down: the 512th root of 2^(64 512 - j), by nine square roots, each rounded down."""
    value = 1 << (64 * 512 - j)
    for _ in range(9):
        value = math.isqrt(value)
    return value


def in_c(line):
    target, text = line.replace("%", "v").split(" = ")
    words = text.replace(",", "").split()
    op, words = words[0], [w for w in words[1:] if w not in ("nuw", "nsw", "inbounds", "exact")]
    signs = {"add": "+", "sub": "-", "mul": "*", "lshr": ">>", "shl": "<<", "and": "&", "or": "|"}
    if op in signs:
        value = f"{words[1]} {signs[op]} (uint32_t){words[2]}"
    elif op == "ashr":
        value = f"(uint32_t)((int32_t){words[1]} >> {words[2]})"
    elif op == "zext":
        value = words[1]
    elif op == "getelementptr":
        value = words[-1]
    elif op == "load":
        value = f"glint_reciprocals[{re.search(r'v[0-9]+', ' '.join(words)).group()}]"
    else:
        raise SystemExit(f"cut: {line}")
    return f"    const uint32_t {target} = {value};"


if __name__ == "__main__":
    found, taken = slice_of(library())
    for name in ("RECIPROCAL_LOW", "RECIPROCAL_HIGH", "QUOTIENT_P", "GGX_SQUARE_ERROR", "GGX_SQUARE_MOST", "FRACTION_LOW", "FRACTION_HIGH"):
        print(f"#define {name} INT64_C({getattr(contracts, name)})")
    for name in ("INVERSE_LOW", "INVERSE_HIGH"):
        print(f"#define {name} {float(getattr(contracts, name))}")
    print("/* 2^-(j / 512) in Q0.64, rounded down, j = 1..512. */")
    print("static const uint64_t root_powers[512] = {" + ", ".join(f"UINT64_C({root_power(j)})" for j in range(1, 513)) + "};")
    print("/* Printed by cut.py from what clang makes of msh_quotient: y, p. */")
    print("static inline void cut(uint32_t v1, uint32_t *y, int32_t *p)\n{")
    print("\n".join(in_c(line) for line in found))
    y, p = (r.replace("%", "v") for r in taken)
    print(f"    *y = {y};\n    *p = (int32_t){p};\n}}")
