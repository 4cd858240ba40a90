# SPDX-License-Identifier: MIT
"""Mutants of C: small changes of one place each, which a test should notice."""
import re

RELATIONS = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="]}
ARITHMETIC = {"+": ["-"], "-": ["+"], "*": ["+"], "/": ["*"], "%": ["/"], ">>": ["<<"], "<<": [">>"],
              "&": ["|"], "|": ["&"], "^": ["|"], "&&": ["||"], "||": ["&&"]}
ASSIGNED = {"+=": ["-=", "="], "-=": ["+=", "="], "*=": ["+="], "|=": ["&=", "="], "&=": ["|="], ">>=": ["<<="],
            "<<=": [">>="], "^=": ["|="]}
# The repository's format has a blank on both sides of an operator, so that a pointer's * is none.
OPERATOR = re.compile(r"(?<= )(<<=|>>=|[-+*|&^]=|<=|>=|==|!=|&&|\|\||<<|>>|[-+*/%&|^<>])(?= |$)")
NUMBER = re.compile(r"(?<![\w.\"'])(0x[0-9a-fA-F]+|\d+)([uU]?[lL]*)(?![\w.\"'])")
DROPPED = re.compile(r"^(\s+)((?:[\w\[\]().>*-]+(?:\[[^;=]*\])*\s(?:[-+*/|&^]|<<|>>)?=\s[^;{]*|\w+\([^;{]*\)|[\w>.\[\]-]+(?:\+\+|--)));$")
NAME = re.compile(r"\w*$")
DECLARES = re.compile(r"\s+(?:static |const )*(?:(?:struct|union|enum) \w+|u?int\d+_t|unsigned|int|char|bool|size_t|float|double) ")
CONDITION = re.compile(r"\b(?:if|while) \((.*)\)( \{)?$")


def blank(text):
    """The text without comments, strings and lines of the preprocessor, in the same places."""
    def spaces(match):
        return re.sub(r"[^\n]", " ", match.group(0))
    text = re.sub(r"/\*.*?\*/", spaces, text, flags=re.S)
    text = re.sub(r'"(\\.|[^"\\\n])*"', spaces, text)
    text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", spaces, text, flags=re.M)
    text = re.sub(r"^_Static_assert\(.*?;", spaces, text, flags=re.M | re.S)
    return re.sub(r"^(?:extern|typedef)\b[^;]*;", spaces, text, flags=re.M)


def array_sizes(line):
    """Where the sizes of arrays stand that the line declares, in a function or a struct; of arrays of arrays the outer ones."""
    declares, depth, is_value = DECLARES.match(line), 0, False
    for place in range(declares.end() if declares else len(line), len(line)):
        depth += (line[place] in "{(") - (line[place] in "})")
        if depth == 0:
            is_value = line[place] != "," and (is_value or line[place] == "=")
            if line[place] == "[" and line[place - 1] != "]" and not is_value:
                yield place + 1


def mutants(text):
    """Each as (line number from 1, column, what stood there, what stands there now)."""
    text = blank(text)
    for number, line in enumerate(text.split("\n"), 1):
        for match in OPERATOR.finditer(line):
            operator = match.group(1)
            for other in [*RELATIONS.get(operator, []), *ARITHMETIC.get(operator, []), *ASSIGNED.get(operator, [])]:
                yield number, match.start(), operator, other
        # Nothing but sizeof can tell an array that is larger.
        sizes = {place for place in array_sizes(line) if f"sizeof {re.search(NAME, line[:place - 1]).group(0)}" not in text}
        for match in NUMBER.finditer(line):
            value, suffix = int(match.group(1), 0), match.group(2)
            for other in sorted({value + (match.start() not in sizes), max(value - 1, 0), 0} - {value}):
                yield number, match.start(), match.group(0), f"{other}{suffix}"
        match = DROPPED.match(line)
        if match and not match.group(2).startswith("return"):
            yield number, match.start(2), match.group(2), ""
        match = CONDITION.search(line)
        if match and match.group(1).count("(") == match.group(1).count(")"):
            yield number, match.start(1), match.group(1), f"!({match.group(1)})"


def mutated(text, mutant):
    number, column, old, new = mutant
    lines = text.split("\n")
    line = lines[number - 1]
    assert line[column:column + len(old)] == old or "/*" in line or '"' in line, (line, mutant)
    lines[number - 1] = line[:column] + new + line[column + len(old):]
    return "\n".join(lines)
