// SPDX-License-Identifier: Apache-2.0
// The axes of a field at the points of a cut, from the frames around.

import { axes_of, dot, type Quaternion } from "../math/frame.ts";
import type { AxisNames } from "./axis_names.ts";
import type { CutMap } from "./cut_map.ts";
import type { CutPieces } from "./cut_pieces.ts";

// Reach of a piece's frame, as a multiple of its size: curves turn smoothly from piece to piece.
const kReach = 1.5;

/** Coordinates are those of the cut: two along it, one across. */
export class CutAxes {
  /** Nine numbers a piece. */
  readonly values: Float64Array;
  /** Middle and reach, three numbers a piece. */
  readonly places: Float64Array;
  private readonly begin: Uint32Array;
  private readonly around: Uint32Array;
  /** What `turn_towards` has found: the axis in space, its unit direction along the cut, how much more steeply it leaves it, its number. */
  x = 0;
  y = 0;
  z = 0;
  u = 0;
  v = 0;
  excess = 0;
  axis = 0;

  constructor(readonly map: CutMap, pieces: CutPieces, normal: [number, number, number], frame_of: (piece: number) => Quaternion) {
    const { count, starts, side_pieces } = pieces;
    this.values = new Float64Array(9 * count);
    this.places = new Float64Array(3 * count);
    for (let piece = 0; piece < count; ++piece) {
      axes_of(frame_of(piece)).forEach((axis, k) => {
        this.values[9 * piece + 3 * k] = dot(axis, map.first);
        this.values[9 * piece + 3 * k + 1] = dot(axis, map.second);
        this.values[9 * piece + 3 * k + 2] = dot(axis, normal);
      });
      let [u, v, twice] = [0, 0, 0];
      const size = starts[piece + 1] - starts[piece];
      for (let k = starts[piece]; k < starts[piece + 1]; ++k) {
        const next = k + 1 < starts[piece + 1] ? k + 1 : starts[piece];
        u += map.flat[2 * k] / size;
        v += map.flat[2 * k + 1] / size;
        twice += map.flat[2 * k] * map.flat[2 * next + 1] - map.flat[2 * k + 1] * map.flat[2 * next];
      }
      this.places.set([u, v, kReach * Math.sqrt(Math.abs(twice) / 2)], 3 * piece);
    }
    this.begin = new Uint32Array(count + 1);
    for (const piece of side_pieces) ++this.begin[piece + 1];
    for (let k = 0; k < count; ++k) this.begin[k + 1] += this.begin[k];
    this.around = new Uint32Array(side_pieces.length);
    const next = this.begin.slice();
    for (let k = 0; k < side_pieces.length; ++k) this.around[next[side_pieces[k]]++] = side_pieces[k ^ 1];
  }

  private nearest(piece: number, x: number, y: number, z: number): number {
    let best = 0;
    let most = -1;
    for (let k = 0; k < 3; ++k) {
      const at = 9 * piece + 3 * k;
      const along = Math.abs(this.values[at] * x + this.values[at + 1] * y + this.values[at + 2] * z);
      if (along > most) [best, most] = [k, along];
    }
    return best;
  }

  private add(piece: number, axis: number, u: number, v: number, x: number, y: number, z: number): void {
    const [off_u, off_v, reach] = [u - this.places[3 * piece], v - this.places[3 * piece + 1], this.places[3 * piece + 2]];
    const far = (off_u * off_u + off_v * off_v) / (reach * reach);
    if (!(far < 1)) return;
    const at = 9 * piece + 3 * axis;
    const [a, b, c] = [this.values[at], this.values[at + 1], this.values[at + 2]];
    const weight = (a * x + b * y + c * z < 0 ? -1 : 1) * (1 - far) ** 2;
    this.x += weight * a;
    this.y += weight * b;
    this.z += weight * c;
  }

  /** Finds the axis at a point of a piece that is nearest to a direction, from the frames around. */
  turn_towards(piece: number, u: number, v: number, x: number, y: number, z: number): void {
    const own = this.nearest(piece, x, y, z);
    const at = 9 * piece + 3 * own;
    let [lead_x, lead_y, lead_z] = [this.values[at], this.values[at + 1], this.values[at + 2]];
    if (lead_x * x + lead_y * y + lead_z * z < 0) [lead_x, lead_y, lead_z] = [-lead_x, -lead_y, -lead_z];
    this.x = this.y = this.z = 0;
    this.add(piece, own, u, v, lead_x, lead_y, lead_z);
    for (let k = this.begin[piece]; k < this.begin[piece + 1]; ++k) {
      const other = this.around[k];
      this.add(other, this.nearest(other, lead_x, lead_y, lead_z), u, v, lead_x, lead_y, lead_z);
    }
    const length = Math.sqrt(this.x * this.x + this.y * this.y + this.z * this.z);
    if (length > 0) [this.x, this.y, this.z] = [this.x / length, this.y / length, this.z / length];
    else [this.x, this.y, this.z] = [lead_x, lead_y, lead_z];
    const along = Math.sqrt(this.x * this.x + this.y * this.y) || 1;
    this.u = this.x / along;
    this.v = this.y / along;
    this.axis = own;
    this.excess = this.steepness(piece, own) - Math.max(this.steepness(piece, (own + 1) % 3), this.steepness(piece, (own + 2) % 3));
  }

  private steepness(piece: number, axis: number): number {
    return Math.abs(this.values[9 * piece + 3 * axis + 2]);
  }

  /** The steepest axis of a piece, along which no curve begins; of those about equally steep the one with the last name. */
  across(piece: number, names: AxisNames, margin: number): number {
    const most = Math.max(...[0, 1, 2].map((axis) => this.steepness(piece, axis)));
    const steep = [0, 1, 2].filter((axis) => this.steepness(piece, axis) > most - margin);
    return steep.reduce((last, axis) => (names[axis] > names[last] ? axis : last));
  }
}
