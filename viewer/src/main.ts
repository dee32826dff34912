// SPDX-License-Identifier: Apache-2.0
// Opens the page: the report's numbers first, which need no WebGL, then the scene.

import { embedded_report, embedded_scene } from "./scene/embedded.ts";
import { has_field, type Report } from "./scene/report.ts";
import { Application } from "./application.ts";
import { view_context } from "./view/view_context.ts";
import { faces_of_model } from "./scene/faces.ts";
import { answer_of } from "./ui/answer.ts";
import { badge } from "./ui/badge.ts";
import { by_id } from "./ui/dom.ts";
import { hexahedra_badge } from "./ui/mesh_summary.ts";
import { report_blocks } from "./ui/report_panel.ts";
import { Tabs } from "./ui/tabs.ts";
import { show_no_cell } from "./ui/cell_panel.ts";

function show_report(report: Report): void {
  const path = report.model?.path ?? "";
  const name = path.split(/[\\/]/).pop() || "Field";
  document.title = `${name} · Crossgrain`;
  by_id("part-name").textContent = name;
  by_id("part-name").title = path;
  const judged = hexahedra_badge(report) ?? answer_of(report);
  by_id("badge").replaceChildren(...badge(judged));
  by_id("badge").className = `badge ${judged?.judgement ?? ""}`;
  // Filled again, with buttons that fly there, once there is a view.
  by_id("panel-field").replaceChildren(...report_blocks(report, faces_of_model(report, null), null));
}

function say_instead_of_view(text: string): void {
  by_id("message").textContent = text;
  by_id("message").hidden = false;
  document.body.classList.add("no-view");
}

async function open(): Promise<void> {
  const report = embedded_report();
  let tabs_changed = (): void => {};
  const tabs = new Tabs(() => tabs_changed());
  show_no_cell(by_id("panel-cell"), report?.hexahedra !== undefined);
  if (!report) return say_instead_of_view("This page contains no field yet; `crossgrain solve` writes pages with one.");
  show_report(report);
  if (report.hexahedra) {
    tabs.rename("field", "Mesh");
    tabs.rename("cell", "Hexahedron");
  }
  // The numbers are on the screen before the scene is unpacked, which goes on while the context is made.
  await new Promise((resolve) => setTimeout(resolve, 0));
  const unpacked = embedded_scene();
  if (!unpacked) return say_instead_of_view("This page contains numbers only, no 3D scene.");
  const context = view_context(by_id("view") as HTMLCanvasElement);
  const scene = await unpacked;
  if (!context) {
    return say_instead_of_view(`The 3D view needs WebGL 2, which this browser lacks: use another browser, or switch graphics acceleration on. The numbers of the ${has_field(report) ? "field" : "mesh"} are shown here.`);
  }
  const application = new Application(scene, report, tabs, context);
  tabs_changed = () => application.panels_changed();
  await application.started();
}

const ready = open().catch((error: unknown) => {
  say_instead_of_view(`This page could not be shown: ${error instanceof Error ? error.message : String(error)}`);
  throw error;
});
(window as unknown as { crossgrain: object }).crossgrain = Object.assign((window as unknown as { crossgrain?: object }).crossgrain ?? {}, { ready });
