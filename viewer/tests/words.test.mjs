// SPDX-License-Identifier: Apache-2.0
// What places and parts of the surface are called.

import assert from "node:assert/strict";
import test from "node:test";

import { coordinates } from "../src/ui/dom.ts";
import { face_title, noun_of } from "../src/ui/face_table.ts";

test("coordinates that are rounding are 0", () => {
  assert.equal(coordinates([-1.1e-15, 2, -0]), "0, 2, 0");
  assert.equal(coordinates([106.123, 51, 1e-4]), "106.1, 51, 0");
  assert.equal(coordinates([0, 0, 0]), "0, 0, 0");
});

test("surfaces of triangles have patches, other models faces", () => {
  assert.equal(noun_of("patch"), "Patch");
  assert.equal(noun_of("plane"), "Face");
  assert.equal(face_title({ number: 4, kind: "patch", area: 1, center: null, quads: null }), "Patch 4");
  assert.equal(face_title({ number: 4, kind: "plane", area: 1, center: null, quads: null }), "Face 4 · plane");
  assert.equal(face_title({ number: 4, kind: null, area: 1, center: null, quads: null }), "Face 4");
});
