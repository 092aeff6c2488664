// SPDX-License-Identifier: BSD-3-Clause
// The list of tracks: which one is which vehicle.
"use strict";

const kColumns = [
  {name: "Track", value: (t) => t.id},
  {name: "What it is", value: (t) => t.what, left: true},
  {name: "There (s)", value: (t) => t.from, text: (v, t) => `${v.toFixed(1)}–${t.to.toFixed(1)}`},
  {name: "m/s", value: (t) => t.speed, text: (v) => fixed(v, 1)},
  {name: "Size (m)", value: (t) => t.length,
   text: (v, t) => `${v.toFixed(1)}×${t.width.toFixed(1)}`},
];

/** One row of the list: what a track was over its life. */
function summaryOf(run, track) {
  const last = track.frame.length - 1;
  return {track, id: track.id, what: whatIs(run, track), isVehicle: isVehicle(run, track),
          isLabelled: track.follows.length > 0,
          from: run.times[track.first], to: run.times[track.last],
          speed: medianOf(track.speed), length: track.length[last], width: track.width[last]};
}

/** Whether a track is for those who look for vehicles: by truth, discriminator, or unknown. */
function isVehicle(run, track) {
  const p = track.vehicleProbability(track.frame.length - 1);
  return track.follows.length > 0 || (p !== null ? p >= 0.5 : !run.truth);
}

/** By the truth, else by the discriminator. */
function whatIs(run, track) {
  const follows = track.follows[0];
  if (follows) return nameOfObject(follows.object);
  const p = track.vehicleProbability(track.frame.length - 1);
  if (p !== null) return p >= 0.5 ? `vehicle, ${Math.round(100 * p)} %`
                                  : `no vehicle, ${Math.round(100 * (1 - p))} %`;
  if (!run.truth) return "object";
  return track.frame.some((frame) => run.matches[frame].false.has(track.id)) ? "nothing labelled"
                                                                             : "not judged";
}

function fillTracks(panel, state) {
  const run = state.run;
  const all = run.tracks.filter((track) => track.wasPublished)
      .map((track) => summaryOf(run, track));
  const vehicles = all.filter((row) => row.isVehicle).length;
  const labelled = all.filter((row) => row.isLabelled).length;
  const others = checkBox("show the other objects too");
  others.hidden = vehicles === all.length;
  const note = paragraph("");
  const table = document.createElement("table");
  panel.append(paragraph(introduction(run, all.length, labelled, vehicles - labelled)), others, table, note);
  const order = {column: null, sign: 1};
  const rows = new TrackRows(state);
  const fill = () => {
    const chosen = all.filter((row) => row.isVehicle || others.firstChild.checked);
    chosen.sort((a, b) => {
      if (order.column === null) return b.isVehicle - a.isVehicle || a.id - b.id;
      const [u, v] = [order.column.value(a), order.column.value(b)];
      return order.sign * (u < v ? -1 : u > v ? 1 : 0);
    });
    const shown = chosen.slice(0, kMostRows);
    note.textContent = shown.length < chosen.length
        ? `The first ${kMostRows} are listed; the others can be picked in the scene.` : "";
    table.replaceChildren(headOf(order, fill), ...rows.make(shown));
    rows.update();
  };
  others.addEventListener("change", fill);
  state.onChange((changed) => {
    rows.update();
    if (changed.has("track")) rows.of(state.track)?.element.scrollIntoView({block: "nearest"});
  });
  themeListeners.push(() => rows.update());
  fill();
}

const kMostRows = 1000;

/** Counts of tracks: all, on labelled vehicles, and others held for vehicles. */
function introduction(run, count, labelled, held) {
  const parts = [`${count} objects were tracked`];
  if (run.truth) parts.push(`${labelled} of them on labelled vehicles`);
  if (run.hasProbabilities && (run.truth || held < count))
    parts.push(`${held} ${run.truth ? "others" : "of them"} held for vehicles`);
  return `${parts.join(", ")}. ` +
      "Those not in the scene at this time are pale. Click one for its history.";
}

function checkBox(text) {
  const label = document.createElement("label");
  label.className = "soft";
  label.innerHTML = '<input type="checkbox"> ';
  label.append(text);
  return label;
}

/** The rows of the list, kept in step with the scene: only those that change are touched. */
class TrackRows {
  constructor(state) {
    this.state = state;
    this.byId = new Map();
    this.present = new Set();
    this.selected = null;
  }

  make(summaries) {
    this.byId = new Map(summaries.map((summary) => {
      const element = rowOf(this.state, summary);
      element.classList.add("absent");
      return [summary.id, {element, swatch: element.querySelector(".swatch"),
                           track: summary.track}];
    }));
    for (const {track, swatch} of this.byId.values())
      swatch.style.background = trackColour(this.state, track, 0);
    this.present = new Set();
    this.selected = null;
    return [...this.byId.values()].map((row) => row.element);
  }

  of(id) { return this.byId.get(id); }

  update() {
    const present = new Set();
    for (const {track, i} of this.state.run.tracksAt(this.state.frame)) {
      const row = this.byId.get(track.id);
      if (!row) continue;
      present.add(track.id);
      row.element.classList.remove("absent");
      row.swatch.style.background = trackColour(this.state, track, i);
    }
    for (const id of this.present)
      if (!present.has(id)) this.byId.get(id).element.classList.add("absent");
    this.present = present;
    this.byId.get(this.selected)?.element.classList.remove("selected");
    this.selected = this.state.track;
    this.byId.get(this.selected)?.element.classList.add("selected");
  }
}

function headOf(order, fill) {
  const head = document.createElement("tr");
  for (const column of kColumns) {
    const cell = document.createElement("th");
    const arrow = order.sign > 0 ? " ▲" : " ▼";
    cell.textContent = column.name + (order.column === column ? arrow : "");
    cell.className = column.left ? "sortable left" : "sortable";
    cell.addEventListener("click", () => {
      order.sign = order.column === column ? -order.sign : 1;
      order.column = column;
      fill();
    });
    head.append(cell);
  }
  return head;
}

function rowOf(state, summary) {
  const row = document.createElement("tr");
  row.className = "row";
  row.dataset.id = summary.id;
  for (const column of kColumns) {
    const cell = document.createElement("td");
    const value = column.value(summary);
    cell.textContent = column.text ? column.text(value, summary) : value;
    if (column.left) cell.className = "what";
    row.append(cell);
  }
  const swatch = document.createElement("span");
  swatch.className = "swatch";
  row.firstChild.prepend(swatch);
  row.addEventListener("click", () => {
    const track = summary.track;
    if (track.at(state.frame) < 0) state.seek(track.first);
    state.selectTrack(track.id);
    const place = state.selectedPlace();
    if (place) state.set({centre: {place}});
  });
  return row;
}
