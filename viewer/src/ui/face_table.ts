// SPDX-License-Identifier: Apache-2.0
// The faces of the model: a table that can be sorted, in which a click shows the face, and what is said of the face that is picked.

import { set_of, type ModelFace } from "../scene/faces.ts";
import type { Report } from "../scene/report.ts";
import { counted, element, measured } from "./dom.ts";
import { mesh_file } from "./mesh_summary.ts";

interface Column {
  name: string;
  /** What rows are sorted by. */
  key: (face: ModelFace) => number | string;
  text: (face: ModelFace) => string;
  is_number: boolean;
}

/** The columns that any face has a value for. */
function columns_of(faces: ModelFace[], unit: string): Column[] {
  const square = unit ? ` (${unit}²)` : "";
  const columns: Column[] = [{ name: noun_of(faces[0].kind), key: ({ number }) => number, text: ({ number }) => String(number), is_number: true }];
  if (faces.some(({ kind }) => kind !== null)) columns.push({ name: "Kind", key: ({ kind }) => kind ?? "", text: ({ kind }) => kind ?? "–", is_number: false });
  if (faces.some(({ area }) => area !== null)) columns.push({ name: `Area${square}`, key: ({ area }) => area ?? -1, text: ({ area }) => (area === null ? "–" : measured(area)), is_number: true });
  if (faces.some(({ quads }) => quads !== null)) columns.push({ name: "Quads", key: ({ quads }) => quads ?? -1, text: ({ quads }) => (quads === null ? "–" : counted(quads)), is_number: true });
  return columns;
}

/** The table, folded; null for a model whose faces have no numbers. `show` is null where there is no view. */
export function face_table(faces: ModelFace[], report: Report, unit: string, show: ((face: number) => void) | null): HTMLElement | null {
  if (faces.length === 0) return null;
  const columns = columns_of(faces, unit);
  const body = element("tbody", {});
  const fill = (sorted: ModelFace[]): void => body.replaceChildren(...sorted.map((face) => row_of(face, columns, show)));
  const heads: HTMLElement[] = columns.map((column) => element("th", { scope: "col", "aria-sort": column === columns[0] ? "ascending" : "none", class: column.is_number ? "right" : undefined },
    element("button", { type: "button", "data-testid": `sort-${column.name.split(" ")[0].toLowerCase()}`, click: () => {
      const head = heads[columns.indexOf(column)];
      const ascending = head.getAttribute("aria-sort") !== "ascending";
      for (const other of heads) other.setAttribute("aria-sort", "none");
      head.setAttribute("aria-sort", ascending ? "ascending" : "descending");
      fill([...faces].sort((a, b) => (ascending ? 1 : -1) * compared(column.key(a), column.key(b)) || a.number - b.number));
    } }, column.name)));
  fill(faces);
  const title = `${columns[0].name === "Patch" ? "Patches" : "Faces"} of the model`;
  return element("details", { class: "kind block", "data-testid": "faces" },
    element("summary", {}, title, element("span", { class: "tally" }, ` ${counted(faces.length)}`)),
    element("div", { class: "face-scroll", tabindex: 0, role: "region", "aria-label": title },
      element("table", { class: "face-table" }, element("thead", {}, element("tr", {}, ...heads)), body)),
    sets_text(faces, report) ? element("p", { class: "fine" }, sets_text(faces, report)) : null);
}

/** What faces are called in the files of the mesh, by the first that it has; empty without these files. */
export function sets_text(faces: ModelFace[], report: Report): string {
  const [inp, msh, face] = [mesh_file(report, "inp"), mesh_file(report, "msh"), faces.find(({ quads }) => quads !== null && quads > 0)];
  return inp && msh && face ? `${noun_of(face.kind)} ${face.number} is the set ${set_of(face.number)} of ${inp} and the group “face ${face.number}” of ${msh}.` : "";
}

const compared = (a: number | string, b: number | string): number => (typeof a === "string" || typeof b === "string" ? String(a).localeCompare(String(b)) : a - b);

function row_of(face: ModelFace, columns: Column[], show: ((face: number) => void) | null): HTMLElement {
  const cells = columns.map(({ text, is_number }, k) => {
    // The number is a button for who has no pointer; all of the row is one for who has.
    const content = k === 0 && show ? element("button", { type: "button", "data-testid": "face-row", "aria-label": `Show ${noun_of(face.kind).toLowerCase()} ${face.number}` }, text(face)) : text(face);
    return element(k === 0 ? "th" : "td", { scope: k === 0 ? "row" : undefined, class: is_number ? "right" : undefined }, content);
  });
  return element("tr", { class: face.quads === 0 ? "lacking" : undefined, ...(show ? { click: () => show(face.number) } : {}) }, ...cells);
}

/** Surfaces of triangles have patches between their sharp edges, whose numbers stand in no file of the user. */
export const noun_of = (kind: string | null): "Face" | "Patch" => (kind === "patch" ? "Patch" : "Face");

/** A face in a few words. */
export const face_title = ({ number, kind }: ModelFace): string => `${noun_of(kind)} ${number}${kind && kind !== "patch" ? ` · ${kind}` : ""}`;

/** What is known of the face that is picked. */
export function face_block(face: ModelFace, report: Report, unit: string, actions: { go(): void; close: (() => void) | null }): HTMLElement {
  const file = mesh_file(report, "inp");
  const facts: [string, string, string][] = [
    ["Kind", face.kind ?? "", "face-kind"],
    ["Area", face.area === null ? "" : `${measured(face.area)}${unit ? ` ${unit}²` : ""}`, "face-area"],
    ["Quads", face.quads === null ? "" : face.quads === 0 ? "none: the mesh does not have this face" : counted(face.quads), "face-quads"],
    ["In files", file && face.quads ? `set ${set_of(face.number)} of ${file}` : "", "face-set"],
  ];
  return element("section", { class: "block", "data-testid": "face" },
    element("div", { class: "cell-head" }, element("h2", { "data-testid": "face-title" }, `${noun_of(face.kind)} ${face.number}`),
      element("div", { class: "buttons" },
        element("button", { type: "button", click: actions.go, "data-testid": "face-go" }, "Show"),
        actions.close ? element("button", { type: "button", click: actions.close, "data-testid": "face-close" }, "Clear") : null)),
    element("dl", { class: "facts" }, ...facts.filter(([, text]) => text !== "").flatMap(([name, text, test]) => [element("dt", {}, name), element("dd", { "data-testid": test }, text)])));
}
