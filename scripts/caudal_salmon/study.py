"""The paper's study: both shapes at all frequencies, the table and the figures."""

import numpy as np

from caudal_plots import style

from . import paper, pictures, runs

FREQUENCIES = (0.64, 0.95, 1.43)
CASES = ("fish_one", "fish_two", "fish_one_literal", "fish_two_literal", "salmon")
REFERENCE = 0.95  # the frequency at which shapes are compared [Hz]


def run_all(folder):
    for case in CASES:
        cost = runs.run(runs.ROOT / "prm" / "salmon" / f"{case}.prm", folder / case,
                        ["Gait/Frequency=" + ", ".join(map(str, FREQUENCIES)),
                         "Output/Interval of fields=0.1"])
        print(f"{case}: " + ("known already" if cost is None else f"{cost:.1f} s of CPU"), flush=True)


def write_table(folder):
    """The paper's figures beside ours."""
    lines = [f"{'shape':18}{'f [Hz]':>8}{'distance in 20 s [cm]':>24}{'mean speed [cm/s]':>20}"
             f"{'[L/s]':>8}{'<T> [J]':>11}{'T max [J]':>11}{'<P+> [W]':>11}{'gross [W]':>11}"
             f"{'[J/(kg m)]':>12}",
             f"{'':26}{'ours':>14}{'paper':>10}{'ours':>12}{'paper':>8}"]
    for case in CASES:
        for result in runs.read_summary(folder / case):
            f = result["frequency"]
            printed = paper.RESULTS.get((case, f))
            lines.append(
                f"{case:18}{f:8.2f}{result['distance']:14.3f}"
                f"{printed[0] if printed else '-':>10}{result['mean speed']:12.4f}"
                f"{printed[1] if printed else '-':>8}{result['mean speed in body lengths']:8.4f}"
                f"{result['mean kinetic energy']:11.3e}{result['largest kinetic energy']:11.3e}"
                f"{result['mean positive power']:11.3e}{result['mean gross power']:11.3e}"
                f"{result['cost of transport']:12.4f}")
    lines += ["", "The paper's energies [W]: fish one 0.61e-4 (0.64 Hz), 1.49e-4 (0.95 and 1.43 Hz); "
              "fish two 1.73e-4 (0.95 Hz).", "", "Largest torque of each joint [N m]:"]
    for case in CASES:
        for result in runs.read_summary(folder / case):
            torques = [value for name, value in result.items() if name.startswith("largest torque")]
            lines.append(f"{case:18}{result['frequency']:8.2f}  "
                         + "".join(f"{torque:11.3e}" for torque in torques))
    text = "\n".join(lines) + "\n\n" + paper.REASONS + "\n"
    (folder / "table.txt").write_text(text)
    print(text)


def draw_over_time(folder, cases, frequencies, title):
    """Distance, speed, energy and torques over time: a column for each swim."""
    swims = [(case, f) for case in cases for f in frequencies]
    figure, axes = style.make_figure(4, len(swims), 8.4, sharex="col", sharey="row")
    for column, (case, f) in enumerate(swims):
        data = runs.read_statistics(folder / case, f)
        time = data["time"]
        axes[0, column].plot(time, 100 * data["distance"])
        axes[1, column].plot(time, 100 * data["speed"])
        axes[2, column].plot(time, data["kinetic energy"])
        for joint in range(1, 7):
            axes[3, column].plot(time, data[f"torque of mode {joint}"], linewidth=0.8,
                                 label=f"joint {joint}")
        axes[0, column].set_title(f"{case.replace('_', ' ')}, {f} Hz")
        axes[3, column].set_xlabel("time [s]")
        axes[3, column].set_xlim(0, time[-1])
        for row in (1, 2, 3):
            axes[row, column].set_xlim(0, time[-1])
    for row, label in enumerate(("distance [cm]", "speed of the\ncentre of mass [cm/s]",
                                 "kinetic energy [J]", "torque [N m]")):
        axes[row, 0].set_ylabel(label)
    axes[3, 0].legend(ncol=2, fontsize=6)
    figure.suptitle(title)
    return figure


def draw_power(folder):
    """Energy and power over frequency for all shapes."""
    figure, axes = style.make_figure(1, 3, 3.2)
    for case in CASES:
        results = runs.read_summary(folder / case)
        f = [result["frequency"] for result in results]
        for panel, name in zip(axes[0], ("distance", "mean kinetic energy", "mean gross power")):
            panel.plot(f, [result[name] for result in results], "o-", markersize=3,
                       label=case.replace("_", " "))
    for case, marker in (("fish_one", "x"), ("fish_two", "+")):
        points = [(f, *values) for (shape, f), values in paper.RESULTS.items() if shape == case]
        f, distance, _, energy = np.array(points).T
        axes[0, 0].plot(f, distance, marker, color="black", label=f"paper, {case.replace('_', ' ')}")
        axes[0, 2].plot(f, energy, marker, color="black")
    for panel, label in zip(axes[0], ("distance in 20 s [cm]", "mean kinetic energy [J]",
                                      "gross power [W]\n(crosses: the paper's \"energy\")")):
        panel.set_xlabel("frequency [Hz]")
        panel.set_ylabel(label)
        panel.set_yscale("log")
    axes[0, 0].set_ylim(bottom=0.02)
    axes[0, 0].legend(fontsize=6, loc="lower right", ncol=2)
    return figure


def draw_relations(folder):
    """Table 2: speed over frequency, with the unit that each source uses."""
    F = np.linspace(0.5, 5, 200)
    figure, axes = style.make_figure(1, 2, 3.6)
    for label, relation in paper.RELATIONS_IN_LENGTHS:
        axes[0, 0].plot(F, relation(F), label=label)
    label, relation = paper.RELATION_IN_CM
    axes[0, 1].plot(F, relation(F), label=label)
    for case in ("fish_one", "fish_two", "salmon"):
        results = runs.read_summary(folder / case)
        f = [result["frequency"] for result in results]
        options = dict(marker="o", markersize=3, linestyle="--", label=case.replace("_", " "))
        axes[0, 0].plot(f, [result["mean speed in body lengths"] for result in results], **options)
        axes[0, 1].plot(f, [result["mean speed"] for result in results], **options)
    axes[0, 0].set_ylim(-0.5, 6)
    axes[0, 1].set_ylim(-20, 70)
    for panel, label in zip(axes[0], ("speed V [body lengths/s]", "speed V [cm/s]")):
        panel.axhline(0, color="0.5", linewidth=0.6)
        panel.set_xlabel("tail-beat frequency F [Hz]")
        panel.set_ylabel(label)
        panel.legend(fontsize=6)
    figure.suptitle("empirical relations of table 2 (units by source, as far as it says) and the "
                    "model: no agreement is claimed")
    return figure


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    run_all(folder)
    write_table(folder)
    style.apply()
    figures = {
        "shapes": draw_over_time(folder, ("fish_one", "fish_two"), (REFERENCE,),
                                 "the two shapes (the paper's figures 5 to 7)"),
        "frequencies": draw_over_time(folder, ("fish_one",), FREQUENCIES,
                                      "fish one at three frequencies (figures 10 to 12)"),
        "salmon": draw_over_time(folder, ("salmon",), FREQUENCIES, "an outline of a real salmon"),
        "power": draw_power(folder),
        "relations": draw_relations(folder),
        "swimming_shapes": pictures.draw_swimming(
            folder, [("fish_one", 0.95), ("fish_two", 0.95), ("salmon", 0.95)],
            "swimming at 0.95 Hz (figures 8 and 9)"),
        "swimming_frequencies": pictures.draw_swimming(
            folder, [("fish_one", f) for f in FREQUENCIES], "fish one (figure 13)"),
    }
    for name, figure in figures.items():
        figure.savefig(folder / f"{name}.png")
        style.close(figure)
        print(folder / f"{name}.png")
    return 0
