// SPDX-License-Identifier: Apache-2.0
// The page in a browser: it opens, shows the part, and does what its controls say. From the root of the repository:
//   node --import ./viewer/tests/register_typescript.mjs tests/viewer/page_test.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import {
  check_opening, check_said_once, keep_screenshot, kDesktop, kPhone, of_the_day, open, page_file, picture, scene_file, scene_named, shared_page, state, template, without_webgl,
} from "./browser.mjs";
import { filled_page } from "../../viewer/tests/scene_writer.mjs";

const by_test = (name) => `[data-testid="${name}"]`;

for (const name of of_the_day(["ball, desktop, light", "components, desktop, light", "plate, desktop, dark", "components, phone, dark", "plate, phone, light"],
  "ball, desktop, light", "components, phone, dark")) {
  test(`opens without complaint and shows the part: ${name}`, () => check_opening(...name.split(", ")));
}

test("the numbers and the answer are those of the report", async () => {
  const { page } = await shared_page("components");
  const { report } = scene_named("components");
  assert.equal(await page.locator(by_test("number-cells")).innerText().then((text) => text.split("\n")[0]), report.levels.at(-1).active_cells.toLocaleString("en-US"));
  assert.match(await page.locator(by_test("number-energy")).innerText(), /^61\.3/);
  assert.equal(await page.locator(by_test("alignment-max")).innerText(), `${report.alignment_deg.max.toFixed(1)}°`);
  assert.equal(await page.locator(by_test("answer")).textContent(), report.answer);
  assert.match(await page.locator(by_test("badge")).textContent(), /hexahedra cannot follow this field$/);
  assert.deepEqual(await page.locator(`${by_test("warnings")} li`).allInnerTexts(), [
    "line 12: 'LOOKUP' is not known, and data after it are ignored",
  ]);
  assert.equal(await page.locator(by_test("part-name")).innerText(), "five components <v2>.step");
  assert.match(await page.title(), /^five components <v2>\.step · Crossgrain$/);
});

test("all further reasons stand below the answer, with what to do next, and lead to their places", async () => {
  const { page } = await shared_page("components");
  const { report } = scene_named("components");
  const shown = await page.locator(`${by_test("further-reasons")} li > .words`).allInnerTexts();
  assert.equal(shown.length, report.reasons.length - 1);
  for (const [k, { text, next }] of report.reasons.slice(1).entries()) {
    assert.ok(shown[k].toLowerCase().includes(text.toLowerCase()) && shown[k].includes(`next: ${next}`), shown[k]);
  }
  // Two lines have the first of these; walls have no place to go to.
  assert.equal(await page.locator(`${by_test("further-reasons")} ${by_test("kind")}`).count(), 1);
  assert.equal(await page.locator(`${by_test("further-reasons")} ${by_test("place")}`).count(), 2);
  assert.deepEqual(await page.locator(by_test("worst-place")).allInnerTexts(), ["1\nCrease 3: 30.0°", "2\nLine 11: turn about a diagonal", "3\nLine 13: turning point"]);
  await page.locator(by_test("worst-place")).first().click();
  assert.deepEqual((await state(page)).marked.point, [46, 26, 6]);
  assert.equal((await state(page)).marked.warn, true);
  assert.equal(await page.locator(by_test("tag")).innerText(), "Crease 3");
  await page.locator(`${by_test("further-reasons")} summary`).click();
  await page.locator(`${by_test("further-reasons")} ${by_test("place")}`).first().click();
  assert.deepEqual((await state(page)).marked.point, report.reasons[1].place);
});

test("a reason stands once, and so does what was found in the input", async () => {
  for (const name of of_the_day(["components", "plate"], "components")) {
    const { page } = await shared_page(name);
    const { report } = scene_named(name);
    await check_said_once(page, report, name === "components" ? ["2 holes", "turning point: frames"] : []);
  }
});

test("creases and corners are marked like nodes, and the legend says what the colours mean", async () => {
  const { page } = await shared_page("components");
  assert.match((await page.locator(by_test("legend-balls")).innerText()).replace(/\s+/g, " "), /impossible for hexahedra 3 undecided 2/);
  await page.evaluate(() => window.crossgrain.change({ cut: { on: false }, layers: { part: false, creases: false, arcs: false, glyphs: false } }));
  const pixel = () => page.evaluate(() => {
    const view = document.getElementById("view");
    const [x, y] = window.crossgrain.screenOf([23, 26, 7]);
    const small = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    small.drawImage(view, (x * view.width) / view.clientWidth, (y * view.height) / view.clientHeight, 1, 1, 0, 0, 1, 1);
    return [...small.getImageData(0, 0, 1, 1).data];
  });
  await picture(page);
  const [r, g, b] = await pixel();
  assert.ok(r > 2 * g && r > 2 * b, `${r} ${g} ${b} is not crimson`);
  await page.locator("label", { has: page.locator(by_test("show-nodes")) }).click();
  assert.equal(await page.locator(by_test("legend-balls")).count(), 0);
});

test("alignment that was measured nowhere is no number, in the text and on the scale", async () => {
  // The numbers stand beside the view, and without one.
  const { report } = scene_named("ball");
  const none = { mean: 0, p95: 0, max: 0 };
  for (const [name, alignment_deg] of [
    ["all excluded", { ...none, excluded_share: 0.9996 }], ["null", { mean: null, p95: null, max: null, excluded_share: 1 }], ["nearly all", { ...none, excluded_share: 0.9994 }],
  ]) {
    const { page, problems } = await open(page_file("unaligned", filled_page(template, { ...report, alignment_deg }, null)));
    const nothing = name !== "nearly all";
    for (const part of ["mean", "p95", "max"]) assert.equal(await page.locator(by_test(`alignment-${part}`)).innerText(), nothing ? "n/a" : "0.00°", name);
    assert.equal(await page.locator(".scale").count(), nothing ? 0 : 1, name);
    const note = await page.locator(by_test("alignment-note")).innerText();
    assert.equal(/No frame could align anywhere/.test(note), nothing, note);
    assert.deepEqual(problems, []);
    await page.close();
  }
});

test("a field of a solve that was stopped says what is missing", async () => {
  // The numbers stand beside the view, and without one.
  const { report } = scene_named("ball");
  const reason = (kind, text) => ({ kind, verdict: "undecided", count: 0, place: [0, 0, 0], text, next: "" });
  const reasons = [reason("walls", "walls are thin"), reason("unfinished", "the solve was stopped before its end")];
  const stopped = { ...report, reasons, unfinished: { resolution_asked: 4 * report.resolution, levels_missing: 2, tets_missing: false } };
  const { page, problems } = await open(page_file("stopped", filled_page(template, stopped, null)));
  const done = report.levels.length;
  assert.match(await page.locator(by_test("unfinished")).innerText(), new RegExp(`Unfinished: level ${done} of ${done + 2}\\.[^]* 4 times as fine`));
  assert.doesNotMatch(await page.locator(by_test("panel-field")).innerText(), /stopped before its end/, "it is said once");
  assert.deepEqual(problems, []);
  await page.close();
});

test("numbers that are not finite, null in the report, are dashes or n/a", async () => {
  // The numbers stand beside the view, and without one.
  const { report } = scene_named("ball");
  const levels = report.levels.map((level) => ({ ...level, energy: null, seconds: null }));
  const nothing = { mean: null, p95: null, max: null };
  const broken = { ...report, levels, alignment_deg: { ...nothing, excluded_share: null }, energy: { smoothness: null, boundary: null, total: null }, seconds: { total: null } };
  const { page, problems } = await open(page_file("null", filled_page(template, broken, null)));
  assert.equal(await page.locator(by_test("number-energy")).innerText(), "–");
  assert.equal(await page.locator(by_test("alignment-max")).innerText(), "n/a");
  assert.match(await page.locator(by_test("numbers")).innerText(), /Time\s+–/i);
  assert.ok(await page.locator(by_test("levels")).isVisible());
  assert.deepEqual(problems, []);
  await page.close();
});

test("nothing is drawn while nothing changes, and the same page gives the same picture", async () => {
  // This one has been opened just now, whose camera is no link's.
  const { page } = await shared_page("regions");
  // A change of the size of the panels, as their fonts arrive, draws once more: after that, nothing for a while.
  await page.waitForFunction(async (quiet_ms) => {
    const { frames_drawn } = window.crossgrain.state();
    await new Promise((resolve) => setTimeout(resolve, quiet_ms));
    return window.crossgrain.state().frames_drawn === frames_drawn;
  }, 400, { polling: 100, timeout: 20_000 });
  const second = await open(scene_file("regions"));
  assert.ok((await picture(page)) === (await picture(second.page)));
  await second.page.close();
});

test("a thinned page says so", async () => {
  const { page } = await shared_page("regions");
  assert.match(await page.locator(by_test("shown")).innerText(), /Cells smaller than 1\.5 mm are shown merged: [\d,]+ of 4,100,000 cells/);
});

/** By how much, 0 to 1 in the mean, the drawing differs from what it was when this was last asked. */
const change_of_drawing = (page) => page.evaluate(async () => {
  await window.crossgrain.drawn();
  const view = document.getElementById("view");
  const small = document.createElement("canvas");
  [small.width, small.height] = [360, Math.round((360 * view.height) / view.width)];
  const drawing = small.getContext("2d", { willReadFrequently: true });
  drawing.imageSmoothingQuality = "high";
  drawing.drawImage(view, 0, 0, small.width, small.height);
  const { data } = drawing.getImageData(0, 0, small.width, small.height);
  const last = window.last_drawing ?? data;
  window.last_drawing = data;
  return data.reduce((sum, value, k) => sum + Math.abs(value - last[k]), 0) / (0.75 * 255 * data.length);
});

test("every control changes the picture", async () => {
  const { page, problems } = await shared_page("regions");
  await page.evaluate(() => window.crossgrain.change({ cut: { axis: "z", flip: false, position: 0.5 } }));
  // From above the cells are large enough for their lines, but singular lines are seen end on.
  await page.evaluate(() => window.crossgrain.setView("top"));
  await change_of_drawing(page);
  const changes = async (name, act) => {
    await act();
    assert.ok((await change_of_drawing(page)) > 2e-5, `${name} changes nothing`);
  };
  // Clicked where the user clicks: on the label.
  const click = (name) => changes(name, () => page.locator("label", { has: page.locator(by_test(name)) }).click());
  const layers = ["show-streamlines", "show-creases", "show-glyphs", "show-glyphs", "show-cells", "cut-clip"];
  for (const name of of_the_day(layers, "show-streamlines", "cut-clip")) await click(name);
  await page.evaluate(() => window.crossgrain.setView("iso"));
  await change_of_drawing(page);
  const choices = ["show-part", "show-part", "show-arcs", "show-nodes", "map-alignment", "map-energy", "map-class", "map-none", "glyph-shape-cross", "glyph-shape-cube", "glyph-shape-curve", "cut-axis-x", "cut-axis-z", "cut-axis-view", "cut-axis-y"];
  for (const name of of_the_day(choices, "show-part", "show-nodes", "map-class", "glyph-shape-cube", "cut-axis-x")) await click(name);
  await click("cut-clip");
  await changes("cut-flip", () => page.locator(by_test("cut-flip")).click());
  for (const value of ["tilt", "turn", "axes"]) {
    if (value === "axes") await changes("glyph-color", () => page.locator(by_test("glyph-color")).selectOption(value));
    else await page.locator(by_test("glyph-color")).selectOption(value);
    await change_of_drawing(page);
  }
  for (const [name, value] of [["opacity", "0.5"], ["cut-position", "0.6"], ["glyph-density", "1"]]) {
    await changes(name, () => page.locator(by_test(name)).fill(value));
  }
  await click("cut-on");
  for (const name of of_the_day(["view-front", "view-top", "view-right", "view-iso", "theme"], "view-front", "theme")) {
    await changes(name, async () => {
      await page.locator(by_test(name)).click();
      if (name === "theme") await page.locator(by_test(name)).click(); // the first is the light that it had
    });
  }
  assert.deepEqual(problems, []);
});

test("dragging turns the part, the wheel zooms, and the whole part comes back", async () => {
  const { page } = await shared_page("ball");
  await page.locator(by_test("view-iso")).click();
  const place = (one) => one.camera.position;
  const first = await state(page);
  await page.mouse.move(650, 400);
  await page.mouse.down();
  await page.mouse.move(750, 430, { steps: 4 });
  await page.mouse.up();
  const turned = await state(page);
  assert.notDeepEqual(place(turned), place(first));
  assert.equal(turned.picked, -1, "a drag is no click");
  await page.mouse.wheel(0, -300);
  await page.evaluate(() => window.crossgrain.drawn());
  const zoomed = await state(page);
  const distance = ({ camera }) => Math.hypot(...camera.position.map((value, k) => value - camera.target[k]));
  assert.ok(distance(zoomed) < distance(turned));
  await page.locator(by_test("view-iso")).click();
  place(await state(page)).forEach((value, k) => assert.ok(Math.abs(value - place(first)[k]) < 1e-9));
});

test("a click picks the cell that lies there, and says what it is", async () => {
  const { page } = await shared_page("ball");
  // A cell that the cut passes, whose place on the screen is known by projection.
  const [x, y] = await page.evaluate(() => window.crossgrain.screenOf([103.5, 50, 22.3]));
  await page.mouse.click(x, y);
  const { picked } = await state(page);
  assert.ok(picked >= 0);
  const cell = await page.evaluate((number) => window.crossgrain.describe(number), picked);
  assert.ok(cell.center.every((value, k) => Math.abs(value - [103.5, 50, 22.3][k]) <= cell.size), `${cell.center}`);
  assert.equal(await page.locator(by_test("cell-title")).innerText(), `Cell ${(picked + 1).toLocaleString("en-US")}`);
  assert.equal(await page.locator(`${by_test("cell-coefficients")} li`).count(), 9);
  assert.ok(Math.abs(Math.hypot(...cell.coefficients) - 1) < 1e-9);
  assert.match(await page.locator(by_test("announcement")).innerText(), /^Cell .* picked/);
  await keep_screenshot(page, "picked-desktop-light");
  // A click beside the part clears it.
  await page.mouse.click(300, 800);
  assert.equal((await state(page)).picked, -1);
  assert.ok(await page.locator(by_test("cell-empty")).isVisible());
});

test("a cell with surface shows its form", async () => {
  const { page } = await shared_page("ball");
  // In the cut, within the uppermost cells.
  const cell = await page.evaluate(() => window.crossgrain.pickAt(...window.crossgrain.screenOf([100.7, 50, 39.8])));
  assert.ok(cell.form, "no form");
  assert.equal(cell.form.eigenvalues.length, 9);
  assert.ok(cell.form.weight > 0);
  await page.locator(`${by_test("cell-form")} summary`).click();
  assert.equal(await page.locator(`${by_test("cell-matrix")} td`).count(), 90);
});

test("places are flown to and marked", async () => {
  const { page } = await shared_page("components");
  const before_it = await state(page);
  const buttons = page.locator(by_test("place"));
  assert.ok((await buttons.count()) >= 6);
  await page.locator(`${by_test("places-found-in-the-input")} ${by_test("place")}`).first().click();
  const there = await state(page);
  assert.equal(there.marked.label, "2 holes");
  assert.deepEqual(there.marked.point, [60, 8, 0]);
  there.camera.target.forEach((value, k) => assert.ok(Math.abs(value - [60, 8, 0][k]) < 1e-9));
  assert.notDeepEqual(there.camera.position, before_it.camera.position);
  await page.locator(`${by_test("places-crowded-corners")} summary`).click();
  await page.locator(`${by_test("places-crowded-corners")} .quiet`).click();
  assert.equal(await page.locator(`${by_test("places-crowded-corners")} ${by_test("place")}`).count(), 9);
});

test("keys do what the help says", async () => {
  const { page } = await shared_page("ball");
  await page.locator("#view").focus();
  const after_key = async (key) => {
    await page.keyboard.press(key);
    return state(page);
  };
  assert.equal((await after_key("x")).cut.axis, "x");
  assert.equal((await after_key("v")).cut.axis, "view");
  assert.equal((await after_key("z")).cut.axis, "z");
  assert.equal((await after_key("c")).cut.on, false);
  assert.ok((await after_key("]")).cut.position > 0.5);
  assert.equal((await after_key("m")).map, "alignment");
  for (const shape of ["cross", "cube", "curve"]) assert.equal((await after_key("b")).glyph.shape, shape);
  assert.equal((await after_key("l")).layers.streamlines, true);
  assert.equal((await after_key("t")).resolved_theme, "light");
  assert.equal((await after_key("t")).resolved_theme, "dark");
  const still = await state(page);
  assert.notDeepEqual((await after_key("ArrowLeft")).camera, still.camera);
  assert.ok((await after_key("Enter")).picked >= -1);
  assert.equal((await after_key("Escape")).picked, -1);
  await page.keyboard.press("?");
  assert.ok(await page.locator(by_test("help")).isVisible());
  await keep_screenshot(page, "help-desktop-dark");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(by_test("help")).isVisible(), false);
  // Letters in a list are the list's own.
  await page.locator(by_test("glyph-color")).focus();
  assert.equal((await after_key("x")).cut.axis, "z");
});

test("a phone has the panels in a drawer, and taps pick", async () => {
  const { page, problems } = await shared_page("tets", { device: kPhone });
  assert.equal(await page.locator(by_test("panel-field")).isVisible(), false);
  const closed = await page.locator("#stage").boundingBox();
  await page.locator(by_test("tab-view")).tap();
  assert.ok(await page.locator(by_test("panel-view")).isVisible());
  assert.ok((await page.locator("#stage").boundingBox()).height < closed.height);
  await keep_screenshot(page, "view-phone-light");
  await page.locator("label", { has: page.locator(by_test("map-energy")) }).tap();
  assert.equal((await state(page)).map, "energy");
  await page.locator(by_test("tab-view")).tap();
  assert.equal(await page.locator(by_test("panel-view")).isVisible(), false);
  await page.evaluate(() => window.crossgrain.drawn());
  const [x, y] = await page.evaluate(() => window.crossgrain.screenOf([3.1, -4.2, 0]));
  await page.touchscreen.tap(x, y);
  assert.ok((await state(page)).picked >= 0);
  await page.locator(by_test("tab-cell")).tap();
  assert.ok(await page.locator(by_test("cell-title")).isVisible());
  await keep_screenshot(page, "cell-phone-light");
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(problems, []);
});

test("without WebGL 2 the page says so and shows the numbers", async () => {
  // Pages of solved parts stand for the phone by day.
  for (const device of of_the_day([kDesktop, kPhone], kDesktop)) {
    const { page, problems } = await open(scene_file("ball"), { device, before: without_webgl });
    assert.match(await page.locator("#message").innerText(), /needs WebGL 2/);
    if (device === kPhone) await page.locator(by_test("tab-field")).tap();
    assert.ok(await page.locator(by_test("numbers")).isVisible());
    assert.equal(await page.locator(by_test("panel-view")).isVisible(), false);
    assert.deepEqual(problems, []);
    await keep_screenshot(page, `without-webgl-${device === kPhone ? "phone" : "desktop"}`);
    await page.close();
  }
});

test("a page that is empty, or has numbers only, says so", async () => {
  const empty = await open(page_file("empty", template));
  assert.match(await empty.page.locator("#message").innerText(), /no field yet/);
  await empty.page.close();
  const numbers = await open(page_file("numbers", filled_page(template, { schema: 4, degree: 4 }, null)));
  assert.match(await numbers.page.locator("#message").innerText(), /numbers only/);
  assert.deepEqual(numbers.problems, []);
  await numbers.page.close();
});

test("the system's choice of light or dark is followed while the page is open", async () => {
  const { page } = await shared_page("ball");
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await background();
  await page.emulateMedia({ colorScheme: "dark" });
  assert.notEqual(await background(), light);
  assert.equal((await state(page)).resolved_theme, "dark");
  await page.emulateMedia({ colorScheme: "light" });
  assert.equal(await background(), light);
});
