// SPDX-License-Identifier: Apache-2.0
// The verdict and the numbers by which a field is judged, from the report alone.

import type { Report, Warning } from "../scene/report.ts";
import { counted, degrees, duration, element, measured, memory, plural } from "./dom.ts";

export type Judgement = "good" | "unsure" | "bad";

export interface Verdict {
  judgement: Judgement;
  short: string;
  sentence: string;
}

/** Returns which part of the requested field this is, if the solve was stopped. */
export function unfinished_card(report: Report): HTMLElement | null {
  if (!report.unfinished) return null;
  const { levels_missing = 0, tets_missing } = report.unfinished;
  const done = report.levels?.length ?? 0;
  const sentence = levels_missing > 0 ? `Unfinished: level ${done} of ${done + levels_missing}.` : "Unfinished.";
  const note = levels_missing > 0
    ? `The solve was stopped. The requested field has cells ${2 ** levels_missing} times as fine.`
    : tets_missing ? "The solve was stopped before the field was transferred to the tets. This is the field on the grid." : "The solve was stopped.";
  return element("div", { class: "verdict unsure", "data-testid": "unfinished" },
    element("span", { class: "sign unsure", "aria-hidden": "true" }, "…"),
    element("div", {}, element("p", { class: "verdict-text" }, sentence), element("p", { class: "fine" }, note)),
  );
}

/** What the singular lines say about hexahedra. */
export function verdict_of(report: Report): Verdict | null {
  const singular = report.singularity;
  if (!singular) return null;
  const { arcs, not_meshable_arcs, not_meshable_nodes, undecided_nodes } = singular;
  if (!singular.meshable) {
    const faults = [
      not_meshable_arcs > 0 ? plural(not_meshable_arcs, "line") : "",
      not_meshable_nodes > 0 ? plural(not_meshable_nodes, "node") : "",
    ].filter(Boolean).join(" and ");
    const one = not_meshable_arcs + not_meshable_nodes === 1;
    return {
      judgement: "bad",
      short: "Not for hexahedra",
      sentence: `No hexahedral mesh can have this field’s singular lines: ${faults} ${one ? "is" : "are"} of a kind that hexahedra cannot form.`,
    };
  }
  if (arcs === 0) {
    return { judgement: "good", short: "No singular lines", sentence: "There are no singular lines: a hexahedral mesh can follow the field everywhere." };
  }
  if (undecided_nodes > 0) {
    return {
      judgement: "unsure",
      short: "Undecided",
      sentence: `No fault was found, but ${plural(undecided_nodes, "node")} cannot be judged: too many hexahedra would meet there.`,
    };
  }
  return { judgement: "good", short: "Fit for hexahedra", sentence: "A hexahedral mesh can have this field’s singular lines." };
}

const kSigns: Record<Judgement, string> = { good: "✓", unsure: "?", bad: "!" };

export function badge(verdict: Verdict | null): Node[] {
  if (!verdict) return [];
  return [element("span", { class: `sign ${verdict.judgement}`, "aria-hidden": "true" }, kSigns[verdict.judgement]), document.createTextNode(verdict.short)];
}

export function verdict_card(verdict: Verdict | null): HTMLElement | null {
  if (!verdict) return null;
  return element("div", { class: `verdict ${verdict.judgement}`, "data-testid": "verdict" },
    element("span", { class: `sign ${verdict.judgement}`, "aria-hidden": "true" }, kSigns[verdict.judgement]),
    element("div", {},
      element("p", { class: "verdict-text" }, verdict.sentence),
      element("p", { class: "fine" }, verdict.judgement === "bad" ? "The places are listed below." : "Necessary for a hexahedral mesh, not sufficient."),
    ),
  );
}

function number(name: string, value: string, note = "", test = ""): HTMLElement {
  return element("div", { class: "number" },
    element("dt", {}, name),
    element("dd", { "data-testid": test || undefined }, value, note ? element("small", {}, note) : null),
  );
}

export function key_numbers(report: Report): HTMLElement {
  const list = element("dl", { class: "numbers", "data-testid": "numbers" });
  const last = report.levels?.at(-1);
  if (last) list.append(number("Cells", counted(last.active_cells), `depth ${last.depth}`, "number-cells"));
  if (report.energy) {
    const { total, smoothness } = report.energy;
    list.append(number("Energy", measured(total, 4), Number.isFinite(total) ? `${total > 0 ? Math.round((100 * smoothness) / total) : 100} % smoothness` : "", "number-energy"));
  }
  const singular = report.singularity;
  if (singular) {
    list.append(number("Singular lines", counted(singular.arcs), plural(singular.nodes, "node"), "number-arcs"));
  }
  if (report.seconds?.total !== undefined || report.peak_memory_bytes !== undefined) {
    const seconds = report.seconds?.total !== undefined ? duration(report.seconds.total) : "–";
    list.append(number("Time", seconds, report.peak_memory_bytes ? memory(report.peak_memory_bytes) : ""));
  }
  return list;
}

/** Alignment as a scale: where mean, 95th percentile and largest angle lie between 0 and the 54.7 degrees there can be at most. */
export function alignment_scale(report: Report): HTMLElement | null {
  const alignment = report.alignment_deg;
  if (!alignment) return null;
  const place = (value: number): string => `${(100 * Math.sqrt(Math.min(1, value / 54.74))).toFixed(2)}%`;
  const ticks = [0, 1, 5, 15, 30, 54.7];
  const excluded = alignment.excluded_share ?? 0;
  return element("section", { class: "block" },
    element("h2", {}, "Alignment to the surface"),
    element("dl", { class: "triple" },
      number("mean", degrees(alignment.mean), "", "alignment-mean"),
      number("95 %", degrees(alignment.p95), "", "alignment-p95"),
      number("largest", degrees(alignment.max), "", "alignment-max"),
    ),
    element("div", { class: "scale", "aria-hidden": "true" },
      element("div", { class: "scale-bar", style: `width: ${place(alignment.p95)}` }),
      element("span", { class: "scale-mean", style: `left: ${place(alignment.mean)}` }),
      element("span", { class: "scale-max", style: `left: ${place(alignment.max)}` }),
      ...ticks.map((tick) => element("span", { class: "scale-tick", style: `left: ${place(tick)}` }, `${tick}°`)),
    ),
    element("p", { class: "fine" },
      `Between normal and nearest axis, by area; ${excluded > 0 ? `without the ${(100 * excluded).toFixed(excluded < 0.001 ? 2 : 1)} % of the surface where no frame could align` : "of the whole surface"}.`),
  );
}

export function warnings_list(report: Report): HTMLElement | null {
  const warnings = report.warnings ?? [];
  if (warnings.length === 0) return null;
  return element("section", { class: "block" },
    element("h2", {}, "Warnings", element("span", { class: "tally" }, String(warnings.length))),
    element("ul", { class: "warnings", "data-testid": "warnings" }, ...warnings.map((warning) => element("li", {}, sentence_of(warning)))),
  );
}

/** Without the file, whose whole path is nothing to show. */
function sentence_of({ place, text, advice }: Warning): string {
  return `${place ? `${place}: ` : ""}${text}${advice ? `; ${advice}` : ""}`;
}

export function about(report: Report): HTMLElement {
  const model = report.model ?? {};
  const facts: [string, string][] = [];
  if (model.path) facts.push(["Model", model.path]);
  if (model.triangles !== undefined) facts.push(["Surface", `${plural(model.triangles, "triangle")}${model.components && model.components > 1 ? `, ${model.components} components` : ""}${model.watertight === false ? ", not watertight" : ""}`]);
  if (report.resolution !== undefined) facts.push(["Resolution", `${measured(report.resolution, 4)} cells along the longest side`]);
  if (report.degree) facts.push(["Harmonics", `degree ${report.degree}`]);
  if (report.walls?.thinnest_cells) {
    const cells = measured(report.walls.thinnest_cells);
    facts.push(["Thinnest wall", `${cells} ${cells === "1" ? "cell" : "cells"}`]);
  }
  if (report.version) facts.push(["Crossgrain", report.version]);
  return element("section", { class: "block" },
    element("h2", {}, "About this field"),
    element("dl", { class: "facts" }, ...facts.flatMap(([name, value]) => [element("dt", {}, name), element("dd", {}, value)])),
  );
}
