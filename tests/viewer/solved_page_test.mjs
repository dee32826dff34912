// SPDX-License-Identifier: Apache-2.0
// The page that the program writes for a part that ships with the project, in a browser. CROSSGRAIN_PROGRAM is the program; without it this
// is left out, saying so.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

import { drawn_share, keep_screenshot, kPhone, open, without_webgl } from "./browser.mjs";

const program = process.env.CROSSGRAIN_PROGRAM;
const skip = program ? false : "CROSSGRAIN_PROGRAM names no program";
const folder = mkdtempSync(join(tmpdir(), "crossgrain-solved-"));
const model = fileURLToPath(new URL("../../models/bracket.stl", import.meta.url));

after(() => rmSync(folder, { recursive: true }));

let solved = null;
/** The report of the part and its page, solved and opened when it is first asked for. */
function solved_page() {
  return (solved ??= (async () => {
    execFileSync(program, ["solve", model, "-o", folder, "--quiet", "--resolution", "32"]);
    const report = JSON.parse(readFileSync(join(folder, "report.json"), "utf8"));
    return { report, ...(await open(pathToFileURL(join(folder, "report.html")).href)) };
  })());
}

test("a solved field opens from disk without complaint, asks the network for nothing, and shows the part", { skip }, async () => {
  const { page, problems } = await solved_page();
  assert.deepEqual(problems, []);
  assert.ok((await drawn_share(page)) > 0.06);
  await keep_screenshot(page, "solved-desktop-light");
});

test("it says how many cells and singular lines the report has", { skip }, async () => {
  const { page, report } = await solved_page();
  const text = await page.locator('[data-testid="panel-field"]').innerText();
  assert.ok(text.includes(report.levels.at(-1).active_cells.toLocaleString("en-US")), text);
  const lines = await page.locator('[data-testid="number-arcs"]').innerText();
  assert.ok(lines.includes(String(report.singularity.arcs)), lines);
});

test("under the content security policy of `crossgrain view` it draws itself, saves pictures, and can load nothing else", { skip }, async () => {
  await solved_page();
  const server = spawn(program, ["view", folder, "--no-browser"], { stdio: ["ignore", "pipe", "inherit"] });
  try {
    const address = await new Promise((resolve) => server.stdout.once("data", (line) => resolve(String(line).trim())));
    const { page, problems } = await open(address);
    assert.ok((await drawn_share(page)) > 0.06);
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator('[data-testid="picture"]').click()]);
    assert.ok(download.suggestedFilename().endsWith(".png"));
    assert.deepEqual(problems, [`request: ${address}`]);
    assert.equal(await page.evaluate(() => fetch("report.json").then(() => "loaded", () => "refused")), "refused");
    await page.close();
  } finally {
    server.kill();
  }
});

/** An STL file of flat faces, each a convex polygon of some corners, outward. */
function stl_text(corners, faces) {
  const triangles = faces.flatMap(([first, ...rest]) => rest.slice(1).map((last, k) => [first, rest[k], last]));
  const facets = triangles.map((triangle) => `facet normal 0 0 0\nouter loop\n${triangle.map((k) => `vertex ${corners[k].join(" ")}`).join("\n")}\nendloop\nendfacet\n`);
  return `solid part\n${facets.join("")}endsolid part\n`;
}

const square = (z) => [[-1, -1, z], [1, -1, z], [1, 1, z], [-1, 1, z]];
const box_faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
const box = (height) => stl_text([...square(0), ...square(height)], box_faces);
const pyramid = stl_text([...square(0), [0, 0, 2]], [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]);

for (const [name, model_text, words] of [["box", box(1.5), "hexahedra fit locally"], ["pyramid", pyramid, "hexahedra cannot follow this field"], ["plate", box(0.03), "undecided"]]) {
  test(`the page of a ${name} gives the answer of check: ${words}`, { skip }, async () => {
    const [stl, out] = [join(folder, `${name}.stl`), join(folder, name)];
    writeFileSync(stl, model_text);
    execFileSync(program, ["solve", stl, "-o", out, "--quiet", "--resolution", "32"]);
    // The page names what is to be set; the program, its option.
    const answer = execFileSync(program, ["check", out], { encoding: "utf8" }).split("\n")[0].replace("solve with --resolution", "use a resolution of");
    assert.ok(answer.startsWith(words), answer);
    // The answer stands beside the view, and without one.
    const { page, problems } = await open(pathToFileURL(join(out, "report.html")).href, { device: kPhone, before: without_webgl });
    assert.match(await page.locator('[data-testid="badge"]').textContent(), new RegExp(`${words}$`));
    assert.ok(await page.locator('[data-testid="badge"]').isVisible());
    await page.locator('[data-testid="tab-field"]').tap();
    assert.equal(await page.locator('[data-testid="answer"]').textContent(), answer);
    await keep_screenshot(page, `answer-${name}-phone-light`);
    assert.deepEqual(problems, []);
    await page.close();
  });
}

test("cells have unit coefficients, and forms with the eigenvalues of sums of projectors", { skip }, async () => {
  const { page, report } = await solved_page();
  const cells = await page.evaluate((count) => {
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
