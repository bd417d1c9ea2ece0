# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections that the reports of both models have."""

import io
import shlex

from caudal_plots import BrokenData, MissingData, style

from . import page


def make_excuse(report, what, reason):
    """Says in the page why something is not there; damaged files are troubles of the report."""
    if isinstance(reason, BrokenData):
        report.troubles.append(str(reason))
    return page.make_note(f"{what} {reason}")


def draw_picture(report, draw, caption, dpi=120):
    """A matplotlib figure as an embedded PNG, or the reason why there is none."""
    try:
        figure = draw()
    except MissingData as reason:
        return make_excuse(report, f"{caption}: not drawn.", reason)
    data = io.BytesIO()
    figure.savefig(data, format="png", dpi=dpi)
    style.close(figure)
    return page.make_picture("png", data.getvalue(), caption)


def place_movie(report, make):
    """An animation, or the reason why there is none."""
    try:
        return report.place_movie(make())
    except MissingData as reason:
        return make_excuse(report, "No animation.", reason)


def make_warnings(log):
    if not log.warnings:
        return page.make_note("None.")
    return page.join(page.make_element(
        "p", line + (page.make_element("b", f" ({count} times)") if count > 1 else ""),
        'class="warning"') for line, count in log.warnings)


def make_next_steps(folder, log, example, has_plots=True):
    """Commands that go on from these results; @p example is an axis of a sweep."""
    name, case = shlex.quote(str(folder)), shlex.quote(f"{folder}/parameters.prm")
    steps = [(f"scripts/swim --resume {name}", "go on with the run")] if log.end != "finished" else []
    if has_plots:
        steps.append((f"scripts/plot {name} --movie", "pictures for a paper, and a film"))
    steps += [(f"scripts/paraview {name}", "a view of the fields in ParaView"),
              (f"scripts/sweep {case} \"{example}\" --dry-run", "what a study would cost"),
              (f"scripts/sweep {case} --mesh", "error bars from three grids"),
              (f"python3 -c 'import caudal; print(caudal.Run(\"{folder}\").statistics)'",
               "the tables in Python, as pandas.DataFrame")]
    return page.make_table(("command", "makes"), [(page.make_element("code", command), words)
                                                  for command, words in steps], left=(0, 1))


def make_program(log):
    """Version, machine, libraries, and what the log says on grid, body and method."""
    return page.make_element("pre", "\n".join(log.banner + [""] + log.get_facts()))


def make_timings(log):
    """The costs of the run, and a bar for each part of the program."""
    content = page.make_note(log.costs or
                             "The log tells no costs: the run goes on or has broken off.")
    if log.timings:
        largest = max(share for _, _, share in log.timings)
        rows = [(name, page.format_number(seconds), f"{share:.1f}", page.Html(
            f'<div class="bar-cell"><i style="width:{100 * share / largest:.1f}%"></i></div>'))
                for name, seconds, share in sorted(log.timings, key=lambda row: -row[1])]
        content += page.make_table(("part", "wall time [s]", "share [%]", ""), rows,
                                   left=(0, 3))
    return content


def make_parameters(entries, folder):
    """What differs from the defaults, and the whole file."""
    changed = [row for row in entries if row[-1] is not None]
    content = page.make_table(("section", "entry", "value", "default"), changed,
                              "What differs from the program's defaults; SI units.", left=range(4))
    text = (folder / "parameters.prm").read_text(encoding="utf-8", errors="replace")
    return content + page.make_details(f"All {len(entries)} parameters: parameters.prm",
                                       page.make_element("pre", text))


def make_state(log):
    """How the run ended, and what made it."""
    doubt = "RESULTS MEAN NOTHING, see the warnings; " if log.means_nothing else ""
    end = log.end or "not finished: this is what it has so far"
    if end == "failed":
        end += ": this is what it had until then"
    return f"{doubt}{end}; {log.banner[0] if log.banner else 'unknown version'}"
