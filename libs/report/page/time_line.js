// SPDX-License-Identifier: BSD-3-Clause
// The line of time below the scene: mistakes, the life of the selected track, the slider.
"use strict";

function startTimeLine(state) {
  const seek = document.getElementById("seek");
  const marks = document.getElementById("marks");
  const clock = document.getElementById("clock");
  seek.max = state.run.count - 1;
  seek.addEventListener("input", () => state.set({playing: false, frame: Number(seek.value)}));
  const toFrame = (event) =>
      event.offsetX / marks.clientWidth * (state.run.count - 1);
  marks.addEventListener("pointerdown", (event) => state.seek(toFrame(event)));
  marks.addEventListener("pointermove", (event) => {
    if (event.buttons === 1) state.seek(toFrame(event));
  });
  const show = () => {
    seek.value = state.frame;
    const run = state.run;
    clock.textContent = `${run.times[state.frame].toFixed(2)} s of ${
        run.times[run.count - 1].toFixed(2)} s · frame ${state.frame}`;
    drawMarks(marks, state);
  };
  state.onChange((changed) => {
    if (["frame", "track", "object"].some((key) => changed.has(key))) show();
  });
  themeListeners.push(show);
  addEventListener("resize", show);
  show();
}

/** Above, mistakes, a row for each group of kinds; below, the selected track's life as a bar. */
function drawMarks(canvas, state) {
  const context = contextOf(canvas);
  const run = state.run;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  const x = (frame) => frame / Math.max(1, run.count - 1) * width;
  const row = (y, first, last, ink, alpha = 0.8) => {
    context.fillStyle = ink;
    context.globalAlpha = alpha;
    context.fillRect(x(first), y, Math.max(2, x(last + 1) - x(first)), 4);
    context.globalAlpha = 1;
  };
  for (const mistake of run.truth?.mistakes ?? []) {
    const kind = kMistakes[mistake.kind];
    if (kind.row === undefined) continue;
    row(kind.row * 6, mistake.first, mistake.last, colour(kind.colour), 0.55);
  }
  const track = run.byId.get(state.track);
  if (track) row(height - 5, track.first, track.last, colour("accent"));
  context.fillStyle = colour("ink");
  context.fillRect(x(state.frame) - 1, 0, 2, height);
}
