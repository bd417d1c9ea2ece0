# SPDX-License-Identifier: LGPL-2.1-or-later
"""swim.json and statistics as tables for the report."""

from . import page

# Of the quantities of swim.json, in this order.
TILES = ("speed", "speed in lengths", "period", "amplitude", "Strouhal number", "Reynolds number",
         "power", "cost of transport", "numerical share")
COMPARED = ("speed", "frequency", "amplitude", "Strouhal number", "power", "cost of transport")
BEAT_COLUMNS = ("start", "period", "frequency", "amplitude", "speed", "speed in lengths",
                "Strouhal number", "power", "peak power", "cost of transport", "thrust", "drag",
                "change", "steady")
LEDGER = ("muscle work", "kinetic energy", "elastic energy", "dissipation", "feedback",
          "external work", "residual", "numerical dissipation")


def get_unit(report, name):
    return report["quantities"][name]["unit"]


def keep_on_one_line(text):
    return text.replace(" ", "\N{NO-BREAK SPACE}")


def make_heading(report, name):
    quantity = report["quantities"][name]
    unit = " " + page.make_element("small", f"[{quantity['unit']}]") if quantity["unit"] else ""
    return quantity["symbol"] + unit


def make_swim_tiles(report):
    """The key figures: of the steady beats or, without any, of the last one."""
    beat = get_key_beat(report)
    return page.make_tiles([(name, page.format_number(beat[name]), get_unit(report, name))
                            for name in TILES])


def make_swim_table(report):
    """All quantities with their definitions: the mean of the steady beats, if any, and the last one."""
    steady, last = report["mean of steady beats"], report["beats"][-1]
    rows = []
    for name, quantity in report["quantities"].items():
        if name in ("start", "steady"):
            continue
        means = [page.format_number(steady[name])] if steady else []
        rows.append([name, quantity["symbol"], *means, page.format_number(last[name]),
                     keep_on_one_line(quantity["unit"]),
                     page.make_element("small", quantity["definition"])])
    means = [f"mean of the last {report['steady beats']} beats"] if steady else []
    header = ["quantity", "symbol", *means, "last beat", "unit", "definition"]
    return page.make_table(header, rows, left=(0, 1, len(header) - 2, len(header) - 1))


def get_key_beat(report):
    """The mean of the steady beats or, without any, the last beat."""
    return report["mean of steady beats"] or report["beats"][-1]


def make_school_table(reports, lone):
    """Each fish beside the lone one: value, and gain over that."""
    reports = [report for report in reports if report["beats"]]
    alone = get_key_beat(lone)
    rows = []
    for name in COMPARED:
        row = [name, keep_on_one_line(get_unit(lone, name)), page.format_number(alone[name])]
        for report in reports:
            value = get_key_beat(report)[name]
            change = f" ({100 * (value / alone[name] - 1):+.1f}&nbsp;%)" if alone[name] else ""
            row.append(page.format_number(value) + page.Html(change))
        rows.append(row)
    return page.make_table(["quantity", "unit", "alone", *(report["body"] for report in reports)],
                           rows, left=(0, 1))


def make_beat_table(report):
    rows = [[str(number)] + ["yes" if beat[name] is True else "no" if beat[name] is False
                             else page.format_number(beat[name]) for name in BEAT_COLUMNS]
            for number, beat in enumerate(report["beats"], 1)]
    return page.make_table(["beat"] + [make_heading(report, name) for name in BEAT_COLUMNS], rows)


def make_beat_ledger(report):
    """The ledger of each beat; the residual also relative to the muscle's work."""
    rows = []
    for number, beat in enumerate(report["beats"], 1):
        work = beat["muscle work"]
        share = 100 * beat["residual"] / work if work else None
        rows.append([str(number)] + [page.format_number(beat[name]) for name in LEDGER]
                    + [page.format_number(share, 2)])
    return page.make_table(["beat"] + [make_heading(report, name) for name in LEDGER]
                           + ["residual " + page.make_element("small", "[% of muscle work]")], rows,
                           page.Html("muscle work = ΔE<sub>kin</sub> + ΔE<sub>el</sub> + dissipation "
                                     "+ feedback − external work + residual, in each tail beat; "
                                     "external work: through the sides and by the body force; "
                                     "numerical: the part of the dissipation by stabilisations and "
                                     "time scheme"))
