// SPDX-License-Identifier: Apache-2.0
// Cuts through tets and cells, where frames are drawn on them, and the names of axes.

import assert from "node:assert/strict";
import { test } from "node:test";

import { length_of, subtract } from "../src/math/frame.ts";
import { kAllNames, matched_axes, name_axes, seams_of } from "../src/scene/axis_names.ts";
import { cut_cells, cut_outline, cut_tets } from "../src/scene/cut_pieces.ts";
import { build_octree } from "../src/scene/octree.ts";
import { decode_scene, element_count } from "../src/scene/scene.ts";
import { tet_at } from "../src/scene/tet_finder.ts";
import { Cut } from "../src/view/cut.ts";
import { glyph_places, piece_at } from "../src/view/glyph_places.ts";
import { ball_scene, components_scene, plate_scene } from "./sample_scene.mjs";
import { box_of_tets, frame_around, middle_of, tets_scene } from "./tet_scene.mjs";

const scenes = Object.fromEntries(Object.entries({ ball: ball_scene, plate: plate_scene, components: components_scene, tets: tets_scene }).map(([name, make]) => [name, decode_scene(make().scene)]));

const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
const corner_of = ({ corners }, k) => [...corners.subarray(3 * k, 3 * k + 3)];

function area_of(pieces) {
  let area = 0;
  for (let piece = 0; piece < pieces.count; ++piece) {
    const first = corner_of(pieces, pieces.starts[piece]);
    let sum = [0, 0, 0];
    for (let k = pieces.starts[piece] + 1; k + 1 < pieces.starts[piece + 1]; ++k) {
      const [a, b] = [subtract(corner_of(pieces, k), first), subtract(corner_of(pieces, k + 1), first)];
      sum = [sum[0] + a[1] * b[2] - a[2] * b[1], sum[1] + a[2] * b[0] - a[0] * b[2], sum[2] + a[0] * b[1] - a[1] * b[0]];
    }
    area += length_of(sum) / 2;
  }
  return area;
}

function tets_of(low, size, counts) {
  const { points, tets } = box_of_tets(low, size, counts);
  return { points: Float32Array.from(points.flat()), corners: Uint32Array.from(tets.flat()), frame: new Int16Array(0), energy_density: new Float32Array(0), alignment_deg: new Float32Array(0), region: new Uint16Array(0) };
}

test("polygons of cut tets cover the section of the box once, whichever way it is cut", () => {
  const tets = tets_of([-1, -1, -1], [2, 2, 2], [5, 5, 5]);
  const root = Math.SQRT1_2;
  for (const [normal, offset, area] of [[[0, 0, 1], 0.13, 4], [[1, 0, 0], 0, 4], [[root, root, 0], 0, 4 * Math.SQRT2], [[0.6, 0, 0.8], 0.1, 5], [[0, 0, 1], 1.5, 0]]) {
    const found = area_of(cut_tets(tets, normal, offset));
    assert.ok(Math.abs(found - area) < 1e-5, `${normal} ${offset}: ${found}, not ${area}`);
  }
});

test("sides inside are shared by two pieces, which both have them", () => {
  const tets = tets_of([-1, -1, -1], [2, 2, 2], [4, 4, 4]);
  const pieces = cut_tets(tets, [0, 0, 1], 0.1);
  let own = 0;
  for (let piece = 0; piece < pieces.count; ++piece) own += pieces.starts[piece + 1] - pieces.starts[piece];
  // The border of the square crosses two triangles of each of the 16 squares along it: one edge each.
  const border = 2 * own - 4 * (pieces.side_pieces.length / 2);
  assert.equal(border / 2, 32);
  for (let side = 0; side < pieces.side_pieces.length / 2; ++side) {
    for (const piece of pieces.side_pieces.subarray(2 * side, 2 * side + 2)) {
      for (const end of [0, 1]) {
        const point = [...pieces.side_ends.subarray(6 * side + 3 * end, 6 * side + 3 * end + 3)];
        let nearest = Infinity;
        for (let k = pieces.starts[piece]; k < pieces.starts[piece + 1]; ++k) nearest = Math.min(nearest, length_of(subtract(corner_of(pieces, k), point)));
        assert.equal(nearest, 0);
      }
    }
  }
});

test("polygons of cells have the area of the section, and each side between them is found once", () => {
  const scene = scenes.tets.grid;
  const octree = build_octree(scene);
  const pieces = cut_cells(scene, octree, [0, 0, 1], 0.2);
  let area = 0;
  for (let piece = 0; piece < pieces.count; ++piece) area += (scene.cells.unit * scene.cell_size[pieces.element[piece]]) ** 2;
  assert.ok(Math.abs(area_of(pieces) - area) < 1e-3 * area);
  const seen = new Set();
  for (let k = 0; k < pieces.side_pieces.length; k += 2) {
    const [a, b] = pieces.side_pieces.subarray(k, k + 2);
    const key = `${Math.min(a, b)} ${Math.max(a, b)} ${[...pieces.side_ends.subarray(3 * k, 3 * k + 6)].map((value) => value.toFixed(3))}`;
    assert.ok(!seen.has(key), key);
    seen.add(key);
  }
  assert.ok(seen.size > pieces.count, `${seen.size} sides of ${pieces.count} pieces`);
});

test("the outline of a ball is a circle", () => {
  const { surface_vertices, surface_triangles } = scenes.ball;
  const outline = cut_outline(surface_vertices, surface_triangles, [0, 1, 0], 0);
  let length = 0;
  for (let k = 0; k < outline.length; k += 6) length += length_of(subtract([...outline.subarray(k, k + 3)], [...outline.subarray(k + 3, k + 6)]));
  assert.ok(Math.abs(length - 2 * Math.PI * 20) < 0.01 * length, `${length}`);
});

test("frames are drawn in the cut, inside the part, and apart from each other", () => {
  for (const [name, normal] of [["ball", [0, 1, 0]], ["ball", [0.6, 0, 0.8]], ["plate", [0, 0, 1]], ["plate", [1, 0, 0]], ["components", [0.36, 0.48, 0.8]], ["tets", [0, 0, 1]], ["tets", [0.6, 0, 0.8]]]) {
    const scene = scenes[name];
    const cut = new Cut(scene, build_octree(scene), true);
    const offset = normal.reduce((sum, value, k) => sum + (value * (scene.low[k] + scene.high[k])) / 2, 0);
    cut.place(normal, offset);
    for (const spacing of [1.4, 4]) {
      const places = glyph_places(cut.pieces, cut.outline, normal, spacing);
      assert.ok(places.length > 10, `${name}: ${places.length} frames`);
      for (const { point, piece } of places) {
        assert.ok(Math.abs(dot(normal, point) - offset) < 1e-3, `${name}: off the cut`);
        assert.ok(piece >= 0 && piece < cut.pieces.count);
        if (name === "ball") assert.ok(length_of(point) < 20, `${point} is outside`);
        if (name === "tets") assert.ok(point.slice(0, 2).every((value) => Math.abs(value) <= 10.001), `${point} is outside`);
      }
      for (let a = 0; a < places.length; ++a) for (let b = 0; b < a; ++b) {
        const distance = length_of(subtract(places[a].point, places[b].point));
        assert.ok(distance >= 0.74 * spacing, `${name}: frames ${distance} apart`);
      }
    }
  }
});

test("walls that pass between the points of the raster have frames in their middle", () => {
  const scene = scenes.plate;
  const cut = new Cut(scene, build_octree(scene), true);
  cut.place([1, 0, 0], 40.3);
  // The plate is 3 thick; points 8 apart are at 4 and -4 of its middle.
  const places = glyph_places(cut.pieces, cut.outline, [1, 0, 0], 8);
  assert.ok(places.length >= 5, `${places.length}`);
  for (const { point } of places) assert.ok(point[2] > 0 && point[2] < 3, `${point}`);
});

test("a wider spacing draws fewer frames", () => {
  const cut = new Cut(scenes.plate, build_octree(scenes.plate), true);
  cut.place([0, 0, 1], 1.5);
  const counts = [1, 2, 4, 8].map((spacing) => glyph_places(cut.pieces, cut.outline, [0, 0, 1], spacing).length);
  assert.ok(counts[0] > 2 * counts[1] && counts[1] > 2 * counts[2] && counts[2] > 2 * counts[3], `${counts}`);
});

test("the tet at a point is the one that holds it", () => {
  const { points, tets } = box_of_tets([0, 0, 0], [3, 2, 1], [4, 3, 2]);
  const all = tets_of([0, 0, 0], [3, 2, 1], [4, 3, 2]);
  tets.forEach((tet, k) => assert.equal(tet_at(all, middle_of(points, tet)), k));
  assert.equal(tet_at(all, [5, 1, 0.5]), -1);
  // In a plane of vertices there are polygons without area, which hold no point.
  const flat = cut_tets(all, [0, 0, 1], 0.5);
  const there = piece_at(flat, [0, 0, 1], [1.1, 0.9, 0.5]);
  const place = corner_of(flat, flat.starts[there]);
  assert.ok(length_of(subtract(place, [1.1, 0.9, 0.5])) < 1.1, `${place}`);
  const cut = cut_tets(all, [0, 0, 1], 0.3);
  for (const tet of [0, 20, 70]) {
    const middle = middle_of(points, tets[tet]);
    const piece = piece_at(cut, [0, 0, 1], [middle[0], middle[1], 0.3]);
    assert.ok(piece >= 0 && tet_at(all, [middle[0], middle[1], 0.3]) === cut.element[piece]);
  }
});

/** Frames on rings around a line of some index, with links around the rings and between them: the case of tests/display. */
function rings(index, around = 24, count = 4) {
  const frames = [];
  const links = [];
  for (let ring = 0; ring < count; ++ring) {
    for (let k = 0; k < around; ++k) {
      const angle = (2 * Math.PI * (k + 0.5)) / around;
      const turn = (index * angle) / 2;
      frames.push([Math.cos(turn), 0, 0, Math.sin(turn)]);
      const here = ring * around + k;
      const arc = (2 * Math.PI * (ring + 1)) / around;
      links.push({ a: here, b: ring * around + ((k + 1) % around), distance: arc, width: 1 });
      if (ring > 0) links.push({ a: here - around, b: here, distance: 1, width: arc });
    }
  }
  return { frames, links };
}

test("names agree all around a line of index one, and change across one seam through the rings around a line of a quarter", () => {
  for (const [index, seams] of [[1, 0], [0.25, 4], [-0.25, 4], [0.5, 0], [0, 0]]) {
    const { frames, links } = rings(index);
    const names = name_axes(frames, links, 0);
    const found = seams_of(names, frames, links);
    assert.equal(found.length, seams, `index ${index}: ${found}`);
    // Straight outwards: in every ring at the same place.
    assert.equal(new Set(found.map((k) => links[k].a % 24)).size, Math.min(1, seams));
  }
});

test("seams are where C++ finds them", () => {
  // As tests/page/page_scene_test.cpp has them, of the same rings.
  const { frames, links } = rings(0.25);
  const found = seams_of(name_axes(frames, links, 0), frames, links).map((k) => [links[k].a, links[k].b]);
  assert.deepEqual(found, kSeamsInCpp);
});
const kSeamsInCpp = [[11, 12], [35, 36], [59, 60], [83, 84]];

test("frames that differ by any symmetry of the cube match, with axes that go on", () => {
  const frame = [0.8, 0.3, -0.4, 0.33166247903554];
  const half = Math.SQRT1_2;
  for (const [turn, axes] of [
    [[1, 0, 0, 0], [0, 1, 2]], [[0, 1, 0, 0], [0, 1, 2]], [[half, half, 0, 0], [0, 2, 1]], [[half, 0, 0, -half], [1, 0, 2]], [[0, half, half, 0], [1, 0, 2]],
    [[0.5, 0.5, 0.5, 0.5], [1, 2, 0]], [[0.5, -0.5, -0.5, -0.5], [2, 0, 1]], [[0.5, -0.5, -0.5, 0.5], [1, 2, 0]],
  ]) {
    // A frame times a symmetry is the same frame; axis k of `from` is axis axes[k] of `to`, up to its sign.
    const from = frame.map((_, k) => {
      const [w, x, y, z] = frame;
      const [a, b, c, d] = turn;
      return [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a][k];
    });
    const found = matched_axes(from, frame);
    assert.deepEqual(kAllNames[found.axes], axes, `${turn}`);
    assert.ok(Math.abs(found.cosine - 1) < 1e-9);
  }
});

test("on the bar of tets names change across one seam from the line to the surface", () => {
  const scene = scenes.tets;
  assert.ok(element_count(scene) > 5000);
  const cut = new Cut(scene, build_octree(scene), true);
  cut.place([0, 0, 1], 0.3);
  const { seams } = cut.named;
  const ends = Array.from({ length: seams.length / 3 }, (_, k) => [...seams.subarray(3 * k, 3 * k + 3)]);
  assert.ok(Math.min(...ends.map(([x, y]) => Math.hypot(x, y))) < 2, "begins at the line");
  assert.ok(Math.max(...ends.map(([x, y]) => Math.max(Math.abs(x), Math.abs(y)))) > 9.99, "ends at the surface");
  let length = 0;
  for (let k = 0; k < ends.length; k += 2) length += length_of(subtract(ends[k], ends[k + 1]));
  assert.ok(length > 8 && length < 30, `${length} long`);
  // Without a line there is none.
  const calm = Array.from(frame_around(0)([1, 2]));
  assert.deepEqual(calm, [1, 0, 0, 0]);
});
