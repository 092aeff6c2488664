// SPDX-License-Identifier: BSD-3-Clause
// The run: frames, tracks, truth, and who is who.
"use strict";

/** Arrays over the frames in which a track or an object is there. */
class Life {
  constructor(columns) {
    Object.assign(this, columns);
    this.index = new Map(columns.frame.map((frame, i) => [frame, i]));
  }

  /** Index into the arrays at a frame, or -1. */
  at(frame) { return this.index.get(frame) ?? -1; }
  get first() { return this.frame[0]; }
  get last() { return this.frame[this.frame.length - 1]; }

  box(i) {
    return {x: this.x[i], y: this.y[i], heading: this.heading[i], length: this.length[i],
            width: this.width[i], z: this.z[i], height: this.height[i]};
  }
}

class Track extends Life {
  isPublished(i) { return this.status[i] === "confirmed" || this.status[i] === "coasting"; }
  get wasPublished() { return this.status.some((_, i) => this.isPublished(i)); }

  measuredBox(i) {
    const m = this.measured[i];
    return m && {x: m[0], y: m[1], heading: m[2], length: m[3], width: m[4], z: this.z[i],
                 height: this.height[i]};
  }

  /** The last probability known up to there, or null. */
  vehicleProbability(i) {
    while (i >= 0 && this.probability[i] === null) --i;
    return i >= 0 ? this.probability[i] : null;
  }
}

class Run {
  constructor(data) {
    this.facts = data.facts;
    this.filter = data.filter;
    this.frames = data.frames;
    this.times = data.frames.time;
    this.count = this.times.length;
    this.tracks = data.tracks.map((columns) => new Track(columns));
    this.byId = new Map(this.tracks.map((track) => [track.id, track]));
    this.objects = data.truth ? data.truth.objects.map((columns) => new Life(columns)) : [];
    this.truth = data.truth;
    this.matches = data.truth ? data.truth.matches.map(readMatches) : null;
    this.hasProbabilities =
        this.tracks.some((track) => track.probability.some((p) => p !== null));
    for (const track of this.tracks) track.follows = this.objectsOf(track);
    this.tracksByFrame = this.times.map(() => []);
    this.objectsByFrame = this.times.map(() => []);
    for (const track of this.tracks)
      track.frame.forEach((frame, i) => {
        if (track.isPublished(i)) this.tracksByFrame[frame].push({track, i});
      });
    this.objects.forEach((object, index) => object.frame.forEach(
        (frame, i) => this.objectsByFrame[frame].push({object, index, i})));
  }

  /** Published tracks of a frame: [{track, i}]. */
  tracksAt(frame) { return this.tracksByFrame[frame]; }

  /** Labels of a frame: [{object, index, i}]. */
  objectsAt(frame) { return this.objectsByFrame[frame]; }

  /** Objects that a track was on: [{object, frames}], the one with most frames first. */
  objectsOf(track) {
    const frames = new Map();
    for (const frame of this.matches ? track.frame : []) {
      const pair = this.matches[frame].byTrack.get(track.id);
      if (pair) frames.set(pair.object, (frames.get(pair.object) ?? 0) + 1);
    }
    return [...frames].map(([object, count]) => ({object: this.objects[object], count}))
        .sort((a, b) => b.count - a.count);
  }

  /** A frame that shows something: in the first ones tracks are not believed yet. */
  firstTelling() {
    const counts = this.tracksByFrame.map((tracks) => tracks.length);
    return Math.max(0, counts.findIndex((count) => count > 0.6 * medianOf(counts)));
  }

  sensorAt(frame) { return this.frames.sensor[frame]; }

  /** The frame shown at a time: the last one that is not later. */
  frameAt(time) {
    let low = 0, high = this.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= time + 1e-6) low = middle; else high = middle - 1;
    }
    return low;
  }
}

function readMatches(frame) {
  const pairs = frame.pairs.map(([object, track, overlap]) => ({object, track, overlap}));
  return {byTrack: new Map(pairs.map((pair) => [pair.track, pair])),
          byObject: new Map(pairs.map((pair) => [pair.object, pair])),
          missed: new Set(frame.missed), false: new Set(frame.false)};
}

function medianOf(values) { return [...values].sort((a, b) => a - b)[values.length >> 1]; }

/** Of those that are known; null where none is. */
function meanOf(values) {
  const known = values.filter((v) => v !== null);
  return known.length ? known.reduce((a, b) => a + b, 0) / known.length : null;
}
