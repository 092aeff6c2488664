// SPDX-License-Identifier: BSD-3-Clause
// The overlay that explains signs and keys.
"use strict";

const kSigns = [
  ["#12", "the number of an object that is tracked; it stays with it"],
  ["▶ in a box", "its front; the line ahead of it is the way of a second"],
  ["thick edge", "a face that the sensor sees"],
  ["dashed box", "of a track: predicted, not measured in this frame"],
  ["violet, dashed", "a label of the truth; red and filled: no track is on it"],
  ["ellipse, wedge", "1-sigma uncertainty of the centre and of the heading"],
  ["thin line behind", "the way of the last 4 s; of the selected one, all of it"],
];

const kKeys = [
  ["space", "play, pause"], [", .", "a frame back, on (also ← →; with shift ten)"],
  ["- +", "slower, faster"], ["home end", "first, last frame"],
  ["n p", "next, previous mistake"], ["tab", "through the controls"],
  ["1 2", "from above, 3D"], ["z x", "zoom in, out (also the wheel)"],
  ["f", "follow the selected one, the sensor"], ["0", "back to the whole scene"],
  ["c", "what colours say"], ["t", "labels on, off"], ["d", "light, dark"],
  ["esc", "select nothing"], ["?", "this page"],
];

function showHelp() {
  const table = (rows, left) => `<table>${rows.map(([name, text]) =>
      `<tr><td>${left(name)}</td><td class="left">${text}</td></tr>`).join("")}</table>`;
  const asKeys = (names) => names.split(" ").map((name) => `<kbd>${name}</kbd>`).join(" ");
  const help = document.getElementById("help");
  help.innerHTML = `
    <form method="dialog"><button class="close" aria-label="Close">✕</button></form>
    <h2>What is shown</h2>
    <p>A LADAR on a moving vehicle sees its surroundings as points. The tracker groups them, fits
    a box to each object of vehicle size with a matched filter, and follows it.</p>
    ${table(kSigns, (sign) => sign)}
    <h2>Keys</h2>
    ${table(kKeys, asKeys)}
    <p class="soft">Drag moves the scene (turns it in 3D), the wheel zooms, a click selects, a
    double click follows. The address keeps time and selection: copy it to show others.</p>`;
  help.showModal();
}
