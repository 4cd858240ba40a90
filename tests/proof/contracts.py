# SPDX-License-Identifier: MIT
"""What is said of the library's functions: of each a contract, which its callers' proofs use, and its own proof by paths.py.
ENUMERATED ones are checked by test_finite.c, which takes these numbers from finite.h."""
from fractions import Fraction

from poly import poly

WORD = 1 << 32
ONE = 1 << 30  # t = 1
# 2^58 / m times 1 + d: d in 2^-30 (-16.1 .. 16.4)
RECIPROCAL_LOW, RECIPROCAL_HIGH = int(Fraction("16.1") * 2**28), int(Fraction("16.4") * 2**28)


class Contract:
    """limits: of the arguments. before(*args): what a caller must show. after(*args, result): what it then knows (a result that it
    computes itself: exact). result: its ends."""

    def __init__(self, name, limits, result=None, before=None, after=None, exact=None):
        self.name, self.limits, self.result = name, limits, result
        self.before, self.after, self.exact = before or (lambda *_: []), after or (lambda *_: []), exact

    def __call__(self, path, *arguments):
        for value, (low, high) in zip(arguments, self.limits):
            path.prove(value - low, f"{self.name}: an argument is at least {low}")
            path.prove(high - value, f"{self.name}: an argument is at most {high}")
        for fact in self.before(*arguments):
            path.prove(fact, f"{self.name}: what it asks of its arguments")
        if self.exact:
            path.exact.append(arguments)
            return self.exact(*arguments)
        result = path.facts.atom(self.name, *self.result)
        for fact in self.after(*arguments, result):
            path.facts.add(fact)
        path.calls[self.name] = (*arguments, result)
        if self.name == "glint_squarehi_near":
            path.squares.append((*arguments, result))
        return result

    def holds(self, path, arguments):
        """Its proof on one path."""
        for fact in self.before(*arguments):
            path.facts.add(fact)
        result = path.run(self.name, arguments)
        if self.exact:
            true = self.exact(*arguments)
            goals = [result - true, true - result]
        else:
            result = path.word(result, 32 if self.result[1] < WORD else 64)
            goals = [result - self.result[0], self.result[1] - result, *self.after(*arguments, result)]
        for goal in goals:
            path.prove(goal, f"{self.name}: what it promises")


def low_by_less(count, product, result, step=WORD):
    """result = product / step, low by 0 .. < count."""
    return [product - result * step, result * step + count * step - 1 - product]


U32 = (0, WORD - 1)
U64 = (0, WORD * WORD - 1)
MULHI = Contract("glint_mulhi_near", [U32, U32], U32, after=lambda a, b, r: low_by_less(3, a * b, r))
SQUAREHI = Contract("glint_squarehi_near", [U32], U32, after=lambda a, r: low_by_less(2, a * a, r))
MULTIPLY = Contract("glint_multiply", [U32, U32], exact=lambda a, b: a * b)
MULHI64 = Contract("mulhi", [U64, U64], U64, after=lambda a, b, r: low_by_less(1, a * b, r, WORD * WORD))
CLAMP_N = Contract("glint_clamp_n", [(1, 1000)], exact=lambda n: n)
# Enumerated.
RECIPROCAL = Contract("glint_reciprocal", [(1 << 27, (1 << 28) - 1)], (1 << 29, (1 << 31) + 15), after=lambda m, y:
                      [2**58 + RECIPROCAL_HIGH - (m + 1) * y, m * y - 2**58 + RECIPROCAL_LOW])

# ---- Schlick ----

SCHLICK_LOW, SCHLICK_HIGH = 6, 5


def schlick_ratio(n, t):
    """F = u / d."""
    return ONE - t, ONE + (n - 1) * t


def schlick_after(n, t, f):
    u, d = schlick_ratio(n, t)
    return [2**28 * u - (f - SCHLICK_HIGH) * d - 1, (f + SCHLICK_LOW) * d - 2**28 * u - 1]


SCHLICK_NEAR = Contract("schlick_near_t", [(1, 1000), (1, ONE - 1)], (0, 2**28 + 4), after=schlick_after)


# ---- Cayley, n > 4 ----

CAYLEY_LOW, CAYLEY_HIGH = 21, 17


def cayley_ratio(n, t):
    """F = (p / s)^4."""
    return 2**33 - (n + 4) * t, 2**33 + (n - 4) * t


# ---- MSH ----

QUOTIENT_ERROR = 2400
QUOTIENT_P = 19300  # |p|
INVERSE_LOW, INVERSE_HIGH = Fraction("2.2"), Fraction(2)  # of unit_inverse, in units of its result
QUOTIENT_DOMAIN = WORD - 6000  # 2^62 u / m^2 is at most this: the sums stay within 32 bits
MSH_QUOTIENT = Contract("msh_quotient", [(0, 2**24), (1 << 27, (1 << 28) - 1)], (0, 1720000000),
                        before=lambda u, m: [QUOTIENT_DOMAIN * m * m - 2**62 * u],
                        after=lambda u, m, q: [2**63 * u - 5 * m * m * (q - QUOTIENT_ERROR), 5 * m * m * (q + QUOTIENT_ERROR) - 2**63 * u])

# ---- GGX ----

GGX_SQUARE_ERROR, GGX_SQUARE_MOST = 2220, 2**31 + 2220
# Enumerated.
GGX_SQUARE = Contract("ggx_square", [(1 << 27, (1 << 28) - 1)], (0, GGX_SQUARE_MOST),
                      after=lambda m, f: [2**85 + GGX_SQUARE_ERROR * m * m - f * m * m - 1, f * m * m + GGX_SQUARE_ERROR * m * m - 2**85 - 1])

# ---- Gauss ----

FRACTION_LOW, FRACTION_HIGH = 34, 24  # of glint_exp2_near, in 2^-32 of its value


def rounds(value, over, result):
    """result = value / over to nearest, ties up: (2 result - 1) over <= 2 value < (2 result + 1) over."""
    return [2 * value - (2 * result - 1) * over, (2 * result + 1) * over - 2 * value - 1]


def rounds_or_less(value, over, result):
    """value / over to nearest is result or 1 more."""
    return [rounds(value, over, result)[0], rounds(value, over, result + 1)[1]]


def quick_is(near, high, f, shift=12):
    """f = (near + 2^(shift - 1) - high) / 2^shift, rounded down."""
    from_below = near + 2**(shift - 1) - high - 2**shift * f
    return [from_below, 2**shift - 1 - from_below]
