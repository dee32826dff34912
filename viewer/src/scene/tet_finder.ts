// SPDX-License-Identifier: Apache-2.0
// Which tet is at a point: one pass over all of them, a few milliseconds for a click.

import type { Vector } from "../math/frame.ts";
import type { Tets } from "./scene.ts";

/** The tet that holds a point, or the one that it is least far outside of in barycentric coordinates, up to `slack`; -1 if none. */
export function tet_at({ points, corners }: Tets, [x, y, z]: Vector, slack = 0.1): number {
  let best = -1;
  let most = -slack;
  for (let at = 0; at < corners.length; at += 4) {
    const o = 3 * corners[at], p = 3 * corners[at + 1], q = 3 * corners[at + 2], r = 3 * corners[at + 3];
    const [dx, dy, dz] = [x - points[o], y - points[o + 1], z - points[o + 2]];
    const ax = points[p] - points[o], ay = points[p + 1] - points[o + 1], az = points[p + 2] - points[o + 2];
    const bx = points[q] - points[o], by = points[q + 1] - points[o + 1], bz = points[q + 2] - points[o + 2];
    const cx = points[r] - points[o], cy = points[r + 1] - points[o + 1], cz = points[r + 2] - points[o + 2];
    const volume = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    const u = (dx * (by * cz - bz * cy) + dy * (bz * cx - bx * cz) + dz * (bx * cy - by * cx)) / volume;
    const v = (ax * (dy * cz - dz * cy) + ay * (dz * cx - dx * cz) + az * (dx * cy - dy * cx)) / volume;
    const w = (ax * (by * dz - bz * dy) + ay * (bz * dx - bx * dz) + az * (bx * dy - by * dx)) / volume;
    const inside = Math.min(u, v, w, 1 - u - v - w);
    if (inside > most) [best, most] = [at / 4, inside];
  }
  return best;
}
