// SPDX-License-Identifier: Apache-2.0
// The binary scene that a page carries, decoded into typed arrays. Its layout is described in viewer/README.md.

import type { Quaternion, Vector } from "../math/frame.ts";
import type { Hexahedra } from "./hexahedra.ts";

/** A field on tets, as the cut needs it. */
export interface Tets {
  points: Float32Array;
  corners: Uint32Array;
  frame: Int16Array;
  energy_density: Float32Array;
  /** Negative for tets without surface. */
  alignment_deg: Float32Array;
  region: Uint16Array;
}

/** What is drawn of a field besides its frames: on tets, or on the grid from which they started. */
interface Outside {
  surface: { triangles_total: number; triangles_shown: number };
  surface_vertices: Float32Array;
  surface_triangles: Uint32Array;
  /** Faces between regions. */
  interface_vertices: Float32Array;
  interface_triangles: Uint32Array;
  arc_points: Float32Array;
  arc_starts: Uint32Array;
  /** Of the part around each point of the lines; infinite where nothing limits them. */
  arc_wall: Float32Array;
  arc_index: Float32Array;
  arc_type: Uint8Array;
  arc_verdict: Uint8Array;
  node_verdict: Uint8Array;
  node_on_boundary: Uint8Array;
  node_degree: Uint8Array;
  mark_points: Float32Array;
  mark_directions: Float32Array;
  mark_shape: Uint8Array;
  mark_verdict: Uint8Array;
  mark_wall: Float32Array;
}

export interface Scene extends Outside {
  origin: Vector;
  unit: string;
  low: Vector;
  high: Vector;
  /** The axis of the cut that the page begins with. */
  first_cut: "x" | "y" | "z" | null;
  /** Whether there is a field: of hexahedra without one, what concerns fields is empty. */
  has_field: boolean;
  cells: { low: Vector; unit: number; total: number; shown: number; merged_to: number | null };
  /** Of a field on tets: how many there are, and how many of them are here; none if cells stand for them. */
  tet_counts: { total: number; shown: number } | null;
  tets: Tets | null;
  hexahedra: Hexahedra | null;
  /** The grid from which the field on tets started. */
  grid: Scene | null;
  /** At the vertices of the surface; empty where cells give the colours. */
  surface_alignment_deg: Float32Array;
  surface_energy_density: Float32Array;
  /** Of the triangles of the surface; empty with a single one. */
  surface_region: Uint16Array;
  /** Numbers of the faces of the model that the triangles of the surface lie on, 0 for none; empty where no face has a number. */
  surface_face: Int32Array;
  crease_points: Float32Array;
  crease_starts: Uint32Array;
  cell_corner: Uint16Array;
  cell_size: Uint16Array;
  cell_frame: Int16Array;
  cell_energy_density: Float32Array;
  cell_alignment_deg: Float32Array;
  cell_class: Uint8Array;
  cell_region: Uint16Array;
  /** Cells with numbers at their eight corners. */
  corner_cell: Uint32Array;
  corner_alignment_deg: Float32Array;
  corner_energy_density: Float32Array;
  /** The numbers of regions, of which cell_region and tets.region are indices. */
  regions: number[];
  form_cell: Uint32Array;
  form_size: number;
  form_matrix: Float32Array;
  form_linear: Float32Array;
  form_constant: Float32Array;
  form_weight: Float32Array;
  streamline_points: Float32Array;
  streamline_starts: Uint32Array;
  streamline_axis: Uint8Array;
  streamline_set: Uint8Array;
}

const kMagic = "CGSCENE1";
const kTypes = { f32: Float32Array, u32: Uint32Array, u16: Uint16Array, i16: Int16Array, u8: Uint8Array };
type TypeName = keyof typeof kTypes;
type Read = <T>(name: string, type: TypeName) => T;

interface Header {
  schema: number;
  origin: Vector;
  unit: string;
  low: Vector;
  high: Vector;
  first_cut?: "x" | "y" | "z";
  cells?: Scene["cells"];
  tets?: { total: number; shown: number };
  hexahedra?: { total: number; shown: number; inverted: number; mean: number };
  regions?: number[];
  tet_regions?: number[];
  hex_regions?: number[];
  surface: Scene["surface"];
  grid_surface?: Scene["surface"];
  arrays: Record<string, { type: TypeName; offset: number; shape: number[] }>;
}

/** Reads a scene; the typed arrays are views of `bytes` where their place allows it. */
export function decode_scene(bytes: Uint8Array<ArrayBuffer>): Scene {
  if (new TextDecoder().decode(bytes.subarray(0, 8)) !== kMagic) throw new Error("the scene does not begin with " + kMagic);
  const header_length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(8, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(12, 12 + header_length))) as Header;
  if (header.schema !== 2) throw new Error(`the scene has schema ${header.schema}, this page reads 2`);
  const start = 12 + header_length;

  const read: Read = <T>(name: string, type: TypeName): T => {
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
  const scene: Scene = {
    origin: header.origin,
    unit: header.unit,
    low: header.low,
    high: header.high,
    first_cut: header.first_cut ?? null,
    has_field: header.cells !== undefined,
    cells: header.cells ?? { low: header.low, unit: Math.max(...header.high.map((high, k) => high - header.low[k])), total: 0, shown: 0, merged_to: null },
    tet_counts: header.tets ?? null,
    tets: null,
    hexahedra: header.hexahedra ? hexahedra_of(read, header.hexahedra, header) : null,
    grid: null,
    ...outside(read, "", header.surface),
    surface_alignment_deg: widened(read("surface_alignment_deg", "u16")),
    surface_energy_density: widened(read("surface_energy_density", "u16")),
    surface_region: read("surface_region", "u16"),
    surface_face: signed(read("surface_face", "u32")),
    crease_points: read("crease_points", "f32"),
    crease_starts: read("crease_starts", "u32"),
    cell_corner: read("cell_corner", "u16"),
    cell_size: read("cell_size", "u16"),
    cell_frame: read("cell_frame", "i16"),
    cell_energy_density: widened(read("cell_energy_density", "u16")),
    cell_alignment_deg: widened(read("cell_alignment_deg", "u16")),
    cell_class: read("cell_class", "u8"),
    cell_region: read("cell_region", "u16"),
    corner_cell: read("corner_cell", "u32"),
    corner_alignment_deg: widened(read("corner_alignment_deg", "u16")),
    corner_energy_density: widened(read("corner_energy_density", "u16")),
    regions: header.regions ?? [],
    form_cell: read("form_cell", "u32"),
    form_size: form_shape && form_shape.length > 1 ? form_shape[1] : 0,
    form_matrix: read("form_matrix", "f32"),
    form_linear: read("form_linear", "f32"),
    form_constant: read("form_constant", "f32"),
    form_weight: read("form_weight", "f32"),
    streamline_points: read("streamline_points", "f32"),
    streamline_starts: read("streamline_starts", "u32"),
    streamline_axis: read("streamline_axis", "u8"),
    streamline_set: read("streamline_set", "u8"),
  };
  return header.arrays["tet_corners"] ? with_tets(scene, read, header) : scene;
}

function outside(read: Read, prefix: string, surface: Outside["surface"]): Outside {
  return {
    surface,
    surface_vertices: read(`${prefix}surface_vertices`, "f32"),
    surface_triangles: read(`${prefix}surface_triangles`, "u32"),
    interface_vertices: read(`${prefix}interface_vertices`, "f32"),
    interface_triangles: read(`${prefix}interface_triangles`, "u32"),
    arc_points: read(`${prefix}arc_points`, "f32"),
    arc_starts: read(`${prefix}arc_starts`, "u32"),
    arc_wall: read(`${prefix}arc_wall`, "f32"),
    arc_index: read(`${prefix}arc_index`, "f32"),
    arc_type: read(`${prefix}arc_type`, "u8"),
    arc_verdict: read(`${prefix}arc_verdict`, "u8"),
    node_verdict: read(`${prefix}node_verdict`, "u8"),
    node_on_boundary: read(`${prefix}node_on_boundary`, "u8"),
    node_degree: read(`${prefix}node_degree`, "u8"),
    mark_points: read(`${prefix}mark_points`, "f32"),
    mark_directions: read(`${prefix}mark_directions`, "f32"),
    mark_shape: read(`${prefix}mark_shape`, "u8"),
    mark_verdict: read(`${prefix}mark_verdict`, "u8"),
    mark_wall: read(`${prefix}mark_wall`, "f32"),
  };
}

/** The scene of tets, with that of the grid from which they started beside it. */
function with_tets(scene: Scene, read: Read, header: Header): Scene {
  const none = new Float32Array(0);
  const grid: Scene = {
    ...scene, ...outside(read, "grid_", header.grid_surface ?? { triangles_total: 0, triangles_shown: 0 }),
    tet_counts: null, hexahedra: null, surface_alignment_deg: none, surface_energy_density: none, surface_region: new Uint16Array(0),
    surface_face: new Int32Array(0),
  };
  const tets: Tets = {
    points: read("tet_points", "f32"),
    corners: read("tet_corners", "u32"),
    frame: read("tet_frame", "i16"),
    energy_density: widened(read("tet_energy_density", "u16")),
    alignment_deg: widened(read("tet_alignment_deg", "u16")),
    region: read("tet_region", "u16"),
  };
  return { ...scene, tets, grid, regions: header.tet_regions ?? [] };
}

function hexahedra_of(read: Read, { total, inverted, mean }: NonNullable<Header["hexahedra"]>, { hex_regions }: Header): Hexahedra {
  return {
    total, inverted, mean,
    points: read("hex_points", "f32"),
    corners: read("hex_corners", "u32"),
    shape: read("hex_shape", "f32"),
    is_inverted: read("hex_inverted", "u8"),
    number: read("hex_number", "u32"),
    face: signed(read("hex_face", "u32")),
    regions: hex_regions ?? [],
    region: read("hex_region", "u16"),
  };
}

/** Numbers below zero are written as two's complement. */
const signed = (numbers: Uint32Array): Int32Array => new Int32Array(numbers.buffer, numbers.byteOffset, numbers.length);

/** Single precision from its upper sixteen bits. */
function widened(upper: Uint16Array): Float32Array {
  const bits = new Uint32Array(upper.length);
  for (let k = 0; k < upper.length; ++k) bits[k] = upper[k] << 16;
  return new Float32Array(bits.buffer);
}

export function cell_count(scene: Scene): number {
  return scene.cell_size.length;
}

/** Tets, or cells where there are none: what has a frame and can be picked. */
export const element_count = (scene: Scene): number => (scene.tets ? scene.tets.corners.length / 4 : cell_count(scene));

/** The frame of a tet or cell as a unit quaternion. */
export function element_quaternion({ tets, cell_frame }: Scene, element: number): Quaternion {
  const q = tets ? tets.frame : cell_frame;
  const [w, x, y, z] = [q[4 * element], q[4 * element + 1], q[4 * element + 2], q[4 * element + 3]];
  const length = Math.hypot(w, x, y, z) || 1;
  return [w / length, x / length, y / length, z / length];
}

export const element_energy = ({ tets, cell_energy_density }: Scene, element: number): number =>
  (tets ? tets.energy_density : cell_energy_density)[element];

export const element_region = ({ tets, cell_region }: Scene, element: number): number => (tets ? tets.region : cell_region)[element] ?? 0;

/** Mean angle between surface and nearest axis; null without surface. */
export function element_alignment({ tets, cell_class, cell_alignment_deg }: Scene, element: number): number | null {
  if (tets) return tets.alignment_deg[element] >= 0 ? tets.alignment_deg[element] : null;
  return cell_class[element] > 0 ? cell_alignment_deg[element] : null;
}

/** The corners of a tet, in the scene's coordinates. */
export function tet_corners(tets: Tets, tet: number): Vector[] {
  return [0, 1, 2, 3].map((k) => {
    const at = 3 * tets.corners[4 * tet + k];
    return [tets.points[at], tets.points[at + 1], tets.points[at + 2]] as Vector;
  });
}

export function element_center(scene: Scene, element: number): Vector {
  if (!scene.tets) return cell_center(scene, element);
  const corners = tet_corners(scene.tets, element);
  return [0, 1, 2].map((k) => corners.reduce((sum, corner) => sum + corner[k] / 4, 0)) as Vector;
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

/** A length that is small beside what has frames: the lattice of cells, or an edge of tets. */
export function element_size({ tets, cells, low, high }: Scene): number {
  if (!tets) return cells.unit;
  const volume = low.reduce((product, value, k) => product * Math.max(high[k] - value, 1e-9), 1);
  return Math.cbrt(volume / Math.max(1, tets.corners.length / 4));
}
