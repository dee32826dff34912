// SPDX-License-Identifier: Apache-2.0
// What covers what, at three sizes, light and dark: no text lies under anything or is cut off, the part lies in what controls and legends
// leave free, and the lines of meshes are seen against their faces.

import assert from "node:assert/strict";
import { test } from "node:test";

import { keep_screenshot, keeps_screenshots, kNightly, kPhone, of_the_day, shared_page, state } from "./browser.mjs";

/** Texts that something lies over, or that are cut off, as sentences; runs in the page. */
function hidden_texts() {
  const found = [];
  /** The part of a rectangle that is not scrolled out of sight. */
  const in_sight = (box, element) => {
    let { left, right, top, bottom } = box;
    for (let one = element; one; one = one.parentElement) {
      if (getComputedStyle(one).overflowY === "visible" && getComputedStyle(one).overflowX === "visible") continue;
      const around = one.getBoundingClientRect();
      [left, right, top, bottom] = [Math.max(left, around.left), Math.min(right, around.right), Math.max(top, around.top), Math.min(bottom, around.bottom)];
    }
    return { left, right: Math.min(right, innerWidth), top, bottom: Math.min(bottom, innerHeight) };
  };
  const belong = (a, b) => a.contains(b) || b.contains(a) || (a.closest("label") !== null && a.closest("label") === b.closest("label")) || (a.closest("svg") !== null && a.closest("svg") === b.closest("svg"));
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const node = walker.currentNode;
    const element = node.parentElement;
    const text = node.textContent.trim();
    if (!text || /^(SCRIPT|STYLE|OPTION|TITLE)$/.test(element.tagName) || !element.checkVisibility() || element.closest(".visually-hidden, title")) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    for (const line of range.getClientRects()) {
      const { left, right, top, bottom } = in_sight(line, element);
      if (right - left < 4 || bottom - top < 0.6 * line.height) continue;
      for (const x of [left + 2, (left + right) / 2, right - 2]) {
        const above = document.elementFromPoint(x, (top + bottom) / 2);
        if (above && !belong(above, element)) found.push(`"${text.slice(0, 40)}" lies under ${above.tagName}.${above.className || above.id}`);
      }
      if (line.width > 4 && line.right - right > 2 && getComputedStyle(element).textOverflow !== "ellipsis" && !element.closest(".matrix-scroll, .face-scroll, h1")) found.push(`"${text.slice(0, 40)}" is cut off at the right`);
    }
  }
  return found;
}

/** How far, in CSS pixels, the part reaches out of what is free; runs in the page. */
async function reach_of_part() {
  await window.crossgrain.drawn();
  const view = document.getElementById("view");
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [view.clientWidth, view.clientHeight];
  const drawing = canvas.getContext("2d", { willReadFrequently: true });
  drawing.drawImage(view, 0, 0, canvas.width, canvas.height);
  const { data } = drawing.getImageData(0, 0, canvas.width, canvas.height);
  const free = window.crossgrain.free();
  let [left, right, top, bottom] = [Infinity, 0, Infinity, 0];
  for (let y = 0; y < canvas.height; ++y) for (let x = 0; x < canvas.width; ++x) {
    const at = 4 * (y * canvas.width + x);
    if (Math.abs(data[at] - data[0]) + Math.abs(data[at + 1] - data[1]) + Math.abs(data[at + 2] - data[2]) < 30) continue;
    [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
  }
  // What is free lies beside all that is over the view.
  const over = ["panel-view", "toolbar", "shown", "legend"].map((id) => document.getElementById(id)).filter((part) => part.checkVisibility()).map((part) => part.getBoundingClientRect());
  const covered = over.some((box) => box.width > 0 && box.left < free.right && box.right > free.left && box.top < free.bottom && box.bottom > free.top);
  const middle = [(left + right - free.left - free.right) / 2, (top + bottom - free.top - free.bottom) / 2];
  return { out: Math.max(free.left - left, right - free.right, free.top - top, bottom - free.bottom), covered, middle: middle.map(Math.abs), free: [free.right - free.left, free.bottom - free.top] };
}

async function with_schemes(page, act) {
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    await page.waitForFunction((scheme) => window.crossgrain.state().resolved_theme === scheme, colorScheme);
    await page.evaluate(() => window.crossgrain.drawn());
    await act(colorScheme);
  }
}

async function keep_schemes(page, name) {
  if (keeps_screenshots) await with_schemes(page, (scheme) => keep_screenshot(page, `${name}-${scheme}`));
}

async function check_layout(page, name, size) {
  const reach = await page.evaluate(reach_of_part);
  assert.equal(reach.covered, false, `${name}, ${size}: what counts as free is covered`);
  assert.ok(reach.out <= 2, `${name}, ${size}: the part reaches ${reach.out} pixels out of what is free`);
  reach.middle.forEach((away, axis) => assert.ok(away < 0.06 * reach.free[axis] + 4, `${name}, ${size}: the part is ${away} pixels beside the middle`));
  assert.deepEqual(await page.evaluate(hidden_texts), [], `${name}, ${size}`);
  await keep_schemes(page, `layout-${name}-${size}`);
}

/** That the part stays in what is free in views of other sizes, and fills them as before where the view comes back. */
async function check_other_sizes(page) {
  const distance = async () => {
    const { position, target } = (await state(page)).camera;
    return Math.hypot(...position.map((value, k) => value - target[k]));
  };
  const resize = async (width, height) => {
    await page.setViewportSize({ width, height });
    await page.waitForFunction((wanted) => document.getElementById("view").width === Math.floor(document.getElementById("stage").clientWidth / 2) && document.getElementById("stage").clientHeight === wanted, height);
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  };
  // The field on the cut is most of what there is to draw.
  await page.evaluate(() => window.crossgrain.change({ cut: { on: false } }));
  await resize(1440, 900);
  const first = await distance();
  for (const [width, height] of [[1024, 700], [820, 1100], [1440, 900]]) {
    await resize(width, height);
    const { out, covered } = await page.evaluate(reach_of_part);
    assert.ok(!covered && out <= 2, `${width} x ${height}: ${out} pixels out`);
  }
  assert.ok(Math.abs((await distance()) / first - 1) < 0.02, "the view is as it was");
}

for (const name of of_the_day(["hexahedra", "components", "tets"], "hexahedra")) {
  test(`${name}: nothing covers texts or the part, on a phone and on a desktop, by night on a large one too`, async () => {
    const { page: desktop } = await shared_page(name);
    await check_layout(desktop, name, "1440x900");
    // With what is looked at named in the view.
    await desktop.locator('[data-testid="worst-place"]').first().click();
    await desktop.evaluate(() => window.crossgrain.drawn());
    assert.deepEqual(await desktop.evaluate(hidden_texts), [], `${name} with a place`);
    await desktop.locator('[data-testid="tag-clear"]').click();
    await desktop.locator('[data-testid="fit"]').click();
    if (kNightly) {
      await desktop.setViewportSize({ width: 2560, height: 1440 });
      await desktop.waitForFunction(() => document.getElementById("view").width === document.getElementById("view").clientWidth / 2);
      await check_layout(desktop, name, "2560x1440");
    }
    if (name === "components") await check_other_sizes(desktop);
    const { page: phone } = await shared_page(name, { device: kPhone });
    await check_layout(phone, name, "390x844");
    await phone.locator('[data-testid="tab-field"]').tap();
    assert.deepEqual(await phone.evaluate(hidden_texts), [], `${name} with the drawer open`);
    await keep_schemes(phone, `layout-${name}-drawer-390x844`);
  });
}

test("on a screen of 1024 x 768 most of the width is for the part, and the controls are a tab away", async () => {
  const { page } = await shared_page("hexahedra", { device: { viewport: { width: 1024, height: 768 } } });
  const { left, right } = await page.evaluate(() => window.crossgrain.free());
  assert.ok(right - left > 0.65 * 1024, `${right - left}`);
  assert.equal(await page.locator('[data-testid="panel-view"]').isVisible(), false);
  await check_layout(page, "hexahedra", "1024x768");
  await page.locator('[data-testid="tab-view"]').click();
  assert.ok(await page.locator('[data-testid="cut-position"]').isVisible());
  assert.deepEqual(await page.evaluate(hidden_texts), [], "with the controls");
  await keep_schemes(page, "layout-hexahedra-view-1024x768");
});

test("the legend of the field that hexahedra follow stands in one row at 1400 x 900", async () => {
  const { page } = await shared_page("hexahedra", { device: { viewport: { width: 1400, height: 900 } } });
  await page.evaluate(() => window.crossgrain.change({ layers: { hexahedra: false } }));
  const tops = await page.locator("#legend-body > *").evaluateAll((blocks) => blocks.map((block) => block.getBoundingClientRect().top));
  assert.ok(tops.length > 1 && new Set(tops).size === 1, `${tops}`);
});

/** The contrast by WCAG of what is at each point of lines, the most of a few pixels, to what is at a point of a face; runs in the page. */
async function contrasts_there(pairs) {
  await window.crossgrain.drawn();
  const view = document.getElementById("view");
  const scale = view.width / view.clientWidth;
  const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  canvas.canvas.width = view.width;
  canvas.canvas.height = view.height;
  canvas.drawImage(view, 0, 0);
  const channel = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
  const luminances = (point, reach) => {
    const [x, y] = window.crossgrain.screenOf(point).map((value) => Math.round(value * scale));
    const { data } = canvas.getImageData(x - reach, y - reach, 2 * reach + 1, 2 * reach + 1);
    return Array.from({ length: data.length / 4 }, (_, k) => 0.2126 * channel(data[4 * k] / 255) + 0.7152 * channel(data[4 * k + 1] / 255) + 0.0722 * channel(data[4 * k + 2] / 255));
  };
  return pairs.map(([line, face]) => {
    const [behind] = luminances(face, 0);
    return Math.max(...luminances(line, 1).map((ink) => (Math.max(ink, behind) + 0.05) / (Math.min(ink, behind) + 0.05)));
  });
}

// Half of what WCAG asks of texts: lines are many, and lie between faces of one colour.
const kLeastContrast = 2;

/** That the edges of hexahedra are seen against their faces. */
async function check_lines(page, size) {
  await page.evaluate(() => window.crossgrain.change({ cut: { on: false }, layers: { arcs: false, nodes: false, creases: false } }));
  await page.evaluate(() => window.crossgrain.setView("front"));
  // On the side that is seen: upright edges between two quads, and the middles of these; the first is inverted.
  const step = 10 / 3;
  const pairs = Array.from({ length: 5 * 12 }, (_, k) => [(k % 5) + 1, Math.floor(k / 5)]).map(([i, j]) => [[-10 + i * step, -10, -20 + (j + 0.5) * step], [-10 + (i - 0.5) * step, -10, -20 + (j + 0.5) * step]]);
  await with_schemes(page, async (scheme) => {
    const contrasts = await page.evaluate(contrasts_there, pairs);
    assert.ok(Math.min(...contrasts) >= kLeastContrast, `${size}, ${scheme}: ${Math.min(...contrasts).toFixed(2)} at least`);
    await keep_screenshot(page, `lines-${size}-${scheme}`);
  });
}

test("edges of hexahedra are seen against their faces, light and dark, on a phone and a desktop", async () => {
  for (const [size, device] of [["390x844", kPhone], ["900x600", { viewport: { width: 900, height: 600 } }]]) {
    const { page } = await shared_page("hexahedra", { device });
    await check_lines(page, size);
  }
});
