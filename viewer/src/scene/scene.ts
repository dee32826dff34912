// SPDX-License-Identifier: Apache-2.0
// The binary scene that a page carries, decoded into typed arrays. Its layout is described in viewer/README.md.

import type { Vector } from "../math/frame.ts";

export interface SceneArray<T> {
  values: T;
  rows: number;
  columns: number;
}

export interface Scene {
  origin: Vector;
  unit: string;
  low: Vector;
  high: Vector;
  cells: { low: Vector; unit: number; total: number; shown: number; merged_to: number | null };
  surface: { triangles_total: number; triangles_shown: number };
  surface_vertices: Float32Array;
  surface_triangles: Uint32Array;
  crease_points: Float32Array;
  crease_starts: Uint32Array;
  arc_points: Float32Array;
  arc_starts: Uint32Array;
  arc_index: Float32Array;
  arc_type: Uint8Array;
  arc_verdict: Uint8Array;
  node_points: Float32Array;
  node_verdict: Uint8Array;
  node_on_boundary: Uint8Array;
  node_degree: Uint8Array;
  cell_corner: Uint16Array;
  cell_size: Uint16Array;
  cell_frame: Int16Array;
  cell_energy_density: Float32Array;
  cell_alignment_deg: Float32Array;
  cell_class: Uint8Array;
  form_cell: Uint32Array;
  form_size: number;
  form_matrix: Float32Array;
  form_linear: Float32Array;
  form_constant: Float32Array;
  form_weight: Float32Array;
  streamline_points: Float32Array;
  streamline_starts: Uint32Array;
}

const kMagic = "CGSCENE1";
const kTypes = { f32: Float32Array, u32: Uint32Array, u16: Uint16Array, i16: Int16Array, u8: Uint8Array };
type TypeName = keyof typeof kTypes;

interface Header {
  schema: number;
  origin: Vector;
  unit: string;
  low: Vector;
  high: Vector;
  cells: Scene["cells"];
  surface: Scene["surface"];
  arrays: Record<string, { type: TypeName; offset: number; shape: number[] }>;
}

/** Reads a scene; the typed arrays are views of `bytes` where their place allows it. */
export function decode_scene(bytes: Uint8Array<ArrayBuffer>): Scene {
  if (new TextDecoder().decode(bytes.subarray(0, 8)) !== kMagic) throw new Error("the scene does not begin with " + kMagic);
  const header_length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(8, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(12, 12 + header_length))) as Header;
  if (header.schema !== 1) throw new Error(`the scene has schema ${header.schema}, this page reads 1`);
  const start = 12 + header_length;

  const read = <T>(name: string, type: TypeName): T => {
    const entry = header.arrays[name];
    if (!entry || entry.shape[0] === 0) return new kTypes[type](0) as T;
    if (entry.type !== type) throw new Error(`array ${name} is ${entry.type}, not ${type}`);
    const length = entry.shape.reduce((a, b) => a * b, 1);
    const begin = bytes.byteOffset + start + entry.offset;
    const size = kTypes[type].BYTES_PER_ELEMENT;
    if (start + entry.offset + length * size > bytes.byteLength) throw new Error(`array ${name} ends beyond the scene`);
    if (begin % size === 0) return new kTypes[type](bytes.buffer, begin, length) as T;
    return new kTypes[type](bytes.slice(start + entry.offset, start + entry.offset + length * size).buffer) as T;
  };

  const form_shape = header.arrays["form_linear"]?.shape;
  return {
    origin: header.origin,
    unit: header.unit,
    low: header.low,
    high: header.high,
    cells: header.cells,
    surface: header.surface,
    surface_vertices: read("surface_vertices", "f32"),
    surface_triangles: read("surface_triangles", "u32"),
    crease_points: read("crease_points", "f32"),
    crease_starts: read("crease_starts", "u32"),
    arc_points: read("arc_points", "f32"),
    arc_starts: read("arc_starts", "u32"),
    arc_index: read("arc_index", "f32"),
    arc_type: read("arc_type", "u8"),
    arc_verdict: read("arc_verdict", "u8"),
    node_points: read("node_points", "f32"),
    node_verdict: read("node_verdict", "u8"),
    node_on_boundary: read("node_on_boundary", "u8"),
    node_degree: read("node_degree", "u8"),
    cell_corner: read("cell_corner", "u16"),
    cell_size: read("cell_size", "u16"),
    cell_frame: read("cell_frame", "i16"),
    cell_energy_density: widened(read("cell_energy_density", "u16")),
    cell_alignment_deg: widened(read("cell_alignment_deg", "u16")),
    cell_class: read("cell_class", "u8"),
    form_cell: read("form_cell", "u32"),
    form_size: form_shape && form_shape.length > 1 ? form_shape[1] : 0,
    form_matrix: read("form_matrix", "f32"),
    form_linear: read("form_linear", "f32"),
    form_constant: read("form_constant", "f32"),
    form_weight: read("form_weight", "f32"),
    streamline_points: read("streamline_points", "f32"),
    streamline_starts: read("streamline_starts", "u32"),
  };
}

/** Single precision from its upper sixteen bits. */
function widened(upper: Uint16Array): Float32Array {
  const bits = new Uint32Array(upper.length);
  for (let k = 0; k < upper.length; ++k) bits[k] = upper[k] << 16;
  return new Float32Array(bits.buffer);
}

export function cell_count(scene: Scene): number {
  return scene.cell_size.length;
}

/** The frame of a cell as a unit quaternion. */
export function cell_quaternion(scene: Scene, cell: number): [number, number, number, number] {
  const q = scene.cell_frame.subarray(4 * cell, 4 * cell + 4);
  const length = Math.hypot(q[0], q[1], q[2], q[3]) || 1;
  return [q[0] / length, q[1] / length, q[2] / length, q[3] / length];
}

/** Low corner and side of a cell, in the scene's coordinates. */
export function cell_box(scene: Scene, cell: number): { low: Vector; side: number } {
  const { low, unit } = scene.cells;
  const corner = scene.cell_corner;
  return {
    low: [low[0] + unit * corner[3 * cell], low[1] + unit * corner[3 * cell + 1], low[2] + unit * corner[3 * cell + 2]],
    side: unit * scene.cell_size[cell],
  };
}

export function cell_center(scene: Scene, cell: number): Vector {
  const { low, side } = cell_box(scene, cell);
  return [low[0] + side / 2, low[1] + side / 2, low[2] + side / 2];
}
