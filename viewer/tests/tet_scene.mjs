// SPDX-License-Identifier: Apache-2.0
// A bar of tets with a singular line along its middle, of index 1/4: frames turn by a quarter about it. The grid from which the field
// started has four lines.

import { about, assemble, line } from "./sample_scene.mjs";
import { upper_half } from "./scene_writer.mjs";
import { bar } from "./solids.mjs";

// Each cube as six tets around its diagonal, whose vertices come in the order of the axes they step along.
const kSteps = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/** Points, and tets as four numbers of points each, of a box of cubes; all tets have positive volume. */
export function box_of_tets(low, size, counts) {
  const points = [];
  const number = (i, j, k) => (k * (counts[1] + 1) + j) * (counts[0] + 1) + i;
  for (let k = 0; k <= counts[2]; ++k) for (let j = 0; j <= counts[1]; ++j) for (let i = 0; i <= counts[0]; ++i) {
    points.push([i, j, k].map((step, axis) => low[axis] + (step * size[axis]) / counts[axis]));
  }
  const tets = [];
  for (let k = 0; k < counts[2]; ++k) for (let j = 0; j < counts[1]; ++j) for (let i = 0; i < counts[0]; ++i) {
    for (const steps of kSteps) {
      const at = [i, j, k];
      const tet = [number(...at)];
      for (const axis of steps) {
        ++at[axis];
        tet.push(number(...at));
      }
      const even = (steps[1] - steps[0] + 3) % 3 === 1;
      tets.push(even ? tet : [tet[1], tet[0], tet[2], tet[3]]);
    }
  }
  return { points, tets };
}

export const middle_of = (points, tet) => [0, 1, 2].map((axis) => tet.reduce((sum, k) => sum + points[k][axis] / 4, 0));

/** The frame of a line of this index along z through the origin. */
export const frame_around = (index) => ([x, y]) => about([0, 0, 1], index * Math.atan2(y, x));

/** The number of the face of a bar, from 1, that a point lies on; 0 inside. */
export function face_of_bar(point, half, half_length) {
  const at = point.map((value, axis) => value / (axis === 2 ? half_length : half));
  const axis = at.findIndex((value) => Math.abs(value) > 1 - 1e-9);
  return axis < 0 ? 0 : 2 * axis + (at[axis] > 0 ? 2 : 1);
}

/** `more` may add to header, arrays and report. */
export function tets_scene(more = {}) {
  const [half, length, cubes] = [10, 40, 9];
  const solid = bar(half, length / 2);
  const { points, tets } = box_of_tets([-half, -half, -length / 2], [2 * half, 2 * half, length], [cubes, cubes, 2 * cubes]);
  const middles = tets.map((tet) => middle_of(points, tet));
  const energy = middles.map(([x, y]) => 0.2 / (x * x + y * y + 0.2));
  const outside = middles.map(([x, y]) => Math.max(Math.abs(x), Math.abs(y)) > half - 1.5);
  const lines = [[-5, -5], [5, -5], [5, 5], [-5, 5]].map(([x, y]) => line([x, y, -length / 2], [x, y, length / 2], 8));
  const ends = (points_of_line) => [points_of_line[0], points_of_line.at(-1)].map((point) => ({ point, on_boundary: 1, degree: 1 }));
  const grid_nodes = lines.flatMap(ends);
  const middle_line = line([0, 0, -length / 2], [0, 0, length / 2], 8);
  const { vertices, triangles } = solid.surface;
  const tilt_at = ([x, y]) => 12 * Math.abs(Math.sin(2 * Math.atan2(y, x)));
  const face_of_triangle = (triangle) => face_of_bar([0, 1, 2].map((axis) => triangle.reduce((sum, vertex) => sum + vertices[vertex][axis] / 3, 0)), half, length / 2);
  const singularity = {
    arcs: 1, nodes: 0, arc_list: [{ type: "regular", index: 0.25, verdict: "meshable", place: [0, 0, 0] }], node_list: [],
    crease_list: Array.from({ length: 3 }, (_, k) => ({ hexahedra: 0, least_angle_deg: 30, verdict: "not_meshable", place: [half, half, 5 * k - 5] })), corner_list: [],
  };
  return assemble({
    solid, depth: 5, lattice: { low: [-20, -20, -20], unit: 1.25 }, arcs: [{ points: middle_line, index: 0.25 }], nodes: ends(middle_line),
    frame_at: frame_around(0.25),
    more: {
      header: { first_cut: "z", tets: { total: tets.length, shown: tets.length }, grid_surface: { triangles_total: triangles.length, triangles_shown: triangles.length }, ...more.header },
      arrays: {
        tet_points: ["f32", 3, points.flat()],
        tet_corners: ["u32", 4, tets.flat()],
        tet_frame: ["i16", 4, middles.flatMap((middle) => frame_around(0.25)(middle).map((part) => Math.round(32767 * part)))],
        tet_energy_density: ["u16", 0, energy.map(upper_half)],
        tet_alignment_deg: ["u16", 0, middles.map((middle, k) => upper_half(outside[k] ? tilt_at(middle) : -1))],
        surface_face: ["u32", 0, triangles.map(face_of_triangle)],
        surface_alignment_deg: ["u16", 0, vertices.map((vertex) => upper_half(tilt_at(vertex)))],
        surface_energy_density: ["u16", 0, vertices.map(([x, y]) => upper_half(0.2 / (x * x + y * y + 0.2)))],
        grid_surface_vertices: ["f32", 3, vertices.flat()],
        grid_surface_triangles: ["u32", 3, triangles.flat()],
        grid_arc_points: ["f32", 3, lines.flat(2)],
        grid_arc_starts: ["u32", 0, [0, 9, 18, 27, 36]],
        grid_arc_index: ["f32", 0, [0.25, -0.25, 0.25, -0.25]],
        grid_arc_type: ["u8", 0, [0, 0, 0, 0]],
        grid_arc_verdict: ["u8", 0, [0, 0, 0, 0]],
        grid_mark_points: ["f32", 3, grid_nodes.flatMap(({ point }) => point)],
        grid_mark_directions: ["f32", 3, grid_nodes.flatMap(() => [0, 0, 1])],
        grid_mark_shape: ["u8", 0, grid_nodes.map(() => 1)],
        grid_mark_verdict: ["u8", 0, grid_nodes.map(() => 0)],
        grid_mark_wall: ["f32", 0, grid_nodes.map(() => 20)],
        grid_node_verdict: ["u8", 0, grid_nodes.map(() => 0)],
        grid_node_on_boundary: ["u8", 0, grid_nodes.map(() => 1)],
        grid_node_degree: ["u8", 0, grid_nodes.map(() => 1)],
        ...more.arrays,
      },
    },
    report: {
      verdict: "not_meshable", answer: "hexahedra cannot follow this field at 10 10 -5: the edge of 30 degrees is too sharp for a hexahedron",
      reasons: [{ kind: "knife_edge", verdict: "not_meshable", count: 3, place: [half, half, -5], text: "the edge of 30 degrees is too sharp for a hexahedron" }],
      onto: { tets: tets.length, singularity, normal_deg: { mean: 1, p95: 2, max: 12 }, crease_deg: { mean: 1, p95: 2, max: 3 } },
      model: { path: "/parts/bar.vtk", triangles: triangles.length, watertight: true, components: 1, unit: "mm" },
      resolution: 32, input: { closed: true, findings: [] },
      ...more.report,
    },
  });
}
