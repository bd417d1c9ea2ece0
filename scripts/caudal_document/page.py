# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reference as one HTML page that needs no network."""

import pathlib
import re

from caudal_report.page import Html, escape, join, make_element

from .parameters import MODELS

HERE = pathlib.Path(__file__).resolve().parent


def make_name(*parts):
    """A name for links, of letters and digits."""
    return re.sub(r"[^A-Za-z0-9]+", "-", "-".join(parts)).strip("-").lower()


def make_code(text):
    return make_element("code", text)


def make_link(target, text):
    return Html('<a href="{}">{}</a>').format(target, text)


def get_anchors(parameters):
    """A name for each parameter; where several models say different things of it, with theirs."""
    anchors = []
    for parameter in parameters:
        name = make_name("p", parameter.path)
        anchors.append(name if name not in anchors else make_name(name, *parameter.models))
    return anchors


def make_models(models):
    """Marks of the models; none if it is in all."""
    if len(models) == len(MODELS):
        return Html("")
    return join(make_element("i", model, 'class="model"') for model in models)


def make_cases(parameter):
    """Which cases set a parameter, by value."""
    if not parameter.cases:
        return Html("")
    n_cases = len({case for cases in parameter.cases.values() for case in cases})
    rows = join(make_element("li", make_code(value or "(empty)") + ": " + join(
        (make_link(f"../{case}", case.removeprefix("prm/")) for case in cases), ", "))
        for value, cases in parameter.cases.items())
    words = f"set by {n_cases} case{'s' if n_cases > 1 else ''}"
    return make_element("details", make_element("summary", words) + make_element("ul", rows))


def make_complaints(parameter, messages):
    """The messages that name a parameter."""
    if not parameter.messages:
        return Html("")
    count = len(parameter.messages)
    rows = join(make_element("li", make_link(f"#m-{index}", messages[index].text))
                for index in parameter.messages)
    words = f"named by {count} message{'s' if count > 1 else ''}"
    return make_element("details", make_element("summary", words) + make_element("ul", rows),
                        'class="complaints"')


def make_parameter(parameter, anchor, messages):
    """An entry of the reference."""
    facts = [Html("default <code>{}</code>").format(parameter.default) if parameter.default
             else Html("no default"), escape(parameter.range)]
    if parameter.units:
        units = ", ".join("1 (none)" if unit in ("1", "-") else unit for unit in parameter.units)
        facts.append(Html("unit <b>{}</b>").format(units))
    title = Html('<h4><a href="#{}">{}</a>{}</h4>').format(
        anchor, parameter.name, make_models(parameter.models))
    return make_element(
        "article", title + make_element("p", join(facts, " · "), 'class="facts"') +
        make_element("p", parameter.meaning) + make_cases(parameter) +
        make_complaints(parameter, messages),
        f'id="{anchor}" data-models="{" ".join(parameter.models)}" '
        f'data-path="{escape(parameter.path)}"')


def make_section(name, title, content, level):
    return Html('<section id="{}"><h{}>{}</h{}>\n{}\n</section>').format(
        name, level, title, level, content)


def make_parameters(parameters, messages):
    """The part with the parameters, and its jump list."""
    sections, anchors = {}, get_anchors(parameters)
    for parameter, anchor in zip(parameters, anchors):
        sections.setdefault(parameter.section, []).append(
            make_parameter(parameter, anchor, messages))
    names = {section: make_name("s", section or "outside") for section in sections}
    titles = {section: section or "Outside of all sections" for section in sections}
    content = join((make_section(names[section], titles[section], join(entries, "\n"), 3)
                    for section, entries in sections.items()), "\n")
    return content, [(names[section], titles[section]) for section in sections]


def group_columns(columns):
    """Columns that follow each other and have their definition in common."""
    groups = []
    for column in columns:
        if groups and column.definition and groups[-1][0].definition == column.definition:
            groups[-1].append(column)
        else:
            groups.append([column])
    return groups


def make_columns(group, model):
    names = join((Html("<b>{}</b>{}").format(column.name, Html(" <i>[{}]</i>").format(column.unit)
                                             if column.unit else "") for column in group), " · ")
    definition = make_element("p", group[0].definition) if group[0].definition else Html("")
    return make_element("article", make_element("p", names) + definition,
                        f'class="row" data-models="{model}"')


def make_tables(tables):
    """The part with the columns of the tables, and its jump list."""
    parts, jumps = [], []
    for table in tables:
        name, title = make_name("t", table.model, table.file), f"{table.file} ({table.model})"
        rows = join((make_columns(group, table.model) for group in group_columns(table.columns)),
                    "\n")
        parts.append(make_section(name, title, rows, 3))
        jumps.append((name, title))
    return join(parts, "\n"), jumps


def make_messages(messages, parameters, root_link):
    """The part with the messages, and its jump list."""
    anchors, parts, jumps = get_anchors(parameters), [], []
    for kind, title in (("warning", "Warnings"), ("error", "Errors")):
        rows = []
        for index, message in enumerate(messages):
            if message.kind != kind:
                continue
            links = join((make_link(f"#{anchors[k]}", parameters[k].path)
                          for k in message.parameters), ", ")
            sources = join((make_link(root_link + source, source.removeprefix("source/"))
                            for source in message.sources), ", ")
            rows.append(Html('<article class="row" id="m-{}"><p>{}</p><p class="facts">{}{}</p>'
                             "</article>").format(index, message.text,
                                                  links + " · " if links else Html(""), sources))
        name = make_name("messages", kind)
        parts.append(make_section(name, f"{title} ({len(rows)})", join(rows, "\n"), 3))
        jumps.append((name, f"{title} ({len(rows)})"))
    return join(parts, "\n"), jumps


def make_jumps(title, target, jumps):
    """A part of the jump list."""
    links = join((Html('<li style="--depth:{}">{}</li>').format(
        text.count("/") if target == "parameters" else 0,
        make_link(f"#{name}", text.rpartition("/")[2] if target == "parameters" else text))
        for name, text in jumps), "\n")
    return make_link(f"#{target}", title) + make_element("ul", links)


PARTS = {
    "parameters": ("Parameters", """What a parameter file can set, as <code>set Entry = value</code>
between <code>subsection Section</code> and <code>end</code>, or <code>-D "Section/Entry=value"</code> on
the command line. <code>&lt;name&gt;</code> stands for each name in <code>Bodies</code>,
<code>&lt;region&gt;</code> for each in that body's <code>Regions</code>. Marks tell which models have an
entry: immersed (a viscous fluid), potential (an ideal fluid), passage (whether fish pass), elastic (a
body without fluid); without a mark all have it. Cases are those of the folder <code>prm</code>."""),
    "columns": ("Output columns", """What the tables and fields of a run hold, from the headers of short
runs. Columns of <code>statistics.txt</code> whose definition stands for a group of them have the one of
the group; those of a case are there if it has what they tell about, such as probes. In two dimensions
forces, energies and powers are those of one metre of span."""),
    "messages": ("Messages", """Warnings of <code>--check</code> and of runs, and what is refused, from
the sources; … stands for what a run fills in."""),
}


def render(parameters, tables, messages):
    """The page."""
    contents = {"parameters": make_parameters(parameters, messages),
                "columns": make_tables(tables),
                "messages": make_messages(messages, parameters, "../")}
    body = join((Html('<section id="{}" class="part"><h2>{}</h2>\n<p>{}</p>\n{}\n</section>').format(
        name, title, Html(words), contents[name][0])
        for name, (title, words) in PARTS.items()), "\n")
    jumps = join((make_jumps(PARTS[name][0], name, contents[name][1]) for name in PARTS), "\n")
    models = join(Html('<option value="{}">{}: {}</option>').format(name, name, words)
                  for name, words in MODELS.items())
    template = (HERE / "reference.html").read_text(encoding="utf-8")
    filled = {"STYLE": (HERE / "reference.css").read_text(encoding="utf-8"),
              "SCRIPT": (HERE / "reference.js").read_text(encoding="utf-8"),
              "MODELS": models, "JUMPS": jumps, "BODY": body}
    return re.sub(r"@(STYLE|SCRIPT|MODELS|JUMPS|BODY)@", lambda match: filled[match[1]], template)
