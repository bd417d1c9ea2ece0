# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the swim of 20 s at three frequencies costs, beside the paper's hour for one."""

import argparse
import pathlib
import re
import resource
import tempfile

from caudal import Run
from caudal_plots.program import ROOT
from caudal_sweep import SweepError
from caudal_sweep.case import call, find_cause

CASE = ROOT / "prm" / "salmon" / "salmon.prm"
MEASURED = ((6, 5), (21, 14))  # cells along and across: 682 and 6,274 panels


def run(folder, settings):
    """Runs the case into a folder; returns s of CPU."""
    options = [word for setting in [f"Output/Folder={folder}", *settings] for word in ("-D", setting)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    text, code = call([CASE, *options], cwd=ROOT)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if code != 0:
        raise SweepError(find_cause(text, code))
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def get_peak_memory():
    """Of the largest run until now [MiB]."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def read_log(folder, pattern):
    """The numbers of the first match of a regular expression in log.txt."""
    match = re.search(pattern, (pathlib.Path(folder) / "log.txt").read_text(encoding="utf-8"))
    return [float(group) for group in match.groups()]


def measure(along, across, torques, folder):
    cpu = run(folder, [f"Surface/Cells along={along}", f"Surface/Cells across={across}",
                       f"Integration/Torques={str(torques).lower()}",
                       "Output/Interval of fields=1e9"])
    table, assembly, solution, gradient = read_log(
        folder, r"shapes, (\S+) s of CPU.*assembly (\S+) s, solution (\S+) s, "
                r"gradient of the energy (\S+) s")
    simulation = read_log(folder, r"CPU of rank 0: (.*) s")[0]
    result = Run(folder).summary
    panels = 16 * along * across + 8 * across**2 + 2
    print(f"{panels:8d}{'yes' if torques else 'no':>9}{cpu:10.2f}{cpu - simulation:10.2f}"
          f"{assembly:10.2f}{solution:10.2f}{gradient:10.2f}"
          f"{table - assembly - solution - gradient:10.2f}{simulation - table:10.2f}"
          f"{result['displacement a stroke [cm]'][0]:11.5f}{get_peak_memory():9.0f}", flush=True)


def main(arguments):
    parser = argparse.ArgumentParser(prog="scripts/benchmark salmon", description=__doc__)
    parser.add_argument("--large", action="store_true", help="also with 6,274 panels (minutes)")
    options = parser.parse_args(arguments)
    print("20 s of swimming at 0.64, 0.95 and 1.43 Hz from one table of phases; s of CPU.\n"
          "The paper: about one hour for each, 681 panels. Figure to reach: 2 s, 1.57 cm a stroke.\n")
    print(f"{'':>17}{'':>10}{'of which':>10}\n"
          f"{'panels':>8}{'torques':>9}{'process':>10}{'loading':>10}{'assembly':>10}"
          f"{'solution':>10}{'gradient':>10}{'shapes':>10}{'swims':>10}{'cm/stroke':>11}{'MiB':>9}")
    with tempfile.TemporaryDirectory() as folder:
        measure(*MEASURED[0], False, folder + "/plain")
        measure(*MEASURED[0], True, folder + "/torques")
        if options.large:
            measure(*MEASURED[1], True, folder + "/large")
    return 0
