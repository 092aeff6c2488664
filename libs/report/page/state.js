// SPDX-License-Identifier: BSD-3-Clause
// What is shown: time, selection, settings. Whoever draws listens.
"use strict";

class State {
  constructor(run) {
    this.run = run;
    this.frame = 0;
    this.playing = false;
    this.speed = 1;
    this.track = null;   // id of the selected one
    this.object = null;  // index of the selected one
    this.view = "above";
    this.follow = "sensor";
    this.colours = run.truth ? "judged" : run.hasProbabilities ? "vehicle" : "identity";
    this.layers = {hits: true, ground: true, overhead: false, clusters: false, boxes: true,
                   faces: true, sigma: true, trails: true, rays: false,
                   truth: run.truth !== null, labels: true, filter: true};
    this.listeners = [];
  }

  /** Called with the names of what changed. */
  onChange(listener) { this.listeners.push(listener); }

  set(changes) {
    const changed = Object.keys(changes).filter((key) => this[key] !== changes[key]);
    if (changed.length === 0) return;
    Object.assign(this, changes);
    for (const listener of this.listeners) listener(new Set(changed));
  }

  setLayer(name, shown) { this.set({layers: {...this.layers, [name]: shown}}); }

  seek(frame) { this.set({frame: Math.max(0, Math.min(this.run.count - 1, Math.round(frame)))}); }

  selectTrack(id) {
    const object = this.run.byId.get(id)?.follows[0]?.object;
    this.set({track: id, object: object ? this.run.objects.indexOf(object) : null});
  }

  /** Selects an object and, where there is one at the frame, the track on it. */
  selectObject(index) {
    const pair = this.run.matches?.[this.frame].byObject.get(index);
    this.set({track: pair ? pair.track : null, object: index});
  }

  /** Where the selected one is, or null. */
  selectedPlace() {
    for (const history of [this.run.byId.get(this.track), this.run.objects[this.object]]) {
      const i = history ? history.at(this.frame) : -1;
      if (i >= 0) return [history.x[i], history.y[i], history.z[i]];
    }
    return null;
  }
}

/** Of pauses of the recording, s: longer ones are jumped over. */
const kLongestWait = 2;

/** Moves the time on while playing. */
function playOn(state) {
  const run = state.run;
  const end = run.count - 1;
  let last = null;  // when the picture before was drawn, ms; null: at rest
  let time = 0;     // of the run, s
  const tick = (now) => {
    if (!state.playing) {
      last = null;
      return;
    }
    requestAnimationFrame(tick);
    const wasMoved = run.frameAt(time) !== state.frame;  // by hand
    time = last === null || wasMoved ? run.times[state.frame]
                                     : time + (now - last) / 1000 * state.speed;
    last = now;
    const next = run.times[state.frame + 1];  // undefined at the end
    if (next - time > kLongestWait) time = next;
    if (time >= run.times[end]) state.set({frame: end, playing: false});
    else state.seek(run.frameAt(time));
  };
  state.onChange((changed) => {
    if (!changed.has("playing") || !state.playing || last !== null) return;
    if (state.frame === end) state.seek(0);
    last = null;
    requestAnimationFrame(tick);
  });
}

/** The address says what is shown, so that it can be sent to others: #t=3.1&track=12. */
function keepInAddress(state) {
  const read = () => {
    const words = new URLSearchParams(location.hash.slice(1));
    if (words.has("t")) state.seek(state.run.frameAt(Number(words.get("t")) || 0));
    if (words.has("frame")) state.seek(Number(words.get("frame")) || 0);
    if (words.has("track")) state.selectTrack(Number(words.get("track")));
    if (words.has("view")) state.set({view: words.get("view") === "3d" ? "3d" : "above"});
    if (words.has("colours")) state.set({colours: words.get("colours")});
    if (words.has("follow")) state.set({follow: words.get("follow")});
    if (words.has("theme")) setTheme(words.get("theme"));
  };
  const write = () => {
    const words = new URLSearchParams({t: state.run.times[state.frame].toFixed(3)});
    if (state.track !== null) words.set("track", state.track);
    if (state.view === "3d") words.set("view", "3d");
    history.replaceState(null, "", "#" + words);
  };
  read();
  addEventListener("hashchange", read);
  state.onChange((changed) => {
    if (!state.playing && ["frame", "track", "view", "playing"].some((k) => changed.has(k)))
      write();
  });
}
