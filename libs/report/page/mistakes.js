// SPDX-License-Identifier: BSD-3-Clause
// Where the tracker errs, as a list to go through: a click goes there.
"use strict";

/** By kind, most telling first: title, what it means, colour, row in the line of time. */
const kMistakes = {
  never_found: {title: "Never found", row: 0, colour: "bad",
                about: "Labelled vehicles that no track was ever on."},
  lost: {title: "Lost", row: 0, colour: "bad",
         about: "Vehicles without a track, after they had been found."},
  identity_switch: {title: "Identity switched", row: 1, colour: "truth",
                    about: "Another track took the vehicle over: its history breaks."},
  box_off: {title: "Box too far off", row: 1, colour: "false",
            about: "A track is on the vehicle, but overlaps too little of it to count as found."},
  flip: {title: "Front taken for rear", row: 2, colour: "accent",
         about: "The heading points backwards."},
  heading: {title: "Heading", row: 2, colour: "accent",
            about: "The axis of the box is turned by more than 15°."},
  position: {title: "Position", row: 2, colour: "accent",
             about: "The centres are more than 1 m apart."},
  speed: {title: "Speed", row: 2, colour: "accent", about: "Wrong by more than 2 m/s."},
  size: {title: "Size", row: 2, colour: "accent",
         about: "Length or width is wrong by more than 1 m."},
  found_late: {title: "Found late", colour: "ignored",
               about: "Vehicles that were there for over half a second before the first track."},
  false_track: {title: "Track on nothing labelled", colour: "ignored",
                about: "Bushes, poles, walls: the tracker follows every object of vehicle size, " +
                    "and the discriminator tells which ones are vehicles. Also vehicles that " +
                    "have no label."},
};

function fillMistakes(panel, state) {
  const run = state.run;
  if (!run.truth) {
    panel.innerHTML = `<p>This report was made without truth, so it cannot tell where the
      tracker errs. <code>vdamf-report run.rawlog -o run.html --truth truth.csv</code> can.</p>`;
    return;
  }
  const all = run.truth.mistakes;
  panel.append(paragraph(`${all.length} entries. Click one to see it; the dashed boxes are the ` +
                         "labels, filled red where they are missed."));
  for (const [kind, {title, about, colour: ink}] of Object.entries(kMistakes)) {
    const some = all.filter((mistake) => mistake.kind === kind);
    if (some.length === 0) continue;
    const details = document.createElement("details");
    details.open = kind !== "false_track" && kind !== "found_late";
    const summary = document.createElement("summary");
    summary.innerHTML = `<span class="swatch" style="background:var(--${ink})"></span>` +
        `${title} <b>${some.length}</b>`;
    details.append(summary, paragraph(about));
    for (const mistake of some) details.append(mistakeButton(state, mistake));
    panel.append(details);
  }
}

function paragraph(text) {
  const p = document.createElement("p");
  p.className = "soft";
  p.textContent = text;
  return p;
}

function mistakeButton(state, mistake) {
  const run = state.run;
  const button = document.createElement("button");
  button.className = "mistake";
  const time = document.createElement("time");
  time.textContent = `${run.times[mistake.first].toFixed(1)} s`;
  button.append(time, mistakeText(run, mistake));
  button.addEventListener("click", () => {
    for (const other of document.querySelectorAll(".mistake.selected"))
      other.classList.remove("selected");
    button.classList.add("selected");
    showMistake(state, mistake);
  });
  return button;
}

function mistakeText(run, m) {
  const object = m.object === null ? "" : nameOfObject(run.objects[m.object]);
  const seconds = `${Math.max(0.1, run.times[m.last] - run.times[m.first]).toFixed(1)} s`;
  const worst = {
    position: `${m.worst} m`, heading: `${m.worst}°`, speed: `${m.worst} m/s`,
    size: `${m.worst} m`, box_off: `overlap ${Math.round(m.worst * 100)} %`,
  }[m.kind];
  if (m.kind === "identity_switch") return `${object}: #${m.trackBefore} → #${m.track}`;
  if (m.kind === "false_track") return `#${m.track}, ${seconds}`;
  const track = m.track === null ? "" : `, #${m.track}`;
  return `${object}${track}, ${worst ? worst + ", " : ""}${seconds}`;
}

/** Goes to the worst frame, selects who it is about and brings it to the middle. */
function showMistake(state, m) {
  const frame = ["lost", "never_found"].includes(m.kind) ? Math.round((m.first + m.last) / 2)
                                                         : m.worstFrame;
  state.set({playing: false, frame, track: m.track, object: m.object});
  const place = state.selectedPlace();
  if (!place) return;
  state.set({follow: "track"});
  state.set({centre: {place, close: true}});
}
