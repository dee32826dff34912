// SPDX-License-Identifier: Apache-2.0
// Uniforms that many materials read, as shared objects: set once, seen by all.

import { Vector3, Vector4, type DataTexture, type IUniform } from "three";

import type { Octree } from "../scene/octree.ts";
import type { Scene } from "../scene/scene.ts";
import type { FieldTextures } from "./field_textures.ts";

export interface SharedUniforms {
  [name: string]: IUniform;
  octree: IUniform<DataTexture>;
  cell_values: IUniform<DataTexture>;
  /** Null until a map shows them. */
  corner_values: IUniform<DataTexture | null>;
  palette: IUniform<DataTexture>;
  octree_depth: IUniform<number>;
  lattice_low: IUniform<Vector3>;
  lattice_unit: IUniform<number>;
  map_kind: IUniform<number>;
  base_color: IUniform<Vector3>;
  void_color: IUniform<Vector3>;
  face_color: IUniform<Vector3>;
  cut: IUniform<Vector4>;
  clip: IUniform<boolean>;
  view_height: IUniform<number>;
  pixel_ratio: IUniform<number>;
}

export function shared_uniforms(scene: Scene, octree: Octree, textures: FieldTextures): SharedUniforms {
  return {
    octree: { value: textures.octree },
    cell_values: { value: textures.values },
    corner_values: { value: null },
    palette: { value: textures.palette },
    octree_depth: { value: octree.depth },
    lattice_low: { value: new Vector3(...scene.cells.low) },
    lattice_unit: { value: scene.cells.unit },
    map_kind: { value: 0 },
    base_color: { value: new Vector3() },
    void_color: { value: new Vector3() },
    face_color: { value: new Vector3() },
    cut: { value: new Vector4(0, 0, 1, 0) },
    clip: { value: false },
    view_height: { value: 1 },
    pixel_ratio: { value: 1 },
  };
}
