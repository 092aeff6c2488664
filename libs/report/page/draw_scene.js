// SPDX-License-Identifier: BSD-3-Clause
// What the scene stands on: grid, range rings, the sensor and its path, scale bar, labels.
"use strict";

/** A round length in metres that is about so many pixels long. */
function roundLength(camera, pixels) {
  const metres = pixels / camera.scale;
  const power = 10 ** Math.floor(Math.log10(metres));
  return [1, 2, 5, 10].map((k) => k * power).find((length) => length >= metres) ?? 10 * power;
}

function drawGrid(context, camera, sensor) {
  context.strokeStyle = colour("grid");
  context.fillStyle = colour("grid-ink");
  context.font = "11px system-ui, sans-serif";
  context.lineWidth = 1;
  const [px, py] = camera.toScreen(sensor[0], sensor[1]);
  const step = Math.max(5, roundLength(camera, 110));
  const farthest = Math.hypot(camera.width, camera.height) / camera.scale;
  for (let range = step; range < farthest && range <= 200; range += step) {
    context.beginPath();
    context.arc(px, py, range * camera.scale, 0, 2 * Math.PI);
    context.stroke();
    context.fillText(`${range} m`, px + range * camera.scale * 0.7071 + 3,
                     py + range * camera.scale * 0.7071 + 3);
  }
}

function drawSensor(context, camera, run, frame) {
  context.strokeStyle = context.fillStyle = colour("sensor");
  context.lineWidth = 2;
  context.globalAlpha = 0.5;
  pathOf(context, camera, run.frames.sensor.slice(0, frame + 1), false);
  context.stroke();
  context.globalAlpha = 1;
  const [px, py] = camera.toScreen(...run.sensorAt(frame));
  context.beginPath();
  context.arc(px, py, 5, 0, 2 * Math.PI);
  context.fill();
  context.font = "11px system-ui, sans-serif";
  context.fillText("sensor", px + 8, py + 14);
}

/** The ray to the selected one, as in Fig. 8. */
function drawRay(context, camera, run, frame, place) {
  context.strokeStyle = colour("sensor");
  context.setLineDash([7, 5]);
  context.lineWidth = 1;
  pathOf(context, camera, [run.sensorAt(frame), place], false);
  context.stroke();
  context.setLineDash([]);
}

function drawScaleBar(context, camera) {
  const length = roundLength(camera, 90);
  const x = 16, y = camera.height - 16, right = x + length * camera.scale;
  context.strokeStyle = context.fillStyle = colour("ink");
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x, y - 5);
  context.lineTo(x, y);
  context.lineTo(right, y);
  context.lineTo(right, y - 5);
  context.stroke();
  context.font = "12px system-ui, sans-serif";
  context.fillText(`${length} m`, x + 5, y - 6);
  context.fillText("N ↑", right + 12, y);
}

/** Texts {x, y, text, colour, rank}, in pixels; of two that overlap the one of lower rank stays. */
function drawLabels(context, labels) {
  context.font = "600 12px system-ui, sans-serif";
  context.lineWidth = 3;
  context.lineJoin = "round";
  const taken = [];
  for (const label of labels.sort((a, b) => a.rank - b.rank)) {
    const width = context.measureText(label.text).width;
    const place = [label.x - 2, label.y - 12, label.x + width + 2, label.y + 4];
    if (taken.some((t) => place[0] < t[2] && place[2] > t[0] && place[1] < t[3] && place[3] > t[1]))
      continue;
    taken.push(place);
    context.strokeStyle = colour("scene");
    context.strokeText(label.text, label.x, label.y);
    context.fillStyle = label.colour;
    context.fillText(label.text, label.x, label.y);
  }
}

/** What is written beside a track: number, what it is on or what it is held for, speed. */
function labelOf(state, track, i) {
  const words = [`#${track.id}`];
  const pair = state.run.matches?.[track.frame[i]].byTrack.get(track.id);
  if (pair) words.push(nameOfObject(state.run.objects[pair.object]));
  if (Math.abs(track.speed[i]) > 0.8) words.push(`${track.speed[i].toFixed(1)} m/s`);
  return words.join(" ");
}

/** "Van van_ahead", or "Car 3" where the id is a number. */
function nameOfObject(object) {
  const tellsClass = object.id.toLowerCase().includes(object.class.toLowerCase());
  return tellsClass ? object.id : `${object.class} ${object.id}`;
}

/** Whether there is room for the name of a track. */
function hasLabel(state, camera, track, i) {
  return !isSubdued(state, track, i) || camera.scale > 16;
}

/** Rank of a track's label: selected, on a vehicle, moving, the rest. */
function labelRank(state, track, i) {
  if (state.track === track.id) return 0;
  if (state.run.matches?.[track.frame[i]].byTrack.has(track.id)) return 2;
  return Math.abs(track.speed[i]) > 1 ? 3 : 4;
}
