# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of the tables that a run writes: headers from short runs, definitions from the
sources."""

import csv
import dataclasses
import pathlib
import re
import subprocess
import tempfile

from . import cpp

HERE = pathlib.Path(__file__).resolve().parent

# Model, case and what makes it short: together they write all columns that there are.
RUNS = (
    ("immersed", HERE / "columns.prm", []),
    ("immersed", "prm/benchmarks/cfd1.prm", ["Time/End time=0.02", "Time/Step=0.01"]),
    ("elastic", "prm/benchmarks/csm1.prm", []),
    ("potential", "prm/salmon/salmon.prm",
     ["Time/End time=4", "Surface/Cells along=1", "Surface/Cells across=1",
      "Output/Interval of fields=4"]),
    ("passage", "prm/passage/culvert.prm", []),
    ("passage", "prm/passage/ramp_batch.prm", []),
    ("passage", "prm/passage/slot_fishway.prm", []),
)
# What stands in a .vtu file beside the fields.
NO_FIELDS = ("CYCLE", "TIME", "Points", "connectivity", "offsets", "types")


@dataclasses.dataclass
class Column:
    """A column of a table."""
    name: str
    unit: str
    definition: str = ""


@dataclasses.dataclass
class Table:
    """A file of a run of a model, and its columns."""
    file: str
    model: str
    columns: list


def generalise(name, bodies):
    """A column's name without what differs between bodies, points, probes, modes, joints and places."""
    for body in bodies:
        name = re.sub(rf"^{re.escape(body)}: ", "<body>: ", name)
    name = re.sub(r"\b(point|probe|mode|joint|quaternion) \d+", r"\1 <k>", name)
    return re.sub(r"at 0\.\d L", "at 0.<k> L", name)


def split_header(header):
    """("name", "unit") of "name [unit]"."""
    match = re.fullmatch(r"(.*?)(?: \[([^\[\]]*)\])?", header)
    return match[1], match[2] or ""


def read_headers(path):
    """The headers of a table: a row of them (.csv), or a line "# n: name [unit]" each."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".csv":
        return next(csv.reader(text.splitlines()))
    return re.findall(r"^# \d+: (.*\S)", text, re.MULTILINE)


def read_field_names(folder):
    """The names of the fields of each block, fluid or a body, of a run."""
    blocks = {}
    for path in sorted((folder / "fields").glob("*.vtu")):
        block = re.sub(r"(_\d+)?[-.].*", "", path.name)
        head = path.read_bytes().decode("latin-1")
        names = re.findall(r'<DataArray[^>]*\bName="([^"]+)"', head)
        blocks[block] = [name for name in names if name not in NO_FIELDS]
    return blocks


def run_case(program, root, model, case, overrides, folder):
    """The tables of a run, by file."""
    command = [program, str(root / case), "-D", f"Output/Folder={folder}"]
    for override in overrides:
        command += ["-D", override]
    ended = subprocess.run(command, capture_output=True, text=True, cwd=root, check=False)
    if ended.returncode != 0:
        raise RuntimeError(f"{case} ended with code {ended.returncode}: {ended.stderr[-500:]}")
    tables = {}
    bodies = [body.strip() for body in
              re.findall(r"^set Bodies\s*= *(.*?) *(?:#.*)?$",
                         (folder / "parameters.prm").read_text(encoding="utf-8"), re.MULTILINE)[:1]]
    for path in sorted([*folder.glob("statistics*.txt"), *folder.glob("*.csv")]):
        file = re.sub(r"_[\d.]+Hz", "_<frequency>Hz", path.name)
        names = dict.fromkeys(split_header(header) for header in read_headers(path))
        tables[file] = dict.fromkeys((generalise(name, bodies), unit) for name, unit in names)
    for block, names in read_field_names(folder).items():
        file = f"fields/{block if block == 'fluid' else '<body>'}-*.vtu"
        tables[file] = dict.fromkeys((name, "") for name in names)
    return tables


def read_comment(text, end):
    """The words of the comment /** ... */ that ends before a place."""
    begin = text.rfind("/**", 0, end)
    if begin < 0 or re.search(r"[;{}]", text[text.find("*/", begin) + 2:end]):
        return ""
    words = text[begin + 3:text.find("*/", begin)]
    return " ".join(re.sub(r"^\s*\*", "", line).strip() for line in words.splitlines()).strip()


def find_writers(root):
    """(definition, texts) of each observer: the comment of its class, and the texts in it."""
    writers = []
    for path in sorted((root / "source/observe").glob("*.cc")):
        text = path.read_text(encoding="utf-8")
        classes = list(re.finditer(r"(?:template <int dim>\s*)?class (\w+)[^;{]*\{", text))
        header = root / "include/caudal/observe" / f"{path.stem}.h"
        if not any("Observer" in match[0] for match in classes) and header.exists():
            words = header.read_text(encoding="utf-8")
            match = re.search(r"(?:template <int dim>\s*)?class \w+[^;{]*Observer[^;{]*\{", words)
            if match:
                writers.append((read_comment(words, match.start()), text))
            continue
        for match in classes:
            end = cpp.find_end(text, match.end() - 1)
            if "Observer" in match[0]:
                writers.append((read_comment(text, match.start()), text[match.end():end]))
    return [(definition, [literal[1:-1] for literal in re.findall(cpp.STRING, text)])
            for definition, text in writers if "set" in text]


def define(name, writers):
    """What the sources say of the group of columns that one belongs to."""
    plain = name.removeprefix("<body>: ")
    known = [(len(text.strip()), definition) for definition, texts in writers for text in texts
             if len(text.strip()) > 1 and text.strip() in plain]
    longest = max(known, default=(0, ""))
    return longest[1] if longest[0] >= 0.4 * len(re.sub("<k>|[xyzuvw] ", "", plain)) else ""


def read_tail_beats(root):
    """The columns of swim.txt and swim.json, from the list of quantities in the sources."""
    text = (root / "source/observe/tail_beat.cc").read_text(encoding="utf-8")
    begin = text.index("get_tail_beat_quantities()\n")
    columns = []
    for match in re.finditer(r"\{&TailBeat::\w+,", text[begin:]):
        place = begin + match.start()
        words = cpp.split(text[place + 1:cpp.find_end(text, place)], ",")
        name, symbol, unit, per_span, definition = (
            cpp.compose(words[i], text, place) if i != 4 else words[i] for i in range(1, 6))
        columns.append(Column(f"{name} ({symbol})", unit + (", 2D: " + unit + "/m" if per_span == "true" else ""),
                              definition))
    return Table("swim.txt, swim.json", "immersed", columns)


def read_tables(program, root):
    """All tables with their columns; those of several runs of a model are one."""
    tables = {}
    with tempfile.TemporaryDirectory() as folder:
        for number, (model, case, overrides) in enumerate(RUNS):
            made = run_case(program, root, model, case, overrides, pathlib.Path(folder) / str(number))
            for file, columns in made.items():
                tables.setdefault((model, file), {}).update(columns)
    writers = find_writers(root)
    result = [Table(file, model, [
        Column(name, unit, define(name, writers) if (model, file) == ("immersed", "statistics.txt") else "")
        for name, unit in columns]) for (model, file), columns in tables.items()]
    result.insert(1, read_tail_beats(root))
    return result
