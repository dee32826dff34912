// SPDX-License-Identifier: Apache-2.0
// Hexahedra of a scene: which are shown, and the outside of these.

import { dot, length_of, subtract, type Vector } from "../math/frame.ts";

export interface Hexahedra {
  /** Of the mesh; the arrays have no more than a page can show. */
  total: number;
  inverted: number;
  /** Of the scaled Jacobians of the mesh. */
  mean: number;
  points: Float32Array;
  corners: Uint32Array;
  /** Scaled Jacobians. */
  shape: Float32Array;
  /** Of each its number in the mesh; empty if all of it is here. */
  number: Uint32Array;
}

/** Hexahedra that are inverted, or flat but for rounding, have at most this scaled Jacobian. */
export const kInverted = 1e-6;

/** Corners of the faces, outward by the right-hand rule, and of the edges. */
const kFaces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
const kEdges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

export const hexahedron_count = ({ shape }: Hexahedra): number => shape.length;

export const number_of = ({ number }: Hexahedra, hexahedron: number): number => number[hexahedron] ?? hexahedron;

/** Faces that one of the shown hexahedra has alone. */
export interface HexSkin {
  hexahedron: Uint32Array;
  /** Four points of each face. */
  corners: Uint32Array;
}

/** Finds skins: what is behind each face is found once. */
export class HexSkins {
  readonly centers: Float32Array;
  /** The hexahedron behind each of six faces; -1 where there is none. */
  private readonly behind: Int32Array;

  constructor(readonly hexahedra: Hexahedra) {
    this.centers = centers_of(hexahedra);
    this.behind = neighbours_of(hexahedra);
  }

  /** Of each hexahedron whether it is shown: where its centre is not above a plane, and its shape is below a limit. */
  shown(plane: { normal: Vector; offset: number } | null, below: number): Uint8Array {
    const { shape } = this.hexahedra;
    const { centers } = this;
    const is_shown = new Uint8Array(shape.length);
    const [x, y, z] = plane ? plane.normal : [0, 0, 0];
    const most = plane ? plane.offset : 0;
    for (let k = 0; k < shape.length; ++k) {
      is_shown[k] = shape[k] < below && x * centers[3 * k] + y * centers[3 * k + 1] + z * centers[3 * k + 2] <= most ? 1 : 0;
    }
    return is_shown;
  }

  skin(is_shown: Uint8Array): HexSkin {
    const { corners } = this.hexahedra;
    let count = 0;
    for (let side = 0; side < this.behind.length; ++side) if (this.is_outside(side, is_shown)) ++count;
    const skin = { hexahedron: new Uint32Array(count), corners: new Uint32Array(4 * count) };
    let next = 0;
    for (let side = 0; side < this.behind.length; ++side) {
      if (!this.is_outside(side, is_shown)) continue;
      const hexahedron = Math.floor(side / 6);
      skin.hexahedron[next] = hexahedron;
      kFaces[side % 6].forEach((corner, k) => (skin.corners[4 * next + k] = corners[8 * hexahedron + corner]));
      ++next;
    }
    return skin;
  }

  private is_outside(side: number, is_shown: Uint8Array): boolean {
    const behind = this.behind[side];
    return is_shown[Math.floor(side / 6)] === 1 && (behind < 0 || is_shown[behind] === 0);
  }
}

export function hexahedron_center({ centers }: HexSkins, hexahedron: number): Vector {
  return [centers[3 * hexahedron], centers[3 * hexahedron + 1], centers[3 * hexahedron + 2]];
}

/** The two ends of each of the twelve edges. */
export function hexahedron_edges({ points, corners }: Hexahedra, hexahedron: number): [Vector, Vector][] {
  const at = (corner: number): Vector => {
    const point = 3 * corners[8 * hexahedron + corner];
    return [points[point], points[point + 1], points[point + 2]];
  };
  return kEdges.map(([a, b]) => [at(a), at(b)]);
}

export function edge_lengths(hexahedra: Hexahedra, hexahedron: number): { least: number; most: number } {
  const lengths = hexahedron_edges(hexahedra, hexahedron).map(([a, b]) => length_of(subtract(b, a)));
  return { least: Math.min(...lengths), most: Math.max(...lengths) };
}

/** The first that a ray meets of the shown ones; -1 where it meets none. */
export function hexahedron_along({ points }: Hexahedra, { hexahedron, corners }: HexSkin, origin: Vector, direction: Vector): number {
  let best = { hexahedron: -1, distance: Infinity };
  const at = (corner: number): Vector => [points[3 * corner], points[3 * corner + 1], points[3 * corner + 2]];
  for (let face = 0; face < hexahedron.length; ++face) {
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => at(corners[4 * face + k]));
    for (const [p, q, r] of [[a, b, c], [a, c, d]]) {
      const distance = ray_meets(origin, direction, p, q, r);
      if (distance < best.distance) best = { hexahedron: hexahedron[face], distance };
    }
  }
  return best.hexahedron;
}

/** Where along a ray it meets a triangle (Möller and Trumbore 1997); infinity where it does not. */
function ray_meets(origin: Vector, direction: Vector, a: Vector, b: Vector, c: Vector): number {
  const [u, v] = [subtract(b, a), subtract(c, a)];
  const across = cross(direction, v);
  const determinant = dot(u, across);
  if (determinant === 0) return Infinity;
  const to = subtract(origin, a);
  const s = dot(to, across) / determinant;
  const turned = cross(to, u);
  const t = dot(direction, turned) / determinant;
  const distance = dot(v, turned) / determinant;
  return s >= 0 && t >= 0 && s + t <= 1 && distance > 0 ? distance : Infinity;
}

const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

function centers_of({ points, corners, shape }: Hexahedra): Float32Array {
  const centers = new Float32Array(3 * shape.length);
  for (let k = 0; k < corners.length; ++k) {
    for (let axis = 0; axis < 3; ++axis) centers[3 * (k >> 3) + axis] += points[3 * corners[k] + axis] / 8;
  }
  return centers;
}

/** Sides of hexahedra by their least point, so that each is compared with a dozen others at most. */
function neighbours_of({ corners, points, shape }: Hexahedra): Int32Array {
  const sides = 6 * shape.length;
  const sorted = new Uint32Array(4 * sides);
  const starts = new Uint32Array(points.length / 3 + 1);
  for (let side = 0; side < sides; ++side) {
    const face = kFaces[side % 6].map((corner) => corners[8 * Math.floor(side / 6) + corner]).sort((a, b) => a - b);
    sorted.set(face, 4 * side);
    ++starts[face[0] + 1];
  }
  for (let point = 0; point + 1 < starts.length; ++point) starts[point + 1] += starts[point];
  const filled = starts.slice();
  const order = new Uint32Array(sides);
  for (let side = 0; side < sides; ++side) order[filled[sorted[4 * side]]++] = side;
  const behind = new Int32Array(sides).fill(-1);
  for (let point = 0; point + 1 < starts.length; ++point) {
    for (let k = starts[point]; k < starts[point + 1]; ++k) {
      for (let other = k + 1; other < starts[point + 1] && behind[order[k]] < 0; ++other) {
        const [a, b] = [order[k], order[other]];
        if (behind[b] >= 0 || [1, 2, 3].some((corner) => sorted[4 * a + corner] !== sorted[4 * b + corner])) continue;
        behind[a] = Math.floor(b / 6);
        behind[b] = Math.floor(a / 6);
      }
    }
  }
  return behind;
}
