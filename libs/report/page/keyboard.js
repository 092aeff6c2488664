// SPDX-License-Identifier: BSD-3-Clause
// Keys, and the page that explains them and the signs.
"use strict";

const kKeys = [
  ["space", "play, pause"], [", .", "a frame back, on (also ← →; with shift ten)"],
  ["- +", "slower, faster"], ["home end", "first, last frame"],
  ["n p", "next, previous mistake"], ["tab", "through the controls"],
  ["1 2", "from above, 3D"], ["z x", "zoom in, out (also the wheel)"],
  ["f", "follow the selected one, the sensor"], ["0", "back to the whole scene"],
  ["c", "what colours say"], ["t", "labels on, off"], ["d", "light, dark"],
  ["esc", "select nothing"], ["?", "this page"],
];

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
    if (steps[event.key])
      state.set({playing: false}), state.seek(state.frame + steps[event.key] * (event.shiftKey ? 10 : 1));
    else actions[event.key]?.();
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

function showHelp() {
  const help = document.getElementById("help");
  help.innerHTML = `<form method="dialog"><button class="close" aria-label="Close">✕</button></form>
    <h2>What is shown</h2>
    <p>A LADAR on a moving vehicle sees its surroundings as points. The tracker groups them, fits a
    box to each object of vehicle size with a matched filter, and follows it: <b>#12</b> is the
    object's number, and stays with it.</p>
    <table>
    <tr><td>▶ in a box</td><td class="left">its front; the line ahead of it is the way of a second</td></tr>
    <tr><td>thick edge</td><td class="left">a face that the sensor sees</td></tr>
    <tr><td>dashed box</td><td class="left">of a track: predicted, not measured in this frame</td></tr>
    <tr><td>violet, dashed</td><td class="left">a label of the truth; red and filled: no track is on it</td></tr>
    <tr><td>ellipse, wedge</td><td class="left">1-sigma uncertainty of the centre and of the heading</td></tr>
    <tr><td>thin line behind</td><td class="left">the way of the last 4 s; of the selected one, all of it</td></tr>
    </table>
    <h2>Keys</h2><table>${kKeys.map(([key, text]) => `<tr><td>${key.split(" ")
        .map((k) => `<kbd>${k}</kbd>`).join(" ")}</td><td class="left">${text}</td></tr>`)
        .join("")}</table>
    <p class="soft">Drag moves the scene (turns it in 3D), the wheel zooms, a click selects, a double
    click follows. The address keeps time and selection: copy it to show others.</p>`;
  help.showModal();
}
