# SPDX-License-Identifier: MIT
"""The cross compilers, the emulated machines, and TAP lines."""
import glob
import os
import re
import shutil
import subprocess
from dataclasses import dataclass

SOURCE = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
WARNINGS = "-Wall -Wextra -Wconversion -Wundef -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Werror".split()


@dataclass
class Target:
    name: str
    prefix: str  # of the tools: arm-none-eabi-
    flags: str
    stack_limit: int
    return_address: int = 0  # bytes that a call pushes by itself, which gcc does not count
    assembly: tuple = ()  # of the library, beside its C

    @property
    def label_prefix(self):
        """Of relocations that name a place inside a function, not its address."""
        return ".text." if self.prefix.startswith("arm") else ".L"

    def tool(self, name, *arguments, cwd=None, check=True):
        """What the tool prints."""
        done = subprocess.run([self.prefix + name, *arguments], cwd=cwd, capture_output=True, text=True)
        if check and done.returncode:
            raise RuntimeError(f"{self.prefix}{name}: {done.stderr}")
        return done.stdout

    def compile(self, sources, flags, folder):
        """Objects and .su files of the sources in a fresh folder; the objects' names."""
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        sources = [os.path.join(SOURCE, source) for source in sources]
        self.tool("gcc", "-std=c99", "-ffreestanding", "-ffunction-sections", "-fstack-usage", *self.flags.split(),
                  *flags.split(), *WARNINGS, "-I" + os.path.join(SOURCE, "lib"), "-c", *sources, cwd=folder)
        return [os.path.join(folder, os.path.basename(source)[:-2] + ".o") for source in sources]


def stated_stack():
    """Bytes as the header promises: of Cortex-M0+, of the other Cortex-M, of the rest."""
    with open(os.path.join(SOURCE, "lib", "glint.h")) as header:
        statement = re.search(r"At most (\d+) bytes on Cortex-M0\+, (\d+) on other Cortex-M, (\d+) on RV32 and AVR", header.read())
    return [int(number) for number in statement.groups()]


def library_files(ending):
    """Its sources, from the project's folder."""
    return tuple(os.path.relpath(path, SOURCE) for path in sorted(glob.glob(os.path.join(SOURCE, "lib", "*" + ending))))


STACK_M0, STACK_M, STACK_OTHER = stated_stack()
TARGETS = [
    Target("cortex-m0plus-asm", "arm-none-eabi-", "-mcpu=cortex-m0plus -mthumb -DGLINT_CORTEX_M0PLUS_ASM=1", STACK_M0,
           assembly=library_files(".S")),
    Target("cortex-m0plus", "arm-none-eabi-", "-mcpu=cortex-m0plus -mthumb", STACK_M0),
    Target("cortex-m3", "arm-none-eabi-", "-mcpu=cortex-m3 -mthumb", STACK_M),
    Target("cortex-m4f", "arm-none-eabi-", "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16", STACK_M),
    Target("cortex-m33", "arm-none-eabi-", "-mcpu=cortex-m33 -mthumb", STACK_M),
    Target("rv32imc", "riscv64-unknown-elf-", "-march=rv32imc -mabi=ilp32", STACK_OTHER),
    Target("atmega328p", "avr-", "-mmcu=atmega328p", STACK_OTHER, 2),
    Target("atmega2560", "avr-", "-mmcu=atmega2560", STACK_OTHER, 3),
]

QEMU_ARM = "qemu-system-arm -display none -semihosting-config enable=on,target=native -M"
NPM = os.path.join(SOURCE, "build/bench/npm")  # where make installs rp2040js
RP2040JS = f"node {SOURCE}/tests/targets/rp2040.mjs {NPM}"


@dataclass(frozen=True)
class Machine:
    """A board of a port, as `make firmware` builds for it, and what emulates it."""
    target: str
    port: str
    board: str
    checks: int  # of the conformance image that fit
    emulator: str

    @property
    def folder(self):
        """Its image, objects, and the linker's words."""
        return os.path.join(SOURCE, "build/firmware", f"{self.port}-{self.board}")

    @property
    def start(self):
        """Sources that start a program."""
        folders = [self.port] if self.port == "avr" else [self.port, "bare"]
        return [path for name in folders for path in glob.glob(os.path.join(SOURCE, "firmware/ports", name, "*.c"))]

    def link(self, objects, program, *words):
        """Words first: a budget must be set before a script asks whether it is."""
        target = next(target for target in TARGETS if target.name == self.target)
        target.tool("gcc", *words, f"@{self.folder}/link", *objects, "-lgcc", "-o", program)


MACHINES = [
    Machine("cortex-m0plus", "cortex-m", "microbit", 24, f"{QEMU_ARM} microbit -kernel"),
    Machine("cortex-m0plus", "cortex-m", "rp2040", 17, RP2040JS),
    Machine("cortex-m0plus-asm", "cortex-m", "rp2040-asm", 17, RP2040JS),
    Machine("cortex-m3", "cortex-m", "mps2-an385", 26, f"{QEMU_ARM} mps2-an385 -kernel"),
    Machine("cortex-m4f", "cortex-m", "mps2-an386", 26, f"{QEMU_ARM} mps2-an386 -kernel"),
    Machine("cortex-m33", "cortex-m", "mps2-an505", 26, f"{QEMU_ARM} mps2-an505 -kernel"),
    Machine("rv32imc", "rv32", "virt", 26, "qemu-system-riscv32 -M virt -bios none -nographic -kernel"),
    Machine("atmega2560", "avr", "atmega2560", 15, "simavr -m atmega2560 -f 16000000"),
    Machine("atmega328p", "avr", "atmega328p", 6, "simavr -m atmega328p -f 16000000"),
]


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
