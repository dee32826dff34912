// SPDX-License-Identifier: Apache-2.0
// What places and parts of the surface are called.

import assert from "node:assert/strict";
import test from "node:test";

import { coordinates, duration, memory } from "../src/ui/dom.ts";
import { advice_on } from "../src/ui/advice.ts";
import { face_title, noun_of, sets_text } from "../src/ui/face_table.ts";
import { kept_text, lacking, mesh_places } from "../src/ui/mesh_summary.ts";

test("coordinates that are rounding are 0", () => {
  assert.equal(coordinates([-1.1e-15, 2, -0]), "0, 2, 0");
  assert.equal(coordinates([106.123, 51, 1e-4]), "106.1, 51, 0");
  assert.equal(coordinates([0, 0, 0]), "0, 0, 0");
});

test("what is rounded up goes over to the next unit", () => {
  assert.deepEqual([0.0001, 0.9996, 59.96, 99.96, 119.4, 119.869861579, 179.6, 3600].map(duration), ["1 ms", "1 s", "60 s", "100 s", "1 min 59 s", "2 min 0 s", "3 min 0 s", "60 min 0 s"]);
  assert.deepEqual([83e6, 999.4e6, 999.6e6, 1.26e9].map(memory), ["83 MB", "999 MB", "1.0 GB", "1.3 GB"]);
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

test("a place that fails is told in the words of the reason", () => {
  const reason = "it is up to 1.2 of a hexahedron off the surface around 35.238 0.245 4.976; the surface is up to 0.36 of a hexahedron from it, around 33.925 -1.888 5.22, and badly shaped (worst scaled Jacobian 0.02 at 34.767 -3.192 7.372)";
  const places = [[34.766609, -3.191738, 7.371579], [35.238043, 0.244521, 4.975738], [33.92455, -1.888372, 5.22], [1, 2, 3], [4, 5, 6]];
  const named = mesh_places({ hexahedra: { outcome: "approximate", hexahedra: 8, reason, places, left_out_place: [1, 2, 3] } }, null, [0, 0, 0]);
  assert.deepEqual(named.map(({ label }) => label), [
    "Badly shaped", "It is up to 1.2 of a hexahedron off the surface", "The surface is up to 0.36 of a hexahedron from it", "Cell left out", "Place of the reason"]);
  assert.equal(named[1].detail, "35.24, 0.2445, 4.976");
});

test("the worst hexahedron of a mesh of boxes is no place to look at", () => {
  const places = (min) => mesh_places({ hexahedra: { outcome: "all-hex", hexahedra: 8, scaled_jacobian: { min, mean: 1, inverted: 0, worst_place: [0, 0, 0] } } }, null, [0, 0, 0]);
  assert.deepEqual(places(1 - 1e-12), []);
  assert.deepEqual(places(0.7).map(({ label }) => label), ["Worst hexahedron"]);
});

test("remedies are told in the options that the terminal names", () => {
  assert.equal(advice_on("take_larger_hexahedra", undefined, "take larger hexahedra"), "raise --size, or lower --cells");
  assert.equal(advice_on("use_edge_length", 3.6, "take tets with edges of 3.6"), "try --tet-size 3.6");
  assert.equal(advice_on("cut_corner", undefined, "cut the corner off"), "cut the corner off");
  assert.equal(advice_on(undefined, undefined, undefined), "");
});

test("a part of the model says how many cells it lacks, and where", () => {
  assert.equal(lacking({ outcome: "partial", hexahedra: 8, left_out: 1, left_out_place: [1, 2, 3] }), "1 cell left out near 1, 2, 3");
  assert.equal(lacking({ outcome: "all-hex", hexahedra: 8, left_out: 0 }), "");
});

test("the worst fit is where the largest distance is known to be, at vertices or within faces", () => {
  const places = (features) => mesh_places({
    hexahedra: { outcome: "all-hex", hexahedra: 8, size: 2, used_size: 2, largest_distance: 0.1, largest_distance_place: [1, 0, 0], largest_distance_of_model: 0, features },
  }, null, [0, 0, 0]).map(({ label, detail, point }) => [label, detail, point]);
  assert.deepEqual(places(undefined), [["Worst fit", "mesh up to 0.1 off the surface", [1, 0, 0]]]);
  const features = { corners: { all: 0, kept: 0 }, creases: { all: 0, kept: 0 }, faces: { all: 0, kept: 0 }, of_mesh: { largest_in_all: 0.01, place_in_all: [9, 9, 9] }, of_model: { largest_in_all: 0.5, place_in_all: [0, 3, 0] } };
  assert.deepEqual(places(features), [["Worst fit", "surface up to 1 from the mesh", [0, 3, 0]]]);
});

test("what is kept of the model is told as the terminal does", () => {
  const of = (corners, creases, faces, more) => kept_text({ corners: { all: corners[1], kept: corners[0] }, creases: { all: creases[1], kept: creases[0] }, faces: { all: faces[1], kept: faces[0] }, ...more });
  assert.equal(of([8, 8], [0, 0], [1, 1], {}), "8 of 8 corners, 1 of 1 face kept");
  assert.equal(of([0, 0], [1, 2], [0, 0], { small: 3, too_small: [{}, {}] }), "1 of 2 creases kept; 3 others smaller than the hexahedra, 2 of which are not kept");
  assert.equal(of([0, 0], [0, 0], [0, 0], { small: 1, too_small: [] }), "1 feature smaller than the hexahedra, kept too");
});
