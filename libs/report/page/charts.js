// SPDX-License-Identifier: BSD-3-Clause
// Small charts over the life of a track, with a line at the time shown; a click goes there.
"use strict";

const kChart = {width: 190, height: 78, left: 30, right: 4, top: 14, bottom: 12};

function svg(name, attributes, parent) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  parent?.append(element);
  return element;
}

/**
 * series: [{values, times, style, colour, sigma}], where values may be null and `sigma` is the
 * half width of a band. Returns the element; its moveTo(time) moves the line.
 */
function chartOf({title, series, limit, range, onSeek}) {
  const {width, height, left, right, top, bottom} = kChart;
  const element = svg("svg", {class: "chart", viewBox: `0 0 ${width} ${height}`,
                              preserveAspectRatio: "none", role: "img", "aria-label": title});
  const all = series.flatMap((s) => s.values.filter((v) => v !== null));
  const times = series.flatMap((s) => [s.times[0], s.times[s.times.length - 1]]);
  const [t0, t1] = [Math.min(...times), Math.max(...times, Math.min(...times) + 0.1)];
  let [low, high] = range ?? [Math.min(...all), Math.max(...all)];
  if (!range && high - low < 0.2) [low, high] = [low - 0.1, high + 0.1];
  if (limit !== undefined) [low, high] = [0, Math.max(limit * 1.3, high)];
  const x = (t) => left + (t - t0) / (t1 - t0) * (width - left - right);
  const y = (v) => {
    const share = (Math.max(low, Math.min(high, v)) - low) / (high - low || 1);
    return height - bottom - share * (height - top - bottom);
  };
  svg("rect", {class: "frame", x: left, y: top, width: width - left - right,
               height: height - top - bottom}, element);
  const text = (tx, ty, words, anchor = "start") =>
      svg("text", {x: tx, y: ty, "text-anchor": anchor}, element).textContent = words;
  text(left, 10, title);
  text(left - 3, top + 8, shortNumber(high), "end");
  text(left - 3, height - bottom, shortNumber(low), "end");
  text(left, height - 2, `${t0.toFixed(1)} s`);
  text(width - right, height - 2, `${t1.toFixed(1)} s`, "end");
  if (limit !== undefined)
    svg("path", {d: `M${left} ${y(limit)}H${width - right}`, stroke: "currentColor",
                 "stroke-dasharray": "3 3", opacity: 0.5}, element);
  for (const s of series) drawSeries(element, s, x, y);
  const cursor = svg("line", {class: "cursor", y1: top, y2: height - bottom}, element);
  element.moveTo = (t) => {
    cursor.setAttribute("x1", x(t));
    cursor.setAttribute("x2", x(t));
    cursor.setAttribute("visibility", t < t0 || t > t1 ? "hidden" : "visible");
  };
  element.addEventListener("click", (event) => {
    const box = element.getBoundingClientRect();
    const share = ((event.clientX - box.left) / box.width * width - left) / (width - left - right);
    onSeek(t0 + Math.max(0, Math.min(1, share)) * (t1 - t0));
  });
  return element;
}

function drawSeries(element, {values, times, sigma, colour: ink, dashed, dots}, x, y) {
  if (sigma) {
    const known = values.map((v, i) => i).filter((i) => values[i] !== null);
    const edge = (sign, order) => order.map((i) => `${x(times[i]).toFixed(1)} ${
        y(values[i] + sign * sigma[i]).toFixed(1)}`);
    svg("path", {d: "M" + [...edge(1, known), ...edge(-1, [...known].reverse())].join("L") + "Z",
                 fill: ink, opacity: 0.18}, element);
  }
  let path = "";
  values.forEach((v, i) => {
    if (v === null) return;
    const begins = path === "" || values[i - 1] === null || dots;
    path += `${begins ? "M" : "L"}${x(times[i]).toFixed(1)} ${y(v).toFixed(1)}${dots ? "h0" : ""}`;
  });
  svg("path", {d: path, fill: "none", stroke: ink, "stroke-width": dots ? 2.5 : 1.4,
               "stroke-linecap": "round", "vector-effect": "non-scaling-stroke",
               "stroke-dasharray": dashed ? "4 3" : "none"}, element);
}

function shortNumber(v) {
  const size = Math.abs(v);
  return fixed(v, size >= 100 ? 0 : size >= 10 ? 1 : 2);
}

/** Without the sign of what is rounded to zero. */
function fixed(v, digits) {
  const text = v.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}
