// SPDX-License-Identifier: Apache-2.0
// Which cell is under the pointer: on the face of the cut, or on the surface.

import { Raycaster, Vector2, type Mesh, type PerspectiveCamera, Mesh as MeshClass, type BufferGeometry, DoubleSide, MeshBasicMaterial } from "three";

import type { Vector } from "../math/frame.ts";
import { dot } from "../math/frame.ts";
import { cell_at, surface_cell_at, type Octree } from "../scene/octree.ts";
import type { Scene } from "../scene/scene.ts";
import { cut_normal, cut_offset, type Settings } from "../settings.ts";

export class Picker {
  private readonly raycaster = new Raycaster();
  private readonly mesh: Mesh;

  constructor(private readonly scene: Scene, private readonly octree: Octree, surface: BufferGeometry) {
    this.mesh = new MeshClass(surface, new MeshBasicMaterial({ side: DoubleSide }));
  }

  /** The cell at a place of the view, both coordinates -1 ... 1 and y up; -1 where there is none. */
  pick(x: number, y: number, camera: PerspectiveCamera, settings: Settings): number {
    this.raycaster.setFromCamera(new Vector2(x, y), camera);
    const origin = this.raycaster.ray.origin.toArray() as Vector;
    const direction = this.raycaster.ray.direction.toArray() as Vector;
    const normal = cut_normal(settings);
    const offset = cut_offset(settings, this.scene.low, this.scene.high);
    const clipped = settings.cut.on && settings.cut.clip;

    let best = { cell: -1, distance: Infinity };
    if (settings.cut.on) {
      const distance = (offset - dot(normal, origin)) / dot(normal, direction);
      if (distance > 0 && Number.isFinite(distance)) {
        const at = origin.map((value, k) => value + distance * direction[k] - 1e-3 * this.scene.cells.unit * normal[k]) as Vector;
        const cell = cell_at(this.scene, this.octree, at);
        if (cell >= 0) best = { cell, distance };
      }
    }
    if (settings.layers.part && settings.opacity > 0) {
      for (const hit of this.raycaster.intersectObject(this.mesh)) {
        if (hit.distance >= best.distance) break;
        const point = hit.point.toArray() as Vector;
        if (clipped && dot(normal, point) > offset) continue;
        const outward = hit.face ? (hit.face.normal.toArray() as Vector) : ([0, 0, 0] as Vector);
        const cell = surface_cell_at(this.scene, this.octree, point, outward);
        if (cell < 0) continue;
        best = { cell, distance: hit.distance };
        break;
      }
    }
    return best.cell;
  }
}
