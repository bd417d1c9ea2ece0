# SPDX-License-Identifier: LGPL-2.1-or-later
# scripts/benchmark scaling: what it reads from MPI and from a run's output, the tables of a small
# case on one and two ranks, the cases it makes, and its model on costs that are known. Then
# scripts/slurm with a SLURM that only says what it is told.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
write_fluid_and_disc

/usr/bin/python3 - <<'END'
import contextlib
import dataclasses
import io
import os
import pathlib
import sys

sys.path.insert(0, os.environ["CAUDAL_SOURCE_DIR"] + "/scripts")
import caudal_setup  # noqa: F401
from caudal_benchmarks import scaling, scaling_model, scaling_run
from caudal_benchmarks.scaling_series import SERIES, Series, repeat_body
from caudal_benchmarks.speed import Report

folder = pathlib.Path.cwd() / "scaling"
folder.mkdir()

print("messages and bytes to others:", scaling_run.parse_monitoring(
    "# POINT TO POINT\nE\t1\t0\t500 bytes\t7 msgs sent\t1,2\nE\t1\t1\t144 bytes\t6 msgs sent\t0\n"
    "I\t1\t0\t30 bytes\t2 msgs sent\n# COLLECTIVES\nC\t1\t0\t900 bytes\t9 msgs sent\n"))
print("calls:", scaling_run.parse_counts("Bcast 3\nAllreduce 20\nseconds_in_mpi 0.25\nseconds 2\n"))
print("output:", scaling_run.parse_output(
    "t = 1 of 2 s  step 5  dt 1 s, 64 cells, 2 iterations, max |u| 1 m/s\n"
    "10 steps in 0:02, 5 steps/s, 5 factorisations\n  factorisation   0.3 s   18.5 %\n"))

case = Series("small", "A small case", str(pathlib.Path.cwd() / "disc.prm"), (1, 1), (4, 4), 3,
              "nothing", (2, 5))
counter = scaling_run.build_counter(folder)
with contextlib.redirect_stdout(io.StringIO()):
    costs = scaling.measure_series(case, (1, 2), folder, counter)
    known = scaling.measure_series(case, (1, 2), folder, counter, only_known=True)
    report = Report()
    scaling.report_series(report, case, costs, cores=1)
print("known afterwards:", known == costs, "- on 3 ranks:",
      scaling.measure_series(case, (3,), folder, counter, only_known=True))
tables = [line.split("|")[1:-1] for line in report.lines if line.startswith("|")]
print("columns:", sorted({len(row) for row in tables}), "-", *(name.strip() for name in tables[0]))
one, two = (row for row in scaling.make_rows(case, costs, cores=1))
print("row:", *one[:2], "- times are told:", "*" not in one[3:5])
print("row:", *two[:2], "- times are told:", "*" not in two[3:5])
print("sections:", *(row[0].strip() for row in tables if row[0].strip() in costs[1].sections))
print("MiB of each rank between 20 and 2000:",
      all(20 < m < 2000 for cost in costs.values() for m in cost.long.memory))
print("both ranks send:", min(costs[2].messages) > 10, min(costs[2].bytes) > 1000)
print("all-to-all:", sum(n for kind, n in costs[2].calls.items() if kind.startswith("Alltoall")),
      "- sums over all:", costs[2].calls["Allreduce"] > 10)
print("differs from one rank by less than 1e-6:", max(scaling.compare(costs[2].long, costs[1].long)) < 1e-6)
changed = dataclasses.replace(costs[1].long, figures={
    name: 1.01 * value for name, value in costs[1].long.figures.items()})
print("a figure that is changed by 1 %:", *(f"{x:.3f}" for x in scaling.compare(changed, costs[1].long)))

for line in repeat_body(["set Bodies = a", "subsection Body a", "  subsection Shape",
                         "    set Position = 0.5, 1", "  end", "end", "set Model = immersed"], 2, 3):
    print("   ", line)
print(*SERIES["space_water"].get_overrides(4, 2)[-4:])


class KnownCost:
    """The cost of a step that has a serial and a shared part, and a dense matrix of 200 a cut."""

    def __init__(self, ranks):
        self.work, self.messages = [0.1 + 2 / ranks], [50 + 10 * scaling_model.logarithm(ranks)]
        self.bytes = [1e6 * scaling_model.ring(ranks) + 4e4 * scaling_model.ring_of_interface(ranks)]
        self.long = self
        self.memory = [200 + 80 / ranks + 24 * (200 * (ranks - 1)) ** 2 / 2**20]


model = scaling_model.Model(SERIES["plane"], {n: KnownCost(n) for n in (1, 2, 4, 8)}, 1e30)
print(f"model: {model.cut:.1f} unknowns in a cut; on 64 ranks", *(f"{x:.5f}" for x in model.get_seconds(64)),
      f"s, {model.get_memory(64):.1f} MiB")
print("what falls does not grow:", *(f"{x:.4f}" for x in scaling_model.fit(
    [2, 4, 8], [3, 2, 1.5], (scaling_model.constant, scaling_model.proportional))))
END

mkdir bin
for program in srun scontrol; do
  printf '#!/bin/sh\necho %s "$@"\n[ %s != srun ] || exit $CODE\n' $program $program >bin/$program
  chmod +x bin/$program
done
for CODE in 0 1 2; do
  export CODE
  code=0
  CAUDAL=caudal SLURM_JOB_ID=7 PATH=$PWD/bin:$PATH "$CAUDAL_SOURCE_DIR/scripts/slurm" fish.prm -D A=1 || code=$?
  echo "  exit code $code"
done
