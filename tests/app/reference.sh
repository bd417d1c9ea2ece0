# SPDX-License-Identifier: LGPL-2.1-or-later
# doc/reference.html is that of this program, its cases and its sources, and works in a browser: it
# fits a narrow window, finds what is searched for, and shows what a link leads to.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
"$CAUDAL_SOURCE_DIR/scripts/document" reference "$PWD/reference.html" >printed 2>&1 || cat printed
grep "no model" printed
cmp reference.html "$CAUDAL_SOURCE_DIR/doc/reference.html" && echo "doc/reference.html is that of this program"

# Each kind of thing that it tells is there.
for text in 'id="p-body-name-shape-elements"' 'a number &gt; 0' 'href="../prm/eel.prm"' \
  'unit <b>m^2/s</b>' '<b>power identity</b>' 'Strouhal number 2 f A / |U|' \
  '<b>fatigue of the median</b> <i>\[1\]</i>' 'href="#p-domain-levels"'; do
  [ "$(grep -c "$text" reference.html)" -gt 0 ] || echo "there is no $text"
done
grep -o '\(src\|action\)="[^"]*"\|href="[a-z]*:[^"]*"\|@import' reference.html | sort -u

# ask WIDTH SEARCH SCRIPT: what the script finds in the page in a window of this width.
ask() {
  cat >frame.html <<PAGE
<iframe src="file://$PWD/reference.html$2" style="width: $1px; height: 900px; border: 0"></iframe><script>
onload = () => setTimeout(() => {
  const frame = document.querySelector("iframe").contentWindow, page = frame.document;
  const seen = name => { const part = page.getElementById(name); return part.getClientRects().length > 0; };
  document.body.dataset.result = ($3).join(", ");
}, 1000);
</script>
PAGE
  open_page frame.html | sed -n 's/.*data-result="\([^"]*\)".*/  \1/p'
}
fits='page.documentElement.scrollWidth <= frame.innerWidth'
beyond='[...page.querySelectorAll("body *")].filter(part => part.getBoundingClientRect().right > frame.innerWidth + 1).length'
echo "fits, parts beyond the right side, jump list is open"
for width in 390 1280; do
  ask $width "" "[$fits, $beyond, page.getElementById(\"jumps\").open]"
done
echo "all are shown"
ask 800 "" '[page.documentElement.dataset.shown == page.querySelectorAll("article").length]'
echo "viscosity of the fluid: entries found, the one of another model, a section without any"
ask 800 "?q=kinematic%20viscosity&model=immersed" '[seen("p-fluid-kinematic-viscosity"),
  seen("p-resistance-kinematic-viscosity"), seen("s-checkpoint")]'
echo "typed: found, hidden; then a link to what is hidden shows it"
ask 800 "" '(() => {
  const words = page.getElementById("words");
  words.value = "Strouhal number";
  words.dispatchEvent(new frame.Event("input"));
  const typed = [seen("t-immersed-swim-txt-swim-json"), !seen("p-time-step")];
  frame.location.hash = "p-domain-levels";
  frame.dispatchEvent(new frame.Event("hashchange"));
  return [...typed, seen("p-domain-levels"), words.value === ""];
})()'
