// SPDX-License-Identifier: Apache-2.0
// Parts of the field and of the surface that hexahedra cannot have, or of which that is undecided, from the report.

import type { Vector } from "../math/frame.ts";
import { judged_lines, type ArcEntry, type CornerEntry, type CreaseEntry, type NodeEntry, type Report, type VerdictName } from "./report.ts";

export type FaultPart = "line" | "node" | "crease" | "corner";

export interface Fault {
  part: FaultPart;
  /** Its number in its list of the report, from 1. */
  number: number;
  verdict: Exclude<VerdictName, "meshable">;
  /** In the model's coordinates. */
  place: Vector;
  words: string;
}

/** The faults of each kind of part, those that are certain first. */
export function faults_of(report: Report): Fault[] {
  const judged = judged_lines(report);
  const listed = <T extends { verdict: VerdictName; place: Vector }>(part: FaultPart, entries: T[] | undefined, words: (entry: T) => string): Fault[] =>
    (entries ?? [])
      .flatMap((entry, k) => (entry.verdict === "meshable" ? [] : [{ part, number: k + 1, verdict: entry.verdict, place: entry.place, words: words(entry) }]))
      .sort((a, b) => Number(a.verdict === "undecided") - Number(b.verdict === "undecided"));
  return [
    ...listed("line", judged?.arc_list, words_of_arc),
    ...listed("node", judged?.node_list, words_of_node),
    ...listed("crease", judged?.crease_list, words_of_crease),
    ...listed("corner", judged?.corner_list, words_of_corner),
  ];
}

/** Whether the scene has it among its lines and nodes; it has no creases and corners. */
export const is_drawn_anyway = ({ part }: Fault): boolean => part === "line" || part === "node";

/** The report of the grid alone from which a field on tets started. */
export const of_starting_grid = (report: Report): Report => ({ ...report, onto: undefined });

function words_of_arc({ type }: ArcEntry): string {
  if (type === "changing") return "turning point: frames rotate about it in both senses";
  if (type === "no_axis") return "frames rotate about a diagonal, by a third of a turn";
  return "two hexahedra around it would share two faces";
}

function words_of_node({ arcs, verdict, on_boundary }: NodeEntry): string {
  const lines = `${arcs.length} ${arcs.length === 1 ? "line" : "lines"}`;
  if (verdict === "not_meshable") return `no hexahedra meet like its ${lines}`;
  return on_boundary ? `${lines} end so close that they leave no hexahedron if they meet` : `${lines} meet: too many hexahedra to judge`;
}

function words_of_crease({ least_angle_deg, verdict }: CreaseEntry): string {
  const angle = `${least_angle_deg.toPrecision(3)}°`;
  return verdict === "not_meshable" ? `knife edge of ${angle}: room for no hexahedron` : `${angle} of solid: rounding decides whether it has a hexahedron`;
}

function words_of_corner({ creases, verdict }: CornerEntry): string {
  const edges = `${creases.length} ${creases.length === 1 ? "crease" : "creases"}, with ${creases.join(", ")} at their edges`;
  return verdict === "not_meshable" ? `no hexahedra fit around ${edges}` : `${edges}: rounding or the size of the cells decides`;
}
