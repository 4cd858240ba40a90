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


def mutants(text):
    """Each as (line number from 1, column, what stood there, what stands there now)."""
    for number, line in enumerate(blank(text).split("\n"), 1):
        for match in OPERATOR.finditer(line):
            operator = match.group(1)
            for other in [*RELATIONS.get(operator, []), *ARITHMETIC.get(operator, []), *ASSIGNED.get(operator, [])]:
                yield number, match.start(), operator, other
        for match in NUMBER.finditer(line):
            value, suffix = int(match.group(1), 0), match.group(2)
            for other in sorted({value + 1, max(value - 1, 0), 0} - {value}):
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
