// SPDX-License-Identifier: Apache-2.0
// Lines a pixel or two wide: creases, streamlines, boxes around cells.

import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

/** Segments of polylines; line k has points starts[k] ... starts[k + 1] - 1. */
export function segments_of(points: Float32Array, starts: Uint32Array): LineSegmentsGeometry {
  const segments: number[] = [];
  for (let line = 0; line + 1 < starts.length; ++line) {
    for (let point = starts[line]; point + 1 < starts[line + 1]; ++point) {
      for (let k = 0; k < 6; ++k) segments.push(points[3 * point + k]);
    }
  }
  // An instanced geometry without instances is drawn as garbage by some drivers.
  if (segments.length === 0) segments.push(0, 0, 0, 0, 0, 0);
  return new LineSegmentsGeometry().setPositions(segments);
}

/** The same, of some of the lines, each in its colour. */
export function coloured_segments(points: Float32Array, starts: Uint32Array, color_of: (line: number) => [number, number, number] | null): LineSegmentsGeometry {
  const segments: number[] = [];
  const colors: number[] = [];
  for (let line = 0; line + 1 < starts.length; ++line) {
    const color = color_of(line);
    if (!color) continue;
    for (let point = starts[line]; point + 1 < starts[line + 1]; ++point) {
      for (let k = 0; k < 6; ++k) segments.push(points[3 * point + k]);
      colors.push(...color, ...color);
    }
  }
  if (segments.length === 0) {
    segments.push(0, 0, 0, 0, 0, 0);
    colors.push(0, 0, 0, 0, 0, 0);
  }
  return new LineSegmentsGeometry().setPositions(segments).setColors(colors) as LineSegmentsGeometry;
}

export function line_material(width: number, opacity: number): LineMaterial {
  return new LineMaterial({ linewidth: width, transparent: opacity < 1, opacity, depthWrite: opacity >= 1, clipping: true });
}

/** The twelve edges of a cube as segments. */
export function box_edges([x, y, z]: [number, number, number], side: number): number[] {
  const corner = (k: number): number[] => [x + side * (k & 1), y + side * ((k >> 1) & 1), z + side * (k >> 2)];
  const edges: number[] = [];
  for (let k = 0; k < 8; ++k) for (const bit of [1, 2, 4]) if (!(k & bit)) edges.push(...corner(k), ...corner(k | bit));
  return edges;
}
