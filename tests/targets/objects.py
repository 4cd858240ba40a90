# SPDX-License-Identifier: MIT
"""What an object file needs and holds, and how deep its calls go."""
import functools
import os
import re

# All that the library may ask of its surroundings: the compiler's helpers for integers. No helper for floating point, no
# function of libm is among them.
ALLOWED = re.compile(r"""
    glint_\w+
  | mem(cpy|set|move|cmp) | memcpy_P                    # AVR: memcpy_P from flash
  | __aeabi_(u?idiv(mod)?|u?ldivmod|lmul|llsl|llsr|lasr|l?u?lcmp|mem(cpy|set|move|clr)[48]?|[ui]div0|ldiv0)
  | __gnu_thumb1_case_\w+                               # a switch, on Cortex-M0
  | __(u?div|u?mod|u?divmod|mul|ashl|ashr|lshr|u?cmp|clz|ctz|bswap|neg)([qhsd]i)[234]?
  | __(u?mulh?isi3|(u|us)?mulhisi3|mulshisi3|muluhisi3|mulohisi3|umulsidi3|mulsidi3|u?divmod(qi|hi|psi|si)4)
  | __(add|sub|cmp)di[23](_s8)? | __negdi2 | __rotl\w+ | __rotr\w+
  | __prologue_saves__ | __epilogue_restores__ | __riscv_(save|restore)_\d+
  | __tablejump2?_?_ | __do_copy_data                   # AVR: a switch; constants in RAM, copied at the start
""", re.VERBOSE)
LIBRARY = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "lib")
HELPER_STACK = 80  # bytes that one of these may use; what the emulated machines measure is checked against it
MULTIPLY = re.compile(r"__aeabi_lmul|__u?mul\w+3")
MULTIPLY_STACK = 32  # of a helper that multiplies: libgcc's push 20 bytes on Cortex-M0, 25 on AVR with what they call, 0 on RV32

VECTORS = "+nofp"  # of a core's flags: vectors of integers, which share registers and mnemonics with a floating-point unit that is not there
FLOATING = r"\t(v[a-z0-9.]+\.f(?:16|32|64)[a-z0-9.]*|vcvt[a-z0-9.]*)\t"


def by_file(text):
    """What objdump says of several files: path, text."""
    parts = re.split(r"^(\S.*): +file format .*$", text, flags=re.M)
    return zip(parts[1::2], parts[2::2])


def complaints(target, objects):
    """Why these objects are not integers only, without writable data."""
    found = []
    for line in target.tool("nm", "-A", "-u", *objects).split("\n"):
        path, _, symbol = line.rpartition(" ")
        if symbol and not ALLOWED.fullmatch(symbol):
            found.append(f"{os.path.basename(path.split(':')[0])} needs {symbol}")
    for line in target.tool("nm", "-A", *objects).split("\n"):
        path, _, symbol = line.rpartition(":")
        fields = symbol.split()
        if len(fields) == 3 and fields[1] in "CcDdBbGgSs":
            found.append(f"{os.path.basename(path)} holds writable data: {fields[2]}")
    name = ""
    for line in target.tool("size", "-A", *objects).split("\n"):
        fields = line.split()
        if len(fields) == 2 and fields[1] == ":":
            name = os.path.basename(fields[0])
        elif re.match(r"\.(data|bss|sdata|sbss|tdata|tbss)", line) and int(fields[1]):
            found.append(f"{name} has {fields[1]} bytes of {fields[0]}")
    if target.prefix.startswith("arm"):
        for path, text in by_file(target.tool("objdump", "-d", *objects)):
            for mnemonic in set(re.findall(FLOATING if VECTORS in target.flags else r"\t(v[a-z0-9.]+)\t", text)):
                found.append(f"{os.path.basename(path)} uses the floating-point unit: {mnemonic}")
    return found


def text_bytes(target, objects):
    """Code and constants, and the constants alone."""
    lines = target.tool("size", "-B", *objects).split("\n")[1:]
    constants = re.findall(r"^\.(?:rodata|progmem|irom0)\S*\s+(\d+)", target.tool("size", "-A", *objects), re.M)
    return sum(int(line.split()[0]) for line in lines if line), sum(map(int, constants))


# What a call through a pointer looks like, and what a call does that is not a jump.
INDIRECT = re.compile(r"\t(blx?\t[a-z]|bx\t(?!lr)[a-z]|e?icall|e?ijmp|jalr\t|jr\t(?!ra)|callx0|jx\t(?!a0))")
FUNCTION = re.compile(r"^[0-9a-f]+ <((?!\.L)[^>+-]+)>:$")  # Xtensa's constants stand before a function, as NAME-0x4
RELOCATION = re.compile(r"^\s+[0-9a-f]+: (R_\S+)\s+([^\s+-]+)(\S*)")
CALL_MNEMONIC = re.compile(r"\t(bl|blx|r?call|jal|auipc|call0)\t")
CALLS = re.compile(r"R_ARM_THM_(CALL|JUMP\d+|XPC22)|R_ARM_CALL|R_RISCV_(CALL|CALL_PLT|JAL|RVC_JUMP)|R_AVR_(CALL|13_PCREL)|R_XTENSA_SLOT0_OP")


def assembly_stack(line):
    """Bytes that an instruction of Thumb assembly takes: registers pushed, one by one or as a range, or room made."""
    pushed = re.search(r"\t(?:push|stmdb\tsp!,|stmdb)\t?\s*(?:sp!, )?\{(.*)\}", line)
    room = re.search(r"\tsub\tsp, #(\d+)", line)
    count = 0
    for part in pushed[1].split(", ") if pushed else ():
        ends = [int(end[1:]) for end in part.split("-") if end[1:].isdigit()]
        count += ends[-1] - ends[0] + 1 if ends else 1
    return 4 * count + (int(room[1]) if room else 0)


def parameters(text):
    """The types of a parameter list, without names and qualifiers."""
    return tuple(re.sub(r"\bconst\b|\b\w+(\[\d*\])?$|\s", "", part.strip()) for part in text.split(","))


def arguments(text):
    """How many a call has, from what follows its parenthesis on."""
    count, depth = 1, 0
    for letter in text:
        depth += (letter in "([{") - (letter in ")]}")
        count += letter == "," and depth == 0
        if depth < 0:
            break
    return count


class Sources:
    """Which functions a call through a pointer may reach, from the C of the library: those whose parameters are those of a pointer to a
    function by whose name the caller, or what is inlined into it, calls."""

    DECLARED = re.compile(r"\(\*(?:const )?(\w+)(?:\[\])?\)\(([^()]*)\)")
    NAMED = re.compile(r"\btypedef [\w ]+?\**(\w+)\(([^()]*)\);")
    FUNCTION = re.compile(r"\b(\w+)\(((?:[^(){};]|\([^()]*\))*)\)\s*\{(.*?)\n\}", re.S)

    def __init__(self, folder):
        self.folder, self.texts, self.read = folder, {}, {}

    def text(self, name):
        if name not in self.texts:
            path = os.path.join(self.folder, name)
            self.texts[name] = open(path).read() if os.path.exists(path) else ""
        return self.texts[name]

    def seen(self, name):
        """What a file sees, by its includes: the parameters of pointers to functions by name, those of types of functions, and the
        parameters and bodies of functions."""
        if name in self.read:
            return self.read[name]
        files, pointers = [name], {}
        for file in files:
            files += [include for include in re.findall(r'#include "([\w.]+)"', self.text(file)) if include not in files]
        text = "\n".join(map(self.text, files))
        for pointer, of in self.DECLARED.findall(text):
            pointers.setdefault(pointer, set()).add(parameters(of))
        kinds = {kind: parameters(of) for kind, of in self.NAMED.findall(text)}
        for kind, pointer in re.findall(r"\b(" + "|".join(kinds or ["-"]) + r") \*(\w+);", text):
            pointers.setdefault(pointer, set()).add(kinds[kind])
        functions = {name: (of, body) for name, of, body in self.FUNCTION.findall(re.sub(r"/\*.*?\*/", "", text, flags=re.S))}
        self.read[name] = pointers, kinds, functions
        return self.read[name]

    @functools.cache
    def called(self, name, function, apart):
        """The parameters of the pointers that a function calls by: members of structs, and its own; apart: what is not inlined."""
        pointers, kinds, functions = self.seen(name)
        if function not in functions:  # assembly, whose comments say which pointers it calls by
            return set().union(*pointers.values())
        found, inlined = set(), [function]
        for each in inlined:
            text = " ".join(functions[each])
            for call in re.finditer(r"(?:->|\.)(\w+)\)?\s*\(", text):
                count = arguments(text[call.end():])
                found |= {of for of in pointers.get(call[1], ()) if len(of) == count}
            found |= {parameters(of) for _, of in self.DECLARED.findall(text)}
            found |= {kinds[kind] for kind in kinds if re.search(rf"\b{kind} \*", text)}
            inlined += {word for word in re.findall(r"\w+", text) if word in functions} - {*inlined, *apart}
        return found

    def may_call(self, caller, apart, target):
        """Where nothing is known of either, yes."""
        (path, function), (to, name) = caller, target
        file, callee = (os.path.basename(each)[:-2] + ".c" for each in (path, to))
        if not self.text(file):
            file = file[:-2] + ".S"
        functions = self.seen(callee)[2]
        name = re.split("[.$]", name)[0]
        if not self.text(callee) and self.text(callee[:-2] + ".S"):
            # A routine that C has no name for is reached from functions of its file, by what a table there holds.
            if not name.startswith("glint_"):
                return path == to and function.startswith("glint_")
            declared = self.declared(name)
            return caller != target and (not declared or not self.text(file) or
                                         declared in self.called(file, re.split("[.$]", function)[0], apart))
        takes = parameters(functions[name][0]) if name in functions else self.declared(name)  # one that a macro defines is declared
        return takes is None or not self.text(file) or \
            takes in self.called(file, re.split("[.$]", function)[0], apart)

    @functools.cache
    def declared(self, name):
        """The parameters of a function that a header or a source of C declares; None: there is none."""
        for each in sorted(os.listdir(self.folder)):
            found = each.endswith((".h", ".c")) and re.search(rf"\b{name}\(([^();]*)\)\s*[;{{]", self.text(each))
            if found:
                return parameters(found[1])
            found = each.endswith(".h") and re.search(rf"^(\w+) (?:\w+,\s*)*{name}\b[\w,\s]*;", self.text(each), re.M)  # by a typedef's name
            kind = found and re.search(rf"\btypedef [\w ]+?\**{found[1]}\(([^()]*)\);", self.text(each))
            if kind:
                return parameters(kind[1])
        return None


SOURCES = Sources(LIBRARY)  # of all objects: what is read of them holds for every core


def clone_name(label):
    """What gcc calls a function in its list of frames: of a clone its kind too, not its number. Assemblers without dots have $ in their place."""
    return re.sub(r"\.\d+$", "", label.replace("$", "."))


class Calls:
    """The call graph of some objects, read from their relocations (compiled with -ffunction-sections, every call has one),
    with the frames that gcc states (-fstack-usage). A call through a pointer may reach any function whose address is taken and whose
    parameters fit."""

    def __init__(self, target, objects):
        self.sources = SOURCES
        self.target, self.frames, self.edges, self.indirect = target, {}, {}, set()
        self.taken, self.trouble, self.memory = set(), set(), {}
        for path in objects:
            self._read_frames(path)
        for path, text in by_file(target.tool("objdump", "-dr", *objects)):
            self._read_code(path, text)
        for path, text in by_file(target.tool("objdump", "-r", *objects)):
            self._read_addresses(path, text)
        self.known = {}
        for file, function in self.edges:
            self.known.setdefault(function, (file, function))

    def _read_frames(self, path):
        if not os.path.exists(path[:-2] + ".su"):  # assembly: _read_function counts what its instructions take
            return
        with open(path[:-2] + ".su") as lines:
            for line in lines:
                place, size, kind = line.rstrip("\n").split("\t")
                function = (path, place.split(":")[-1])
                self.frames[function] = max(self.frames.get(function, 0), int(size))
                if kind not in ("static", "dynamic,bounded"):
                    self.trouble.add(f"{function[1]}: its frame is {kind}")

    def _read_code(self, path, text):
        function, code = None, []
        for line in text.split("\n") + ["0 <end>:"]:
            match = FUNCTION.match(line)
            if not match:
                code.append(line)
                continue
            if function:
                self._read_function((path, function), code)
            function, code = match[1], []

    def _read_addresses(self, path, text):
        """Functions whose address is taken, in code or in constants: any mention that is not a call nor a branch inside a
        function, which would have an offset."""
        section = ""
        for line in text.split("\n"):
            fields = line.split()
            if line.startswith("RELOCATION"):
                section = fields[-1]
            elif len(fields) == 3 and fields[1].startswith("R_") and not section.startswith(("[.ARM", "[.eh", "[.debug", "[.xt")):
                inside = re.search(r"[+-]0x", fields[2]) or fields[2].startswith(self.target.label_prefix)
                if not CALLS.fullmatch(fields[1]) and not inside:
                    self.taken.add((path, fields[2].replace(".text.", "")))

    def _read_function(self, function, code):
        edges = self.edges.setdefault(function, set())
        if not self.frames.get(function):  # assembly, or C around it, for which gcc states no frame
            self.frames[function] = sum(map(assembly_stack, code))
        instruction, direct = "", False
        for line in code + ["\t\t"]:
            match = RELOCATION.match(line)
            if not match:  # the next instruction; RISC-V's calls are two: auipc, which has the name, and jalr
                if INDIRECT.search(instruction) and not direct:
                    self.indirect.add(function)
                direct = direct and "\tauipc\t" in instruction
                instruction = line
            elif CALLS.fullmatch(match[1]):
                direct = True
                name = match[2].replace(".text.", "")
                inside = match[3] not in ("", "+0x0") or not CALL_MNEMONIC.search(instruction)
                if not name.startswith(".L") and (name != function[1] or not inside):
                    edges.add(name)

    def _find(self, path, name):
        return (path, name) if (path, name) in self.edges else self.known.get(name)

    def depth(self, function, above=()):
        """Bytes, and the names of the deepest chain."""
        if function in above:
            self.trouble.add(f"{function[1]}: calls itself")
            return 0, []
        if function not in self.memory:
            below = {(name, self._find(function[0], name)) for name in self.edges[function]}
            if function in self.indirect:
                apart = frozenset(name for name in self.edges[function] if self._find(function[0], name))
                reached = {self._find(path, name) for path, name in self.taken} - {None}
                below |= {(at[1], at) for at in reached if self.sources.may_call(function, apart, at)}
            chains = [self.depth(at, (*above, function)) if at else
                      (MULTIPLY_STACK if MULTIPLY.fullmatch(name) else HELPER_STACK, [name]) for name, at in below]
            deepest = max(chains, default=(0, []))
            frame = self.frames.get((function[0], clone_name(function[1])), 0)
            self.memory[function] = frame + self.target.pushed + deepest[0], [function[1], *deepest[1]]
        return self.memory[function]

    def deepest(self, name=None):
        """Over all functions, or of one by name."""
        functions = [function for function in self.edges if name in (None, function[1])]
        return max(self.depth(function) for function in functions)
