# SPDX-License-Identifier: MIT
"""Power series with rational coefficients on 0..1, and bounds of them that hold.

S(t) = acos(1 - t)^2 / 2 = sum over k of c_k t^k, c_k = 2^k / (k^2 C(2k, k)): with t = 2 z^2, acos(1 - t) = 2 asin z, and asin^2 z =
1/2 sum (2z)^2k / (k^2 C(2k, k)). As C(2k, k) >= 4^k / (2k + 1), what is left out past k is less than tail(k)."""
import math
from fractions import Fraction

FIXED = 300  # fraction bits of a shifted series


def of_s(terms):
    """S / t."""
    return [Fraction(2**k, k * k * math.comb(2 * k, k)) for k in range(1, terms + 1)]


def of_s_derived(terms):
    return [Fraction(2**k, k * math.comb(2 * k, k)) for k in range(1, terms + 1)]


def tail(terms):
    return Fraction(3, 2**terms)


def derived(p):
    return [k * c for k, c in enumerate(p)][1:]


def add(p, q):
    size = max(len(p), len(q))
    return [a + b for a, b in zip(p + [0] * (size - len(p)), q + [0] * (size - len(q)))]


def times(p, q):
    out = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


def pieces(p, count):
    """On each of count equal parts of 0..1: the value in the middle, and how far others may be from it."""
    fixed = [(c.numerator << FIXED) // c.denominator for c in map(Fraction, p)]
    bits = (2 * count).bit_length() - 1
    for i in range(count):
        shifted = fixed[:]
        for start in range(len(shifted) - 1):  # p(x + middle) by repeated Horner; each step rounds by < 1
            for k in range(len(shifted) - 2, start - 1, -1):
                shifted[k] += shifted[k + 1] * (2 * i + 1) >> bits
        rest = sum((abs(c) >> (bits * k)) + 1 for k, c in enumerate(shifted) if k)
        yield Fraction(shifted[0], 2**FIXED), Fraction(rest, 2**FIXED) + Fraction(1, 2**(FIXED // 2))


def largest(p, count):
    return max(abs(middle) + rest for middle, rest in pieces(p, count))


def smallest(p, count):
    return min(middle - rest for middle, rest in pieces(p, count))


def log2(x):
    return math.log2(x.numerator) - math.log2(x.denominator)


def ln2():
    """Below and above."""
    value = sum(Fraction(1, k * 2**k) for k in range(1, 101))
    return value, value + Fraction(1, 2**100)


def exp_below(x):
    """Of x <= 0: 1 / e^-x, where what a partial sum of e^-x lacks is less than its last term (30 terms, -x < 17: 60)."""
    terms = [Fraction(1)]
    for k in range(1, 61):
        terms.append(terms[-1] * -x / k)
    return 1 / (sum(terms) + terms[-1])


def exp_above(x):
    """Of x <= 0."""
    terms = [Fraction(1)]
    for k in range(1, 61):
        terms.append(terms[-1] * -x / k)
    return 1 / sum(terms)
