# SPDX-License-Identifier: LGPL-2.1-or-later
"""The messages of the program, from its sources: what it refuses and what it warns of."""

import dataclasses
import re

from . import cpp, parameters
from .cpp import UNKNOWN

# Functions that complain about a value, and what they allow.
CHECKS = {"check_positive": "> 0", "check_not_negative": "≥ 0", "check_finite": "",
          "check_between": "", "check_value": "", "read_unless_automatic": ""}
# The models that a part of the sources belongs to, if not to all; the longest name counts.
MODELS = {"source/passage": ["passage"], "source/ideal": ["potential"],
          "source/solid/elastic": ["elastic"], "source/solid": ["immersed", "elastic"],
          "source/base/time_stepping": ["immersed"], "source/fluid": ["immersed"],
          "source/viscous": ["immersed"], "source/observe": ["immersed"],
          "source/coupling": ["immersed"], "source/linear": ["immersed"]}


@dataclasses.dataclass
class Message:
    """A sentence of the program; … stands for what a run fills in."""
    kind: str  # error or warning
    text: str
    sources: list  # the files that have it
    limit: str = ""  # what it tells of the allowed values
    parameters: list = dataclasses.field(default_factory=list)  # indices of those that it names


def find_internal(text):
    """The parts of a source that only check the program itself: arguments of Assert()."""
    return [(match.start(), cpp.find_end(text, match.end() - 1))
            for match in re.finditer(r"\bAssert\s*\(", text)]


def read_remedies(root):
    """The remedies by function that checks of values have if they are given none."""
    header = (root / "include/caudal/base/checks.h").read_text(encoding="utf-8")
    return dict(re.findall(r'void (check_\w+)\([^)]*remedy = "([^"]*)"\)', header))


def read_errors(text, remedies):
    """(text, limit) of the errors of a source."""
    internal = find_internal(text)
    for _, arguments, position in cpp.find_calls(text, "ExcMessage|complain|fail"):
        is_definition = re.match(r"const\s+std::string\b", arguments[0] if arguments else "")
        if any(begin < position < end for begin, end in internal) or is_definition:
            continue
        yield cpp.compose(",".join(arguments), text, position), ""
    for name, arguments, position in cpp.find_calls(text, "|".join(CHECKS)):
        if name == "check_value":
            arguments = arguments[1:]
        if not arguments or re.match(r"const\b", arguments[0]):
            continue  # its definition
        limit, remedy = CHECKS[name], remedies.get(name, "")
        if name == "check_between":
            low, high = (re.sub(r"\.$", "", value) for value in arguments[2:4])
            if re.fullmatch(r"[\d.e-]+", low) and re.fullmatch(r"[\d.e-]+", high):
                limit = f"from {low} to {high}"
        if arguments[-1] != arguments[0] and '"' in arguments[-1]:
            remedy = cpp.compose(arguments[-1], text, position)
        path = cpp.compose(arguments[0], text, position)
        yield f"{path}: the value is {UNKNOWN}. {remedy}".strip(), limit


def read_warnings(text):
    """The warnings of a source."""
    for _, arguments, position in cpp.find_calls(text, r"(?:warnings|remarks|marks)\.push_back"):
        yield cpp.compose(",".join(arguments), text, position)
    for match in re.finditer(r'<<\s*"Warning', text):
        begin = text.index('"', match.start())
        parts = cpp.split(cpp.split(text[begin:], ";")[0], "<<")
        words = (cpp.compose(part, text, begin) for part in parts if "std::" not in part)
        yield re.sub(r"^Warnings?: ", "", re.sub(rf"{UNKNOWN}+", UNKNOWN, "".join(words)))
    for match in re.finditer(r"\bGuard<dim>\(\{", text):  # the words of a guard
        words = cpp.split(text[match.end():cpp.find_end(text, match.end() - 1)], ",")
        entry, _, quantity, unit, hint = (cpp.compose(word, text, match.start()) for word in words)
        yield (f"at t = {UNKNOWN} s {quantity} is {UNKNOWN}{unit} (Guards/{entry} = {UNKNOWN}). "
               f"{hint}")


def is_text(text):
    """Whether it says anything: more than what a run fills in."""
    words = re.findall(r"[A-Za-z]{2,}", text.replace("the value is", ""))
    return len(words) >= 3 or "/" in text and len(words) >= 1


def read_messages(root):
    """All messages in the sources, each once."""
    found, remedies = {}, read_remedies(root)
    for path in sorted((root / "source").rglob("*.cc")):
        name = str(path.relative_to(root))
        text = cpp.remove_comments(path.read_text(encoding="utf-8"))
        texts = [("error", *error) for error in read_errors(text, remedies)]
        texts += [("warning", warning, "") for warning in read_warnings(text)]
        for kind, words, limit in texts:
            words = re.sub(r"^Warning: ", "", " ".join(words.split()))
            if not is_text(words):
                continue
            message = found.setdefault((kind, words), Message(kind, words, [], limit))
            if name not in message.sources:
                message.sources.append(name)
    return sorted(found.values(), key=lambda message: message.text.lstrip(UNKNOWN + "/ :").lower())


def get_models(source):
    """The models that have what a source file says."""
    found = [name for name in MODELS if source.startswith(name)]
    return MODELS[max(found, key=len)] if found else list(parameters.MODELS)


def read_plugins(root, source):
    """The names of the plug-ins that a source registers: those of their sections, in lower case."""
    text = (root / source).read_text(encoding="utf-8")
    return {name.lower().replace(".", "") for name in re.findall(r'\w+\s*\(\s*"([^"]+)",\s*\n?\s*"', text)}


def get_tail(parameter):
    """How messages call a parameter: by the last section of its path, without names of bodies."""
    section = parameter.section.rpartition("/")[2]
    if section == "Body <name>":
        return rf"(?:Body|{UNKNOWN}) ?{UNKNOWN}?/{re.escape(parameter.name)}"
    if section == "Region <region>":
        return rf"Region(?: {UNKNOWN})?/{re.escape(parameter.name)}"
    return re.escape(f"{section}/{parameter.name}" if section else f"{parameter.name}:")


def find_named(message, candidates, plugins):
    """The parameters that a message names: in full, or at its beginning by the entry alone."""
    named = [parameter for parameter in candidates if re.search(
        rf"(?<!\w){get_tail(parameter)}(?!\w| [a-z]+:)", message.text)]
    begin = re.match(rf"{UNKNOWN}/?([A-Z][\w' -]*\w)[:,]", message.text)
    if begin and not any(parameter.name == begin[1] for parameter in named):
        same = [parameter for parameter in candidates if parameter.name == begin[1]]
        own = [parameter for parameter in same
               if parameter.section.rpartition("/")[2].lower() in plugins]
        if own or len({parameter.section for parameter in same}) <= 2:
            named += own or same
    return named


def connect(messages, known, root):
    """Lets messages and the parameters that they name know each other."""
    for index, message in enumerate(messages):
        models = {model for source in message.sources for model in get_models(source)}
        candidates = [parameter for parameter in known if models & set(parameter.models)]
        plugins = set().union(*(read_plugins(root, source) for source in message.sources))
        for parameter in find_named(message, candidates, plugins):
            message.parameters.append(known.index(parameter))
            parameter.messages.append(index)
            start = message.text.partition(": ")[0]
            if message.limit and start.endswith(parameter.name):
                parameter.limits.append(message.limit)
