// SPDX-License-Identifier: Apache-2.0
// Forms and classes of the cells of a test scene, summed from small pieces of its surface (docs/design.md, "Spectral boundary conditions").

import { harmonics_at, kReferenceFourfold, kReferenceZonal, coefficients_of, zonal_coefficients } from "../src/math/harmonics.ts";
import { cross, quaternion_of, tangents_of, tilt_deg, axes_of, unit } from "../src/math/frame.ts";
import { eigenvalues, unpacked } from "../src/math/symmetric_matrix.ts";

/** The degree-4 form of one unit of area with this normal: upper triangle of I - P, b, c. */
export function plane_form(normal) {
  const zonal = zonal_coefficients(4, normal);
  const [u, v] = tangents_of(normal);
  const pair = [0, Math.PI / 8].map((turn) => {
    const first = [0, 1, 2].map((k) => Math.cos(turn) * u[k] + Math.sin(turn) * v[k]);
    const h = coefficients_of(4, quaternion_of([first, cross(normal, first), normal]));
    return h.map((value, m) => (value - kReferenceZonal * zonal[m]) / kReferenceFourfold);
  });
  const matrix = [];
  for (let row = 0; row < 9; ++row) {
    for (let column = row; column < 9; ++column) {
      matrix.push((row === column ? 1 : 0) - pair[0][row] * pair[0][column] - pair[1][row] * pair[1][column]);
    }
  }
  return { matrix, linear: zonal.map((value) => kReferenceZonal * value), constant: 7 / 12 };
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** Splits triangles until no edge is longer than `longest`; yields [centroid, normal, area], the normal as one object for all pieces of a triangle. */
function* pieces(surface, longest) {
  const stack = surface.triangles.map((triangle) => {
    const [a, b, c] = triangle.map((corner) => surface.vertices[corner]);
    return [a, b, c, unit(cross(minus(b, a), minus(c, a)))];
  });
  while (stack.length > 0) {
    const [a, b, c, normal] = stack.pop();
    const edges = [[a, b], [b, c], [c, a]].map(([p, q]) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    const worst = edges.indexOf(Math.max(...edges));
    if (edges[worst] > longest) {
      const [p, q, r] = [[a, b, c], [b, c, a], [c, a, b]][worst];
      const middle = [0, 1, 2].map((k) => (p[k] + q[k]) / 2);
      stack.push([p, middle, r, normal], [middle, q, r, normal]);
      continue;
    }
    const doubled = Math.hypot(...cross(minus(b, a), minus(c, a)));
    if (doubled > 0) yield [[0, 1, 2].map((k) => (a[k] + b[k] + c[k]) / 3), normal, doubled / 2];
  }
}

/** Gives cells their class and alignment, and returns the forms. `find` is (point) => cell number or -1. */
export function add_forms(surface, cells, lattice, find) {
  const sums = new Map();
  const forms = new Map(); // of normals
  for (const [point, normal, area] of pieces(surface, 0.6 * lattice.unit)) {
    const inside = [0, 1, 2].map((k) => point[k] - 1e-4 * lattice.unit * normal[k]);
    const cell = find(inside);
    if (cell < 0) continue;
    const sum = sums.get(cell) ?? { matrix: new Array(45).fill(0), linear: new Array(9).fill(0), constant: 0, weight: 0, tilt: 0 };
    sums.set(cell, sum);
    const form = forms.get(normal) ?? plane_form(normal);
    forms.set(normal, form);
    form.matrix.forEach((value, k) => (sum.matrix[k] += area * value));
    form.linear.forEach((value, k) => (sum.linear[k] += area * value));
    sum.constant += area * form.constant;
    sum.weight += area;
    sum.tilt += area * tilt_deg(axes_of(cells[cell].frame), normal);
  }
  for (const [cell, sum] of sums) {
    cells[cell].class = class_of(sum);
    cells[cell].alignment = sum.tilt / sum.weight;
  }
  return [...sums].sort((a, b) => a[0] - b[0]).map(([cell, sum]) => ({ cell, ...sum }));
}

// Rough: enough to give a scene cells of each class. The program's own table is src/constraint's.
function class_of(sum) {
  const values = eigenvalues(unpacked(sum.matrix, 9)).map((value) => value / sum.weight);
  if (values[1] < 0.02) return 1;
  if (values[8] - values[0] < 0.1) return 4;
  if (values[0] < 0.45) return values[1] - values[0] < 0.05 ? 2 : 3;
  return values[0] < 0.6 ? 3 : 5;
}

export { harmonics_at };
