// SPDX-License-Identifier: Apache-2.0
// A block of two regions on a coarse grid. The face between them, x = z / 2 - y / 4, does not follow the cells. A singular line and streamlines
// are there to be looked at; this is the scene that is drawn fastest.

import { assemble, line } from "./sample_scene.mjs";
import { bar } from "./solids.mjs";

export function regions_scene() {
  const half = 10;
  const solid = bar(half, half);
  const between = (y, z) => z / 2 - y / 4;
  const corners = [[-half, -half], [half, -half], [half, half], [-half, half]].flatMap(([y, z]) => [between(y, z), y, z]);
  const [low, high] = [[7, 7, -half], [7, 7, half]];
  const streamlines = [3, 5, 7].map((radius) => Array.from({ length: 65 }, (_, k) => [radius * Math.cos((Math.PI * k) / 32), radius * Math.sin((Math.PI * k) / 32), 0]));
  return assemble({
    solid, depth: 4, lattice: { low: [-12, -12, -12], unit: 1.5 }, frame_at: () => [1, 0, 0, 0], streamlines,
    arcs: [{ points: line(low, high, 8), index: 0.25 }], nodes: [low, high].map((point) => ({ point, on_boundary: 1, degree: 1 })),
    total: 4_100_000, merged_to: 1.5,
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
