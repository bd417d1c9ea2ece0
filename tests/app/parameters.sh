# SPDX-License-Identifier: LGPL-2.1-or-later
# Every case in prm/ can be run; what a run writes as its parameters is the same
# case again.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cd "$CAUDAL_SOURCE_DIR"
find prm -name '*.prm' | sort | while read -r file; do
  printed=$("$CAUDAL" --check --fast "$file" 2>&1)
  case $printed in
    *"No problems found"* | *"The case can be run"*) ;;
    *) echo "$file: $printed" ;;
  esac
done
cd - >/dev/null

cat >case.prm <<'END'
set Bodies = fish, disc
subsection Time
  set End time = 0.01
  set Step     = 0.01
end
subsection Domain
  set Size   = 3, 2
  set Cells  = 3, 2
  set Levels = 3
end
subsection Body fish
  set Regions = head, tail
  subsection Shape
    set Elements          = 20, 4
    set Position          = 1, 1
    set Region boundaries = 0.5
  end
end
subsection Body disc
  subsection Region body
    set Motion = fixed
  end
  subsection Shape
    set Type     = disc
    set Position = 0.5, 1
    set Elements = 4, 4
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Output
  set Folder = first
end
END
caudal case.prm -D "Fluid/Kinematic viscosity=0.25"
caudal first/parameters.prm -D "Output/Folder=second"
cmp first/statistics.txt second/statistics.txt && echo "the written parameters give the same run"
grep "^Override" first/log.txt

"$CAUDAL" case.prm -D "Output/Folder=first" >/dev/null && echo "results are replaced by those of a new run"
"$CAUDAL" --version | sed -E 's/[0-9]+\.[0-9.]+( \([0-9a-z.-]+\))?$/.../'
"$CAUDAL" --help | head -n 1 | sed -E 's/ \([0-9a-z.-]+\)//'

# is_current FILE ARGUMENTS: whether FILE ends with what the program prints of its parameters.
is_current() {
  file=$1
  shift
  "$CAUDAL" --print-parameters md "$@" >printed.md
  tail -n "$(wc -l <printed.md)" "$CAUDAL_SOURCE_DIR/$file" | cmp - printed.md &&
    echo "$file is that of this program"
}
is_current doc/parameters.md
is_current doc/parameters_potential.md "$CAUDAL_SOURCE_DIR/prm/salmon/salmon.prm"
is_current doc/parameters_passage.md "$CAUDAL_SOURCE_DIR/prm/passage/two_reaches.prm"
