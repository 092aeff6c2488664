// SPDX-License-Identifier: BSD-3-Clause
// The scene from above, and the hand on it: zoom, pan, pick.
"use strict";

class MapView {
  constructor(canvas, state, store) {
    this.canvas = canvas;
    this.state = state;
    this.store = store;
    this.camera = new Camera();
    this.offset = [0, 0];  // of the middle from what is followed, m
    this.shown = null;     // hits drawn last, while others are being unpacked
    this.camera.scale = Math.max(3, canvas.clientWidth / 110);
    this.listen();
  }

  /** What stays in the middle. */
  anchor() {
    const state = this.state;
    const selected = state.follow === "track" ? state.selectedPlace() : null;
    if (selected) return selected;
    return state.follow === "none" ? this.anchorKept ?? state.run.sensorAt(state.frame)
                                   : state.run.sensorAt(state.frame);
  }

  /** Brings a place to the middle. */
  centreOn([x, y], close) {
    const anchor = this.anchor();
    if (close) this.camera.scale = Math.max(14, this.camera.scale);
    this.offset = [x - anchor[0], y - anchor[1]];
  }

  draw() {
    const {state, camera} = this;
    const run = state.run;
    const context = contextOf(this.canvas);
    camera.width = this.canvas.clientWidth;
    camera.height = this.canvas.clientHeight;
    const anchor = this.anchorKept = this.anchor();
    camera.x = anchor[0] + this.offset[0];
    camera.y = anchor[1] + this.offset[1];
    drawGrid(context, camera, run.sensorAt(state.frame));
    const hits = this.store.at(state.frame);
    if (hits) this.shown = {hits, origin: run.frames.origin[state.frame]};
    if (this.shown) drawHits(context, camera, state, this.shown.hits, this.shown.origin);
    drawSensor(context, camera, run, state.frame);
    this.drawObjects(context);
    this.drawTracks(context);
    drawScaleBar(context, camera);
  }

  drawObjects(context) {
    this.labels = [];
    if (!this.state.layers.truth || !this.state.run.truth) return;
    for (const {object, index, i} of this.state.run.objectsAt(this.state.frame)) {
      if (!this.camera.sees(object.x[i], object.y[i])) continue;
      drawObject(context, this.camera, this.state, object, index, i);
      const missed = this.state.run.matches[this.state.frame].missed.has(index);
      if (missed || this.state.object === index)
        this.addLabel(object, i, `${missed ? "missed: " : ""}${nameOfObject(object)}`,
                      colour(missed ? "bad" : "truth"), this.state.object === index ? 1 : 1.5, 14);
    }
  }

  drawTracks(context) {
    const {state, camera} = this;
    if (state.layers.boxes) {
      for (const {track, i} of state.run.tracksAt(state.frame)) {
        if (!camera.sees(track.x[i], track.y[i]) && state.track !== track.id) continue;
        drawTrack(context, camera, state, track, i);
        if (hasLabel(state, camera, track, i))
          this.addLabel(track, i, labelOf(state, track, i), trackColour(state, track, i),
                        labelRank(state, track, i), 0);
      }
    }
    if (state.layers.rays)
      for (const {track, i} of state.run.tracksAt(state.frame))
        drawRay(context, camera, state.run, state.frame, [track.x[i], track.y[i]]);
    const place = state.selectedPlace();
    if (place) drawRay(context, camera, state.run, state.frame, place);
    if (state.layers.labels) drawLabels(context, this.labels);
  }

  /** Above right of a box. */
  addLabel(history, i, text, ink, rank, lower) {
    const corners = cornersOf(history.box(i)).map(([x, y]) => this.camera.toScreen(x, y));
    const x = Math.max(...corners.map((c) => c[0])) + 4;
    const y = Math.min(...corners.map((c) => c[1])) + lower;
    this.labels.push({x, y, text, colour: ink, rank});
  }

  listen() {
    const canvas = this.canvas;
    let pressed = null;
    canvas.addEventListener("pointerdown", (event) => {
      pressed = {x: event.offsetX, y: event.offsetY, moved: false};
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!pressed || this.state.view !== "above") return;
      const dx = event.offsetX - pressed.x, dy = event.offsetY - pressed.y;
      if (!pressed.moved && Math.hypot(dx, dy) < 4) return;
      this.offset[0] -= dx / this.camera.scale;
      this.offset[1] += dy / this.camera.scale;
      pressed = {x: event.offsetX, y: event.offsetY, moved: true};
      this.draw();
    });
    canvas.addEventListener("pointerup", (event) => {
      if (pressed && !pressed.moved && this.state.view === "above")
        this.pick(event.offsetX, event.offsetY);
      pressed = null;
    });
    canvas.addEventListener("dblclick", () => {
      if (this.state.track === null) return;
      this.offset = [0, 0];
      this.state.set({follow: "track"});
    });
    canvas.addEventListener("wheel", (event) => {
      if (this.state.view !== "above") return;
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * 0.0015), event.offsetX, event.offsetY);
    }, {passive: false});
  }

  zoom(factor, x = this.camera.width / 2, y = this.camera.height / 2) {
    const before = [this.camera.x, this.camera.y];
    this.camera.zoomAt(x, y, factor);
    this.offset[0] += this.camera.x - before[0];
    this.offset[1] += this.camera.y - before[1];
    this.draw();
  }

  /** Selects the track there, else the label, else nothing. */
  pick(px, py) {
    const {state, camera} = this;
    const [x, y] = camera.toWorld(px, py);
    const margin = 5 / camera.scale;
    const holds = (history, i) => {
      const [bx, by] = inBox(history.box(i), x, y);
      return Math.abs(bx) < history.length[i] / 2 + margin &&
             Math.abs(by) < history.width[i] / 2 + margin;
    };
    const distance = (history, i) => Math.hypot(history.x[i] - x, history.y[i] - y);
    const found = state.run.tracksAt(state.frame).filter(({track, i}) => holds(track, i))
        .sort((a, b) => distance(a.track, a.i) - distance(b.track, b.i))[0];
    if (found) return state.selectTrack(found.track.id);
    const object = state.run.objectsAt(state.frame).find(({object, i}) => holds(object, i));
    if (object) return state.selectObject(object.index);
    state.set({track: null, object: null});
  }
}
