// SPDX-License-Identifier: BSD-3-Clause
// The matched filter of the paper (Table 1) around a box, for the close-up.
"use strict";

/**
 * The rectangles in the frame of the box: {name, x0, x1, y0, y1, weight}, in order of drawing.
 * beta is the box's heading minus the bearing to the sensor; of the two visible edges the heavier
 * one takes the corner they share.
 */
function filterRegions(filter, box, sensor) {
  const beta = box.heading - Math.atan2(sensor[1] - box.y, sensor[0] - box.x);
  const front = Math.cos(beta) > 0, left = Math.sin(beta) < 0;
  const endWeight = Math.abs(Math.cos(beta)), sideWeight = Math.abs(Math.sin(beta));
  const l = box.length / 2, w = box.width / 2;
  const end = front ? [l - filter.endStrip, l] : [-l, -l + filter.endStrip];
  const side = left ? [w - filter.sideStrip, w] : [-w, -w + filter.sideStrip];
  const restX = front ? [-l, end[0]] : [end[1], l];
  const restY = left ? [-w, side[0]] : [side[1], w];
  const sideX = sideWeight >= endWeight ? [-l, l] : restX;
  const endY = sideWeight >= endWeight ? restY : [-w, w];
  const region = (name, x, y, weight) => ({name, x0: x[0], x1: x[1], y0: y[0], y1: y[1], weight});
  return [
    region("surround", [-l - filter.endMargin, l + filter.endMargin],
           [-w - filter.sideMargin, w + filter.sideMargin], filter.surroundWeight),
    region("interior", [-l, l], [-w, w], filter.interiorWeight),
    region("strip", sideX, side, sideWeight),
    region("strip", end, endY, endWeight),
  ];
}
