# SPDX-License-Identifier: MIT
"""The boards with their cross compilers and emulators, and TAP lines."""
import csv
import glob
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass

SOURCE = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
WARNINGS = "-Wall -Wextra -Wconversion -Wundef -Wshadow -Wstrict-prototypes -Wmissing-prototypes".split()


@dataclass(frozen=True)
class Target:
    """A processor core, as a board names it, and the compiler for it."""
    name: str
    prefix: str  # of the tools: arm-none-eabi-
    flags: str
    stack_limit: int
    pushed: int = 0  # bytes that a call pushes by itself, which gcc does not count
    assembly: tuple = ()  # of the library, beside its C

    @property
    def label_prefix(self):
        """Of relocations that name a place inside a function, not its address."""
        return ".text." if self.prefix.startswith("arm") else ".L"

    def tool(self, name, *arguments, cwd=None, check=True, quiet=False):
        """What the tool prints. Quiet: a warning is an error."""
        done = subprocess.run([self.prefix + name, *arguments], cwd=cwd, capture_output=True, text=True)
        if check and (done.returncode or quiet and done.stderr):
            raise RuntimeError(f"{self.prefix}{name}: {done.stderr}")
        return done.stdout

    def compile(self, sources, flags, folder):
        """Objects and .su files of the sources in a fresh folder; the objects' names."""
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        sources = [os.path.join(SOURCE, source) for source in sources]
        for source in sources:  # one at a time, as BARE_FLAGS say: ccache knows only such compilations
            self.tool("gcc", "-std=c99", "-ffreestanding", *flags.split(), "-ffunction-sections", "-fdata-sections", "-fstack-usage",
                      "-fno-jump-tables", *WARNINGS, *self.flags.split(), "-I" + os.path.join(SOURCE, "lib"), "-c", source, cwd=folder, quiet=True)
        return [os.path.join(folder, os.path.basename(source)[:-2] + ".o") for source in sources]


def library_files(ending):
    """Its sources, from the project's folder."""
    return tuple(os.path.relpath(path, SOURCE) for path in sorted(glob.glob(os.path.join(SOURCE, "lib", "*" + ending))))


NPM = os.path.join(SOURCE, "build/bench/npm")  # where make installs rp2040js


@dataclass(frozen=True)
class Machine:
    """A board, as its port.mk describes it (firmware/ports/bare/bare.mk says where each field comes from)."""
    port: str
    board: str
    target: Target
    skips: int  # checks of the conformance image that it may leave out
    sources: tuple  # that start a program
    emulator: str  # a command; '': nothing emulates it

    @property
    def folder(self):
        """Its image, objects, and the linker's words."""
        return os.path.join(SOURCE, "build/firmware", f"{self.port}-{self.board}")

    @property
    def missing(self):
        """Why it cannot be run; '': it can."""
        if not self.emulator:
            return f"nothing emulates it: firmware/ports/{self.port}/port.mk names no emulator"
        if NPM_WORD in self.emulator and not os.path.exists(os.path.join(NPM, "done")):
            return "npm could not install rp2040js"
        program = self.emulator.split()[0]
        return "" if shutil.which(program) else f"{program} is not installed: make setup-targets"

    def run(self, program, *words):
        """What it prints, and its exit status. Words: of the emulator, before its others."""
        emulator, *others = self.emulator.split()
        done = subprocess.run([emulator, *words, *others, program], capture_output=True, text=True, timeout=HANGS,
                              stdin=subprocess.DEVNULL, cwd=SOURCE)
        text = re.sub(r"\x1b\[\d*m", "", done.stdout + done.stderr)  # simavr colours what a program sends, and shows its line ends as dots
        return re.sub(r"\.$", "", text, flags=re.M), done.returncode

    def link(self, objects, program, *words):
        """Words first: a budget must be set before a script asks whether it is."""
        self.target.tool("gcc", *words, f"@{self.folder}/link", *objects, "-lgcc", "-o", program)


HANGS = 3600  # seconds: an image has ended by then, also where a simulator counts for it, or never does
NPM_WORD = os.path.relpath(NPM, SOURCE)


def read_boards():
    """All boards, by the list that make writes of what the port.mk files say; tests have lists of their own."""
    path = os.environ.get("GLINT_BOARDS") or os.path.join(SOURCE, "build/firmware/boards")
    if not os.path.exists(path):
        raise SystemExit(f"{sys.argv[0]}: there is no {os.path.relpath(path)}: run 'make boards' first")
    machines, cores = [], {}
    with open(path) as lines:
        for row in csv.DictReader(lines, delimiter="|"):
            target = Target(row["core"], row["tools"], row["flags"], int(row["stack"]), int(row["pushed"]),
                            tuple(row["assembly"].split()))
            if cores.setdefault(target.name, target) != target:
                raise SystemExit(f"{sys.argv[0]}: board {row['board']}: another board gives the core {target.name} other flags")
            own = sorted(glob.glob(os.path.join(SOURCE, "firmware/ports", row["port"], "*.c")))
            started = (*own, *(os.path.join(SOURCE, source) for source in row["sources"].split()))
            machines.append(Machine(row["port"], row["board"], cores[target.name], int(row["skips"]), started, row["run"]))
    return machines


MACHINES = read_boards()
TARGETS = list({machine.target.name: machine.target for machine in MACHINES}.values())


def choose(board):
    """The machine of that name alone, or all for ''; and their cores."""
    machines = [machine for machine in MACHINES if board in ("", machine.board)]
    return machines, list({machine.target.name: machine.target for machine in machines}.values())


def library_sources(target=None):
    return [*library_files(".c"), *(target.assembly if target else ())]


class Tap:
    def __init__(self):
        self.count = self.failed = 0

    def result(self, good, name, details=()):
        self.count += 1
        self.failed += not good
        print(f"{'' if good else 'not '}ok {self.count} - {name}")
        for detail in details if not good else ():
            print(f"# {detail}")

    def skip(self, name, why):
        self.count += 1
        print(f"ok {self.count} - {name} # SKIP {why}")

    def end(self):
        print(f"1..{self.count}", flush=True)
        return 1 if self.failed else 0
