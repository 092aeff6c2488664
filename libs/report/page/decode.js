// SPDX-License-Identifier: BSD-3-Clause
// The page's data: base64, gz, and the hits of a frame.
"use strict";

/** Bytes of an element of the page's data, unpacked. */
async function unpack(id) {
  const text = document.getElementById(id).textContent;
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

const GROUND = 0, OVERHEAD = 1, STRUCTURE = 2;

/** Hits in metres from the frame's origin; groups {kind, track, begin, end}, kind 3: cluster. */
function decodeHits(buffer) {
  const view = new DataView(buffer);
  const groups = [];
  let offset = 4;
  let count = 0;
  for (let g = 0; g < view.getUint32(0, true); ++g, offset += 8) {
    const size = view.getUint32(offset, true);
    groups.push({kind: Math.min(g, 3), track: view.getUint32(offset + 4, true),
                 begin: count, end: count + size});
    count += size;
  }
  const bytes = new Uint8Array(buffer, offset);
  const axis = (plane) => {
    const values = new Float32Array(count);
    const low = plane * count, high = low + count;
    for (let i = 0, sum = 0; i < count; ++i) {
      sum = (sum + bytes[low + i] + (bytes[high + i] << 8)) & 0xffff;
      values[i] = (sum << 16 >> 16) / 100;
    }
    return values;
  };
  return {count, groups, x: axis(0), y: axis(2), z: axis(4)};
}

/** Decoded hits of the frames around the one shown. */
class HitStore {
  constructor(frames, onReady) {
    this.frames = frames;
    this.onReady = onReady;
    this.ready = new Map();
    this.asked = new Set();
  }

  /** Hits of a frame, or null while they are being unpacked; unpacks those ahead as well. */
  at(frame) {
    const ahead = 8, kept = 48;
    for (let f = frame; f < Math.min(frame + ahead, this.frames); ++f) this.ask(f);
    for (const f of this.ready.keys())
      if (this.ready.size > kept && Math.abs(f - frame) > ahead) this.ready.delete(f);
    return this.ready.get(frame) ?? null;
  }

  async ask(frame) {
    if (this.ready.has(frame) || this.asked.has(frame)) return;
    this.asked.add(frame);
    this.ready.set(frame, decodeHits(await unpack("hits" + frame)));
    this.asked.delete(frame);
    this.onReady(frame);
  }
}
