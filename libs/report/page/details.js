// SPDX-License-Identifier: BSD-3-Clause
// The selected track: what it says of itself now, its close-up, its history.
"use strict";

function startDetails(panel, state, store) {
  let shown = {};
  const fill = () => {
    const track = state.run.byId.get(state.track);
    const object = state.run.objects[state.object];
    panel.hidden = !track && !object;
    shown = {};
    if (track) shown = fillTrack(panel, state, track);
  };
  const update = () => {
    const track = state.run.byId.get(state.track);
    const object = state.run.objects[state.object];
    if (!track && object) fillObject(panel, state, object);
    if (!track || !shown.facts) return;
    shown.facts.innerHTML = factsOf(state, track);
    for (const chart of shown.charts) chart.moveTo(state.run.times[state.frame]);
    drawCloseUp(shown.closeUp, state, store, track);
    showSurface(shown.surface, state, track);
  };
  state.onChange((changed) => {
    if (changed.has("track") || changed.has("object")) fill();
    update();
  });
  themeListeners.push(() => { fill(); update(); });
  addEventListener("resize", update);
  fill();
  update();
  return update;
}

/** Only where the track is measured: without, there is no filter. */
function showSurface(canvas, state, track) {
  const i = track.at(state.frame);
  const box = i < 0 ? null : track.measuredBox(i);
  canvas.hidden = !box || !state.layers.filter;
  if (canvas.hidden) return;
  drawSurface(canvas, filterRegions(state.run.filter, box, state.run.sensorAt(state.frame)));
}

function heading(state, text) {
  const head = document.createElement("h2");
  const close = document.createElement("button");
  close.className = "close";
  close.textContent = "✕";
  close.title = "Select nothing (Esc)";
  close.addEventListener("click", () => state.set({track: null, object: null}));
  head.append(close, text);
  return head;
}

function fillTrack(panel, state, track) {
  const facts = document.createElement("div");
  const closeUp = document.createElement("canvas");
  closeUp.id = "closeup";
  const key = document.createElement("div");
  key.className = "key";
  key.innerHTML = [["bad", "measured box, thick: faces seen"], ["strip", "filter: visible faces"],
                   ["interior", "interior"], ["surround", "surround (negative)"],
                   ["truth", "label"]]
      .map(([ink, text]) => `<span><i style="background:var(--${ink})"></i>${text}</span>`)
      .join("") + "<span>✕ hits · dotted: track, with 1-sigma ellipse and heading wedge</span>";
  const grid = document.createElement("div");
  grid.className = "charts";
  const charts = chartsOf(state, track);
  grid.append(...charts);
  const title = `Track #${track.id}: ${whatIs(state.run, track)}`;
  const surface = document.createElement("canvas");
  surface.id = "surface";
  surface.title = "The matched filter as a surface over the plane (Figs. 4 and 5)";
  panel.replaceChildren(heading(state, title), facts, closeUp, surface, key, grid);
  panel.scrollTop = 0;
  return {facts, closeUp, surface, charts};
}

function fillObject(panel, state, object) {
  const run = state.run;
  const counted = object.frame.filter((_, i) => object.counts[i]);
  const index = run.objects.indexOf(object);
  const found = counted.filter((frame) => run.matches[frame].byObject.has(index)).length;
  const tracks = new Set(object.frame.map((frame) => run.matches[frame].byObject.get(index)?.track)
      .filter((id) => id !== undefined));
  const text = document.createElement("p");
  text.textContent = `Labelled ${object.class}, there ${spanOf(run, object)}. It counts in ${
      counted.length} frames; a track is on it in ${found} of them. ${hitsOn(state, object)}`;
  panel.replaceChildren(heading(state, nameOfObject(object)), text);
  for (const id of tracks) {
    const button = document.createElement("button");
    button.textContent = `Track #${id}`;
    button.addEventListener("click", () => {
      state.selectTrack(id);
      if (run.byId.get(id).at(state.frame) < 0) state.seek(run.byId.get(id).first);
    });
    panel.append(button);
  }
}

/** "from 1.0 s to 3.5 s" */
function spanOf(run, life) {
  return `from ${run.times[life.first].toFixed(1)} s to ${run.times[life.last].toFixed(1)} s`;
}

/** What of a labelled object the sensor sees at the time shown. */
function hitsOn(state, object) {
  const i = object.at(state.frame);
  if (i < 0) return "It is not there at this time.";
  const sensor = state.run.sensorAt(state.frame);
  const range = Math.hypot(object.x[i] - sensor[0], object.y[i] - sensor[1]);
  const hits = object.points[i] < 0 ? "" : `, with ${object.points[i]} LADAR hits on it`;
  return `At this time it is ${range.toFixed(0)} m away${hits}` +
      (object.counts[i] ? "." : ": it does not count.");
}

/** The row of the frame shown. */
function factsOf(state, track) {
  const i = track.at(state.frame);
  if (i < 0) return `<p class="soft">Not in the scene at this time, but ${
      spanOf(state.run, track)}.</p>`;
  const deg = (rad) => `${fixed(rad * 180 / Math.PI, 1)}°`;
  const sigma = (variance) => Math.sqrt(variance).toFixed(2);
  const p = track.vehicleProbability(i);
  const faces = {F: "front", B: "back", L: "left", R: "right"};
  const pair = state.run.matches?.[state.frame].byTrack.get(track.id);
  const rows = [
    ["State", track.status[i]],
    ["Vehicle", p === null ? "not told" : `${Math.round(100 * p)} %`],
    ["Speed", `${fixed(track.speed[i], 2)} ± ${sigma(track.varSpeed[i])} m/s`],
    ["Heading", `${deg(track.heading[i])} ± ${deg(Math.sqrt(track.varHeading[i]))}`],
    ["Front as drawn", `${Math.round(100 * track.forward[i])} %`],
    ["Axes as drawn", `${Math.round(100 * track.axes[i])} %`],
    ["Length", `${track.length[i].toFixed(2)} ± ${sigma(track.varLength[i])} m`],
    ["Width", `${track.width[i].toFixed(2)} ± ${sigma(track.varWidth[i])} m`],
    ["Hits", track.hits[i]],
    ["Faces seen", [...track.faces[i]].map((f) => faces[f]).join(", ") || "none"],
    ["Match", `${fixed(track.match[i], 2)} / m`],
    ["NIS", track.nis[i] === null ? "no update" : track.nis[i].toFixed(2)],
  ];
  const truth = pair ? `On the label ${nameOfObject(state.run.objects[pair.object])}, overlap ${
      Math.round(100 * pair.overlap)} %` : state.run.truth ? "On no label in this frame" : "";
  const cells = rows.map(([name, value]) => `<td class="soft">${name}</td><td>${
      escaped(String(value))}</td>`);
  let html = "";
  for (let k = 0; k < cells.length; k += 2) html += `<tr>${cells[k]}${cells[k + 1] ?? ""}</tr>`;
  return `<p class="soft">${escaped(truth)}</p><table class="facts">${html}</table>`;
}

function escaped(text) {
  const span = document.createElement("span");
  span.textContent = text;
  return span.innerHTML;
}
