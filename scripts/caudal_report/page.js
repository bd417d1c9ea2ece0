// SPDX-License-Identifier: LGPL-2.1-or-later
// Draws the charts, runs the animations and tells in data attributes of the page what was done.
"use strict";
const errors = [];
window.addEventListener("error", event => {
  errors.push(event.message);
  document.documentElement.dataset.errors = errors.join("; ");
});

function startMovie(figure, movie) {
  const [image, button, slider, caption] =
    ["img", "button", "input", "output"].map(name => figure.querySelector(name));
  let timer = null;
  const show = k => {
    slider.value = k;
    image.src = movie.frames[k];
    caption.textContent = movie.captions[k];
  };
  const stop = () => { clearInterval(timer); timer = null; button.textContent = "Play"; };
  slider.addEventListener("input", () => { stop(); show(+slider.value); });
  button.addEventListener("click", () => {
    if (timer) return stop();
    button.textContent = "Pause";
    timer = setInterval(() => show((+slider.value + 1) % movie.frames.length), 80);
  });
}

MOVIES.forEach((movie, k) => startMovie(document.getElementById(`movie-${k + 1}`), movie));
document.documentElement.dataset.charts = drawCharts(CHARTS);
document.documentElement.dataset.movies = MOVIES.length;
document.documentElement.dataset.errors = errors.join("; ");
document.documentElement.dataset.resources = performance.getEntriesByType("resource")
  .filter(entry => !entry.name.startsWith("data:")).length;
document.documentElement.dataset.drawn = "yes";
