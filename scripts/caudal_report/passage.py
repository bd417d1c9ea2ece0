# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a run of the model `passage`, for a permit application: two printed pages."""

import numpy as np

from caudal import read_parameters
from caudal_plots import style
from caudal_plots.passage import BANDS, MEDIAN, Answers, draw_matrix, name_discharge

from . import common, files, page
from .chart import make_chart, make_curve

MOST_FATIGUE = 2.  # that is drawn
DISTANCE = "distance from the entrance [m]"
WORDS = {"green": "enough fish pass", "amber": "the median fish passes, too many others do not",
         "red": "most fish do not pass"}
METHOD = (
    "Fatigue adds up linearly along the way s, dD = ds/((U − V) T(U)): V is the velocity of the water, "
    "U the swimming speed, T(U) how long the fish can hold it. It passes if D stays up to 1. With the "
    "best speed everywhere D = ∫ ds/X(V(s)), X(V) = max (U − V) T(U).",
    "A band is a quantile of the fish in the spread of the endurance law: 87.5 % of the fish exceed the "
    "lower limit of the band that holds 75 % of them, 97.5 % that of 95 %. The share that passes is taken "
    "over this spread and over the distribution of lengths.",
    "Drops of the height h ask for the speed √(2 g h), in a leap or, in a slot, against the jet. The "
    "largest velocity is the water's largest one, without drops and slots, times the factor on all these "
    "velocities with which the fish just passes.")


def percent(share):
    return "less than 0.1 %" if 0 < share < 1e-3 else f"{100 * share:.3g} %"


def make_answer(facts):
    """The verdicts in a line each, the whole in colours."""
    rows = []
    for verdict in facts["verdicts"]:
        colour = page.Html('<b class="verdict {}">{}</b>').format(verdict["colour"],
                                                                 percent(verdict["share"]))
        rows.append([name_discharge(verdict["discharge"]), colour,
                     verdict["sentence"] + (" " + verdict["design"] if "design" in verdict else "")])
    return page.make_table(("discharge", "pass", "what happens"), rows,
                           "Share of the fish that pass: green 87.5 % or more, amber half or more, "
                           "red less.", left=(0, 1, 2))


def format_if_any(value):
    return page.format_number(value, 3) if value else "none"


def make_band_table(facts):
    rows = []
    for verdict in facts["verdicts"]:
        for band in verdict["bands"]:
            if band["name"] not in BANDS:
                continue
            end = "passes" if band["passes"] else f"{band['cause']} at {band['place']:.3g} m"
            rows.append([name_discharge(verdict["discharge"]), band["name"], percent(band["better"]),
                         end, page.format_number(band["fatigue"], 3),
                         percent(band["velocity factor"] - 1) if band["velocity factor"] > 0 else "–",
                         format_if_any(band["largest velocity"]),
                         format_if_any(band["smallest length"]),
                         page.format_number(band["time"], 3)]
                        + ([page.format_number(band["energy"], 3)] if facts["energy"] else []))
    header = ["discharge", "fish", "better fish", "verdict", "fatigue [1]", "margin of velocity",
              "largest velocity [m/s]", "smallest length [m]", "time [s]"]
    return page.make_table(header + (["energy [J]"] if facts["energy"] else []), rows,
                           "Fish of the mean length. Margin: by how much all velocities along the way may "
                           "grow, or have to fall; those in drops and slots stay as they are.", left=(0, 1, 3))


def make_inputs(facts, entries):
    """What the engineer has given."""
    rows = [("fish", f"{facts['species']}, mean length {facts['mean length']:g} m, minimum depth "
             f"{facts['minimum depth']:g} m"),
            ("endurance", facts["endurance"]), ("way", facts["way"]),
            ("velocity factor", f"{facts['velocity factor']:g}"), ("strategy", facts["strategy"])]
    if facts["energy"]:
        rows.append(("energy", facts["energy"]))
    named = {("Fish", "Standard deviation of length"): "standard deviation of length [m]",
             ("Fish", "Length classes"): "length classes [m, fish]",
             ("Passage/Profile", "Table"): "profile [m, m/s, m]",
             ("Passage", "Drops"): "drops [m, m, m]", ("Passage", "Rests"): "rests [m, 1]",
             ("Passage", "Rest spacing"): "distance between rests [m]"}
    for section, entry, value, default in entries:
        if (section, entry) in named and value not in ("", "0", default):
            rows.append((named[section, entry], value))
    return page.make_table(("input", "value"), rows, left=(0, 1))


def make_charts(answers):
    """Fatigue of the bands and speeds of the median fish where the fewest pass of those that enter."""
    verdicts = sorted(answers.facts["verdicts"], key=lambda verdict: verdict["share"])
    verdict = next((v for v in verdicts if answers.get_way(v, MEDIAN) is not None), verdicts[0])
    where = name_discharge(verdict["discharge"])
    fatigue, speeds = [], []
    for band, colour in zip(BANDS, style.LINES):
        way = answers.get_way(verdict, band)
        if way is not None:
            shown = np.where(way["fatigue"] <= MOST_FATIGUE, way["fatigue"], np.nan)
            fatigue.append(make_curve(band, way["distance"], shown, colour))
    way = answers.get_way(verdict, MEDIAN)
    if way is not None:
        ends = [way["distance"].min(), way["distance"].max()]
        fatigue.append(make_curve("exhausted", ends, [1, 1], "#444444", dash="5 3"))
        for name, colour in (("water velocity", style.LINES[0]), ("swimming speed", style.LINES[1])):
            speeds.append(make_curve(name, way["distance"], way[name], colour))
        speeds.append(make_curve("speed over ground", way["distance"],
                                 way["swimming speed"] - way["water velocity"], style.LINES[2]))
    charts = []
    if fatigue:
        charts.append(make_chart(f"Fatigue along the way, {where}", DISTANCE, "fatigue D [1]",
                                 fatigue, zero=True))
    if speeds:
        charts.append(make_chart(f"Speeds of the median fish, {where}", DISTANCE, "speed [m/s]",
                                 speeds, zero=True))
    return charts


def make_list(texts):
    return page.make_element("ul", page.join(page.make_element("li", text) for text in texts),
                             'class="facts"')


def make_strikes(facts):
    rows = [[page.format_number(strike["r/R"], 3), percent(strike["probability"])]
            for strike in facts["strikes"]]
    return page.make_table(("place on the blade r/R", "probability of a strike"), rows,
                           "Franke et al. 1997, doi:10.2172/563213; a fish of the mean length.",
                           left=())


def describe(folder):
    """The page of a run; MissingData if what it can't do without is not there."""
    answers, log = Answers(folder), files.Log(folder)
    entries, facts = read_parameters(folder), answers.facts
    colour, discharge = answers.hardest["colour"], answers.hardest["discharge"]
    where = f" at {name_discharge(discharge)}" if discharge > 0 else ""
    report = page.Page(f"Can this fish pass? {facts['species']}, {facts['mean length']:g} m",
                       f"{folder.resolve().name}: {WORDS[colour]}{where}; {common.make_state(log)}.")
    marks = dict.fromkeys(mark for verdict in facts["verdicts"] for mark in verdict["marks"])
    report.add("Verdict", make_answer(facts) + page.join(
        page.make_element("p", mark, 'class="warning"') for mark in marks))
    report.add("Fish of the bands", make_band_table(facts))
    charts = make_charts(answers)
    report.add("Along the way", report.place_charts(charts) if charts else
               page.make_note("No fish enters."))
    if (folder / "batch.csv").is_file():
        report.add("Other fish", common.draw_picture(
            report, lambda: draw_matrix(answers), "The fish of the batch at all discharges"))
    if facts["strikes"]:
        report.add("Down through the turbine", make_strikes(facts))
    report.add("Inputs", make_inputs(facts, entries))
    report.add("Method", make_list(METHOD) + page.make_note(
        "Castro-Santos 2005, J. Exp. Biol. 208, 421-432, doi:10.1242/jeb.01380; Katopodis and Gervais "
        "2016, DFO Can. Sci. Advis. Sec. Res. Doc. 2016/002."))
    report.add("Limits of validity", make_list(facts["limits"]) + page.make_details(
        "Program, machine and all parameters",
        common.make_program(log) + common.make_parameters(entries, folder)))
    return report
