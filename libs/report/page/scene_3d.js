// SPDX-License-Identifier: BSD-3-Clause
// What the 3D view draws, as rows of x, y, z, red, green, blue, alpha.
"use strict";

const rgbaOf = new Map();

/** Any colour of CSS as four numbers of 0..1. */
function rgba(css) {
  if (!rgbaOf.has(css)) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 1;
    const context = canvas.getContext("2d");
    context.fillStyle = css;
    context.fillRect(0, 0, 1, 1);
    rgbaOf.set(css, [...context.getImageData(0, 0, 1, 1).data].map((v) => v / 255));
  }
  return rgbaOf.get(css);
}

/** Places are relative to `target`, so that single precision is enough. */
function sceneOf(state, shown, target) {
  const scene = {points: [], lines: [], faces: []};
  const add = (rows, [x, y, z], [r, g, b, a], alpha = a) =>
      rows.push(x - target[0], y - target[1], z - target[2], r, g, b, alpha);
  const ground = groundHeight(state, shown);
  if (shown) addHits(scene, add, state, shown);
  addGrid(scene, add, ground, target);
  if (state.layers.boxes)
    for (const {track, i} of state.run.tracksAt(state.frame)) {
      const [r, g, b] = rgba(trackColour(state, track, i));
      const subdued = isSubdued(state, track, i);
      addBox(scene, add, track.box(i), [r, g, b, subdued ? 0.5 : 1],
             subdued ? 0 : state.track === track.id ? 0.35 : 0.14, track.faces[i]);
    }
  if (state.layers.truth && state.run.truth)
    for (const {object, index, i} of state.run.objectsAt(state.frame)) {
      const missed = state.run.matches[state.frame].missed.has(index);
      addBox(scene, add, object.box(i), rgba(colour(missed ? "bad" : "truth")),
             missed ? 0.3 : 0, "");
    }
  addSensor(scene, add, state, ground);
  return scene;
}

function addHits(scene, add, state, {hits, origin}) {
  for (const [index, group] of hits.groups.entries()) {
    const style = hitStyle(state, group, index);
    if (style === null) continue;
    const ink = rgba(style);
    for (let k = group.begin; k < group.end; ++k)
      add(scene.points, [origin[0] + hits.x[k], origin[1] + hits.y[k], origin[2] + hits.z[k]], ink);
  }
}

const kUsualSensorHeight = 1.8;

/** Of the ground around the sensor, from the hits on it; without any, that of a usual sensor. */
function groundHeight(state, shown) {
  const sensor = state.run.sensorAt(state.frame);
  const group = shown?.hits.groups[GROUND];
  const heights = [];
  for (let k = group?.begin ?? 0; k < (group?.end ?? 0); ++k)
    if (Math.hypot(shown.origin[0] + shown.hits.x[k] - sensor[0],
                   shown.origin[1] + shown.hits.y[k] - sensor[1]) < 15)
      heights.push(shown.origin[2] + shown.hits.z[k]);
  return heights.length > 10 ? medianOf(heights) : sensor[2] - kUsualSensorHeight;
}

/** Lines every 10 m. */
function addGrid(scene, add, ground, target) {
  const ink = rgba(colour("grid"));
  const x0 = Math.round(target[0] / 10) * 10, y0 = Math.round(target[1] / 10) * 10;
  for (let k = -60; k <= 60; k += 10)
    for (const [a, b] of [[[x0 + k, y0 - 60], [x0 + k, y0 + 60]],
                          [[x0 - 60, y0 + k], [x0 + 60, y0 + k]]]) {
      add(scene.lines, [...a, ground], ink);
      add(scene.lines, [...b, ground], ink);
    }
}

/** Edges, a mark to the front and faces; those seen are fuller. */
function addBox(scene, add, box, ink, alpha, letters) {
  const corners = cornersOf(box);
  const low = box.z, high = box.z + Math.max(0.2, box.height);
  const at = (k, z) => [...corners[k % 4], z];
  const line = (a, b) => { add(scene.lines, a, ink); add(scene.lines, b, ink); };
  for (let k = 0; k < 4; ++k) {
    line(at(k, low), at(k + 1, low));
    line(at(k, high), at(k + 1, high));
    line(at(k, low), at(k, high));
  }
  const c = Math.cos(box.heading), s = Math.sin(box.heading), l = box.length / 2;
  line([box.x, box.y, high], [box.x + c * (l + 1), box.y + s * (l + 1), high]);
  const quad = (a, b, c2, d, opacity) => {
    for (const p of [a, b, c2, a, c2, d]) add(scene.faces, p, ink, opacity);
  };
  if (alpha <= 0) return;
  quad(at(0, high), at(1, high), at(2, high), at(3, high), alpha);
  for (const [letter, [a, b]] of Object.entries(kFaces))
    quad(at(a, low), at(b, low), at(b, high), at(a, high),
         letters.includes(letter) ? alpha + 0.25 : alpha * 0.6);
}

/** A post where the sensor is, and its path: as high over the path as now over the ground. */
function addSensor(scene, add, state, ground) {
  const ink = rgba(colour("sensor"));
  const [x, y, z] = state.run.sensorAt(state.frame);
  add(scene.lines, [x, y, ground], ink);
  add(scene.lines, [x, y, z + 0.3], ink);
  const path = state.run.frames.sensor;
  for (let f = 1; f <= state.frame; ++f)
    for (const [px, py, pz] of [path[f - 1], path[f]])
      add(scene.lines, [px, py, pz - (z - ground)], ink);
}
