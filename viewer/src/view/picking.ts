// SPDX-License-Identifier: Apache-2.0
// Which tet or cell is under the pointer, on the face of the cut or on the surface, and on which face of the model.

import { Raycaster, Vector2, type Mesh, type PerspectiveCamera, Mesh as MeshClass, type BufferGeometry, DoubleSide, MeshBasicMaterial } from "three";

import type { Vector } from "../math/frame.ts";
import { dot, scaled, subtract } from "../math/frame.ts";
import { face_of_triangle } from "../scene/faces.ts";
import { cell_at, surface_cell_at, type Octree } from "../scene/octree.ts";
import { element_size, type Scene } from "../scene/scene.ts";
import { tet_at } from "../scene/tet_finder.ts";
import type { Settings } from "../settings.ts";
import type { Cut } from "./cut.ts";

// Below the surface by this share of a tet, to be inside the one that has the face.
const kBelow = 0.02;

/** What is under a place of the view. */
export interface Hit {
  /** A tet, a cell, or of a view of hexahedra one of these; -1 where there is none. */
  element: number;
  /** The face of the model, if it is on its surface and has a number, and the point that was hit. */
  face: Settings["face"];
}

export const kNothingHit: Hit = { element: -1, face: null };

/** The face of a number, which is 0 without one. */
export const face_at = (number: number, point: Vector): Settings["face"] => (number === 0 ? null : { number, point });

export class Picker {
  private readonly raycaster = new Raycaster();
  private readonly mesh: Mesh;

  constructor(private readonly scene: Scene, private readonly octree: Octree, surface: BufferGeometry, private readonly cut: Cut) {
    this.mesh = new MeshClass(surface, new MeshBasicMaterial({ side: DoubleSide }));
  }

  /** At a place of the view, both coordinates -1 ... 1 and y up. */
  pick(x: number, y: number, camera: PerspectiveCamera, settings: Settings): Hit {
    this.raycaster.setFromCamera(new Vector2(x, y), camera);
    const origin = this.raycaster.ray.origin.toArray() as Vector;
    const direction = this.raycaster.ray.direction.toArray() as Vector;
    const { normal, offset } = this.cut;
    const clipped = settings.cut.on && settings.cut.clip;

    let best: Hit & { distance: number } = { ...kNothingHit, distance: Infinity };
    if (settings.cut.on) {
      const distance = (offset - dot(normal, origin)) / dot(normal, direction);
      if (distance > 0 && Number.isFinite(distance)) {
        const element = this.on_cut(origin.map((value, k) => value + distance * direction[k]) as Vector);
        if (element >= 0) best = { element, face: null, distance };
      }
    }
    if (settings.layers.part && settings.opacity > 0) {
      for (const hit of this.raycaster.intersectObject(this.mesh)) {
        if (hit.distance >= best.distance) break;
        const point = hit.point.toArray() as Vector;
        if (clipped && dot(normal, point) > offset) continue;
        const outward = hit.face ? (hit.face.normal.toArray() as Vector) : ([0, 0, 0] as Vector);
        if (!this.scene.has_field) {
          // What is seen from inside lies behind the face of the cut.
          if (dot(direction, outward) < 0) best = { element: -1, face: face_at(face_of_triangle(this.scene, hit.faceIndex ?? -1), point), distance: hit.distance };
          break;
        }
        const element = this.on_surface(point, outward);
        if (element < 0) continue;
        best = { element, face: face_at(face_of_triangle(this.scene, hit.faceIndex ?? -1), point), distance: hit.distance };
        break;
      }
    }
    return { element: best.element, face: best.face };
  }

  private on_cut(point: Vector): number {
    const { scene, cut } = this;
    if (!scene.tets) return cell_at(scene, this.octree, subtract(point, scaled(cut.normal, 1e-3 * scene.cells.unit)));
    const piece = cut.map.piece_at(...cut.map.flat_of(point));
    return piece < 0 ? -1 : cut.pieces.element[piece];
  }

  private on_surface(point: Vector, outward: Vector): number {
    const { scene } = this;
    if (!scene.tets) return surface_cell_at(scene, this.octree, point, outward);
    return tet_at(scene.tets, subtract(point, scaled(outward, kBelow * element_size(scene))));
  }
}
