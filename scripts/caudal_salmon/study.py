# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's study: both shapes at all frequencies, the table and the figures."""

import numpy as np

from caudal import Run
from caudal.tables import get_name
from caudal_plots import style
from caudal_plots.program import ROOT
from caudal_sweep import SweepError
from caudal_sweep.case import Case
from caudal_sweep.jobs import Job, Runner
from caudal_sweep.records import Records

from . import paper, pictures

FREQUENCIES = (0.64, 0.95, 1.43)
CASES = ("fish_one", "fish_two", "fish_one_literal", "fish_two_literal", "salmon")
N_STROKES = 3  # shown of what repeats itself
REFERENCE = 0.95  # the frequency at which shapes are compared [Hz]


def run_all(folder):
    """Makes the runs that are not there yet."""
    settings = ["Body fish/Gait/Frequency=" + ", ".join(map(str, FREQUENCIES)),
                "Output/Interval of fields=0.1"]
    jobs = [Job(name, Case(ROOT / "prm" / "salmon" / f"{name}.prm", settings), {}, folder / name)
            for name in CASES]
    has_ended = Runner(Records(folder)).run(jobs)
    failed = [f"{job.name}: {job.cause}" for job in jobs if job.state == "failed"]
    if failed or not has_ended:
        raise SweepError("\n".join(failed) or "stopped: the same command goes on.")


def read_summary(folder):
    """A dictionary for each frequency, by the names of the columns without their units."""
    return Run(folder).summary.rename(columns=get_name).to_dict("records")


def write_table(folder):
    """The paper's figures beside ours."""
    lines = [f"{'shape':18}{'f [Hz]':>8}{'distance in 20 s [cm]':>24}{'mean speed [cm/s]':>20}"
             f"{'[L/s]':>8}{'<T> [J]':>11}{'T max [J]':>11}{'<P+> [W]':>11}{'gross [W]':>11}"
             f"{'[J/(kg m)]':>12}",
             f"{'':26}{'ours':>14}{'paper':>10}{'ours':>12}{'paper':>8}"]
    for case in CASES:
        for result in read_summary(folder / case):
            f = result["frequency"]
            printed = paper.RESULTS.get((case, f))
            lines.append(
                f"{case:18}{f:8.2f}{result['distance']:14.3f}"
                f"{printed[0] if printed else '-':>10}{result['mean speed']:12.4f}"
                f"{printed[1] if printed else '-':>8}{result['mean speed in body lengths']:8.4f}"
                f"{result['mean kinetic energy']:11.3e}{result['largest kinetic energy']:11.3e}"
                f"{result['mean positive power']:11.3e}{result['mean gross power']:11.3e}"
                f"{result['cost of transport']:12.4f}")
    lines += ["", "The energies of Yao et al. [W]: fish one 0.61e-4 (0.64 Hz), 1.49e-4 (0.95 and 1.43 Hz); "
              "fish two 1.73e-4 (0.95 Hz).", "", "Largest torque of each joint [N m]:"]
    for case in CASES:
        for result in read_summary(folder / case):
            torques = [value for name, value in result.items() if name.startswith("largest torque")]
            lines.append(f"{case:18}{result['frequency']:8.2f}  "
                         + "".join(f"{torque:11.3e}" for torque in torques))
    text = "\n".join(lines) + "\n\n" + paper.REASONS + "\n"
    (folder / "table.txt").write_text(text)
    print(text)


def draw_over_time(folder, cases, frequencies, title):
    """A column for each swim: distance over all of it; speed, energy and torques, which repeat
    themselves, over the first strokes."""
    swims = [(case, f) for case in cases for f in frequencies]
    figure, axes = style.make_figure(4, len(swims), 8.8, sharey="row")
    end = N_STROKES / min(frequencies)
    for column, (case, f) in enumerate(swims):
        data = Run(folder / case).read_statistics(f).rename(columns=get_name)
        time = data["time"]
        first = time <= end
        axes[0, column].plot(time, 100 * data["distance"])
        axes[0, column].set_xlim(0, time.iloc[-1])
        axes[1, column].plot(time[first], 100 * data["speed"][first])
        axes[2, column].plot(time[first], data["kinetic energy"][first])
        for joint in range(1, 7):
            axes[3, column].plot(time[first], data[f"torque of joint {joint}"][first], linewidth=0.9,
                                 label=f"joint {joint}")
        for row in (1, 2, 3):
            axes[row, column].set_xlim(0, end)
        axes[0, column].set_title(f"{case.replace('_', ' ')}, {f} Hz")
        axes[3, column].set_xlabel("time [s]")
    for row, label in enumerate(("distance [cm]", "speed of the\ncentre of mass [cm/s]",
                                 "kinetic energy [J]", "torque [N m]")):
        axes[row, 0].set_ylabel(label)
    for row in (0, 1, 2):
        axes[row, 0].set_ylim(bottom=0)
    largest = max(map(abs, axes[3, 0].get_ylim()))
    axes[3, 0].set_ylim(-1.9 * largest, 1.1 * largest)  # room for the legend
    axes[3, 0].legend(ncol=3, fontsize=7, loc="lower center", columnspacing=1., handlelength=1.2)
    figure.suptitle(title)
    return figure


def draw_power(folder):
    """Distance, energy and power over frequency for all shapes, and the paper's points."""
    figure, axes = style.make_figure(1, 3, 4.)
    for case, colour in zip(CASES, style.LINES):
        results = read_summary(folder / case)
        f = [result["frequency"] for result in results]
        for panel, name in zip(axes[0], ("distance", "mean kinetic energy", "mean gross power")):
            panel.plot(f, [result[name] for result in results], "o-", markersize=3, color=colour,
                       label=case.replace("_", " "))
        printed = [(g, *values) for (shape, g), values in paper.RESULTS.items() if shape == case]
        if printed:
            g, distance, _, energy = np.array(printed).T
            options = dict(linestyle="none", color=colour, markeredgewidth=1.4, markersize=6)
            axes[0, 0].plot(g, distance, "x", label=f"{case.replace('_', ' ')}, paper", **options)
            axes[0, 2].plot(g, energy, "x", **options)
    for panel, label in zip(axes[0], ("distance in 20 s [cm]", "mean kinetic energy [J]",
                                      "gross power [W] (x: the paper's \"energy\")")):
        panel.set_xlabel("frequency [Hz]")
        panel.set_title(label)
        panel.set_yscale("log")
    # Below all panels, in the room that this label keeps free
    axes[0, 1].set_xlabel("frequency [Hz]\n\n\n")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), ncol=4, loc="lower center")
    return figure


def draw_relations(folder):
    """Table 2: speed over frequency, with the unit that each source uses."""
    F = np.linspace(0.5, 5, 200)
    figure, axes = style.make_figure(1, 2, 4.4)
    for label, relation in paper.RELATIONS_IN_LENGTHS:
        axes[0, 0].plot(F, relation(F), label=label)
    label, relation = paper.RELATION_IN_CM
    axes[0, 1].plot(F, relation(F), label=label)
    for case, colour, marker in zip(("fish_one", "fish_two", "salmon"), style.LINES[-3:], "os^"):
        results = read_summary(folder / case)
        f = [result["frequency"] for result in results]
        options = dict(marker=marker, markersize=4, linestyle="--", color=colour,
                       label=f"model, {case.replace('_', ' ')}")
        axes[0, 0].plot(f, [result["mean speed in body lengths"] for result in results], **options)
        axes[0, 1].plot(f, [result["mean speed"] for result in results], **options)
    axes[0, 0].set_ylim(-0.5, 6)
    axes[0, 1].set_ylim(-20, 70)
    for panel, label in zip(axes[0], ("speed V [body lengths/s]", "speed V [cm/s]")):
        panel.axhline(0, color="0.5", linewidth=0.6)
        panel.set_xlim(F[0], F[-1])
        panel.set_xlabel("tail-beat frequency F [Hz]")
        panel.set_ylabel(label)
        panel.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.15), ncol=2)
    figure.suptitle("Speed over tail-beat frequency: empirical relations (units by source, as far as it says)\n"
                    "and the model: no agreement is claimed")
    return figure


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    run_all(folder)
    write_table(folder)
    style.apply()
    figures = {
        "shapes": draw_over_time(folder, ("fish_one", "fish_two"), (REFERENCE,),
                                 f"Two shapes of fish at {REFERENCE} Hz: distance, speed, energy and torques"),
        "frequencies": draw_over_time(folder, ("fish_one",), FREQUENCIES,
                                      "Fish one at three frequencies: distance, speed, energy and torques"),
        "salmon": draw_over_time(folder, ("salmon",), FREQUENCIES, "A salmon at three frequencies: distance, speed, energy and torques"),
        "power": draw_power(folder),
        "relations": draw_relations(folder),
        "swimming_shapes": pictures.draw_swimming(
            folder, [("fish_one", 0.95), ("fish_two", 0.95), ("salmon", 0.95)],
            "Three fish swimming at 0.95 Hz, seen from above"),
        "swimming_frequencies": pictures.draw_swimming(
            folder, [("fish_one", f) for f in FREQUENCIES], "Fish one swimming at three frequencies, seen from above"),
    }
    for name, figure in figures.items():
        figure.savefig(folder / f"{name}.png")
        style.close(figure)
        print(folder / f"{name}.png")
    return 0
