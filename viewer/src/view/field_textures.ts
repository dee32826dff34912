// SPDX-License-Identifier: Apache-2.0
// The octree and the values of its cells as textures, so that fragment shaders find the cell at any point: exact at every size of cell,
// where a raster of values would have to be as fine as the smallest one everywhere.

import { DataTexture, NearestFilter, LinearFilter, RedIntegerFormat, RGBAFormat, UnsignedByteType, UnsignedIntType } from "three";

import { palette_of, type MapName, type Theme } from "../math/color_maps.ts";
import type { Octree } from "../scene/octree.ts";
import { cell_count, type Scene } from "../scene/scene.ts";
import { corner_values } from "./corner_values.ts";
import type { Ranges } from "./ranges.ts";
import { fraction_of } from "./ranges.ts";

const kRow = 2048; // the width that every WebGL2 device has

export interface FieldTextures {
  octree: DataTexture;
  values: DataTexture;
  palette: DataTexture;
}

export function field_textures(scene: Scene, octree: Octree, ranges: Ranges): FieldTextures {
  const rows = Math.max(1, Math.ceil(octree.entries.length / kRow));
  const entries = new Uint32Array(rows * kRow);
  entries.set(octree.entries);
  const tree = new DataTexture(entries, kRow, rows, RedIntegerFormat, UnsignedIntType);
  tree.internalFormat = "R32UI";
  tree.needsUpdate = true;

  const count = cell_count(scene);
  const value_rows = Math.max(1, Math.ceil(count / kRow));
  const texels = new Uint8Array(value_rows * kRow * 4);
  for (let cell = 0; cell < count; ++cell) {
    texels[4 * cell] = Math.round(255 * fraction_of(ranges.alignment, scene.cell_alignment_deg[cell]));
    texels[4 * cell + 1] = Math.round(255 * fraction_of(ranges.energy, scene.cell_energy_density[cell]));
    texels[4 * cell + 2] = scene.cell_class[cell];
    texels[4 * cell + 3] = scene.cell_region[cell] ?? 0;
  }
  const values = new DataTexture(texels, kRow, value_rows, RGBAFormat, UnsignedByteType);
  values.minFilter = values.magFilter = NearestFilter;
  values.needsUpdate = true;

  const palette = new DataTexture(new Uint8Array(256 * 4), 256, 1, RGBAFormat, UnsignedByteType);
  palette.minFilter = palette.magFilter = LinearFilter;
  return { octree: tree, values, palette };
}

/** The numbers at the corners of cells. They take longer to make than all else, and are needed where a map shows them. */
export function corner_texture(scene: Scene, ranges: Ranges): DataTexture {
  const rows = Math.max(1, Math.ceil((4 * cell_count(scene)) / kRow));
  const texels = new Uint8Array(rows * kRow * 4);
  texels.set(corner_values(scene, ranges));
  const corners = new DataTexture(texels, kRow, rows, RGBAFormat, UnsignedByteType);
  corners.minFilter = corners.magFilter = NearestFilter;
  corners.needsUpdate = true;
  return corners;
}

export function set_palette(textures: FieldTextures, map: MapName, theme: Theme): void {
  (textures.palette.image as { data: Uint8Array }).data.set(palette_of(map, theme));
  textures.palette.needsUpdate = true;
}
