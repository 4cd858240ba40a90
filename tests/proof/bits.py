# SPDX-License-Identifier: MIT
"""One path of a function that is run for all arguments at once: words as bits, decided by z3. A product of two unknown words is any word
between the ends of such products, so that every question is one of sums, shifts and comparisons.

What the compiled code would make poison of (nsw, nuw) is followed to where it is used, and there shown not to be."""
import subprocess

from run import Broken, Infeasible, Pointer, Run

answers, solver, sent = {}, [], []


def tell(text):
    if not solver:
        solver.append(subprocess.Popen(["z3", "-in"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True))
    solver[0].stdin.write(text)
    solver[0].stdin.flush()


def heard():
    answer = solver[0].stdout.readline().strip()
    if answer not in ("sat", "unsat", "unknown"):
        raise RuntimeError(f"z3 says {answer}")
    return {"sat": True, "unsat": False}.get(answer)


def ask(lines, condition):
    """Is there a solution of the lines with this condition? None where z3 gives up: by its own count of steps, some 1.5 million a second,
    which are the same on every machine. The lines mostly begin as those before: first z3 goes on from there, then it begins anew."""
    key = hash((tuple(lines), condition))
    if key not in answers:
        if not solver or sent != lines[:len(sent)]:
            tell("(reset)(set-option :rlimit 5000000)(set-logic QF_BV)\n")
            sent.clear()
        tell("\n".join(lines[len(sent):]) + f"\n(push)(assert {condition})(check-sat)(pop)\n")
        sent[:] = lines
        answers[key] = heard()
        if answers[key] is None:
            sent[:] = [None]
            tell("(reset)(set-option :rlimit 100000000)(set-logic QF_BV)\n" + "\n".join(lines) + f"(assert {condition})(check-sat)\n")
            answers[key] = heard()
    return answers[key]


class Word:
    """n: its number where that is known, modulo 2^width; else text: its name. poison: the name of when it is poison, or None. ends: of
    its value as a signed number, where an operation tells."""

    def __init__(self, width, n=None, text=None, poison=None):
        self.width, self.n, self.text, self.poison = width, n, text, poison
        self.ends = None

    def __str__(self):
        return self.text if self.n is None else f"(_ bv{self.n} {self.width})"


SMT = {"add": "bvadd", "sub": "bvsub", "mul": "bvmul", "and": "bvand", "or": "bvor", "xor": "bvxor", "shl": "bvshl", "lshr": "bvlshr", "ashr": "bvashr",
       "udiv": "bvudiv", "urem": "bvurem", "sdiv": "bvsdiv", "srem": "bvsrem"}


def signed(n, width):
    return n - (1 << width) if n >> (width - 1) else n


def bounded(word, low, high):
    word.ends = low, high
    return word


class Bits(Run):
    def __init__(self, functions, contracts, decisions, without_needed=False):
        self.begin(functions, contracts)
        self.decisions, self.taken, self.lines, self.count = decisions, 0, [], 0
        self.without_needed, self.products, self.proved = without_needed, {}, 0

    # ---- z3 ----

    def named(self, width, term, poison=None):
        self.count += 1
        name = f"v{self.count}"
        self.lines.append(f"(define-fun {name} () {'Bool' if width is None else f'(_ BitVec {width})'} {term})")
        return name if width is None else Word(width, None, name, poison)

    def possible(self, condition):
        return ask(self.lines, condition)

    def given_that(self, condition):
        self.lines.append(f"(assert {condition})")

    def show(self, condition, what):
        if self.possible(f"(not {condition})") is not False:
            raise Broken(what)

    def settle(self, word, what="a value that is used"):
        """It is not poison."""
        if isinstance(word, Word) and word.poison:
            self.show(f"(not {word.poison})", f"{what} may be the result of an overflow or of a shift by too much")
            word.poison = None

    def any_poison(self, *words):
        names = sorted({w.poison for w in words if w.poison})
        return None if not names else names[0] if len(names) == 1 else self.named(None, f"(or {' '.join(names)})")

    def choose(self, conditions):
        """One of several, which leave nothing out; the others become paths of their own."""
        if self.taken < len(self.decisions):
            pick = self.decisions[self.taken][0]
        else:
            pick = 0
            self.decisions.append([0, len(conditions)])
        self.taken += 1
        if self.possible(conditions[pick]) is False:
            raise Infeasible
        self.given_that(conditions[pick])
        return pick

    # ---- what run.py asks for ----

    def constant(self, word):
        return word.n if isinstance(word, Word) else None

    def number(self, width, n):
        return Word(width, n % (1 << width))

    def any(self, width, name):
        self.count += 1
        word = Word(width, None, f"{name}_{self.count}")
        self.lines.append(f"(declare-const {word} (_ BitVec {width}))")
        return word

    def branch(self, condition):
        self.settle(condition, "a condition")
        if condition.n is not None:
            return bool(condition.n)
        yes, no = f"(= {condition} #b1)", f"(= {condition} #b0)"
        may = [self.possible(c) is not False for c in (yes, no)]
        if may == [False, False]:
            raise Infeasible
        if may[0] != may[1]:
            return may[0]
        return self.choose([yes, no]) == 0

    def kept(self, word, _):
        return word

    def choice(self, word, width):
        self.settle(word, "an index")
        tried = 0
        while word.n is None:
            if tried == 70:
                raise Broken("an index that may be any of many")
            n = self.example(word)
            if n is None:
                raise Infeasible
            if self.choose([f"(= {word} {Word(width, n)})", f"(distinct {word} {Word(width, n)})"]) == 0:
                return signed(n, width)
            tried += 1
        return signed(word.n, width)

    def example(self, word):
        sent[:] = [None]
        tell("(reset)(set-logic QF_BV)\n" + "\n".join(self.lines) + f"\n(check-sat)\n(eval {word})\n")
        found, value = heard(), solver[0].stdout.readline().strip()
        return int(value[2:], 16 if value[1] == "x" else 2) if found else None

    def part(self, word, _, low, bits):
        if isinstance(word, Pointer):
            raise Broken("a part of a pointer")
        if word.n is not None:
            return self.number(bits, word.n >> low)
        return self.named(bits, f"((_ extract {low + bits - 1} {low}) {word})", word.poison)

    def of_parts(self, parts):
        if all(w.n is not None for _, w in parts):
            total, at = 0, 0
            for bits, word in parts:
                total, at = total | word.n << at, at + bits
            return self.number(at, total)
        return self.named(sum(bits for bits, _ in parts), f"(concat {' '.join(str(w) for _, w in reversed(parts))})", self.any_poison(*(w for _, w in parts)))

    def zext(self, word, width, to):
        if word.n is not None:
            return self.number(to, word.n)
        return bounded(self.named(to, f"((_ zero_extend {to - width}) {word})", word.poison), 0, (1 << width) - 1)

    def sext(self, word, width, to):
        if word.n is not None:
            return self.number(to, signed(word.n, width))
        return bounded(self.named(to, f"((_ sign_extend {to - width}) {word})", word.poison), -(1 << width - 1), (1 << width - 1) - 1)

    def trunc(self, word, width, to):
        return self.part(word, width, 0, to)

    def select(self, condition, a, b, width):
        poison = condition.poison
        if a.poison or b.poison:
            poison = self.named(None, f"(or {condition.poison or 'false'} (ite (= {condition} #b1) {a.poison or 'false'} {b.poison or 'false'}))")
        return self.named(width, f"(ite (= {condition} #b1) {a} {b})", poison)

    def compare(self, how, width, a, b):
        if a.n is not None and b.n is not None:
            x, y = (signed(w.n, width) if how[0] == "s" else w.n for w in (a, b))
            return self.number(1, {"eq": x == y, "ne": x != y, "lt": x < y, "le": x <= y, "gt": x > y, "ge": x >= y}[how if how in ("eq", "ne") else how[1:]])
        term = f"(= {a} {b})" if how == "eq" else f"(distinct {a} {b})" if how == "ne" else f"(bv{how} {a} {b})"
        return self.named(1, f"(ite {term} #b1 #b0)", self.any_poison(a, b))

    def binary(self, op, flags, width, a, b):
        if op not in SMT:
            raise Broken(f"the operation {op}")
        if op in ("udiv", "sdiv", "urem", "srem"):
            self.settle(b, "a divisor")
            self.show(f"(distinct {b} {self.number(width, 0)})", "a divisor is not 0")
        if a.n is not None and b.n is not None and op in ("add", "sub", "mul", "and", "or", "xor"):
            exact = {"add": lambda x, y: x + y, "sub": lambda x, y: x - y, "mul": lambda x, y: x * y, "and": lambda x, y: x & y, "or": lambda x, y: x | y,
                     "xor": lambda x, y: x ^ y}[op]
            half = 1 << (width - 1)
            wrong = "nsw" in flags and not -half <= exact(signed(a.n, width), signed(b.n, width)) < half or \
                "nuw" in flags and not 0 <= exact(a.n, b.n) < 2 * half
            return Word(width, exact(a.n, b.n) % (2 * half), None, "true" if wrong else self.any_poison(a, b))
        if op == "mul" and a.n is None and b.n is None:
            return self.product(flags, width, a, b)
        poison = []
        if op in ("shl", "lshr", "ashr"):
            if b.n is None:
                poison.append(self.named(None, f"(bvuge {b} {self.number(width, width)})"))
            elif b.n >= width:
                poison.append("true")
            back = {"nuw": "bvlshr", "nsw": "bvashr"}
            poison += [self.named(None, f"(distinct {a} ({back[f]} (bvshl {a} {b}) {b}))") for f in sorted(flags) if op == "shl"]
        elif op in ("add", "sub", "mul"):
            more = width if op == "mul" else 2
            for flag in sorted(flags):
                extend = f"(_ {'sign' if flag == 'nsw' else 'zero'}_extend {more})"
                poison.append(self.named(None, f"(distinct ({SMT[op]} ({extend} {a}) ({extend} {b})) ({extend} ({SMT[op]} {a} {b})))"))
        poison = self.any_poison(a, b, *(Word(1, poison=p) for p in poison))
        result = self.named(width, f"({SMT[op]} {a} {b})", poison)
        if op == "and" and b.n is not None and b.n >> (width - 1) == 0:
            bounded(result, 0, b.n)
        if op == "lshr" and b.n:
            bounded(result, 0, (1 << width - b.n) - 1)
        return result

    def product(self, flags, width, a, b):
        """Any word between the ends; where these may not fit, poison or any word at all."""
        for word in (a, b):
            self.settle(word, "a factor")
        key = (tuple(sorted((str(a), str(b)))), width, tuple(sorted(flags)))
        if key in self.products:
            return self.products[key]
        is_signed = "nuw" not in flags or "nsw" in flags
        half = 1 << width - 1
        whole = (-half, half - 1) if is_signed else (0, 2 * half - 1)

        def of(a_ends, b_ends):
            corners = [x * y for x in a_ends for y in b_ends]
            low, high = min(corners), max(corners)
            return (max(low, 0) if str(a) == str(b) else low), high, whole[0] <= low and high <= whole[1]

        low, high, fits = of(a.ends or whole, b.ends or whole)
        if not fits:
            low, high, fits = of(self.found_ends(a, is_signed), self.found_ends(b, is_signed))
        word = self.any(width, "product")
        if fits:
            less = "bvsle" if is_signed else "bvule"
            self.given_that(f"(and ({less} {self.number(width, low)} {word}) ({less} {word} {self.number(width, high)}))")
            if is_signed or high < half:
                bounded(word, low, high)
        elif flags:
            word.poison = "true"
        self.products[key] = word
        return word

    def found_ends(self, word, is_signed):
        """The least and the largest that it may be, by bisection."""
        less, width = "bvslt" if is_signed else "bvult", word.width
        low, high = (-(1 << width - 1), (1 << width - 1) - 1) if is_signed else (0, (1 << width) - 1)
        if word.ends and (is_signed or word.ends[0] >= 0):
            low, high = word.ends

        def smallest(low, high, too_small):
            """The smallest n, low .. high, that is not too small."""
            for reach in [k for k in (0, 1 << 15, 1 << 16, 1 << 30) if low <= k < high]:
                if not too_small(reach):
                    high = reach
                    break
                low = reach + 1
            while low < high:
                middle = (low + high) // 2
                low, high = (middle + 1, high) if too_small(middle) else (low, middle)
            return high

        most = smallest(low, high, lambda n: self.possible(f"({less} {self.number(width, n)} {word})") is not False)
        least = -smallest(-most, -low, lambda n: self.possible(f"({less} {word} {self.number(width, -n)})") is not False)
        return least, most

    def call_fshl(self, width, a, b, by):
        if by.n is None:
            raise Broken("a funnel shift by an unknown number of bits")
        by = by.n % width
        return self.named(width, f"((_ extract {2 * width - 1} {width}) (bvshl (concat {a} {b}) (_ bv{by} {2 * width})))", self.any_poison(a, b))

    def call_ctlz(self, width, a, _):
        if a.n is not None:
            return self.number(width, width - a.n.bit_length())
        text = str(self.number(width, width))
        for bit in range(width):
            text = f"(ite (= ((_ extract {bit} {bit}) {a}) #b1) {self.number(width, width - 1 - bit)} {text})"
        return self.named(width, text, a.poison)

    def call_usub(self, width, a, b):
        return self.named(width, f"(ite (bvult {a} {b}) {self.number(width, 0)} (bvsub {a} {b}))", self.any_poison(a, b))

    # ---- what a claim in C calls ----

    def holds(self, condition, what):
        self.settle(condition, what)
        self.proved += 1
        if condition.n != 1:
            self.show("false" if condition.n == 0 else f"(= {condition} #b1)", what)

    def taken_for_true(self, condition):
        self.settle(condition, "what is assumed")
        if condition.n is None:
            self.given_that(f"(= {condition} #b1)")
        if condition.n == 0 or self.possible("true") is False:
            raise Infeasible
