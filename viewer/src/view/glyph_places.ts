// SPDX-License-Identifier: Apache-2.0
// Where to draw frames on a cut: at the points of a raster that lie in the part, and in the middle of walls that pass between them.

import type { Vector } from "../math/frame.ts";
import { flattened, holds, type CutMap } from "../scene/cut_map.ts";
import type { CutPieces } from "../scene/cut_pieces.ts";

export interface GlyphPlace {
  piece: number;
  point: Vector;
}

// More points than this nobody tells apart; the raster becomes coarser.
const kMostPoints = 20_000;
// Frames in the middle of walls keep this distance to others, as a share of the raster.
const kApart = 0.75;

/** `outline` is that of the surface where it is closed, null where pieces alone say what is inside. */
export function glyph_places(pieces: CutPieces, map: CutMap, outline: Float32Array | null, spacing: number): GlyphPlace[] {
  if (pieces.count === 0) return [];
  const raster = new Raster(map.flat, spacing);
  if (outline) raster.keep_inside(flattened(outline, map.first, map.second));
  return raster.pieces_at(pieces, map.flat).map(({ piece, u, v }) => ({ piece, point: map.point_at(u, v) }));
}

class Raster {
  private readonly low: [number, number];
  private readonly counts: [number, number];
  private readonly spacing: number;
  private readonly inside: Uint8Array;
  /** Middles of walls that the raster misses. */
  private readonly extra: number[] = [];

  constructor(flat: Float32Array, wanted: number) {
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    for (let k = 0; k < flat.length; ++k) {
      low[k & 1] = Math.min(low[k & 1], flat[k]);
      high[k & 1] = Math.max(high[k & 1], flat[k]);
    }
    let spacing = wanted;
    while (((high[0] - low[0]) / spacing + 1) * ((high[1] - low[1]) / spacing + 1) > kMostPoints) spacing *= Math.SQRT2;
    this.spacing = spacing;
    // Half a step from multiples of the spacing: symmetric about the middle of the part, and still where it was if the cut moves.
    this.low = low.map((value) => (Math.floor(value / spacing) + 0.5) * spacing) as [number, number];
    this.counts = [0, 1].map((k) => Math.max(1, Math.ceil((high[k] - this.low[k]) / spacing))) as [number, number];
    this.inside = new Uint8Array(this.counts[0] * this.counts[1]).fill(1);
  }

  private index_of(column: number, row: number): number {
    return row * this.counts[0] + column;
  }

  /** Keeps what an even number of crossings of the outline does not lie before, along rows; and looks for walls along rows and columns. */
  keep_inside(outline: Float32Array): void {
    this.inside.fill(0);
    for (const across of [0, 1] as const) {
      const lines = this.crossings(outline, across);
      lines.forEach((places, line) => {
        places.sort((a, b) => a - b);
        for (let k = 0; k + 1 < places.length; k += 2) {
          const [from, to] = [0, 1].map((end) => (places[k + end] - this.low[across]) / this.spacing);
          const [begin, end] = [Math.max(0, Math.ceil(from)), Math.min(this.counts[across] - 1, Math.floor(to))];
          if (across === 0) for (let column = begin; column <= end; ++column) this.inside[this.index_of(column, line)] = 1;
          if (begin > end && to > from) {
            const middle = this.low[across] + ((from + to) / 2) * this.spacing;
            const other = this.low[1 - across] + line * this.spacing;
            this.extra.push(...(across === 0 ? [middle, other] : [other, middle]));
          }
        }
      });
    }
  }

  /** Where the outline crosses each row (across = 0) or column (1), as places along it. */
  private crossings(outline: Float32Array, across: 0 | 1): number[][] {
    const up = 1 - across;
    const lines: number[][] = Array.from({ length: this.counts[up] }, () => []);
    for (let k = 0; k < outline.length; k += 4) {
      const [a, b] = [outline[k + up], outline[k + 2 + up]];
      const [from, to] = [Math.min(a, b), Math.max(a, b)].map((value) => (value - this.low[up]) / this.spacing);
      // Half open, so that a corner counts once.
      for (let line = Math.max(0, Math.floor(from) + 1); line <= Math.min(this.counts[up] - 1, to); ++line) {
        const share = (this.low[up] + line * this.spacing - a) / (b - a);
        lines[line].push(outline[k + across] + share * (outline[k + 2 + across] - outline[k + across]));
      }
    }
    return lines;
  }

  /** The piece at each point that is inside and on one. */
  pieces_at(pieces: CutPieces, flat: Float32Array): { piece: number; u: number; v: number }[] {
    const found: { piece: number; u: number; v: number }[] = [];
    const taken = new Int32Array(this.inside.length).fill(-1);
    const bins = this.binned_extra();
    const extra_pieces = new Int32Array(this.extra.length / 2).fill(-1);
    for (let piece = 0; piece < pieces.count; ++piece) {
      const [begin, end] = [pieces.starts[piece], pieces.starts[piece + 1]];
      const low = [Infinity, Infinity];
      const high = [-Infinity, -Infinity];
      for (let k = 2 * begin; k < 2 * end; ++k) {
        low[k & 1] = Math.min(low[k & 1], flat[k]);
        high[k & 1] = Math.max(high[k & 1], flat[k]);
      }
      const [first, last] = [low, high].map((values) => values.map((value, k) => (value - this.low[k]) / this.spacing));
      for (let row = Math.max(0, Math.ceil(first[1])); row <= Math.min(this.counts[1] - 1, last[1]); ++row) {
        for (let column = Math.max(0, Math.ceil(first[0])); column <= Math.min(this.counts[0] - 1, last[0]); ++column) {
          const index = this.index_of(column, row);
          if (!this.inside[index] || taken[index] >= 0) continue;
          if (holds(flat, begin, end, this.low[0] + column * this.spacing, this.low[1] + row * this.spacing)) taken[index] = piece;
        }
      }
      if (bins.size === 0) continue;
      for (let row = Math.floor(first[1]); row <= last[1]; ++row) {
        for (let column = Math.floor(first[0]); column <= last[0]; ++column) {
          for (const k of bins.get(row * 65536 + column) ?? []) {
            if (extra_pieces[k] < 0 && holds(flat, begin, end, this.extra[2 * k], this.extra[2 * k + 1])) extra_pieces[k] = piece;
          }
        }
      }
    }
    taken.forEach((piece, index) => {
      if (piece >= 0) found.push({ piece, u: this.low[0] + (index % this.counts[0]) * this.spacing, v: this.low[1] + Math.floor(index / this.counts[0]) * this.spacing });
    });
    for (let k = 0; k < extra_pieces.length; ++k) {
      const [u, v] = [this.extra[2 * k], this.extra[2 * k + 1]];
      if (extra_pieces[k] < 0 || found.some((other) => Math.hypot(other.u - u, other.v - v) < kApart * this.spacing)) continue;
      found.push({ piece: extra_pieces[k], u, v });
    }
    return found;
  }

  private binned_extra(): Map<number, number[]> {
    const bins = new Map<number, number[]>();
    for (let k = 0; k < this.extra.length / 2; ++k) {
      const [column, row] = [0, 1].map((axis) => Math.floor((this.extra[2 * k + axis] - this.low[axis]) / this.spacing));
      const key = row * 65536 + column;
      bins.set(key, [...(bins.get(key) ?? []), k]);
    }
    return bins;
  }
}
