// SPDX-License-Identifier: Apache-2.0
// The keys of report.json that the page shows; docs/report.md says what each one means. All may be missing: pages of other versions,
// and of fields made by the library, still show what there is. Numbers that are not finite are null.

import type { Vector } from "../math/frame.ts";

export interface Statistics {
  mean: number | null;
  p95: number | null;
  max: number | null;
}

export interface Finding {
  kind: string;
  count: number;
  at_least?: boolean;
  place?: Vector | null;
  length?: number | null;
  done_text?: string;
}

export type VerdictName = "meshable" | "not_meshable" | "undecided";

/** Why a field is not meshable or undecided; `place` counts only where `count` is not 0. */
export interface Reason {
  kind: string;
  verdict: VerdictName;
  count: number;
  place: Vector;
  text: string;
  next?: string;
}

export interface ArcEntry {
  type: string;
  index: number;
  verdict: VerdictName;
  place: Vector;
}

export interface NodeEntry {
  verdict: VerdictName;
  place: Vector;
  on_boundary?: boolean;
  arcs: number[];
}

export interface CreaseEntry {
  hexahedra: number;
  least_angle_deg: number;
  verdict: VerdictName;
  place: Vector;
}

export interface CornerEntry {
  creases: number[];
  verdict: VerdictName;
  place: Vector;
}

export interface Singularity {
  arcs: number;
  nodes: number;
  arc_list?: ArcEntry[];
  node_list?: NodeEntry[];
  crease_list?: CreaseEntry[];
  corner_list?: CornerEntry[];
}

export interface Warning {
  kind: string;
  file?: string;
  place?: string;
  text: string;
  remedy?: string;
  advice?: string;
}

interface Kept {
  all: number;
  kept: number;
}

/** Of surfaces, in sizes asked for, and where that is. */
export interface HexDistances {
  largest_in_all: number;
  place_in_all?: Vector;
}

/** What a mesh keeps of its model. */
export interface HexFeatures {
  corners: Kept;
  creases: Kept;
  faces: Kept;
  of_mesh?: HexDistances;
  of_model?: HexDistances;
  lacking?: { kind: string; number?: number; place: Vector; figure: number; share: number }[];
  too_small?: object[];
  small?: number;
}

/** Of hexahedra that were made. */
export interface HexReport {
  outcome: string;
  reason?: string;
  remedy?: string;
  remedy_number?: number;
  next?: string;
  places?: Vector[];
  /** Cells of the grid without a hexahedron, and the first of them. */
  left_out?: number;
  left_out_place?: Vector;
  hexahedra: number;
  /** Number that was expected at the size asked for. */
  expected?: number;
  /** Edge asked for, and taken. */
  size?: number;
  used_size?: number;
  mean_edge?: number;
  scaled_jacobian?: { min: number; mean: number; inverted: number; worst_place?: Vector };
  volume?: number;
  model_volume?: number;
  area?: number;
  model_area?: number;
  /** What they are measured against: `cad`, `surface` or `tets`. */
  model?: string;
  largest_distance?: number;
  largest_distance_place?: Vector;
  largest_distance_of_model?: number;
  largest_distance_of_model_place?: Vector;
  /** Ctrl-C ended the search: the best mesh by then. */
  is_stopped?: boolean;
  /** Which attempt made it. */
  way?: string;
  /** Why no map was taken, where it is of a lattice and maps were tried. */
  map_fault?: string;
  attempts?: { kind: string }[];
  best_attempt?: number;
  features?: HexFeatures;
}

/** A face of the model. */
export interface FaceEntry {
  /** As in the files, from 1. */
  number: number;
  kind?: string;
  area?: number;
  centre?: Vector;
  /** Of a mesh of hexahedra. */
  quads?: number;
}

export interface Report {
  verdict?: VerdictName;
  answer?: string;
  reasons?: Reason[];
  model?: { path?: string; triangles?: number; unit?: string; watertight?: boolean; components?: number };
  degree?: 3 | 4;
  resolution?: number;
  levels?: { depth: number; active_cells: number; energy: number; seconds: number }[];
  energy?: { smoothness: number; boundary: number; total: number };
  alignment_deg?: (Statistics & { excluded_share?: number }) | null;
  spectrum?: Record<string, number>;
  singularity?: Singularity;
  seconds?: { total?: number };
  peak_memory_bytes?: number;
  version?: string;
  input?: { closed?: boolean; findings?: Finding[] };
  walls?: { cells_wanted?: number; thin_share?: number; thinnest_cells?: number };
  creases?: { crowded_corner_places?: Vector[] };
  limited?: { resolution_asked?: number };
  unfinished?: { resolution_asked?: number; levels_missing?: number; tets_missing?: boolean };
  onto?: { tets: number; singularity?: Singularity; normal_deg?: Statistics; crease_deg?: Statistics; unfollowed_share?: number };
  hexahedra?: HexReport;
  faces?: FaceEntry[];
  files?: { name: string }[];
  warnings?: Warning[];
}

/** Whether the mesh is of a lattice, which follows no field. */
export const is_of_lattice = ({ hexahedra }: Report): boolean => hexahedra?.attempts?.[hexahedra.best_attempt ?? 0]?.kind === "lattice";

/** Whether there is a field: of hexahedra that are given, or of a lattice alone, there is none. */
export const has_field = ({ hexahedra, levels }: Report): boolean => !hexahedra || levels?.length !== 0;

/** The singular lines that the answer is about: those on the tets, if there are tets. */
export const judged_lines = (report: Report): Singularity | undefined => report.onto?.singularity ?? report.singularity;
