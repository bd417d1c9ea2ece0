"""What the swim of 20 s at three frequencies costs, beside the paper's hour for one."""

import argparse
import tempfile

from . import runs

CASE = runs.ROOT / "prm" / "salmon" / "salmon.prm"
MEASURED = ((6, 5), (20, 14))  # cells along and across: 682 and 6,050 panels


def measure(along, across, torques, folder):
    cpu = runs.run(CASE, folder, [f"Surface/Cells along={along}", f"Surface/Cells across={across}",
                                  f"Integration/Torques={str(torques).lower()}",
                                  "Output/Interval of fields=1e9"])
    table, assembly, solution = runs.read_log(
        folder, r"shapes, (\S+) s of CPU.*assembly (\S+) s, solution (\S+) s")
    results = runs.read_summary(folder)
    panels = 16 * along * across + 8 * across**2 + 2
    print(f"{panels:8d}{'yes' if torques else 'no':>9}{cpu:11.2f}{table:11.2f}{assembly:11.2f}"
          f"{solution:11.2f}{runs.read_log(folder, r'CPU of rank 0: (.*) s')[0] - table:11.2f}"
          f"{results[0]['displacement a stroke']:12.5f}", flush=True)


def main(arguments):
    parser = argparse.ArgumentParser(prog="scripts/benchmark salmon", description=__doc__)
    parser.add_argument("--large", action="store_true", help="also with 6,000 panels (minutes)")
    options = parser.parse_args(arguments)
    print("20 s of swimming at 0.64, 0.95 and 1.43 Hz from one table of 32 phases; s of CPU.\n"
          "The paper: about one hour for each, 681 panels. Figure to reach: 2 s, 1.57 cm a stroke.\n")
    print(f"{'panels':>8}{'torques':>9}{'process':>11}{'table':>11}{'assembly':>11}{'solution':>11}"
          f"{'the swims':>11}{'cm/stroke':>12}")
    with tempfile.TemporaryDirectory() as folder:
        measure(*MEASURED[0], False, folder + "/plain")
        measure(*MEASURED[0], True, folder + "/torques")
        if options.large:
            measure(*MEASURED[1], False, folder + "/large")
    return 0
