# SPDX-License-Identifier: MIT
"""One path of a function that is run for all arguments at once: its facts, the decisions that lead to it, and machine words as polynomials.

A value is a polynomial congruent to its word modulo 2^width; a shift adds its quotient as an atom; a comparison that the facts leave
open is a decision."""
from poly import Facts, Poly, poly
from run import Broken, Infeasible, Pointer


class Words:
    """The facts of one path, and the decisions that lead to it."""

    def __init__(self, decisions):
        self.facts, self.decisions, self.taken = Facts(), decisions, 0
        self.quotients, self.floors, self.origins, self.rests, self.definitions = {}, {}, {}, {}, []

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
        for atom, rest in self.definitions:
            if p.terms == {(atom,): 1}:  # the rest of a rest
                return self.rest(Poly({m: c for m, c in rest.terms.items() if c % (1 << bits)}), bits)
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

    # ---- what run.py asks for ----

    def constant(self, p):
        return p.constant()

    def number(self, _, n):
        return poly(n)

    def any(self, width, name):
        return self.facts.atom(name, 0, (1 << width) - 1)

    def branch(self, condition):
        return bool(condition.constant() % 2)

    def kept(self, p, width):
        return self.word(p, width)

    def choice(self, p, width):
        """A number where it is known, or one of a few, each a path of its own."""
        p = self.word(p, width, True)
        if p.constant() is not None:
            return p.constant()
        low, high = self.facts.interval(p)
        if high - low > 64:
            raise Broken("an index that may be any of many")
        return low + self.choose([[p - k, k - p] for k in range(low, high + 1)])

    def part(self, p, width, low, bits):
        if isinstance(p, Pointer):
            raise Broken("a part of a pointer")
        p = self.shifted(self.word(p, width), low)
        return p if low + bits == width else self.rest(p, bits)

    def of_parts(self, parts):
        total, at = poly(0), 0
        for bits, value in parts:
            total, at = total + self.word(value, bits) * (1 << at), at + bits
        return total

    def zext(self, p, width, _):
        return self.word(p, width)

    def sext(self, p, width, _):
        return self.word(p, width, True)

    def trunc(self, p, _, width):
        return self.reduced(p, width)

    def compare(self, how, width, a, b):
        if isinstance(a, tuple):
            return self.differ_only_below(a, how, b.constant())
        a, b = (self.word(v, width, how[0] == "s") for v in (a, b))
        if how in ("eq", "ne"):
            below, above = self.facts.decided(a - b - 1), self.facts.decided(b - a - 1)
            same = a.key() == b.key() or (below is not True and above is not True and
                                          self.choose([[a - b, b - a], [a - b - 1], [b - a - 1]]) == 0)
            return poly(int(same == (how == "eq")))
        low, high = (a, b) if how[1] == "l" else (b, a)
        return poly(int(self.is_true(high - low - how.endswith("t"))))

    def differ_only_below(self, words, how, limit):
        """a ^ b < 2^k: their quotients by 2^k are the same."""
        if how != "ult" or limit & (limit - 1):
            raise Broken("a comparison of an exclusive or that is not with a power of two")
        a, b = (self.shifted(w, limit.bit_length() - 1) for w in words)
        return poly(int(self.choose([[a - b, b - a], [a - b - 1], [b - a - 1]]) == 0))

    def exclusive(self, width, a, b):
        """a ^ b: of numbers; of a sign, 0 or -1, and a word; else both, for what compares it with a power of two."""
        words = [self.word(v, width) for v in (a, b)]
        numbers = [w.constant() for w in words]
        if None not in numbers:
            return poly(numbers[0] ^ numbers[1])
        for sign, other in ((a, b), (b, a)):
            sign = self.word(sign, width, True)
            low, high = self.facts.interval(sign)
            if -1 <= low and high <= 0:
                is_zero = sign.constant() == 0 or sign.constant() is None and self.choose([[sign], [-1 - sign]]) == 0
                return other if is_zero else -1 - other
        return tuple(words)

    def binary(self, op, flags, width, a, b):
        if width == 1:
            a, b = a.constant() % 2, b.constant() % 2
            return poly({"and": a & b, "or": a | b, "xor": a ^ b}[op])
        if op == "xor":
            return self.exclusive(width, a, b)
        if op in ("lshr", "ashr"):
            return self.shifted(self.word(a, width, op == "ashr"), self.amount(b, width))
        if op == "and":
            a, b = (a, b) if b.constant() is not None else (b, a)
            if b.constant() is None:
                raise Broken("an and of two words")
            mask = b.constant() % (1 << width)
            if a.constant() is not None:
                return poly(a.constant() & mask)
            return self.rest(a, mask.bit_length()) if mask & (mask + 1) == 0 else self.masked(self.word(a, width), mask)
        if op == "or":
            return self.joined(self.word(a, width), self.word(b, width))
        if op in ("udiv", "sdiv"):
            return self.quotient(*(self.word(v, width, op == "sdiv") for v in (a, b)))
        if op == "urem":
            a, b = self.word(a, width), self.word(b, width)
            return a - self.quotient(a, b) * b
        if op not in ("add", "sub", "mul", "shl"):
            raise Broken(f"the operation {op}")
        for flag, signed in (("nuw", False), ("nsw", True)):
            if flag in flags:
                a, b = self.word(a, width, signed), self.word(b, width, signed and op != "shl")
        if op == "shl":
            op, b = "mul", poly(1 << self.amount(b, width))
        result = {"add": lambda: a + b, "sub": lambda: a - b, "mul": lambda: a * b}[op]()
        for flag, signed in (("nuw", False), ("nsw", True)):
            if flag in flags:
                bottom = -(1 << (width - 1)) if signed else 0
                self.prove(result - bottom, f"{op} {a.key()} {b.key()} does not overflow downwards")
                self.prove(bottom + (1 << width) - 1 - result, f"{op} {a.key()} {b.key()} does not overflow")
        return result

    def amount(self, b, width):
        bits = self.word(b, width).constant()
        if bits is None:
            word = self.word(b, width)
            low, high = self.facts.interval(word)
            if low >= 0 and high < min(width, 65):
                bits = low + self.choose([[word - k, k - word] for k in range(low, high + 1)])
        if bits is None or bits >= width:
            raise Broken(f"a shift by {'an unknown number of' if bits is None else bits} bits")
        return bits

    def quotient(self, a, b):
        """a / b towards 0, where b is at least 1."""
        self.prove(b - 1, "a divisor is above 0")
        if a.constant() is not None and b.constant() is not None:
            return poly(abs(a.constant()) // b.constant() * (1 if a.constant() >= 0 else -1))
        if self.is_true(a):
            return self.floor(a, b)
        return -self.floor(-a, b)

    def floor(self, a, b):
        """As quotient, of an a of at least 0; the same one for the same numbers."""
        key = a.key(), b.key()
        if key not in self.floors:
            q = self.floors[key] = self.facts.atom("quotient", 0, self.facts.interval(a)[1] // max(self.facts.interval(b)[0], 1))
            self.facts.add(a - q * b)
            self.facts.add(q * b + b - 1 - a)
        return self.floors[key]

    def call_fshl(self, width, a, b, by):
        return self.joined(self.word(a * (1 << by.constant()), width), self.shifted(b, width - by.constant()))

    def call_ctlz(self, width, a, _):
        """Zero bits above the highest, each a path of its own."""
        word = self.word(a, width)
        return poly(width - self.choose([[-word], *([word - (1 << k), (2 << k) - 1 - word] for k in range(width))]))
