// SPDX-License-Identifier: BSD-3-Clause
// The list of tracks: which one is which vehicle.
"use strict";

const kColumns = [
  {name: "Track", value: (t) => t.id},
  {name: "What it is", value: (t) => t.what, left: true},
  {name: "There (s)", value: (t) => t.from, text: (v, t) => `${v.toFixed(1)}–${t.to.toFixed(1)}`},
  {name: "m/s", value: (t) => t.speed, text: (v) => v.toFixed(1)},
  {name: "Size (m)", value: (t) => t.length,
   text: (v, t) => `${v.toFixed(1)}×${t.width.toFixed(1)}`},
];

/** One row of the list: what a track was over its life. */
function summaryOf(run, track) {
  const last = track.frame.length - 1;
  return {track, id: track.id, what: whatIs(run, track), isVehicle: isVehicle(run, track),
          from: run.times[track.first], to: run.times[track.last],
          speed: meanOf(track.speed), length: track.length[last], width: track.width[last]};
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
  const rows = run.tracks.filter((track) => track.wasPublished)
      .map((track) => summaryOf(run, track));
  let order = {column: null, sign: 1};
  const vehicles = rows.filter((row) => row.isVehicle).length;
  const about = paragraph(`${rows.length} objects were tracked` + (vehicles < rows.length
      ? `, ${vehicles} of them ${run.truth ? "labelled vehicles" : "held for vehicles"}. ` : ". ") +
      "Those not in the scene at this time are pale. Click one for its history.");
  const others = document.createElement("label");
  others.className = "soft";
  others.innerHTML = '<input type="checkbox"> show the other objects too';
  others.hidden = vehicles === rows.length;
  others.addEventListener("change", () => fill());
  const table = document.createElement("table");
  panel.append(about, others, table);
  const fill = () => {
    rows.sort((a, b) => {
      if (order.column === null) return b.isVehicle - a.isVehicle || a.id - b.id;
      const [u, v] = [order.column.value(a), order.column.value(b)];
      return order.sign * (u < v ? -1 : u > v ? 1 : 0);
    });
    const all = others.firstChild.checked;
    table.replaceChildren(headOf(order, fill), ...rows.filter((row) => all || row.isVehicle)
        .map((row) => rowOf(state, row)));
    update();
  };
  const update = () => {
    for (const row of table.querySelectorAll(".row")) {
      const track = run.byId.get(Number(row.dataset.id));
      const i = track.at(state.frame);
      row.classList.toggle("absent", i < 0 || !track.isPublished(i));
      row.classList.toggle("selected", state.track === track.id);
      const shown = i >= 0 ? i : state.frame < track.first ? 0 : track.frame.length - 1;
      row.querySelector(".swatch").style.background = trackColour(state, track, shown);
    }
  };
  state.onChange((changed) => {
    update();
    if (changed.has("track"))
      table.querySelector(".row.selected")?.scrollIntoView({block: "nearest"});
  });
  themeListeners.push(update);
  fill();
}

function headOf(order, fill) {
  const head = document.createElement("tr");
  for (const column of kColumns) {
    const cell = document.createElement("th");
    cell.textContent = column.name + (order.column === column ? (order.sign > 0 ? " ▲" : " ▼") : "");
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
