# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the fish of a school gain over a lone one: two runs, which must be comparable."""

import math
import re

from caudal import MissingData, Run, read_parameters

from . import page, tables

# What may differ between them: company, place and tank, how long they swim, and what is only
# observed or kept. Schools need more cells, and their fish may beat in phases of their own.
MAY_DIFFER = re.compile("Bodies|Libraries|Time/End time|Refinement/Largest number of cells|"
                        "(Domain|Output|Checkpoint|Guards)/.*|Fluid/(Probes|Control volume)|"
                        "Body/(Monitored points|Shape/(Position|Rotation)|Muscle/.*/Phase)")
WITHOUT_LATERAL_FORCE = ("travelling wave", "fibres", "none")  # of the muscles
MOST_TOLD = 4  # differences


def name_values(entries):
    """The values of parameters by "section/entry"."""
    return {f"{section}/{entry}".lstrip("/"): value for section, entry, value, _ in entries}


def get_cell_size(values):
    """The widths of the finest cells of the fluid [m], which a tank of another size can have, too."""
    lengths, cells = (values[f"Domain/{name}"].split(",") for name in ("Size", "Cells"))
    halvings = int(values["Domain/Levels"]) - 1
    return ", ".join(f"{float(length) / float(n) / 2**halvings:g}"
                     for length, n in zip(lengths, cells))


def has_effect(path, values):
    """Whether an entry matters beside the others: one of a type that was not chosen does not. The
    lone fish of prm/ has some that it got from the file that it includes."""
    section, _, entry = path.rpartition("/")
    around, _, name = section.rpartition("/")
    if values.get(f"{around}/Type", name).lower() != name.lower():
        return False
    if entry == "Force distribution":
        return values[f"{section}/Type"] not in WITHOUT_LATERAL_FORCE
    if entry == "Feedback directions":
        return any(float(values[f"{section}/Feedback {name}"]) for name in ("stiffness", "damping"))
    return True


def describe_fish(values, report):
    """All that decides how a fish swims, as texts by their names: the parameters that are not those
    of other bodies or may differ, the grid, and by its constants what it has from files."""
    own = f"Body {report['body']}/"
    fish = {"Body/" + path.removeprefix(own) if path.startswith(own) else path: value
            for path, value in values.items()}
    fish = {path: value for path, value in fish.items() if has_effect(path, fish)
            and not path.startswith("Body ") and not MAY_DIFFER.fullmatch(path)}
    return {**fish, "finest cells [m]": get_cell_size(values),
            **{name: f"{constant['value']:.6g}" for name, constant in report["constants"].items()}}


def read_words(text):
    """The numbers and other words of a value: 0.0020 is 2e-3."""
    for word in re.split("[,;]", text):
        try:
            yield float(word)
        except ValueError:
            yield word.strip()


def is_same(text, other):
    words, others = list(read_words(text)), list(read_words(other))
    return len(words) == len(others) and all(
        a == b or (isinstance(a, float) and isinstance(b, float) and math.isclose(a, b, rel_tol=1e-5))
        for a, b in zip(words, others))


def find_differences(fish, lone):
    """What the lone fish has otherwise, in words. What only one of them has follows from an entry
    of both, a type or the regions."""
    return [f"{name} is <{lone[name]}> there, <{text}> here"
            for name, text in fish.items() if name in lone and not is_same(text, lone[name])]


def read_lone(folder):
    """Parameters and swim report of the run of a lone fish."""
    values = name_values(read_parameters(folder))
    bodies = [name for name in values.get("Bodies", "").split(",") if name.strip()]
    reports = [report for report in Run(folder).swims.values() if report["beats"]]
    if len(bodies) != 1 or len(reports) != 1:
        raise MissingData(f"--lone {folder}: bodies there: {len(bodies)}, with whole tail beats: "
                          f"{len(reports)}. Give the folder of a run of one fish.")
    return values, reports[0]


def make_school_section(entries, reports, folder):
    """The table of the gain over a lone fish, whose run is in the folder."""
    lone_values, lone = read_lone(folder)
    lone_fish, values = describe_fish(lone_values, lone), name_values(entries)
    for report in reports:
        differences = find_differences(describe_fish(values, report), lone_fish)
        if differences:
            more = len(differences) - MOST_TOLD
            raise MissingData(f"--lone {folder}: the fish there is not that of {report['body']}: "
                              + "; ".join(differences[:MOST_TOLD])
                              + (f"; and {more} more" if more > 0 else "")
                              + ". Give the run of an equal fish.")
    unsteady = [report["body"] for report in [lone, *reports] if not report["steady beats"]]
    return tables.make_school_table(reports, lone) + page.make_note(
        page.escape(f"In brackets: gain over the lone fish of {folder}. Means of the steady beats; "
                    "without any, the last beat.")
        + (" " + page.make_element("b", f"Not steady: {', '.join(dict.fromkeys(unsteady))}.")
           if unsteady else ""))
