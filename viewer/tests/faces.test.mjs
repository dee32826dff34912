// SPDX-License-Identifier: Apache-2.0
// Faces of the model: what is known of each, and where they are.

import assert from "node:assert/strict";
import { test } from "node:test";

import { face_of_triangle, faces_of_model, facing_of, point_of, set_of, triangles_of_face } from "../src/scene/faces.ts";
import { decode_scene } from "../src/scene/scene.ts";
import { surface_normal } from "../src/scene/surface_normal.ts";
import { scene_named } from "./scenes.mjs";
import { face_of_bar, tets_scene } from "./tet_scene.mjs";

const { report, scene: bytes } = scene_named("hexahedra");
const scene = decode_scene(bytes);

test("the set of a face is named as docs/formats.md says", () => {
  assert.equal(set_of(12), "FACE_12");
  assert.equal(set_of(-3), "FACE_MINUS_3");
});

test("a model whose report has no faces has those that the scene names, with their quads", () => {
  const faces = faces_of_model({}, scene);
  assert.deepEqual(faces.map(({ number }) => number), [1, 2, 3, 4, 5, 6]);
  assert.deepEqual(faces.map(({ quads }) => quads), [72, 72, 72, 72, 36, 36]);
  assert.deepEqual(faces_of_model({}, decode_scene(scene_named("ball").scene)), []);
});

test("a report says more of its faces, also of those that no quad lies on", () => {
  const faces = faces_of_model(report, scene);
  assert.equal(faces.length, 7);
  assert.deepEqual([faces[6].kind, faces[6].quads, faces[6].area], ["cylinder", 0, 0.8]);
  assert.deepEqual(faces[4].center, [0, 0, -20]);
});

test("triangles of a face lie on it, look outward and have a point of it in their middle", () => {
  const outward = [[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, -1], [0, 0, 1]];
  for (let number = 1; number <= 6; ++number) {
    const corners = triangles_of_face(scene, number);
    assert.ok(corners.length > 0 && corners.length % 9 === 0);
    facing_of(corners).forEach((value, k) => assert.ok(Math.abs(value - outward[number - 1][k]) < 1e-6));
    assert.equal(face_of_bar(point_of(corners), 10, 20), number);
  }
  assert.equal(triangles_of_face(scene, 7).length, 0);
  assert.equal(face_of_triangle(scene, -1), 0);
});

test("what faces all ways faces none", () => {
  const all = Float32Array.from([1, 2, 3, 4, 5, 6].flatMap((number) => [...triangles_of_face(scene, number)]));
  assert.equal(facing_of(all), null);
});

test("numbers of faces below zero are read as they are", () => {
  const { scene: written } = tets_scene({ arrays: { surface_face: ["u32", 0, [2 ** 32 - 3]] } });
  assert.deepEqual([...decode_scene(written).surface_face], [-3]);
});

test("the surface at a place faces as its nearest triangle does", () => {
  for (const [point, normal] of [[[10.4, 3, -7], [1, 0, 0]], [[-9.9, 3, 15], [-1, 0, 0]], [[2, -10, 1], [0, -1, 0]], [[1, 2, 20], [0, 0, 1]], [[3, 4, -23], [0, 0, -1]]]) {
    surface_normal(scene, point).forEach((value, k) => assert.ok(Math.abs(value - normal[k]) < 1e-6, `${point}`));
  }
  assert.deepEqual(surface_normal({ surface_vertices: new Float32Array(0), surface_triangles: new Uint32Array(0) }, [0, 0, 0]), [1, 0, 0]);
});
