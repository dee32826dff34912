// SPDX-License-Identifier: Apache-2.0
// What is known of a mesh of hexahedra and of one of them.

import { add, subtract } from "../math/frame.ts";
import { edge_lengths, hexahedron_count, kInverted, number_of } from "../scene/hexahedra.ts";
import type { HexReport, Report } from "../scene/report.ts";
import type { Scene } from "../scene/scene.ts";
import type { HexView } from "../view/hex_view.ts";
import type { Badge } from "./badge.ts";
import { counted, element, measured, plural } from "./dom.ts";
import type { Place } from "./place.ts";

export const hexahedra_text = (count: number): string => plural(count, "hexahedron", "hexahedra");

/** Everything the panel says of a hexahedron, as values; tests and `window.crossgrain` read it too. */
export function describe_hexahedron(scene: Scene, view: HexView, hexahedron: number) {
  const hexahedra = scene.hexahedra!;
  return {
    kind: "hexahedron",
    /** Its number in the mesh, from 0. */
    number: number_of(hexahedra, hexahedron),
    center: add(view.center(hexahedron), scene.origin),
    scaled_jacobian: hexahedra.shape[hexahedron],
    edges: edge_lengths(hexahedra, hexahedron),
  };
}

export type HexDescription = ReturnType<typeof describe_hexahedron>;

export const hexahedron_title = ({ number }: HexDescription): string => `Hexahedron ${counted(number)}`;

export function show_hexahedron(panel: HTMLElement, hexahedron: HexDescription, unit: string, actions: { go(): void; close(): void }): void {
  const { center, scaled_jacobian, edges } = hexahedron;
  const length = unit ? ` ${unit}` : "";
  const facts: [string, string, string][] = [
    ["Scaled Jacobian", `${scaled_jacobian.toFixed(3).replace("-", "−")}${scaled_jacobian > kInverted ? "" : ", inverted"}`, "hexahedron-shape"],
    ["Centre", center.map((value) => measured(value, 4)).join(", "), "hexahedron-center"],
    ["Edges", `${measured(edges.least)} to ${measured(edges.most)}${length}`, "hexahedron-edges"],
  ];
  panel.replaceChildren(
    element("div", { class: "cell-head" },
      element("h2", { "data-testid": "cell-title" }, hexahedron_title(hexahedron)),
      element("div", { class: "buttons" },
        element("button", { type: "button", click: actions.go, "data-testid": "cell-go" }, "Show"),
        element("button", { type: "button", click: actions.close, "data-testid": "cell-close" }, "Clear")),
    ),
    element("dl", { class: "facts" }, ...facts.flatMap(([name, value, test]) => [element("dt", {}, name), element("dd", { "data-testid": test }, value)])),
    element("section", { class: "block" }, element("p", { class: "fine" }, "The scaled Jacobian is the least determinant of unit vectors along the edges at a corner: 1 for a cube, 0 or less if it is inverted. Its number is that in the files, from 0.")),
  );
}

const kOutcomes: Record<string, Badge> = {
  "all-hex": { judgement: "good", short: "all-hex", sign: "✓" },
  flawed: { judgement: "unsure", short: "flawed mesh", sign: "!" },
  partial: { judgement: "unsure", short: "partial mesh", sign: "!" },
  none: { judgement: "bad", short: "no mesh", sign: "!" },
};

/** Whether hexahedra fill the model; null if none were asked for. */
export const hexahedra_badge = ({ hexahedra }: Report): Badge | null => (hexahedra ? (kOutcomes[hexahedra.outcome] ?? kOutcomes.partial) : null);

/** The same in a card like that of the answer. */
export function hexahedra_card(report: Report): HTMLElement | null {
  const outcome = hexahedra_badge(report);
  const { hexahedra } = report;
  if (!hexahedra || !outcome) return null;
  return element("div", { class: `verdict ${outcome.judgement}`, "data-testid": "hexahedra" },
    element("span", { class: `sign ${outcome.judgement}`, "aria-hidden": "true" }, outcome.sign),
    element("div", {},
      element("p", { class: "words" }, element("strong", { class: "verdict-text" }, outcome.short), `: ${summary_of(hexahedra)}`),
      hexahedra.reason ? element("p", { class: "fine" }, `${hexahedra.reason}${hexahedra.next ? `; ${hexahedra.next}` : ""}.`) : null),
  );
}

function summary_of({ hexahedra, scaled_jacobian }: HexReport): string {
  if (hexahedra === 0 || !scaled_jacobian) return hexahedra_text(hexahedra);
  const { min, mean, inverted } = scaled_jacobian;
  const shapes = `scaled Jacobian ${two_digits(min)} at least, ${two_digits(mean)} in the mean`;
  return `${hexahedra_text(hexahedra)}, ${shapes}${inverted ? `, ${counted(inverted)} inverted` : ""}`;
}

export const two_digits = (value: number): string => value.toFixed(2).replace("-", "−");

/** Where the worst hexahedron is, and where the mesh lacks some. */
export function hexahedra_places(report: Report, origin: [number, number, number]): Place[] {
  const { hexahedra } = report;
  const shapes = hexahedra?.scaled_jacobian;
  const places: Place[] = [];
  if (hexahedra && hexahedra.hexahedra > 0 && shapes?.worst_place) {
    places.push({ label: `Hexahedron of scaled Jacobian ${two_digits(shapes.min)}`, detail: "the worst", short: "Worst hexahedron", point: subtract(shapes.worst_place, origin), warn: shapes.inverted > 0 });
  }
  (hexahedra?.places ?? []).forEach((place, k) => places.push({ label: `Place ${k + 1}`, detail: hexahedra?.reason ?? "", point: subtract(place, origin), warn: true }));
  return places;
}

/** How many are shown, if not all. */
export function hexahedra_shown({ hexahedra }: Scene): string {
  if (!hexahedra || hexahedron_count(hexahedra) === hexahedra.total) return "";
  return `The page has ${counted(hexahedron_count(hexahedra))} of ${hexahedra_text(hexahedra.total)}: those at the surface and the worst.`;
}
