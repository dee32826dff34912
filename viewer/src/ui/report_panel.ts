// SPDX-License-Identifier: Apache-2.0
// The panel with what the report says: the answer first, then numbers, then what there is to look at.

import type { Vector } from "../math/frame.ts";
import type { ModelFace } from "../scene/faces.ts";
import type { Report } from "../scene/report.ts";
import type { Scene } from "../scene/scene.ts";
import { answer_blocks } from "./answer.ts";
import { element } from "./dom.ts";
import { face_table } from "./face_table.ts";
import { levels_chart } from "./levels_chart.ts";
import { failing_list, mesh_card, mesh_numbers } from "./mesh_summary.ts";
import { input_groups, place_lists, type Go } from "./places.ts";
import { about, alignment_scale, fact_list, facts_of_field, key_numbers, tet_alignment, unfinished_card, warnings_list } from "./summary.ts";

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
  const input = place_lists(input_groups(report, origin), origin, go);
  const blocks = report.hexahedra
    ? [unfinished_card(report), mesh_card(report, scene, origin, go), ...mesh_numbers(report, scene), ...failing_list(report, scene, origin, go), table, warnings_list(report), ...input,
        folded("The field that they follow", [...field, levels_chart(report), fact_list(facts_of_field(report))]), about(report)]
    : [unfinished_card(report), ...field, table, ...input, levels_chart(report), warnings_list(report), about(report)];
  return blocks.filter((block) => block !== null);
}

function folded(name: string, blocks: (HTMLElement | null)[]): HTMLElement {
  return element("details", { class: "kind block", "data-testid": "field-of-mesh" }, element("summary", {}, name), ...blocks);
}
