// SPDX-License-Identifier: Apache-2.0
// The page of a mesh of hexahedra.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { hex_mesh } from "../../viewer/tests/hex_scene.mjs";
import { difference, keep_screenshot, kDesktop, launch, open, picture, scene_file, SharedPages, state } from "./browser.mjs";

let browser;
const shared = new SharedPages();
before(async () => (browser = await launch()));
after(() => browser?.close());

const by_test = (name) => `[data-testid="${name}"]`;
const mesh = hex_mesh();
const total = mesh.hexahedra.length;
const center_of = (corners) => [0, 1, 2].map((axis) => corners.reduce((sum, point) => sum + mesh.points[point][axis] / 8, 0));
/** A move of the mouse that no slider or key is needed for. */
const change = (page, part) => page.evaluate((wanted) => window.crossgrain.change(wanted), part);

test("hexahedra are shown first, cut, with what the report says of them", async () => {
  const { page, problems } = await shared.page(browser, "hexahedra");
  assert.equal((await state(page)).layers.hexahedra, true);
  assert.match(await page.locator(by_test("hexahedra")).innerText(), /^!\s*Partial mesh: 432 hexahedra, scaled Jacobian −1\.00 at least, 0\.99 in the mean, 1 inverted\s+1 hexahedron is inverted; mesh it with edges of 3\.6\.$/i);
  assert.match(await page.locator(by_test("badge")).textContent(), /partial mesh$/i);
  assert.match(await page.locator(by_test("shown")).innerText(), /^\d+ hexahedra shown\.$/);
  const legend = (await page.locator(by_test("legend-hexahedra")).innerText()).replace(/\s+/g, " ");
  assert.match(legend, /^Hexahedra in the mesh 432 shown \d+ inverted 1$/);
  assert.equal(await page.locator(by_test("legend-ramp")).count(), 1);
  assert.deepEqual(problems, []);
});

test("a cut takes away the hexahedra whose centres are above it", async () => {
  const { page } = await shared.page(browser, "hexahedra");
  for (const [axis, k] of [["x", 0], ["y", 1], ["z", 2]]) {
    for (const position of [0.1, 0.37, 0.81]) {
      await change(page, { cut: { axis, position, on: true, clip: true, flip: false } });
      const low = k === 2 ? -20 : -10;
      const at = low - 2 * low * position;
      const expected = mesh.hexahedra.filter((corners) => center_of(corners)[k] < at).length;
      assert.equal((await state(page)).hexahedra, expected, `${axis} ${position}`);
      assert.equal(await page.locator(by_test("shown")).innerText(), `${expected} hexahedra shown.`);
    }
  }
  await change(page, { cut: { clip: false } });
  assert.equal((await state(page)).hexahedra, total);
});

test("a limit leaves the hexahedra of worse shapes, and goes into links", async () => {
  const { page } = await shared.page(browser, "hexahedra");
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
  const other = await open(browser, scene_file("hexahedra") + new URL(link).hash, { device: kDesktop });
  assert.equal((await state(other.page)).below, 0.9);
  assert.equal((await state(other.page)).hexahedra, expected);
  await other.context.close();
  await page.locator(by_test("below")).fill("0");
  assert.equal((await state(page)).hexahedra, 1);
  await change(page, { below: 1 });
});

test("a click on a hexahedron shows its number and its shape", async () => {
  const { page } = await shared.page(browser, "hexahedra");
  await change(page, { cut: { on: false }, below: 1 });
  await page.evaluate(() => window.crossgrain.setView("front"));
  // On the side across y with the low coordinates.
  const number = 6 * 6 * 4 + 3;
  const [x, , z] = center_of(mesh.hexahedra[number]);
  const at = await page.evaluate((point) => window.crossgrain.screenOf(point), [x, -10, z]);
  await page.mouse.click(...at);
  assert.equal((await state(page)).hexahedron, number);
  assert.equal(await page.locator(by_test("cell-title")).innerText(), `Hexahedron ${number}`);
  assert.equal(await page.locator(by_test("hexahedron-shape")).innerText(), "1.000");
  assert.equal(await page.locator(by_test("hexahedron-edges")).innerText(), "3.33 to 3.33 mm");
  await keep_screenshot(page, "picked-hexahedron-desktop-light");
  await page.locator(by_test("cell-close")).click();
  assert.equal((await state(page)).hexahedron, -1);
  await page.mouse.click(...(await page.evaluate(() => window.crossgrain.screenOf([-8, -10, -18]))));
  assert.equal(await page.locator(by_test("hexahedron-shape")).innerText(), "−1.000, inverted");
});

test("the field is there where it is asked for, and only then what concerns it alone", async () => {
  const { page } = await shared.page(browser, "hexahedra");
  const solid = await picture(page);
  assert.equal(await page.locator(by_test("glyph-density")).isVisible(), false);
  await page.locator("label", { has: page.locator(by_test("mesh-field")) }).click();
  assert.equal(await page.locator(by_test("glyph-density")).isVisible(), true);
  assert.match(await page.locator(by_test("shown")).innerText(), /^The field on [\d,]+ tets\.$/);
  assert.equal(await page.locator(by_test("legend-hexahedra")).count(), 0);
  assert.ok((await difference(page, solid, await picture(page))).mean > 0.01);
  await page.locator("label", { has: page.locator(by_test("mesh-hexahedra")) }).click();
  assert.equal(await picture(page), solid);
});

test("the worst hexahedron is the first place to look at", async () => {
  const { page } = await shared.page(browser, "hexahedra");
  const worst = page.locator(by_test("worst-place")).first();
  assert.match(await worst.innerText(), /Worst hexahedron/);
  await worst.click();
  assert.deepEqual((await state(page)).marked.point, [-8, -8, -18]);
});
