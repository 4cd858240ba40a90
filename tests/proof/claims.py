# SPDX-License-Identifier: MIT
"""Claims about numbers, of mathematics alone, decided by z3 over all values. Each is also asked with less given: then z3 has to find a
counterexample."""
import subprocess

from proofs import result
from run import Broken


def z3(text):
    return subprocess.run(["z3", "-in", "-T:120"], input=text + "\n(check-sat)\n", stdout=subprocess.PIPE, text=True, check=False).stdout.split()


def claim(name, given, needed, never):
    """never, given and needed, has no solution; without what is needed it has one."""
    def proof():
        for what, text in (("unsat", given + needed + never), ("sat", given + never)):
            answer = z3(text)
            if answer[:1] != [what]:
                raise Broken(f"z3 says {answer} for {what}")
    result(name, proof)


def ints(*names):
    return "".join(f"(declare-const {name} Int)\n" for name in names)


def reals(*names):
    return "".join(f"(declare-const {name} Real)\n" for name in names)


def within(name, low, high):
    return f"(assert (<= {low} {name} {high}))\n" if low >= 0 else f"(assert (<= (- {-low}) {name} {high}))\n"


def words(*names):
    return "".join(f"(declare-const {name} (_ BitVec 32))\n" for name in names)
