// SPDX-License-Identifier: Apache-2.0
// All scenes of the page's tests, by name.
//   node --import ./tests/register_typescript.mjs tests/scenes.mjs FOLDER     writes a page of each

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { hexahedra_scene } from "./hex_scene.mjs";
import { fallback_scene, fitted_scene, lattice_scene } from "./lattice_scene.mjs";
import { regions_scene } from "./region_scene.mjs";
import { ball_scene, components_scene, plate_scene } from "./sample_scene.mjs";
import { filled_page } from "./scene_writer.mjs";
import { tets_scene } from "./tet_scene.mjs";

const kScenes = { ball: ball_scene, plate: plate_scene, components: components_scene, regions: regions_scene, tets: tets_scene, hexahedra: hexahedra_scene, all_hex: () => hexahedra_scene(false),
  lattice: lattice_scene, fitted: fitted_scene, fallback: fallback_scene };

const made = new Map();

/** The report and the bytes of a scene, made when it is first asked for. */
export function scene_named(name) {
  if (!made.has(name)) made.set(name, kScenes[name]());
  return made.get(name);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const folder = process.argv[2] ?? ".";
  mkdirSync(folder, { recursive: true });
  const page = readFileSync(new URL("../dist/report.html", import.meta.url), "utf8");
  for (const name of Object.keys(kScenes)) {
    const { report, scene } = scene_named(name);
    writeFileSync(`${folder}/${name}.html`, filled_page(page, report, scene));
    console.log(`${folder}/${name}.html: ${report.levels.at(-1)?.active_cells ?? 0} cells`);
  }
}
