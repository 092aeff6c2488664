// SPDX-License-Identifier: BSD-3-Clause
// World to screen, seen from above: north is up.
"use strict";

class Camera {
  constructor() {
    this.x = 0;  // of the middle, world, m
    this.y = 0;
    this.scale = 9;  // pixels a metre
    this.width = 1;
    this.height = 1;
  }

  toScreen(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale,
            this.height / 2 - (y - this.y) * this.scale];
  }

  toWorld(px, py) {
    return [this.x + (px - this.width / 2) / this.scale,
            this.y - (py - this.height / 2) / this.scale];
  }

  /** Zooms so that the point of the world under a pixel stays there. */
  zoomAt(px, py, factor) {
    const [x, y] = this.toWorld(px, py);
    this.scale = Math.max(0.5, Math.min(300, this.scale * factor));
    const [nowX, nowY] = this.toWorld(px, py);
    this.x += x - nowX;
    this.y += y - nowY;
  }

  sees(x, y, margin = 8) {
    const [px, py] = this.toScreen(x, y);
    const m = margin * this.scale;
    return px > -m && py > -m && px < this.width + m && py < this.height + m;
  }
}

/** Corners of a box: front left, rear left, rear right, front right. */
function cornersOf(box, grow = 0) {
  const c = Math.cos(box.heading), s = Math.sin(box.heading);
  const l = box.length / 2 + grow, w = box.width / 2 + grow;
  return [[l, w], [-l, w], [-l, -w], [l, -w]]
      .map(([x, y]) => [box.x + c * x - s * y, box.y + s * x + c * y]);
}

/** A point in the frame of a box: x to its front, y to its left. */
function inBox(box, x, y) {
  const c = Math.cos(box.heading), s = Math.sin(box.heading);
  return [c * (x - box.x) + s * (y - box.y), -s * (x - box.x) + c * (y - box.y)];
}

/** Fits a canvas to its place and the screen's pixels; returns its 2D context, in CSS pixels. */
function contextOf(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio);
  const height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  return context;
}
