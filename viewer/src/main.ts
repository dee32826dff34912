// SPDX-License-Identifier: Apache-2.0
// Opens the page: the report's numbers first, which need no WebGL, then the scene.

import { embedded_report, embedded_scene } from "./scene/embedded.ts";
import type { Report } from "./scene/report.ts";
import { Application } from "./application.ts";
import { view_context } from "./view/view_context.ts";
import { place_groups, place_lists } from "./ui/places.ts";
import { answer_blocks, answer_of } from "./ui/answer.ts";
import { badge } from "./ui/badge.ts";
import { about, alignment_scale, key_numbers, tet_alignment, unfinished_card, warnings_list } from "./ui/summary.ts";
import { by_id, element } from "./ui/dom.ts";
import { hexahedra_badge, hexahedra_card } from "./ui/hex_panel.ts";
import { levels_chart } from "./ui/levels_chart.ts";
import { Tabs } from "./ui/tabs.ts";
import { show_no_cell } from "./ui/cell_panel.ts";

function show_report(report: Report): void {
  const path = report.model?.path ?? "";
  const name = path.split(/[\\/]/).pop() || "Field";
  document.title = `${name} · Crossgrain`;
  by_id("part-name").textContent = name;
  by_id("part-name").title = path;
  const answer = answer_of(report);
  const judged = hexahedra_badge(report) ?? answer;
  by_id("badge").replaceChildren(...badge(judged));
  by_id("badge").className = `badge ${judged?.judgement ?? ""}`;
  // Filled again, with buttons that fly there, once there is a view.
  const verdict = element("div", { id: "answer" }, ...answer_blocks(answer, [], [0, 0, 0], () => {}));
  const places = element("div", { id: "places" }, ...place_lists(place_groups(report, [0, 0, 0]), [0, 0, 0], () => {}));
  const blocks = [unfinished_card(report), hexahedra_card(report), verdict, key_numbers(report), tet_alignment(report), alignment_scale(report), places, levels_chart(report), warnings_list(report), about(report)];
  by_id("panel-field").replaceChildren(...blocks.filter((block) => block !== null));
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
  show_no_cell(by_id("panel-cell"));
  if (!report) return say_instead_of_view("This page contains no field yet; `crossgrain solve` writes pages with one.");
  show_report(report);
  // The numbers are on the screen before the scene is unpacked, which goes on while the context is made.
  await new Promise((resolve) => setTimeout(resolve, 0));
  const unpacked = embedded_scene();
  const context = view_context(by_id("view") as HTMLCanvasElement);
  const scene = await unpacked;
  if (!context) {
    return say_instead_of_view("The 3D view needs WebGL 2, which this browser lacks: use another browser, or switch graphics acceleration on. The numbers of the field are shown here.");
  }
  if (!scene) return say_instead_of_view("This page contains numbers only, no 3D scene.");
  const application = new Application(scene, report, tabs, context);
  tabs_changed = () => application.panels_changed();
  await application.started();
}

const ready = open().catch((error: unknown) => {
  say_instead_of_view(`The field could not be shown: ${error instanceof Error ? error.message : String(error)}`);
  throw error;
});
(window as unknown as { crossgrain: object }).crossgrain = Object.assign((window as unknown as { crossgrain?: object }).crossgrain ?? {}, { ready });
