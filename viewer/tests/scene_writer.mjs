// SPDX-License-Identifier: Apache-2.0
// Writes scenes as viewer/README.md describes them, and puts them into the page. The program does this in C++; tests do it here.

import { gzipSync } from "node:zlib";

const kTypes = { f32: Float32Array, u32: Uint32Array, u16: Uint16Array, i16: Int16Array, u8: Uint8Array };

/** The upper half of a float32, rounded to nearest. */
export function upper_half(value) {
  const bits = new Uint32Array(new Float32Array([value]).buffer)[0];
  return (bits + 0x8000) >>> 16;
}

/** Bytes of a scene. `arrays` is {name: [type, columns or 0, flat values]}; columns 0 stands for shape [n]. */
export function encode_scene(header, arrays) {
  const entries = {};
  const blocks = [];
  let offset = 0;
  for (const [name, [type, columns, values]] of Object.entries(arrays)) {
    const typed = kTypes[type].from(values);
    entries[name] = { type, offset, shape: columns ? [typed.length / columns, columns] : [typed.length] };
    blocks.push([offset, new Uint8Array(typed.buffer)]);
    offset = Math.ceil((offset + typed.byteLength) / 8) * 8;
  }
  let text = JSON.stringify({ schema: 2, ...header, arrays: entries });
  while ((12 + Buffer.byteLength(text)) % 8 !== 0) text += " ";
  const start = 12 + Buffer.byteLength(text);
  const bytes = new Uint8Array(start + offset);
  bytes.set(new TextEncoder().encode("CGSCENE1"));
  new DataView(bytes.buffer).setUint32(8, start - 12, true);
  bytes.set(new TextEncoder().encode(text), 12);
  for (const [at, block] of blocks) bytes.set(block, start + at);
  return bytes;
}

/** The page with a report and a scene in place of its placeholders. */
export function filled_page(page, report, scene) {
  const json = JSON.stringify(report).replaceAll("<", "\\u003c");
  return page
    .replace("/*REPORT*/", () => json)
    .replace("/*SCENE*/", () => (scene ? gzipSync(scene, { level: 6 }).toString("base64") : ""));
}

/** {header, arrays} from what a test made: cells [{corner, size, frame, energy, alignment, class}], triangles, arcs, nodes, forms. */
export function scene_of({ surface, creases, cells, lattice, arcs, nodes, forms, streamlines, unit = "mm", merged_to = null, total, more }) {
  const low = [0, 1, 2].map((k) => surface.vertices.reduce((best, point) => Math.min(best, point[k]), Infinity));
  const high = [0, 1, 2].map((k) => surface.vertices.reduce((best, point) => Math.max(best, point[k]), -Infinity));
  const polylines = (lines) => {
    const starts = [0];
    for (const line of lines) starts.push(starts.at(-1) + line.length);
    return { points: lines.flat(2), starts };
  };
  const crease = polylines(creases);
  const arc = polylines(arcs.map((one) => one.points));
  const stream = polylines(streamlines ?? []);
  // A node where lines meet is a ball, an end on the surface a disc; lines that turn their sense do so in the middle.
  const marks = [
    ...nodes.map((one) => ({ ...one, shape: one.on_boundary ? 1 : 0 })),
    ...arcs.filter((one) => one.type === 1).map((one) => ({ point: one.points[Math.floor(one.points.length / 2)], shape: 2 })),
  ];
  const size = forms.length > 0 ? forms[0].linear.length : 9;
  const flat_cells = (take) => cells.flatMap(take);
  const header = {
    origin: surface.origin ?? [0, 0, 0],
    unit,
    low,
    high,
    cells: { low: lattice.low, unit: lattice.unit, total: total ?? cells.length, shown: cells.length, merged_to },
    surface: { triangles_total: surface.triangles.length, triangles_shown: surface.triangles.length },
  };
  const arrays = {
    surface_vertices: ["f32", 3, surface.vertices.flat()],
    surface_triangles: ["u32", 3, surface.triangles.flat()],
    crease_points: ["f32", 3, crease.points],
    crease_starts: ["u32", 0, crease.starts],
    arc_points: ["f32", 3, arc.points],
    arc_starts: ["u32", 0, arc.starts],
    arc_index: ["f32", 0, arcs.map((one) => one.index)],
    arc_type: ["u8", 0, arcs.map((one) => one.type ?? 0)],
    arc_verdict: ["u8", 0, arcs.map((one) => one.verdict ?? 0)],
    arc_wall: ["f32", 0, arcs.flatMap((one) => one.points.map(() => one.wall ?? Infinity))],
    node_verdict: ["u8", 0, nodes.map((one) => one.verdict ?? 0)],
    node_on_boundary: ["u8", 0, nodes.map((one) => one.on_boundary ?? 0)],
    node_degree: ["u8", 0, nodes.map((one) => one.degree ?? 0)],
    mark_points: ["f32", 3, marks.flatMap((one) => one.point)],
    mark_directions: ["f32", 3, marks.flatMap(() => [0, 0, 1])],
    mark_shape: ["u8", 0, marks.map((one) => one.shape)],
    mark_verdict: ["u8", 0, marks.map((one) => one.verdict ?? 0)],
    mark_wall: ["f32", 0, marks.map(() => Infinity)],
    cell_corner: ["u16", 3, flat_cells((cell) => cell.corner)],
    cell_size: ["u16", 0, flat_cells((cell) => cell.size)],
    cell_frame: ["i16", 4, flat_cells((cell) => cell.frame.map((q) => Math.round(q * 32767)))],
    cell_energy_density: ["u16", 0, flat_cells((cell) => upper_half(cell.energy))],
    cell_alignment_deg: ["u16", 0, flat_cells((cell) => upper_half(cell.alignment))],
    cell_class: ["u8", 0, flat_cells((cell) => cell.class)],
    form_cell: ["u32", 0, forms.map((form) => form.cell)],
    form_matrix: ["f32", (size * (size + 1)) / 2, forms.flatMap((form) => form.matrix)],
    form_linear: ["f32", size, forms.flatMap((form) => form.linear)],
    form_constant: ["f32", 0, forms.map((form) => form.constant)],
    form_weight: ["f32", 0, forms.map((form) => form.weight)],
    streamline_points: ["f32", 3, stream.points],
    streamline_starts: ["u32", 0, stream.starts],
    streamline_axis: ["u8", 0, (streamlines ?? []).map((_, k) => k % 3)],
    streamline_set: ["u8", 0, (streamlines ?? []).map((_, k) => k % 2)],
  };
  return encode_scene({ ...header, ...more?.header }, { ...arrays, ...more?.arrays });
}
