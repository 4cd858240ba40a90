# SPDX-License-Identifier: MIT
"""One path of a function that is run for all arguments at once: its facts, the decisions that lead to it, and machine words as polynomials.

A value is a polynomial congruent to its word modulo 2^width; a shift adds its quotient as an atom; a comparison that the facts leave
open is a decision."""
from poly import Facts, Poly, poly


class Broken(Exception):
    """A proof that does not go through: what, where."""


class Infeasible(Exception):
    """A path that nothing takes."""


class Words:
    """The facts of one path, and the decisions that lead to it."""

    def __init__(self, decisions):
        self.facts, self.decisions, self.taken = Facts(), decisions, 0
        self.quotients, self.origins, self.rests, self.definitions = {}, {}, {}, []

    def choose(self, options):
        """One of several lists of facts, which between them leave nothing out; the others become paths of their own."""
        open_ = [o for o in options if all(self.facts.decided(f) is not False for f in o)]
        if len(open_) > 1:
            open_ = [o for o in open_ if self.facts.possible(o)]
        if not open_:
            raise Infeasible
        pick = 0
        if len(open_) > 1:
            if self.taken == len(self.decisions):
                self.decisions.append([0, len(open_)])
            pick = self.decisions[self.taken][0]
            self.taken += 1
        for fact in open_[pick]:
            self.facts.add(fact)
        return options.index(open_[pick])

    def is_true(self, p):
        """p >= 0?"""
        known = self.facts.decided(p)
        return known if known is not None else self.choose([[p], [-p - 1]]) == 0

    def prove(self, goal, what):
        goal = poly(goal)
        if not any(self.facts.follows(p, sort) for p, sort in ((goal, ["Real"]), (self.expanded(goal), ["Real"]), (goal, ["Int"]))):
            raise Broken(what)

    def expanded(self, p):
        """With the definitions of rests in their places."""
        for atom, rest in self.definitions:
            p = sum((rest**m.count(atom) * Poly({tuple(a for a in m if a != atom): c}) for m, c in p.terms.items()), poly(0))
        return p

    def same(self, a, b, what):
        self.prove(a - b, what)
        self.prove(b - a, what)

    def squared(self, a, b, what):
        """From a = b follows a^2 = b^2."""
        self.same(a, b, what)
        self.facts.add(a * a - b * b)
        self.facts.add(b * b - a * a)

    def times(self, *factors):
        """Adds the product of numbers that are at least 0."""
        product = poly(1)
        for factor in factors:
            self.prove(factor, "a factor of a product")
            product = product * factor
        self.facts.add(product)

    def divide(self, fact, factor):
        """fact >= 0, since its product with a number of at least 1 is."""
        self.prove(factor - 1, "a divisor of a fact is positive")
        self.prove(fact * factor, "a fact, multiplied")
        self.facts.add(fact)

    # ---- words ----

    def reduced(self, p, width):
        """Congruent modulo 2^width, with coefficients of the smallest size."""
        top = 1 << width
        return Poly({m: c if -top < c < top else (c + top // 2) % top - top // 2 for m, c in p.terms.items()})

    def word(self, p, width, signed=False):
        """The value of a word itself."""
        bottom = -(1 << (width - 1)) if signed else 0
        top = bottom + (1 << width)
        for q in (p, self.reduced(p, width)):
            low, high = self.facts.interval(q)
            if low >= bottom and high < top:
                return q
        p = self.reduced(p, width)
        low, high = self.facts.interval(p)
        first, last = (low - bottom) >> width, (high - bottom) >> width
        if last - first > 3:
            if self.facts.follows(p - bottom) and self.facts.follows(top - 1 - p):
                return p
            return self.rest(p - bottom, width) + bottom
        turns = list(range(first, last + 1))
        chosen = self.choose([[p - (k << width) - bottom, top - 1 - p + (k << width)] for k in turns])
        return p - (turns[chosen] << width)

    def shifted(self, p, bits):
        """p / 2^bits, rounded down."""
        if bits == 0:
            return p
        while bits and p.terms and all(c % 2 == 0 for c in p.terms.values()):
            p, bits = Poly({m: c // 2 for m, c in p.terms.items()}), bits - 1
        if bits == 0:
            return p
        inner = (p - p.terms.get((), 0)).key()
        if inner in self.origins:  # (x / 2^a + k) / 2^b = (x + k 2^a) / 2^(a + b), each rounded down
            x, a = self.origins[inner]
            return self.shifted(x + (p.terms.get((), 0) << a), a + bits)
        step = 1 << bits
        whole = Poly({m: c // step for m, c in p.terms.items() if c % step == 0})
        rest = p - whole * step
        low, high = self.facts.interval(rest)
        if low >> bits == high >> bits:
            return whole + (low >> bits)
        key = (rest.key(), bits)
        if key not in self.quotients and whole.terms and \
                self.facts.follows(rest) and self.facts.follows(step - 1 - rest):
            self.quotients[key] = poly(0)
        if key not in self.quotients:
            q = self.quotients[key] = self.facts.atom("quotient", low >> bits, high >> bits)
            self.origins[q.key()] = (rest, bits)
            self.facts.add(rest - q * step)
            self.facts.add(q * step + step - 1 - rest)
        return whole + self.quotients[key]

    def masked(self, p, mask):
        if mask == 0:
            return poly(0)
        low = (mask & -mask).bit_length() - 1
        bits = (mask >> low).bit_length()
        if mask >> low != (1 << bits) - 1:
            raise Broken(f"a mask of several pieces: {mask:#x}")
        p = self.shifted(p, low)
        return self.rest(p, bits) * (1 << low)

    def rest(self, p, bits):
        """p modulo 2^bits; an atom where an interval of its terms would not show that."""
        zeros = 0
        while zeros < bits and p.terms and all(c % (2 << zeros) == 0 for c in p.terms.values()):
            zeros += 1
        if zeros:
            return self.rest(Poly({m: c >> zeros for m, c in p.terms.items()}), bits - zeros) * (1 << zeros)
        q = self.shifted(p, bits)
        rest = p - q * (1 << bits)
        low, high = self.facts.interval(rest)
        if low >= 0 and high < 1 << bits:
            return rest
        if rest.key() not in self.rests:
            atom = self.rests[rest.key()] = self.facts.atom("rest", 0, (1 << bits) - 1)
            self.facts.add(rest - atom)
            self.facts.add(atom - rest)
            self.definitions.insert(0, (next(iter(atom.terms))[0], rest))
        return self.rests[rest.key()]

    def joined(self, a, b):
        """a | b, where no bit is set in both."""
        for x, y in ((a, b), (b, a)):
            if x.constant() == 0:
                return y
            bits = min((c & -c).bit_length() - 1 for c in x.terms.values())
            if bits and self.facts.follows(y) and self.facts.follows((1 << bits) - 1 - y):
                return x + y
        raise Broken("an or of numbers that may share bits")
