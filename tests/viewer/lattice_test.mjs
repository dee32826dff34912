// SPDX-License-Identifier: Apache-2.0
// Pages of hexahedra that follow no field: of a lattice, of a mesh that was given, and where no map was taken.

import assert from "node:assert/strict";
import { test } from "node:test";

import { check_opening, difference, keep_screenshot, kPhone, picture, scene_named, shared_page, state } from "./browser.mjs";

const by_test = (name) => `[data-testid="${name}"]`;
const text = (page, name) => page.locator(by_test(name)).innerText();
const change = (page, part) => page.evaluate((wanted) => window.crossgrain.change(wanted), part);
const choose = (page, name) => page.locator("label", { has: page.locator(by_test(name)) }).click();

// What concerns a field alone: controls, panels, words.
const kOfField = ["map-none", "glyph-shape-curve", "glyph-density", "show-arcs", "show-nodes", "show-mesh_lines", "show-streamlines", "show-cells", "field-main", "levels", "answer", "verdict",
  "number-energy", "number-cells", "number-arcs", "alignment-note", "field-of-mesh", "further-reasons", "places-found-in-the-input", "legend-arcs", "legend-axes", "unfinished"];

test("a lattice opens without complaint, with its hexahedra first", async () => {
  await check_opening("lattice");
  const { page } = await shared_page("lattice");
  assert.equal(await text(page, "shown"), "216 of 432 hexahedra");
  assert.equal((await page.locator("#legend-body").innerText()).replace(/\s+/g, " "), "Scaled Jacobian 0 0.5 1 0.18 at least, 0.99 in the mean");
});

for (const name of ["lattice", "fitted"]) {
  test(`nothing of a field is on the page of hexahedra without one: ${name}`, async () => {
    const { page, problems } = await shared_page(name);
    for (const mode of ["mesh-hexahedra", "mesh-field"]) {
      await choose(page, mode);
      for (const part of kOfField) assert.equal(await page.locator(by_test(part)).count(), 0, `${part} with ${mode}`);
    }
    await choose(page, "mesh-hexahedra");
    assert.equal(await page.locator(by_test("tab-field")).innerText(), "Mesh");
    assert.equal(await page.locator(by_test("tab-cell")).innerText(), "Hexahedron");
    assert.match(await page.locator(by_test("cell-empty")).textContent(), /^Click a hexahedron /);
    const said = await page.locator("body").innerText();
    assert.doesNotMatch(said, /NaN|undefined|null|Infinity|\bfield\b|frames|energy|singular/i);
    assert.deepEqual(problems, []);
  });
}

test("the model is there where it is asked for, and its faces can be picked", async () => {
  const { page, problems } = await shared_page("lattice");
  await change(page, { cut: { on: false } });
  await page.evaluate(() => window.crossgrain.setView("front"));
  const solid = await picture(page);
  await page.keyboard.press("q");
  assert.equal(await page.locator(by_test("mesh-field")).isChecked(), true);
  assert.equal(await text(page, "shown"), "The surface of the model.");
  assert.equal(await page.locator("#legend").isVisible(), false);
  assert.ok((await difference(page, solid, await picture(page))).mean > 0.01);
  const at = await page.evaluate(() => window.crossgrain.screenOf([1.7, -10, 5]));
  await page.mouse.click(...at);
  assert.equal(await text(page, "face-title"), "Face 3");
  assert.match(await page.locator(by_test("announcement")).textContent(), /^Face 3 · plane\.$/);
  await keep_screenshot(page, "lattice-model-desktop-light");
  // The face of a cut is none of the model's.
  await change(page, { cut: { on: true, axis: "y", position: 0.5, flip: true, clip: true }, face: null });
  await page.mouse.click(...at);
  assert.equal((await state(page)).face, null);
  await page.keyboard.press("q");
  assert.equal((await state(page)).layers.hexahedra, true);
  assert.deepEqual(problems, []);
});

test("keys that concern fields do nothing, and are not listed", async () => {
  const { page, problems } = await shared_page("lattice");
  const before = await picture(page);
  for (const key of ["s", "n", "l", "g", "e", "b"]) await page.keyboard.press(key);
  assert.equal(await picture(page), before);
  await page.keyboard.press("?");
  const listed = await page.locator("#help").innerText();
  assert.match(listed, /hexahedra or the model/);
  assert.doesNotMatch(listed, /singular|streamlines|frames|cells|curves/);
  await page.keyboard.press("Escape");
  assert.deepEqual(problems, []);
});

test("the panel says by what way, the mean edge beside the size asked for, both distances, and what is not kept", async () => {
  const { page } = await shared_page("lattice");
  assert.match(await text(page, "hexahedra"), /^✓\s*All-hex by a lattice: 432 hexahedra/i);
  assert.match(await page.locator(by_test("badge")).textContent(), /all-hex by a lattice$/);
  assert.equal(await text(page, "number-size"), "3.33 mm\nasked for: 4 mm, lattice: 3.33 mm");
  // 0.06 of the size is more than what is known at vertices.
  assert.equal(await text(page, "mesh-fit"), "volume −0.12 %, area +0.2 % of the CAD model; surface up to 0.1 mm from the mesh, mesh up to 0.24 mm off the surface");
  assert.equal(await text(page, "mesh-features"), "8 of 8 corners, 11 of 12 creases, 6 of 6 faces kept");
  assert.match(await text(page, "places-not-kept-of-the-model"), /Crease 5\s*50 % kept/);
  assert.match(await text(page, "warnings"), /1 of 7 faces has no quads/);
  await page.locator(`${by_test("places-not-kept-of-the-model")} button`).click();
  assert.deepEqual((await state(page)).marked.point, [10, 10, 0]);
});

test("of hexahedra that were given it tells no forecast", async () => {
  const { page } = await shared_page("fitted");
  assert.equal(await text(page, "number-hexahedra"), "432");
  assert.match(await text(page, "hexahedra"), /^✓\s*All-hex: 432 hexahedra/i);
});

test("a field that the mesh does not follow stands below, with what is wrong with it", async () => {
  const { page, problems } = await shared_page("fallback");
  const { report } = scene_named("fallback");
  assert.match(await text(page, "hexahedra"), /^✓\s*All-hex by a lattice: 432 hexahedra/i);
  assert.equal(await page.locator(by_test("warnings")).first().innerText(), "1 of 7 faces has no quads: 7");
  const fold = page.locator(by_test("field-of-mesh"));
  assert.equal(await fold.locator("summary").first().innerText(), "The field along which maps were tried");
  assert.equal(await page.locator(by_test("answer")).isVisible(), false);
  assert.equal(await page.locator(by_test("show-mesh_lines")).count(), 0, "its lines are none of the mesh");
  const before = await picture(page);
  await page.keyboard.press("s");
  assert.equal(await picture(page), before);
  await fold.locator("summary").first().click();
  const said = await fold.innerText();
  assert.ok(said.includes(`No map was taken, since ${report.hexahedra.map_fault}`), said);
  assert.ok(said.includes("the sweeps on the grid ran out"), said);
  await fold.locator("summary").first().click();
  assert.deepEqual(problems, []);
});

test("on a phone the outcome and the tabs fit beside each other", async () => {
  const { page, problems } = await shared_page("lattice", { device: kPhone, scheme: "dark" });
  await keep_screenshot(page, "lattice-phone-dark");
  const [name, badge] = await Promise.all([by_test("part-name"), by_test("badge")].map((part) => page.locator(part).boundingBox()));
  assert.ok(name.x + name.width <= badge.x && badge.x + badge.width <= 390, `${JSON.stringify([name, badge])}`);
  assert.deepEqual(problems, []);
});
