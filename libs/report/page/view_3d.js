// SPDX-License-Identifier: BSD-3-Clause
// The scene in 3D: points and boxes by WebGL, names on a canvas over it.
"use strict";

const kVertexShader = `
  attribute vec3 place;
  attribute vec4 ink;
  uniform mat4 matrix;
  uniform float size;
  varying vec4 shade;
  void main() {
    gl_Position = matrix * vec4(place, 1.0);
    gl_PointSize = clamp(size / gl_Position.w, 1.5, 6.0);
    shade = ink;
  }`;
const kFragmentShader = `
  precision mediump float;
  varying vec4 shade;
  void main() { gl_FragColor = shade; }`;

class View3D {
  constructor(canvas, overlay, state, store) {
    Object.assign(this, {canvas, overlay, state, store});
    this.yaw = -2.2;
    this.pitch = 0.55;
    this.distance = 45;
    this.gl = canvas.getContext("webgl", {alpha: false, preserveDrawingBuffer: true});
    this.shown = null;
    if (!this.gl) return;
    this.program = programOf(this.gl);
    this.buffer = this.gl.createBuffer();
    this.listen();
  }

  get works() { return Boolean(this.gl); }

  /** `target`: what is looked at, world. */
  draw(target) {
    this.target = target;
    const {gl, canvas, state} = this;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    const aspect = canvas.width / Math.max(1, canvas.height);
    this.matrix = multiplied(perspective(0.9, aspect, 0.5, 600),
                             orbit(this.yaw, this.pitch, this.distance));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(...rgba(colour("scene")));
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.useProgram(this.program);
    gl.uniformMatrix4fv(gl.getUniformLocation(this.program, "matrix"), false, this.matrix);
    gl.uniform1f(gl.getUniformLocation(this.program, "size"), 90 * ratio);
    const scene = sceneOf(state, this.hits(), target);
    this.drawArray(gl.POINTS, scene.points);
    this.drawArray(gl.LINES, scene.lines);
    gl.depthMask(false);
    this.drawArray(gl.TRIANGLES, scene.faces);
    gl.depthMask(true);
    this.drawNames(target);
  }

  hits() {
    const hits = this.store.at(this.state.frame);
    if (hits) this.shown = {hits, origin: this.state.run.frames.origin[this.state.frame]};
    return this.shown;
  }

  drawArray(mode, numbers) {
    const gl = this.gl;
    const place = gl.getAttribLocation(this.program, "place");
    const ink = gl.getAttribLocation(this.program, "ink");
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STREAM_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 28, 0);
    gl.enableVertexAttribArray(ink);
    gl.vertexAttribPointer(ink, 4, gl.FLOAT, false, 28, 12);
    gl.drawArrays(mode, 0, numbers.length / 7);
  }

  /** Pixel of a place in the world, or null where it is behind the eye. */
  pixel(x, y, z) {
    const t = this.target;
    const p = projected(this.matrix, x - t[0], y - t[1], z - t[2]);
    if (p.w <= 0) return null;
    return [(p.x + 1) / 2 * this.overlay.clientWidth, (1 - p.y) / 2 * this.overlay.clientHeight];
  }

  drawNames() {
    const {state} = this;
    const context = contextOf(this.overlay);
    if (!state.layers.labels) return;
    const labels = [];
    for (const {object, index, i} of state.run.objectsAt(state.frame)) {
      if (!state.layers.truth || !state.run.matches[state.frame].missed.has(index)) continue;
      const at = this.pixel(object.x[i], object.y[i], object.z[i] + object.height[i] + 0.3);
      if (at) labels.push({x: at[0], y: at[1], text: `missed: ${nameOfObject(object)}`,
                           colour: colour("bad"), rank: 1});
    }
    for (const {track, i} of state.run.tracksAt(state.frame)) {
      const at = this.pixel(track.x[i], track.y[i], track.z[i] + track.height[i] + 0.3);
      if (!at || isSubdued(state, track, i)) continue;
      labels.push({x: at[0], y: at[1], text: labelOf(state, track, i),
                   colour: trackColour(state, track, i), rank: labelRank(state, track, i)});
    }
    drawLabels(context, labels);
  }

  listen() {
    let pressed = null;
    this.overlay.addEventListener("pointerdown", (event) => {
      pressed = {x: event.offsetX, y: event.offsetY, moved: false};
    });
    this.overlay.addEventListener("pointermove", (event) => {
      if (!pressed || this.state.view !== "3d") return;
      const dx = event.offsetX - pressed.x, dy = event.offsetY - pressed.y;
      if (!pressed.moved && Math.hypot(dx, dy) < 4) return;
      this.yaw -= dx * 0.006;
      this.pitch = Math.max(0.05, Math.min(1.55, this.pitch + dy * 0.006));
      pressed = {x: event.offsetX, y: event.offsetY, moved: true};
      this.draw(this.target);
    });
    this.overlay.addEventListener("pointerup", (event) => {
      if (pressed && !pressed.moved && this.state.view === "3d")
        this.pick(event.offsetX, event.offsetY);
      pressed = null;
    });
    this.overlay.addEventListener("wheel", (event) => {
      if (this.state.view !== "3d") return;
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * 0.0015));
    }, {passive: false});
  }

  zoom(factor) {
    this.distance = Math.max(4, Math.min(250, this.distance / factor));
    this.draw(this.target);
  }

  /** The track whose middle is nearest on the screen, within reach. */
  pick(px, py) {
    const near = this.state.run.tracksAt(this.state.frame).map(({track, i}) => {
      const at = this.pixel(track.x[i], track.y[i], track.z[i] + track.height[i] / 2);
      return {track, gap: at ? Math.hypot(at[0] - px, at[1] - py) : Infinity};
    }).sort((a, b) => a.gap - b.gap)[0];
    if (near && near.gap < 40) this.state.selectTrack(near.track.id);
    else this.state.set({track: null, object: null});
  }
}

function programOf(gl) {
  const program = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, kVertexShader],
                                [gl.FRAGMENT_SHADER, kFragmentShader]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  return program;
}
