// SPDX-License-Identifier: Apache-2.0
// What places and parts of the surface are called.

import assert from "node:assert/strict";
import test from "node:test";

import { coordinates } from "../src/ui/dom.ts";
import { advice_on } from "../src/ui/advice.ts";
import { face_title, noun_of, sets_text } from "../src/ui/face_table.ts";
import { lacking, mesh_places } from "../src/ui/mesh_summary.ts";

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

const face = (number, quads) => ({ number, kind: "plane", area: 1, center: null, quads });

test("sets are named of files that there are, by a face that has quads", () => {
  const hexahedra = { outcome: "all-hex", hexahedra: 8, scaled_jacobian: { min: 1, mean: 1, inverted: 0 } };
  const faces = [face(4, 0), face(5, 9)];
  assert.equal(sets_text(faces, { hexahedra }), "Face 5 is the set FACE_5 of hexahedra.inp and the group “face 5” of hexahedra.msh.");
  assert.match(sets_text(faces, { hexahedra: { ...hexahedra, outcome: "partial" } }), /of hexahedra\.partial\.inp and/);
  assert.equal(sets_text([face(4, 0)], { hexahedra }), "");
  assert.equal(sets_text(faces, { hexahedra: { ...hexahedra, scaled_jacobian: { min: -1, mean: 1, inverted: 1 } } }), "");
  assert.equal(sets_text([face(5, null)], {}), "");
});

test("the worst hexahedron of a mesh of boxes is no place to look at", () => {
  const places = (min) => mesh_places({ hexahedra: { outcome: "all-hex", hexahedra: 8, scaled_jacobian: { min, mean: 1, inverted: 0, worst_place: [0, 0, 0] } } }, null, [0, 0, 0]);
  assert.deepEqual(places(1 - 1e-12), []);
  assert.deepEqual(places(0.7).map(({ label }) => label), ["Worst hexahedron"]);
});

test("remedies are told in the options that the terminal names", () => {
  assert.equal(advice_on("take_smaller_hexahedra", undefined, "take smaller hexahedra"), "lower --size, or raise --cells");
  assert.equal(advice_on("use_edge_length", 3.6, "take tets with edges of 3.6"), "try --tet-size 3.6");
  assert.equal(advice_on("cut_corner", undefined, "cut the corner off"), "cut the corner off");
  assert.equal(advice_on(undefined, undefined, undefined), "");
});

test("a part of the model says how many cells it lacks, and where", () => {
  assert.equal(lacking({ outcome: "partial", hexahedra: 8, left_out: 1, left_out_place: [1, 2, 3] }), "1 cell left out near 1, 2, 3");
  assert.equal(lacking({ outcome: "all-hex", hexahedra: 8, left_out: 0 }), "");
});
