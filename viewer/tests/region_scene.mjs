// SPDX-License-Identifier: Apache-2.0
// A block of two regions on a coarse grid. The face between them, x = z / 2 - y / 4, does not follow the cells.

import { assemble } from "./sample_scene.mjs";
import { bar } from "./solids.mjs";

export function regions_scene() {
  const half = 10;
  const solid = bar(half, half);
  const between = (y, z) => z / 2 - y / 4;
  const corners = [[-half, -half], [half, -half], [half, half], [-half, half]].flatMap(([y, z]) => [between(y, z), y, z]);
  return assemble({
    solid, depth: 4, lattice: { low: [-12, -12, -12], unit: 1.5 }, arcs: [], nodes: [], frame_at: () => [1, 0, 0, 0],
    regions: {
      numbers: [3, 8], of: ([x, y, z]) => Number(x > between(y, z)),
      interfaces: { interface_vertices: ["f32", 3, corners], interface_triangles: ["u32", 3, [0, 1, 2, 0, 2, 3]] },
    },
    report: {
      model: { path: "/parts/block.step", triangles: solid.surface.triangles.length, watertight: true, components: 1, unit: "mm" },
      resolution: 16, input: { closed: true, findings: [] },
    },
  });
}
