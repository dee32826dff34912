// SPDX-License-Identifier: Apache-2.0
// The page's harmonics against docs/design.md, sections 1 to 3.

import assert from "node:assert/strict";
import { test } from "node:test";

import { axes_of, product, quaternion_of, tilt_deg, turn_deg } from "../src/math/frame.ts";
import { coefficients_of, harmonics_at, value_at } from "../src/math/harmonics.ts";
import { eigenvalues, form_value, unpacked } from "../src/math/symmetric_matrix.ts";
import { plane_form } from "./plane_forms.mjs";

const kIdentity = [1, 0, 0, 0];
const kSomeFrame = [0.8, 0.3, -0.4, 0.33166247903554];

const near = (a, b, tolerance = 1e-12) => a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) < tolerance, `${a} is not ${b}`));

/** The 24 rotations of the cube as quaternions. */
function cube_rotations() {
  const found = [];
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  for (let i = 0; i < 3; ++i) for (let j = 0; j < 3; ++j) for (const s of [1, -1]) for (const t of [1, -1]) {
    if (i === j) continue;
    const u = axes[i].map((value) => s * value);
    const v = axes[j].map((value) => t * value);
    found.push(quaternion_of([u, v, cross(u, v)]));
  }
  return found;
}

test("the reference frame of degree 4 is sqrt(7/12) at m = 0 and sqrt(5/12) at m = 4", () => {
  near(coefficients_of(4, kIdentity), [0, 0, 0, 0, Math.sqrt(7 / 12), 0, 0, 0, Math.sqrt(5 / 12)]);
});

test("the reference frame of degree 3 is the harmonic of m = -2", () => {
  near(coefficients_of(3, kIdentity), [0, 1, 0, 0, 0, 0, 0]);
});

test("degree 4 is the same for the 24 frames that are the same", () => {
  const rotations = cube_rotations();
  assert.equal(rotations.length, 24);
  for (const turn of rotations) near(coefficients_of(4, product(kSomeFrame, turn)), coefficients_of(4, kSomeFrame));
});

test("degree 3 is the same up to sign", () => {
  const h = coefficients_of(3, kSomeFrame);
  for (const turn of cube_rotations()) {
    const other = coefficients_of(3, product(kSomeFrame, turn));
    const sign = Math.sign(h.reduce((sum, value, m) => sum + value * other[m], 0));
    near(other.map((value) => sign * value), h);
  }
});

test("harmonics are orthonormal", () => {
  // A product rule that is exact to degree 9: Gauss points of 5 in z, 12 around.
  const nodes = [0, 0.5384693101056831, 0.906179845938664];
  const weights = [0.5688888888888889, 0.4786286704993665, 0.2369268850561891];
  for (const degree of [3, 4]) {
    const size = 2 * degree + 1;
    const gram = Array.from({ length: size }, () => new Array(size).fill(0));
    for (const k of [0, 1, 2]) for (const sign of k === 0 ? [1] : [1, -1]) for (let j = 0; j < 12; ++j) {
      const z = sign * nodes[k];
      const angle = (Math.PI * j) / 6;
      const y = harmonics_at(degree, [Math.sqrt(1 - z * z) * Math.cos(angle), Math.sqrt(1 - z * z) * Math.sin(angle), z]);
      y.forEach((a, m) => y.forEach((b, n) => (gram[m][n] += weights[k] * (Math.PI / 6) * a * b)));
    }
    gram.forEach((row, m) => near(row, row.map((_, n) => (m === n ? 1 : 0)), 1e-12));
  }
});

test("the harmonic of a frame is largest along its axes", () => {
  const h = coefficients_of(4, kSomeFrame);
  const along = axes_of(kSomeFrame).map((axis) => value_at(4, h, axis));
  near(along, [along[0], along[0], along[0]]);
  for (let k = 0; k < 200; ++k) {
    const z = 1 - (2 * k + 1) / 200;
    const angle = 2.399963 * k;
    const direction = [Math.sqrt(1 - z * z) * Math.cos(angle), Math.sqrt(1 - z * z) * Math.sin(angle), z];
    assert.ok(value_at(4, h, direction) <= along[0] + 1e-12);
  }
});

test("the form of a plane has eigenvalues 0 twice and 1 seven times, and nothing to say against frames along its normal", () => {
  const normal = axes_of(kSomeFrame)[1];
  const { matrix, linear, constant } = plane_form(normal);
  near(eigenvalues(unpacked(matrix, 9)), [0, 0, 1, 1, 1, 1, 1, 1, 1]);
  assert.ok(Math.abs(form_value(unpacked(matrix, 9), linear, constant, coefficients_of(4, kSomeFrame))) < 1e-12);
});

test("tilting the normal by t costs 20/3 t^2", () => {
  const t = 1e-3;
  const { matrix, linear, constant } = plane_form([0, 0, 1]);
  const tilted = coefficients_of(4, [Math.cos(t / 2), Math.sin(t / 2), 0, 0]);
  const cost = form_value(unpacked(matrix, 9), linear, constant, tilted);
  assert.ok(Math.abs(cost / ((20 / 3) * t * t) - 1) < 1e-3, `${cost}`);
});

test("eigenvalues of a matrix with known ones", () => {
  near(eigenvalues([[2, 1, 0], [1, 2, 0], [0, 0, -5]]), [-5, 1, 3]);
});

test("quaternions and axes are inverse to each other", () => {
  for (const turn of cube_rotations()) {
    const frame = product(kSomeFrame, turn);
    const back = quaternion_of(axes_of(frame));
    const sign = Math.sign(frame.reduce((sum, value, k) => sum + value * back[k], 0));
    near(back.map((value) => sign * value), frame);
  }
});

test("tilt is 0 along an axis and 54.7 degrees along a diagonal; turn is that of a frame turned in the plane", () => {
  const axes = axes_of(kIdentity);
  assert.equal(tilt_deg(axes, [0, 0, 1]), 0);
  assert.ok(Math.abs(tilt_deg(axes, [1, 1, 1].map((value) => value / Math.sqrt(3))) - 54.7356) < 1e-3);
  const angle = (25 * Math.PI) / 180;
  assert.ok(Math.abs(turn_deg(axes_of([Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)]), [0, 0, 1], [1, 0, 0]) - 25) < 1e-9);
});
