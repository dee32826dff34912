// SPDX-License-Identifier: Apache-2.0
// Which frames to draw on a cut, and where: one for each square of a raster of the lattice, or for each cell that is larger.

import type { Vector } from "../math/frame.ts";
import { dot } from "../math/frame.ts";
import { cell_at, type Octree } from "../scene/octree.ts";
import { cell_count, type Scene } from "../scene/scene.ts";

export interface GlyphPlace {
  cell: number;
  point: Vector;
  /** Room for the glyph, in model units. */
  side: number;
}

/** `spacing` in lattice units, a power of two. The places are in the cut. */
export function glyph_places(scene: Scene, octree: Octree, normal: Vector, offset: number, spacing: number): GlyphPlace[] {
  const { low, unit } = scene.cells;
  const corner = scene.cell_corner;
  const size = scene.cell_size;
  const count = cell_count(scene);
  const reach = Math.abs(normal[0]) + Math.abs(normal[1]) + Math.abs(normal[2]);
  const lattice_offset = (offset - dot(normal, low)) / unit;
  // Like the cut's face, glyphs show what lies just on the kept side.
  const sample_offset = lattice_offset - 1e-3;

  const places: GlyphPlace[] = [];
  const blocks = new Map<number, { cell: number; distance: number; place: Vector }>();
  for (let cell = 0; cell < count; ++cell) {
    const side = size[cell];
    const half = side / 2;
    const x = corner[3 * cell] + half;
    const y = corner[3 * cell + 1] + half;
    const z = corner[3 * cell + 2] + half;
    const distance = normal[0] * x + normal[1] * y + normal[2] * z - sample_offset;
    if (Math.abs(distance) > reach * half) continue;
    const on_cut: Vector = [x - distance * normal[0], y - distance * normal[1], z - distance * normal[2]];
    if (side >= spacing) {
      places.push({ cell, point: to_scene(on_cut, low, unit), side: unit * Math.min(side, 2 * spacing) });
      continue;
    }
    const block = [Math.floor(on_cut[0] / spacing), Math.floor(on_cut[1] / spacing), Math.floor(on_cut[2] / spacing)];
    const key = (block[2] * 65536 + block[1]) * 65536 + block[0];
    const from_middle = Math.hypot(...on_cut.map((value, k) => value - (block[k] + 0.5) * spacing));
    const best = blocks.get(key);
    if (!best || from_middle < best.distance) blocks.set(key, { cell, distance: from_middle, place: on_cut });
  }

  for (const { cell, place } of blocks.values()) {
    // In the middle of its square where the part is there, so that glyphs make straight rows; else in the cell itself.
    const middle = place.map((value) => (Math.floor(value / spacing) + 0.5) * spacing) as Vector;
    const away = dot(normal, middle) - sample_offset;
    const on_cut = middle.map((value, k) => value - away * normal[k]) as Vector;
    const point = to_scene(on_cut, low, unit);
    const there = cell_at(scene, octree, point);
    places.push(there >= 0 ? { cell: there, point, side: unit * spacing } : { cell, point: to_scene(place, low, unit), side: unit * spacing });
  }
  return without_neighbours(places, 0.72);
}

/** The same, closer together where the cut is so narrow that glyphs would reach far out of it: through thin walls. */
export function fitting_glyph_places(scene: Scene, octree: Octree, normal: Vector, offset: number, spacing: number): GlyphPlace[] {
  const places = glyph_places(scene, octree, normal, offset, spacing);
  if (spacing < 2 || places.length === 0) return places;
  const squares = places.reduce((sum, place) => sum + (place.side / scene.cells.unit) ** 2, 0);
  // Rows of glyphs on an inclined cut overlap: each has about half of its room to itself.
  const own = Math.max(...normal.map(Math.abs)) > 0.999 ? 1 : 0.5;
  if (cut_area(scene, normal, offset) > kLeastCover * own * squares) return places;
  return glyph_places(scene, octree, normal, offset, spacing / 2);
}

// Below this share of glyphs' room that is cut, the part is a thin wall there: a wall of half a room's width has 0.5.
const kLeastCover = 0.55;

/** The area of the cut in square lattice units: each cell that is the one it passes along its steepest axis counts with its shadow. */
function cut_area(scene: Scene, normal: Vector, offset: number): number {
  const { low, unit } = scene.cells;
  const lattice_offset = (offset - dot(normal, low)) / unit - 1e-3;
  const steepest = Math.max(...normal.map(Math.abs));
  let area = 0;
  for (let cell = 0; cell < cell_count(scene); ++cell) {
    const side = scene.cell_size[cell];
    let distance = -lattice_offset;
    for (let k = 0; k < 3; ++k) distance += normal[k] * (scene.cell_corner[3 * cell + k] + side / 2);
    if (Math.abs(distance) <= (steepest * side) / 2) area += (side * side) / steepest;
  }
  return area;
}

const to_scene = (at: Vector, low: Vector, unit: number): Vector => [low[0] + unit * at[0], low[1] + unit * at[1], low[2] + unit * at[2]];

/** Cuts across the lattice pass several blocks close together: of glyphs nearer than a share of their room only one stays. */
function without_neighbours(places: GlyphPlace[], share: number): GlyphPlace[] {
  if (places.length === 0) return places;
  const cell_side = Math.min(...places.map((place) => place.side));
  const grid = new Map<string, GlyphPlace[]>();
  const key = (point: Vector, step: [number, number, number]): string =>
    point.map((value, k) => Math.floor(value / cell_side) + step[k]).join();
  return places.filter((place) => {
    for (let i = -1; i <= 1; ++i) for (let j = -1; j <= 1; ++j) for (let k = -1; k <= 1; ++k) {
      for (const other of grid.get(key(place.point, [i, j, k])) ?? []) {
        const distance = Math.hypot(...other.point.map((value, axis) => value - place.point[axis]));
        if (distance < share * Math.min(place.side, other.side)) return false;
      }
    }
    const own = key(place.point, [0, 0, 0]);
    grid.set(own, [...(grid.get(own) ?? []), place]);
    return true;
  });
}
