// SPDX-License-Identifier: Apache-2.0
// Decoding scenes, finding cells in them, and choosing which frames to draw.

import assert from "node:assert/strict";
import { test } from "node:test";

import { kClasses, ramp_color } from "../src/math/color_maps.ts";
import { faults_of, reasons_with_faults } from "../src/scene/faults.ts";
import { build_octree, cell_at, surface_cell_at } from "../src/scene/octree.ts";
import { cell_box, cell_center, cell_count, decode_scene, element_quaternion } from "../src/scene/scene.ts";
import { cut_normal, cut_offset, SettingsStore } from "../src/settings.ts";
import { answer_of, worst_places } from "../src/ui/answer.ts";
import { amount, plural } from "../src/ui/dom.ts";
import { fault_groups, input_groups } from "../src/ui/places.ts";
import { link_from, link_of } from "../src/view_link.ts";
import { fraction_of, ranges_of } from "../src/view/ranges.ts";
import { fault_counts, mark_counts } from "../src/view/line_marks.ts";
import { widest_cut } from "../src/view/widest_cut.ts";
import { scene_named } from "./scenes.mjs";
import { encode_scene, upper_half } from "./scene_writer.mjs";

const made = Object.fromEntries(["ball", "plate", "components", "tets"].map((name) => [name, scene_named(name)]));
const scenes = Object.fromEntries(Object.entries(made).map(([name, { scene }]) => [name, decode_scene(scene)]));

test("what was written is read back", () => {
  const scene = scenes.ball;
  assert.deepEqual(scene.origin, [100, 50, 20]);
  assert.equal(cell_count(scene), scene.cells.shown);
  assert.equal(scene.arc_starts.at(-1), scene.arc_points.length / 3);
  assert.equal(scene.surface_triangles.length, 3 * scene.surface.triangles_shown);
  assert.equal(scene.form_matrix.length, 45 * scene.form_cell.length);
  assert.equal(scene.streamline_starts.length, 1);
  assert.ok(Math.abs(Math.hypot(...element_quaternion(scene, 17)) - 1) < 1e-12);
});

test("a scene at an odd place in its buffer is read as well", () => {
  const bytes = new Uint8Array(made.ball.scene.length + 3);
  bytes.set(made.ball.scene, 3);
  assert.deepEqual(decode_scene(bytes.subarray(3)).cell_corner, scenes.ball.cell_corner);
});

test("numbers keep eight bits of their mantissa in sixteen bits", () => {
  for (const value of [0, 1, 3.14159, 1e-7, 54.7, 1e9]) {
    const back = new Float32Array(new Uint32Array([upper_half(value) << 16]).buffer)[0];
    assert.ok(Math.abs(back - value) <= value / 256, `${value} became ${back}`);
  }
});

test("arrays that are missing or empty are empty", () => {
  const scene = decode_scene(encode_scene({ origin: [0, 0, 0], cells: {}, surface: {} }, { cell_size: ["u16", 0, []] }));
  assert.equal(cell_count(scene), 0);
  assert.equal(scene.streamline_points.length, 0);
});

test("damaged scenes are refused with what is wrong", () => {
  assert.throws(() => decode_scene(new Uint8Array(64)), /does not begin with CGSCENE1/);
  const other = encode_scene({ schema: 3 }, {});
  assert.throws(() => decode_scene(other), /schema 3/);
  assert.throws(() => decode_scene(made.ball.scene.slice(0, 100_000)), /ends beyond the scene/);
});

test("every cell is found at its centre and near its corners, and nothing outside", () => {
  for (const scene of Object.values(scenes)) {
    const octree = build_octree(scene);
    for (let cell = 0; cell < cell_count(scene); ++cell) {
      const { low, side } = cell_box(scene, cell);
      assert.equal(cell_at(scene, octree, cell_center(scene, cell)), cell);
      assert.equal(cell_at(scene, octree, low.map((value) => value + 1e-3 * side)), cell);
      assert.equal(cell_at(scene, octree, low.map((value) => value + 0.999 * side)), cell);
    }
    assert.equal(cell_at(scene, octree, scene.cells.low.map((value) => value - 1)), -1);
    assert.equal(cell_at(scene, octree, [1e9, 0, 0]), -1);
  }
});

test("a single cell that is all of the octree is found", () => {
  const scene = decode_scene(encode_scene({ cells: { low: [0, 0, 0], unit: 1 } }, { cell_corner: ["u16", 3, [0, 0, 0]], cell_size: ["u16", 0, [4]] }));
  assert.equal(cell_at(scene, build_octree(scene), [3.9, 0.1, 2]), 0);
});

test("points of the surface have a boundary cell", () => {
  const scene = scenes.ball;
  const octree = build_octree(scene);
  let boundary = 0;
  for (let k = 0; k < scene.surface_vertices.length; k += 3) {
    const point = [...scene.surface_vertices.subarray(k, k + 3)];
    const cell = surface_cell_at(scene, octree, point, point.map((value) => value / 20));
    assert.ok(cell >= 0, `${point}`);
    if (scene.cell_class[cell] > 0) ++boundary;
  }
  // The sample sums its forms from small pieces, which miss cells that the surface only grazes.
  assert.ok(boundary > 0.9 * (scene.surface_vertices.length / 3), `${boundary}`);
});

test("the first cut shows most of the part", () => {
  assert.equal(widest_cut(scenes.plate), "z");
  assert.equal(widest_cut(scenes.ball), "y");
});

test("a cut that is flipped lies where it lay", () => {
  const store = new SettingsStore();
  for (const axis of ["x", "y", "z"]) {
    store.change({ cut: { axis, position: 0.25, flip: false } });
    const [n, d] = [cut_normal(store.current), cut_offset(store.current, [-1, 0, 5], [1, 4, 9])];
    store.change({ cut: { flip: true } });
    assert.deepEqual(cut_normal(store.current).map((value) => -value + 0), n);
    assert.equal(-cut_offset(store.current, [-1, 0, 5], [1, 4, 9]), d);
  }
});

test("ranges are round and hold what they colour", () => {
  const { alignment, energy } = ranges_of(scenes.ball);
  assert.equal(alignment.low, 0);
  assert.ok(alignment.high >= 2 && alignment.high <= 10);
  assert.equal(Math.log10(energy.high) % 1, 0);
  assert.equal(fraction_of(energy, 0), 0);
  assert.ok(Math.abs(fraction_of(energy, Math.sqrt(energy.low * energy.high)) - 0.5) < 1e-12);
});

test("lightness of the maps of quantities only rises or only falls, in steps of like size", () => {
  const linear = (channel) => (channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4);
  const lightness = ([r, g, b]) => 116 * Math.cbrt(0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b)) - 16;
  for (const theme of ["light", "dark"]) for (const ramp of ["alignment", "energy"]) {
    const values = Array.from({ length: 33 }, (_, k) => lightness(ramp_color(ramp, theme, k / 32)));
    const steps = values.slice(1).map((value, k) => (theme === "dark" ? value - values[k] : values[k] - value));
    assert.ok(Math.min(...steps) > 0.6 && Math.max(...steps) < 5.5, `${theme} ${ramp}: ${steps.map((step) => step.toFixed(1))}`);
  }
  assert.equal(new Set(kClasses.map(({ color }) => color.light)).size, kClasses.length);
});

test("the worst shapes are red and the good ones calm, light and dark", () => {
  for (const theme of ["light", "dark"]) {
    const [worst, middle, best] = [0, 0.5, 1].map((value) => ramp_color("shape", theme, value));
    assert.ok(worst[0] - Math.max(worst[1], worst[2]) > 0.3, `${theme}: ${worst} is not red`);
    assert.ok(Math.max(...best) - Math.min(...best) < 0.25 && best[2] > best[0], `${theme}: ${best} is not calm`);
    assert.ok(middle[0] > middle[2], `${theme}: ${middle} is calmer than the best`);
  }
});

test("the answer is the one of the report, in its words", () => {
  const answers = Object.values(made).map(({ report }) => answer_of(report));
  assert.deepEqual(answers.map(({ judgement, short }) => [judgement, short]), [["good", "hexahedra fit locally"], ["unsure", "undecided"], ["bad", "hexahedra cannot follow this field"], ["bad", "hexahedra cannot follow this field"]]);
  for (const { short, sentence } of answers) assert.ok(sentence.startsWith(short), sentence);
  assert.equal(answer_of({}), null);
  assert.equal(answer_of({ verdict: "of a later version" }), null);
});

test("faults are lines, nodes, creases and corners that are not meshable or undecided, certain ones first", () => {
  const faults = faults_of(made.components.report).map(({ part, number, verdict }) => [part, number, verdict]);
  const [bad, unsure] = ["not_meshable", "undecided"];
  assert.deepEqual(faults, [["line", 11, bad], ["line", 13, bad], ["node", 9, bad], ["node", 10, unsure], ["crease", 3, bad], ["crease", 2, unsure], ["corner", 1, bad]]);
  assert.deepEqual(faults_of(made.ball.report), []);
  assert.deepEqual(faults_of({}), []);
});

test("a reason has the faults of its kind, of which it names one, and those that no reason has are others", () => {
  const { report } = made.components;
  const { reasons, others } = reasons_with_faults(report);
  assert.deepEqual(reasons.map(({ reason, faults }) => [reason.kind, ...faults.map(({ part, number }) => `${part} ${number}`)]), [["knife_edge", "crease 3"], ["arc", "line 11", "line 13"], ["walls"]]);
  assert.deepEqual(others.map(({ part, number }) => `${part} ${number}`), ["node 9", "node 10", "crease 2", "corner 1"]);
  // Ends that are close together are told from nodes inside that are undecided.
  const node = (on_boundary, place) => ({ verdict: "undecided", place, on_boundary, arcs: [0, 1] });
  const singularity = { arcs: 0, nodes: 0, node_list: [node(false, [1, 0, 0]), node(true, [2, 0, 0]), node(true, [3, 0, 0])] };
  const ends = { kind: "ends", verdict: "undecided", count: 2, place: [2, 0, 0], text: "2 arcs end close to one another" };
  assert.deepEqual(reasons_with_faults({ singularity, reasons: [ends] }).reasons[0].faults.map(({ number }) => number), [2, 3]);
});

test("with tets, faults are those of the field on the tets", () => {
  const { report } = made.components;
  const onto = { tets: 9, singularity: { arcs: 0, nodes: 0, corner_list: [{ creases: [1], verdict: "undecided", place: [1, 2, 3] }] } };
  const faults = faults_of({ ...report, onto });
  assert.deepEqual(faults.map(({ part, place }) => [part, place]), [["corner", [1, 2, 3]]]);
  assert.equal(faults[0].words, "its crease takes 1 hexahedron");
});

test("marks are counted by their shape, and by their colour with those of other faults", () => {
  assert.deepEqual(mark_counts(scenes.ball), { nodes: 8, ends: 8, turns: 0 });
  assert.deepEqual(mark_counts(scenes.components), { nodes: 2, ends: 8, turns: 1 });
  assert.deepEqual(fault_counts(scenes.ball, []), { impossible: 0, undecided: 0 });
  const marks = [{ point: [0, 0, 0], verdict: "undecided" }, { point: [1, 0, 0], verdict: "not_meshable" }];
  assert.deepEqual(fault_counts(scenes.components, marks), { impossible: 2, undecided: 2 });
});

test("places are relative to the origin of the scene", () => {
  const [faults] = fault_groups(faults_of(made.components.report), [10, 20, 30]);
  const [first] = faults_of(made.components.report);
  assert.deepEqual(faults.kinds[0].places[0].point, first.place.map((value, k) => value - [10, 20, 30][k]));
});

test("one is no plural", () => {
  assert.deepEqual([plural(1, "node"), plural(0, "node"), plural(1000, "node")], ["1 node", "0 nodes", "1,000 nodes"]);
  assert.deepEqual([amount(1, "cell"), amount(0.99999, "cell"), amount(2.75, "cell")], ["1 cell", "1 cell", "2.75 cells"]);
  const input = { findings: [{ kind: "duplicated triangles", count: 1 }, { kind: "holes", count: 2 }, { kind: "inside-out parts", count: 1 }] };
  const found = input_groups({ input }, [0, 0, 0]).find(({ name }) => name === "Found in the input");
  assert.deepEqual(found.kinds.map(({ places: [{ label }] }) => label), ["1 duplicated triangle", "2 holes", "1 inside-out part"]);
});

test("findings of a kind are summed up in words", () => {
  const crease = (verdict) => ({ hexahedra: 0, least_angle_deg: 30, verdict, place: [0, 0, 0] });
  const crease_list = [...Array(10).fill(crease("not_meshable")), crease("undecided"), crease("meshable")];
  const [, creases] = fault_groups(faults_of({ singularity: { arcs: 0, nodes: 0, crease_list } }), [0, 0, 0]);
  assert.deepEqual(creases.kinds.map(({ summary, places }) => [summary, places.length]), [["Ten edges below 45 degrees", 10], ["One edge where rounding decides", 1]]);
});

test("the worst places are faults first, then where the field is off its surface or turns most, each once", () => {
  const bad = worst_places(made.components.report, scenes.components, [0, 0, 0]);
  const { arc_list } = made.components.report.singularity;
  assert.deepEqual(bad.map(({ point }) => point), [[46, 26, 6], arc_list[10].place, arc_list[12].place]);
  const good = worst_places(made.ball.report, scenes.ball, scenes.ball.origin);
  assert.deepEqual(good.map(({ label }) => label), ["Largest energy density"]);
  const tilted = { ...scenes.ball, cell_alignment_deg: scenes.ball.cell_alignment_deg.map((value, k) => (k === 100 ? 30 : value)), cell_class: scenes.ball.cell_class.map((value, k) => (k === 100 ? 1 : value)) };
  const [first] = worst_places(made.ball.report, tilted, scenes.ball.origin);
  assert.deepEqual([first.label, first.detail], ["Worst alignment", "30°"]);
  assert.deepEqual(first.point, cell_center(tilted, 100));
});

test("a link restores what it was made of, and unknown parts of it are ignored", () => {
  const store = new SettingsStore();
  store.change({ up: "y", field: "grid", map: "energy", opacity: 0.8, streams: "surface", cut: { axis: "view", normal: [0.6, 0, 0.8], position: 0.25, flip: true, clip: false }, glyph: { shape: "cube", color: "turn", density: -1 }, layers: { streamlines: true, part: false } });
  const camera = { position: [1.5, -2, 3], target: [0, 0.25, 0] };
  const link = link_of(store.current, camera);
  const back = link_from(link);
  assert.deepEqual(back.camera, camera);
  const other = new SettingsStore();
  other.change(back.settings);
  assert.deepEqual(other.current, store.current);
  assert.deepEqual(link_from("#camera=1,2&cut=q,3&map=lava&up=w&opacity=7&frames=ball,axes,9&x=y"), { settings: {}, camera: null });
});

test("without a field of tets there is no grid to choose", () => {
  assert.equal(scenes.ball.grid, null);
  assert.equal(scenes.tets.grid.tets, null);
  assert.deepEqual([scenes.tets.arc_index.length, scenes.tets.grid.arc_index.length], [1, 4]);
  assert.equal(scenes.tets.grid.surface_alignment_deg.length, 0);
});
