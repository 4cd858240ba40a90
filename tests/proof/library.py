#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What clang makes of all of lib/ at once: its functions by name, wherever in lib/ they stand, its constants, and faults put into what
was compiled. Each function stands by itself: none is inlined, and none is changed to suit its callers. Run: prints lib/ as one source."""
import glob
import os
import random
import re
import subprocess

from ir import Module

HERE = os.path.dirname(os.path.abspath(__file__))
LIB = f"{HERE}/../../lib"
CLANG = ["clang", "--target=x86_64-linux-gnu", "-std=c99", "-ffreestanding", "-O1", "-fno-inline", "-fno-vectorize", "-fno-slp-vectorize",
         "-fno-unroll-loops", "-S", "-emit-llvm", "-Dalways_inline=noinline", "-Dflatten=", "-Dstatic=static __attribute__((used))"]


def sources():
    return "".join(f'#include "{os.path.basename(path)}"\n' for path in sorted(glob.glob(f"{LIB}/*.c")))


def text_of(more=""):
    """All of lib/ and what is added, as one source."""
    run = subprocess.run([*CLANG, f"-I{LIB}", "-x", "c", "-", "-o", "-"], input=sources() + more, capture_output=True, text=True, check=False)
    if run.returncode:
        raise SystemExit(f"library: clang does not compile lib/: {[line for line in run.stderr.splitlines() if 'error' in line][0]}")
    return run.stdout


def constants(*names):
    """The values of constants that lib/ names."""
    text = text_of("".join(f"const long long value_of_{name} = {name};\n" for name in names))
    return [int(re.search(rf"^@value_of_{name} = .*constant i64 (-?\d+)", text, re.M).group(1)) for name in names]


def functions_of(text):
    """By name: arguments, and blocks of lines by label; and the module."""
    functions = {"module": Module(text)}
    for name, arguments, body in re.findall(r"^define [^\n]*?@(\w+)\((.*?)\)[^\n)]*{$(.*?)^}", text, re.M | re.S):
        names = re.findall(r"(%\d+)(?:,|$)", arguments)
        blocks, label = {}, str(len(names))
        for line in body.splitlines():
            line = line.split(" ;")[0].strip()
            if re.match(r"\d+:", line):
                label = line.split(":")[0]
            elif line:
                blocks.setdefault(label, []).append(re.sub(r", ![a-z.]+ !\d+", "", line))
        functions[name] = (names, blocks)
    return functions


compiled = {}


def library():
    """All of lib/, and claims.c."""
    if not compiled:
        compiled.update(functions_of(text_of(f'#include "{HERE}/claims.c"\n')))
    return compiled


# ---- Faults ----

OTHERS = {"ult": "ule", "ule": "ult", "ugt": "uge", "uge": "ugt", "slt": "sle", "sle": "slt", "sgt": "sge", "sge": "sgt", "eq": "ne", "ne": "eq"}
WITH_NUMBERS = ("add", "sub", "mul", "and", "or", "shl", "lshr", "ashr", "udiv", "icmp", "select", "call", "store", "ret")


def faults(line):
    """The line with another comparison, with a sum for a difference, or with a number that is one more or one less."""
    operation = re.match(r"(?:%\d+ = )?(?:tail )?(\w+)", line).group(1)
    plain = re.sub(r", align \d+$", "", re.sub(r"\b(nuw|nsw|exact) ", "", line))
    if operation == "icmp":
        comparison = re.search(r"icmp (\w+)", plain).group(1)
        yield plain.replace(f"icmp {comparison}", f"icmp {OTHERS[comparison]}")
    if operation in ("add", "sub"):
        yield re.sub(rf"= {operation} ", "= sub " if operation == "add" else "= add ", plain)
    if operation in WITH_NUMBERS and "@llvm" not in line:
        for found in re.finditer(r"(?<=[ (])(-?\d+)(?=[,)]|$)", plain):
            for step in (1, -1):
                yield plain[:found.start()] + str(int(found.group()) + step) + plain[found.end():]


def with_faults(functions, ran, seed):
    """Puts one fault after the other into the lines that ran, and into the entries that were read of tables; says which."""
    sites = [(functions["module"].off, site, 1 << 16, f"{site[0]}, {site[1]} bytes on, 2^16 more") for site in sorted(s for s in ran if len(s) == 2)]
    for name, label, place in sorted(s for s in ran if len(s) == 3 and not s[0].startswith("claim_")):
        block = functions[name][1][label]
        sites += [(block, place, fault, f"{name}: {block[place]} -> {fault}") for fault in faults(block[place])]
    random.Random(seed).shuffle(sites)
    for block, place, fault, what in sites:
        right = block[place] if isinstance(block, list) else 0
        block[place] = fault
        try:
            yield what
        finally:
            block[place] = right


def texts_with_faults(text, names, seed):
    """The text of a module, with one fault after the other in the functions of these names; and which it is."""
    sites = []
    for found in re.finditer(r"^define [^\n]*?@(\w+)\(.*?^}", text, re.M | re.S):
        if found.group(1) in names:
            for line in re.finditer(r"^  (\S.*)$", found.group(), re.M):
                start = found.start() + line.start(1)
                sites += [(start, line.group(1), fault, found.group(1)) for fault in faults(re.sub(r", ![a-z.]+ !\d+", "", line.group(1)))]
    random.Random(seed).shuffle(sites)
    for start, right, fault, name in sites:
        yield text[:start] + fault + text[start + len(right):], f"{name}: {right} -> {fault}"


if __name__ == "__main__":
    print(sources(), end="")
