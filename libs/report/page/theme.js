// SPDX-License-Identifier: BSD-3-Clause
// Light and dark, and colours for what is drawn.
"use strict";

const themeListeners = [];
const themeColours = new Map();

function setTheme(name) {
  document.documentElement.dataset.theme = name === "dark" ? "dark" : "light";
  themeColours.clear();
  for (const listener of themeListeners) listener();
}

function toggleTheme() {
  setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
}

/** Follows the system until the reader chooses. */
function startTheme() {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  setTheme(dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => setTheme(dark.matches ? "dark" : "light"));
}

/** A colour of the style sheet by name: colour("truth"). */
function colour(name) {
  if (!themeColours.has(name)) {
    const style = getComputedStyle(document.documentElement);
    themeColours.set(name, style.getPropertyValue("--" + name).trim());
  }
  return themeColours.get(name);
}

/** Hues a golden angle apart; keeps its colour over the run. */
function identityColour(id) {
  const light = document.documentElement.dataset.theme === "dark" ? 64 : 38;
  return `hsl(${(id * 137.508) % 360} 75% ${light}%)`;
}

/** "right", "false", "ignored" (on what does not count), by the truth of a frame. */
function judgement(run, track, frame) {
  const matches = run.matches?.[frame];
  if (!matches) return null;
  if (matches.byTrack.has(track.id)) return "right";
  return matches.false.has(track.id) ? "false" : "ignored";
}

/** The colour of a track's box at a frame, by what colours are to say. */
function trackColour(state, track, i) {
  const frame = track.frame[i];
  if (state.colours === "judged" && state.run.matches)
    return colour({right: "good", false: "false", ignored: "ignored"}[
        judgement(state.run, track, frame)]);
  if (state.colours === "vehicle") {
    const p = track.vehicleProbability(i);
    return colour(p === null ? "unknown" : p >= 0.5 ? "vehicle" : "clutter");
  }
  if (state.colours === "status")
    return colour({confirmed: "good", coasting: "false"}[track.status[i]] ?? "ignored");
  return identityColour(track.id);
}

/** Objects that are no vehicle, as far as the colours tell: drawn thin, named only close up. */
function isSubdued(state, track, i) {
  if (state.track === track.id) return false;
  if (state.colours === "judged" && state.run.matches)
    return judgement(state.run, track, track.frame[i]) !== "right";
  const p = state.colours === "vehicle" ? track.vehicleProbability(i) : null;
  return p !== null && p < 0.5;
}

/** What the colours say: [[colour, text]]. */
function legendOf(state) {
  if (state.colours === "judged" && state.run.matches)
    return [[colour("good"), "track on a labelled vehicle"],
            [colour("false"), "track on nothing that is labelled"],
            [colour("ignored"), "track that is not judged: no labels there"],
            [colour("bad"), "labelled vehicle that is missed"],
            [colour("truth"), "label (dashed)"]];
  if (state.colours === "vehicle") {
    const rows = [[colour("vehicle"), "vehicle"], [colour("clutter"), "not a vehicle"]];
    return state.run.hasProbabilities ? rows : [[colour("unknown"), "not told apart in this run"]];
  }
  if (state.colours === "status")
    return [[colour("good"), "measured in this frame"], [colour("false"), "predicted only"]];
  return [[identityColour(1), "each track has a colour of its own"]];
}
