// SPDX-License-Identifier: Apache-2.0
// Real orthonormal spherical harmonics of degrees 3 and 4, and the coefficients that stand for a frame.
//
// Notation: Y_m, m = -l ... l, without the Condon-Shortley sign; h the unit coefficients of a frame. In degree 4 h is the normalised sum
// of Y over the three axes; in degree 3 it is that of (u.x)(v.x)(w.x), of which h and -h are the same frame.

import { axes_of, type Quaternion, type Vector } from "./frame.ts";

export type Degree = 3 | 4;

export const kReferenceZonal = Math.sqrt(7 / 12);
export const kReferenceFourfold = Math.sqrt(5 / 12);

/** The 2 degree + 1 harmonics at a unit vector. */
export function harmonics_at(degree: Degree, [x, y, z]: Vector): number[] {
  const xx = x * x;
  const yy = y * y;
  const zz = z * z;
  if (degree === 3) {
    const a = 0.25 * Math.sqrt(35 / (2 * Math.PI));
    const b = 0.25 * Math.sqrt(105 / Math.PI);
    const c = 0.25 * Math.sqrt(21 / (2 * Math.PI));
    const d = 0.25 * Math.sqrt(7 / Math.PI);
    return [
      a * y * (3 * xx - yy),
      2 * b * x * y * z,
      c * y * (5 * zz - 1),
      d * z * (5 * zz - 3),
      c * x * (5 * zz - 1),
      b * z * (xx - yy),
      a * x * (xx - 3 * yy),
    ];
  }
  const a = 0.75 * Math.sqrt(35 / Math.PI);
  const b = 0.75 * Math.sqrt(35 / (2 * Math.PI));
  const c = 0.75 * Math.sqrt(5 / Math.PI);
  const d = 0.75 * Math.sqrt(5 / (2 * Math.PI));
  return [
    a * x * y * (xx - yy),
    b * y * z * (3 * xx - yy),
    c * x * y * (7 * zz - 1),
    d * y * z * (7 * zz - 3),
    (3 / 16) * Math.sqrt(1 / Math.PI) * (35 * zz * zz - 30 * zz + 3),
    d * x * z * (7 * zz - 3),
    0.5 * c * (xx - yy) * (7 * zz - 1),
    b * x * z * (xx - 3 * yy),
    0.25 * a * (xx * xx - 6 * xx * yy + yy * yy),
  ];
}

/** The function that has these coefficients, at a unit vector. */
export function value_at(degree: Degree, coefficients: ArrayLike<number>, direction: Vector): number {
  const basis = harmonics_at(degree, direction);
  let sum = 0;
  for (let m = 0; m < basis.length; ++m) sum += coefficients[m] * basis[m];
  return sum;
}

/** The unit coefficients of a frame. */
export function coefficients_of(degree: Degree, frame: Quaternion): number[] {
  const [u, v, w] = axes_of(frame);
  if (degree === 4) return normalized(weighted_sum(4, [[1, u], [1, v], [1, w]]));
  // 24 abc = (a+b+c)^3 - (a+b-c)^3 - (a-b+c)^3 - (-a+b+c)^3, and the degree-3 part of a cube (d.x)^3 is a multiple of sum Y_m(d) Y_m(x).
  const diagonal = (a: number, b: number, c: number): Vector => {
    const scale = 1 / Math.sqrt(3);
    return [0, 1, 2].map((k) => scale * (a * u[k] + b * v[k] + c * w[k])) as Vector;
  };
  return normalized(weighted_sum(3, [[1, diagonal(1, 1, 1)], [-1, diagonal(1, 1, -1)], [-1, diagonal(1, -1, 1)], [-1, diagonal(-1, 1, 1)]]));
}

/** The unit coefficients of the harmonic that is symmetric about a direction. */
export function zonal_coefficients(degree: Degree, direction: Vector): number[] {
  return normalized(harmonics_at(degree, direction));
}

function weighted_sum(degree: Degree, terms: [number, Vector][]): number[] {
  const sum = new Array<number>(2 * degree + 1).fill(0);
  for (const [weight, direction] of terms) harmonics_at(degree, direction).forEach((value, m) => (sum[m] += weight * value));
  return sum;
}

function normalized(values: number[]): number[] {
  const length = Math.hypot(...values);
  return values.map((value) => value / length);
}
