// SPDX-License-Identifier: Apache-2.0
// Names x, y, z for the axes of frames on a cut, the same from piece to piece wherever the field allows it; as src/display/axis_names.cpp
// does for pictures.

import { axes_of, product, type Quaternion } from "../math/frame.ts";

/** Two neighbouring frames. */
export interface FrameLink {
  a: number;
  b: number;
  distance: number;
  width: number;
}

/** Entry k is the name of axis k of a frame: 0 x, 1 y, 2 z. */
export type AxisNames = readonly [number, number, number];

export const kAllNames: AxisNames[] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

// Angle between neighbouring frames at which a path counts as twice its length, as the squared sine of its half: about 10 degrees. Names
// should not pass next to a singular line, where the matching is uncertain.
const kTurn = 0.0076;
// Rounds in which frames take the names that most of their neighbours give them: they straighten seams.
const kRounds = 20;
// What a share must gain to count: more than rounding.
const kGain = 1 + 1e-9;

const number_of = ([x, y]: readonly number[]): number => kAllNames.findIndex((names) => names[0] === x && names[1] === y);
// Names as numbers of kAllNames: what names[n] become where axis k continues as axis kAllNames[axes][k].
const kRenamed: number[][] = kAllNames.map((names) => kAllNames.map((axes) => {
  const out = [0, 0, 0];
  axes.forEach((axis, k) => (out[axis] = names[k]));
  return number_of(out);
}));
const kInverse: number[] = kAllNames.map((axes) => number_of([0, 1, 2].map((k) => axes.indexOf(k))));

/** How the axes of one frame continue in another, and the cosine of half the angle that is left between the two. */
export function matched_axes(from: Quaternion, to: Quaternion): { axes: number; cosine: number } {
  const turn = product([to[0], -to[1], -to[2], -to[3]], from);
  const size = turn.map(Math.abs);
  const order = [0, 1, 2, 3].sort((a, b) => size[b] - size[a]);
  // A turn by nothing or half a turn about an axis, by a quarter or about a diagonal of a side, or by a third.
  const whole = size[order[0]];
  const quarter = (size[order[0]] + size[order[1]]) * Math.SQRT1_2;
  const third = (size[0] + size[1] + size[2] + size[3]) / 2;
  if (whole >= quarter && whole >= third) return { axes: 0, cosine: whole };
  if (quarter >= third) {
    // The axis that stays: of quarter turns that of the turn, of half turns about a diagonal the one across it.
    const [i, j] = [order[0], order[1]].sort();
    const kept = i === 0 ? j : 6 - i - j;
    return { axes: kept === 1 ? 3 : kept === 2 ? 4 : 5, cosine: quarter };
  }
  const odd = turn.filter((part) => part < 0).length % 2 === 1;
  return { axes: odd ? 2 : 1, cosine: third };
}

/** For each frame the number of its names in kAllNames, spread from `start` along paths that are short and turn little. */
export function name_axes(frames: Quaternion[], links: FrameLink[], start: number): Uint8Array {
  const names = new Uint8Array(frames.length);
  if (frames.length === 0) return names;
  const around = neighbours(frames, links);
  const named = new Uint8Array(frames.length);
  const begin = (frame: number): void => {
    if (named[frame]) return;
    names[frame] = names_by_coordinates(frames[frame]);
    spread(frame, around, names, named);
  };
  begin(start);
  for (let frame = 0; frame < frames.length; ++frame) begin(frame);
  for (let round = 0; round < kRounds && straighten(around, names); ++round);
  return names;
}

/** The links across which the names disagree. */
export function seams_of(names: Uint8Array, frames: Quaternion[], links: FrameLink[]): number[] {
  return links.flatMap(({ a, b }, k) => (kRenamed[names[a]][matched_axes(frames[a], frames[b]).axes] === names[b] ? [] : [k]));
}

interface Neighbours {
  begin: Uint32Array;
  to: Uint32Array;
  axes: Uint8Array;
  cost: Float64Array;
  width: Float64Array;
}

function neighbours(frames: Quaternion[], links: FrameLink[]): Neighbours {
  const begin = new Uint32Array(frames.length + 1);
  for (const { a, b } of links) {
    ++begin[a + 1];
    ++begin[b + 1];
  }
  for (let k = 0; k < frames.length; ++k) begin[k + 1] += begin[k];
  const next = begin.slice();
  const all: Neighbours = {
    begin, to: new Uint32Array(2 * links.length), axes: new Uint8Array(2 * links.length), cost: new Float64Array(2 * links.length), width: new Float64Array(2 * links.length),
  };
  for (const { a, b, distance, width } of links) {
    const { axes, cosine } = matched_axes(frames[a], frames[b]);
    const cost = distance * (1 + Math.max(1 - cosine * cosine, 0) / kTurn);
    for (const [from, to, through] of [[a, b, axes], [b, a, kInverse[axes]]]) {
      const place = next[from]++;
      all.to[place] = to;
      all.axes[place] = through;
      all.cost[place] = cost;
      all.width[place] = width;
    }
  }
  return all;
}

function names_by_coordinates(frame: Quaternion): number {
  const axes = axes_of(frame);
  const sums = kAllNames.map((names) => names.reduce((sum, name, k) => sum + Math.abs(axes[k][name]), 0));
  return sums.indexOf(Math.max(...sums));
}

/** Names everything that is linked to `start`, nearest first. */
function spread(start: number, around: Neighbours, names: Uint8Array, named: Uint8Array): void {
  const steps = new Steps();
  steps.push(0, start, names[start]);
  while (steps.size > 0) {
    const { way, frame, given } = steps.pop();
    if (named[frame]) continue;
    named[frame] = 1;
    names[frame] = given;
    for (let k = around.begin[frame]; k < around.begin[frame + 1]; ++k) {
      if (!named[around.to[k]]) steps.push(way + around.cost[k], around.to[k], kRenamed[given][around.axes[k]]);
    }
  }
}

/** Gives each frame the names that its neighbours give it over the largest width; whether any changed. */
function straighten(around: Neighbours, names: Uint8Array): boolean {
  let changed = false;
  const widths = new Float64Array(kAllNames.length);
  for (let frame = 0; frame < names.length; ++frame) {
    widths.fill(0);
    for (let k = around.begin[frame]; k < around.begin[frame + 1]; ++k) {
      widths[kRenamed[names[around.to[k]]][kInverse[around.axes[k]]]] += around.width[k];
    }
    let most = widths[names[frame]] * kGain;
    for (let other = 0; other < kAllNames.length; ++other) {
      if (widths[other] <= most) continue;
      most = widths[other] * kGain;
      names[frame] = other;
      changed = true;
    }
  }
  return changed;
}

/** A heap, the shortest way first; of equal ones the lower frame. */
class Steps {
  private readonly ways: number[] = [];
  private readonly frames: number[] = [];
  private readonly names: number[] = [];

  get size(): number {
    return this.ways.length;
  }

  push(way: number, frame: number, given: number): void {
    let at = this.ways.length;
    this.ways.push(way);
    this.frames.push(frame);
    this.names.push(given);
    while (at > 0) {
      const parent = (at - 1) >> 1;
      if (!this.before(at, parent)) break;
      this.swap(at, parent);
      at = parent;
    }
  }

  pop(): { way: number; frame: number; given: number } {
    const first = { way: this.ways[0], frame: this.frames[0], given: this.names[0] };
    this.swap(0, this.ways.length - 1);
    this.ways.pop();
    this.frames.pop();
    this.names.pop();
    for (let at = 0; ;) {
      let least = at;
      for (const child of [2 * at + 1, 2 * at + 2]) if (child < this.ways.length && this.before(child, least)) least = child;
      if (least === at) return first;
      this.swap(at, least);
      at = least;
    }
  }

  private before(a: number, b: number): boolean {
    return this.ways[a] !== this.ways[b] ? this.ways[a] < this.ways[b] : this.frames[a] < this.frames[b];
  }

  private swap(a: number, b: number): void {
    for (const list of [this.ways, this.frames, this.names]) [list[a], list[b]] = [list[b], list[a]];
  }
}
