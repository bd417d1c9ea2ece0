# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table on the screen and as Markdown, and the plots."""

import math

from caudal_plots import style


def format_number(value):
    return "-" if value is None else f"{value:.5g}"


def format_gate(gate):
    if gate is None:
        return "-"
    if isinstance(gate, tuple):
        low, high = gate
        return f">= {low:g}" if math.isinf(high) else f"{low:.4g} to {high:.4g}"
    return f"{100 * gate:g} %"


def make_row(case, figure):
    error = "-" if figure.error is None else f"{100 * figure.error:+.2f}"
    verdict = "-" if figure.gate is None else "ok" if figure.is_ok else "off"
    return (case, figure.name, format_number(figure.value), format_number(figure.reference), error,
            format_gate(figure.gate), verdict)


HEADER = ("case", "quantity", "value", "reference", "error %", "gate", "")
WIDTHS = (22, 46, 12, 12, 9, 20, 4)


def format_row(row):
    return "".join(f"{cell:<{width}}" for cell, width in zip(row, WIDTHS)).rstrip()


def write_markdown(path, tables):
    """`tables`: the figures by the name of the case."""
    lines = ["| " + " | ".join(HEADER) + " | |", "|" + "---|" * (len(HEADER) + 1)]
    for case, figures in tables.items():
        for figure in figures:
            lines.append("| " + " | ".join(make_row(case, figure) + (figure.note,)) + " |")
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def plot(path, case, runs, figures):
    """The curves of a case over time; mean and extremes of the references as lines."""
    style.apply()
    picture, axes = style.make_figure(len(case.curves), 1, 1.7 * len(case.curves), sharex=True)
    any_reference = False
    for axis, column in zip(axes[:, 0], case.curves):
        for number, run in enumerate(runs, 1):
            axis.plot(run.time, run.get(column), label=f"run {number}")
        header = next(name for name in runs[0].columns if name.partition(" [")[0] == column)
        axis.set_ylabel(header.replace(": ", "\n", 1).replace(" of ", "\nof ", 1)
                        .replace(" by ", "\nby ", 1))
        if not case.from_start:
            limit_to_late_values(axis, runs, column)
        any_reference |= draw_reference(axis, column, runs[0], figures)
    if len(runs) > 1:
        axes[0, 0].legend()
    axes[-1, 0].set_xlabel("time [s]")
    axes[0, 0].set_title(f"{case.name}: {case.purpose}"
                         + ("; dashed: mean and extremes of the reference" if any_reference else ""))
    picture.savefig(path)
    style.close(picture)


def limit_to_late_values(axis, runs, column):
    """The start-up may go beyond the plot's top and bottom."""
    late = [run.get(column)[run.time >= 0.3 * run.time[-1]] for run in runs]
    low, high = min(map(min, late)), max(map(max, late))
    margin = 0.15 * (high - low) or 0.1 * abs(high) or 1.
    axis.set_ylim(low - margin, high + margin)


def draw_reference(axis, column, run, figures):
    """Dashed lines from the figures whose label starts like the column's quantity, if any."""
    names = {"force x": "drag [N/m]", "force y": "lift [N/m]", "x of point 1": "ux [mm]",
             "y of point 1": "uy [mm]"}
    label = next((label for key, label in names.items() if key in column), None)
    known = {figure.name: figure.reference for figure in figures}
    mean = known.get(f"{label} mean")
    if mean is None:
        return False
    amplitude = known.get(f"{label} amplitude") or 0.
    # Displacements are in mm from where the point was at the start.
    factor, offset = (1e-3, run.get(column)[0]) if label.startswith("u") else (1., 0.)
    for level in {mean, mean - amplitude, mean + amplitude}:
        axis.axhline(offset + factor * level, color="0.4", linestyle="--", linewidth=0.8)
    return True
