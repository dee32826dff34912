// SPDX-License-Identifier: Apache-2.0
// Parts of the field and of the surface that hexahedra cannot have, or of which that is undecided, from the report, and the reasons that
// are about them.

import type { Vector } from "../math/frame.ts";
import { judged_lines, type ArcEntry, type CornerEntry, type CreaseEntry, type NodeEntry, type Reason, type Report, type VerdictName } from "./report.ts";

export type FaultPart = "line" | "node" | "end" | "crease" | "corner";

export interface Fault {
  part: FaultPart;
  /** Its number in its list of the report, from 1. */
  number: number;
  verdict: Exclude<VerdictName, "meshable">;
  /** In the model's coordinates. */
  place: Vector;
  /** What tells it from others of its kind, in a few words. */
  words: string;
}

/** The faults of each kind of part, those that are certain first. */
export function faults_of(report: Report): Fault[] {
  const judged = judged_lines(report);
  const listed = <T extends { verdict: VerdictName; place: Vector }>(part: (entry: T) => FaultPart, entries: T[] | undefined, words: (entry: T) => string): Fault[] =>
    (entries ?? [])
      .flatMap((entry, k) => (entry.verdict === "meshable" ? [] : [{ part: part(entry), number: k + 1, verdict: entry.verdict, place: entry.place, words: words(entry) }]))
      .sort((a, b) => Number(a.verdict === "undecided") - Number(b.verdict === "undecided"));
  return [
    ...listed(() => "line", judged?.arc_list, words_of_arc),
    ...listed(({ on_boundary, verdict }) => (on_boundary && verdict === "undecided" ? "end" : "node"), judged?.node_list, words_of_node),
    ...listed(() => "crease", judged?.crease_list, words_of_crease),
    ...listed(() => "corner", judged?.corner_list, words_of_corner),
  ];
}

/** The part that each kind of reason is about; others are about none. */
const kParts: Record<string, FaultPart> = { knife_edge: "crease", corner: "corner", arc: "line", node: "node", ends: "end" };

/** The reasons, each with its faults, and the faults that no reason is about. A reason names the place of one of its faults. */
export function reasons_with_faults(report: Report): { reasons: { reason: Reason; faults: Fault[] }[]; others: Fault[] } {
  let others = faults_of(report);
  const reasons = (report.reasons ?? []).map((reason) => {
    const named = others.find(({ part, place }) => part === kParts[reason.kind] && place.every((value, k) => value === reason.place[k]));
    const faults = others.filter(({ part, verdict }) => named && part === named.part && verdict === named.verdict);
    others = others.filter((fault) => !faults.includes(fault));
    return { reason, faults };
  });
  return { reasons, others };
}

/** Whether the scene has it among its lines and nodes; it has no creases and corners. */
export const is_drawn_anyway = ({ part }: Fault): boolean => part === "line" || part === "node" || part === "end";

/** The report of the grid alone from which a field on tets started. */
export const of_starting_grid = (report: Report): Report => ({ ...report, onto: undefined });

function words_of_arc({ type }: ArcEntry): string {
  if (type === "changing") return "turning point";
  return type === "no_axis" ? "turn about a diagonal" : "two hexahedra around it";
}

const words_of_node = ({ arcs }: NodeEntry): string => `${arcs.length} ${arcs.length === 1 ? "line" : "lines"}`;
const words_of_crease = ({ least_angle_deg }: CreaseEntry): string => `${least_angle_deg.toPrecision(3)}°`;

function words_of_corner({ creases }: CornerEntry): string {
  if (creases.length === 0) return "lines end at it";
  if (creases.length === 1) return `its crease takes ${creases[0]} ${creases[0] === 1 ? "hexahedron" : "hexahedra"}`;
  return `its creases take ${creases.slice(0, -1).join(", ")} and ${creases[creases.length - 1]} hexahedra`;
}
