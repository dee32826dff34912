// SPDX-License-Identifier: Apache-2.0
// The bar of tets with the hexahedra that were made of it: cubes, of which one vertex is moved, so that eight are worse, and one is inverted.

import { face_of_bar, tets_scene } from "./tet_scene.mjs";

const [kHalf, kLength, kCubes] = [10, 40, 6];
const kCounts = [kCubes, kCubes, 2 * kCubes];

/** Points, and hexahedra as eight numbers of points each, of a box of cubes. */
export function box_of_hexahedra(low, size, counts) {
  const points = [];
  const number = (i, j, k) => (k * (counts[1] + 1) + j) * (counts[0] + 1) + i;
  for (let k = 0; k <= counts[2]; ++k) for (let j = 0; j <= counts[1]; ++j) for (let i = 0; i <= counts[0]; ++i) {
    points.push([i, j, k].map((step, axis) => low[axis] + (step * size[axis]) / counts[axis]));
  }
  const hexahedra = [];
  for (let k = 0; k < counts[2]; ++k) for (let j = 0; j < counts[1]; ++j) for (let i = 0; i < counts[0]; ++i) {
    const around = (level) => [number(i, j, level), number(i + 1, j, level), number(i + 1, j + 1, level), number(i, j + 1, level)];
    hexahedra.push([...around(k), ...around(k + 1)]);
  }
  return { points, hexahedra };
}

const kNext = [[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]];

export function scaled_jacobian(points, corners) {
  return Math.min(...kNext.map((next, corner) => {
    const [a, b, c] = next.map((other) => {
      const edge = points[corners[other]].map((value, k) => value - points[corners[corner]][k]);
      return edge.map((value) => value / Math.hypot(...edge));
    });
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }));
}

/** With `inverted` the first of them, at a corner of the bar; without, the worst one is inside. */
export function hex_mesh(inverted = true) {
  const { points, hexahedra } = box_of_hexahedra([-kHalf, -kHalf, -kLength / 2], [2 * kHalf, 2 * kHalf, kLength], kCounts);
  const moved = points.findIndex((point) => point.every((value) => Math.abs(value) < 1e-9));
  points[moved] = [1, 0.8, 1.2];
  // Its top and bottom are exchanged.
  if (inverted) hexahedra[0] = [...hexahedra[0].slice(4), ...hexahedra[0].slice(0, 4)];
  const shapes = hexahedra.map((corners) => scaled_jacobian(points, corners));
  const worst = shapes.indexOf(Math.min(...shapes));
  return { points, hexahedra, shapes, worst, worst_place: center_of(points, hexahedra[worst]) };
}

export const center_of = (points, corners) => [0, 1, 2].map((axis) => corners.reduce((sum, point) => sum + points[point][axis] / corners.length, 0));

const kFaces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/** Of each hexahedron the faces of the bar that its six sides lie on; 0 inside. */
export const faces_of_sides = ({ points, hexahedra }) => hexahedra.map((corners) => kFaces.map((face) => face_of_bar(center_of(points, face.map((corner) => corners[corner])), kHalf, kLength / 2)));

/** Numbers of the regions of the mesh without an inverted hexahedron, and the place among them of its lower half and of its upper one. */
export const kRegions = [3, 8];
export const region_at = ([, , z]) => Number(z > 0);

export function hexahedra_scene(inverted = true) {
  const mesh = hex_mesh(inverted);
  const { points, hexahedra, shapes, worst_place } = mesh;
  const mean = shapes.reduce((sum, shape) => sum + shape / shapes.length, 0);
  const faces = faces_of_sides(mesh).flat();
  const quads = (number) => faces.filter((face) => face === number).length;
  const failed = inverted ? { outcome: "partial", reason: "1 hexahedron is inverted", next: "take tets with edges of 3.6", places: [worst_place] } : { outcome: "all-hex" };
  return tets_scene({
    header: { ...(inverted ? {} : { hex_regions: kRegions }), hexahedra: { total: hexahedra.length, shown: hexahedra.length, inverted: Number(inverted), mean } },
    arrays: {
      hex_points: ["f32", 3, points.flat()],
      hex_corners: ["u32", 8, hexahedra.flat()],
      hex_shape: ["f32", 0, shapes],
      ...(inverted ? { hex_inverted: ["u8", 0, shapes.map((shape) => Number(shape <= 0))] } : {}),
      hex_face: ["u32", 6, faces],
      ...(inverted ? {} : { hex_region: ["u16", 0, hexahedra.map((corners) => region_at(center_of(points, corners)))] }),
    },
    report: {
      hexahedra: {
        ...failed, hexahedra: hexahedra.length, expected: 250, size: 4, used_size: 10 / 3, mean_edge: 10 / 3,
        scaled_jacobian: { min: Math.min(...shapes), mean, inverted: Number(inverted), worst_place },
        volume: 15980, model_volume: 16000, area: 4008, model_area: 4000, model: "cad", largest_distance: 0.134, largest_distance_place: [10, 10, 0],
        largest_distance_of_model: 0.1, largest_distance_of_model_place: [-10, 10, 0],
        way: "attempt 1 of 2: field on 8748 tets of 2, repaired",
      },
      files: [{ name: "hexahedra.hexex" }, { name: "onto.frames" }],
      // The mesh lacks one of the faces that the model has.
      faces: [
        ...[1, 2, 3, 4].map((number) => ({ number, kind: "plane", area: 800, centre: [[-10, 0, 0], [10, 0, 0], [0, -10, 0], [0, 10, 0]][number - 1], quads: quads(number) })),
        ...[5, 6].map((number) => ({ number, kind: "plane", area: 400, centre: [0, 0, number === 5 ? -20 : 20], quads: quads(number) })),
        { number: 7, kind: "cylinder", area: 0.8, centre: [10, 10, 20], quads: 0 },
      ],
    },
  });
}
