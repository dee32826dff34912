// SPDX-License-Identifier: Apache-2.0
// The intersection of a field with a plane: polygons of tets or cells with the sides that they share. Typed arrays throughout, since a
// cut follows the pointer through hundreds of thousands of tets.

import { cross, dot, tangents_of, type Vector } from "../math/frame.ts";
import { cell_at, type Octree } from "./octree.ts";
import { cell_count, type Scene, type Tets } from "./scene.ts";

export interface CutPieces {
  count: number;
  /** Tet or cell of each piece. */
  element: Uint32Array;
  /** First corner of each piece, and the end; three coordinates a corner. */
  starts: Uint32Array;
  corners: Float32Array;
  /** Sides of two pieces: their numbers, and both ends. */
  side_pieces: Uint32Array;
  side_ends: Float32Array;
}

// Corners of a cut tet in order around it, for each set of vertices above the plane: pairs of vertices whose edges are cut.
const kTetCorners: number[][] = Array.from({ length: 16 }, (_, above) => {
  const [up, down] = [true, false].map((side) => [0, 1, 2, 3].filter((k) => Boolean((above >> k) & 1) === side));
  if (up.length === 1) return down.flatMap((k) => [up[0], k]);
  if (down.length === 1) return up.flatMap((k) => [k, down[0]]);
  return up.length === 2 ? [up[0], down[0], up[0], down[1], up[1], down[1], up[1], down[0]] : [];
});

/** Cuts all tets. A vertex in the plane counts as below it. */
export function cut_tets({ points, corners: tets }: Tets, normal: Vector, offset: number): CutPieces {
  const heights = new Float32Array(points.length / 3);
  for (let k = 0; k < heights.length; ++k) heights[k] = normal[0] * points[3 * k] + normal[1] * points[3 * k + 1] + normal[2] * points[3 * k + 2] - offset;
  const total = tets.length / 4;
  const sets = new Uint8Array(total);
  let count = 0;
  let corner_count = 0;
  for (let tet = 0; tet < total; ++tet) {
    const at = 4 * tet;
    const above = Number(heights[tets[at]] > 0) | (Number(heights[tets[at + 1]] > 0) << 1) | (Number(heights[tets[at + 2]] > 0) << 2) | (Number(heights[tets[at + 3]] > 0) << 3);
    sets[tet] = above;
    if (above === 0 || above === 15) continue;
    ++count;
    corner_count += kTetCorners[above].length / 2;
  }
  const element = new Uint32Array(count);
  const starts = new Uint32Array(count + 1);
  const corners = new Float32Array(3 * corner_count);
  const faces = new Faces(corner_count);
  let piece = 0;
  let corner = 0;
  for (let tet = 0; tet < total; ++tet) {
    const above = sets[tet];
    if (above === 0 || above === 15) continue;
    const pairs = kTetCorners[above];
    element[piece] = tet;
    const first = corner;
    for (let k = 0; k < pairs.length; k += 2) {
      // From the lower number to the higher, so that both sides of a face find the same point to the bit.
      let a = tets[4 * tet + pairs[k]];
      let b = tets[4 * tet + pairs[k + 1]];
      if (a > b) [a, b] = [b, a];
      const share = heights[a] / (heights[a] - heights[b]);
      for (let axis = 0; axis < 3; ++axis) corners[3 * corner + axis] = points[3 * a + axis] + share * (points[3 * b + axis] - points[3 * a + axis]);
      ++corner;
    }
    const size = corner - first;
    for (let k = 0; k < size; ++k) {
      // Two neighbouring corners lie on two edges with a common vertex: the face of three vertices.
      const [p, q, r, s] = [pairs[2 * k], pairs[2 * k + 1], pairs[2 * ((k + 1) % size)], pairs[2 * ((k + 1) % size) + 1]];
      faces.add(tets[4 * tet + p], tets[4 * tet + q], tets[4 * tet + (p === r ? s : r)], piece, first + k, first + ((k + 1) % size));
    }
    starts[++piece] = corner;
  }
  return { count, element, starts, corners, ...faces.sides(corners) };
}

/** Finds the sides that lie on the same face: a table with open addressing. */
class Faces {
  private readonly mask: number;
  private readonly slots: Int32Array;
  private readonly keys: Uint32Array;
  private readonly pieces: Uint32Array;
  private readonly ends: Uint32Array;
  private used = 0;
  private readonly found: Uint32Array;
  private shared = 0;

  constructor(most: number) {
    const size = 2 ** Math.ceil(Math.log2(Math.max(16, 2 * most)));
    this.mask = size - 1;
    this.slots = new Int32Array(size).fill(-1);
    this.keys = new Uint32Array(3 * most);
    this.pieces = new Uint32Array(most);
    this.ends = new Uint32Array(2 * most);
    this.found = new Uint32Array(2 * most);
  }

  add(a: number, b: number, c: number, piece: number, from: number, to: number): void {
    const low = Math.min(a, b, c);
    const high = Math.max(a, b, c);
    const middle = a + b + c - low - high;
    let slot = (Math.imul(low, 73856093) ^ Math.imul(middle, 19349663) ^ Math.imul(high, 83492791)) & this.mask;
    for (; this.slots[slot] >= 0; slot = (slot + 1) & this.mask) {
      const other = this.slots[slot];
      if (this.keys[3 * other] !== low || this.keys[3 * other + 1] !== middle || this.keys[3 * other + 2] !== high) continue;
      this.found[2 * this.shared] = other;
      this.found[2 * this.shared++ + 1] = piece;
      return;
    }
    this.slots[slot] = this.used;
    this.keys.set([low, middle, high], 3 * this.used);
    this.pieces[this.used] = piece;
    this.ends[2 * this.used] = from;
    this.ends[2 * this.used++ + 1] = to;
  }

  sides(corners: Float32Array): Pick<CutPieces, "side_pieces" | "side_ends"> {
    const side_pieces = new Uint32Array(2 * this.shared);
    const side_ends = new Float32Array(6 * this.shared);
    for (let k = 0; k < this.shared; ++k) {
      const first = this.found[2 * k];
      side_pieces[2 * k] = this.pieces[first];
      side_pieces[2 * k + 1] = this.found[2 * k + 1];
      for (let end = 0; end < 2; ++end) {
        const at = 3 * this.ends[2 * first + end];
        for (let axis = 0; axis < 3; ++axis) side_ends[6 * k + 3 * end + axis] = corners[at + axis];
      }
    }
    return { side_pieces, side_ends };
  }
}

// In lattice units. Like the face of the cut, pieces are what lies just on its kept side.
const kKeptSide = 1e-3;
// How far beyond a side its neighbour is looked for, in lattice units.
const kBeyond = 0.02;

/** Cuts the cells, whole also where the surface passes through. */
export function cut_cells(scene: Scene, octree: Octree, normal: Vector, offset: number): CutPieces {
  const { low, unit } = scene.cells;
  const [first, second] = tangents_of(normal);
  const reach = Math.abs(normal[0]) + Math.abs(normal[1]) + Math.abs(normal[2]);
  const lattice_offset = (offset - dot(normal, low)) / unit - kKeptSide;
  const elements: number[] = [];
  const starts: number[] = [0];
  const flat: number[] = []; // corners in lattice units
  const piece_of = new Int32Array(cell_count(scene)).fill(-1);
  for (let cell = 0; cell < cell_count(scene); ++cell) {
    const side = scene.cell_size[cell];
    const corner: Vector = [scene.cell_corner[3 * cell], scene.cell_corner[3 * cell + 1], scene.cell_corner[3 * cell + 2]];
    const middle = dot(normal, corner) + ((normal[0] + normal[1] + normal[2]) * side) / 2 - lattice_offset;
    if (Math.abs(middle) >= (reach * side) / 2) continue;
    const polygon = cut_cube(corner, side, normal, lattice_offset, first, second);
    if (polygon.length < 9) continue;
    piece_of[cell] = elements.push(cell) - 1;
    for (const value of polygon) flat.push(value);
    starts.push(flat.length / 3);
  }
  const corners = new Float32Array(flat.length);
  const lift = kKeptSide;
  for (let k = 0; k < flat.length; ++k) corners[k] = low[k % 3] + unit * (flat[k] + lift * normal[k % 3]);
  return { count: elements.length, element: Uint32Array.from(elements), starts: Uint32Array.from(starts), corners, ...cell_sides(scene, octree, normal, elements, starts, flat, corners, piece_of) };
}

/** The polygon of a cube and a plane, in order around it. */
function cut_cube(low: Vector, side: number, normal: Vector, offset: number, first: Vector, second: Vector): number[] {
  const found: { angle: number; at: Vector }[] = [];
  const middle: Vector = [0, 0, 0];
  for (let k = 0; k < 8; ++k) {
    const a: Vector = [low[0] + side * (k & 1), low[1] + side * ((k >> 1) & 1), low[2] + side * (k >> 2)];
    const height = dot(normal, a) - offset;
    for (let axis = 0; axis < 3; ++axis) {
      if ((k >> axis) & 1) continue;
      const other = height + side * normal[axis];
      if (height > 0 === other > 0) continue;
      const at: Vector = [...a];
      at[axis] += (side * height) / (height - other);
      for (let m = 0; m < 3; ++m) middle[m] += at[m];
      found.push({ angle: 0, at });
    }
  }
  for (const one of found) {
    const away: Vector = [one.at[0] - middle[0] / found.length, one.at[1] - middle[1] / found.length, one.at[2] - middle[2] / found.length];
    one.angle = Math.atan2(dot(second, away), dot(first, away));
  }
  return found.sort((a, b) => a.angle - b.angle).flatMap(({ at }) => at);
}

function cell_sides(
  scene: Scene, octree: Octree, normal: Vector, elements: number[], starts: number[], flat: number[], corners: Float32Array, piece_of: Int32Array,
): Pick<CutPieces, "side_pieces" | "side_ends"> {
  const { low, unit } = scene.cells;
  const pieces: number[] = [];
  const ends: number[] = [];
  for (let piece = 0; piece < elements.length; ++piece) {
    const cell = elements[piece];
    const size = scene.cell_size[cell];
    for (let k = starts[piece]; k < starts[piece + 1]; ++k) {
      const next = k + 1 < starts[piece + 1] ? k + 1 : starts[piece];
      const along: Vector = [flat[3 * next] - flat[3 * k], flat[3 * next + 1] - flat[3 * k + 1], flat[3 * next + 2] - flat[3 * k + 2]];
      const length = Math.hypot(...along);
      if (length < 1e-6) continue;
      // Polygons run anticlockwise about the normal: outwards is to the right.
      const out = cross(along, normal);
      const at = [0, 1, 2].map((m) => low[m] + unit * (flat[3 * k + m] + along[m] / 2 + (kBeyond * out[m]) / length)) as Vector;
      const other = cell_at(scene, octree, at);
      if (other < 0 || piece_of[other] < 0) continue;
      // The smaller of two cells has the whole side.
      if (scene.cell_size[other] < size || (scene.cell_size[other] === size && other < cell)) continue;
      pieces.push(piece, piece_of[other]);
      for (const end of [k, next]) ends.push(corners[3 * end], corners[3 * end + 1], corners[3 * end + 2]);
    }
  }
  return { side_pieces: Uint32Array.from(pieces), side_ends: Float32Array.from(ends) };
}

/** Segments of a surface in a plane, six coordinates each: the outline of what is cut. */
export function cut_outline(vertices: Float32Array, triangles: Uint32Array, normal: Vector, offset: number): Float32Array {
  const heights = new Float32Array(vertices.length / 3);
  for (let k = 0; k < heights.length; ++k) heights[k] = normal[0] * vertices[3 * k] + normal[1] * vertices[3 * k + 1] + normal[2] * vertices[3 * k + 2] - offset;
  const segments: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const above = Number(heights[triangles[t]] > 0) + Number(heights[triangles[t + 1]] > 0) + Number(heights[triangles[t + 2]] > 0);
    if (above === 0 || above === 3) continue;
    for (let k = 0; k < 3; ++k) {
      let a = triangles[t + k];
      let b = triangles[t + ((k + 1) % 3)];
      if (heights[a] > 0 === heights[b] > 0) continue;
      if (a > b) [a, b] = [b, a];
      const share = heights[a] / (heights[a] - heights[b]);
      for (let axis = 0; axis < 3; ++axis) segments.push(vertices[3 * a + axis] + share * (vertices[3 * b + axis] - vertices[3 * a + axis]));
    }
  }
  return Float32Array.from(segments);
}
