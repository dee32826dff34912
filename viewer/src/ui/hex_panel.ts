// SPDX-License-Identifier: Apache-2.0
// What is known of one hexahedron.

import { add } from "../math/frame.ts";
import { edge_lengths, hexahedron_count, is_inverted, number_of, type HexColor, type Hexahedra } from "../scene/hexahedra.ts";
import type { Scene } from "../scene/scene.ts";
import type { HexView } from "../view/hex_view.ts";
import { coordinates, counted, element, measured, plural } from "./dom.ts";

export const kHexColorNames: Record<HexColor, string> = { shape: "Quality", face: "Face", region: "Region" };

export const hexahedra_text = (count: number): string => plural(count, "hexahedron", "hexahedra");

/** A scaled Jacobian: two digits, so that one near 0 is told from one that is not. Of 0 or less it is of an inverted hexahedron. */
export const shape_text = (shape: number, inverted = shape <= 0): string => `${measured(shape, 2)}${inverted ? ", inverted" : ""}`;

/** Everything the panel says of a hexahedron, as values; tests and `window.crossgrain` read it too. */
export function describe_hexahedron(scene: Scene, view: HexView, hexahedron: number) {
  const hexahedra = scene.hexahedra!;
  return {
    kind: "hexahedron",
    /** As in the files, from 1. */
    number: number_of(hexahedra, hexahedron),
    center: add(view.center(hexahedron), scene.origin),
    scaled_jacobian: hexahedra.shape[hexahedron],
    inverted: is_inverted(hexahedra, hexahedron),
    edges: edge_lengths(hexahedra, hexahedron),
  };
}

export type HexDescription = ReturnType<typeof describe_hexahedron>;

export const hexahedron_title = ({ number }: { number: number }): string => `Hexahedron ${counted(number)}`;

export function show_hexahedron(panel: HTMLElement, hexahedron: HexDescription, unit: string, actions: { go(): void; close(): void }): void {
  const { center, scaled_jacobian, inverted, edges } = hexahedron;
  const length = unit ? ` ${unit}` : "";
  const facts: [string, string, string][] = [
    ["Scaled Jacobian", `${measured(scaled_jacobian)}${inverted ? ", inverted" : ""}`, "hexahedron-shape"],
    ["Centre", coordinates(center), "hexahedron-center"],
    ["Edges", `${measured(edges.least)} to ${measured(edges.most)}${length}`, "hexahedron-edges"],
  ];
  panel.replaceChildren(
    element("div", { class: "cell-head" },
      element("h2", { "data-testid": "cell-title" }, hexahedron_title(hexahedron)),
      element("div", { class: "buttons" },
        element("button", { type: "button", click: actions.go, "data-testid": "cell-go", title: "Alone, with those around it faintly" }, "Show"),
        element("button", { type: "button", click: actions.close, "data-testid": "cell-close" }, "Clear")),
    ),
    element("dl", { class: "facts" }, ...facts.flatMap(([name, value, test]) => [element("dt", {}, name), element("dd", { "data-testid": test }, value)])),
    element("p", { class: "fine" }, "The scaled Jacobian is the least determinant of unit vectors along the edges at a corner: 1 for a cube, 0 or less if it is inverted there. Its number is that in the files, which count from 1."),
  );
}

/** How many are shown, and how many there are. */
export function hexahedra_shown(hexahedra: Hexahedra, shown: number): string {
  const total = hexahedra_text(hexahedra.total);
  const here = hexahedron_count(hexahedra);
  const count = shown < hexahedra.total ? `${counted(shown)} of ${total}` : total;
  return here < hexahedra.total ? `${count}; the page has ${counted(here)}, those at the surface and the worst.` : count;
}
