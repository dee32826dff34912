// SPDX-License-Identifier: Apache-2.0
// The bar of hexahedra as a lattice makes them: without a field, and beside the field along which maps were tried.

import { faces_of_sides, hex_mesh, hexahedra_scene } from "./hex_scene.mjs";
import { encode_scene } from "./scene_writer.mjs";
import { bar } from "./solids.mjs";
import { face_of_bar } from "./tet_scene.mjs";

const kAttempt = { kind: "lattice", number: 1 };
const kFeatures = {
  corners: { all: 8, kept: 8 }, creases: { all: 12, kept: 11 }, faces: { all: 6, kept: 6 }, of_mesh: { largest_in_all: 0.06 }, of_model: { largest_in_all: 0.01 },
  lacking: [{ kind: "crease", number: 5, place: [10, 10, 0], figure: 0.1, share: 0.5 }], too_small: [], small: 0,
};

/** What a report without a field has of one. */
const kNoField = {
  verdict: "undecided", answer: "undecided, because nothing was judged", reasons: [], degree: 4, resolution: 0, levels: [], energy: { smoothness: 0, boundary: 0, unavoidable: 0, total: 0 },
  alignment_deg: { mean: null, p95: null, max: null, excluded_share: 0 }, singularity: { arcs: 0, nodes: 0, arc_list: [], node_list: [], crease_list: [], corner_list: [] },
  input: { closed: false, findings: [] },
};

export function lattice_scene() {
  const mesh = hex_mesh(false);
  const { points, hexahedra, shapes } = mesh;
  const [half, length] = [10, 40];
  const { surface, creases } = bar(half, length / 2);
  const { vertices, triangles } = surface;
  const face_of = (triangle) => face_of_bar([0, 1, 2].map((axis) => triangle.reduce((sum, vertex) => sum + vertices[vertex][axis] / 3, 0)), half, length / 2);
  const { report } = hexahedra_scene(false);
  const starts = creases.reduce((all, line) => [...all, all.at(-1) + line.length], [0]);
  const scene = encode_scene({
    origin: [0, 0, 0], unit: "mm", low: [-half, -half, -length / 2], high: [half, half, length / 2], first_cut: "y",
    surface: { triangles_total: triangles.length, triangles_shown: triangles.length },
    hexahedra: { total: hexahedra.length, shown: hexahedra.length, inverted: 0, mean: report.hexahedra.scaled_jacobian.mean },
  }, {
    surface_vertices: ["f32", 3, vertices.flat()],
    surface_triangles: ["u32", 3, triangles.flat()],
    surface_face: ["u32", 0, triangles.map(face_of)],
    crease_points: ["f32", 3, creases.flat(2)],
    crease_starts: ["u32", 0, starts],
    hex_points: ["f32", 3, points.flat()],
    hex_corners: ["u32", 8, hexahedra.flat()],
    hex_shape: ["f32", 0, shapes],
    hex_face: ["u32", 6, faces_of_sides(mesh).flat()],
  });
  const { model, seconds, faces } = report;
  return {
    scene,
    report: {
      ...kNoField, model, seconds, faces, files: [{ name: "report.html" }], warnings: [{ kind: "faces_without_quads", text: "1 of 7 faces has no quads: 7" }],
      hexahedra: { ...report.hexahedra, attempts: [kAttempt], best_attempt: 0, features: kFeatures, way: "attempt 1 of 1: lattice, fitted to the model" },
    },
  };
}

/** Of `crossgrain fit`: hexahedra that were given. */
export function fitted_scene() {
  const { scene, report } = lattice_scene();
  return { scene, report: { ...report, warnings: [], hexahedra: { ...report.hexahedra, attempts: [], way: "fitted to the model" } } };
}

/** Of `crossgrain hex` where no map was taken. */
export function fallback_scene() {
  const { scene, report } = hexahedra_scene(false);
  const attempts = [{ kind: "tets" }, { kind: "repair", number: 1 }, { ...kAttempt, number: 2 }];
  const map_fault = "layers of hexahedra are folded at 1 2 3";
  return {
    scene,
    report: {
      ...report, warnings: [{ kind: "not_settled", text: "the sweeps on the grid ran out" }, { kind: "faces_without_quads", text: "1 of 7 faces has no quads: 7" }],
      hexahedra: { ...report.hexahedra, attempts, best_attempt: 2, map_fault, features: kFeatures, way: `attempt 2 of 2: lattice; no map, since ${map_fault}` },
    },
  };
}
