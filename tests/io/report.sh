# SPDX-License-Identifier: LGPL-2.1-or-later
# Reports of both models, as a browser sees them: all charts are drawn without an
# error, pictures and animation are in the page, and nothing is loaded from elsewhere.
# What a report can't be made of is refused with a sentence.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_eel

# see PAGE: what is left of the page in a browser.
see() {
  chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --hide-scrollbars \
    --user-data-dir="$PWD/profile" --window-size=1200,6000 --virtual-time-budget=5000 \
    "--screenshot=$PWD/$1.png" "file://$PWD/$1" >/dev/null 2>&1 || echo "no screenshot of $1"
  chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage \
    --user-data-dir="$PWD/profile" --virtual-time-budget=5000 \
    --dump-dom "file://$PWD/$1" >dom.html 2>/dev/null || echo "no page $1"
  /usr/bin/python3 - "$1" <<'END'
import re
import sys

from PIL import Image

page, dom = open(sys.argv[1], encoding="utf-8").read(), open("dom.html", encoding="utf-8").read()
root = dict(re.findall(r'data-(\w+)="([^"]*)"', re.search(r"<html[^>]*>", dom)[0]))
body = re.sub(r"<script>.*?</script>", "", dom, flags=re.S)
links = re.findall(r"""(?:src|href|poster|data|action)\s*=\s*["']([^"']*)|url\(([^)]*)\)|@import""", page)
holders = len(re.findall('class="chart"', body))
colours = Image.open(sys.argv[1] + ".png").convert("RGB").getcolors(10**7)
print("  drawn:", root.get("drawn"), "- errors:", root.get("errors") or "none",
      "- loaded from elsewhere:", root.get("resources"))
print("  links that leave the page:", [a or b for a, b in links
                                       if not (a or b).startswith(("data:", "#"))])
print("  each chart has axes and curves:",
      holders == int(root["charts"]) and holders > 5 and
      all('class="frame"' in part and "<path" in part for part in body.split('class="chart"')[1:]))
print("  animations:", root["movies"], "- empty pictures:",
      sum(len(source) < 1000 for source in re.findall(r'<img src="data:([^"]*)"', body)))
print("  less than 15 MB:", len(page) < 15e6, "- many colours:", len(colours) > 100)
print("  sections:", ", ".join(re.findall(r"<h2>([^<]*)</h2>", body)))
END
}

caudal eel.prm
"$CAUDAL_SOURCE_DIR/scripts/report" eel >printed
echo "an immersed eel"
cp eel/report.html eel.html
see eel.html
/usr/bin/python3 -c '
import json
swim = json.load(open("eel/swim.json"))
print("  swim.json:", len(swim["beats"]), "beats of", len(swim["quantities"]), "quantities")'

# A lone eel of half the speed; one of another muscle, on another grid, is none to compare with.
mkdir lone
cp eel/parameters.prm lone
/usr/bin/python3 -c '
import json
swim = json.load(open("eel/swim.json"))
for beat in [swim["mean of steady beats"] or {}, *swim["beats"]]:
    beat["speed"] = 0.5 * beat.get("speed", 0)
json.dump(swim, open("lone/swim.json", "w"))'
"$CAUDAL_SOURCE_DIR/scripts/report" eel --lone lone --output school.html --no-pictures --frames 0 >printed
grep -A 12 "Gain of the school" school.html | grep -o "(+100.0&nbsp;%)\|(+0.0&nbsp;%)" | sort | uniq -c | sed 's/^ */  gains: /'
sed -i 's/set Levels .*= 2/set Levels = 3/; s/set Gait damping .*= 1e4/set Gait damping = 2e4/' lone/parameters.prm
for folder in lone profile no; do
  "$CAUDAL_SOURCE_DIR/scripts/report" eel --lone $folder 2>&1 >printed | sed 's/^/  /'
done

# A run that failed is called so, and what it says of itself is no markup.
cp -r eel failed
sed -i '1s/finished/failed/' failed/manifest.txt
sed -i '1s/^/<i>/' failed/log.txt
"$CAUDAL_SOURCE_DIR/scripts/report" failed --no-pictures --frames 0 >printed
grep -o 'failed: this[^;]*; .*Caudal' failed/report.html | sed 's/^/  /'

# What a hand does: it reads values and zooms into the first chart, and plays the animation.
cp eel.html hand.html
cat >>hand.html <<'END'
<script>
Element.prototype.setPointerCapture = () => {}; // there is no real pointer
const charts = document.querySelectorAll(".plot"), tip = charts[0].querySelector(".tip");
const send = (type, share) => {
  const svg = charts[0].querySelector(":scope > svg"), box = svg.getBoundingClientRect();
  svg.dispatchEvent(new PointerEvent(type, {clientX: box.left + share * box.width, pointerId: 1}));
};
const getAxis = chart => [...chart.querySelectorAll("text")].map(text => text.textContent).join();
send("pointermove", 0.5);
const shown = tip.style.display === "block" && /\d/.test(tip.textContent);
const before = [...charts].slice(0, 2).map(getAxis);
send("pointerdown", 0.4); send("pointermove", 0.5); send("pointerup", 0.6);
const zoomed = [...charts].slice(0, 2).map(getAxis);
send("dblclick", 0.5);
const after = [...charts].slice(0, 2).map(getAxis);
const image = document.querySelector(".movie img"), last = image.src;
document.querySelector(".movie input").value = 0;
document.querySelector(".movie input").dispatchEvent(new Event("input"));
document.documentElement.dataset.hand = [shown, before.every((axis, k) => axis !== zoomed[k]),
  before.join() === after.join(), image.src !== last].join(", ");
</script>
END
chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --window-size=1200,6000 \
  --user-data-dir="$PWD/profile" --virtual-time-budget=5000 --dump-dom "file://$PWD/hand.html" \
  2>/dev/null | sed -n 's/^<html.*data-hand="\([^"]*\)".*/  values shown, two charts zoomed, all seen again, animation moved: \1/p'

caudal "$CAUDAL_SOURCE_DIR/prm/salmon/salmon.prm" -D "Output/Folder=salmon" -D "Time/End time=3" \
  -D "Surface/Cells along=2" -D "Surface/Cells across=2" -D "Output/Interval of fields=0.25"
"$CAUDAL_SOURCE_DIR/scripts/report" salmon >printed
echo "a salmon in an ideal fluid"
cp salmon/report.html salmon.html
see salmon.html

# The views for ParaView, which need not be there.
for run in eel salmon; do
  "$CAUDAL_SOURCE_DIR/scripts/paraview" $run >printed
  /usr/bin/python3 -m py_compile $run/view.py && echo "$run/view.py is a program"
done

# trouble TEXT PROGRAM FOLDER: what the program says, and with which code it ends.
trouble() {
  echo "* $1"
  code=0
  "$CAUDAL_SOURCE_DIR/scripts/$2" "$3" >printed 2>errors || code=$?
  sed "s|$PWD/||g; s|^|  |" errors
  echo "  exit code $code"
}
trouble "no such folder" report nothing
trouble "no such folder" paraview nothing
mkdir empty
trouble "not the folder of a run" report empty
trouble "not the folder of a run" paraview empty
mv eel/statistics.txt kept
trouble "no statistics" report eel
: >eel/statistics.txt
trouble "empty statistics" report eel
mv kept eel/statistics.txt
cp eel/swim.json kept
head -c 500 kept >eel/swim.json
trouble "swim.json cut off" report eel
mv kept eel/swim.json
for file in eel/fields/fluid-00004*.vtu; do
  head -c 5000 "$file" >short
  mv short "$file"
done
trouble "fields cut off" report eel
trouble "fields cut off" paraview eel
: >salmon/summary.csv
trouble "an empty summary" report salmon
