# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader of C++ that knows as much as is needed to find texts: strings, comments, brackets."""

import re

UNKNOWN = "…"  # what only a run knows
STRING = r'"(?:[^"\\\n]|\\.)*"'
OPEN, CLOSE = "([{", ")]}"


def remove_comments(text):
    """The source without comments, as long as it was; strings stay."""
    pattern = re.compile(rf"{STRING}|'(?:[^'\\\n]|\\.)'|//[^\n]*|/\*.*?\*/", re.DOTALL)
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match[0])
                       if match[0].startswith("/") else match[0], text)


def find_end(text, begin):
    """The place of the bracket that closes the one at @p begin."""
    depth, position = 0, begin
    while position < len(text):
        if match := re.compile(STRING).match(text, position):
            position = match.end()
            continue
        depth += (text[position] in OPEN) - (text[position] in CLOSE)
        if depth == 0:
            return position
        position += 1
    return len(text)


def split(text, separator):
    """The parts of an expression between separators that stand in no bracket and no string."""
    parts, begin, position = [], 0, 0
    while position < len(text):
        if match := re.compile(STRING).match(text, position):
            position = match.end()
        elif text[position] in OPEN:
            position = find_end(text, position) + 1
        elif text.startswith(separator, position):
            parts.append(text[begin:position])
            position += len(separator)
            begin = position
        else:
            position += 1
    return [part.strip() for part in [*parts, text[begin:]]]


def find_calls(text, names):
    """(name, arguments, position) of all calls of the functions that a pattern matches."""
    for match in re.finditer(rf"\b({names})\s*\(", text):
        end = find_end(text, match.end() - 1)
        yield match[1], split(text[match.end():end], ","), match.start()


def find_definition(text, name, position):
    """The expression that a string was last defined as before a place, or None."""
    pattern = rf"\b(?:std::string|auto|char \*const)\s*&?\s*{re.escape(name)}\s*(?:=|\()"
    found = list(re.finditer(pattern, text[:position]))
    if not found:
        return None
    begin = found[-1].end()
    if text[begin - 1] == "(":
        return text[begin:find_end(text, begin - 1)]
    return split(text[begin:], ";")[0]


def read_stream(text, name, position, depth):
    """What was written to a string stream since it was defined, up to a place."""
    begin = text.rfind("stringstream ", 0, position)
    pieces = re.finditer(rf"\b{re.escape(name)}\s*<<", text[begin:position])
    parts = []
    for piece in pieces:
        parts += split(split(text[begin + piece.end():], ";")[0], "<<")
    return "".join(compose(part, text, position, depth + 1) for part in parts
                   if not part.startswith("std::set"))


def compose(expression, text, position, depth=0):
    """The text that an expression of strings makes; UNKNOWN stands for what it fills in."""
    parts = [compose_part(part, text, position, depth) for part in split(expression, "+")]
    return re.sub(rf"{UNKNOWN}+", UNKNOWN, "".join(parts))


def compose_part(part, text, position, depth):
    if re.fullmatch(rf"(?:{STRING}\s*)+", part):
        literals = "".join(literal[1:-1] for literal in re.findall(STRING, part))
        return literals.replace(r"\"", '"').replace(r"\n", " ").replace("\\\\", "\\")
    if match := re.fullmatch(r"std::string\((.*)\)", part, re.DOTALL):
        return compose(match[1], text, position, depth)
    if part.startswith("(") and find_end(part, 0) == len(part) - 1:
        return compose(part[1:-1], text, position, depth)
    choices = split(part, "?")
    if len(choices) == 2 and len(split(choices[1], ":")) == 2:
        first, second = (compose(choice, text, position, depth)
                         for choice in split(choices[1], ":"))
        return second if not first else first if not second else f"{first} | {second}"
    if match := re.fullmatch(r"(\w+)\.str\(\)", part):
        return read_stream(text, match[1], position, depth) if depth < 4 else UNKNOWN
    if re.fullmatch(r"\w+", part) and depth < 4:
        definition = find_definition(text, part, position)
        if definition is not None and '"' in definition:
            return compose(definition, text, position, depth + 1)
    return UNKNOWN
