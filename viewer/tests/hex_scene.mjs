// SPDX-License-Identifier: Apache-2.0
// The bar of tets with the hexahedra that were made of it: cubes, of which one vertex is moved, so that eight are worse, and one is inverted.

import { tets_scene } from "./tet_scene.mjs";

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

export function hex_mesh() {
  const { points, hexahedra } = box_of_hexahedra([-kHalf, -kHalf, -kLength / 2], [2 * kHalf, 2 * kHalf, kLength], kCounts);
  const moved = points.findIndex((point) => point.every((value) => Math.abs(value) < 1e-9));
  points[moved] = [1, 0.8, 1.2];
  // Its top and bottom are exchanged.
  hexahedra[0] = [...hexahedra[0].slice(4), ...hexahedra[0].slice(0, 4)];
  return { points, hexahedra, shapes: hexahedra.map((corners) => scaled_jacobian(points, corners)) };
}

export function hexahedra_scene() {
  const { points, hexahedra, shapes } = hex_mesh();
  const mean = shapes.reduce((sum, shape) => sum + shape / shapes.length, 0);
  return tets_scene({
    header: { hexahedra: { total: hexahedra.length, shown: hexahedra.length, inverted: 1, mean } },
    arrays: {
      hex_points: ["f32", 3, points.flat()],
      hex_corners: ["u32", 8, hexahedra.flat()],
      hex_shape: ["f32", 0, shapes],
    },
    report: {
      hexahedra: {
        outcome: "partial", reason: "1 hexahedron is inverted", next: "mesh it with edges of 3.6", places: [[-8, -8, -18]], hexahedra: hexahedra.length,
        scaled_jacobian: { min: Math.min(...shapes), mean, inverted: 1, worst_place: [-8, -8, -18] },
      },
    },
  });
}
