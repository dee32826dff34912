// SPDX-License-Identifier: Apache-2.0
// A cut flattened to two coordinates: which piece is at a point of it, and whether that is in the part.

import { dot, tangents_of, type Vector } from "../math/frame.ts";
import { Bins } from "./bins.ts";
import type { CutPieces } from "./cut_pieces.ts";

export function flattened(points: Float32Array, first: Vector, second: Vector): Float32Array {
  const flat = new Float32Array((2 * points.length) / 3);
  for (let k = 0; k < flat.length / 2; ++k) {
    const [x, y, z] = [points[3 * k], points[3 * k + 1], points[3 * k + 2]];
    flat[2 * k] = first[0] * x + first[1] * y + first[2] * z;
    flat[2 * k + 1] = second[0] * x + second[1] * y + second[2] * z;
  }
  return flat;
}

/** Whether a convex polygon, in either sense, holds a point; one without area holds none. */
export function holds(flat: Float32Array, begin: number, end: number, u: number, v: number): boolean {
  let sense = 0;
  for (let k = begin; k < end; ++k) {
    const next = k + 1 < end ? k + 1 : begin;
    const turn = (flat[2 * next] - flat[2 * k]) * (v - flat[2 * k + 1]) - (flat[2 * next + 1] - flat[2 * k + 1]) * (u - flat[2 * k]);
    if (turn === 0) continue;
    if (sense !== 0 && turn > 0 !== sense > 0) return false;
    sense = turn;
  }
  return sense !== 0;
}

// Squares of the raster for each piece, and rows for each segment of the outline.
const kSquaresPerPiece = 2;
const kRowsPerSegment = 0.5;
const kMostRows = 4096;

export class CutMap {
  readonly first: Vector;
  readonly second: Vector;
  /** Corners of the pieces. */
  readonly flat: Float32Array;
  readonly low: Vector;
  readonly high: Vector;
  private readonly height: number;
  private readonly square: number;
  private readonly columns: number;
  private readonly rows: number;
  private readonly pieces_in: Bins;
  private readonly edges: Float32Array | null;
  private readonly edge_rows: Bins | null;
  private readonly edge_row_count: number;

  /** `outline` is that of the surface where it is closed; without one the pieces alone say what is inside. */
  constructor(private readonly pieces: CutPieces, outline: Float32Array | null, private readonly normal: Vector) {
    [this.first, this.second] = tangents_of(normal);
    this.flat = flattened(pieces.corners, this.first, this.second);
    this.height = dot(normal, [pieces.corners[0], pieces.corners[1], pieces.corners[2]]);
    this.low = [Infinity, Infinity, this.height];
    this.high = [-Infinity, -Infinity, this.height];
    for (let k = 0; k < this.flat.length; ++k) {
      this.low[k & 1] = Math.min(this.low[k & 1], this.flat[k]);
      this.high[k & 1] = Math.max(this.high[k & 1], this.flat[k]);
    }
    const [width, depth] = [0, 1].map((k) => Math.max(this.high[k] - this.low[k], 1e-30));
    this.square = Math.sqrt((width * depth) / (kSquaresPerPiece * Math.max(1, pieces.count)));
    this.columns = 1 + Math.floor(width / this.square);
    this.rows = 1 + Math.floor(depth / this.square);
    this.pieces_in = new Bins(this.columns * this.rows, (add) => this.bin_pieces(add));
    this.edges = outline ? flattened(outline, this.first, this.second) : null;
    this.edge_row_count = outline ? Math.min(kMostRows, Math.max(1, Math.round((outline.length / 6) * kRowsPerSegment))) : 1;
    this.edge_rows = this.edges ? new Bins(this.edge_row_count, (add) => this.bin_edges(this.edges!, add)) : null;
  }

  private column_of(u: number): number {
    return Math.min(this.columns - 1, Math.max(0, Math.floor((u - this.low[0]) / this.square)));
  }

  private row_of(v: number): number {
    return Math.min(this.rows - 1, Math.max(0, Math.floor((v - this.low[1]) / this.square)));
  }

  private edge_row_of(v: number): number {
    const share = (v - this.low[1]) / (this.high[1] - this.low[1] || 1);
    return Math.min(this.edge_row_count - 1, Math.max(0, Math.floor(share * this.edge_row_count)));
  }

  private bin_pieces(add: (bin: number, piece: number) => void): void {
    for (let piece = 0; piece < this.pieces.count; ++piece) {
      let [left, right, below, above] = [Infinity, -Infinity, Infinity, -Infinity];
      for (let k = this.pieces.starts[piece]; k < this.pieces.starts[piece + 1]; ++k) {
        const [u, v] = [this.flat[2 * k], this.flat[2 * k + 1]];
        if (u < left) left = u;
        if (u > right) right = u;
        if (v < below) below = v;
        if (v > above) above = v;
      }
      const [from, to, last] = [this.column_of(left), this.column_of(right), this.row_of(above)];
      for (let row = this.row_of(below); row <= last; ++row) for (let column = from; column <= to; ++column) add(row * this.columns + column, piece);
    }
  }

  private bin_edges(edges: Float32Array, add: (bin: number, edge: number) => void): void {
    for (let edge = 0; edge < edges.length / 4; ++edge) {
      const [a, b] = [this.edge_row_of(edges[4 * edge + 1]), this.edge_row_of(edges[4 * edge + 3])];
      for (let row = Math.min(a, b); row <= Math.max(a, b); ++row) add(row, edge);
    }
  }

  /** The piece at a point, or -1. */
  piece_at(u: number, v: number): number {
    if (!(u >= this.low[0] && u <= this.high[0] && v >= this.low[1] && v <= this.high[1])) return -1;
    const bin = this.row_of(v) * this.columns + this.column_of(u);
    for (let k = this.pieces_in.first(bin); k < this.pieces_in.last(bin); ++k) {
      const piece = this.pieces_in.items[k];
      if (holds(this.flat, this.pieces.starts[piece], this.pieces.starts[piece + 1], u, v)) return piece;
    }
    return -1;
  }

  /** Whether the outline, if there is one, goes around a point. */
  is_enclosed(u: number, v: number): boolean {
    if (!this.edges || !this.edge_rows) return true;
    const row = this.edge_row_of(v);
    let inside = false;
    for (let k = this.edge_rows.first(row); k < this.edge_rows.last(row); ++k) {
      const at = 4 * this.edge_rows.items[k];
      const [from, to] = [this.edges[at + 1], this.edges[at + 3]];
      if (from > v === to > v) continue;
      if (this.edges[at] + ((v - from) / (to - from)) * (this.edges[at + 2] - this.edges[at]) > u) inside = !inside;
    }
    return inside;
  }

  /** The piece at a point that is in the part, or -1. */
  piece_inside(u: number, v: number): number {
    const piece = this.piece_at(u, v);
    return piece >= 0 && this.is_enclosed(u, v) ? piece : -1;
  }

  flat_of(point: Vector): [number, number] {
    return [dot(this.first, point), dot(this.second, point)];
  }

  /** The point of the cut with these coordinates. */
  point_at(u: number, v: number): Vector {
    return [0, 1, 2].map((k) => u * this.first[k] + v * this.second[k] + this.height * this.normal[k]) as Vector;
  }
}
