// SPDX-License-Identifier: Apache-2.0
// The numbers by which a field is judged, from the report alone.

import { judged_lines, type Report, type Statistics, type Warning } from "../scene/report.ts";
import { advice_on } from "./advice.ts";
import { amount, counted, degrees, duration, element, measured, memory, plural } from "./dom.ts";

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

/** A number with its name above and a note below. */
export function number(name: string, value: string, note = "", test = ""): HTMLElement {
  return element("div", { class: "number" },
    element("dt", {}, name),
    element("dd", { "data-testid": test || undefined }, value, note ? element("small", {}, note) : null),
  );
}

export function key_numbers(report: Report): HTMLElement {
  const list = element("dl", { class: "numbers", "data-testid": "numbers" });
  const last = report.levels?.at(-1);
  const { onto } = report;
  if (onto) list.append(number("Tets", counted(onto.tets), last ? `from a grid of ${plural(last.active_cells, "cell")}` : "", "number-tets"));
  else if (last) list.append(number("Cells", counted(last.active_cells), `depth ${last.depth}`, "number-cells"));
  const energy = report.energy ? energy_number(report.energy, onto ? "on the grid" : "") : "";
  const singular = judged_lines(report);
  const lines = singular ? number("Singular lines", counted(singular.arcs), `${plural(singular.nodes, "node")}${onto ? ", on the tets" : ""}`, "number-arcs") : "";
  // Of tets, what concerns them first.
  list.append(...(onto ? [lines, energy] : [energy, lines]));
  // Of hexahedra it stands with their numbers.
  if (!report.hexahedra && (report.seconds?.total !== undefined || report.peak_memory_bytes !== undefined)) {
    const seconds = report.seconds?.total !== undefined ? duration(report.seconds.total) : "–";
    list.append(number("Time", seconds, report.peak_memory_bytes ? memory(report.peak_memory_bytes) : ""));
  }
  return list;
}

function energy_number({ total, smoothness }: NonNullable<Report["energy"]>, where: string): HTMLElement {
  const share = Number.isFinite(total) ? `${total > 0 ? Math.round((100 * smoothness) / total) : 100} % smoothness` : "";
  return number("Energy", measured(total, 4), [share, where].filter(Boolean).join(", "), "number-energy");
}

/** Of nearly all of the surface: what is left is a cell or two. */
const kNothingMeasured = 0.9995;
const kNothing = "No frame could align anywhere.";

/** The three numbers; null where nothing was measured. */
function measured_angles(angles: Statistics | undefined): { mean: number; p95: number; max: number } | null {
  const { mean, p95, max } = angles ?? {};
  return Number.isFinite(mean) && Number.isFinite(p95) && Number.isFinite(max) ? { mean: mean!, p95: p95!, max: max! } : null;
}

function triple(angles: Statistics | null, test: string): HTMLElement {
  const text = (value: number | null | undefined): string => (angles ? degrees(value!) : "n/a");
  return element("dl", { class: "triple" },
    number("mean", text(angles?.mean), "", `${test}-mean`),
    number("95 %", text(angles?.p95), "", `${test}-p95`),
    number("largest", text(angles?.max), "", `${test}-max`),
  );
}

/** Alignment as a scale: where mean, 95th percentile and largest angle lie between 0 and the 54.7 degrees there can be at most. */
export function alignment_scale(report: Report): HTMLElement | null {
  const alignment = report.alignment_deg;
  if (!alignment) return null;
  const place = (value: number): string => `${(100 * Math.sqrt(Math.min(1, value / 54.74))).toFixed(2)}%`;
  const ticks = [0, 1, 5, 15, 30, 54.7];
  const excluded = alignment.excluded_share ?? 0;
  const angles = excluded < kNothingMeasured ? measured_angles(alignment) : null;
  const of_what = excluded > 0 ? `without the ${(100 * excluded).toFixed(excluded < 0.001 ? 2 : 1)} % of the surface where no frame could align` : "of the whole surface";
  return element("section", { class: "block" },
    element("h2", {}, report.onto ? "Alignment to the surface, on the grid" : "Alignment to the surface"),
    triple(angles, "alignment"),
    angles && element("div", { class: "scale", "aria-hidden": "true" },
      element("div", { class: "scale-bar", style: `width: ${place(angles.p95)}` }),
      element("span", { class: "scale-mean", style: `left: ${place(angles.mean)}` }),
      element("span", { class: "scale-max", style: `left: ${place(angles.max)}` }),
      ...ticks.map((tick) => element("span", { class: "scale-tick", style: `left: ${place(tick)}` }, `${tick}°`)),
    ),
    element("p", { class: "fine", "data-testid": "alignment-note" }, angles ? `Between normal and nearest axis, by area; ${of_what}.` : kNothing),
  );
}

/** Alignment of the field on tets, at vertices inside faces and at those of creases and corners. */
export function tet_alignment(report: Report): HTMLElement | null {
  const { onto } = report;
  if (!onto) return null;
  const rows: [string, Statistics | undefined, string][] = [
    ["Where the surface is smooth", onto.normal_deg, "tets-smooth"], ["At its creases and corners", onto.crease_deg, "tets-crease"],
  ];
  const off = onto.unfollowed_share ? ` Frames are far off ${measured(100 * onto.unfollowed_share, 2)} % of the surface.` : "";
  return element("section", { class: "block" },
    element("h2", {}, "Alignment to the surface, on the tets"),
    ...rows.flatMap(([name, angles, test]) => [element("h3", {}, name), triple(measured_angles(angles), test)]),
    element("p", { class: "fine" }, `Between normals of faces and the nearest axis of their vertices’ frames.${off}`),
  );
}

/** Whether what a warning says stands in the panel already: as a reason, or with its places in a list. */
function stands_elsewhere({ kind }: Warning, { reasons = [], input, creases }: Report): boolean {
  switch (kind) {
    case "surface_finding": return (input?.findings ?? []).length > 0;
    case "crowded_corners": return (creases?.crowded_corner_places ?? []).length > 0;
    case "thin_walls": return reasons.some((reason) => reason.kind === "walls");
    case "knife_edges": return reasons.some((reason) => reason.kind === "knife_edge");
    default: return false;
  }
}

const kKindsOfField = ["crowded_corners", "knife_edges", "unfinished", "memory_limited", "thin_walls", "excluded_surface", "not_settled", "tets_not_settled", "constraints_outside", "vertices_outside", "refused_splits"];

/** Whether a warning is about the field, not about the model or hexahedra. */
export const is_of_field = ({ kind }: Warning): boolean => kKindsOfField.includes(kind);

/** All warnings, or those that are wanted. */
export function warnings_list(report: Report, is_wanted: (warning: Warning) => boolean = () => true): HTMLElement | null {
  const warnings = (report.warnings ?? []).filter((warning) => !stands_elsewhere(warning, report) && is_wanted(warning));
  if (warnings.length === 0) return null;
  return element("section", { class: "block" },
    element("h2", {}, "Warnings", element("span", { class: "tally" }, String(warnings.length))),
    element("ul", { class: "warnings", "data-testid": "warnings" }, ...warnings.map((warning) => element("li", {}, sentence_of(warning)))),
  );
}

/** Without the file, whose whole path is nothing to show. */
function sentence_of({ place, text, remedy, advice }: Warning): string {
  const next = advice_on(remedy, undefined, advice);
  return `${place ? `${place}: ` : ""}${text}${next ? `; ${next}` : ""}`;
}

export function about(report: Report): HTMLElement {
  const model = report.model ?? {};
  const facts: [string, string][] = [];
  if (model.path) facts.push(["Model", model.path]);
  if (model.triangles !== undefined) facts.push(["Surface", `${plural(model.triangles, "triangle")}${model.components && model.components > 1 ? `, ${model.components} components` : ""}${model.watertight === false ? ", not watertight" : ""}`]);
  if (!report.hexahedra) facts.push(...facts_of_field(report));
  if (!report.hexahedra && report.walls?.thinnest_cells) facts.push(["Thinnest wall", amount(report.walls.thinnest_cells, "cell")]);
  if (report.version) facts.push(["Crossgrain", report.version]);
  return element("section", { class: "block", "data-testid": "about" },
    element("h2", {}, report.hexahedra ? "About this mesh" : "About this field"), fact_list(facts));
}

/** How the field was asked for. */
export function facts_of_field({ resolution, degree }: Report): [string, string][] {
  const facts: [string, string][] = [];
  if (resolution !== undefined) facts.push(["Resolution", `${amount(resolution, "cell", 4)} along the longest side`]);
  if (degree) facts.push(["Harmonics", `degree ${degree}`]);
  return facts;
}

export const fact_list = (facts: [string, string][]): HTMLElement =>
  element("dl", { class: "facts" }, ...facts.flatMap(([name, value]) => [element("dt", {}, name), element("dd", {}, value)]));
