// SPDX-License-Identifier: BSD-3-Clause
// The matched filter as a surface, as in Figs. 4 (b) and 5: its height over the plane, obliquely.
"use strict";

/** Cells between all edges of the regions, in the box's frame: {x0, x1, y0, y1, height}. */
function filterCells(regions) {
  const edges = (low, high) => [...new Set(regions.flatMap((r) => [r[low], r[high]]))]
      .sort((a, b) => a - b);
  const xs = edges("x0", "x1"), ys = edges("y0", "y1");
  const cells = [];
  for (let i = 0; i + 1 < xs.length; ++i)
    for (let j = 0; j + 1 < ys.length; ++j)
      cells.push({x0: xs[i], x1: xs[i + 1], y0: ys[j], y1: ys[j + 1],
                  height: filterHeight(regions, (xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2)});
  return cells;
}

/** The surround is negative, the interior slightly positive, strips stand on the interior. */
function filterHeight(regions, x, y) {
  let height = 0;
  for (const r of regions) {
    if (x < r.x0 || x > r.x1 || y < r.y0 || y > r.y1) continue;
    height = r.name === "strip" ? height + r.weight : r.weight;
  }
  return height;
}

/** Blocks from the plane to the filter's height, far ones first; the seen corner is at the back. */
function drawSurface(canvas, regions) {
  const context = contextOf(canvas);
  const kTilt = 0.42, kHeight = 2.2;  // of the plane; metres of the picture a unit of the filter
  const [, , side, end] = regions;
  const turn = Math.atan2(0.5 * Math.sign(end.x0 + end.x1), 0.87 * Math.sign(side.y0 + side.y1));
  const c = Math.cos(turn), s = Math.sin(turn);
  const reach = 2.1 * Math.max(...regions.map((r) => Math.hypot(r.x1, r.y1)));
  const scale = Math.min(canvas.clientWidth / reach,
                         canvas.clientHeight / (reach * kTilt + 1.4 * kHeight));
  const depth = (x, y) => s * x + c * y;  // away from the reader
  const pixel = (x, y, z) => [canvas.clientWidth / 2 + (c * x - s * y) * scale,
      canvas.clientHeight * 0.6 - (depth(x, y) * kTilt + z * kHeight) * scale];
  const middle = (cell) => depth((cell.x0 + cell.x1) / 2, (cell.y0 + cell.y1) / 2);
  for (const cell of filterCells(regions).sort((a, b) => middle(b) - middle(a)))
    drawBlock(context, cell, pixel, depth);
}

function drawBlock(context, {x0, x1, y0, y1, height}, pixel, depth) {
  const ink = colour(height < 0 ? "surround" : height > 0.15 ? "strip" : "interior");
  const corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
  const fill = (points, light) => {
    context.beginPath();
    for (const p of points) context.lineTo(...pixel(...p));
    context.closePath();
    context.fillStyle = colour("scene");
    context.fill();
    context.globalAlpha = light;
    context.fillStyle = ink;
    context.fill();
    context.globalAlpha = 0.8;
    context.strokeStyle = ink;
    context.lineWidth = 0.7;
    context.stroke();
    context.globalAlpha = 1;
  };
  corners.forEach((a, k) => {
    const b = corners[(k + 1) % 4];
    const isNear = depth((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) <
                   depth((x0 + x1) / 2, (y0 + y1) / 2);
    if (isNear) fill([[...a, 0], [...b, 0], [...b, height], [...a, height]], 0.55);
  });
  fill(corners.map((corner) => [...corner, height]), 0.3);
}
