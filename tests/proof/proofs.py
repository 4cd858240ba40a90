# SPDX-License-Identifier: MIT
"""What the proofs share: their list, their arguments, the step from a bound to a rounded value. Usage of each: [FOLDER [WORD]]: of the
sources in FOLDER, those proofs that have WORD in their names. TAP."""
import subprocess
import sys
import traceback

from contracts import ONE
from paths import Broken, compiled, paths

ROOT = __file__.rsplit("/", 3)[0] if len(sys.argv) < 2 else sys.argv[1]
counts = {"number": 0, "failed": 0}


def source(name):
    return compiled(f"{ROOT}/lib/{name}", f"{ROOT}/lib")


def result(name, proof):
    if len(sys.argv) > 2 and sys.argv[2] not in name:
        return
    counts["number"] += 1
    try:
        count = proof()
        print(f"ok {counts['number']} - {name}" + (f" ({count} paths)" if count else ""), flush=True)
    except Broken as what:
        counts["failed"] += 1
        print(f"not ok {counts['number']} - {name}\n# {what}", flush=True)
    except Exception:
        counts["failed"] += 1
        print(f"not ok {counts['number']} - {name}\n# " + traceback.format_exc().replace("\n", "\n# "), flush=True)


def known(*contracts):
    return {c.name: c for c in contracts}


def halves(path, name, half=1 << 16, above=None):
    return path.facts.atom(name + "_high", 0, (above or half) - 1) * half + path.facts.atom(name + "_low", 0, half - 1)


def atoms(contract):
    return lambda path: [path.facts.atom(f"a{i}", *limit) for i, limit in enumerate(contract.limits)]


def keeps(functions, contract, uses=(), arguments=None):
    return lambda: paths(functions, known(*uses), lambda path: contract.holds(path, (arguments or atoms(contract))(path)))


def end():
    print(f"1..{counts['number']}")
    sys.exit(counts["failed"] != 0)


def decided_by_bounds(path, near, f, over, low, high):
    """Where both ends round to f: that, times what F is a fraction over."""
    ends = [near + 2048 - high - 4096 * f, 4096 * f + 4095 - near - 2048 - low]
    if all(path.facts.follows(e) for e in ends):
        for end in ends:
            path.times(end, over)


def exponent_of(path, x, m):
    """The k with m = x / 2^k, rounded down."""
    for k in range(16):
        if path.facts.follows(x - m * 2**k) and path.facts.follows((m + 1) * 2**k - 1 - x):
            return k
    raise Broken("a mantissa is not its number, shifted")


def n_and_t(path, first=1, bits=14):
    """n in first .. 1000, 0 < t < 1, in the pieces that the code takes."""
    n = path.facts.atom("n", 0, 1000 - first) + first
    t = halves(path, "t", 1 << bits, ONE >> bits)
    path.facts.add(t - 1)
    return n, t


def round_of_candidates(path, near, value, over, low, high):
    """What is known of both candidates, times what F is a fraction over."""
    below, above = path.shifted(near + 2048 - high, 12), path.shifted(near + 2048 + low, 12)
    for fact in (near + 2048 - high - 4096 * below, 4096 * above + 4095 - near - 2048 - low):
        path.times(fact, over)
    step = 0 if path.facts.follows(below - above) else 1
    path.same(above, below + step, "the candidates are the same or one apart")
    path.facts.add((above - below - step) * over)
    path.facts.add((below + step - above) * over)


def refuted(text):
    def proof():
        run = subprocess.run(["z3", "-T:60", "-in"], input=text + "(check-sat)", capture_output=True, text=True, check=False)
        if run.stdout.strip() != "unsat":
            raise Broken(f"z3 says {run.stdout.strip()}")
    return proof
