// SPDX-License-Identifier: BSD-3-Clause
// What keys do.
"use strict";

function startKeyboard(state, views) {
  const steps = {",": -1, "ArrowLeft": -1, ".": 1, "ArrowRight": 1};
  const choose = (id, by) => {
    const select = document.getElementById(id);
    const next = select.selectedIndex + by;
    select.selectedIndex = id === "speed" ? Math.max(0, Math.min(select.length - 1, next))
                                          : (next + select.length) % select.length;
    select.dispatchEvent(new Event("change"));
  };
  const actions = {
    " ": () => state.set({playing: !state.playing}),
    "Home": () => state.seek(0), "End": () => state.seek(state.run.count - 1),
    "-": () => choose("speed", -1), "+": () => choose("speed", 1), "=": () => choose("speed", 1),
    "c": () => choose("colours", 1), "d": toggleTheme,
    "1": () => state.set({view: "above"}), "2": () => state.set({view: "3d"}),
    "z": () => views.zoom(1.25), "x": () => views.zoom(0.8), "0": () => views.whole(),
    "f": () => { views.map.offset = [0, 0];
                 state.set({follow: state.follow === "track" ? "sensor" : "track"}); },
    "t": () => state.setLayer("truth", !state.layers.truth),
    "n": () => stepMistake(state, 1), "p": () => stepMistake(state, -1),
    "Escape": () => state.set({track: null, object: null}), "?": showHelp,
  };
  addEventListener("keydown", (event) => {
    const onControl = ["SELECT", "INPUT"].includes(event.target.tagName) ||
        (event.key === " " && event.target.tagName === "BUTTON");
    if (event.ctrlKey || event.altKey || event.metaKey || onControl) return;
    if (document.getElementById("help").open) return;
    if (steps[event.key] || actions[event.key]) event.preventDefault();
    if (!steps[event.key]) return actions[event.key]?.();
    state.set({playing: false});
    state.seek(state.frame + steps[event.key] * (event.shiftKey ? 10 : 1));
  });
}

/** The next mistake in the list of those whose kinds are unfolded. */
function stepMistake(state, by) {
  const all = [...document.querySelectorAll("#mistakes details[open] .mistake")];
  if (all.length === 0) return;
  const now = all.findIndex((button) => button.classList.contains("selected"));
  const next = all[(now < 0 ? (by > 0 ? 0 : all.length - 1) : now + by + all.length) % all.length];
  next.click();
  next.scrollIntoView({block: "nearest"});
}
