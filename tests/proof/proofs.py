# SPDX-License-Identifier: MIT
"""What the proofs share: their list, their arguments, the step from a bound to a rounded value. Usage of each: [WORD]: those proofs
that have WORD in their names. With FAULTS=1 each is instead done with faults in what it ran, and has to break. TAP."""
import os
import resource
import subprocess
import sys
import time
import traceback

import bits as of_bits
import poly as of_poly
from contracts import ONE
from library import library, with_faults
from paths import paths
from run import Broken, ran

counts = {"number": 0, "failed": 0}
MOST_FAULTS, ENOUGH = 12, 2


def ok(holds, name, *notes):
    counts["number"] += 1
    counts["failed"] += not holds
    print(f"{'ok' if holds else 'not ok'} {counts['number']} - {name}", *[f"# {line}" for note in notes for line in str(note).splitlines()],
          sep="\n", flush=True)


def used():
    """Seconds of processors, by this process and its solvers: where others have the processors, too, a proof has no more of them."""
    ticks = 0
    for solver in of_poly.solver + of_bits.solver:
        with open(f"/proc/{solver.pid}/stat") as stat:
            fields = stat.read().rpartition(")")[2].split()
        ticks += int(fields[11]) + int(fields[12])
    return time.process_time() + ticks / os.sysconf("SC_CLK_TCK")


def result(name, proof):
    if len(sys.argv) > 1 and sys.argv[1] not in name:
        return
    ran.clear()
    start = used()
    try:
        count = proof()
    except Broken as what:
        return ok(False, name, what)
    except Exception:
        return ok(False, name, traceback.format_exc())
    if os.environ.get("FAULTS"):
        if ran:
            ok(*broken_by_faults(name, proof, round(5 + 3 * (used() - start))))
    else:
        ok(True, name + (f" ({count} paths)" if count else ""))


def breaks(proof, seconds):
    """The proof in a process of its own: True where it does not go through; None where it ends otherwise, or it or its solver takes more
    of the processor's time."""
    child = os.fork()
    if child == 0:
        of_poly.solver.clear()
        of_bits.solver.clear()
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        try:
            proof()
            os._exit(0)
        except Broken:
            os._exit(1)
        except BaseException:
            os._exit(2)
    return {0: False, 1: True}.get(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))


def broken_by_faults(name, proof, seconds):
    """Of a proof that goes through: is it broken by faults in what it ran? One at least has to."""
    tried, found, notes = 0, 0, []
    for what in with_faults(library(), set(ran), name):
        answer = breaks(proof, seconds)
        tried, found = tried + 1, found + (answer is True)
        notes += [] if answer else [f"{'it holds' if answer is False else 'nothing is shown'} with {what}"]
        if found == ENOUGH or tried == MOST_FAULTS:
            break
    return found > 0, f"{found} of {tried} faults break: {name}", *notes


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
        run = subprocess.run(["z3", "-in"], input=text + "(check-sat)", capture_output=True, text=True, check=False)
        if run.returncode < 0:
            raise RuntimeError("z3 was ended")
        if run.stdout.strip() != "unsat":
            raise Broken(f"z3 says {run.stdout.strip()}")
    return proof
