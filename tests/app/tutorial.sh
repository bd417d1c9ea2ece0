# SPDX-License-Identifier: LGPL-2.1-or-later
# The commands of doc/tutorial.md, all of them in their order, with a fish on a coarser grid that
# swims for two beats: each does what the tutorial says.
mkdir prm
ln -s "$CAUDAL_SOURCE_DIR/scripts" scripts
ln -s "$CAUDAL_SOURCE_DIR/python" python
cat >prm/first_fish.prm <<END
include $CAUDAL_SOURCE_DIR/prm/first_fish.prm
subsection Time
  set End time = 1.6
end
subsection Domain
  set Levels = 4
end
subsection Refinement
  set Vorticity levels = 4
end
subsection Coupling
  set Accept unresolved bodies = true
end
subsection Output
  set Interval of fields = 0.1
end
END
# The Python block becomes a command, too.
sed -n '/^```sh$/,/^```$/{/^```/!p}
  /^```python$/,/^```$/{s/^```python$/\/usr\/bin\/python3 - <<"PYTHON"/; s/^```$/PYTHON/; p}' \
  "$CAUDAL_SOURCE_DIR/doc/tutorial.md" | sed 's/End time=4.5/End time=1.7/' >commands

export CAUDAL_RANKS=1
bash -e commands >printed 2>&1 || { echo "failed:"; tail -n 20 printed; }

grep "The case can be run\|^3 runs: \|finished\( (. of 3)\)*$" printed | sed 's|^\(.*\) (. of 3)$|  \1|' | LC_ALL=C sort
for file in plots/vorticity.png plots/cruise.png plots/movie.mp4 plots/movie.gif report.html; do
  [ -s output/first_fish/$file ] && echo "first_fish/$file"
done
grep -c "^Resumed from" output/first_fish/log.txt
for file in soft_fish/statistics.txt stiffness/sweep.csv stiffness/sweep.png stiffness/report.html power.png; do
  [ -s output/$file ] && echo "$file"
done
cut -d, -f 2,3 output/stiffness/sweep.csv

# What the tutorial points to is there.
for link in $(sed -n 's/.*](\([^)#]*\)).*/\1/p' "$CAUDAL_SOURCE_DIR/doc/tutorial.md"); do
  [ -e "$CAUDAL_SOURCE_DIR/doc/$link" ] || echo "there is no $link"
done
