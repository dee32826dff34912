// SPDX-License-Identifier: Apache-2.0
// The ranges of values that the colour maps spread over: round numbers, so that legends read well.

import { element_alignment, element_count, element_energy, type Scene } from "../scene/scene.ts";

export interface Range {
  low: number;
  high: number;
  logarithmic: boolean;
}

export interface Ranges {
  alignment: Range;
  energy: Range;
}

// A cube's diagonal is as far from its axes as a direction can be.
const kLargestTilt = 54.74;

export function ranges_of(scene: Scene): Ranges {
  const tilts: number[] = [];
  const energies: number[] = [];
  const count = element_count(scene);
  // Percentiles do not need every cell of a large field.
  const stride = Math.max(1, Math.floor(count / 50_000));
  for (let element = 0; element < count; element += stride) {
    const tilt = element_alignment(scene, element);
    if (tilt !== null) tilts.push(tilt);
    const energy = element_energy(scene, element);
    if (energy > 0) energies.push(energy);
  }
  const tilt = percentile(tilts, 0.995) ?? 0;
  const high_tilt = [1, 2, 5, 10, 15, 20, 30, 45].find((step) => tilt <= step) ?? kLargestTilt;
  const high = percentile(energies, 0.999) ?? 1;
  const low = percentile(energies, 0.05) ?? high / 1000;
  const top = Math.ceil(Math.log10(high));
  // Of many decades the upper four tell the lines from the rest; below is all "smooth".
  const bottom = Math.min(top - 1, Math.max(Math.floor(Math.log10(low)), top - 4));
  return {
    alignment: { low: 0, high: high_tilt, logarithmic: false },
    energy: { low: 10 ** bottom, high: 10 ** top, logarithmic: true },
  };
}

/** Where a value lies in a range, 0 ... 1. */
export function fraction_of(range: Range, value: number): number {
  const fraction = range.logarithmic
    ? value <= range.low ? 0 : Math.log(value / range.low) / Math.log(range.high / range.low)
    : (value - range.low) / (range.high - range.low);
  return Math.min(1, Math.max(0, fraction));
}

function percentile(values: number[], share: number): number | undefined {
  const sorted = Float64Array.from(values).sort();
  return sorted.length > 0 ? sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] : undefined;
}
