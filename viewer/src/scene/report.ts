// SPDX-License-Identifier: Apache-2.0
// The keys of report.json that the page shows; docs/report.md says what each one means. All may be missing: pages of other versions,
// and of fields made by the library, still show what there is. Numbers that are not finite are null.

import type { Vector } from "../math/frame.ts";

export interface Statistics {
  mean: number;
  p95: number;
  max: number;
}

export interface Finding {
  kind: string;
  count: number;
  at_least?: boolean;
  place?: Vector | null;
  length?: number | null;
  done_text?: string;
}

export interface ArcEntry {
  type: string;
  index: number;
  verdict: string;
  length: number;
  place: Vector;
}

export interface NodeEntry {
  verdict: string;
  place: Vector;
  on_boundary?: boolean;
  degree?: number;
}

export interface Warning {
  kind: string;
  file?: string;
  place?: string;
  text: string;
  advice?: string;
}

export interface Report {
  model?: { path?: string; triangles?: number; unit?: string; watertight?: boolean; components?: number };
  degree?: 3 | 4;
  resolution?: number;
  levels?: { depth: number; active_cells: number; energy: number; seconds: number }[];
  energy?: { smoothness: number; boundary: number; total: number };
  alignment_deg?: (Statistics & { excluded_share?: number }) | null;
  spectrum?: Record<string, number>;
  singularity?: {
    arcs: number;
    nodes: number;
    length?: number;
    boundary_ends?: number;
    unresolved_loops?: number;
    meshable: boolean;
    not_meshable_arcs: number;
    not_meshable_nodes: number;
    undecided_nodes: number;
    arc_list?: ArcEntry[];
    node_list?: NodeEntry[];
  };
  seconds?: { total?: number };
  peak_memory_bytes?: number;
  version?: string;
  input?: { closed?: boolean; findings?: Finding[] };
  walls?: { cells_wanted?: number; thin_share?: number; thinnest_cells?: number };
  creases?: {
    knife_edges?: number;
    crowded_corners?: number;
    knife_edge_places?: Vector[];
    crowded_corner_places?: Vector[];
  };
  limited?: { resolution_asked?: number };
  unfinished?: { resolution_asked?: number; levels_missing?: number; tets_missing?: boolean };
  warnings?: Warning[];
}
