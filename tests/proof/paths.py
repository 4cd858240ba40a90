# SPDX-License-Identifier: MIT
"""Runs a function of the library, as clang compiled it, for all arguments at once: words.py has what a value is, and what makes two
paths. A call is run the same way, or taken for what its contract says, which is then proved of it or checked by enumeration.

Where the compiled code says that a sum or product does not overflow (nsw, nuw), that is proved; and that shifts are by less than the width."""
import re
import subprocess

from poly import Poly, poly
from words import Broken, Infeasible, Words

CLANG = ["clang", "-std=c99", "-O1", "-fno-inline", "-fno-vectorize", "-fno-slp-vectorize", "-fno-unroll-loops", "-S", "-emit-llvm"]


def compiled(path, include):
    """Functions of a source by name: arguments, and blocks of lines by label."""
    run = subprocess.run([*CLANG, f"-I{include}", path, "-o", "-"], capture_output=True, text=True, check=False)
    if run.returncode:
        raise SystemExit(f"paths: clang does not compile {path}: {run.stderr.splitlines()[0]}")
    functions = {}
    for name, values in re.findall(r"^(@\w+) = .*?constant \[\d+ x i\d+\] \[(.*?)\]", run.stdout, re.M):
        functions[name] = [poly(int(v.split()[1])) for v in values.split(", ")]
    for name, body in re.findall(r"^define .*?@(\w+)\(.*?$(.*?)^}", run.stdout, re.M | re.S):
        count = re.search(rf"@{name}\((.*?)\)[^)]*{{$", run.stdout, re.M).group(1)
        arguments = re.findall(r"(i\d+)[^,]*?(%\d+)|(ptr|i32\*)[^,]*?(%\d+)", count)
        blocks, label = {}, str(len(arguments))
        for line in body.splitlines():
            line = line.split(" ;")[0].strip()
            if re.match(r"\d+:", line):
                label = line.split(":")[0]
            elif line:
                blocks.setdefault(label, []).append(re.sub(r", ![a-z.]+ !\d+", "", line))
        functions[name] = ([a[1] or a[3] for a in arguments], blocks)
    return functions


class Path(Words):
    """One path: what its calls and loops leave for the theorem."""

    def __init__(self, functions, contracts, decisions):
        super().__init__(decisions)
        self.functions, self.contracts = functions, dict(contracts)
        self.given = {}  # registers of a function that are known from elsewhere; None: not needed
        self.calls, self.squares, self.exact, self.carried = {}, [], [], []

    def run(self, name, arguments):
        if name in self.contracts:
            return self.contracts[name](self, *arguments)
        names, blocks = self.functions[name]
        return Frame(self, {**dict(zip(names, arguments)), **self.given.get(name, {})}, blocks, self.given.get(name, {})).run(next(iter(blocks)))


class Frame:
    """A call under way."""

    def __init__(self, path, values, blocks, given):
        self.path, self.values, self.blocks, self.given = path, values, blocks, given

    def value(self, text):
        text = text.strip()
        if text.startswith("%"):
            return self.values[text]
        return poly({"true": 1, "false": 0}.get(text) if text in ("true", "false") else int(text))

    def run(self, label):
        before = None
        while True:
            phis = {}
            for line in self.blocks[label]:
                found = re.match(r"(%\d+) = phi i\d+ (.*)", line)
                if found:
                    for value, source in re.findall(r"\[ (\S+), %(\d+) \]", found.group(2)):
                        if source == before:
                            phis[found.group(1)] = self.value(value)
            self.values.update(phis)
            self.path.carried.extend(v for v in phis.values() if isinstance(v, Poly) and v.constant() is None)
            for line in self.blocks[label]:
                if " = phi " in line:
                    continue
                if line.startswith("ret"):
                    return None if line == "ret void" else self.value(line.split()[-1])
                if line.startswith("br label"):
                    before, label = label, line.split("%")[1]
                    break
                found = re.match(r"br i1 (\S+), label %(\d+), label %(\d+)", line)
                if found:
                    before, label = label, found.group(2 if self.value(found.group(1)).constant() else 3)
                    break
                self.step(line)
            else:
                raise Broken(f"a block that ends in {line}")

    def step(self, line):
        found = re.match(r"(?:(%\d+) = )?(?:tail )?(\w+) (.*)", line)
        target, op, rest = found.groups()
        if target in self.given:
            return
        if op == "call":
            result = self.call(rest)
        elif op == "store":
            a, b = re.match(r"i\d+ (\S+), i\d+\* (\S+),", rest).groups()
            array, offset = self.values[b]
            array[offset] = self.path.word(self.value(a), 32)
            return
        else:
            result = getattr(self, "op_" + op, self.arithmetic)(op, rest)
        if target:
            self.values[target] = result

    def call(self, rest):
        name, arguments = re.search(r"@([\w.]+)\((.*)\)", rest).groups()
        if name.startswith("llvm.lifetime"):
            return None
        values = []
        for argument in arguments.split(", "):
            value = self.value(argument.split()[-1])
            kind = re.match(r"i(\d+)\b(?!\*)", argument)
            values.append(value if not kind else self.path.word(value, int(kind.group(1))))
        if name.startswith("llvm.umin"):
            return values[0] if self.path.is_true(values[1] - values[0]) else values[1]
        if name.startswith("llvm.fshl"):
            return self.path.joined(self.path.word(values[0] * (1 << values[2].constant()), 32),
                                    self.path.shifted(values[1], 32 - values[2].constant()))
        return self.path.run(name, values)

    def op_alloca(self, _, __):
        return ({}, 0)

    def op_bitcast(self, _, rest):
        return self.values.get(re.search(r"(%\d+) to", rest).group(1))

    def op_getelementptr(self, _, rest):
        base, index = re.match(r".*\* (?:noundef )?([%@]\w+), .*?i64 (?:0, i64 )?(\S+)$", rest).groups()
        array, offset = self.values[base] if base[0] == "%" else (self.path.functions[base], 0)
        return (array, offset + self.value(index).constant())

    def op_load(self, _, rest):
        array, offset = self.values[re.search(r"\* (%\d+)", rest).group(1)]
        return array[offset]

    def op_zext(self, _, rest):
        width, value = re.match(r"i(\d+) (\S+) to", rest).groups()
        return self.path.word(self.value(value), int(width))

    def op_sext(self, _, rest):
        width, value = re.match(r"i(\d+) (\S+) to", rest).groups()
        return self.path.word(self.value(value), int(width), signed=True)

    def op_trunc(self, _, rest):
        value, width = re.match(r"i\d+ (\S+) to i(\d+)", rest).groups()
        return self.path.reduced(self.value(value), int(width))

    def op_select(self, _, rest):
        condition, a, b = re.match(r"i1 (\S+), i\d+ (\S+), i\d+ (\S+)", rest).groups()
        return self.value(a if self.value(condition).constant() else b)

    def op_icmp(self, _, rest):
        how, width, a, b = re.match(r"(\w+) i(\d+) (\S+), (\S+)", rest).groups()
        if isinstance(self.values.get(a), tuple):
            return self.differ_only_below(self.values[a], how, self.value(b).constant())
        a, b = (self.path.word(self.value(v), int(width), how[0] == "s") for v in (a, b))
        if how in ("eq", "ne"):
            below, above = self.path.facts.decided(a - b - 1), self.path.facts.decided(b - a - 1)
            same = a.key() == b.key() or (below is not True and above is not True and
                                          self.path.choose([[a - b, b - a], [a - b - 1], [b - a - 1]]) == 0)
            return poly(int(same == (how == "eq")))
        low, high = (a, b) if how[1] == "l" else (b, a)
        return poly(int(self.path.is_true(high - low - how.endswith("t"))))

    def op_xor(self, _, rest):
        width, a, b = re.match(r"i(\d+) (\S+), (\S+)", rest).groups()
        if int(width) == 1:
            return poly(self.value(a).constant() % 2 ^ self.value(b).constant() % 2)
        words = tuple(self.path.word(self.value(v), int(width)) for v in (a, b))
        numbers = [w.constant() for w in words]
        return words if None in numbers else poly(numbers[0] ^ numbers[1])

    def differ_only_below(self, words, how, limit):
        """a ^ b < 2^k: their quotients by 2^k are the same."""
        if how != "ult" or limit & (limit - 1):
            raise Broken("a comparison of an exclusive or that is not with a power of two")
        a, b = (self.path.shifted(w, limit.bit_length() - 1) for w in words)
        return poly(int(self.path.choose([[a - b, b - a], [a - b - 1], [b - a - 1]]) == 0))

    def arithmetic(self, op, rest):
        flags, width, a, b = re.match(r"((?:nuw |nsw |exact )*)i(\d+) (\S+), (\S+)", rest).groups()
        width, a, b, path = int(width), self.value(a), self.value(b), self.path
        if width == 1:
            a, b = a.constant() % 2, b.constant() % 2
            return poly({"and": a & b, "or": a | b, "xor": a ^ b}[op])
        if op in ("lshr", "ashr"):
            return path.shifted(path.word(a, width, op == "ashr"), self.amount(b, width))
        if op == "and":
            a, b = (a, b) if b.constant() is not None else (b, a)
            mask = b.constant() % (1 << width)
            if a.constant() is not None:
                return poly(a.constant() & mask)
            return path.rest(a, mask.bit_length()) if mask & (mask + 1) == 0 else path.masked(path.word(a, width), mask)
        if op == "or":
            return path.joined(path.word(a, width), path.word(b, width))
        if op == "udiv":
            return self.quotient(path.word(a, width), path.word(b, width))
        for flag, signed in (("nuw", False), ("nsw", True)):
            if flag in flags:
                a, b = path.word(a, width, signed), path.word(b, width, signed and op != "shl")
        if op == "shl":
            op, b = "mul", poly(1 << self.amount(b, width))
        result = {"add": lambda: a + b, "sub": lambda: a - b, "mul": lambda: a * b}[op]()
        for flag, signed in (("nuw", False), ("nsw", True)):
            if flag in flags:
                bottom = -(1 << (width - 1)) if signed else 0
                path.prove(result - bottom, f"{op} {rest} does not overflow downwards")
                path.prove(bottom + (1 << width) - 1 - result, f"{op} {rest} does not overflow")
        return result

    def amount(self, b, width):
        bits = self.path.word(b, width).constant()
        if bits is None:
            word = self.path.word(b, width)
            low, high = self.path.facts.interval(word)
            if low >= 0 and high < min(width, 33):
                bits = low + self.path.choose([[word - k, k - word] for k in range(low, high + 1)])
        if bits is None or bits >= width:
            raise Broken(f"a shift by {'an unknown number of' if bits is None else bits} bits")
        return bits

    def quotient(self, a, b):
        self.path.prove(b - 1, "a divisor is not 0")
        q = self.path.facts.atom("quotient", 0, self.path.facts.interval(a)[1])
        self.path.facts.add(a - q * b)
        self.path.facts.add(q * b + b - 1 - a)
        return q


def paths(functions, contracts, theorem):
    """Calls theorem(path) for every path; returns how many can be taken. Broken where it does not hold, or none can: from facts that
    contradict each other anything follows."""
    decisions, count = [], 0
    while True:
        path = Path(functions, contracts, decisions)
        try:
            theorem(path)
            count += path.facts.possible([])
        except Infeasible:
            pass
        while decisions and decisions[-1][0] + 1 == decisions[-1][1]:
            decisions.pop()
        if not decisions and not count:
            raise Broken("no path can be taken")
        if not decisions:
            return count
        decisions[-1][0] += 1
