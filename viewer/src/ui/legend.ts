// SPDX-License-Identifier: Apache-2.0
// What colours and patterns mean: singular lines, the colour map, and frames.

import { css_gradient, kClasses, region_color, type Theme } from "../math/color_maps.ts";
import { faces_of_hexahedra, type HexColor, type Hexahedra } from "../scene/hexahedra.ts";
import type { Scene } from "../scene/scene.ts";
import type { Settings } from "../settings.ts";
import { kTiltScale } from "../view/frame_colors.ts";
import type { Range, Ranges } from "../view/ranges.ts";
import { fault_counts, mark_counts, type FaultMark } from "../view/line_marks.ts";
import { arc_kind, kArcKinds, type ArcKind } from "../view/singular_lines.ts";
import { axis_colors, kViewColors } from "../view/view_colors.ts";
import { counted, drawing, element, measured, superscript } from "./dom.ts";

const kStackedRows = 3;
const kImpossible = "impossible for hexahedra";
const kArcNames: Record<ArcKind, string> = {
  positive: "index +1/4",
  negative: "index −1/4",
  half: "index ±1/2",
  warn: kImpossible,
  undecided: "undecided",
};

/** Arcs of each kind. */
export function arc_counts(scene: Scene): Record<ArcKind, number> {
  const counts = { positive: 0, negative: 0, half: 0, warn: 0, undecided: 0 };
  for (let arc = 0; arc + 1 < scene.arc_starts.length; ++arc) ++counts[arc_kind(scene, arc)];
  return counts;
}

/** The field that is shown. */
export interface LegendSource {
  scene: Scene;
  ranges: Ranges;
  faults: FaultMark[];
  hexahedra: object | null;
}

export function legend_body(settings: Settings, theme: Theme, { scene, ranges, faults, hexahedra }: LegendSource): Node[] {
  const field_name = scene.tets || scene.tet_counts ? "on the tets" : settings.field === "grid" ? "on the starting grid" : "";
  const blocks: Node[] = [];
  const is_solid = hexahedra !== null && settings.layers.hexahedra;
  if (is_solid) {
    const { mesh_lines } = settings.layers;
    return [hexahedra_block(scene.hexahedra!, settings.hex_color, theme), ...(scene.has_field ? line_blocks({ arcs: mesh_lines, nodes: mesh_lines }, theme, scene, faults, field_name) : [])];
  }
  if (!scene.has_field) return [];
  if (settings.map === "alignment") blocks.push(ramp("Alignment", css_gradient("alignment", theme), linear_ticks(ranges.alignment, "°"), "angle of normal and nearest axis"));
  if (settings.map === "energy") blocks.push(ramp("Energy density", css_gradient("energy", theme), decade_ticks(ranges.energy), scene.unit ? `per volume, ${scene.unit}⁻²` : "per volume"));
  if (settings.map === "class") blocks.push(class_list(theme));
  if (settings.map === "region") blocks.push(region_list(scene.regions));
  const shows_frames = settings.layers.glyphs && settings.cut.on;
  const shows_streams = settings.layers.streamlines && scene.streamline_starts.length > 1;
  if (shows_frames) {
    const { color } = settings.glyph;
    if (color === "tilt") blocks.push(ramp("Frames: tilt", css_gradient("tilt", theme), linear_ticks({ low: 0, high: kTiltScale, logarithmic: false }, "°"), "nearest axis to the cut’s normal"));
    if (color === "turn") blocks.push(ramp("Frames: turn in the cut", css_gradient("turn", theme), linear_ticks({ low: 0, high: 90, logarithmic: false }, "°"), "all colours around a singular line"));
  }
  const named = shows_frames && settings.glyph.color === "axes";
  if (named || shows_streams) blocks.push(axis_list(theme, named, shows_streams));
  return [...blocks, ...line_blocks(settings.layers, theme, scene, faults, field_name)];
}

function line_blocks({ arcs, nodes }: { arcs: boolean; nodes: boolean }, theme: Theme, scene: Scene, faults: FaultMark[], field_name: string): Node[] {
  const of_lines = [...(arcs ? [arc_list(scene, theme, field_name)] : []), ...(nodes ? mark_list(scene, theme) : [])];
  // Beneath each other where that is no higher than a colour map with its words, so that one row has room for all.
  const rows = of_lines.reduce((sum, block) => sum + block.querySelectorAll("li").length, 0);
  const blocks = of_lines.length > 1 && rows <= kStackedRows ? [element("div", { class: "legend-stack" }, ...of_lines)] : of_lines;
  return [...blocks, ...(nodes ? fault_list(scene, faults, theme) : [])];
}

/** What the colours of hexahedra mean. */
function hexahedra_block(hexahedra: Hexahedra, color: HexColor, theme: Theme): HTMLElement {
  if (color === "region" && hexahedra.regions.length > 1) return region_list(hexahedra.regions);
  const faces = color === "face" ? faces_of_hexahedra(hexahedra).length : 0;
  if (faces > 0) {
    return element("div", { class: "legend-block", "data-testid": "legend-faces" },
      element("h3", {}, "Faces of the model"),
      element("p", { class: "fine" }, `A colour for each of ${counted(faces)}; a click tells its number.`));
  }
  const { inverted, mean, shape } = hexahedra;
  const least = shape.reduce((a, b) => Math.min(a, b), 1);
  const block = ramp("Scaled Jacobian", css_gradient("shape", theme), linear_ticks({ low: 0, high: 1, logarithmic: false }, ""), `${measured(least, 2)} at least, ${measured(mean, 2)} in the mean`);
  if (inverted > 0) {
    block.append(element("ul", { class: "keys", "data-testid": "legend-inverted" },
      element("li", {}, element("span", { class: "swatch", style: `background-color: ${kViewColors[theme].inverted}` }), "inverted", element("span", { class: "tally" }, counted(inverted)))));
  }
  return block;
}

function ramp(name: string, gradient: string, ticks: [string, number][], note: string): HTMLElement {
  return element("div", { class: "legend-block", "data-testid": "legend-ramp" },
    element("h3", {}, name),
    element("div", { class: "ramp", style: `background: ${gradient}` }),
    element("div", { class: "ramp-ticks" }, ...ticks.map(([text, place]) => element("span", { style: `left: ${(100 * place).toFixed(1)}%` }, text))),
    note ? element("p", { class: "fine" }, note) : null,
  );
}

function linear_ticks({ low, high }: Range, unit: string): [string, number][] {
  return [0, 0.5, 1].map((share) => [`${measured(low + share * (high - low))}${unit}`, share]);
}

function decade_ticks({ low, high }: Range): [string, number][] {
  const first = Math.round(Math.log10(low));
  const last = Math.round(Math.log10(high));
  return Array.from({ length: last - first + 1 }, (_, k) => [`10${superscript(first + k)}`, k / (last - first)]);
}

function class_list(theme: Theme): HTMLElement {
  return element("div", { class: "legend-block", "data-testid": "legend-class" },
    element("h3", {}, "Surface constraints"),
    element("ul", { class: "keys" }, ...kClasses.slice(1).map(({ name, meaning, color }) =>
      element("li", { title: meaning },
        element("span", { class: `swatch ${name === "conflicted" ? "hatched" : name === "free" ? "hatched back" : ""}`, style: `background-color: ${color[theme]}` }),
        name))),
  );
}

/** The colours of axes, of frames and streamlines alike. */
function axis_list(theme: Theme, frames: boolean, streams: boolean): HTMLElement {
  const bar = (color: string, dashes = ""): SVGElement => drawing("svg", { viewBox: "0 0 30 14", class: "arc-swatch", "aria-hidden": "true" },
    drawing("line", { x1: 1, x2: 29, y1: 7, y2: 7, stroke: color, "stroke-width": dashes ? 1.6 : 4, "stroke-dasharray": dashes || undefined }));
  return element("div", { class: "legend-block", "data-testid": "legend-axes" },
    element("h3", {}, frames && streams ? "Axes of frames and streamlines" : frames ? "Axes of frames" : "Streamlines"),
    element("ul", { class: "keys" },
      element("li", { class: "axis-row" }, ...axis_colors(theme).flatMap((color, k) => [bar(color), "xyz"[k]])),
      frames ? element("li", { title: "Around a singular line the axes change places: names have to change somewhere" }, bar(kViewColors[theme].seam, "4 3"), "seam: names change") : null),
  );
}

function region_list(regions: number[]): HTMLElement {
  const most = 12;
  return element("div", { class: "legend-block", "data-testid": "legend-region" },
    element("h3", {}, "Regions"),
    element("ul", { class: "keys" }, ...regions.slice(0, most).map((number, k) =>
      element("li", {}, element("span", { class: "swatch", style: `background-color: ${region_color(k)}` }), String(number)))),
    regions.length > most ? element("p", { class: "fine" }, `and ${regions.length - most} more`) : null,
  );
}

function arc_list(scene: Scene, theme: Theme, field_name: string): HTMLElement {
  const counts = arc_counts(scene);
  const present = kArcKinds.filter((kind) => counts[kind] > 0);
  return element("div", { class: "legend-block", "data-testid": "legend-arcs" },
    element("h3", {}, field_name ? `Singular lines, ${field_name}` : "Singular lines"),
    present.length === 0
      ? element("p", { class: "fine" }, "none")
      : element("ul", { class: "keys" }, ...present.map((kind) =>
          element("li", {}, arc_swatch(kind, kViewColors[theme][kind]), kArcNames[kind], element("span", { class: "tally" }, counted(counts[kind]))))),
  );
}

/** A piece of the tube with its pattern. */
function arc_swatch(kind: ArcKind, color: string): SVGElement {
  const height = kind === "warn" ? 8 : 5;
  const middle = 7;
  const bands: [number, number][] = kind === "negative" ? [[4, 3], [14, 3], [24, 3]] : kind === "half" ? [[3, 2], [7, 1.5], [15, 2], [19, 1.5], [27, 2]] : kind === "warn" ? [[0, 5], [10, 5], [20, 5]] : [];
  return drawing("svg", { viewBox: "0 0 30 14", class: "arc-swatch", "aria-hidden": "true" },
    drawing("rect", { x: 0, y: middle - height / 2, width: 30, height, rx: 1.5, fill: color }),
    ...bands.map(([x, width]) => drawing("rect", { x, y: middle - height / 2, width, height, fill: kind === "warn" ? "#fff" : "#000", "fill-opacity": kind === "warn" ? 0.55 : 0.62 })));
}

/** The shapes of marks that occur. */
function mark_list(scene: Scene, theme: Theme): HTMLElement[] {
  const { nodes, ends, turns } = mark_counts(scene);
  const { node, turn } = kViewColors[theme];
  const rows: [string, SVGElement, number][] = [
    ["node: lines meet", drawing("circle", { cx: 15, cy: 7, r: 5, fill: node }), nodes],
    ["end on the surface", drawing("ellipse", { cx: 15, cy: 7, rx: 7, ry: 3, fill: node }), ends],
    ["turning point", drawing("path", { d: "M15 0l6 7l-6 7l-6-7z", fill: turn, stroke: "#806000", "stroke-width": 0.8 }), turns],
  ];
  const present = rows.filter(([, , count]) => count > 0);
  if (present.length === 0) return [];
  return [element("div", { class: "legend-block", "data-testid": "legend-marks" },
    element("h3", {}, "Marks"),
    element("ul", { class: "keys" }, ...present.map(([name, shape, count]) =>
      element("li", {}, drawing("svg", { viewBox: "0 0 30 14", class: "arc-swatch", "aria-hidden": "true" }, shape), name, element("span", { class: "tally" }, counted(count))))),
  )];
}

/** The colours of marks that hexahedra cannot have, or of which that is undecided; none if there are none. */
function fault_list(scene: Scene, faults: FaultMark[], theme: Theme): HTMLElement[] {
  const counts = fault_counts(scene, faults);
  const rows: [string, string, number][] = [[kImpossible, kViewColors[theme].warn, counts.impossible], ["undecided", kViewColors[theme].undecided, counts.undecided]];
  const present = rows.filter(([, , count]) => count > 0);
  if (present.length === 0) return [];
  return [element("div", { class: "legend-block", "data-testid": "legend-balls" },
    element("h3", {}, "Nodes, creases, corners"),
    element("ul", { class: "keys" }, ...present.map(([name, color, count]) =>
      element("li", {},
        drawing("svg", { viewBox: "0 0 30 14", class: "arc-swatch", "aria-hidden": "true" }, drawing("rect", { x: 10, y: 2, width: 10, height: 10, fill: color })),
        name, element("span", { class: "tally" }, counted(count))))),
  )];
}
