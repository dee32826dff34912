// SPDX-License-Identifier: Apache-2.0
// Normals for shading: smooth over faces that nearly go on, sharp at creases. One normal a corner of a triangle.

import type { Scene } from "../scene/scene.ts";

// As in the solver, a crease is where normals are more than 35 degrees apart.
const kCreaseCosine = Math.cos((35 * Math.PI) / 180);

/** Positions and normals, nine numbers a triangle each. */
export function shaded_triangles(scene: Scene): { positions: Float32Array; normals: Float32Array } {
  const vertices = scene.surface_vertices;
  const triangles = scene.surface_triangles;
  const count = triangles.length / 3;
  const positions = new Float32Array(9 * count);
  const faces = new Float32Array(3 * count); // normals times twice the area
  for (let t = 0; t < count; ++t) {
    for (let corner = 0; corner < 3; ++corner) {
      const vertex = triangles[3 * t + corner];
      for (let k = 0; k < 3; ++k) positions[9 * t + 3 * corner + k] = vertices[3 * vertex + k];
    }
    const p = 9 * t;
    const ax = positions[p + 3] - positions[p], ay = positions[p + 4] - positions[p + 1], az = positions[p + 5] - positions[p + 2];
    const bx = positions[p + 6] - positions[p], by = positions[p + 7] - positions[p + 1], bz = positions[p + 8] - positions[p + 2];
    faces[3 * t] = ay * bz - az * by;
    faces[3 * t + 1] = az * bx - ax * bz;
    faces[3 * t + 2] = ax * by - ay * bx;
  }
  return { positions, normals: corner_normals(triangles, faces, vertices.length / 3) };
}

function corner_normals(triangles: Uint32Array, faces: Float32Array, vertices: number): Float32Array {
  const starts = new Uint32Array(vertices + 1);
  for (const vertex of triangles) starts[vertex + 1]++;
  for (let v = 0; v < vertices; ++v) starts[v + 1] += starts[v];
  const around = new Uint32Array(triangles.length);
  const next = starts.slice();
  for (let corner = 0; corner < triangles.length; ++corner) around[next[triangles[corner]]++] = Math.floor(corner / 3);

  const lengths = new Float32Array(faces.length / 3);
  for (let t = 0; t < lengths.length; ++t) lengths[t] = Math.hypot(faces[3 * t], faces[3 * t + 1], faces[3 * t + 2]);
  const normals = new Float32Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; ++corner) {
    const own = Math.floor(corner / 3);
    const vertex = triangles[corner];
    let x = 0, y = 0, z = 0;
    for (let k = starts[vertex]; k < starts[vertex + 1]; ++k) {
      const other = around[k];
      const cosine = faces[3 * own] * faces[3 * other] + faces[3 * own + 1] * faces[3 * other + 1] + faces[3 * own + 2] * faces[3 * other + 2];
      if (other !== own && cosine < kCreaseCosine * lengths[own] * lengths[other]) continue;
      x += faces[3 * other];
      y += faces[3 * other + 1];
      z += faces[3 * other + 2];
    }
    const length = Math.hypot(x, y, z) || 1;
    normals[3 * corner] = x / length;
    normals[3 * corner + 1] = y / length;
    normals[3 * corner + 2] = z / length;
  }
  return normals;
}
