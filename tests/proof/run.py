# SPDX-License-Identifier: MIT
"""Runs a compiled function for all arguments at once. What a word is and does is a matter of the class that this is mixed into: a
polynomial (words.py) or bits (bits.py). A call is run the same way, or taken for what its contract says."""
from ir import POINTER

ran = set()  # lines of functions: function, block, place; and entries of tables: table, offset


class Broken(Exception):
    """A proof that does not go through: what, where."""


class Infeasible(Exception):
    """A path that nothing takes."""


class Memory:
    """Cells by their offsets: bytes, and what is in them. What is read before it is written is any word, or unknown to the proof."""

    def __init__(self, is_any=False, name=None, make=None):
        """make(bits): a word where one is read first."""
        self.cells, self.is_any, self.name, self.make = {}, is_any or make, name, make

    def words(self, size=4):
        """Its words, by index."""
        return {offset // size: value for offset, (_, value) in self.cells.items()}


class Pointer:
    def __init__(self, memory, offset=0):
        self.memory, self.offset = memory, offset

    def plus(self, bytes_):
        return Pointer(self.memory, self.offset + bytes_)


NULL = Pointer(None)


class Run:
    """Of one path: functions and contracts, memory, and calls under way."""

    def begin(self, functions, contracts):
        self.functions, self.module, self.contracts = functions, functions["module"], dict(contracts)
        self.given = {}  # registers of a function that are known from elsewhere; None: not needed
        self.carried, self.memories = [], {}

    def run(self, name, arguments):
        if name in self.contracts:
            return self.contracts[name](self, *arguments)
        if name not in self.functions:
            raise Broken(f"no function {name}")
        names, blocks = self.functions[name]
        given = self.given.get(name, {})
        return Frame(self, name, {**dict(zip(names, arguments)), **given}, blocks, given).run(next(iter(blocks)))

    # ---- memory ----

    def table(self, name):
        """A global's memory."""
        if name not in self.memories:
            memory = self.memories[name] = Memory(name=name)
            self.fill(memory, 0, *self.module.initial(name))
        return self.memories[name]

    def fill(self, memory, offset, kind, value):
        if kind[0] == "named":
            kind = self.module.types[kind[1]]
        if value == ("zeroinitializer",) and kind[0] in ("array", "struct"):
            for index in range(kind[1] if kind[0] == "array" else len(kind[1])):
                at, part = self.module.field(kind, index)
                self.fill(memory, offset + at, part, value)
        elif kind[0] in ("array", "struct"):
            for index, (part, inner) in enumerate(value[1]):
                self.fill(memory, offset + self.module.field(kind, index)[0], part, inner)
        elif kind[0] == "pointer":
            memory.cells[offset] = (8, NULL if value in (("null",), ("zeroinitializer",)) else Pointer(self.table(value[1])) if
                                    value[0] == "global" and value[1] in self.module.globals else value)
        else:
            number = 0 if value == ("zeroinitializer",) else value
            memory.cells[offset] = (self.module.size(kind), self.number(kind[1], number + self.module.off.get((memory.name, offset), 0)))

    def split(self, memory, at):
        """No cell goes across this offset."""
        for start, (size, value) in list(memory.cells.items()):
            if start < at < start + size:
                low = at - start
                memory.cells[start] = (low, self.part(value, 8 * size, 0, 8 * low))
                memory.cells[at] = (size - low, self.part(value, 8 * size, 8 * low, 8 * (size - low)))

    def load(self, pointer, size):
        memory, offset = pointer.memory, pointer.offset
        if memory is None:
            raise Broken("a null pointer is read")
        if memory.name in self.module.constants:
            ran.add((memory.name, offset))
        if memory.cells.get(offset, (0,))[0] == size:
            return memory.cells[offset][1]
        for start, (length, value) in memory.cells.items():
            if start <= offset and offset + size <= start + length:
                return self.part(value, 8 * length, 8 * (offset - start), 8 * size)
        self.split(memory, offset)
        self.split(memory, offset + size)
        parts, at = [], offset
        while at < offset + size:
            if at not in memory.cells:
                if not memory.is_any:
                    raise Broken("memory is read that is not set")
                end = min([c for c in memory.cells if at < c < offset + size] + [offset + size])
                memory.cells[at] = (end - at, memory.make(8 * (end - at)) if memory.make else self.any(8 * (end - at), "memory"))
            parts.append((8 * memory.cells[at][0], memory.cells[at][1]))
            at += memory.cells[at][0]
        return parts[0][1] if len(parts) == 1 else self.of_parts(parts)

    def store(self, pointer, size, value):
        memory, offset = pointer.memory, pointer.offset
        if memory is None:
            raise Broken("a null pointer is written")
        self.split(memory, offset)
        self.split(memory, offset + size)
        for at in [c for c in memory.cells if offset <= c < offset + size]:
            del memory.cells[at]
        memory.cells[offset] = (size, value)

    def copy(self, to, from_, size):
        for at in (from_.offset, from_.offset + size):
            self.split(from_.memory, at)
        cells = [(at, cell) for at, cell in from_.memory.cells.items() if from_.offset <= at < from_.offset + size]
        if from_.memory.is_any and not cells:
            cells = [(from_.offset, (size, self.load(from_, size)))]
        for at, (length, value) in cells:
            self.store(to.plus(at - from_.offset), length, value)


class Frame:
    """A call under way."""

    def __init__(self, path, name, values, blocks, given):
        self.path, self.name, self.values, self.blocks, self.given = path, name, values, blocks, given
        self.module = path.module

    def operand(self, kind, value):
        if isinstance(value, int):
            return self.path.number(kind[1], value)
        if value[0] == "register":
            return self.values[value[1]]
        if value[0] == "global":
            return Pointer(self.path.table(value[1])) if value[1] in self.module.globals else value
        if value[0] == "at":
            return self.address(*value[1:])
        if value[0] in ("null", "zeroinitializer", "undef", "poison"):
            return self.empty(kind, value[0])
        raise Broken(f"an operand {value}")

    def empty(self, kind, what):
        if kind[0] == "named":
            return self.empty(self.module.types[kind[1]], what)
        if kind[0] in ("struct", "array"):
            parts = kind[1] if kind[0] == "struct" else [kind[2]] * kind[1]
            return tuple(self.empty(part, what) for part in parts)
        return NULL if kind[0] == "pointer" else self.path.number(kind[1], 0) if what == "zeroinitializer" else None

    def address(self, kind, base, indices):
        pointer = self.operand(POINTER, base)
        number = self.path.choice(self.operand(*indices[0]), indices[0][0][1])
        pointer = pointer.plus(number * self.module.size(kind))
        for index in indices[1:]:
            offset, kind = self.module.field(kind, self.path.choice(self.operand(*index), index[0][1]))
            pointer = pointer.plus(offset)
        return pointer

    def run(self, label):
        before = None
        while True:
            phis = {}
            for line in self.blocks[label]:
                if " = phi " not in line:
                    break
                _, target, kind, choices = self.module.instruction(line)
                phis[target] = self.operand(kind, choices[before])
            self.values.update(phis)
            self.path.carried.extend(v for v in phis.values() if not isinstance(v, (Pointer, tuple)) and self.path.constant(v) is None)
            for place, line in enumerate(self.blocks[label]):
                if " = phi " in line:
                    continue
                op, target, *rest = self.module.instruction(line)
                if target in self.given:
                    continue
                ran.add((self.name, label, place))
                if op == "ret":
                    kind, value = rest
                    return None if kind is None else self.operand(kind, value)
                if op in ("br", "switch"):
                    before, label = label, getattr(self, "to_" + op)(*rest)
                    break
                result = getattr(self, "op_" + op, None)
                value = result(*rest) if result else self.path.binary(op, rest[0], rest[1], *(self.operand(("int", rest[1]), v) for v in rest[2:]))
                if target:
                    self.values[target] = value
            else:
                raise Broken(f"a block of {self.name} that ends in {line}")

    def to_br(self, condition, yes, no):
        return yes if condition is None or self.path.branch(self.operand(("int", 1), condition)) else no

    def to_switch(self, kind, value, other, cases):
        value = self.operand(kind, value)
        for number, label in cases:
            if self.path.branch(self.path.compare("eq", kind[1], value, self.path.number(kind[1], number))):
                return label
        return other

    def op_unreachable(self):
        raise Broken(f"{self.name} goes on where it must not")

    def op_alloca(self, _):
        return Pointer(Memory())

    def op_freeze(self, kind, value):
        return self.operand(kind, value)

    def op_bitcast(self, kind, value, _):
        return self.operand(kind, value)

    def op_getelementptr(self, kind, base, indices):
        return self.address(kind, base, indices)

    def op_load(self, kind, value):
        return self.path.load(self.operand(POINTER, value), self.module.size(kind))

    def op_store(self, kind, value, to):
        value = self.operand(kind, value)
        if isinstance(value, tuple):
            raise Broken("a store of several words")
        self.path.store(self.operand(POINTER, to), self.module.size(kind),
                        value if isinstance(value, Pointer) or kind[0] != "int" else self.path.kept(value, kind[1]))

    def op_zext(self, kind, value, to):
        return self.path.zext(self.operand(kind, value), kind[1], to[1])

    def op_sext(self, kind, value, to):
        return self.path.sext(self.operand(kind, value), kind[1], to[1])

    def op_trunc(self, kind, value, to):
        return self.path.trunc(self.operand(kind, value), kind[1], to[1])

    def op_select(self, kind, condition, a, b):
        return self.either(self.operand(("int", 1), condition), kind, lambda: self.operand(kind, a), lambda: self.operand(kind, b))

    def either(self, condition, kind, a, b):
        if self.path.constant(condition) is not None or kind[0] != "int":
            return a() if self.path.branch(condition) else b()
        return self.path.select(condition, a(), b(), kind[1])

    def op_icmp(self, how, kind, a, b):
        a, b = self.operand(kind, a), self.operand(kind, b)
        if kind[0] == "pointer":
            return self.path.number(1, self.compared(how, a, b))
        return self.path.compare(how, kind[1], a, b)

    def compared(self, how, a, b):
        same = a.memory is b.memory
        if how in ("eq", "ne"):
            return int((same and a.offset == b.offset) == (how == "eq"))
        if not same:
            raise Broken("pointers to different things are compared")
        return int({"ult": a.offset < b.offset, "ule": a.offset <= b.offset, "ugt": a.offset > b.offset, "uge": a.offset >= b.offset}[how])

    def op_extractvalue(self, kind, value, index):
        return self.operand(kind, value)[index]

    def op_insertvalue(self, kind, value, part, inner, index):
        parts = list(self.operand(kind, value))
        parts[index] = self.operand(part, inner)
        return tuple(parts)

    def op_call(self, kind, name, arguments):
        values = [self.path.kept(self.operand(k, v), k[1]) if k[0] == "int" else self.operand(k, v) for k, v in arguments]
        if name[0] == "%":
            name = self.values[name][1]
        name = name[1:]
        if not name.startswith("llvm."):
            return self.path.run(name, values)
        of = name.split(".")[1]
        width = kind[1] if kind[0] == "int" else 0
        path = self.path
        if of in ("lifetime", "assume"):
            return None
        if of in ("umin", "umax", "smin", "smax"):
            how = of[0] + ("le" if of.endswith("min") else "ge")
            return self.either(path.compare(how, width, *values), kind, lambda: values[0], lambda: values[1])
        if of == "abs":
            return self.either(path.compare("slt", width, values[0], path.number(width, 0)), kind,
                               lambda: path.binary("sub", {"nsw"} if path.constant(values[1]) else set(), width, path.number(width, 0), values[0]), lambda: values[0])
        if of == "memcpy":
            return path.copy(values[0], values[1], path.constant(values[2]))
        if of == "memset" and path.constant(values[1]) == 0:
            return [path.store(values[0].plus(i), 1, path.number(8, 0)) for i in range(path.constant(values[2]))] and None
        if hasattr(path, "call_" + of):
            return getattr(path, "call_" + of)(width, *values)
        raise Broken(f"a call of {name}")
