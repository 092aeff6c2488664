// SPDX-License-Identifier: BSD-3-Clause
// Puts the page together.
"use strict";

/** The two views and what moves them. */
class Views {
  constructor(state) {
    this.state = state;
    this.dirty = false;
    this.store = new HitStore(state.run.count, (frame) => {
      if (frame === state.frame) this.ask();
    });
    this.map = new MapView(document.getElementById("map"), state, this.store);
    this.space = null;  // made when first asked for
    state.onChange((changed) => {
      if (changed.has("follow")) this.map.offset = [0, 0];
      if (changed.has("centre")) this.map.centreOn(state.centre.place, state.centre.close);
      if (changed.has("view")) this.showView();
      this.ask();
    });
    themeListeners.push(() => this.ask());
    addEventListener("resize", () => this.ask());
    this.showView();
  }

  /** Draws once before the next picture, however often it is asked for. */
  ask() {
    if (this.dirty) return;
    this.dirty = true;
    requestAnimationFrame(() => { this.dirty = false; this.draw(); });
  }

  showView() {
    const is3d = this.state.view === "3d";
    if (is3d) this.space ??= new View3D(document.getElementById("gl"), this.map.canvas,
                                        this.state, this.store);
    document.getElementById("gl").hidden = !is3d;
    const note = document.getElementById("note");
    note.hidden = !is3d || this.space.works;
    note.textContent = "This browser does not offer WebGL, which the 3D view needs.";
    document.getElementById("view-3d").setAttribute("aria-pressed", is3d);
    document.getElementById("view-above").setAttribute("aria-pressed", !is3d);
    this.ask();
  }

  draw() {
    if (this.state.view === "3d" && this.space.works) {
      const anchor = this.map.anchor();
      this.map.anchorKept = anchor;
      const low = this.state.run.sensorAt(this.state.frame)[2] - kUsualSensorHeight + 0.5;
      this.space.draw([anchor[0] + this.map.offset[0], anchor[1] + this.map.offset[1], low]);
    } else {
      this.map.draw();
    }
    this.onDrawn?.();
  }

  zoom(factor) {
    if (this.state.view === "3d") this.space.zoom(factor); else this.map.zoom(factor);
  }

  whole() {
    this.map.offset = [0, 0];
    this.map.camera.scale = Math.max(3, this.map.canvas.clientWidth / 110);
    this.state.set({follow: "sensor"});
    this.ask();
  }
}

function startControls(state) {
  const on = (id, event, action) => document.getElementById(id).addEventListener(event, action);
  on("play", "click", () => state.set({playing: !state.playing}));
  on("step", "click", () => { state.set({playing: false}); state.seek(state.frame + 1); });
  on("step-back", "click", () => { state.set({playing: false}); state.seek(state.frame - 1); });
  on("theme", "click", toggleTheme);
  on("help-button", "click", showHelp);
  on("view-above", "click", () => state.set({view: "above"}));
  on("view-3d", "click", () => state.set({view: "3d"}));
  for (const id of ["speed", "colours", "follow"])
    on(id, "change", (event) => state.set({
      [id]: id === "speed" ? Number(event.target.value) : event.target.value}));
  const show = () => {
    document.getElementById("play").textContent = state.playing ? "❚❚" : "▶\uFE0E";
    for (const id of ["colours", "follow"]) document.getElementById(id).value = state[id];
    document.getElementById("legend").innerHTML = legendOf(state)
        .map(([ink, text]) => `<div><i style="border-color:${ink}"></i>${text}</div>`).join("");
  };
  state.onChange(show);
  themeListeners.push(show);
  if (!state.run.truth) document.querySelector("#colours [value=judged]").remove();
  if (!state.run.hasProbabilities) document.querySelector("#colours [value=vehicle]").remove();
  show();
}

const kLayers = {hits: "LADAR hits", ground: "Ground", overhead: "Overhead",
                 clusters: "A colour for each cluster", boxes: "Boxes", faces: "Faces seen",
                 sigma: "Uncertainty", trails: "Trails", rays: "Rays to the sensor",
                 truth: "Truth", labels: "Names", filter: "Filter in the close-up"};

function startLayers(state) {
  const popup = document.getElementById("layers");
  document.getElementById("layers-button").addEventListener("click", () => {
    popup.hidden = !popup.hidden;
  });
  for (const [name, text] of Object.entries(kLayers)) {
    const label = document.createElement("label");
    const box = document.createElement("input");
    box.type = "checkbox";
    box.checked = state.layers[name];
    box.addEventListener("change", () => state.setLayer(name, box.checked));
    state.onChange(() => { box.checked = state.layers[name]; });
    label.append(box, " " + text);
    popup.append(label);
  }
}

function startTabs() {
  const show = (name) => {
    for (const tab of document.querySelectorAll("[data-tab]")) {
      tab.setAttribute("aria-selected", tab.dataset.tab === name);
      document.getElementById(tab.dataset.tab).hidden = tab.dataset.tab !== name;
    }
  };
  for (const tab of document.querySelectorAll("[data-tab]"))
    tab.addEventListener("click", () => show(tab.dataset.tab));
  return show;
}

async function start() {
  startTheme();
  const loading = document.getElementById("loading");
  if (!("DecompressionStream" in window)) {
    loading.textContent = "This browser is too old for this page: it cannot unpack its data " +
        "(DecompressionStream; Chrome 80, Firefox 113, Safari 16.4 can).";
    return;
  }
  const data = new TextDecoder().decode(await unpack("run"));
  const run = new Run(JSON.parse(data));
  const state = new State(run);
  state.seek(run.firstTelling());
  document.getElementById("title").textContent = run.facts.title;
  document.getElementById("subtitle").textContent =
      `${run.count} frames, ${run.times[run.count - 1].toFixed(1)} s, ${
          run.tracks.filter((t) => t.wasPublished).length} objects`;
  const views = new Views(state);
  startControls(state);
  startLayers(state);
  startTimeLine(state);
  fillTracks(document.getElementById("tracks"), state);
  fillMistakes(document.getElementById("mistakes"), state);
  fillSummary(document.getElementById("summary"), state);
  startTabs()("tracks");
  views.onDrawn = startDetails(document.getElementById("details"), state, views.store);
  startKeyboard(state, views);
  playOn(state);
  keepInAddress(state);
  loading.hidden = true;
  // For tests and the curious.
  window.report = {state, views, run};
}

addEventListener("DOMContentLoaded", () => start().catch((error) => {
  document.getElementById("loading").textContent = `The run cannot be shown: ${error.message}`;
  throw error;
}));
