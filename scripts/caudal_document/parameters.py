# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of all models, as the program prints them."""

import dataclasses
import pathlib
import re
import subprocess
import tempfile

# What the program calls its models, and what they are.
MODELS = {"immersed": "viscous fluid", "potential": "ideal fluid", "passage": "passage",
          "elastic": "no fluid"}


@dataclasses.dataclass
class Parameter:
    """An entry of a section; models that say the same of it share one."""
    section: str  # "Body <name>/Shape"; empty: outside of all sections
    name: str
    default: str
    allowed: str
    meaning: str
    models: list
    cases: dict = dataclasses.field(default_factory=dict)  # paths of cases by the value they set
    messages: list = dataclasses.field(default_factory=list)  # indices of those that name it
    limits: list = dataclasses.field(default_factory=list)  # what checks ask of its value

    @property
    def path(self):
        return f"{self.section}/{self.name}".lstrip("/")

    @property
    def range(self):
        """What is allowed, with what the program checks of a number; where checks differ between
        models, the one that leaves more."""
        limits = set(self.limits) - ({"> 0"} if {"> 0", "≥ 0"} <= set(self.limits) else set())
        if ">=" in self.allowed:  # the pattern says it already, unless it has no upper limit
            limits -= {"> 0", "≥ 0"}
            if limits:
                return " ".join([self.allowed.partition(" >=")[0], *sorted(limits)])
        glue = ", a number " if self.allowed.startswith("any text") and limits else " "
        return glue.join([self.allowed, ", ".join(sorted(limits))]).strip()

    @property
    def units(self):
        """The units in the text, such as m/s of "[m/s]"."""
        units = re.findall(r"\[((?:[\w%/^. ()-]|\*)+)\]", self.meaning)
        return list(dict.fromkeys(units))


def generalise(section):
    """A section's path with <name> and <region> for the names of bodies and their regions."""
    section = re.sub(r"^Body [^/]*", "Body <name>", section)
    return re.sub(r"^(Body <name>/)Region [^/]*", r"\1Region <region>", section)


def parse_markdown(text, model):
    """The parameters in the tables that `caudal --print-parameters md` prints."""
    section, parameters = "", []
    for line in text.splitlines():
        if line.startswith("## "):
            section = generalise(line.removeprefix("## ").strip())
        elif line.startswith("| ") and not line.startswith("| Entry |"):
            cells = [cell.strip().replace(r"\|", "|")
                     for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
            name, default, allowed, meaning = cells
            parameters.append(Parameter(section, name, default.strip("`"), allowed, meaning, [model]))
    return parameters


def print_parameters(program, model, dimension=2):
    """What the program prints of the parameters of a model; those of the first one, whose bodies
    and regions can have any names, are what it prints without a case."""
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "case.prm"
        bodies = "set Bodies = body\n" if model == "elastic" else ""
        spatial = "set Dimension = 3\n" if dimension == 3 else ""
        case.write_text(f"set Model = {model}\n{spatial}{bodies}", encoding="utf-8")
        arguments = [] if model == "immersed" and not spatial else [str(case)]
        return subprocess.run([program, "--print-parameters", "md", *arguments], check=True,
                              capture_output=True, text=True).stdout


def read_parameters(program):
    """The parameters of all models. Sections stand in the order of the first model that has them;
    what models say differently of an entry are several parameters, one after the other."""
    sections = {}
    for model in MODELS:
        for parameter in parse_markdown(print_parameters(program, model), model):
            if parameter.path == "Bodies" and parameter.default in ("body", "<name>"):
                parameter.default = ""
            known = sections.setdefault(parameter.section, {}).setdefault(parameter.name, [])
            same = [other for other in known if (other.default, other.allowed, other.meaning) ==
                    (parameter.default, parameter.allowed, parameter.meaning)]
            if same:
                same[0].models.append(model)
            else:
                known.append(parameter)
    # Of three dimensions only what two don't have: the sides back and front.
    for parameter in parse_markdown(print_parameters(program, "immersed", 3), "immersed"):
        known = sections.setdefault(parameter.section, {}).setdefault(parameter.name, [])
        if not known:
            parameter.meaning = "In three dimensions: " + parameter.meaning
            known.append(parameter)
    return [parameter for entries in sections.values() for variants in entries.values()
            for parameter in variants]


def find_parameters(parameters, path, model=None):
    """The parameters with this path that a model has."""
    section, _, name = path.rpartition("/")
    return [parameter for parameter in parameters
            if parameter.name == name and parameter.section == generalise(section) and
            model in (None, *parameter.models)]
