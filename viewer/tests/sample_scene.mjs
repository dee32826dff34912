// SPDX-License-Identifier: Apache-2.0
// Scenes for the page's tests: a ball, a thin plate with holes, and five components with faults of all kinds. Frames and numbers are
// made up in closed form: like those of a solve, but no solve's.

import { cross, product, unit } from "../src/math/frame.ts";
import { add_forms } from "./plane_forms.mjs";
import { scene_of } from "./scene_writer.mjs";
import { ball, joined, plate, prism, torus } from "./solids.mjs";

/** Leaves of the octree, in Morton order, that hold surface or have their centre inside; finer towards the surface. */
function cells_of(distance, lattice, depth, frame_at, energy_at) {
  const cells = [];
  const visit = (corner, level) => {
    const size = 2 ** level;
    const center = corner.map((value, k) => lattice.low[k] + lattice.unit * (value + size / 2));
    const away = distance(center);
    const reach = 0.87 * size * lattice.unit;
    if (away > reach) return;
    if (level > 0 && away > -1.1 * reach) {
      for (let child = 0; child < 8; ++child) visit(corner.map((value, k) => value + ((child >> k) & 1) * (size / 2)), level - 1);
    } else if (away < 0 || away <= 0.5 * size * lattice.unit) {
      cells.push({ corner, size, frame: frame_at(center), energy: energy_at(center), alignment: 0, class: 0 });
    }
  };
  visit([0, 0, 0], depth);
  return cells;
}

function finder(cells, lattice) {
  const numbers = new Map(cells.map((cell, number) => [`${cell.size}:${cell.corner}`, number]));
  const sizes = [...new Set(cells.map((cell) => cell.size))];
  return (point) => {
    const at = point.map((value, k) => Math.floor((value - lattice.low[k]) / lattice.unit));
    for (const size of sizes) {
      const number = numbers.get(`${size}:${at.map((value) => value - (value % size))}`);
      if (number !== undefined) return number;
    }
    return -1;
  };
}

export const about = (axis, angle) => [Math.cos(angle / 2), ...axis.map((value) => value * Math.sin(angle / 2))];
const smooth = (low, high, value) => {
  const share = Math.min(1, Math.max(0, (value - low) / (high - low)));
  return share * share * (3 - 2 * share);
};

/** The rotation that takes the axis nearest to a direction onto it, by a share of its angle. */
function toward(direction, share) {
  const axis = direction.map(Math.abs).indexOf(Math.max(...direction.map(Math.abs)));
  const nearest = [0, 0, 0];
  nearest[axis] = Math.sign(direction[axis]);
  const across = cross(nearest, direction);
  const angle = Math.acos(Math.min(1, Math.abs(direction[axis])));
  return angle < 1e-9 ? [1, 0, 0, 0] : about(unit(across), share * angle);
}

/** Falls off with the distance from singular lines, over some four decades. */
function energy_near(arcs, width) {
  const points = arcs.flatMap(({ points: all }) => all.filter((_, k) => k % 2 === 0));
  return (at) => {
    let nearest = Infinity;
    for (const point of points) nearest = Math.min(nearest, (point[0] - at[0]) ** 2 + (point[1] - at[1]) ** 2 + (point[2] - at[2]) ** 2);
    return 0.8 / (nearest / width ** 2 + 0.3) ** 1.6 / width ** 2;
  };
}

export const line = (from, to, count, bend = () => [0, 0, 0]) =>
  Array.from({ length: count + 1 }, (_, k) => {
    const share = k / count;
    const away = bend(share);
    return from.map((value, axis) => value + share * (to[axis] - value) + away[axis]);
  });

export function assemble({ solid, lattice, depth, frame_at, arcs, nodes, streamlines, report, singularity = {}, origin = [0, 0, 0], total, merged_to, regions, more }) {
  const at = (point) => point.map((value, k) => value + origin[k]);
  const cells = cells_of(solid.distance, lattice, depth, frame_at, energy_near(arcs, 4 * lattice.unit));
  const surface = { ...solid.surface, origin };
  const forms = add_forms(surface, cells, lattice, finder(cells, lattice));
  const counts = { plane: 0, axis: 0, frame: 0, free: 0, conflicted: 0 };
  for (const cell of cells) if (cell.class > 0) ++counts[["plane", "axis", "frame", "free", "conflicted"][cell.class - 1]];
  const tilts = cells.filter((cell) => cell.class > 0).map((cell) => cell.alignment).sort((a, b) => a - b);
  const verdict_of = ({ verdict = 0 }) => ["meshable", "not_meshable", "undecided"][verdict];
  const full_report = {
    schema: 4,
    verdict: "meshable", answer: "hexahedra fit locally (necessary, not sufficient)", reasons: [],
    degree: 4,
    levels: [5, 4, 3, 2, 1, 0].filter((back) => back < depth).map((back) => ({
      depth: depth - back, cells: 2 * cells.length, active_cells: Math.round(cells.length / 4.4 ** back), sweeps: 16,
      energy: 61.3 * (1 - 0.16 * back), seconds: 0.9 / 3.1 ** back,
    })),
    energy: { smoothness: 58.1, boundary: 3.2, unavoidable: 0, total: 61.3, deviation_max: 1e-12 },
    alignment_deg: { mean: tilts.reduce((a, b) => a + b, 0) / tilts.length, p95: tilts[Math.floor(0.95 * tilts.length)], max: tilts.at(-1), excluded_share: 0.004 },
    spectrum: counts,
    singularity: {
      edges: 480, length: 512, arcs: arcs.length, nodes: nodes.filter(({ on_boundary }) => !on_boundary).length,
      boundary_ends: nodes.filter(({ on_boundary }) => on_boundary).length, unresolved_loops: 0,
      arc_list: arcs.map((arc) => ({ type: ["regular", "changing", "no_axis"][arc.type ?? 0], index: arc.index, verdict: verdict_of(arc), place: at(arc.points[Math.floor(arc.points.length / 2)]) })),
      node_list: nodes.map((node) => ({ verdict: verdict_of(node), place: at(node.point), on_boundary: Boolean(node.on_boundary), arcs: Array.from({ length: node.degree }, (_, k) => k) })),
      crease_list: [], corner_list: [], ...singularity,
    },
    seconds: { read: 0.1, grid: 0.5, solve: 1.1, write: 0.2, total: 2.03 },
    peak_memory_bytes: 148e6,
    version: "0.1.0",
    warnings: [],
    ...report,
  };
  const centers = cells.map(({ corner, size }) => corner.map((value, k) => lattice.low[k] + lattice.unit * (value + size / 2)));
  const parts = regions ? { header: { regions: regions.numbers }, arrays: { cell_region: ["u16", 0, centers.map(regions.of)], ...regions.interfaces } } : {};
  const scene = scene_of({ surface, creases: solid.creases, cells, lattice, arcs, nodes, forms, streamlines, total, merged_to, more: more ?? parts });
  return { report: full_report, scene };
}

export function ball_scene() {
  const radius = 20;
  const solid = ball([0, 0, 0], radius);
  const corners = Array.from({ length: 8 }, (_, k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? 1 : -1)));
  const inner = 0.4 * radius;
  const arcs = [];
  for (const corner of corners) {
    const start = corner.map((value) => value * inner);
    arcs.push({ points: line(start, unit(corner).map((value) => value * radius), 12), index: 0.25 });
    for (let axis = 0; axis < 3; ++axis) {
      if (corner[axis] > 0) continue;
      const end = start.map((value, k) => (k === axis ? -value : value));
      const out = corner.map((value, k) => (k === axis ? 0 : value));
      arcs.push({ points: line(start, end, 24, (share) => out.map((value) => 0.28 * inner * value * Math.sin(Math.PI * share))), index: 0.25 });
    }
  }
  const nodes = corners.flatMap((corner) => [
    { point: corner.map((value) => value * inner), degree: 4 },
    { point: unit(corner).map((value) => value * radius), on_boundary: 1, degree: 1 },
  ]);
  return assemble({
    solid, depth: 5, lattice: { low: [-22.4, -22.4, -22.4], unit: 1.4 }, arcs, nodes, origin: [100, 50, 20],
    frame_at: (p) => toward(unit(p), smooth(0.3 * radius, 0.85 * radius, Math.hypot(...p))),
    report: {
      model: { path: "/parts/ball.stl", triangles: solid.surface.triangles.length, watertight: true, components: 1, unit: "mm" },
      resolution: 28, input: { closed: true, findings: [] },
    },
  });
}

export function plate_scene() {
  const [tile, hole, thickness] = [40, 10, 3];
  const solid = plate(3, 2, tile, hole, thickness);
  const centers = [0, 1, 2].flatMap((column) => [0, 1].map((row) => [(column + 0.5) * tile, (row + 0.5) * tile]));
  const arcs = [];
  const nodes = [];
  const streamlines = [];
  for (const [x, y] of centers) {
    for (const [sx, sy] of [[1, 1], [-1, 1], [-1, -1], [1, -1]]) {
      const [low, high] = [0.02, thickness - 0.02].map((z) => [x + 9.6 * sx, y + 9.6 * sy, z]);
      arcs.push({ points: line(low, high, 4), index: -0.25 });
      nodes.push({ point: low, on_boundary: 1, degree: 1 }, { point: high, on_boundary: 1, degree: 1 });
    }
    for (const radius of [11.2, 12.6, 14.2]) {
      streamlines.push(Array.from({ length: 65 }, (_, k) => [x + radius * Math.cos((Math.PI * k) / 32), y + radius * Math.sin((Math.PI * k) / 32), thickness / 2]));
    }
  }
  const frame_at = ([px, py]) => {
    const x = (((px % tile) + tile) % tile) - tile / 2;
    const y = (((py % tile) + tile) % tile) - tile / 2;
    const polar = Math.atan2(y, x);
    const folded = polar - (Math.PI / 2) * Math.round(polar / (Math.PI / 2));
    return about([0, 0, 1], folded * (1 - smooth(hole, tile / 2, Math.hypot(x, y))));
  };
  return assemble({
    solid, depth: 7, lattice: { low: [-1.5, -1.5, -0.75], unit: 1 }, arcs, nodes, streamlines, frame_at, total: 4_100_000, merged_to: 1,
    report: {
      verdict: "undecided", answer: "undecided, because walls under 93 % of the surface have fewer than 2.5 cells; next: use a resolution of 101",
      reasons: [{ kind: "walls", verdict: "undecided", count: 0, place: [0, 0, 0], text: "walls under 93 % of the surface have fewer than 2.5 cells", next: "use a resolution of 101" }],
      model: { path: "/parts/perforated plate.stl", triangles: solid.surface.triangles.length, watertight: true, components: 1, unit: "mm" },
      resolution: 120, input: { closed: true, findings: [] }, walls: { cells_wanted: 4, thin_share: 0.93, thinnest_cells: 3 },
      warnings: [{ kind: "thin_walls", text: "walls below 4 cells under 93 % of the surface: under-resolved there", remedy: "raise_resolution", advice: "raise the resolution" }],
    },
  });
}

export function components_scene() {
  const solids = [
    ball([0, 0, 0], 9), torus([30, 0, 0], 9, 3.4), prism([60, 0, 0], 8, 10, 48), prism([14, 26, 0], 9, 7, 4), prism([46, 26, 0], 9, 6, 3),
  ];
  const solid = {
    surface: joined(solids.map(({ surface }) => surface)),
    creases: solids.flatMap(({ creases }) => creases),
    distance: (p) => Math.min(...solids.map(({ distance }) => distance(p))),
  };
  const arcs = [];
  const nodes = [];
  for (let k = 0; k < 4; ++k) {
    const [x, y] = [60 + 4 * Math.cos((Math.PI * (k + 0.5)) / 2), 4 * Math.sin((Math.PI * (k + 0.5)) / 2)];
    arcs.push({ points: line([x, y, -10], [x, y, 10], 16), index: 0.25 });
    nodes.push({ point: [x, y, -10], on_boundary: 1, degree: 1 }, { point: [x, y, 10], on_boundary: 1, degree: 1 });
    const turn = (share) => 2 * Math.PI * share;
    const out = (share) => 9 + 1.3 * Math.cos((Math.PI * (k + 0.5)) / 2 + 0 * share);
    arcs.push({
      points: Array.from({ length: 73 }, (_, j) => [30 + out(0) * Math.cos(turn(j / 72)), out(0) * Math.sin(turn(j / 72)), 1.3 * Math.sin((Math.PI * (k + 0.5)) / 2)]),
      index: 0.25,
    });
  }
  arcs.push({ points: line([46, 26, -6], [46, 26, 6], 10), index: 0.25 });
  arcs.push({ points: line([14, 22, -7], [14, 30, 7], 12, (share) => [3 * Math.sin(Math.PI * share), 0, 0]), index: -0.25 });
  arcs.push({ points: line([-4, 0, -7.5], [4, 3, 7.5], 18, (share) => [0, 4 * Math.sin(2 * Math.PI * share), 0]), index: 0, type: 2, verdict: 1 });
  arcs.push({ points: line([2, -7, -2], [-3, 6, 1], 14), index: -0.5 });
  arcs.push({ points: line([10, 22, 3], [18, 30, -3], 14), index: 0.25, type: 1, verdict: 1 });
  const faulty = arcs.find(({ verdict }) => verdict === 1);
  nodes.push({ point: [0, 0, 0], verdict: 1, degree: 3 }, { point: [14, 26, 0], verdict: 2, degree: 2 });
  return assemble({
    solid, depth: 6, lattice: { low: [-12, -12, -12], unit: 1.28 }, arcs, nodes,
    frame_at: (p) => product(toward(unit([p[0] % 30, p[1] % 26, p[2] + 0.01]), 0.4), [1, 0, 0, 0]),
    singularity: {
      crease_list: [
        { hexahedra: 1, least_angle_deg: 90, verdict: "meshable", place: [23, 26, 0] }, { hexahedra: 1, least_angle_deg: 44.3, verdict: "undecided", place: [46, 35, 0] },
        { hexahedra: 0, least_angle_deg: 30, verdict: "not_meshable", place: [46, 26, 6] },
      ],
      corner_list: [{ hexahedra: 0, creases: [1, 1, 1, 1], arcs: [], verdict: "not_meshable", place: [23, 26, 7] }],
    },
    report: {
      verdict: "not_meshable",
      answer: "hexahedra cannot follow this field at 46 26 6: the edge of 30 degrees is too sharp for a hexahedron; 'crossgrain hex' changes the field, and may mesh the part; next: give the edge a fillet or a chamfer",
      reasons: [
        { kind: "knife_edge", verdict: "not_meshable", count: 1, place: [46, 26, 6], text: "the edge of 30 degrees is too sharp for a hexahedron", next: "give the edge a fillet or a chamfer" },
        { kind: "arc", verdict: "not_meshable", count: 2, place: faulty.points[Math.floor(faulty.points.length / 2)], text: "an arc has a turning point: frames rotate about it in both senses", next: "try other cells" },
        { kind: "walls", verdict: "undecided", count: 0, place: [0, 0, 0], text: "walls under 4 % of the surface have fewer than 2.5 cells", next: "use a resolution of 101" },
      ],
      model: { path: "C:\\parts\\five components <v2>.step", triangles: solid.surface.triangles.length, watertight: false, components: 5, unit: "mm" },
      resolution: 63,
      input: {
        closed: true,
        findings: [
          { kind: "holes", count: 2, at_least: false, place: [60, 8, 0], length: 3.25, done: "bridged", done_text: "bridged by the winding number" },
          { kind: "self-intersections", count: 100123, at_least: true, place: [14, 35, 7], length: null, done: "all_inside", done_text: "left as they are: all that they enclose is inside" },
          { kind: "duplicated triangles", count: 1, at_least: false, place: null, length: null, done: "left_out", done_text: "left out" },
        ],
      },
      creases: {
        curves: 20, crowded_corners: 9,
        crowded_corner_places: Array.from({ length: 9 }, (_, k) => [46 + 9 * Math.cos(k), 26 + 9 * Math.sin(k), (k % 2) * 12 - 6]),
      },
      warnings: [
        { kind: "skipped_data", file: "components.vtk", place: "line 12", text: "'LOOKUP' is not known, and data after it are ignored" },
        { kind: "surface_finding", text: "the surface has 2 holes, bridged where they are less than half open" },
      ],
    },
  });
}
