// SPDX-License-Identifier: Apache-2.0
// Frames as unit quaternions (w, x, y, z), and small vector algebra on plain triples.

export type Vector = [number, number, number];
export type Quaternion = [number, number, number, number];

/** The three unit axes: what the rotation makes of x, y and z. */
export function axes_of([w, x, y, z]: Quaternion): [Vector, Vector, Vector] {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
    [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
    [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/** The quaternion of a rotation given by its axes, which are right-handed and orthonormal. */
export function quaternion_of([u, v, w]: [Vector, Vector, Vector]): Quaternion {
  const trace = u[0] + v[1] + w[2];
  // The largest of the four components is computed by a square root, the others by division by it, so that nothing cancels.
  const squares = [1 + trace, 1 + 2 * u[0] - trace, 1 + 2 * v[1] - trace, 1 + 2 * w[2] - trace];
  const largest = squares.indexOf(Math.max(...squares));
  const root = Math.sqrt(squares[largest]) * 2;
  switch (largest) {
    case 0:
      return [root / 4, (v[2] - w[1]) / root, (w[0] - u[2]) / root, (u[1] - v[0]) / root];
    case 1:
      return [(v[2] - w[1]) / root, root / 4, (u[1] + v[0]) / root, (w[0] + u[2]) / root];
    case 2:
      return [(w[0] - u[2]) / root, (u[1] + v[0]) / root, root / 4, (v[2] + w[1]) / root];
    default:
      return [(u[1] - v[0]) / root, (w[0] + u[2]) / root, (v[2] + w[1]) / root, root / 4];
  }
}

export function product(a: Quaternion, b: Quaternion): Quaternion {
  return [
    a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
    a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
    a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
    a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
  ];
}

export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: Vector, factor: number): Vector => [a[0] * factor, a[1] * factor, a[2] * factor];
export const length_of = (a: Vector): number => Math.hypot(a[0], a[1], a[2]);
export const unit = (a: Vector): Vector => scaled(a, 1 / (length_of(a) || 1));

/** Two unit vectors that complete a unit normal to a right-handed frame (first, second, normal). */
export function tangents_of(normal: Vector): [Vector, Vector] {
  // Crossing with the axis that the normal is least along keeps the result well away from zero.
  const least = [0, 1, 2].reduce((best, k) => (Math.abs(normal[k]) < Math.abs(normal[best]) - 1e-9 ? k : best), 0);
  const helper: Vector = [0, 0, 0];
  helper[least] = 1;
  const first = unit(cross(helper, normal));
  return [first, cross(normal, first)];
}

/** Angle in degrees between a direction and the nearest axis of a frame: 0 to 54.7. */
export function tilt_deg(axes: [Vector, Vector, Vector], direction: Vector): number {
  const cosine = Math.max(...axes.map((axis) => Math.abs(dot(axis, direction))));
  return (Math.acos(Math.min(1, cosine)) * 180) / Math.PI;
}

/** How far the axis that lies flattest in a plane is turned in it from a first direction, in degrees: 0 to 90, cyclic. */
export function turn_deg(axes: [Vector, Vector, Vector], normal: Vector, first: Vector): number {
  const second = cross(normal, first);
  // Fourfold average over all axes: each projection counts with the fourth power of its length, and an axis along the normal not at all.
  let cosine = 0;
  let sine = 0;
  for (const axis of axes) {
    const x = dot(axis, first);
    const y = dot(axis, second);
    const angle = 4 * Math.atan2(y, x);
    const weight = (x * x + y * y) ** 2;
    cosine += weight * Math.cos(angle);
    sine += weight * Math.sin(angle);
  }
  const turn = (Math.atan2(sine, cosine) * 180) / Math.PI / 4;
  return (turn + 90) % 90;
}
