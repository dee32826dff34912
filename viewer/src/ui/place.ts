// SPDX-License-Identifier: Apache-2.0
// A place worth a look.

import type { Vector } from "../math/frame.ts";

export interface Place {
  label: string;
  detail: string;
  /** In the scene's coordinates; null where the report names none. */
  point: Vector | null;
  warn: boolean;
  /** The hexahedron that is there: its place in the scene. */
  hexahedron?: number;
  /** Whether it is one of the mesh of hexahedra. */
  of_mesh?: boolean;
}
