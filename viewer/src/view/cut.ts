// SPDX-License-Identifier: Apache-2.0
// Everything about the plane that the part is cut by, worked out once for each place of it: pieces, outline, and names of axes.

import { subtract, length_of, type Quaternion, type Vector } from "../math/frame.ts";
import { kAllNames, name_axes, seams_of, type AxisNames, type FrameLink } from "../scene/axis_names.ts";
import { CutMap } from "../scene/cut_map.ts";
import { cut_cells, cut_outline, cut_tets, type CutPieces } from "../scene/cut_pieces.ts";
import type { Octree } from "../scene/octree.ts";
import { element_quaternion, type Scene } from "../scene/scene.ts";

export interface NamedFrames {
  /** Of each piece. */
  names: AxisNames[];
  /** Segments across which names differ, six coordinates each. */
  seams: Float32Array;
}

export class Cut {
  private key = "";
  private kept_pieces: CutPieces | null = null;
  private kept_outline: Float32Array | null = null;
  private kept_interfaces: Float32Array | null = null;
  private kept_map: CutMap | null = null;
  private kept_names: NamedFrames | null = null;
  normal: Vector = [0, 0, 1];
  offset = 0;

  constructor(private readonly scene: Scene, private readonly octree: Octree, private readonly closed: boolean) {}

  place(normal: Vector, offset: number): void {
    const key = `${normal} ${offset}`;
    if (key === this.key) return;
    this.key = key;
    this.normal = normal;
    this.offset = offset;
    this.kept_pieces = this.kept_outline = this.kept_interfaces = this.kept_map = this.kept_names = null;
  }

  get pieces(): CutPieces {
    const { tets } = this.scene;
    return (this.kept_pieces ??= tets ? cut_tets(tets, this.normal, this.offset) : cut_cells(this.scene, this.octree, this.normal, this.offset));
  }

  /** Of the surface. */
  get outline(): Float32Array {
    return (this.kept_outline ??= cut_outline(this.scene.surface_vertices, this.scene.surface_triangles, this.normal, this.offset));
  }

  /** Of the faces between regions. */
  get interfaces(): Float32Array {
    return (this.kept_interfaces ??= cut_outline(this.scene.interface_vertices, this.scene.interface_triangles, this.normal, this.offset));
  }

  /** The outline where the surface is closed; elsewhere pieces alone say what is inside. */
  get limits(): Float32Array | null {
    return this.closed ? this.outline : null;
  }

  get map(): CutMap {
    return (this.kept_map ??= new CutMap(this.pieces, this.limits, this.normal));
  }

  get named(): NamedFrames {
    if (this.kept_names) return this.kept_names;
    const { pieces } = this;
    const frames: Quaternion[] = Array.from(pieces.element, (element) => element_quaternion(this.scene, element));
    const middles = middles_of(pieces);
    const links: FrameLink[] = [];
    for (let k = 0; k < pieces.side_pieces.length; k += 2) {
      const [a, b] = [pieces.side_pieces[k], pieces.side_pieces[k + 1]];
      const ends = pieces.side_ends.subarray(3 * k, 3 * k + 6);
      links.push({ a, b, distance: length_of(subtract(middles[a], middles[b])), width: Math.hypot(ends[3] - ends[0], ends[4] - ends[1], ends[5] - ends[2]) });
    }
    const names = name_axes(frames, links, nearest_to_middle(middles));
    const seams = seams_of(names, frames, links).flatMap((side) => [...pieces.side_ends.subarray(6 * side, 6 * side + 6)]);
    return (this.kept_names = { names: Array.from(names, (name) => kAllNames[name]), seams: Float32Array.from(seams) });
  }
}

function middles_of({ count, starts, corners }: CutPieces): Vector[] {
  return Array.from({ length: count }, (_, piece) => {
    const middle: Vector = [0, 0, 0];
    const size = starts[piece + 1] - starts[piece];
    for (let k = starts[piece]; k < starts[piece + 1]; ++k) for (let axis = 0; axis < 3; ++axis) middle[axis] += corners[3 * k + axis] / size;
    return middle;
  });
}

/** The piece nearest to the mean of all: names begin there. */
function nearest_to_middle(middles: Vector[]): number {
  const mean: Vector = [0, 0, 0];
  for (const middle of middles) for (let axis = 0; axis < 3; ++axis) mean[axis] += middle[axis] / middles.length;
  let best = 0;
  let least = Infinity;
  middles.forEach((middle, piece) => {
    const distance = length_of(subtract(middle, mean));
    if (distance < least) [best, least] = [piece, distance];
  });
  return best;
}
