# SPDX-License-Identifier: MIT
"""Claims about lines of lib/, as the sources have them, word for word, decided by z3 over all values. Each is also asked with less
given: then z3 has to find a counterexample. Arguments of a program: [FOLDER [WORD]]."""
import os
import re
import subprocess
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..") if len(sys.argv) < 2 else sys.argv[1]
number, failed = 0, 0


def z3(text):
    return subprocess.run(["z3", "-in", "-T:120"], input=text + "\n(check-sat)\n", stdout=subprocess.PIPE, text=True, check=False).stdout.split()


def value(file, pattern):
    """The number that the source has there."""
    with open(f"{ROOT}/lib/{file}", encoding="utf-8") as source:
        found = re.findall(pattern, source.read())
    return int(found[0]) if len(found) == 1 else 0


def claim(name, says, given, needed, never):
    """never, given and needed, has no solution; without what is needed it has one."""
    global number, failed
    if len(sys.argv) > 2 and sys.argv[2] not in name:
        return
    number += 1
    wrong = []
    for file, lines in says.items():
        with open(f"{ROOT}/lib/{file}", encoding="utf-8") as source:
            text = " ".join(source.read().split())
        wrong += [f"lib/{file} does not say: {line}" for line in lines if line not in text]
    for what, text in (("unsat", given + needed + never), ("sat", given + never)):
        answer = z3(text)
        if answer[:1] != [what]:
            wrong.append(f"z3 says {answer} for {what}")
    failed += bool(wrong)
    print(f"{'not ok' if wrong else 'ok'} {number} - {name}", *[f"# {line}" for line in wrong], sep="\n", flush=True)


def ints(*names):
    return "".join(f"(declare-const {name} Int)\n" for name in names)


def within(name, low, high):
    return f"(assert (<= {low} {name} {high}))\n" if low >= 0 else f"(assert (<= (- {-low}) {name} {high}))\n"


def words(*names):
    return "".join(f"(declare-const {name} (_ BitVec 32))\n" for name in names)


def end():
    print(f"1..{number}")
    sys.exit(failed != 0)
