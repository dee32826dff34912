// SPDX-License-Identifier: Apache-2.0
// The faces of the model: what the report says of each, and which triangles lie on it.

import { add, cross, length_of, scaled, subtract, type Vector } from "../math/frame.ts";
import type { Report } from "./report.ts";
import type { Scene } from "./scene.ts";

export interface ModelFace {
  /** As in the files. */
  number: number;
  /** What the report does not say is null. */
  kind: string | null;
  area: number | null;
  /** In the scene's coordinates. */
  center: Vector | null;
  /** Of the mesh of hexahedra; null without one. */
  quads: number | null;
}

/** Its set in hexahedra.inp; docs/formats.md. */
export const set_of = (number: number): string => `FACE_${number < 0 ? "MINUS_" : ""}${Math.abs(number)}`;

/** All faces with a number, ascending: those of the report, or without any there those that the scene names. */
export function faces_of_model(report: Report, scene: Scene | null): ModelFace[] {
  if (report.faces?.length) {
    return report.faces.map(({ number, kind, area, centre, quads }) =>
      ({ number, kind: kind ?? null, area: area ?? null, center: centre && scene ? subtract(centre, scene.origin) : null, quads: quads ?? null }));
  }
  const numbers = [...new Set(scene?.surface_face)].filter((number) => number !== 0).sort((a, b) => a - b);
  const quads = scene ? quads_of_faces(scene) : null;
  return numbers.map((number) => ({ number, kind: null, area: null, center: null, quads: quads && (quads.get(number) ?? 0) }));
}

/** How many sides of hexahedra lie on each face; null unless the scene has all of the mesh and names the faces of its sides. */
function quads_of_faces({ hexahedra }: Scene): Map<number, number> | null {
  if (!hexahedra || hexahedra.face.length === 0 || hexahedra.shape.length < hexahedra.total) return null;
  const counts = new Map<number, number>();
  for (const number of hexahedra.face) counts.set(number, (counts.get(number) ?? 0) + 1);
  return counts;
}

/** The number of the face that a triangle of the surface lies on; 0 for none. */
export const face_of_triangle = ({ surface_face }: Scene, triangle: number): number => surface_face[triangle] ?? 0;

/** Corners of the triangles on a face, nine numbers each. */
export function triangles_of_face({ surface_face, surface_triangles, surface_vertices }: Scene, number: number): Float32Array {
  const corners: number[] = [];
  surface_face.forEach((face, triangle) => {
    if (face !== number) return;
    for (let k = 0; k < 3; ++k) {
      const vertex = 3 * surface_triangles[3 * triangle + k];
      corners.push(surface_vertices[vertex], surface_vertices[vertex + 1], surface_vertices[vertex + 2]);
    }
  });
  return Float32Array.from(corners);
}

// The mean normal of a face that closes around something, such as a hole, says nothing: it is shorter than this share of the area.
const kLeastFacing = 0.3;

/** The mean normal of triangles; null where they face all ways. */
export function facing_of(corners: Float32Array): Vector | null {
  let sum: Vector = [0, 0, 0];
  let area = 0;
  for (let k = 0; k < corners.length; k += 9) {
    const at = (corner: number): Vector => [corners[k + corner], corners[k + corner + 1], corners[k + corner + 2]];
    const normal = cross(subtract(at(3), at(0)), subtract(at(6), at(0)));
    sum = add(sum, normal);
    area += length_of(normal);
  }
  const length = length_of(sum);
  return length > kLeastFacing * area ? scaled(sum, 1 / length) : null;
}

/** A point of these triangles near their middle: the centre of one of them. */
export function point_of(corners: Float32Array): Vector {
  const centers: Vector[] = [];
  for (let k = 0; k < corners.length; k += 9) centers.push([0, 1, 2].map((axis) => (corners[k + axis] + corners[k + 3 + axis] + corners[k + 6 + axis]) / 3) as Vector);
  const middle = scaled(centers.reduce(add, [0, 0, 0]), 1 / Math.max(1, centers.length));
  return centers.reduce((best, center) => (length_of(subtract(center, middle)) < length_of(subtract(best, middle)) ? center : best), centers[0] ?? middle);
}
