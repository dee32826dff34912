// SPDX-License-Identifier: Apache-2.0
// Energy and time of each level of the solve, as two small charts over one axis.

import type { Report } from "../scene/report.ts";
import { counted, drawing, duration, element, measured } from "./dom.ts";

const kWidth = 308;
const kHeight = 121;
const kTop = 16;
const kBase = 104;
const kLabelRoom = 6;

export function levels_chart(report: Report): HTMLElement | null {
  const levels = report.levels ?? [];
  if (levels.length === 0) return null;
  const half = kWidth / 2;
  const energy = panel("Energy", levels.map((level) => level.energy), (value) => measured(value), 0, half - kLabelRoom, "line");
  const time = panel("Time", levels.map((level) => level.seconds), duration, half + kLabelRoom, half - kLabelRoom, "bars");
  const depths = [0, half + kLabelRoom].flatMap((left) =>
    levels.map((level, k) =>
      drawing("text", { x: left + place(k, levels.length, half - kLabelRoom), y: kBase + 14, class: "chart-depth", "text-anchor": "middle" }, String(level.depth))));
  const table = element("table", { class: "visually-hidden" },
    element("caption", {}, "Levels of the solve"),
    element("tr", {}, ...["Depth", "Cells", "Energy", "Time"].map((name) => element("th", { scope: "col" }, name))),
    ...levels.map((level) => element("tr", {}, ...[String(level.depth), counted(level.active_cells), measured(level.energy), duration(level.seconds)].map((text) => element("td", {}, text)))));
  return element("section", { class: "block" },
    element("h2", {}, "Levels"),
    drawing("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, class: "chart", "aria-hidden": "true", "data-testid": "levels" }, ...energy, ...time, ...depths),
    table,
    element("p", { class: "fine" }, "By depth of the octree. Each level has the energy of its own grid, so the energy may rise."),
  );
}

/** The middle of column k. */
const place = (k: number, count: number, width: number): number => ((k + 0.5) / count) * width;

function panel(name: string, values: number[], format: (value: number) => string, left: number, width: number, kind: "line" | "bars"): SVGElement[] {
  const largest = Math.max(...values, 1e-30);
  const x = (k: number): number => left + place(k, values.length, width);
  const y = (value: number): number => kBase - (value / largest) * (kBase - kTop - 14);
  const title = (k: number): SVGElement => drawing("title", {}, `${name}: ${format(values[k])}`);
  const parts: SVGElement[] = [
    drawing("text", { x: left, y: kTop - 5, class: "chart-name" }, name),
    drawing("text", { x: left + width, y: kTop - 5, class: "chart-value", "text-anchor": "end" }, format(values[values.length - 1])),
    drawing("line", { x1: left, x2: left + width, y1: kBase, y2: kBase, class: "chart-axis" }),
  ];
  if (kind === "line") {
    parts.push(drawing("polyline", { points: values.map((value, k) => `${x(k)},${y(value)}`).join(" "), class: "chart-line" }));
    values.forEach((value, k) => parts.push(drawing("circle", { cx: x(k), cy: y(value), r: 2.6, class: "chart-dot" }, title(k))));
  } else {
    const bar = Math.min(18, (0.62 * width) / values.length);
    values.forEach((value, k) => parts.push(
      drawing("rect", { x: x(k) - bar / 2, width: bar, y: y(value), height: Math.max(0.75, kBase - y(value)), class: "chart-bar" }, title(k))));
  }
  return parts;
}
