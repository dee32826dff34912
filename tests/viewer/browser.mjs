// SPDX-License-Identifier: Apache-2.0
// A browser with pages of the test scenes in it, drawn by software so that pictures are the same on every machine.
//
// Environment: CROSSGRAIN_CHROMIUM is the browser (default /usr/bin/chromium), CROSSGRAIN_SCREENSHOTS a folder that screenshots are kept
// in, CROSSGRAIN_UPDATE_REFERENCES=1 writes the pictures of references/ anew instead of comparing with them.

import assert from "node:assert/strict";
import { mkdtempSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

import { chromium } from "../../viewer/node_modules/playwright-core/index.mjs";
import { scene_named } from "../../viewer/tests/scenes.mjs";
import { filled_page } from "../../viewer/tests/scene_writer.mjs";

// WebGL is drawn by software. What is around it needs no GPU, whose shaders software would compile too, and pages share one process, since
// each new one costs a second. With several samples a pixel a picture takes twice as long.
const kArguments = [
  "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--force-color-profile=srgb",
  "--disable-gpu-compositing", "--renderer-process-limit=1", "--webgl-antialiasing-mode=none",
];
// Half a device pixel a CSS pixel: software draws a quarter as many, and everything else is as large as it is on a desktop or a phone.
export const kDesktop = { viewport: { width: 1440, height: 900 }, deviceScaleFactor: 0.5 };
export const kPhone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 1 };

const folder = mkdtempSync(join(tmpdir(), "crossgrain-viewer-"));
export const template = readFileSync(new URL("../../viewer/dist/report.html", import.meta.url), "utf8");
export { scene_named };

export const kNightly = process.env.CROSSGRAIN_NIGHTLY === "1";

/** The names that were chosen to stand for all by day; all of them by night. */
export const of_the_day = (names, ...chosen) => names.filter((name) => kNightly || chosen.includes(name));

/** Options of a test that others stand for by day. */
export const by_night = { skip: !kNightly && "by night" };

/** Address of a file that holds this page. */
export function page_file(name, text) {
  const path = join(folder, `${name}.html`);
  writeFileSync(path, text);
  return pathToFileURL(path).href;
}

export function scene_file(name) {
  const { report, scene } = scene_named(name);
  return page_file(name, filled_page(template, report, scene));
}

// Without a GPU the browser reads what WebGL has drawn, and warns of it as if the page had.
const kOfCompositing = /GPU stall due to ReadPixels/;

let launched = null;
const contexts = new Map();
after(async () => (await launched)?.close());

/** The context of all pages of a device: pages of one context share a process. */
async function context_of(device) {
  launched ??= chromium.launch({ executablePath: process.env.CROSSGRAIN_CHROMIUM ?? "/usr/bin/chromium", args: kArguments });
  const browser = await launched;
  const key = JSON.stringify(device);
  if (!contexts.has(key)) contexts.set(key, browser.newContext(device));
  return contexts.get(key);
}

/** Opens a page and waits until it is drawn. `problems` collects console messages, errors and requests to anywhere but the file. */
export async function open(address, { device = kDesktop, scheme = "light", before = null } = {}) {
  const page = await (await context_of(device)).newPage();
  page.setDefaultTimeout(60_000);
  const problems = [];
  page.on("console", (message) => {
    if (!kOfCompositing.test(message.text())) problems.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`error: ${error.message}`));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) problems.push(`request: ${request.url()}`);
  });
  await page.emulateMedia({ colorScheme: scheme, reducedMotion: "reduce" });
  if (before) await page.addInitScript(before);
  const start = Date.now();
  await page.goto(address);
  await page.evaluate(() => window.crossgrain.ready);
  return { page, problems, opened_ms: Date.now() - start, opened_in: scheme };
}

/** Takes WebGL from a page, which shows numbers only then: for `before` of open(). */
export function without_webgl() {
  const own = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind.startsWith("webgl") ? null : own.call(this, kind, ...rest);
  };
}

const shared = new Map();

/**
 * The page of a scene on a device, which all tests share. It is opened, in this scheme, when it is first asked for, and afterwards shown
 * in this scheme as it opened.
 */
export async function shared_page(name, { device = kDesktop, scheme = "light" } = {}) {
  const key = `${name} ${JSON.stringify(device)}`;
  if (!shared.has(key)) {
    const opened = await open(scene_file(name), { device, scheme });
    const folds = await opened.page.evaluate(() => [...document.querySelectorAll("details")].map((one) => one.open));
    shared.set(key, { ...opened, first: await state(opened.page), link: await opened.page.evaluate(() => window.crossgrain.link()), folds });
    return opened;
  }
  const { page, problems, first, link, folds, opened_ms } = shared.get(key);
  await page.setViewportSize(device.viewport);
  await page.emulateMedia({ colorScheme: scheme, reducedMotion: "reduce" });
  await page.evaluate(restore_there, [first, new URL(link).hash, folds]);
  const { position, target } = (await state(page)).camera;
  const size = Math.hypot(...first.camera.position.map((value, k) => value - first.camera.target[k]));
  [...position, ...target].forEach((value, k) => {
    const before_it = [...first.camera.position, ...first.camera.target][k];
    assert.ok(Math.abs(value - before_it) < 1e-4 * size, `${name} looks from elsewhere than when it opened: ${value}, not ${before_it}`);
  });
  problems.length = 0;
  return { page, problems, opened_ms, opened_in: shared.get(key).opened_in };
}

/** Shows a page as it opened; runs in the page. */
async function restore_there([{ theme, cut, glyph, layers }, hash, folds]) {
  const tab = document.querySelector('[data-testid="tab-field"]');
  const is_shown = () => !document.getElementById("panel-field").hidden;
  if (!matchMedia("(max-width: 799px)").matches) tab.click();
  else if (!document.body.classList.contains("drawer-closed")) {
    if (!is_shown()) tab.click();
    tab.click();
  }
  document.getElementById("help").close();
  // The Tab key goes on from here.
  const start = document.createElement("span");
  start.tabIndex = -1;
  start.style.position = "fixed";
  document.body.prepend(start);
  start.focus();
  start.remove();
  await window.crossgrain.change({ theme, cut, glyph, layers, picked: -1, below: 1, hex_color: "shape", hexahedron: -1, alone: false, face: null, marked: null });
  [...document.querySelectorAll("details")].forEach((one, k) => (one.open = folds[k] ?? one.open));
  const restored = new Promise((resolve) => addEventListener("hashchange", resolve, { once: true }));
  history.replaceState(null, "", location.pathname);
  location.hash = hash;
  await restored;
  await window.crossgrain.drawn();
}

// Software drawing and busy machines are slow: the limit is of what would be wrong anywhere.
const kLongestOpening = 20_000;

/** That a page has opened, in this scheme, without complaint, and shows what the reference picture of this name shows. */
export async function check_opening(name, device_name = "desktop", scheme = "light") {
  const { page, problems, opened_ms, opened_in } = await shared_page(name, { device: device_name === "phone" ? kPhone : kDesktop, scheme });
  assert.equal(opened_in, scheme, "another test opened it first");
  assert.ok(opened_ms < kLongestOpening, `${opened_ms} ms`);
  assert.deepEqual(problems, []);
  assert.ok((await drawn_share(page)) > 0.06);
  assert.equal(await page.locator("#message").isVisible(), false);
  const named = `${name}-${device_name}-${scheme}`;
  await keep_screenshot(page, named);
  const current = await picture(page, device_name === "phone" ? 240 : 360);
  const { mean, share } = await difference(page, current, reference(named, current));
  assert.ok(mean < 0.01 && share < 0.01, `differs from the reference: mean ${mean}, share ${share}`);
}

/** That every reason, and whatever else may be said in several places, stands in the panel once. */
export async function check_said_once(page, { reasons, hexahedra }, others = []) {
  const text = (await page.locator('[data-testid="panel-field"]').evaluate((panel) => panel.textContent)).toLowerCase();
  const times = (words) => text.split(words.toLowerCase()).length - 1;
  for (const { text: reason } of reasons) assert.equal(times(reason), 1, reason);
  if (hexahedra?.reason) assert.equal(times(hexahedra.reason), 1, hexahedra.reason);
  for (const words of others) assert.equal(times(words), 1, words);
}

export const state = (page) => page.evaluate(() => window.crossgrain.state());

/** The drawing, reduced to `width` pixels, as a PNG in base64. */
export function picture(page, width = 360) {
  return page.evaluate(async (wanted) => {
    await window.crossgrain.drawn();
    const view = document.getElementById("view");
    const small = document.createElement("canvas");
    small.width = wanted;
    small.height = Math.round((wanted * view.height) / view.width);
    const context = small.getContext("2d", { willReadFrequently: true });
    context.imageSmoothingQuality = "high";
    context.drawImage(view, 0, 0, small.width, small.height);
    return small.toDataURL("image/png").split(",")[1];
  }, width);
}

/** How two pictures differ: mean over all channels, and the share of pixels that differ by a quarter or more; both 0 to 1. */
export function difference(page, first, second) {
  return page.evaluate(async ([one, other]) => {
    const pixels = async (base64) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      canvas.width = image.width;
      canvas.height = image.height;
      const context = canvas.getContext("2d", { willReadFrequently: true });
      context.drawImage(image, 0, 0);
      return { width: image.width, height: image.height, data: context.getImageData(0, 0, image.width, image.height).data };
    };
    const [a, b] = [await pixels(one), await pixels(other)];
    if (a.width !== b.width || a.height !== b.height) return { mean: 1, share: 1 };
    let sum = 0;
    let far = 0;
    for (let k = 0; k < a.data.length; k += 4) {
      const apart = [0, 1, 2].map((channel) => Math.abs(a.data[k + channel] - b.data[k + channel]));
      sum += apart[0] + apart[1] + apart[2];
      if (Math.max(...apart) >= 64) ++far;
    }
    return { mean: sum / (0.75 * 255 * a.data.length), share: (4 * far) / a.data.length };
  }, [first, second]);
}

/** The share of the drawing that is not background; runs in the page. */
export async function drawn_share_there() {
  await window.crossgrain.drawn();
  const view = document.getElementById("view");
  const small = document.createElement("canvas");
  [small.width, small.height] = [200, 125];
  const context = small.getContext("2d", { willReadFrequently: true });
  context.drawImage(view, 0, 0, 200, 125);
  const { data } = context.getImageData(0, 0, 200, 125);
  let other = 0;
  for (let k = 0; k < data.length; k += 4) if (Math.abs(data[k] - data[0]) + Math.abs(data[k + 1] - data[1]) + Math.abs(data[k + 2] - data[2]) > 12) ++other;
  return (4 * other) / data.length;
}

export const drawn_share = (page) => page.evaluate(drawn_share_there);

const kept = process.env.CROSSGRAIN_SCREENSHOTS;
export const keeps_screenshots = Boolean(kept);

export async function keep_screenshot(page, name) {
  if (!kept) return;
  mkdirSync(kept, { recursive: true });
  await page.screenshot({ path: join(kept, `${name}.png`) });
}

const reference_path = (name) => fileURLToPath(new URL(`references/${name}.png`, import.meta.url));

/** The committed picture of this name in base64; writes it first where references are to be made anew. */
export function reference(name, current) {
  if (process.env.CROSSGRAIN_UPDATE_REFERENCES === "1") writeFileSync(reference_path(name), Buffer.from(current, "base64"));
  return readFileSync(reference_path(name)).toString("base64");
}
