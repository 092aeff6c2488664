// SPDX-License-Identifier: BSD-3-Clause
// A track over its life, with the truth of the vehicle it is on: the charts of the panel.
"use strict";

function chartsOf(state, track) {
  const run = state.run;
  const times = track.frame.map((frame) => run.times[frame]);
  const onSeek = (time) => state.set({playing: false, frame: run.frameAt(time)});
  const object = track.follows[0]?.object;
  const root = (variances, factor = 1) => variances.map((v) => factor * Math.sqrt(Math.max(0, v)));
  const of = (values, more = {}) => ({values, times, colour: "var(--accent)", ...more});
  // The truth at the track's frames.
  const truth = (value, more = {}) => object
      ? [{values: track.frame.map((frame, i) => object.at(frame) < 0 ? null
              : value(object.at(frame), i)),
          times, colour: "var(--truth)", dashed: true, ...more}] : [];
  const degrees = 180 / Math.PI;
  const headings = unwrapped(track.heading.map((h) => h * degrees));
  const charts = [
    {title: "Speed (m/s)", series: [of(track.speed, {sigma: root(track.varSpeed)}),
                                    ...truth((k) => object.speed[k])]},
    {title: "Heading (°)", series: [of(headings, {sigma: root(track.varHeading, degrees)}),
        ...truth((k, i) => nearestTurn(object.heading[k] * degrees, headings[i]))]},
    {title: "Front as drawn, probability", range: [0, 1],
     series: [of(track.forward)]},
    {title: "Length (m)", series: [of(track.length, {sigma: root(track.varLength)}),
                                   ...truth((k) => object.length[k])]},
    {title: "Width (m)", series: [of(track.width, {sigma: root(track.varWidth)}),
                                  ...truth((k) => object.width[k])]},
    {title: "Match (1/m)", series: [of(track.match)]},
    {title: "NIS (dashed: 95 %)", limit: 7.81, series: [of(track.nis, {dots: true})]},
    {title: "Hits", series: [of(track.hits)]},
  ];
  if (track.probability.some((p) => p !== null))
    charts.push({title: "Vehicle probability", range: [0, 1], series: [of(track.probability)]});
  return charts.map((chart) => chartOf({...chart, onSeek}));
}

/** Degrees without jumps of a whole turn. */
function unwrapped(angles) {
  const out = [];
  for (const angle of angles)
    out.push(out.length ? nearestTurn(angle, out[out.length - 1]) : angle);
  return out;
}

function nearestTurn(angle, to) {
  return angle - 360 * Math.round((angle - to) / 360);
}
