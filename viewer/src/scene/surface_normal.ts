// SPDX-License-Identifier: Apache-2.0
// Which way the surface faces at a place.

import { cross, dot, length_of, scaled, subtract, type Vector } from "../math/frame.ts";
import type { Scene } from "./scene.ts";

/** The outward unit normal of the triangle nearest to a point; x where there are none. */
export function surface_normal({ surface_vertices, surface_triangles }: Pick<Scene, "surface_vertices" | "surface_triangles">, point: Vector): Vector {
  let [best, least]: [Vector, number] = [[1, 0, 0], Infinity];
  const at = (corner: number): Vector => [0, 1, 2].map((axis) => surface_vertices[3 * surface_triangles[corner] + axis]) as Vector;
  for (let corner = 0; corner < surface_triangles.length; corner += 3) {
    const [a, b, c] = [at(corner), at(corner + 1), at(corner + 2)];
    const normal = cross(subtract(b, a), subtract(c, a));
    const size = length_of(normal);
    if (size === 0) continue;
    const distance = distance_to_triangle(point, [a, b, c], scaled(normal, 1 / size));
    if (distance < least) [best, least] = [scaled(normal, 1 / size), distance];
  }
  return best;
}

/** From a point, to a triangle with this unit normal. */
function distance_to_triangle(point: Vector, corners: Vector[], normal: Vector): number {
  const sides = corners.map((corner, k) => subtract(corners[(k + 1) % 3], corner));
  const from = corners.map((corner) => subtract(point, corner));
  if (sides.every((side, k) => dot(cross(side, from[k]), normal) >= 0)) return Math.abs(dot(from[0], normal));
  return Math.min(...sides.map((side, k) => {
    const share = Math.min(1, Math.max(0, dot(from[k], side) / dot(side, side)));
    return length_of(subtract(from[k], scaled(side, share)));
  }));
}
