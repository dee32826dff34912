// SPDX-License-Identifier: Apache-2.0
// The page in Debian's Firefox: it opens, draws with WebGL 2, and follows its controls. Left out where Firefox or Xvfb is missing.

import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { drawn_share_there, scene_file, scene_named } from "./browser.mjs";
import { Firefox, has_firefox } from "./firefox.mjs";

const skip = has_firefox() ? false : "firefox-esr or Xvfb is missing";

let browser;
before(async () => {
  if (!skip) browser = await Firefox.start();
});
after(() => browser?.close());

const kDrawnShare = `(${drawn_share_there})()`;

for (const name of ["tets", "components"]) {
  test(`${name} opens in Firefox, and its cut, map and field follow`, { skip }, async (context) => {
    const start = Date.now();
    await browser.open(scene_file(name));
    await browser.evaluate("window.crossgrain.ready");
    context.diagnostic(`open after ${Date.now() - start} ms`);
    const { report } = scene_named(name);
    assert.equal(await browser.evaluate("document.getElementById('message').hidden"), true);
    assert.equal(await browser.evaluate("document.querySelector('[data-testid=answer]').textContent"), report.answer);
    assert.ok((await browser.evaluate(kDrawnShare)) > 0.06);
    await browser.evaluate("window.crossgrain.change({ map: 'energy', opacity: 1 })");
    assert.equal(await browser.evaluate("window.crossgrain.state().map"), "energy");
    await browser.evaluate("window.crossgrain.cutAcross('x')");
    assert.ok((await browser.evaluate(kDrawnShare)) > 0.06);
    assert.match(await browser.evaluate("window.crossgrain.picture()"), /^data:image\/png;base64,/, "with curves");
    await browser.evaluate("window.crossgrain.change({ glyph: { shape: 'cross' } })");
    // The frames follow the flight of the view towards the cut.
    const glyphs = () => browser.evaluate("window.crossgrain.state().glyphs");
    for (let tries = 0; tries < 50 && (await glyphs()) <= 5; ++tries) await new Promise((resolve) => setTimeout(resolve, 200));
    assert.ok((await glyphs()) > 5);
    const picture = await browser.evaluate("window.crossgrain.picture()");
    assert.match(picture, /^data:image\/png;base64,/);
    const folder = process.env.CROSSGRAIN_SCREENSHOTS;
    if (folder) {
      mkdirSync(folder, { recursive: true });
      writeFileSync(join(folder, `firefox-${name}.png`), Buffer.from(await browser.screenshot(), "base64"));
      writeFileSync(join(folder, `firefox-${name}-saved.png`), Buffer.from(picture.split(",")[1], "base64"));
    }
  });
}
