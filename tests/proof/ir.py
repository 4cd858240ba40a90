# SPDX-License-Identifier: MIT
"""LLVM IR as clang 14 prints it: types and where their parts lie, constants, instructions."""
import re

TOKEN = re.compile(r'%[\w.]+|@[\w.]+|c"(?:[^"\\]|\\[0-9A-Fa-f]{2})*"|-?\d+|[A-Za-z_][\w.]*|<\{|\}>|\.\.\.|#\d+|![\w.]*|[()\[\]{}<>*,=]')
OF_ARGUMENTS = {"noundef", "zeroext", "signext", "nonnull", "nocapture", "readonly", "readnone", "writeonly", "noalias", "immarg", "returned", "inreg",
                "byval", "sret", "align", "dereferenceable", "dereferenceable_or_null"}
POINTER = ("pointer", None)


class Reader:
    """The tokens of a line, one after the other."""

    def __init__(self, text, types):
        self.tokens, self.at, self.types = TOKEN.findall(text), 0, types

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def next(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def take(self, token):
        if self.peek() == token:
            self.at += 1
            return True
        return False

    def skip_attributes(self):
        while self.peek() in OF_ARGUMENTS:
            if self.next() == "align":
                self.next()
            if self.take("("):
                depth = 1
                while depth:
                    depth += {"(": 1, ")": -1}.get(self.next(), 0)

    def list(self, end, item):
        found = []
        while not self.take(end):
            found.append(item())
            self.take(",")
        return found

    def type(self):
        token = self.next()
        if token in ("{", "<{"):
            kind = ("struct", tuple(self.list("}" if token == "{" else "}>", self.type)), token == "<{")
        elif token == "[":
            count = int(self.next())
            self.next()
            kind = ("array", count, self.type())
            self.next()
        elif token[0] == "%":
            kind = ("named", token)
        elif re.fullmatch(r"i\d+", token):
            kind = ("int", int(token[1:]))
        else:
            kind = (token,)
        while True:
            if self.take("*"):
                kind = ("pointer", kind)
            elif self.take("("):
                kind = ("function", kind, self.list(")", self.type))
            else:
                return kind

    def value(self, kind):
        """Of a type: an operand. Constants are Python's numbers; ("register", name), ("global", name), ("at", type, base, indices)."""
        token = self.next()
        if re.fullmatch(r"-?\d+", token):
            return int(token)
        if token[0] in "%@":
            return ("register" if token[0] == "%" else "global", token)
        if token in ("true", "false"):
            return int(token == "true")
        if token in ("null", "zeroinitializer", "undef", "poison"):
            return (token,)
        if token == "getelementptr":
            self.take("inbounds")
            self.next()
            return self.address(")")
        if token in ("bitcast", "inttoptr", "ptrtoint"):
            self.next()
            inner = self.typed()[1]
            self.next()
            self.type()
            self.next()
            return inner
        if token in ("{", "<{", "["):
            return ("list", self.list({"{": "}", "<{": "}>", "[": "]"}[token], self.typed))
        if token[0] == "c":
            raw = re.sub(r"\\([0-9A-Fa-f]{2})", lambda m: chr(int(m.group(1), 16)), token[2:-1])
            return ("list", [(("int", 8), ord(c)) for c in raw])
        raise ValueError(f"ir: an operand that is not known: {token}")

    def typed(self):
        kind = self.type()
        self.skip_attributes()
        return kind, self.value(kind)

    def address(self, end):
        kind = self.type()
        self.take(",")
        base = self.typed()[1]
        indices = []
        while self.take(","):
            indices.append(self.typed())
        if end:
            self.next()
        return ("at", kind, base, indices)


class Module:
    def __init__(self, text):
        self.types, self.globals = {}, {}
        for name, rest in re.findall(r"^(%[\w.]+) = type (.*)$", text, re.M):
            self.types[name] = Reader(rest, self.types).type()
        self.constants = set()
        for name, how, rest in re.findall(r"^(@[\w.]+) = .*?\b(constant|global) (.*)$", text, re.M):
            self.globals[name] = rest
            self.constants |= {name} if how == "constant" else set()
        self.instructions = {}
        self.off = {}  # of entries of tables, each a global and an offset: faults

    def initial(self, name):
        """A global's type and value."""
        return Reader(self.globals[name], self.types).typed()

    def size(self, kind):
        return self.laid(kind)[0]

    def laid(self, kind):
        """Size and alignment, in bytes, of x86-64."""
        if kind[0] == "int":
            size = 1 << max(0, (kind[1] + 7) // 8 - 1).bit_length()
            return size, min(size, 16)
        if kind[0] in ("pointer", "function"):
            return 8, 8
        if kind[0] == "array":
            size, align = self.laid(kind[2])
            return kind[1] * size, align
        if kind[0] == "named":
            return self.laid(self.types[kind[1]])
        at, most = 0, 1
        for part in kind[1]:
            size, align = self.laid(part)
            align = 1 if kind[2] else align
            at, most = -(-at // align) * align + size, max(most, align)
        return -(-at // most) * most, most

    def field(self, kind, index):
        """The offset and the type of a struct's or an array's part."""
        if kind[0] == "named":
            return self.field(self.types[kind[1]], index)
        if kind[0] == "array":
            return index * self.size(kind[2]), kind[2]
        at = 0
        for place, part in enumerate(kind[1]):
            size, align = self.laid(part)
            at = at if kind[2] else -(-at // align) * align
            if place == index:
                return at, part
            at += size
        raise ValueError("ir: no such part")

    def instruction(self, line):
        if line not in self.instructions:
            self.instructions[line] = self.parsed(line)
        return self.instructions[line]

    def parsed(self, line):
        """(operation, target, what it needs)."""
        read = Reader(line, self.types)
        target = None
        if len(read.tokens) > 1 and read.tokens[1] == "=":
            target = read.next()
            read.next()
        while read.peek() in ("tail", "musttail", "notail"):
            read.next()
        op = read.next()
        return (op, target, *getattr(self, "read_" + op, self.read_binary)(read))

    def read_binary(self, read):
        flags = set()
        while read.peek() in ("nuw", "nsw", "exact"):
            flags.add(read.next())
        kind, a = read.typed()
        read.next()
        return flags, kind[1], a, read.value(kind)

    def read_icmp(self, read):
        how = read.next()
        kind, a = read.typed()
        read.next()
        return how, kind, a, read.value(kind)

    def read_select(self, read):
        _, condition = read.typed()
        read.next()
        kind, a = read.typed()
        read.next()
        return kind, condition, a, read.typed()[1]

    def read_zext(self, read):
        kind, a = read.typed()
        read.next()
        return kind, a, read.type()

    read_sext = read_trunc = read_bitcast = read_ptrtoint = read_inttoptr = read_zext

    def read_freeze(self, read):
        return read.typed()

    def read_ret(self, read):
        return (None, None) if read.peek() == "void" else read.typed()

    def read_br(self, read):
        if read.take("label"):
            return None, read.next()[1:], None
        _, condition = read.typed()
        read.next()
        read.next()
        yes = read.next()[1:]
        read.next()
        read.next()
        return condition, yes, read.next()[1:]

    def read_switch(self, read):
        kind, a = read.typed()
        read.next()
        read.next()
        other = read.next()[1:]
        read.next()
        cases = []
        while not read.take("]"):
            number = read.typed()[1]
            read.next()
            read.next()
            cases.append((number, read.next()[1:]))
        return kind, a, other, cases

    def read_unreachable(self, _):
        return ()

    def read_phi(self, read):
        kind = read.type()
        choices = {}
        while True:
            read.next()
            value = read.value(kind)
            read.next()
            choices[read.next()[1:]] = value
            read.next()
            if not read.take(","):
                return kind, choices

    def read_alloca(self, read):
        return (read.type(),)

    def read_load(self, read):
        kind = read.type()
        read.next()
        return kind, read.typed()[1]

    def read_store(self, read):
        kind, a = read.typed()
        read.next()
        return kind, a, read.typed()[1]

    def read_getelementptr(self, read):
        read.take("inbounds")
        return read.address(None)[1:]

    def read_extractvalue(self, read):
        kind, a = read.typed()
        read.next()
        return kind, a, int(read.next())

    def read_insertvalue(self, read):
        kind, a = read.typed()
        read.next()
        part, b = read.typed()
        read.next()
        return kind, a, part, b, int(read.next())

    def read_call(self, read):
        while read.peek() in OF_ARGUMENTS or read.peek() in ("fastcc", "range"):
            read.skip_attributes()
        kind = read.type()
        name = read.next()
        read.next()
        arguments = read.list(")", read.typed)
        return kind, name, arguments
