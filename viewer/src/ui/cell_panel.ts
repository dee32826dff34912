// SPDX-License-Identifier: Apache-2.0
// What is known of one cell or tet: its place, its frame, and of a cell the form of the surface in it.

import { kClasses } from "../math/color_maps.ts";
import { add, axes_of } from "../math/frame.ts";
import { coefficients_of, type Degree } from "../math/harmonics.ts";
import { eigenvalues, form_value, unpacked } from "../math/symmetric_matrix.ts";
import { cell_box, element_alignment, element_center, element_energy, element_quaternion, element_region, type Scene } from "../scene/scene.ts";
import { coordinates, counted, degrees, drawing, element, measured } from "./dom.ts";
import { HarmonicPlot } from "./harmonic_plot.ts";

/** Everything the panel says, as values; tests and `window.crossgrain` read it too. */
export function describe_element(scene: Scene, element: number, degree: Degree) {
  const frame = element_quaternion(scene, element);
  const is_tet = scene.tets !== null;
  return {
    kind: is_tet ? "tet" : "cell",
    /** Its number among the tets of the mesh, or the cells of the page, from 1. */
    number: element + 1,
    center: add(element_center(scene, element), scene.origin),
    size: is_tet ? null : cell_box(scene, element).side,
    class: is_tet ? null : (kClasses[scene.cell_class[element]]?.name ?? "unknown"),
    region: scene.regions.length > 1 ? scene.regions[element_region(scene, element)] : null,
    axes: axes_of(frame),
    coefficients: coefficients_of(is_tet ? 4 : degree, frame),
    energy_density: element_energy(scene, element),
    alignment_deg: element_alignment(scene, element),
    form: is_tet ? null : form_of(scene, element, degree),
  };
}

/** "Tet 1,234" */
export const title_of = (scene: Scene, element: number): string => `${scene.tets ? "Tet" : "Cell"} ${counted(element + 1)}`;

export type CellDescription = ReturnType<typeof describe_element>;

function form_of(scene: Scene, cell: number, degree: Degree) {
  const place = binary_search(scene.form_cell, cell);
  const size = scene.form_size;
  if (place < 0 || size === 0) return null;
  const entries = (size * (size + 1)) / 2;
  const matrix = unpacked(scene.form_matrix.subarray(place * entries, (place + 1) * entries), size);
  const linear = [...scene.form_linear.subarray(place * size, (place + 1) * size)];
  const constant = scene.form_constant[place];
  const weight = scene.form_weight[place];
  const h = coefficients_of(degree, element_quaternion(scene, cell));
  return {
    matrix, linear, constant, weight,
    eigenvalues: eigenvalues(matrix).map((value) => value / (weight || 1)),
    value: size === h.length ? Math.max(0, form_value(matrix, linear, constant, h)) / (weight || 1) : null,
  };
}

function binary_search(values: Uint32Array, wanted: number): number {
  let low = 0;
  let high = values.length - 1;
  while (low <= high) {
    const middle = (low + high) >> 1;
    if (values[middle] === wanted) return middle;
    if (values[middle] < wanted) low = middle + 1;
    else high = middle - 1;
  }
  return -1;
}

export interface CellPanel {
  plot: HarmonicPlot;
  canvas: HTMLCanvasElement;
}

/** Fills the panel with a cell; the plot is drawn by who knows the camera. */
export function show_cell(panel: HTMLElement, cell: CellDescription, unit: string, actions: { go(): void; close(): void }): CellPanel {
  const canvas = element("canvas", { class: "harmonic", role: "img", "aria-label": "The harmonic of the frame as a surface; its lobes lie along the axes, seen from the camera" });
  const length = unit ? ` ${unit}` : "";
  const facts: [string, string, string][] = [["Centre", coordinates(cell.center), "cell-center"]];
  if (cell.size !== null) facts.push(["Side", `${measured(cell.size)}${length}`, "cell-size"]);
  if (cell.class !== null) facts.push(["Class", `${cell.class} (${kClasses.find(({ name }) => name === cell.class)?.meaning ?? ""})`, "cell-class"]);
  if (cell.region !== null) facts.push(["Region", String(cell.region), "cell-region"]);
  facts.push(["Energy density", `${measured(cell.energy_density)}${unit ? ` ${unit}⁻²` : ""}`, "cell-energy"]);
  facts.push(["Alignment", cell.alignment_deg === null ? (cell.kind === "tet" ? "no face of it on the surface" : "no surface in it") : degrees(cell.alignment_deg), "cell-alignment"]);
  panel.replaceChildren(
    element("div", { class: "cell-head" },
      element("h2", { "data-testid": "cell-title" }, `${cell.kind === "tet" ? "Tet" : "Cell"} ${counted(cell.number)}`),
      element("div", { class: "buttons" },
        element("button", { type: "button", click: actions.go, "data-testid": "cell-go" }, "Show"),
        element("button", { type: "button", click: actions.close, "data-testid": "cell-close" }, "Clear")),
    ),
    element("dl", { class: "facts" }, ...facts.flatMap(([name, value, test]) => [element("dt", {}, name), element("dd", { "data-testid": test }, value)])),
    element("section", { class: "block" },
      element("h2", {}, "Frame"),
      element("div", { class: "frame-row" }, canvas, axes_table(cell)),
      element("h3", {}, cell.coefficients.length === 9 ? "Nine coefficients, degree 4" : "Seven coefficients, degree 3"),
      coefficient_bars(cell.coefficients),
    ),
    cell.kind === "cell" ? form_section(cell) : "",
  );
  return { plot: new HarmonicPlot(cell.coefficients.length === 9 ? 4 : 3, cell.coefficients), canvas };
}

const signed = (value: number): string => (Math.abs(value) < 5e-4 ? "0.000" : value.toFixed(3)).replace("-", "−");

function axes_table({ axes }: CellDescription): HTMLElement {
  return element("table", { class: "axes", "data-testid": "cell-axes" },
    element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "axis"), ...["x", "y", "z"].map((name) => element("th", { scope: "col" }, name)))),
    element("tbody", {}, ...axes.map((axis, k) => element("tr", {}, element("th", { scope: "row" }, "uvw"[k]), ...axis.map((value) => element("td", {}, signed(value)))))),
  );
}

function coefficient_bars(coefficients: number[]): HTMLElement {
  const degree = (coefficients.length - 1) / 2;
  return element("ol", { class: "coefficients", "data-testid": "cell-coefficients" }, ...coefficients.map((value, k) => {
    const order = k - degree;
    const width = 50 * Math.abs(value);
    return element("li", {},
      element("span", { class: "order" }, `m = ${order}`.replace("-", "−")),
      element("span", { class: "bar", "aria-hidden": "true" }, element("span", { class: value < 0 ? "negative" : "positive", style: `width: ${width.toFixed(1)}%; left: ${(value < 0 ? 50 - width : 50).toFixed(1)}%` })),
      element("span", { class: "value" }, signed(value)));
  }));
}

function form_section({ form }: CellDescription): HTMLElement {
  if (!form) {
    return element("section", { class: "block" }, element("h2", {}, "Form"), element("p", { class: "fine" }, "No surface is in this cell, or its form is not in the page."));
  }
  return element("section", { class: "block", "data-testid": "cell-form" },
    element("h2", {}, "Form of the surface in it"),
    element("dl", { class: "facts" },
      element("dt", {}, "Weight"), element("dd", {}, measured(form.weight)),
      ...(form.value === null ? [] : [element("dt", {}, "Of this frame"), element("dd", {}, `${measured(form.value)} per weight`)])),
    element("h3", {}, "Eigenvalues per weight"),
    eigenvalue_chart(form.eigenvalues),
    element("details", {}, element("summary", {}, "Matrix, linear part, constant"), matrix_table(form)),
  );
}

function eigenvalue_chart(values: number[]): SVGElement {
  const width = 308;
  const base = 64;
  const column = width / values.length;
  const largest = Math.max(...values, 1);
  return drawing("svg", { viewBox: `0 0 ${width} 82`, class: "chart", role: "img", "aria-label": `Eigenvalues: ${values.map(signed).join(", ")}`, "data-testid": "cell-eigenvalues" },
    drawing("line", { x1: 0, x2: width, y1: base, y2: base, class: "chart-axis" }),
    ...values.flatMap((value, k) => {
      const height = Math.max(0.75, (Math.max(0, value) / largest) * (base - 8));
      return [
        drawing("rect", { x: k * column + column * 0.2, width: column * 0.6, y: base - height, height, class: "chart-bar" }),
        drawing("text", { x: (k + 0.5) * column, y: base + 13, class: "chart-depth", "text-anchor": "middle" }, Math.abs(value) < 5e-3 ? "0" : value.toFixed(2)),
      ];
    }));
}

function matrix_table(form: NonNullable<CellDescription["form"]>): HTMLElement {
  const largest = Math.max(...form.matrix.flat().map(Math.abs), 1e-30);
  const degree = (form.matrix.length - 1) / 2;
  const short = (value: number): string => (Math.abs(value) < 5e-4 * largest ? "·" : measured(value, 2));
  const cells = (values: number[]): HTMLElement[] =>
    values.map((value) => element("td", { style: `--share: ${(Math.abs(value) / largest).toFixed(3)}` }, short(value)));
  const orders = form.matrix.map((_, k) => String(k - degree).replace("-", "−"));
  return element("div", { class: "matrix-scroll", tabindex: 0, role: "region", "aria-label": "Matrix" },
    element("table", { class: "matrix", "data-testid": "cell-matrix" },
      element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "m"), ...orders.map((order) => element("th", { scope: "col" }, order)))),
      element("tbody", {}, ...form.matrix.map((row, k) => element("tr", {}, element("th", { scope: "row" }, orders[k]), ...cells(row)))),
      element("tbody", { class: "apart" }, element("tr", {}, element("th", { scope: "row" }, "b"), ...cells(form.linear))),
    ),
    element("p", { class: "fine" }, `E(h) = h·Ah − 2 b·h + ${measured(form.constant)}, not divided by the weight`));
}

export function show_no_cell(panel: HTMLElement, of_hexahedra: boolean): void {
  const what = of_hexahedra ? "Click a hexahedron to see its shape, and the face of the model that it is on." : "Click the part or the cut to see a cell or tet: its frame and its numbers.";
  panel.replaceChildren(element("p", { class: "empty", "data-testid": "cell-empty" }, `${what} With keys: Enter takes the one in the middle of the view.`));
}
