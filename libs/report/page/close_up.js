// SPDX-License-Identifier: BSD-3-Clause
// A track close up, as in Figs. 4, 5 and 8: its hits, the measured box, the matched filter on it.
"use strict";

function drawCloseUp(canvas, state, store, track) {
  const context = contextOf(canvas);
  const i = track.at(state.frame);
  if (i < 0) return;
  const box = track.measuredBox(i) ?? track.box(i);
  const camera = new Camera();
  camera.width = canvas.clientWidth;
  camera.height = canvas.clientHeight;
  camera.x = box.x;
  camera.y = box.y;
  const reach = Math.hypot(box.length, box.width) + 3;
  camera.scale = Math.min(camera.width, camera.height) / reach;
  const sensor = state.run.sensorAt(state.frame);
  if (state.layers.filter && track.measured[i])
    drawFilter(context, camera, filterRegions(state.run.filter, box, sensor), box);
  drawCloseHits(context, camera, state, store, track);
  drawCloseTruth(context, camera, state);
  context.strokeStyle = context.fillStyle = colour("ink");
  context.lineWidth = 1;
  context.setLineDash([2, 3]);
  pathOf(context, camera, cornersOf(track.box(i)));
  context.stroke();
  context.setLineDash([]);
  drawSigma(context, camera, track, i);
  drawMeasured(context, camera, track, i, box);
  drawSensorWay(context, camera, box, sensor);
  drawScaleBar(context, camera);
}

function drawFilter(context, camera, regions, box) {
  const c = Math.cos(box.heading), s = Math.sin(box.heading);
  for (const region of regions) {
    const {x0, x1, y0, y1} = region;
    pathOf(context, camera, [[x1, y1], [x0, y1], [x0, y0], [x1, y0]]
        .map(([x, y]) => [box.x + c * x - s * y, box.y + s * x + c * y]));
    context.fillStyle = context.strokeStyle = colour(region.name);
    context.globalAlpha = region.name === "strip" ? 0.6 * region.weight : 0.15;
    if (region.name !== "surround") context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 1.2;
    context.setLineDash(region.name === "surround" ? [5, 4] : []);
    if (region.name !== "interior") context.stroke();
    context.setLineDash([]);
  }
}

/** Crosses; hits on other things are faint. The ground is left out. */
function drawCloseHits(context, camera, state, store, track) {
  const hits = store.at(state.frame);
  if (!hits) return;
  const origin = state.run.frames.origin[state.frame];
  context.lineWidth = 1;
  for (const group of hits.groups) {
    if (group.kind < STRUCTURE) continue;
    context.strokeStyle = colour("ink");
    context.globalAlpha = group.track === track.id ? 0.85 : 0.25;
    context.beginPath();
    for (let k = group.begin; k < group.end; ++k) {
      const [x, y] = camera.toScreen(origin[0] + hits.x[k], origin[1] + hits.y[k]);
      if (x < 0 || y < 0 || x > camera.width || y > camera.height) continue;
      context.moveTo(x - 2, y - 2);
      context.lineTo(x + 2, y + 2);
      context.moveTo(x - 2, y + 2);
      context.lineTo(x + 2, y - 2);
    }
    context.stroke();
  }
  context.globalAlpha = 1;
}

function drawCloseTruth(context, camera, state) {
  if (!state.layers.truth) return;
  for (const {object, i} of state.run.objectsAt(state.frame))
    drawLabelBox(context, camera, state, object, i, false, false);
}

/** The box measured in this frame; without a measurement, the track's. Seen faces are thick. */
function drawMeasured(context, camera, track, i, box) {
  context.strokeStyle = context.fillStyle = colour("bad");
  const corners = cornersOf(box);
  pathOf(context, camera, corners);
  context.lineWidth = 1.8;
  if (track.measured[i]) context.stroke();
  drawFaces(context, camera, corners, track.faces[i]);
  context.globalAlpha = 0.5;
  drawFront(context, camera, track.box(i), 0);
  context.globalAlpha = 1;
}

/** A dashed arrow from the edge of the picture: where the sensor is. */
function drawSensorWay(context, camera, box, sensor) {
  const distance = Math.hypot(sensor[0] - box.x, sensor[1] - box.y);
  const away = Math.min(distance, 0.47 * Math.min(camera.width, camera.height) / camera.scale);
  const ux = (sensor[0] - box.x) / distance, uy = (sensor[1] - box.y) / distance;
  const from = [box.x + ux * away, box.y + uy * away];
  context.strokeStyle = context.fillStyle = colour("ink");
  context.lineWidth = 1.2;
  context.setLineDash([6, 4]);
  pathOf(context, camera, [from, [box.x, box.y]], false);
  context.stroke();
  context.setLineDash([]);
  context.font = "11px system-ui, sans-serif";
  const [px, py] = camera.toScreen(...from);
  context.fillText(`sensor ${distance.toFixed(1)} m`, Math.min(px + 4, camera.width - 80), py + 4);
}
