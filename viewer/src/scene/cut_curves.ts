// SPDX-License-Identifier: Apache-2.0
// Curves on a cut along the two axes of its frames that run along it, evenly spaced, as src/display/cut_lines.cpp draws them in pictures
// (B. Jobard, W. Lefer, "Creating evenly-spaced streamlines of arbitrary density", 1997).

import type { Quaternion } from "../math/frame.ts";
import type { AxisNames } from "./axis_names.ts";
import { CutAxes } from "./cut_axes.ts";
import type { CutMap } from "./cut_map.ts";
import type { CutPieces } from "./cut_pieces.ts";
import { SpacedPoints } from "./spaced_points.ts";

/** Curves as two coordinates a point; curve k has points starts[k] to starts[k + 1] - 1. */
export interface CutCurves {
  points: Float32Array;
  starts: Uint32Array;
  /** Of the segment that begins at each point, none at the last of a curve: the piece that it begins in, and the axis of the frame there. */
  pieces: Uint32Array;
  axes: Uint8Array;
}

// Numbers of src/display/cut_lines.cpp; lengths are shares of the spacing.
// A curve ends where another along the same axis is nearer than this, and begins no nearer than the other to one.
const kLeast = 0.55;
const kSeed = 0.98;
// Length of a curve within which it is not another one to itself, and its least length unless it runs from side to side.
const kOwnLag = 1.2;
const kShortest = 1;
// A curve ends where its axis leaves the plane so much more steeply than both others; axes closer than that are equally steep.
const kNormalMargin = 0.1;
// Distance of seeds from the outline, across the curve; in walls of less than twice that the seed is in the middle, unless they are
// thinner than the least.
const kFromOutline = 0.25;
const kThinnestWall = 0.12;
const kStep = 0.2;
const kMostSteps = 10_000;
// Halvings in which a curve is led to the boundary: a thousandth of a step.
const kHalvings = 10;
// More squares of the spacing than this nobody tells apart; curves are further apart then.
const kMostSquares = 12_000;

/** One way of a curve from its seed. */
class Way {
  readonly u: number[] = [];
  readonly v: number[] = [];
  readonly du: number[] = [];
  readonly dv: number[] = [];
  readonly pieces: number[] = [];
  readonly axes: number[] = [];
  at_boundary = false;

  push(u: number, v: number, du: number, dv: number, piece: number, axis: number): void {
    this.u.push(u);
    this.v.push(v);
    this.du.push(du);
    this.dv.push(dv);
    this.pieces.push(piece);
    this.axes.push(axis);
  }

  get length(): number {
    return this.u.length;
  }
}

class Tracer {
  private readonly drawn: SpacedPoints;
  private readonly own: SpacedPoints;
  private readonly spacing: number;
  private readonly seeds: number[] = [];
  private readonly points: number[] = [];
  private readonly starts: number[] = [0];
  private readonly pieces: number[] = [];
  private readonly numbers: number[] = [];

  constructor(private readonly axes: CutAxes, private readonly names: AxisNames[], private readonly map: CutMap, wanted: number) {
    const [width, depth] = [0, 1].map((k) => map.high[k] - map.low[k]);
    let spacing = wanted;
    while ((width / spacing + 1) * (depth / spacing + 1) > kMostSquares) spacing *= Math.SQRT2;
    this.spacing = spacing;
    const counts: [number, number] = [Math.ceil(width / spacing) + 1, Math.ceil(depth / spacing) + 1];
    this.drawn = new SpacedPoints(map.low, spacing, ...counts);
    this.own = new SpacedPoints(map.low, spacing, ...counts);
  }

  /** The largest pieces first: they are in the thick of the part. */
  curves(count: number): CutCurves {
    const { places } = this.axes;
    const order = Uint32Array.from({ length: count }, (_, piece) => piece).sort((a, b) => places[3 * b + 2] - places[3 * a + 2] || a - b);
    for (const piece of order) {
      this.try_from(places[3 * piece], places[3 * piece + 1]);
      for (let k = 0; k < this.seeds.length; k += 2) this.try_from(this.seeds[k], this.seeds[k + 1]);
      this.seeds.length = 0;
    }
    return { points: Float32Array.from(this.points), starts: Uint32Array.from(this.starts), pieces: Uint32Array.from(this.pieces), axes: Uint8Array.from(this.numbers) };
  }

  private try_from(u: number, v: number): void {
    const piece = this.map.piece_inside(u, v);
    if (piece < 0) return;
    const { axes } = this;
    const across = axes.across(piece, this.names[piece], kNormalMargin);
    for (let k = 0; k < 3; ++k) {
      if (k === across) continue;
      const at = 9 * piece + 3 * k;
      axes.turn_towards(piece, u, v, axes.values[at], axes.values[at + 1], axes.values[at + 2]);
      const place = this.off_outline(u, v, -axes.v, axes.u);
      if (place && this.drawn.has_room(...place, axes.u, axes.v, kSeed * this.spacing)) this.trace(piece, ...place);
    }
  }

  /** The seed, or the middle of the thin wall that it is in; null where a curve would run next to the outline. */
  private off_outline(u: number, v: number, across_u: number, across_v: number): [number, number] | null {
    const least = kFromOutline * this.spacing;
    const has = (way: number): boolean => this.map.piece_inside(u + way * across_u, v + way * across_v) >= 0;
    if (has(least) && has(-least)) return [u, v];
    if (has(2 * least) || has(-2 * least)) return null;
    const from = this.last_inside(u, v, u + 2 * least * across_u, v + 2 * least * across_v);
    const to = this.last_inside(u, v, u - 2 * least * across_u, v - 2 * least * across_v);
    const wall = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (wall < kThinnestWall * this.spacing || wall > 2 * least) return null;
    return [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  }

  /** Half a curve, in steps by the midpoint rule, up to earlier curves, the other half, itself where it comes round, or the boundary. */
  private half(u: number, v: number, x: number, y: number, z: number, other: Way | null): Way {
    const { axes, map, own } = this;
    const [step, least] = [kStep * this.spacing, kLeast * this.spacing];
    const lag = Math.ceil(kOwnLag / kStep);
    own.clear();
    if (other) for (let k = lag; k < other.length; ++k) own.add(other.u[k], other.v[k], other.du[k], other.dv[k]);
    const way = new Way();
    for (let k = 0; k < kMostSteps; ++k) {
      const piece = map.piece_at(u, v);
      if (piece < 0) break;
      axes.turn_towards(piece, u, v, x, y, z);
      if (axes.excess > kNormalMargin) return way;
      const { axis } = axes;
      const [middle_u, middle_v] = [u + 0.5 * step * axes.u, v + 0.5 * step * axes.v];
      const ahead = map.piece_at(middle_u, middle_v);
      if (ahead >= 0) axes.turn_towards(ahead, middle_u, middle_v, axes.x, axes.y, axes.z);
      if (axes.excess > kNormalMargin) return way;
      const [next_u, next_v] = [u + step * axes.u, v + step * axes.v];
      if (map.piece_inside(next_u, next_v) < 0) {
        const [end_u, end_v] = this.last_inside(u, v, next_u, next_v);
        way.push(end_u, end_v, axes.u, axes.v, piece, axis);
        way.at_boundary = true;
        return way;
      }
      if (!this.drawn.has_room(next_u, next_v, axes.u, axes.v, least) || !own.has_room(next_u, next_v, axes.u, axes.v, least)) return way;
      way.push(next_u, next_v, axes.u, axes.v, piece, axis);
      const passed = way.length - 1 - lag;
      if (passed >= 0) own.add(way.u[passed], way.v[passed], way.du[passed], way.dv[passed]);
      [u, v, x, y, z] = [next_u, next_v, axes.x, axes.y, axes.z];
    }
    way.at_boundary = true;
    return way;
  }

  private last_inside(u: number, v: number, out_u: number, out_v: number): [number, number] {
    for (let k = 0; k < kHalvings; ++k) {
      const [middle_u, middle_v] = [(u + out_u) / 2, (v + out_v) / 2];
      if (this.map.piece_inside(middle_u, middle_v) >= 0) [u, v] = [middle_u, middle_v];
      else [out_u, out_v] = [middle_u, middle_v];
    }
    return [u, v];
  }

  /** Draws the curve along the axis that was found at a point. */
  private trace(piece: number, u: number, v: number): void {
    const { x, y, z, u: du, v: dv, axis } = this.axes;
    const back = this.half(u, v, -x, -y, -z, null);
    const forth = this.half(u, v, x, y, z, back);
    const steps = back.length + forth.length;
    if (steps === 0) return;
    if (steps * kStep < kShortest && !(back.at_boundary && forth.at_boundary)) return;
    const whole = new Way();
    // A segment has the piece and the axis where its half began it.
    for (let k = back.length - 1; k >= 0; --k) whole.push(back.u[k], back.v[k], back.du[k], back.dv[k], back.pieces[k], back.axes[k]);
    whole.push(u, v, du, dv, forth.pieces[0] ?? piece, forth.axes[0] ?? axis);
    for (let k = 0; k < forth.length; ++k) whole.push(forth.u[k], forth.v[k], forth.du[k], forth.dv[k], forth.pieces[k + 1] ?? piece, forth.axes[k + 1] ?? axis);
    for (let k = 0; k < whole.length; ++k) {
      this.drawn.add(whole.u[k], whole.v[k], whole.du[k], whole.dv[k]);
      this.points.push(whole.u[k], whole.v[k]);
      this.pieces.push(whole.pieces[k]);
      this.numbers.push(whole.axes[k]);
    }
    this.starts.push(this.points.length / 2);
    this.add_seeds(whole);
  }

  /** Seeds one spacing to either side, and along the curve for the other axis; not at its ends, where one would run along the boundary. */
  private add_seeds(way: Way): void {
    const every = Math.max(1, Math.round(1 / kStep));
    for (let k = (every >> 1) + 1; k + 1 + (every >> 1) < way.length; k += every) {
      const [aside_u, aside_v] = [-this.spacing * way.dv[k], this.spacing * way.du[k]];
      this.seeds.push(way.u[k], way.v[k], way.u[k] + aside_u, way.v[k] + aside_v, way.u[k] - aside_u, way.v[k] - aside_v);
    }
  }
}

/** Curves so far apart, or further where there would be too many; `names` are those of the pieces' axes. */
export function cut_curves(pieces: CutPieces, names: AxisNames[], map: CutMap, normal: [number, number, number], frame_of: (piece: number) => Quaternion, spacing: number): CutCurves {
  if (pieces.count === 0) return { points: new Float32Array(0), starts: new Uint32Array(1), pieces: new Uint32Array(0), axes: new Uint8Array(0) };
  return new Tracer(new CutAxes(map, pieces, normal, frame_of), names, map, spacing).curves(pieces.count);
}
