// SPDX-License-Identifier: Apache-2.0
// The cells of a scene as a tree of eight children each, for looking up the cell at a point, here and in shaders.
//
// One flat array serves both: entry 8 node + child is 0 where there is nothing, the number of the child's node where it has children,
// and kLeaf + cell number where it is a cell. Bit k of `child` says whether it is the upper half along axis k. The root is node 0.

import type { Vector } from "../math/frame.ts";
import { cell_count, type Scene } from "./scene.ts";

export const kLeaf = 0x80000000;

export interface Octree {
  entries: Uint32Array;
  nodes: number;
  /** The root's side is 2^depth lattice units. */
  depth: number;
}

export function build_octree(scene: Scene): Octree {
  const count = cell_count(scene);
  const corner = scene.cell_corner;
  const size = scene.cell_size;
  let extent = 1;
  for (let cell = 0; cell < count; ++cell) {
    for (let axis = 0; axis < 3; ++axis) extent = Math.max(extent, corner[3 * cell + axis] + size[cell]);
  }
  // At least 1, so that a single cell that fills the root still is the child of a node.
  const depth = Math.max(1, Math.ceil(Math.log2(extent)) + (count === 1 ? 1 : 0));
  let entries = new Uint32Array(8 * Math.max(64, count));
  let nodes = 1;
  for (let cell = 0; cell < count; ++cell) {
    const x = corner[3 * cell];
    const y = corner[3 * cell + 1];
    const z = corner[3 * cell + 2];
    const leaf_level = Math.round(Math.log2(size[cell]));
    let node = 0;
    for (let level = depth - 1; level > leaf_level; --level) {
      const entry = 8 * node + child_of(x, y, z, level);
      if (entries[entry] === 0) {
        if (8 * (nodes + 1) > entries.length) {
          const larger = new Uint32Array(2 * entries.length);
          larger.set(entries);
          entries = larger;
        }
        entries[entry] = nodes++;
      }
      node = entries[entry];
    }
    entries[8 * node + child_of(x, y, z, leaf_level)] = (kLeaf | cell) >>> 0;
  }
  return { entries: entries.slice(0, 8 * nodes), nodes, depth };
}

const child_of = (x: number, y: number, z: number, level: number): number =>
  ((x >> level) & 1) | (((y >> level) & 1) << 1) | (((z >> level) & 1) << 2);

/** The cell that holds a point given in the scene's coordinates, or -1. */
export function cell_at(scene: Scene, octree: Octree, point: Vector): number {
  const { low, unit } = scene.cells;
  const x = Math.floor((point[0] - low[0]) / unit);
  const y = Math.floor((point[1] - low[1]) / unit);
  const z = Math.floor((point[2] - low[2]) / unit);
  const side = 2 ** octree.depth;
  if (x < 0 || y < 0 || z < 0 || x >= side || y >= side || z >= side) return -1;
  let node = 0;
  for (let level = octree.depth - 1; level >= 0; --level) {
    const entry = octree.entries[8 * node + child_of(x, y, z, level)];
    if (entry === 0) return -1;
    if (entry >= kLeaf) return entry - kLeaf;
    node = entry;
  }
  return -1;
}

/** The cell on the surface at a point: a boundary cell there, or a little further in against the outward normal; else any cell; else -1. */
export function surface_cell_at(scene: Scene, octree: Octree, point: Vector, normal: Vector): number {
  let any = -1;
  for (const steps of kStepsInward) {
    const depth = steps * scene.cells.unit;
    const cell = cell_at(scene, octree, [point[0] - depth * normal[0], point[1] - depth * normal[1], point[2] - depth * normal[2]]);
    if (cell >= 0 && scene.cell_class[cell] > 0) return cell;
    if (any < 0) any = cell;
  }
  return any;
}

// In lattice units. The first is past rounding only; the others serve surfaces of fewer triangles than were solved with, which run beside them.
export const kStepsInward = [0.03, 0.4, 1.1, 2.5, -0.6];
