// SPDX-License-Identifier: Apache-2.0
// The page of a field on tets, and what all pages do with the view: it faces the cut, fills the window, and goes into links and pictures.

import assert from "node:assert/strict";
import { test } from "node:test";

import { by_night, check_opening, check_said_once, difference, keep_screenshot, kDesktop, kPhone, of_the_day, open, picture, scene_named, shared_page, state } from "./browser.mjs";

const by_test = (name) => `[data-testid="${name}"]`;

test("tets opens without complaint and shows the part, and says each reason once", async () => {
  await check_opening("tets");
  await check_said_once((await shared_page("tets")).page, scene_named("tets").report);
});

test("with a field on tets, the page shows that, and the grid from which it started where it is asked for", async () => {
  const { page, problems } = await shared_page("tets");
  const { report } = scene_named("tets");
  const tets = report.onto.tets.toLocaleString("en-US");
  assert.equal(await page.locator(by_test("number-tets")).innerText().then((text) => text.split("\n")[0]), tets);
  assert.equal(await page.locator(by_test("number-arcs")).innerText(), "1\n0 nodes, on the tets");
  assert.equal(await page.locator(by_test("shown")).innerText(), `The field on ${tets} tets.`);
  assert.match((await page.locator(by_test("legend-arcs")).innerText()).replace(/\s+/g, " "), /^Singular lines, on the tets index \+1\/4 1$/);
  assert.match(await page.locator(by_test("legend-balls")).innerText(), /impossible for hexahedra\s+3/);
  const of_tets = await picture(page);
  await page.locator("label", { has: page.locator(by_test("field-grid")) }).click();
  assert.match((await page.locator(by_test("legend-arcs")).innerText()).replace(/\s+/g, " "), /^Singular lines, on the starting grid index \+1\/4 2 index −1\/4 2$/);
  assert.match(await page.locator(by_test("shown")).innerText(), /^The grid of [\d,]+ cells from which the field on the tets started; the answer is about the tets\.$/);
  assert.ok((await difference(page, of_tets, await picture(page))).mean > 1e-3);
  await page.locator("label", { has: page.locator(by_test("field-main")) }).click();
  assert.equal(await picture(page), of_tets);
  assert.deepEqual(problems, []);
});

test("a click on a cut through tets picks the tet there", async () => {
  const { page } = await shared_page("tets");
  // The bar's origin is its middle, so this is a point of the cut.
  const point = [3.1, -4.2, 0];
  const [x, y] = await page.evaluate((at) => window.crossgrain.screenOf(at), point);
  await page.mouse.click(x, y);
  const { picked } = await state(page);
  const tet = await page.evaluate((number) => window.crossgrain.describe(number), picked);
  assert.equal(tet.kind, "tet");
  assert.ok(Math.hypot(...tet.center.map((value, k) => value - point[k])) < 2, `${tet.center}`);
  assert.equal(await page.locator(by_test("cell-title")).innerText(), `Tet ${(picked + 1).toLocaleString("en-US")}`);
  assert.equal(await page.locator(by_test("cell-form")).count(), 0);
  await keep_screenshot(page, "picked-tet-desktop-light");
});

test("several places of a reason are folded beneath it, and opened on demand", async () => {
  const { page } = await shared_page("tets");
  const kind = page.locator(`${by_test("verdict")} ${by_test("kind")}`);
  assert.equal(await kind.locator("summary").innerText(), "Three places");
  assert.equal(await kind.locator(by_test("place")).first().isVisible(), false);
  await kind.locator("summary").click();
  assert.deepEqual(await kind.locator(by_test("place")).allInnerTexts(), [1, 2, 3].map((number) => `! Crease ${number}\n30.0°\n→`));
  await kind.locator(by_test("place")).nth(1).click();
  assert.deepEqual((await state(page)).marked.point, [10, 10, 0]);
});

test("a click on a face of a field names the face", async () => {
  const { page } = await shared_page("tets");
  await page.evaluate(() => window.crossgrain.change({ cut: { on: false }, opacity: 1 }));
  await page.evaluate(() => window.crossgrain.setView("right"));
  const clicked = await page.evaluate(() => window.crossgrain.screenOf([10, 3.3, 7]));
  const plain = await picture(page);
  await page.mouse.click(...clicked);
  assert.equal(await page.locator(by_test("face-title")).innerText(), "Face 2");
  assert.equal(await page.locator(by_test("face-set")).count(), 0, "there is no file with it");
  assert.equal(await page.locator(by_test("face-area")).count(), 0);
  assert.match(await page.locator(by_test("cell-title")).innerText(), /^Tet /);
  assert.ok((await difference(page, plain, await picture(page))).mean > 0.02, "it is tinted");
  await keep_screenshot(page, "picked-face-tets-desktop-light");
  await page.locator(by_test("cell-close")).click();
  assert.equal((await state(page)).face, null);
});

test("the part fills what is free of the view at first, and when another cut is chosen", async () => {
  for (const name of of_the_day(["ball", "plate", "tets", "components"], "ball", "tets")) {
    const { page } = await shared_page(name, { device: ["plate", "tets"].includes(name) ? kPhone : kDesktop });
    const share = () => page.evaluate(async () => {
      await window.crossgrain.change({ layers: { glyphs: false, arcs: false, nodes: false } });
      const view = document.getElementById("view");
      const small = document.createElement("canvas");
      [small.width, small.height] = [view.clientWidth, view.clientHeight];
      const drawing = small.getContext("2d", { willReadFrequently: true });
      drawing.drawImage(view, 0, 0, small.width, small.height);
      const { data } = drawing.getImageData(0, 0, small.width, small.height);
      let [left, right, top, bottom] = [Infinity, 0, Infinity, 0];
      for (let y = 0; y < small.height; ++y) for (let x = 0; x < small.width; ++x) {
        const at = 4 * (y * small.width + x);
        if (Math.abs(data[at] - data[0]) + Math.abs(data[at + 1] - data[1]) + Math.abs(data[at + 2] - data[2]) < 30) continue;
        [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
      }
      const free = window.crossgrain.free();
      return Math.max((right - left) / (free.right - free.left), (bottom - top) / (free.bottom - free.top));
    });
    const first = await share();
    assert.ok(first >= 0.8 && first <= 1, `${name}: ${first} of the view at first`);
    await page.evaluate(() => window.crossgrain.cutAcross("x"));
    const cut = await share();
    assert.ok(cut >= 0.8, `${name}: ${cut} of the view across x`);
  }
});

test("turning the cut on turns the view towards it", async () => {
  const { page } = await shared_page("tets");
  for (const axis of ["x", "y", "z"]) {
    await page.locator("label", { has: page.locator(by_test(`cut-axis-${axis}`)) }).click();
    const { camera, cut } = await state(page);
    const away = camera.position.map((value, k) => value - camera.target[k]);
    const along = away["xyz".indexOf(axis)] / Math.hypot(...away) * (cut.flip ? -1 : 1);
    const angle = (Math.acos(along) * 180) / Math.PI;
    assert.ok(angle > 24 && angle < 31, `${axis}: ${angle} degrees beside the normal`);
  }
});

test("any axis points up", async () => {
  const { page } = await shared_page("tets");
  for (const [axis, ahead] of [["x", [0, 0, -1]], ["y", [0, 0, 1]], ["z", [0, -1, 0]]]) {
    await page.locator(by_test(`up-${axis}`)).evaluate((input) => input.click());
    await page.evaluate(() => window.crossgrain.setView("front"));
    const { camera } = await state(page);
    const away = camera.position.map((value, k) => value - camera.target[k]);
    away.forEach((value, k) => assert.ok(Math.abs(value / Math.hypot(...away) - ahead[k]) < 1e-3, `${axis}: ${away}`));
    const [low, high] = await page.evaluate((k) => [0, 5].map((height) => window.crossgrain.screenOf([0, 1, 2].map((other) => (other === k ? height : 0)))), "xyz".indexOf(axis));
    assert.ok(high[1] < low[1] - 10 && Math.abs(high[0] - low[0]) < 1, `${axis} is up: ${low} ${high}`);
  }
});

test("a link restores the view", async () => {
  const { page } = await shared_page("tets");
  await page.evaluate(() => window.crossgrain.change({ map: "energy", field: "grid", up: "y", cut: { axis: "x", position: 0.3, flip: true }, glyph: { shape: "cube" } }));
  await page.locator("#view").focus();
  for (const key of ["ArrowLeft", "ArrowUp", "+"]) await page.keyboard.press(key);
  // The note goes away by itself, so it is awaited from before the click.
  await Promise.all([page.locator(by_test("note")).waitFor(), page.locator(by_test("link")).click()]);
  const link = await page.evaluate(() => window.crossgrain.link());
  const before_it = await picture(page);
  const second = await open(link);
  assert.equal(await second.page.locator(by_test("field-grid")).isChecked(), true);
  const { mean } = await difference(page, before_it, await picture(second.page));
  assert.ok(mean < 1e-3, `${mean}`);
  await second.page.close();
});

test("the picture that is saved is twice as fine as the view and has the legend in it", by_night, async () => {
  const { page } = await shared_page("tets");
  const facts = await page.evaluate(async () => {
    const image = new Image();
    image.src = await window.crossgrain.picture();
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const drawing = canvas.getContext("2d");
    drawing.drawImage(image, 0, 0);
    const legend = document.getElementById("legend").getBoundingClientRect();
    const { data } = drawing.getImageData(2 * legend.left, 2 * legend.top, 2 * legend.width, 2 * legend.height);
    let ink = 0;
    for (let k = 0; k < data.length; k += 4) if (data[k] + data[k + 1] + data[k + 2] < 250) ++ink;
    const view = document.getElementById("view");
    return { width: image.width / view.clientWidth, height: image.height / view.clientHeight, ink: (4 * ink) / data.length };
  });
  assert.deepEqual([facts.width, facts.height], [2, 2]);
  assert.ok(facts.ink > 0.008 && facts.ink < 0.4, `${facts.ink} of the legend is ink`);
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator(by_test("picture")).click()]);
  assert.equal(download.suggestedFilename(), "bar.png");
});

test("the half that is taken away has faint lines only", async () => {
  const { page } = await shared_page("tets");
  // The line is seen end on from the side; above the cut it is as faint as what lies behind.
  await page.evaluate(() => window.crossgrain.change({ cut: { axis: "z", flip: false }, layers: { part: false, creases: false, glyphs: false, nodes: false } }));
  await page.evaluate(() => window.crossgrain.setView("front"));
  const ink = () => page.evaluate(async () => {
    await window.crossgrain.drawn();
    const view = document.getElementById("view");
    const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    const red_at = (height) => {
      const [x, y] = window.crossgrain.screenOf([0, 0, height]);
      canvas.drawImage(view, (x * view.width) / view.clientWidth, (y * view.height) / view.clientHeight, 1, 1, 0, 0, 1, 1);
      return canvas.getImageData(0, 0, 1, 1).data[0];
    };
    return [red_at(-10), red_at(10)];
  });
  const [kept, taken] = await ink();
  assert.ok(kept < 110 && taken > 170, `${kept} ${taken}`);
  await page.evaluate(() => window.crossgrain.change({ cut: { clip: false } }));
  const [below, above] = await ink();
  assert.ok(Math.abs(below - above) < 10, `${below} ${above}`);
});

/** The darkest of three channels at points of the model, each with those a few pixels beside it along x. */
const dark_at = (page, points) => page.evaluate(async (all) => {
  await window.crossgrain.drawn();
  const view = document.getElementById("view");
  const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  const level = (x, y) => {
    canvas.drawImage(view, ((x - 1) * view.width) / view.clientWidth, ((y - 1) * view.height) / view.clientHeight, 2, 2, 0, 0, 2, 2);
    return Math.min(...[0, 4, 8, 12].map((k) => Math.max(...canvas.getImageData(0, 0, 2, 2).data.slice(k, k + 3))));
  };
  return all.map((point) => {
    const [x, y] = window.crossgrain.screenOf(point);
    return { on: level(x, y), beside: Math.min(level(x - 9, y), level(x + 9, y)) };
  });
}, points);

test("the cut shows the face between two regions as a dark line, straight across the cells", async () => {
  const { page } = await shared_page("regions");
  await page.evaluate(() => window.crossgrain.change({ cut: { axis: "z", position: 0.5, flip: false }, layers: { cells: false, glyphs: false, part: false } }));
  await page.evaluate(() => window.crossgrain.setView("top"));
  await keep_screenshot(page, "regions-desktop-light");
  const places = Array.from({ length: 25 }, (_, k) => -9 + 0.75 * k);
  for (const { on, beside } of await dark_at(page, places.map((y) => [-y / 4, y, 0]))) assert.ok(on < beside - 50, `${on} on the line, ${beside} beside it`);
  await page.evaluate(() => window.crossgrain.change({ layers: { creases: false } }));
  for (const { on, beside } of await dark_at(page, places.map((y) => [-y / 4, y, 0]))) assert.ok(on > beside - 10, `${on} without creases`);
});

test("frames are curves at first, and follow the slider: at rest they are those of the cut that is shown", async () => {
  const { page } = await shared_page("tets");
  assert.equal((await state(page)).glyph.shape, "curve");
  assert.equal(await page.locator(by_test("glyph-shape-curve")).isChecked(), true);
  await page.evaluate(() => window.crossgrain.change({ cut: { position: 0.3 } }));
  const there = await picture(page);
  await page.evaluate(() => window.crossgrain.change({ cut: { position: 0.7 } }));
  assert.ok((await difference(page, there, await picture(page))).mean > 1e-3);
  // As a hand moves it, without waiting for any picture but the last.
  await page.locator(by_test("cut-position")).evaluate((slider) => {
    for (let place = 0.7; place > 0.305; place -= 0.02) {
      slider.value = String(place);
      slider.dispatchEvent(new Event("input"));
    }
    slider.value = "0.3";
    slider.dispatchEvent(new Event("input"));
  });
  assert.equal(await picture(page), there);
});
