// SPDX-License-Identifier: Apache-2.0
// What people who cannot see well, or use no pointer, need of the page: names, contrast, focus.

import assert from "node:assert/strict";
import { test } from "node:test";

import { by_night, kDesktop, kPhone, of_the_day, shared_page } from "./browser.mjs";

/** Texts whose contrast to what is behind them is below WCAG 2 AA, as sentences. */
function faint_texts() {
  const channel = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * channel(r / 255) + 0.7152 * channel(g / 255) + 0.0722 * channel(b / 255);
  const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  // Any CSS colour as red, green, blue, alpha, whatever notation the browser gives it in.
  const parsed = (color) => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = color;
    canvas.fillRect(0, 0, 1, 1);
    const [r, g, b, a] = canvas.getImageData(0, 0, 1, 1).data;
    return [r, g, b, a / 255];
  };
  const over = (top, bottom) => [0, 1, 2].map((k) => top[3] * top[k] + (1 - top[3]) * bottom[k]);
  const behind = (element) => {
    const layers = [];
    for (let one = element; one; one = one.parentElement) layers.push(parsed(getComputedStyle(one).backgroundColor));
    return layers.reverse().reduce((below, layer) => over(layer, below), [255, 255, 255]);
  };
  const found = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const text = walker.currentNode.textContent.trim();
    const element = walker.currentNode.parentElement;
    if (!text || /^(SCRIPT|STYLE|OPTION)$/.test(element.tagName) || !element.checkVisibility() || element.closest(".visually-hidden")) continue;
    const style = getComputedStyle(element);
    const ink = parsed(element instanceof SVGElement ? style.fill : style.color);
    const back = behind(element);
    const [light, dark] = [luminance(over(ink, back)), luminance(back)].sort((a, b) => b - a);
    const ratio = (light + 0.05) / (dark + 0.05);
    const size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (ratio < (large ? 3 : 4.5)) found.push(`"${text.slice(0, 40)}" ${ratio.toFixed(2)}`);
  }
  return found;
}

/** Things to use that have no name, or are too small to hit. */
function faulty_controls() {
  const found = [];
  for (const control of document.querySelectorAll("button, input, select, summary, [role=tab], canvas[tabindex]")) {
    if (!control.checkVisibility()) continue;
    const labels = [...(control.labels ?? [])].map((label) => label.innerText).join(" ");
    const described = control.getAttribute("aria-label") ?? control.getAttribute("aria-roledescription") ?? "";
    if (!(labels + described + control.textContent).trim()) found.push(`no name: ${control.outerHTML.slice(0, 80)}`);
    const target = (control.labels?.[0] ?? control).getBoundingClientRect();
    if (target.width < 24 || (target.height < 23.5 && !control.matches("summary"))) found.push(`small: ${control.outerHTML.slice(0, 80)} ${target.width} x ${target.height}`);
  }
  return found;
}

test("texts of hexahedra are legible and their controls have names", async () => {
  const { page } = await shared_page("hexahedra");
  await page.evaluate(() => window.crossgrain.pickAt(...window.crossgrain.screenOf([-8, -10, -18])));
  assert.ok((await page.evaluate(() => window.crossgrain.state())).hexahedron >= 0);
  for (const panel of ["cell", "field"]) {
    await page.locator(`[data-testid="tab-${panel}"]`).click();
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      await page.waitForFunction((scheme) => window.crossgrain.state().resolved_theme === scheme, colorScheme);
      assert.deepEqual(await page.evaluate(faint_texts), [], `${panel}, ${colorScheme}`);
      assert.deepEqual(await page.evaluate(faulty_controls), [], panel);
    }
  }
});

const kDevices = { desktop: kDesktop, phone: kPhone };
for (const device_name of of_the_day(Object.keys(kDevices), "phone")) {
  const device = kDevices[device_name];
  test(`texts are legible and controls have names: ${device_name}, dark, by night light too`, async () => {
    const { page } = await shared_page("components", { device });
    const select = (panel) => page.locator(`[data-testid="tab-${panel}"]`).click();
    const check = async (where) => {
      for (const colorScheme of of_the_day(["light", "dark"], "dark")) {
        await page.emulateMedia({ colorScheme });
        await page.waitForFunction((scheme) => window.crossgrain.state().resolved_theme === scheme, colorScheme);
        assert.deepEqual(await page.evaluate(faint_texts), [], `${where}, ${colorScheme}`);
      }
    };
    await page.evaluate(() => window.crossgrain.change({ map: "alignment", glyph: { color: "tilt" } }));
    await page.evaluate(() => document.getElementById("legend").setAttribute("open", ""));
    for (const panel of ["field", "cell", "view"]) {
      if (panel === "view" && device !== kPhone) continue;
      if (panel === "cell") await page.evaluate(() => {
        const [x, y] = window.crossgrain.screenOf([60, 4, 0]);
        window.crossgrain.pickAt(x, y);
      });
      await select(panel);
      await check(panel);
      assert.deepEqual(await page.evaluate(faulty_controls), [], panel);
      if (device === kPhone) await select(panel);
    }
    if (device !== kPhone) {
      await page.keyboard.press("?");
      await check("help");
    }
  });
}

test("the Tab key visits the view, then its buttons, then the panels, and shows where it is", async () => {
  const { page } = await shared_page("components");
  const visited = [];
  for (let k = 0; k < 60; ++k) {
    await page.keyboard.press("Tab");
    const at = await page.evaluate(() => {
      const one = document.activeElement;
      if (!one || one === document.body) return null;
      const shown = one.matches(".segments input") ? one.nextElementSibling : one;
      const style = getComputedStyle(shown);
      return { name: one.dataset.testid ?? one.id ?? one.className, outline: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2, shown: one.checkVisibility() };
    });
    if (!at) break;
    visited.push(at);
  }
  for (const { name, outline, shown } of visited) assert.ok(outline && shown, `${name} does not show that it has the focus`);
  const names = visited.map(({ name }) => name);
  const order = ["view", "view-iso", "fit", "help-open", "map-none", "cut-on", "cut-position", "show-glyphs", "opacity"].map((name) => names.indexOf(name));
  const tab = names.indexOf("tab-field");
  assert.ok(order.every((place) => place >= 0) && tab >= 0, `${names}`);
  assert.deepEqual(order.slice(0, 4), [...order.slice(0, 4)].sort((a, b) => a - b), `${names}`);
  assert.deepEqual(order.slice(4), [...order.slice(4)].sort((a, b) => a - b), `${names}`);
});

test("the document has a title, a language, landmarks and one first heading", async () => {
  const { page } = await shared_page("ball");
  const facts = await page.evaluate(() => ({
    language: document.documentElement.lang, main: document.querySelectorAll("main").length, first: document.querySelectorAll("h1").length,
    live: document.querySelectorAll("[aria-live=polite]").length, view: document.getElementById("view").getAttribute("aria-label"),
  }));
  assert.equal(facts.language, "en");
  assert.equal(facts.main, 1);
  assert.equal(facts.first, 1);
  assert.ok(facts.live >= 1);
  assert.match(facts.view, /ball\.stl/);
});

test("who wants no motion gets none", by_night, async () => {
  const { page } = await shared_page("ball");
  for (const motion of ["reduce", "no-preference"]) {
    await page.emulateMedia({ reducedMotion: motion });
    await page.evaluate(() => window.crossgrain.setView("front"));
    const camera = () => page.evaluate(() => window.crossgrain.state());
    const { frames_drawn } = await camera();
    await page.evaluate(() => document.querySelector('[data-testid="view-top"]').click());
    // Whether it has flown or jumped, it gets there.
    await page.waitForFunction(() => {
      const { position, target } = window.crossgrain.state().camera;
      return Math.hypot(position[0] - target[0], position[1] - target[1]) < 0.01 * Math.abs(position[2] - target[2]);
    });
    await page.evaluate(() => window.crossgrain.drawn());
    const drawn = (await camera()).frames_drawn - frames_drawn;
    assert.ok(drawn >= 1 && (motion !== "reduce" || drawn <= 2), `${motion}: ${drawn} frames`);
  }
});
