// SPDX-License-Identifier: Apache-2.0
// The page of a mesh of hexahedra.

import assert from "node:assert/strict";
import { test } from "node:test";

import { filled_page } from "../../viewer/tests/scene_writer.mjs";
import { center_of as center_of_points, hex_mesh } from "../../viewer/tests/hex_scene.mjs";
import { by_night, check_opening, check_said_once, difference, keep_screenshot, kPhone, open, page_file, picture, scene_named, shared_page, state, template } from "./browser.mjs";

const by_test = (name) => `[data-testid="${name}"]`;
const mesh = hex_mesh();
const total = mesh.hexahedra.length;
const center_of = (corners) => center_of_points(mesh.points, corners);
/** A move of the mouse that no slider or key is needed for. */
const change = (page, part) => page.evaluate((wanted) => window.crossgrain.change(wanted), part);

test("hexahedra opens without complaint and shows the part, and says each reason once", async () => {
  await check_opening("hexahedra");
  await check_said_once((await shared_page("hexahedra")).page, scene_named("hexahedra").report, ["edge of 30 degrees"]);
});

test("hexahedra are shown first, cut, with what the report says of them", async () => {
  const { page, problems } = await shared_page("hexahedra");
  assert.equal((await state(page)).layers.hexahedra, true);
  assert.equal(await page.locator(by_test("tab-field")).innerText(), "Mesh");
  assert.match(await page.locator(by_test("hexahedra")).innerText(), /^!\s*Partial mesh: 432 hexahedra\s+1 hexahedron is inverted; take tets with edges of 3\.6\.\s+1\s+Worst hexahedron: −1, inverted\s+2\s+Worst fit: mesh up to 0\.13 mm off the surface$/i);
  assert.match(await page.locator(by_test("badge")).textContent(), /partial mesh$/i);
  assert.match(await page.locator(by_test("shown")).innerText(), /^\d+ of 432 hexahedra$/);
  const legend = (await page.locator("#legend-body").innerText()).replace(/\s+/g, " ");
  assert.equal(legend, "Scaled Jacobian 0 0.5 1 −1 at least, 0.99 in the mean inverted 1");
  assert.equal(await page.locator(by_test("places-where-it-fails")).count(), 0, "the worst hexahedron has its button");
  assert.match(await page.locator(by_test("about")).innerText(), /^About this mesh\s+Model\s/);
  assert.doesNotMatch(await page.locator(by_test("about")).innerText(), /Resolution|Harmonics/);
  assert.deepEqual(problems, []);
});

test("a cut takes away the hexahedra whose centres are above it", async () => {
  const { page } = await shared_page("hexahedra");
  for (const [axis, k] of [["x", 0], ["y", 1], ["z", 2]]) {
    for (const position of [0.1, 0.37, 0.81]) {
      await change(page, { cut: { axis, position, on: true, clip: true, flip: false } });
      const low = k === 2 ? -20 : -10;
      const at = low - 2 * low * position;
      const expected = mesh.hexahedra.filter((corners) => center_of(corners)[k] < at).length;
      assert.equal((await state(page)).hexahedra, expected, `${axis} ${position}`);
      assert.equal(await page.locator(by_test("shown")).innerText(), `${expected} of ${total} hexahedra`);
    }
  }
  await change(page, { cut: { clip: false } });
  assert.equal((await state(page)).hexahedra, total);
});

test("a limit leaves the hexahedra of worse shapes, and goes into links", async () => {
  const { page } = await shared_page("hexahedra");
  await change(page, { cut: { on: false } });
  assert.equal((await state(page)).hexahedra, total);
  const whole = await picture(page);
  await page.locator(by_test("below")).fill("0.9");
  const expected = mesh.shapes.filter((shape) => shape < 0.9).length;
  assert.ok(expected > 4 && expected < 12, `${expected}`);
  assert.equal((await state(page)).hexahedra, expected);
  assert.ok((await difference(page, whole, await picture(page))).mean > 0.01);
  await keep_screenshot(page, "hexahedra-below-desktop-light");
  const link = await page.evaluate(() => window.crossgrain.link());
  assert.match(link, /below=0\.9/);
  await change(page, { below: 1 });
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await page.waitForFunction(() => window.crossgrain.state().below === 0.9);
  assert.equal((await state(page)).hexahedra, expected);
  await page.locator(by_test("below")).fill("0");
  assert.equal((await state(page)).hexahedra, 1);
  await change(page, { below: 1 });
});

test("a click on a hexahedron shows its number and its shape", async () => {
  const { page } = await shared_page("hexahedra");
  await change(page, { cut: { on: false }, below: 1 });
  await page.evaluate(() => window.crossgrain.setView("front"));
  // On the side across y with the low coordinates.
  const number = 6 * 6 * 4 + 3;
  const [x, , z] = center_of(mesh.hexahedra[number]);
  const at = await page.evaluate((point) => window.crossgrain.screenOf(point), [x, -10, z]);
  await page.mouse.click(...at);
  assert.equal((await state(page)).hexahedron, number);
  assert.equal(await page.locator(by_test("cell-title")).innerText(), `Hexahedron ${number + 1}`);
  assert.equal(await page.locator(by_test("hexahedron-shape")).innerText(), "1");
  assert.equal(await page.locator(by_test("hexahedron-edges")).innerText(), "3.33 to 3.33 mm");
  await keep_screenshot(page, "picked-hexahedron-desktop-light");
  await page.locator(by_test("cell-close")).click();
  assert.equal((await state(page)).hexahedron, -1);
  await page.mouse.click(...(await page.evaluate(() => window.crossgrain.screenOf([-8, -10, -18]))));
  assert.equal(await page.locator(by_test("hexahedron-shape")).innerText(), "−1, inverted");
});

test("the field is there where it is asked for, and only then what concerns it alone", async () => {
  const { page } = await shared_page("hexahedra");
  const solid = await picture(page);
  assert.equal(await page.locator(by_test("glyph-density")).isVisible(), false);
  await page.locator("label", { has: page.locator(by_test("mesh-field")) }).click();
  assert.equal(await page.locator(by_test("glyph-density")).isVisible(), true);
  assert.match(await page.locator(by_test("shown")).innerText(), /^The field on [\d,]+ tets\.$/);
  assert.doesNotMatch(await page.locator("#legend-body").innerText(), /Scaled Jacobian/);
  assert.ok((await difference(page, solid, await picture(page))).mean > 0.01);
  await page.locator("label", { has: page.locator(by_test("mesh-hexahedra")) }).click();
  assert.equal(await picture(page), solid);
});

test("sizes, numbers, worst hexahedron, fit, way and files stand beside what was asked for, and the field is folded away", async () => {
  const { page } = await shared_page("hexahedra");
  const { report } = scene_named("hexahedra");
  const text = (test) => page.locator(by_test(test)).innerText();
  assert.equal(await text("number-size"), "3.33 mm\nnot 4 mm");
  assert.equal(await text("number-hexahedra"), "432\nabout 250 expected");
  assert.match(await text("number-worst"), /^−1, inverted\nof hexahedron 1, 0\.99 in the mean$/);
  assert.equal(await text("mesh-fit"), "volume −0.12 %, area +0.2 % of the CAD model; surface up to 0.1 mm from the mesh, mesh up to 0.13 mm off the surface");
  assert.equal(await text("mesh-way"), "attempt 1 of 2: field on 8748 tets of 2, repaired");
  assert.equal(await text("mesh-files"), "hexahedra.partial.vtu, hexahedra.hexex");
  // What is rounding is said to be nothing.
  const { report: { hexahedra } } = scene_named("all_hex");
  const exact = { ...report, hexahedra: { ...hexahedra, volume: 16000.0000001, area: 4000, largest_distance: 1e-14, largest_distance_of_model: 0 } };
  const other = await open(page_file("exact", filled_page(template, exact, null)));
  assert.equal(await other.page.locator(by_test("mesh-fit")).innerText(), "volume ±0 %, area ±0 % of the CAD model; on the surface");
  await other.page.close();
  const beside = { ...report, hexahedra: { ...exact.hexahedra, largest_distance_of_model: 0.03 } };
  const third = await open(page_file("beside", filled_page(template, beside, null)));
  assert.equal(await third.page.locator(by_test("mesh-fit")).innerText(), "volume ±0 %, area ±0 % of the CAD model; surface up to 0.03 mm from the mesh");
  await third.page.close();
  // Numbers of the field say nothing of the mesh.
  for (const test of ["number-energy", "alignment-max", "levels", "answer"]) assert.equal(await page.locator(by_test(test)).isVisible(), false, test);
  await page.locator(`${by_test("field-of-mesh")} > summary`).click();
  assert.equal(await page.locator(by_test("answer")).textContent(), report.answer);
  assert.ok(await page.locator(by_test("number-energy")).isVisible());
  await page.locator(`${by_test("field-of-mesh")} > summary`).click();
});

test("singular lines are those of the field until they are asked for on the mesh", async () => {
  const { page } = await shared_page("hexahedra");
  await change(page, { cut: { on: false }, below: 0.5 });
  const without = await picture(page);
  const [lines, of_mesh] = [by_test("show-arcs"), by_test("show-mesh_lines")];
  assert.equal(await page.locator(lines).isVisible(), false);
  assert.equal(await page.locator(of_mesh).isChecked(), false);
  await page.locator("label", { has: page.locator(of_mesh) }).click();
  assert.ok((await difference(page, without, await picture(page))).mean > 0.001);
  assert.match(await page.locator(by_test("legend-arcs")).innerText(), /Singular lines, on the tets/);
  assert.match(await page.evaluate(() => window.crossgrain.link()), /show=[^&]*mesh_lines/);
  await page.keyboard.press("s");
  assert.equal(await picture(page), without);
  await change(page, { layers: { hexahedra: false } });
  assert.equal(await page.locator(lines).isChecked(), true);
});

test("hexahedra take the colours of faces and of regions, and the legend and links say so", async () => {
  const { page } = await shared_page("all_hex");
  const colors = new Set([await picture(page)]);
  assert.equal(await page.locator(by_test("hex-color-shape")).isChecked(), true);
  for (const [color, legend] of [["face", /^Faces of the model\s+A colour for each of 6; a click tells its number\.$/], ["region", /^Regions\s+3\s+8$/]]) {
    await page.locator("label", { has: page.locator(by_test(`hex-color-${color}`)) }).click();
    assert.match(await page.locator("#legend-body").innerText(), legend);
    colors.add(await picture(page));
    await keep_screenshot(page, `hex-color-${color}-desktop-light`);
  }
  assert.equal(colors.size, 3);
  const link = await page.evaluate(() => window.crossgrain.link());
  assert.match(link, /hexahedra=region/);
  await page.locator("#view").press("m");
  assert.equal((await state(page)).hex_color, "shape");
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await page.waitForFunction(() => window.crossgrain.state().hex_color === "region");
  await change(page, { hex_color: "shape" });
  // A mesh of one region has no colours for it.
  const { page: other } = await shared_page("hexahedra");
  assert.equal(await other.locator(by_test("hex-color-face")).count(), 1);
  assert.equal(await other.locator(by_test("hex-color-region")).count(), 0);
});

test("the cut moves to a place that it has taken away or that hexahedra hide, and not to one that is seen", async () => {
  const { page } = await shared_page("all_hex");
  const fit = page.locator(by_test("worst-place"), { hasText: "Worst fit" });
  // On the edge between the sides of high x and high y.
  const at = scene_named("all_hex").report.hexahedra.largest_distance_place;
  const is_kept = ({ cut: { axis, position, flip } }) => {
    const k = "xyz".indexOf(axis);
    const [low, high] = k === 2 ? [-20, 20] : [-10, 10];
    const above = at[k] - (low + position * (high - low));
    return (flip ? -above : above) <= 1e-6;
  };
  for (const [cut, view] of [[{ on: true, axis: "x", position: 0.4, flip: false }, "right"], [{ on: true, axis: "x", position: 0.9, flip: true }, "left"], [{ on: false }, "front"]]) {
    await change(page, { cut: { clip: true, ...cut } });
    await page.evaluate((name) => window.crossgrain.setView(name), view);
    await page.locator(by_test("tab-field")).click();
    await fit.click();
    const there = await state(page);
    assert.ok(there.cut.on && is_kept(there), `${JSON.stringify(there.cut)}`);
    // What is picked there is a hexahedron that has the place.
    const picked = await page.evaluate((point) => window.crossgrain.pickAt(...window.crossgrain.screenOf(point)), at.map((value, k) => (k < 2 ? value - 0.5 : value)));
    assert.ok(picked && Math.hypot(...picked.center.map((value, k) => value - at[k])) < 4, `${JSON.stringify(picked)}`);
    await page.locator(by_test("tag-clear")).click();
  }
  await keep_screenshot(page, "worst-fit-desktop-light");
  await change(page, { cut: { on: false } });
  await page.evaluate(() => window.crossgrain.setView("right"));
  await page.locator(by_test("tab-field")).click();
  await fit.click();
  assert.equal((await state(page)).cut.on, false);
  await page.locator(by_test("tag-clear")).click();
});

/** Pixels near one: how many have the colour of what is picked, and how many lie about where the hexahedron is seen. */
const crimson_around = (page, point) => page.evaluate(async (at) => {
  await window.crossgrain.drawn();
  const view = document.getElementById("view");
  const [x, y] = window.crossgrain.screenOf(at);
  const size = 120;
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [size, size];
  const drawing = canvas.getContext("2d", { willReadFrequently: true });
  const scale = view.width / view.clientWidth;
  drawing.drawImage(view, (x - size / 2) * scale, (y - size / 2) * scale, size * scale, size * scale, 0, 0, size, size);
  const { data } = drawing.getImageData(0, 0, size, size);
  let count = 0;
  for (let k = 0; k < data.length; k += 4) if (data[k] > 150 && data[k + 1] < 120 && data[k + 2] > 60 && data[k + 2] < 200) ++count;
  return count;
}, point);

for (const [name, mesh_of] of [["hexahedra", hex_mesh(true)], ["all_hex", hex_mesh(false)]]) {
  test(`the worst hexahedron is shown alone and named, ${name === "all_hex" ? "inside the part" : "at its surface"}`, async () => {
    const { page } = await shared_page(name);
    const before_it = await picture(page);
    const worst = page.locator(by_test("worst-place")).first();
    assert.match(await worst.innerText(), /Worst hexahedron/);
    await worst.click();
    const there = await state(page);
    assert.deepEqual(there.marked.point, mesh_of.worst_place);
    assert.equal(there.hexahedron, mesh_of.worst);
    assert.equal(there.alone, true);
    assert.equal(there.hexahedra, 1, "others are not shown as solid");
    const shape = mesh_of.shapes[mesh_of.worst];
    assert.equal(await page.locator(by_test("tag")).innerText(), `Hexahedron ${mesh_of.worst + 1}: scaled Jacobian ${shape <= 0 ? "−1, inverted" : shape.toPrecision(2)}`);
    // Outlined, with nothing in front of its lines, and the rest pale.
    assert.ok((await crimson_around(page, mesh_of.worst_place)) > 60, `${await crimson_around(page, mesh_of.worst_place)} pixels are marked`);
    assert.ok((await difference(page, before_it, await picture(page))).mean > 0.02);
    await keep_screenshot(page, `worst-${name}-desktop-light`);
    await page.locator(by_test("tag-clear")).click();
    assert.equal((await state(page)).alone, false);
    assert.equal(await page.locator(by_test("tag")).isVisible(), false);
    // A cut shows all again as well.
    await worst.click();
    await page.locator(by_test("cut-position")).fill("0.4");
    assert.equal((await state(page)).alone, false);
  });
}

test("a click on a face names the face, its set in the files, and what the report says of it", async () => {
  const { page } = await shared_page("hexahedra");
  await change(page, { cut: { on: false } });
  await page.evaluate(() => window.crossgrain.setView("front"));
  await page.mouse.click(...(await page.evaluate(() => window.crossgrain.screenOf([1.7, -10, 5]))));
  const text = (test) => page.locator(by_test(test)).innerText();
  assert.equal(await text("face-title"), "Face 3");
  assert.equal(await text("face-kind"), "plane");
  assert.equal(await text("face-area"), "800 mm²");
  assert.equal(await text("face-quads"), "72");
  assert.equal(await page.locator(by_test("face-set")).count(), 0, "a mesh with an inverted hexahedron has no file with sets");
  assert.equal(await text("tag"), "Face 3 · plane");
  assert.match(await text("cell-title"), /^Hexahedron /);
  assert.match(await page.locator(by_test("announcement")).textContent(), /on Face 3 · plane\.$/);
  await keep_screenshot(page, "picked-face-hexahedra-desktop-light");
  // A cut shows hexahedra inside, which lie on no face.
  await change(page, { cut: { on: true, axis: "y", position: 0.5, flip: true, clip: true }, face: null });
  await page.mouse.click(...(await page.evaluate(() => window.crossgrain.screenOf([1.7, 0, 5]))));
  assert.ok((await state(page)).hexahedron >= 0);
  assert.equal((await state(page)).face, null);
});

test("the table of faces is sorted by its heads, marks faces without quads, and shows the face of a row", async () => {
  const { page } = await shared_page("hexahedra");
  await page.locator(`${by_test("faces")} > summary`).click();
  const rows = () => page.locator(`${by_test("faces")} tbody tr`).allInnerTexts();
  const numbers = async () => (await rows()).map((row) => Number(row.split(/\s/)[0]));
  assert.deepEqual(await numbers(), [1, 2, 3, 4, 5, 6, 7]);
  assert.deepEqual((await rows())[6].split(/\s+/), ["7", "cylinder", "0.8", "0"]);
  await page.locator(by_test("sort-area")).click();
  assert.deepEqual(await numbers(), [7, 5, 6, 1, 2, 3, 4]);
  await page.locator(by_test("sort-area")).click();
  assert.deepEqual(await numbers(), [1, 2, 3, 4, 5, 6, 7]);
  assert.equal(await page.locator(`${by_test("faces")} tr.lacking`).count(), 1);
  await page.locator(`${by_test("faces")} tbody tr`).nth(1).click();
  const { face, camera } = await state(page);
  assert.equal(face.number, 2);
  assert.ok(camera.position[0] - camera.target[0] > 10, "it is looked at from outside");
  assert.equal(await page.locator(by_test("tag")).innerText(), "Face 2 · plane");
  await page.locator(`${by_test("faces")} > summary`).click();
});

test("on a phone the worst hexahedron is named too, and a tap beside it shows all", by_night, async () => {
  const { page } = await shared_page("hexahedra", { device: kPhone, scheme: "dark" });
  await page.locator(by_test("tab-field")).tap();
  await page.locator(by_test("worst-place")).first().tap();
  assert.match(await page.locator(by_test("tag")).innerText(), /^Hexahedron \d+: scaled Jacobian −1, inverted$/);
  await keep_screenshot(page, "worst-phone-dark");
  const { left, top } = await page.evaluate(() => window.crossgrain.free());
  await page.touchscreen.tap(left + 12, top + 12);
  assert.equal((await state(page)).alone, false);
});
