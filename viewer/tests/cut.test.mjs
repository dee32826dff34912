// SPDX-License-Identifier: Apache-2.0
// Cuts through tets and cells, where frames are drawn on them, and the names of axes.

import assert from "node:assert/strict";
import { test } from "node:test";

import { axes_of, length_of, subtract } from "../src/math/frame.ts";
import { kAllNames, matched_axes, name_axes, seams_of } from "../src/scene/axis_names.ts";
import { cut_curves } from "../src/scene/cut_curves.ts";
import { CutMap } from "../src/scene/cut_map.ts";
import { cut_cells, cut_outline, cut_tets } from "../src/scene/cut_pieces.ts";
import { build_octree } from "../src/scene/octree.ts";
import { decode_scene, element_count, element_quaternion } from "../src/scene/scene.ts";
import { tet_at } from "../src/scene/tet_finder.ts";
import { Cut } from "../src/view/cut.ts";
import { glyph_places } from "../src/view/glyph_places.ts";
import { scene_named } from "./scenes.mjs";
import { box_of_tets, frame_around, middle_of } from "./tet_scene.mjs";

const scenes = Object.fromEntries(["ball", "plate", "components", "tets"].map((name) => [name, decode_scene(scene_named(name).scene)]));

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
      const places = glyph_places(cut.pieces, cut.map, cut.outline, spacing);
      assert.ok(places.length > 10, `${name}: ${places.length} frames`);
      for (const { point, piece } of places) {
        assert.ok(Math.abs(dot(normal, point) - offset) < 1e-3, `${name}: off the cut`);
        assert.ok(piece >= 0 && piece < cut.pieces.count);
        if (name === "ball") assert.ok(length_of(point) < 20, `${point} is outside`);
        if (name === "tets") assert.ok(point.slice(0, 2).every((value) => Math.abs(value) <= 10.001), `${point} is outside`);
      }
      for (let a = 0; a < places.length; ++a) for (let b = 0; b < a; ++b) {
        if (Math.abs(places[a].point[0] - places[b].point[0]) > spacing) continue;
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
  const places = glyph_places(cut.pieces, cut.map, cut.outline, 8);
  assert.ok(places.length >= 5, `${places.length}`);
  for (const { point } of places) assert.ok(point[2] > 0 && point[2] < 3, `${point}`);
});

test("a wider spacing draws fewer frames", () => {
  const cut = new Cut(scenes.plate, build_octree(scenes.plate), true);
  cut.place([0, 0, 1], 1.5);
  const counts = [1, 2, 4, 8].map((spacing) => glyph_places(cut.pieces, cut.map, cut.outline, spacing).length);
  assert.ok(counts[0] > 2 * counts[1] && counts[1] > 2 * counts[2] && counts[2] > 2 * counts[3], `${counts}`);
});

/** The curves on a cut: lists of points in space, and of the axis names of their segments. */
function curves_of(scene, normal, offset, spacing) {
  const cut = new Cut(scene, build_octree(scene), true);
  cut.place(normal, offset);
  const { pieces, map } = cut;
  const { points, starts, pieces: begun_in, axes } = cut_curves(pieces, cut.named.names, map, normal, (piece) => element_quaternion(scene, pieces.element[piece]), spacing);
  return Array.from({ length: starts.length - 1 }, (_, curve) => Array.from({ length: starts[curve + 1] - starts[curve] }, (_, step) => {
    const k = starts[curve] + step;
    return { at: map.point_at(points[2 * k], points[2 * k + 1]), element: pieces.element[begun_in[k]], axis: axes[k], name: cut.named.names[begun_in[k]][axes[k]] };
  }));
}

test("curves run along an axis of the frames, in the cut and inside the part", () => {
  for (const [name, normal] of [["ball", [0, 1, 0]], ["plate", [0, 0, 1]], ["tets", [0, 0, 1]], ["tets", [0.6, 0, 0.8]]]) {
    const scene = scenes[name];
    const offset = normal.reduce((sum, value, k) => sum + (value * (scene.low[k] + scene.high[k])) / 2, 0);
    let [steps, astray] = [0, 0];
    for (const curve of curves_of(scene, normal, offset, 2)) for (let k = 0; k + 1 < curve.length; ++k) {
      const { at, element, axis } = curve[k];
      assert.ok(Math.abs(dot(normal, at) - offset) < 2e-3 && scene.low.every((low, m) => at[m] > low - 1e-3 && at[m] < scene.high[m] + 1e-3), `${name}: ${at}`);
      if (name === "ball") assert.ok(length_of(at) < 20.01, `${at} is outside`);
      const way = subtract(curve[k + 1].at, at);
      if (length_of(way) < 1e-3) continue;
      const along = axes_of(element_quaternion(scene, element))[axis];
      const flat = subtract(along, normal.map((value) => value * dot(normal, along)));
      ++steps;
      if (Math.abs(dot(flat, way)) < 0.94 * length_of(flat) * length_of(way)) ++astray; // 20 degrees: frames between pieces differ
    }
    assert.ok(steps > 300 && astray < 0.02 * steps, `${name}: ${astray} of ${steps} steps run elsewhere`);
  }
});

test("curves are evenly spaced: in a calm field they are the lines of a square grid", () => {
  const [side, spacing] = [20, 2];
  // The bar's frames, all turned into one direction.
  const tets = { ...scenes.tets.tets, frame: scenes.tets.tets.frame.map((_, k) => (k % 4 === 0 ? 32767 : 0)) };
  const curves = curves_of({ ...scenes.tets, tets }, [0, 0, 1], 0.3, spacing);
  const length = curves.reduce((sum, curve) => sum + length_of(subtract(curve[0].at, curve.at(-1).at)), 0);
  // None run along the sides.
  assert.ok(Math.abs(length - 2 * side * (side / spacing - 1)) < 0.02 * length, `${length} long in all`);
  for (const axis of [0, 1]) {
    const places = curves.filter((curve) => curve[0].name === axis).map((curve) => curve[0].at[1 - axis]).sort((a, b) => a - b);
    assert.equal(places.length, 9);
    places.slice(1).forEach((place, k) => assert.ok(place - places[k] > 0.95 * spacing && place - places[k] < 1.97 * spacing, `${places}`));
  }
});

test("of two axes that run alike on the cut curves follow the one with the earlier name", () => {
  const eighth = [Math.cos(Math.PI / 8), Math.sin(Math.PI / 8), 0, 0].map((value) => Math.round(32767 * value));
  const tets = { ...scenes.tets.tets, frame: scenes.tets.tets.frame.map((_, k) => eighth[k % 4]) };
  const names = new Set(curves_of({ ...scenes.tets, tets }, [0, 0, 1], 0.3, 2).flat().map(({ name }) => name));
  assert.deepEqual([...names].sort(), [0, 1]);
});

test("walls thinner than the distance between curves have curves from side to side, and one along the middle", () => {
  const curves = curves_of(scenes.plate, [1, 0, 0], 40.3, 8);
  const heights = curves.map((curve) => Math.abs(curve[0].at[2] - curve.at(-1).at[2]));
  assert.ok(heights.filter((height) => Math.abs(height - 3) < 0.02).length >= 8, `${heights}`);
  const along = curves.filter((curve) => Math.abs(curve[0].at[1] - curve.at(-1).at[1]) > 70);
  assert.equal(along.length, 1);
  for (const { at } of along[0]) assert.ok(Math.abs(at[2] - 1.5) < 0.1, `${at}`);
});

test("faces between regions are cut as they are, not along the cells", () => {
  const scene = decode_scene(scene_named("regions").scene);
  const cut = new Cut(scene, build_octree(scene), true);
  cut.place([0, 0, 1], 1);
  const ends = Array.from({ length: cut.interfaces.length / 3 }, (_, k) => [...cut.interfaces.subarray(3 * k, 3 * k + 3)]);
  assert.equal(ends.length, 4);
  // The face is x = z / 2 - y / 4.
  for (const [x, y, z] of ends) assert.ok(Math.abs(x - z / 2 + y / 4) < 1e-5 && Math.abs(z - 1) < 1e-5, `${[x, y, z]}`);
  assert.deepEqual([Math.min(...ends.map(([, y]) => y)), Math.max(...ends.map(([, y]) => y))], [-10, 10]);
});

function piece_at(pieces, point) {
  const map = new CutMap(pieces, null, [0, 0, 1]);
  return map.piece_at(...map.flat_of(point));
}

test("the tet at a point is the one that holds it", () => {
  const { points, tets } = box_of_tets([0, 0, 0], [3, 2, 1], [4, 3, 2]);
  const all = tets_of([0, 0, 0], [3, 2, 1], [4, 3, 2]);
  tets.forEach((tet, k) => assert.equal(tet_at(all, middle_of(points, tet)), k));
  assert.equal(tet_at(all, [5, 1, 0.5]), -1);
  // In a plane of vertices there are polygons without area, which hold no point.
  const flat = cut_tets(all, [0, 0, 1], 0.5);
  const there = piece_at(flat, [1.1, 0.9, 0.5]);
  const place = corner_of(flat, flat.starts[there]);
  assert.ok(length_of(subtract(place, [1.1, 0.9, 0.5])) < 1.1, `${place}`);
  const cut = cut_tets(all, [0, 0, 1], 0.3);
  for (const tet of [0, 20, 70]) {
    const middle = middle_of(points, tets[tet]);
    const piece = piece_at(cut, [middle[0], middle[1], 0.3]);
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
