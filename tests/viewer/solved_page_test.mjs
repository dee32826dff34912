// SPDX-License-Identifier: Apache-2.0
// The page that the program writes for a part that ships with the project, in a browser. CROSSGRAIN_PROGRAM is the program; without it this
// is left out, saying so.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

import { drawn_share, keep_screenshot, launch, open } from "./browser.mjs";

const program = process.env.CROSSGRAIN_PROGRAM;
const skip = program ? false : "CROSSGRAIN_PROGRAM names no program";
const folder = mkdtempSync(join(tmpdir(), "crossgrain-solved-"));
const model = fileURLToPath(new URL("../../models/bracket.stl", import.meta.url));

let browser, opened, report;
before(async () => {
  if (skip) return;
  execFileSync(program, ["solve", model, "-o", folder, "--quiet", "--resolution", "48"]);
  report = JSON.parse(readFileSync(join(folder, "report.json"), "utf8"));
  browser = await launch();
  opened = await open(browser, pathToFileURL(join(folder, "report.html")).href);
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

test("a solved field opens from disk without complaint, asks the network for nothing, and shows the part", { skip }, async () => {
  assert.deepEqual(opened.problems, []);
  assert.ok((await drawn_share(opened.page)) > 0.06);
  await keep_screenshot(opened.page, "solved-desktop-light");
});

test("it says how many cells and singular lines the report has", { skip }, async () => {
  const text = await opened.page.locator('[data-testid="panel-field"]').innerText();
  assert.ok(text.includes(report.levels.at(-1).active_cells.toLocaleString("en-US")), text);
  const lines = await opened.page.locator('[data-testid="number-arcs"]').innerText();
  assert.ok(lines.includes(String(report.singularity.arcs)), lines);
});

test("cells have unit coefficients, and forms with the eigenvalues of sums of projectors", { skip }, async () => {
  const cells = await opened.page.evaluate((count) => {
    const found = [];
    for (let cell = 0; cell < count && found.length < 50; cell += 97) {
      const described = window.crossgrain.describe(cell);
      if (described.form) found.push(described);
    }
    return found;
  }, report.levels.at(-1).active_cells);
  assert.ok(cells.length > 5);
  for (const { coefficients, form } of cells) {
    assert.ok(Math.abs(Math.hypot(...coefficients) - 1) < 1e-6);
    assert.ok(form.weight > 0);
    // Over the weight none is below 0 or above 1.
    for (const value of form.eigenvalues) assert.ok(value > -1e-4 && value < 1.0001, `${value}`);
  }
});
