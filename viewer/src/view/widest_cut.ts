// SPDX-License-Identifier: Apache-2.0
// Which of the three middle cuts shows most of the part: the page begins with it.

import { cell_count, type Scene } from "../scene/scene.ts";

export function widest_cut(scene: Scene): "x" | "y" | "z" {
  const areas = [0, 0, 0];
  const middle = [0, 1, 2].map((axis) => ((scene.low[axis] + scene.high[axis]) / 2 - scene.cells.low[axis]) / scene.cells.unit);
  for (let cell = 0; cell < cell_count(scene); ++cell) {
    const size = scene.cell_size[cell];
    for (let axis = 0; axis < 3; ++axis) {
      const low = scene.cell_corner[3 * cell + axis];
      if (low <= middle[axis] && middle[axis] < low + size) areas[axis] += size * size;
    }
  }
  // The front is nearest to the first view: a cut there is preferred to others that show about as much.
  areas[1] *= 1.15;
  return (["x", "y", "z"] as const)[areas.indexOf(Math.max(...areas))];
}
