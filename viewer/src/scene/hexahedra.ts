// SPDX-License-Identifier: Apache-2.0
// Hexahedra of a scene: which are shown, and the outside of these.

import { add, cross, dot, length_of, scaled, subtract, type Vector } from "../math/frame.ts";

/** By what hexahedra are coloured: scaled Jacobian, face of the model, region. */
export const kHexColors = ["shape", "face", "region"] as const;
export type HexColor = (typeof kHexColors)[number];

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
  /** 1 for each that is not valid, otherwise 0; empty if all are. */
  is_inverted: Uint8Array;
  /** Of each its place in the mesh, from 0; empty if all of it is here. */
  number: Uint32Array;
  /** Numbers of the faces of the model that the six sides of each lie on, 0 for none; empty where no face has a number. */
  face: Int32Array;
  /** Numbers of the regions, ascending, and of each hexahedron its place among them; both empty for fewer than two regions. */
  regions: number[];
  region: Uint16Array;
}

/** Corners of the faces, outward by the right-hand rule, and of the edges. */
const kFaces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
const kEdges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

export const hexahedron_count = ({ shape }: Hexahedra): number => shape.length;

export const is_inverted = (hexahedra: Hexahedra, hexahedron: number): boolean => hexahedra.is_inverted[hexahedron] === 1;

/** Its number in the files, from 1. */
export const number_of = ({ number }: Hexahedra, hexahedron: number): number => (number[hexahedron] ?? hexahedron) + 1;

/** Numbers of the faces of the model that hexahedra lie on, ascending. */
export const faces_of_hexahedra = ({ face }: Hexahedra): number[] => [...new Set(face)].filter((number) => number !== 0).sort((a, b) => a - b);

/** By what the hexahedra of a page can be coloured. */
export const hex_colors = (hexahedra: Hexahedra): HexColor[] =>
  kHexColors.filter((color) => color === "shape" || (color === "face" ? hexahedra.face.some((number) => number !== 0) : hexahedra.regions.length > 1));

/** Faces that one of the shown hexahedra has alone. */
export interface HexSkin {
  /** 6 k + s: side s of hexahedron k. */
  side: Uint32Array;
  /** Four points of each face. */
  corners: Uint32Array;
}

/** The hexahedron that has a side. */
export const hexahedron_of = (side: number): number => Math.floor(side / 6);

/** The share of hexahedra whose centres are below a plane. */
export function share_below(hexahedra: Hexahedra, { normal, offset }: { normal: Vector; offset: number }): number {
  const centers = centers_of(hexahedra);
  let count = 0;
  for (let k = 0; k < centers.length; k += 3) if (normal[0] * centers[k] + normal[1] * centers[k + 1] + normal[2] * centers[k + 2] < offset) ++count;
  return (3 * count) / centers.length;
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
    const skin = { side: new Uint32Array(count), corners: new Uint32Array(4 * count) };
    let next = 0;
    for (let side = 0; side < this.behind.length; ++side) {
      if (!this.is_outside(side, is_shown)) continue;
      skin.side[next] = side;
      kFaces[side % 6].forEach((corner, k) => (skin.corners[4 * next + k] = corners[8 * hexahedron_of(side) + corner]));
      ++next;
    }
    return skin;
  }

  /** Of each hexahedron whether it has a vertex of this one; not of itself. */
  around(hexahedron: number): Uint8Array {
    const { corners, shape } = this.hexahedra;
    const own = new Set(corners.subarray(8 * hexahedron, 8 * hexahedron + 8));
    const is_around = new Uint8Array(shape.length);
    for (let k = 0; k < corners.length; ++k) if (own.has(corners[k])) is_around[k >> 3] = 1;
    is_around[hexahedron] = 0;
    return is_around;
  }

  private is_outside(side: number, is_shown: Uint8Array): boolean {
    const behind = this.behind[side];
    return is_shown[hexahedron_of(side)] === 1 && (behind < 0 || is_shown[behind] === 0);
  }
}

// Of a hexahedron with its centre at a place: how far off that is, in its radii. Places are rounded to single precision.
const kAtCenter = 1e-2;

/** The hexahedron with its centre at a point; -1 where none has. */
export function hexahedron_centered_at(hexahedra: Hexahedra, [x, y, z]: Vector): number {
  const centers = centers_of(hexahedra);
  let best = -1;
  let least = Infinity;
  for (let k = 0; k < centers.length / 3; ++k) {
    const distance = (centers[3 * k] - x) ** 2 + (centers[3 * k + 1] - y) ** 2 + (centers[3 * k + 2] - z) ** 2;
    if (distance < least) [best, least] = [k, distance];
  }
  return best >= 0 && Math.sqrt(least) <= kAtCenter * hexahedron_radius(hexahedra, best) ? best : -1;
}

/** Half the largest distance of two of its corners from one another. */
export function hexahedron_radius({ points, corners }: Hexahedra, hexahedron: number): number {
  const at = Array.from(corners.subarray(8 * hexahedron, 8 * hexahedron + 8), (corner) => [...points.subarray(3 * corner, 3 * corner + 3)] as Vector);
  return Math.max(...at.flatMap((a) => at.map((b) => length_of(subtract(a, b))))) / 2;
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

/** The first side of the shown hexahedra that a ray meets, and where; null where it meets none. */
export function side_along({ points }: Hexahedra, { side, corners }: HexSkin, origin: Vector, direction: Vector): { side: number; point: Vector } | null {
  let best = { side: -1, distance: Infinity };
  const at = (corner: number): Vector => [points[3 * corner], points[3 * corner + 1], points[3 * corner + 2]];
  for (let face = 0; face < side.length; ++face) {
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => at(corners[4 * face + k]));
    for (const [p, q, r] of [[a, b, c], [a, c, d]]) {
      const distance = ray_meets(origin, direction, p, q, r);
      if (distance < best.distance) best = { side: side[face], distance };
    }
  }
  return best.side < 0 ? null : { side: best.side, point: add(origin, scaled(direction, best.distance)) };
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
    const face = kFaces[side % 6].map((corner) => corners[8 * hexahedron_of(side) + corner]).sort((a, b) => a - b);
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
        behind[a] = hexahedron_of(b);
        behind[b] = hexahedron_of(a);
      }
    }
  }
  return behind;
}
