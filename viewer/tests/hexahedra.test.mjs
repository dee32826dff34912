// SPDX-License-Identifier: Apache-2.0
// Which hexahedra are shown, and the outside of these.

import assert from "node:assert/strict";
import { test } from "node:test";

import { face_color } from "../src/math/color_maps.ts";
import { edge_lengths, faces_of_hexahedra, hex_colors, hexahedron_center, hexahedron_centered_at, hexahedron_of, hexahedron_radius, HexSkins, number_of, share_below, side_along } from "../src/scene/hexahedra.ts";
import { decode_scene } from "../src/scene/scene.ts";
import { box_of_hexahedra, center_of, hex_mesh, kRegions, region_at } from "./hex_scene.mjs";
import { scene_named } from "./scenes.mjs";

const scene = decode_scene(scene_named("hexahedra").scene);
const mesh = hex_mesh();
const kFaces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

const hexahedra_of = ({ points, hexahedra }) => ({
  total: hexahedra.length, inverted: 0, mean: 1, points: Float32Array.from(points.flat()), corners: Uint32Array.from(hexahedra.flat()),
  shape: new Float32Array(hexahedra.length).fill(1), is_inverted: new Uint8Array(0), number: new Uint32Array(0), face: new Int32Array(0),
  regions: [], region: new Uint16Array(0),
});

/** Faces that one of the shown hexahedra has alone, found by counting: their points, sorted, with the hexahedron. */
function counted_faces(hexahedra, is_shown) {
  const uses = new Map();
  hexahedra.forEach((corners, k) => {
    if (!is_shown[k]) return;
    for (const face of kFaces) {
      const key = face.map((corner) => corners[corner]).sort((a, b) => a - b).join();
      uses.set(key, [...(uses.get(key) ?? []), k]);
    }
  });
  return [...uses].filter(([, users]) => users.length === 1).map(([key, [user]]) => `${key}: ${user}`).sort();
}

const faces_of = ({ side, corners }) =>
  Array.from(side, (number, face) => `${[...corners.subarray(4 * face, 4 * face + 4)].sort((a, b) => a - b).join()}: ${hexahedron_of(number)}`).sort();

test("a plane leaves the share of hexahedra whose centres are below it", () => {
  const plate = hexahedra_of(box_of_hexahedra([0, 0, 0], [4, 3, 1], [4, 3, 1]));
  assert.equal(share_below(plate, { normal: [0, 0, 1], offset: 0.5 - 1e-5 }), 0);
  assert.equal(share_below(plate, { normal: [1, 0, 0], offset: 2 - 1e-5 }), 0.5);
  assert.equal(share_below(plate, { normal: [-1, 0, 0], offset: -1 }), 0.75);
});

test("a page without hexahedra has none, and one with them has all", () => {
  assert.equal(decode_scene(scene_named("tets").scene).hexahedra, null);
  assert.equal(scene.hexahedra.shape.length, mesh.hexahedra.length);
  assert.equal(scene.grid.hexahedra, null);
});

test("hexahedra are coloured by faces where there are numbers, and by regions where there are several", () => {
  const plain = hexahedra_of(mesh);
  assert.deepEqual(hex_colors(plain), ["shape"]);
  assert.deepEqual(hex_colors(scene.hexahedra), ["shape", "face"]);
  assert.deepEqual(faces_of_hexahedra(scene.hexahedra), [1, 2, 3, 4, 5, 6]);
  const { hexahedra } = decode_scene(scene_named("all_hex").scene);
  assert.deepEqual(hex_colors(hexahedra), ["shape", "face", "region"]);
  assert.deepEqual(hexahedra.regions, kRegions);
  assert.deepEqual([...hexahedra.region], hex_mesh(false).hexahedra.map((corners) => region_at(center_of(hex_mesh(false).points, corners))));
});

test("faces with numbers near each other have colours that differ", () => {
  const apart = (a, b) => Math.hypot(...face_color(a).map((value, k) => value - face_color(b)[k]));
  for (let face = 0; face < 60; ++face) for (let other = face + 1; other <= face + 4; ++other) {
    assert.ok(apart(face, other) > 0.15, `${face} and ${other}: ${apart(face, other)}`);
    for (const channel of face_color(face)) assert.ok(channel >= 0 && channel <= 1);
  }
});

test("hexahedra are numbered from 1, as files number them", () => {
  assert.equal(number_of(scene.hexahedra, 0), 1);
  assert.equal(number_of(scene.hexahedra, 7), 8);
  assert.equal(number_of({ ...scene.hexahedra, number: Uint32Array.of(3, 9) }, 1), 10);
});

test("around a hexahedron are those that share a vertex with it", () => {
  const skins = new HexSkins(scene.hexahedra);
  for (const hexahedron of [0, 15, 6 * 6 * 5 + 6 * 2 + 3]) {
    const own = new Set(mesh.hexahedra[hexahedron]);
    const expected = mesh.hexahedra.map((corners, k) => Number(k !== hexahedron && corners.some((corner) => own.has(corner))));
    assert.deepEqual([...skins.around(hexahedron)], expected);
    assert.ok([7, 11, 17, 26].includes(expected.reduce((sum, flag) => sum + flag, 0)));
  }
});

test("a hexahedron is found by its centre, and not by a place beside it", () => {
  for (const hexahedron of [0, mesh.worst, 200]) {
    const center = hexahedron_center(new HexSkins(scene.hexahedra), hexahedron);
    assert.equal(hexahedron_centered_at(scene.hexahedra, center), hexahedron);
    assert.equal(hexahedron_centered_at(scene.hexahedra, center.map((value) => value + 0.1)), -1);
  }
  assert.ok(Math.abs(hexahedron_radius(scene.hexahedra, 5) - (Math.sqrt(3) * 10) / 6) < 1e-5);
});

test("the outside of any hexahedra is that which counting finds", () => {
  const { points, hexahedra } = box_of_hexahedra([0, 0, 0], [5, 4, 3], [5, 4, 3]);
  const skins = new HexSkins(hexahedra_of({ points, hexahedra }));
  let seed = 1;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  for (let trial = 0; trial < 20; ++trial) {
    const is_shown = Uint8Array.from(hexahedra, () => (random() < trial / 19 ? 1 : 0));
    assert.deepEqual(faces_of(skins.skin(is_shown)), counted_faces(hexahedra, is_shown));
  }
});

test("faces point outward by the right-hand rule", () => {
  const hexahedra = hexahedra_of(box_of_hexahedra([-1, -1, -1], [2, 2, 2], [3, 3, 3]));
  const skins = new HexSkins(hexahedra);
  const { corners } = skins.skin(new Uint8Array(27).fill(1));
  assert.equal(corners.length, 4 * 54);
  for (let face = 0; face < 54; ++face) {
    const [a, b, c] = [0, 1, 2].map((k) => [...hexahedra.points.subarray(3 * corners[4 * face + k], 3 * corners[4 * face + k] + 3)]);
    const [u, v] = [b.map((value, k) => value - a[k]), c.map((value, k) => value - a[k])];
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    assert.ok(normal.reduce((sum, value, k) => sum + value * (a[k] + c[k]), 0) > 0);
  }
});

test("a cut leaves the hexahedra whose centres are not above it, and a limit those of worse shapes", () => {
  const skins = new HexSkins(scene.hexahedra);
  const middle = (corners, axis) => corners.reduce((sum, point) => sum + mesh.points[point][axis] / 8, 0);
  for (const [axis, offset] of [[0, 2.1], [1, -4.3], [2, 0.7]]) {
    for (const sign of [-1, 1]) {
      const normal = [0, 1, 2].map((k) => (k === axis ? sign : 0));
      for (const below of [Infinity, 0.9]) {
        const expected = mesh.hexahedra.map((corners, k) => (sign * middle(corners, axis) < sign * offset && mesh.shapes[k] < below ? 1 : 0));
        assert.deepEqual([...skins.shown({ normal, offset: sign * offset }, below)], expected);
      }
    }
  }
  assert.equal(skins.shown(null, 0).reduce((sum, flag) => sum + flag, 0), 1);
});

test("a ray meets the nearest of the shown hexahedra", () => {
  const skins = new HexSkins(scene.hexahedra);
  const all = skins.skin(new Uint8Array(mesh.hexahedra.length).fill(1));
  for (const hexahedron of [3, 20, 35]) {
    const [x, y] = hexahedron_center(skins, hexahedron);
    const { side, point } = side_along(scene.hexahedra, all, [x, y, -100], [0, 0, 1]);
    assert.equal(hexahedron_of(side), hexahedron);
    assert.ok(Math.hypot(point[0] - x, point[1] - y, point[2] + 20) < 1e-4, `${point}`);
    assert.equal(side_along(scene.hexahedra, all, [x, y, -100], [0, 0, -1]), null);
    assert.equal(side_along(scene.hexahedra, all, [x + 30, y, -100], [0, 0, 1]), null);
  }
});

test("edges have the lengths of the mesh", () => {
  const { least, most } = edge_lengths(scene.hexahedra, 5);
  assert.ok(Math.abs(least - 10 / 3) < 1e-5 && Math.abs(most - 10 / 3) < 1e-5, `${least} ${most}`);
});
