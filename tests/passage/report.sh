# SPDX-License-Identifier: LGPL-2.1-or-later
# Reports of the model passage as a browser sees them: charts are drawn without an error, nothing is
# loaded from elsewhere, they print on two pages; and the pictures.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

browse() {
  chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir="$PWD/profile" \
    --virtual-time-budget=5000 "$@" 2>/dev/null
}

for case in culvert ramp_batch slot_fishway; do
  caudal "$CAUDAL_SOURCE_DIR/prm/passage/$case.prm" -D Output/Folder=$case
  "$CAUDAL_SOURCE_DIR/scripts/report" $case >printed
  browse --dump-dom "file://$PWD/$case/report.html" >dom.html
  browse --print-to-pdf="$PWD/$case.pdf" "file://$PWD/$case/report.html"
  echo "$case: $(sed -n 's/^<html.*data-charts="\([^"]*\)".*data-errors="\([^"]*\)".*data-resources="\([^"]*\)".*/charts \1, errors <\2>, loaded \3/p' dom.html)" \
    "- curves: $(grep -o '<path d="M' dom.html | wc -l) - pages: $(pdfinfo $case.pdf | sed -n 's/^Pages: *//p')"
  grep -o '<h2>[^<]*</h2>' $case/report.html | sed 's/<[^>]*>//g' | paste -sd, | sed 's/^/  /'
done
"$CAUDAL_SOURCE_DIR/scripts/plot" ramp_batch
"$CAUDAL_SOURCE_DIR/scripts/plot" culvert

head -c 300 culvert/passage.json >short
mv short culvert/passage.json
code=0
"$CAUDAL_SOURCE_DIR/scripts/report" culvert 2>&1 >printed || code=$?
echo "a report cut off: exit code $code"
