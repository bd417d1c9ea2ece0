"""Mesh independence: the same swim on finer and finer surfaces."""

import numpy as np

from caudal_plots import style

from . import runs

# Cells along and across, 130 to 6,050 panels; every second one has half the spacing.
MESHES = ((3, 2), (4, 3), (6, 4), (8, 6), (12, 8), (16, 12))
FINEST = (20, 14)
QUANTITIES = ("displacement a stroke", "mean kinetic energy")


def count_panels(along, across):
    return 16 * along * across + 8 * across**2 + 2


def extrapolate(values):
    """Observed order and Richardson's value of three grids, each with half the spacing."""
    coarse, middle, fine = values
    ratio = (middle - coarse) / (fine - middle) if fine != middle else 0
    if ratio <= 1:
        return None, None
    return np.log2(ratio), fine + (fine - middle) / (ratio - 1)


def main(case, folder, overrides, with_finest):
    meshes = MESHES + ((FINEST,) if with_finest else ())
    rows, text = [], []
    for along, across in meshes:
        n = count_panels(along, across)
        place = folder / f"{n}"
        runs.run(case, place, [*overrides, f"Surface/Cells along={along}",
                               f"Surface/Cells across={across}", "Integration/Torques=false",
                               "Output/Interval of fields=1e9"])
        result = runs.read_summary(place)[0]
        cpu = runs.read_log(place, r"CPU of rank 0: (\S+) s")[0]
        rows.append((n, *(result[name] for name in QUANTITIES), cpu))
        text.append(f"{n:8d}{rows[-1][1]:20.8g}{rows[-1][2]:20.8g}{cpu:12.2f}")
        print(text[-1], flush=True)
    n, *values, _ = np.array(rows).T
    similar = slice(len(MESHES) - 5, len(MESHES), 2)
    header = f"{'panels':>8}{'a stroke [cm]':>20}{'<T> [J]':>20}{'CPU [s]':>12}"
    text.insert(0, header)
    limits = []
    for name, value in zip(QUANTITIES, values):
        order, limit = extrapolate(value[similar])
        limits.append(value[-1] if limit is None else limit)
        text.append(f"{name}: " + ("the differences do not decrease; no order"
                                   if order is None else
                                   f"observed order {order:.2f}, Richardson's value {limit:.8g} "
                                   f"({n[similar].astype(int)} panels)"))
    (folder / "mesh.txt").write_text("\n".join(text) + "\n")
    print("\n".join(text[len(meshes) + 1:]))
    style.apply()
    figure, axes = style.make_figure(1, 1, 3.6)
    for name, value, limit in zip(QUANTITIES, values, limits):
        axes[0, 0].loglog(n, np.maximum(abs(value / limit - 1), 1e-8), "o-", markersize=3, label=name)
    axes[0, 0].set_xlabel("panels")
    axes[0, 0].set_ylabel("relative difference from Richardson's value")
    axes[0, 0].legend()
    figure.savefig(folder / "mesh.png")
    style.close(figure)
    print(folder / "mesh.txt", folder / "mesh.png", sep="\n")
    return 0
