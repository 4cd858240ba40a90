# SPDX-License-Identifier: MIT
"""Polynomials with integer coefficients over atoms, and what follows from inequalities between them.

An atom is an unknown integer with bounds. A fact is a polynomial that is at least 0. A goal follows from facts where z3 finds no
values for the monomials (each an integer of its own, between its interval's ends) that hold the facts and break the goal: a
product of unknowns is nothing but a number to z3, so every question is linear; products of facts are facts that a caller adds."""
import itertools
import math
import subprocess

answers, solver = {}, []


class Poly:
    def __init__(self, terms):
        self.terms = {m: c for m, c in terms.items() if c}

    def __add__(self, other):
        terms = dict(self.terms)
        for m, c in poly(other).terms.items():
            terms[m] = terms.get(m, 0) + c
        return Poly(terms)

    def __mul__(self, other):
        terms = {}
        for (m, c), (k, d) in itertools.product(self.terms.items(), poly(other).terms.items()):
            both = tuple(sorted(m + k))
            terms[both] = terms.get(both, 0) + c * d
        return Poly(terms)

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + -poly(other)

    def __rsub__(self, other):
        return poly(other) - self

    __radd__ = __add__
    __rmul__ = __mul__

    def __pow__(self, k):
        return poly(1) if k == 0 else self * self ** (k - 1)

    def key(self):
        return tuple(sorted(self.terms.items()))

    def constant(self):
        """Its value where it has no atom, else None."""
        return self.terms.get((), 0) if not set(self.terms) - {()} else None


def poly(value):
    return value if isinstance(value, Poly) else Poly({(): value})


class Facts:
    """Atoms, their bounds, and facts."""

    def __init__(self):
        self.low, self.high, self.known, self.names = [], [], [], []

    def atom(self, name, low, high):
        self.low.append(low)
        self.high.append(high)
        self.names.append(name)
        return Poly({(len(self.low) - 1,): 1})

    def add(self, fact):
        self.known.append(poly(fact))

    def of_monomial(self, monomial):
        low = high = 1
        for atom, power in ((a, monomial.count(a)) for a in sorted(set(monomial))):
            a, b = self.low[atom] ** power, self.high[atom] ** power
            if power % 2 == 0 and self.low[atom] < 0:
                a, b = (0 if self.high[atom] >= 0 else min(a, b)), max(a, b)
            ends = [low * a, low * b, high * a, high * b]
            low, high = min(ends), max(ends)
        return low, high

    def interval(self, p):
        low = high = 0
        for m, c in p.terms.items():
            a, b = self.of_monomial(m)
            low += c * (a if c > 0 else b)
            high += c * (b if c > 0 else a)
        return low, high

    def decided(self, p):
        """True where p >= 0 always, False where p < 0 always, None where intervals do not tell."""
        low, high = self.interval(p)
        return True if low >= 0 else False if high < 0 else None

    def possible(self, extra, sorts=("Real",)):
        """May all facts and these hold? (What z3 does not refute may.)"""
        facts = [f for f in self.known + extra if f.terms]
        monomials = sorted({m for f in facts for m in f.terms if m})
        name = {m: f"m{i}" for i, m in enumerate(monomials)}

        def number(c):
            return str(c) if c >= 0 else f"(- {-c})"

        def text(p):
            parts = [number(c) if m == () else f"(* {number(c)} {name[m]})" for m, c in sorted(p.terms.items())]
            return f"(+ 0 {' '.join(parts)})"

        bounds = [f"(assert (<= {number(low)} {name[m]} {number(high)}))" for m in monomials for low, high in [self.of_monomial(m)]]
        body = "\n".join(bounds + [f"(assert (>= {text(f)} 0))" for f in facts])
        return not any(unsatisfiable(sort, list(name.values()), body) for sort in sorts)

    def follows(self, goal, sorts=("Real",)):
        """goal >= 0, from the facts."""
        goal = poly(goal)
        known = self.decided(goal)
        return known if known is not None else not self.possible([tightened(-goal - 1)], sorts)


def tightened(p):
    """p >= 0 is g h + c >= 0 with whole h: h is at least -c / g rounded up."""
    c, g = p.terms.get((), 0), math.gcd(*(c for m, c in p.terms.items() if m))
    return p - c % g if g else p


def unsatisfiable(sort, names, body):
    """Over the reals first: quick, and nearly always enough."""
    key = (sort, body)
    if key not in answers:
        query = [f"(reset)(set-option :rlimit 20000000)(set-logic QF_L{sort[0]}A)"]
        query += [f"(declare-const {name} {sort})" for name in names] + [body, "(check-sat)", ""]
        if not solver:
            solver.append(subprocess.Popen(["z3", "-in"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True))
        solver[0].stdin.write("\n".join(query))
        solver[0].stdin.flush()
        answers[key] = solver[0].stdout.readline().strip() == "unsat"
    return answers[key]
