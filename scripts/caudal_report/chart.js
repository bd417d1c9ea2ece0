// SPDX-License-Identifier: LGPL-2.1-or-later
// Charts as SVG: drag over a span of x to zoom, double click to see all, hover to read values.
// Charts of one group are zoomed together. No libraries, no network.
"use strict";
(() => {
  const NS = "http://www.w3.org/2000/svg";
  // On a narrow screen charts are narrower, not smaller: their letters must be read.
  const W = document.documentElement.clientWidth < 480 ? 360 : 560, H = 270, M = {l: 64, r: 12, t: 8, b: 40};
  const groups = {};

  const svg = (name, attributes, parent, text) => {
    const e = document.createElementNS(NS, name);
    for (const k in attributes) e.setAttribute(k, attributes[k]);
    if (text !== undefined) e.textContent = text;
    if (parent) parent.appendChild(e);
    return e;
  };

  // Round steps of a linear axis.
  const getTicks = (a, b, n) => {
    const raw = (b - a) / n, power = 10 ** Math.floor(Math.log10(raw));
    const step = power * [1, 2, 5, 10].find(f => f * power >= raw * 0.999);
    const ticks = [];
    for (let i = Math.ceil(a / step - 1e-9); i * step <= b + 1e-9 * step; ++i) ticks.push(i * step);
    return ticks;
  };
  const getPowers = (a, b) => {
    const every = Math.ceil((b - a) / 6) || 1, ticks = [];
    for (let i = Math.ceil(a); i <= b; ++i) if (i % every === 0) ticks.push(i);
    return ticks;
  };
  const raise = n => String(n).replace(/./g, c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[+c]);
  const format = v => {
    if (v === 0) return "0";
    const a = Math.abs(v);
    if (a >= 1e5 || a < 1e-3) {
      const [m, e] = v.toExponential(3).split("e");
      return `${parseFloat(m)}·10${raise(parseInt(e))}`.replace("-", "−");
    }
    return String(parseFloat(v.toPrecision(4))).replace("-", "−");
  };

  function Chart(holder, data) {
    const all = data.curves.flatMap(c => c.x);
    const full = [all.reduce((a, b) => Math.min(a, b), Infinity),
                  all.reduce((a, b) => Math.max(a, b), -Infinity)];
    if (full[0] === full[1]) { full[0] -= 0.5; full[1] += 0.5; }
    let span = full, hidden = new Set();
    const transform = v => v === null ? null : data.log ? (v > 0 ? Math.log10(v) : null) : v;
    const root = svg("svg", {viewBox: `0 0 ${W} ${H}`, role: "img", "aria-label": data.title}, holder);
    const id = "clip" + Math.random().toString(36).slice(2);
    const tip = holder.appendChild(document.createElement("div"));
    tip.className = "tip";
    const legend = document.createElement("div");
    legend.className = "legend";
    data.curves.forEach((c, k) => {
      const key = legend.appendChild(document.createElement("button"));
      key.type = "button";
      key.title = "show or hide";
      const line = svg("svg", {width: 22, height: 10}, key);
      if (c.markers) svg("circle", {cx: 11, cy: 5, r: 3, fill: c.color}, line);
      else svg("line", {x1: 1, x2: 21, y1: 5, y2: 5, stroke: c.color, "stroke-width": 2,
                        "stroke-dasharray": c.dash || ""}, line);
      key.appendChild(document.createTextNode(c.name));
      key.onclick = () => {
        hidden.has(k) ? hidden.delete(k) : hidden.add(k);
        key.classList.toggle("off", hidden.has(k));
        draw();
      };
    });
    holder.insertBefore(legend, root);
    let X, Y, invert;

    function getRange() {
      let low = Infinity, high = -Infinity;
      data.curves.forEach((c, k) => {
        if (hidden.has(k)) return;
        c.x.forEach((x, i) => {
          const y = transform(c.y[i]);
          if (y === null || x < span[0] || x > span[1]) return;
          low = Math.min(low, y); high = Math.max(high, y);
        });
      });
      if (data.zero && !data.log) { low = Math.min(low, 0); high = Math.max(high, 0); }
      if (!(low <= high)) return [0, 1];
      const margin = 0.06 * (high - low) || Math.abs(high) * 0.05 || 1e-3;
      if (!data.equal) return [low - margin, high + margin];
      // A unit of y is as long as one of x; where y needs more room, draw() widens x.
      const half = Math.max((span[1] - span[0]) / (W - M.l - M.r) * (H - M.t - M.b), high - low + 2 * margin) / 2;
      return [(low + high) / 2 - half, (low + high) / 2 + half];
    }

    function drawAxes(range) {
      const ticks = data.log ? getPowers(...range) : getTicks(...range, 5);
      for (const t of ticks) {
        const y = Y(t);
        svg("line", {x1: M.l, x2: W - M.r, y1: y, y2: y, class: !data.log && t === 0 ? "zero" : "grid"}, root);
        svg("text", {x: M.l - 6, y: y + 4, "text-anchor": "end"}, root, data.log ? "10" + raise(t) : format(t));
      }
      for (const t of getTicks(...span, 7)) {
        svg("line", {x1: X(t), x2: X(t), y1: M.t, y2: H - M.b, class: "grid"}, root);
        svg("text", {x: X(t), y: H - M.b + 16, "text-anchor": "middle"}, root, format(t));
      }
      svg("rect", {x: M.l, y: M.t, width: W - M.l - M.r, height: H - M.t - M.b, class: "frame"}, root);
      svg("text", {x: (M.l + W - M.r) / 2, y: H - 6, "text-anchor": "middle", class: "label"}, root, data.x);
      svg("text", {x: 0, y: 0, transform: `translate(14 ${(H - M.b + M.t) / 2}) rotate(-90)`,
                   "text-anchor": "middle", class: "label"}, root, data.y);
    }

    function drawCurve(c, area) {
      let path = "", pen = "M";
      c.x.forEach((x, i) => {
        const y = transform(c.y[i]);
        if (y === null) { pen = "M"; return; }
        if (c.markers) svg("circle", {cx: X(x), cy: Y(y), r: 3, fill: c.color}, area);
        path += `${pen}${X(x).toFixed(1)} ${Y(y).toFixed(1)}`;
        pen = "L";
      });
      if (!c.markers || c.line)
        svg("path", {d: path, fill: "none", stroke: c.color, "stroke-width": c.width || 1.3,
                     "stroke-dasharray": c.dash || "", "stroke-linejoin": "round"}, area);
    }

    function draw() {
      root.replaceChildren();
      const range = getRange();
      const middle = (span[0] + span[1]) / 2;
      const reach = (range[1] - range[0]) / (H - M.t - M.b) * (W - M.l - M.r) / 2;
      if (data.equal && reach > (span[1] - span[0]) / 2) span = [middle - reach, middle + reach];
      X = x => M.l + (x - span[0]) / (span[1] - span[0]) * (W - M.l - M.r);
      Y = y => H - M.b - (y - range[0]) / (range[1] - range[0]) * (H - M.t - M.b);
      invert = px => span[0] + (px - M.l) / (W - M.l - M.r) * (span[1] - span[0]);
      drawAxes(range);
      const clip = svg("clipPath", {id}, root);
      svg("rect", {x: M.l, y: M.t, width: W - M.l - M.r, height: H - M.t - M.b}, clip);
      const area = svg("g", {"clip-path": `url(#${id})`}, root);
      data.curves.forEach((c, k) => { if (!hidden.has(k)) drawCurve(c, area); });
    }
    this.zoom = to => { span = to || full; draw(); };
    const zoomGroup = to => (data.group ? groups[data.group] : [this]).forEach(c => c.zoom(to));

    const cursor = svg("line", {y1: M.t, y2: H - M.b, class: "cursor"});
    const band = svg("rect", {y: M.t, height: H - M.t - M.b, class: "band"});
    let from = null;
    const place = event => {
      const box = root.getBoundingClientRect();
      return Math.max(M.l, Math.min(W - M.r, (event.clientX - box.left) / box.width * W));
    };
    const hide = () => { tip.style.display = "none"; cursor.remove(); };
    root.addEventListener("pointermove", event => {
      const px = place(event), x = invert(px);
      root.appendChild(cursor);
      cursor.setAttribute("x1", px); cursor.setAttribute("x2", px);
      if (from !== null) {
        root.appendChild(band);
        band.setAttribute("x", Math.min(from, px)); band.setAttribute("width", Math.abs(px - from));
      }
      tip.replaceChildren(Object.assign(document.createElement("b"), {textContent: `${data.x}: ${format(x)}`}));
      data.curves.forEach((c, k) => {
        if (hidden.has(k)) return;
        let best = 0;
        c.x.forEach((v, i) => { if (Math.abs(v - x) < Math.abs(c.x[best] - x)) best = i; });
        const row = tip.appendChild(document.createElement("div"));
        const dot = row.appendChild(document.createElement("i"));
        dot.style.background = c.color;
        row.append(`${c.name}: ${c.y[best] === null ? "–" : format(c.y[best])}`);
      });
      tip.style.display = "block";
      tip.style.left = px / W * 100 + "%";
      tip.style.transform = px > W / 2 ? "translateX(calc(-100% - 10px))" : "translateX(10px)";
    });
    root.addEventListener("pointerleave", () => { if (from === null) hide(); });
    root.addEventListener("pointerdown", event => {
      from = place(event); root.setPointerCapture(event.pointerId); event.preventDefault();
    });
    root.addEventListener("pointerup", event => {
      const to = place(event), start = from;
      from = null; band.remove();
      if (Math.abs(to - start) > 6) zoomGroup([invert(Math.min(start, to)), invert(Math.max(start, to))]);
    });
    root.addEventListener("dblclick", () => zoomGroup(null));
    draw();
  }

  window.drawCharts = charts => {
    document.querySelectorAll(".chart").forEach(holder => {
      const data = charts[holder.dataset.chart], chart = new Chart(holder.querySelector(".plot"), data);
      if (data.group) (groups[data.group] ||= []).push(chart);
    });
    return Object.keys(charts).length;
  };
})();
