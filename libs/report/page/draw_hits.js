// SPDX-License-Identifier: BSD-3-Clause
// LADAR hits from above: ground, structure and clusters, those on a track in its colour.
"use strict";

function drawHits(context, camera, state, hits, origin) {
  const size = Math.max(1.2, Math.min(3.5, camera.scale * 0.09));
  for (const [index, group] of hits.groups.entries()) {
    const style = hitStyle(state, group, index);
    if (style === null) continue;
    context.fillStyle = style;
    for (let i = group.begin; i < group.end; ++i) {
      const [px, py] = camera.toScreen(origin[0] + hits.x[i], origin[1] + hits.y[i]);
      if (px < 0 || py < 0 || px > camera.width || py > camera.height) continue;
      context.fillRect(px - size / 2, py - size / 2, size, size);
    }
  }
}

/** The colour of a group of hits, or null where it is not shown. */
function hitStyle(state, group, index) {
  const layers = state.layers;
  if (!layers.hits) return null;
  if (group.kind === GROUND) return layers.ground ? colour("ground") : null;
  if (group.kind === OVERHEAD) return layers.overhead ? colour("overhead") : null;
  if (group.kind === STRUCTURE) return colour("structure");
  if (layers.clusters) return identityColour(index);
  const track = state.run.byId.get(group.track);
  const i = track ? track.at(state.frame) : -1;
  return i >= 0 ? trackColour(state, track, i) : colour("cluster");
}
