// SPDX-License-Identifier: LGPL-2.1-or-later
// The search: each word has to be in an entry, its section's title or its path.
"use strict";

const words = document.getElementById("words"), model = document.getElementById("model");
const jumps = document.getElementById("jumps"), count = document.getElementById("count");
const entries = [...document.querySelectorAll("article")].map(element => ({
  element,
  text: [element.closest("section").querySelector("h3"),
    ...[...element.children].filter(part => part.className !== "complaints")]
    .map(part => part.textContent).concat(element.dataset.path || "").join(" ").toLowerCase(),
  models: (element.dataset.models || "").split(" ").filter(Boolean),
}));
const sections = [...document.querySelectorAll("main section")].reverse(); // inner ones first
const links = new Map([...jumps.querySelectorAll("a")].map(link => [link.getAttribute("href").slice(1), link]));

function filter() {
  const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const {element, text, models} of entries) {
    const fits = wanted.every(word => text.includes(word)) &&
      (!model.value || models.length === 0 || models.includes(model.value));
    element.hidden = !fits;
    shown += fits;
  }
  for (const section of sections) {
    section.hidden = !section.querySelector("article:not([hidden])");
    const link = links.get(section.id);
    if (link) (link.closest("li") || link).hidden = section.hidden;
  }
  count.textContent = wanted.length || model.value ? `${shown} of ${entries.length}` : `${entries.length} entries`;
  document.documentElement.dataset.shown = shown;
}

// What a link leads to is shown, whatever was searched for.
function showTarget() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  if (target.hidden || target.closest("[hidden]")) {
    words.value = model.value = "";
    filter();
  }
  target.scrollIntoView();
  if (!matchMedia("(min-width: 62rem)").matches) jumps.open = false;
}

words.addEventListener("input", filter);
model.addEventListener("input", filter);
addEventListener("hashchange", showTarget);
addEventListener("keydown", event => {
  if (event.key === "/" && document.activeElement !== words) {
    event.preventDefault();
    words.focus();
  }
});
const asked = new URLSearchParams(location.search);
words.value = asked.get("q") || "";
model.value = asked.get("model") || "";
jumps.open = matchMedia("(min-width: 62rem)").matches;
filter();
showTarget();
