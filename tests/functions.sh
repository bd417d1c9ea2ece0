# Functions for the tests that are shell scripts.

# caudal ARGUMENTS: runs the program and, only if it fails, shows what it said.
caudal() {
  "$CAUDAL" "$@" >caudal.log 2>&1 || { status=$?; cat caudal.log; return $status; }
}

# column NAME FILE: all values of the column with this name (without its unit).
column() {
  awk -v name="$1" '
    /^# / { number = $2 + 0; sub(/^# [0-9]+: /, ""); sub(/ \[[^[]*\]$/, "")
            if ($0 == name) column = number; next }
    { if (!column) exit 1; print $column }' "$2" ||
    { echo "$2 has no column <$1>" >&2; return 1; }
}

# last NAME FILE: its last value.
last() {
  column "$1" "$2" | tail -n 1
}

# compute EXPRESSION: its value by awk, with two digits after the point.
compute() {
  awk "BEGIN { printf \"%.2f\\n\", $1 }"
}

# check TEXT CONDITION: prints the text and whether the condition holds.
check() {
  awk "BEGIN { print \"$1: \" (($2) ? \"yes\" : \"no ($2)\") }"
}

# refuse TEXT ARGUMENTS: prints the text and what the program says as it refuses these.
# It must leave no folder called results.
refuse() {
  echo "* $1"
  shift
  "$CAUDAL" "$@" >printed 2>errors </dev/null
  code=$?
  sed -n '/^Error/,$ s/^/    /p' errors
  [ $code -eq 1 ] || echo "    exit code $code"
  [ ! -s printed ] || cat printed
  [ ! -e results ] || echo "    there is a folder of results"
  rm -rf results
}

# override ENTRY VALUE: the same for good.prm with this entry.
override() {
  refuse "$1 = $2" good.prm -D "$1=$2"
}
