// SPDX-License-Identifier: BSD-3-Clause
// Tracks and truth from above: box, front, faces seen, 1-sigma ellipse and heading wedge, trail.
"use strict";

const kTrailSeconds = 4;

function pathOf(context, camera, points, close = true) {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(...camera.toScreen(x, y));
  if (close) context.closePath();
}

/** Faces by their letters as pairs of corners (cornersOf). */
const kFaces = {L: [0, 1], B: [1, 2], R: [2, 3], F: [3, 0]};

function drawTrack(context, camera, state, track, i) {
  const box = track.box(i);
  const selected = state.track === track.id;
  const stroke = trackColour(state, track, i);
  const subdued = isSubdued(state, track, i);
  context.strokeStyle = context.fillStyle = stroke;
  if (state.layers.trails && !subdued)
    drawTrail(context, camera, state.run.times, track, i, selected ? Infinity : kTrailSeconds);
  const corners = cornersOf(box);
  pathOf(context, camera, corners);
  context.globalAlpha = selected ? 0.3 : subdued ? 0.05 : 0.15;
  context.fill();
  context.globalAlpha = subdued ? 0.6 : 1;
  context.lineWidth = selected ? 2.5 : subdued ? 0.8 : 1.5;
  context.setLineDash(track.status[i] === "coasting" ? [5, 4] : []);
  context.stroke();
  context.setLineDash([]);
  context.globalAlpha = 1;
  if (subdued) return;
  if (state.layers.faces) drawFaces(context, camera, corners, track.faces[i]);
  drawFront(context, camera, box, track.speed[i]);
  const large = camera.scale * Math.max(box.length, box.width) > 55;
  if (state.layers.sigma && (selected || large)) drawSigma(context, camera, track, i);
}

/** The way behind, from the centres of the boxes. */
function drawTrail(context, camera, times, track, i, seconds) {
  context.beginPath();
  const since = times[track.frame[i]] - seconds;
  for (let k = i; k >= 0 && times[track.frame[k]] >= since; --k)
    context.lineTo(...camera.toScreen(track.x[k], track.y[k]));
  context.globalAlpha = 0.55;
  context.lineWidth = 1.5;
  context.stroke();
  context.globalAlpha = 1;
}

function drawFaces(context, camera, corners, letters) {
  context.lineWidth = 4;
  for (const letter of letters) {
    const [a, b] = kFaces[letter];
    pathOf(context, camera, [corners[a], corners[b]], false);
    context.stroke();
  }
}

/** A triangle in the front third of the box, and a line as far as it gets in a second. */
function drawFront(context, camera, box, speed) {
  const c = Math.cos(box.heading), s = Math.sin(box.heading);
  const at = (x, y) => [box.x + c * x - s * y, box.y + s * x + c * y];
  const l = box.length / 2, w = box.width / 2;
  pathOf(context, camera, [at(l, 0), at(l * 0.45, w * 0.6), at(l * 0.45, -w * 0.6)]);
  context.fill();
  if (Math.abs(speed) < 0.5) return;
  const ahead = speed > 0 ? l : -l;
  pathOf(context, camera, [at(ahead, 0), at(ahead + speed, 0)], false);
  context.lineWidth = 1.5;
  context.stroke();
}

/** Fig. 8: the 1-sigma ellipse of the centre, and the 1-sigma segment of the heading. */
function drawSigma(context, camera, track, i) {
  const half = (track.varX[i] + track.varY[i]) / 2;
  const difference = (track.varX[i] - track.varY[i]) / 2;
  const root = Math.hypot(difference, track.covXY[i]);
  const angle = Math.atan2(track.covXY[i], difference) / 2;
  const [px, py] = camera.toScreen(track.x[i], track.y[i]);
  const axis = (variance) => Math.sqrt(Math.max(0, variance)) * camera.scale;
  context.lineWidth = 1.2;
  context.beginPath();
  context.ellipse(px, py, axis(half + root), axis(half - root), -angle, 0, 2 * Math.PI);
  context.stroke();
  const sigma = Math.min(Math.PI, Math.sqrt(track.varHeading[i]));
  const heading = -track.heading[i];
  context.beginPath();
  context.moveTo(px, py);
  context.arc(px, py, (track.length[i] / 2 + 1) * camera.scale, heading - sigma, heading + sigma);
  context.closePath();
  context.globalAlpha = 0.25;
  context.fill();
  context.globalAlpha = 1;
  context.stroke();
}

/** Labels: dashed; filled in the colour of misses where no track is on a vehicle that counts. */
function drawObject(context, camera, state, object, index, i) {
  drawLabelBox(context, camera, state, object, i,
               state.run.matches[state.frame].missed.has(index), state.object === index);
}

function drawLabelBox(context, camera, state, object, i, missed, selected) {
  pathOf(context, camera, cornersOf(object.box(i)));
  context.strokeStyle = context.fillStyle = colour(missed ? "bad" : "truth");
  context.lineWidth = selected ? 2.5 : 1.5;
  if (missed) {
    context.globalAlpha = 0.3;
    context.fill();
    context.globalAlpha = 1;
  }
  context.setLineDash(object.counts[i] ? [6, 3] : [2, 4]);
  context.stroke();
  const c = Math.cos(object.heading[i]), s = Math.sin(object.heading[i]);
  const l = object.length[i] / 2;
  pathOf(context, camera, [[object.x[i], object.y[i]], [object.x[i] + c * l, object.y[i] + s * l]],
         false);
  context.stroke();
  context.setLineDash([]);
}
