// SPDX-License-Identifier: BSD-3-Clause
// The run in numbers: what was tracked, how well, how fast.
"use strict";

function fillSummary(panel, state) {
  const run = state.run;
  const published = run.tracks.filter((track) => track.wasPublished);
  const seconds = run.times[run.count - 1];
  const cards = [[run.count, "frames"], [`${seconds.toFixed(1)} s`, "of time"],
                 [published.length, "objects tracked"],
                 [Math.round(meanOf(run.frames.points)).toLocaleString("en"), "hits a frame"],
                 [Math.round(meanOf(run.frames.clusters)), "clusters a frame"],
                 [distanceDriven(run), "driven"]];
  panel.append(cardsOf(cards));
  if (run.truth) fillMetrics(panel, run.truth.metrics);
  fillNis(panel, run);
  if (run.facts.stages.length) fillStages(panel, run.facts.stages);
  panel.append(tableOf("The run", [...run.facts.rows, ["Program", `vdamf ${run.facts.version}`]]));
  const details = document.createElement("details");
  details.innerHTML = "<summary>Configuration</summary>";
  const text = document.createElement("pre");
  text.textContent = run.facts.configuration;
  details.append(text);
  panel.append(details);
}

function cardsOf(cards) {
  const grid = document.createElement("div");
  grid.className = "cards";
  for (const [value, text] of cards) {
    const card = document.createElement("div");
    card.className = "card";
    card.innerHTML = `<b>${escaped(String(value))}</b><span>${escaped(text)}</span>`;
    grid.append(card);
  }
  return grid;
}

function tableOf(title, rows) {
  const part = document.createElement("section");
  part.innerHTML = `<h3>${escaped(title)}</h3><table>` + rows.map((row) => `<tr>${row
      .map((cell) => `<td>${escaped(String(cell))}</td>`).join("")}</tr>`).join("") + "</table>";
  return part;
}

function distanceDriven(run) {
  let metres = 0;
  const path = run.frames.sensor;
  for (let f = 1; f < path.length; ++f)
    metres += Math.hypot(path[f][0] - path[f - 1][0], path[f][1] - path[f - 1][1]);
  return `${metres.toFixed(0)} m`;
}

function fillMetrics(panel, metrics) {
  const percent = (v) => v === null || v === undefined ? "-" : `${(100 * v).toFixed(1)} %`;
  const m = metrics.clear_mot;
  panel.append(cardsOf([
    [percent(m.recall), "of labelled vehicles found"], [percent(metrics.hota?.hota), "HOTA"],
    [m.identity_switches, "identity switches"],
  ]));
  const errors = metrics.errors;
  const row = (name, e, unit) => [name, e.median === null ? "-" : `${e.median.toFixed(2)} ${unit}`,
                                  e.p95 === null ? "-" : `${e.p95.toFixed(2)} ${unit}`];
  panel.append(tableOf("Errors of tracks on vehicles: median, 95 %", [
    row("Position", errors.position_m, "m"), row("Nearest corner", errors.corner_m, "m"),
    row("Heading (axis)", errors.heading_mod_180_deg, "°"), row("Speed", errors.speed_mps, "m/s"),
    row("Length", errors.length_m, "m"), row("Width", errors.width_m, "m"),
  ]));
  panel.append(tableOf("Detection and tracking", [
    ["MOTA", percent(m.mota)], ["IDF1", percent(metrics.identity?.idf1)],
    ["Precision", percent(m.precision)],
    ["Objects mostly tracked / partly / mostly lost",
     `${m.mostly_tracked} / ${m.partly_tracked} / ${m.mostly_lost}`],
    ["Breaks of tracks", m.fragmentations],
  ]));
  panel.append(paragraph("The tracker follows every object of vehicle size. Where tracks on " +
                         "bushes and walls are judged too, precision and MOTA count them as " +
                         "false: --vehicles-only leaves them to the discriminator."));
}

/** How the filter's confidence sits with what it then measured. */
function fillNis(panel, run) {
  const values = run.tracks.flatMap((track) =>
      track.nis.filter((v, i) => v !== null && track.status[i] === "confirmed"));
  if (values.length === 0) return;
  const share = (limit) => `${(100 * values.filter((v) => v < limit).length / values.length)
      .toFixed(0)} %`;
  panel.append(tableOf("Innovations (NIS) of confirmed tracks", [
    ["Mean (3 expected)", meanOf(values).toFixed(2)],
    ["Inside the 68 / 95 / 99 % bounds", `${share(3.51)} / ${share(7.81)} / ${share(11.34)}`],
  ]));
}

function fillStages(panel, stages) {
  const part = document.createElement("section");
  const total = stages.reduce((sum, [, ms]) => sum + ms, 0);
  part.innerHTML = "<h3>Time a frame</h3><table>" + stages.map(([name, ms]) =>
      `<tr><td>${escaped(name)}</td><td>${ms.toFixed(2)} ms</td><td class="left"><span class="bar"
       style="width:${Math.round(140 * ms / total)}px"></span></td></tr>`).join("") +
      `<tr><th>all</th><th>${total.toFixed(2)} ms</th><th></th></tr></table>`;
  panel.append(part);
}
