// SPDX-License-Identifier: Apache-2.0
// Numbers at the corners of cells, between which shaders interpolate: those of cells with surface come with the scene; the energy of all
// others is the mean over the cells at a corner.

import { cell_count, type Scene } from "../scene/scene.ts";
import { fraction_of, type Ranges } from "./ranges.ts";

/** Sixteen bytes a cell: alignment and energy density, as shares of their ranges, at its corners; bit a is set on the high side of axis a. */
export function corner_values(scene: Scene, ranges: Ranges): Uint8Array {
  const count = cell_count(scene);
  const texels = new Uint8Array(16 * count);
  const energy = Float32Array.from(scene.cell_energy_density, (value) => fraction_of(ranges.energy, value));
  const corners = new Corners(8 * count);
  for (let cell = 0; cell < count; ++cell) for (let k = 0; k < 8; ++k) corners.add(corner_key(scene, cell, k), energy[cell]);
  for (let cell = 0; cell < count; ++cell) {
    const tilt = Math.round(255 * fraction_of(ranges.alignment, scene.cell_alignment_deg[cell]));
    for (let k = 0; k < 8; ++k) {
      texels[16 * cell + 2 * k] = tilt;
      texels[16 * cell + 2 * k + 1] = Math.round(255 * corners.mean(corner_key(scene, cell, k)));
    }
  }
  scene.corner_cell.forEach((cell, row) => {
    for (let k = 0; k < 8; ++k) {
      const [angle, density] = [scene.corner_alignment_deg[8 * row + k], scene.corner_energy_density[8 * row + k]];
      if (Number.isFinite(angle)) texels[16 * cell + 2 * k] = Math.round(255 * fraction_of(ranges.alignment, angle));
      if (Number.isFinite(density)) texels[16 * cell + 2 * k + 1] = Math.round(255 * fraction_of(ranges.energy, density));
    }
  });
  return texels;
}

/** A point of the lattice as a number: corners count up to 2^16 along an axis. */
function corner_key({ cell_corner, cell_size }: Scene, cell: number, k: number): number {
  const side = cell_size[cell];
  const [x, y, z] = [0, 1, 2].map((axis) => cell_corner[3 * cell + axis] + ((k >> axis) & 1) * side);
  return (z * 65537 + y) * 65537 + x;
}

/** Means over what was added for a key: a table with open addressing. */
class Corners {
  private readonly mask: number;
  private readonly keys: Float64Array;
  private readonly sums: Float32Array;
  private readonly counts: Uint8Array;

  constructor(most: number) {
    const size = 2 ** Math.ceil(Math.log2(Math.max(16, most)));
    this.mask = size - 1;
    this.keys = new Float64Array(size).fill(-1);
    this.sums = new Float32Array(size);
    this.counts = new Uint8Array(size);
  }

  private slot(key: number): number {
    let slot = Math.imul(key % 4294967296, 2654435761) >>> 0;
    slot = (slot ^ (slot >>> 15) ^ Math.imul(Math.floor(key / 4294967296), 40503)) & this.mask;
    while (this.keys[slot] !== key && this.keys[slot] >= 0) slot = (slot + 1) & this.mask;
    return slot;
  }

  add(key: number, value: number): void {
    const slot = this.slot(key);
    this.keys[slot] = key;
    this.sums[slot] += value;
    ++this.counts[slot];
  }

  mean(key: number): number {
    const slot = this.slot(key);
    return this.sums[slot] / Math.max(1, this.counts[slot]);
  }
}
