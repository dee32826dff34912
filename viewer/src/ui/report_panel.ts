// SPDX-License-Identifier: Apache-2.0
// The panel with what the report says: the answer first, then numbers, then what there is to look at.

import type { Vector } from "../math/frame.ts";
import type { ModelFace } from "../scene/faces.ts";
import { has_field, is_of_lattice, type Report } from "../scene/report.ts";
import type { Scene } from "../scene/scene.ts";
import { answer_blocks } from "./answer.ts";
import { element } from "./dom.ts";
import { face_table } from "./face_table.ts";
import { levels_chart } from "./levels_chart.ts";
import { failing_list, lacking_list, mesh_card, mesh_numbers } from "./mesh_summary.ts";
import { input_groups, place_lists, type Go } from "./places.ts";
import { about, alignment_scale, fact_list, facts_of_field, is_of_field, key_numbers, tet_alignment, unfinished_card, warnings_list } from "./summary.ts";

/** What the panel may ask of the view. */
export interface PanelView {
  scene: Scene;
  go: Go;
  show_face: (face: number) => void;
}

/** The blocks of the panel. Without a view, before there is one or where there can be none, they have no buttons. */
export function report_blocks(report: Report, faces: ModelFace[], view: PanelView | null): HTMLElement[] {
  const scene = view?.scene ?? null;
  const go = view?.go ?? null;
  const origin: Vector = scene?.origin ?? [0, 0, 0];
  const table = face_table(faces, report, report.model?.unit ?? "", view?.show_face ?? null);
  const answer = answer_blocks(report, report.hexahedra ? null : scene, origin, go);
  const field = [...answer, key_numbers(report), tet_alignment(report), alignment_scale(report)];
  const input = has_field(report) ? place_lists(input_groups(report, origin), origin, go) : [];
  if (!report.hexahedra) return shown([unfinished_card(report), ...field, table, ...input, levels_chart(report), warnings_list(report), about(report)]);
  // What concerns the field alone is no fault of a lattice.
  const aside = is_of_lattice(report) ? warnings_list(report, is_of_field) : null;
  const of_field = has_field(report) ? [folded(name_of_field(report), [map_fault(report), ...field, aside, levels_chart(report), fact_list(facts_of_field(report))])] : [];
  return shown([unfinished_card(report), mesh_card(report, scene, origin, go), ...mesh_numbers(report, scene), ...failing_list(report, scene, origin, go), ...lacking_list(report, origin, go), table,
    warnings_list(report, is_of_lattice(report) ? (warning) => !is_of_field(warning) : undefined), ...input, ...of_field, about(report)]);
}

const shown = (blocks: (HTMLElement | null)[]): HTMLElement[] => blocks.filter((block) => block !== null);

/** Hexahedra of a lattice follow none. */
const name_of_field = (report: Report): string =>
  (!is_of_lattice(report) ? "The field that they follow" : report.hexahedra!.map_fault ? "The field along which maps were tried" : "A field, which they do not follow");

const map_fault = ({ hexahedra }: Report): HTMLElement | null =>
  (hexahedra?.map_fault ? element("p", { class: "words fine", "data-testid": "map-fault" }, `No map was taken, since ${hexahedra.map_fault}: the mesh does not follow this field.`) : null);

function folded(name: string, blocks: (HTMLElement | null)[]): HTMLElement {
  return element("details", { class: "kind block", "data-testid": "field-of-mesh" }, element("summary", {}, name), ...blocks);
}
