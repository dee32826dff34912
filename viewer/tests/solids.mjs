// SPDX-License-Identifier: Apache-2.0
// Solids of the test scenes: triangles with matching vertices, a distance that is negative inside, and creases.

const kTurn = 2 * Math.PI;

/** A closed surface over a raster: `at(i, j)` for i = 0 ... rows, j = 0 ... columns - 1, columns going round. Poles may be points. */
function raster(rows, columns, at, round = false) {
  const vertices = [];
  const triangles = [];
  for (let i = 0; i < (round ? rows : rows + 1); ++i) for (let j = 0; j < columns; ++j) vertices.push(at(i, j));
  for (let i = 0; i < rows; ++i) {
    for (let j = 0; j < columns; ++j) {
      const below = ((i + 1) % (round ? rows : rows + 1)) * columns;
      const a = i * columns + j;
      const b = i * columns + ((j + 1) % columns);
      triangles.push([a, below + j, b], [b, below + j, below + ((j + 1) % columns)]);
    }
  }
  return joined([{ vertices, triangles }]);
}

/** One surface of several; equal points become one vertex, and triangles without area go. */
export function joined(surfaces) {
  const numbers = new Map();
  const vertices = [];
  const triangles = [];
  for (const surface of surfaces) {
    const renamed = surface.vertices.map((point) => {
      const key = point.map((value) => Math.round(value * 1e6)).join();
      if (!numbers.has(key)) numbers.set(key, vertices.push(point) - 1);
      return numbers.get(key);
    });
    for (const triangle of surface.triangles) {
      const corners = triangle.map((corner) => renamed[corner]);
      if (new Set(corners).size === 3) triangles.push(corners);
    }
  }
  return { vertices, triangles };
}

const shifted = (point, center) => point.map((value, k) => value + center[k]);
const ring = (radius, height, count, center) =>
  Array.from({ length: count + 1 }, (_, j) => shifted([radius * Math.cos((kTurn * j) / count), radius * Math.sin((kTurn * j) / count), height], center));

export function ball(center, radius) {
  const surface = raster(32, 64, (i, j) => {
    const polar = (Math.PI * i) / 32;
    const around = (kTurn * j) / 64;
    return shifted([radius * Math.sin(polar) * Math.cos(around), radius * Math.sin(polar) * Math.sin(around), radius * Math.cos(polar)], center);
  });
  return { surface, creases: [], distance: (p) => Math.hypot(p[0] - center[0], p[1] - center[1], p[2] - center[2]) - radius };
}

export function torus(center, ring_radius, radius) {
  const surface = raster(64, 24, (i, j) => {
    const around = (kTurn * i) / 64;
    const section = (kTurn * j) / 24;
    const out = ring_radius + radius * Math.cos(section);
    return shifted([out * Math.cos(around), out * Math.sin(around), -radius * Math.sin(section)], center);
  }, true);
  const distance = (p) => Math.hypot(Math.hypot(p[0] - center[0], p[1] - center[1]) - ring_radius, p[2] - center[2]) - radius;
  return { surface, creases: [], distance };
}

/** A prism on a regular polygon; many sides make a cylinder, whose upright edges are no creases. */
export function prism(center, radius, half_height, sides) {
  const heights = [half_height, half_height, -half_height, -half_height];
  const surface = raster(3, sides, (i, j) => {
    const out = i === 0 || i === 3 ? 0 : radius;
    return shifted([out * Math.cos((kTurn * j) / sides), out * Math.sin((kTurn * j) / sides), heights[i]], center);
  });
  const creases = [ring(radius, half_height, sides, center), ring(radius, -half_height, sides, center)];
  if (sides < 9) for (let j = 0; j < sides; ++j) creases.push([creases[0][j], creases[1][j]]);
  const apothem = radius * Math.cos(Math.PI / sides);
  const distance = (p) => {
    const [x, y, z] = p.map((value, k) => value - center[k]);
    const sector = kTurn / sides;
    const angle = Math.atan2(y, x) - sector / 2;
    const to_middle = angle - sector * Math.round(angle / sector);
    return Math.max(Math.hypot(x, y) * Math.cos(to_middle) - apothem, Math.abs(z) - half_height);
  };
  return { surface, creases, distance };
}

/** A square bar along z, with its sides along the axes. */
export function bar(half, half_height) {
  const solid = prism([0, 0, 0], half * Math.SQRT2, half_height, 4);
  // The prism's corners lie on the axes: turned by an eighth its sides do.
  const turned = ([x, y, z]) => [(x - y) * Math.SQRT1_2, (x + y) * Math.SQRT1_2, z];
  return {
    surface: { vertices: solid.surface.vertices.map(turned), triangles: solid.surface.triangles }, creases: solid.creases.map((crease) => crease.map(turned)),
    distance: ([x, y, z]) => Math.max(Math.abs(x) - half, Math.abs(y) - half, Math.abs(z) - half_height),
  };
}

/** A plate of square tiles, each with a round hole through it. */
export function plate(columns, rows, tile, hole, thickness) {
  const count = 48;
  const pieces = [];
  const creases = [];
  for (let column = 0; column < columns; ++column) {
    for (let row = 0; row < rows; ++row) {
      const center = [(column + 0.5) * tile, (row + 0.5) * tile, 0];
      const edge = (j) => {
        const angle = (kTurn * (j + 0.5)) / count;
        const scale = tile / 2 / Math.max(Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle)));
        return [scale * Math.cos(angle), scale * Math.sin(angle)];
      };
      const circle = (j) => [hole * Math.cos((kTurn * (j + 0.5)) / count), hole * Math.sin((kTurn * (j + 0.5)) / count)];
      const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([x, y]) => [(x * tile) / 2, (y * tile) / 2]);
      for (let j = 0; j < count; ++j) {
        const at = ([x, y], z) => shifted([x, y, z], center);
        const quad = (a, b, c, d) => ({ vertices: [a, b, c, d], triangles: [[0, 1, 2], [0, 2, 3]] });
        pieces.push(quad(at(circle(j), thickness), at(edge(j), thickness), at(edge(j + 1), thickness), at(circle(j + 1), thickness)));
        pieces.push(quad(at(circle(j), 0), at(circle(j + 1), 0), at(edge(j + 1), 0), at(edge(j), 0)));
        pieces.push(quad(at(circle(j), 0), at(circle(j), thickness), at(circle(j + 1), thickness), at(circle(j + 1), 0)));
        // No point lies on a tile's corner: the one quad beside it gets a triangle more.
        const crossed = (j + 1) % (count / 4) === count / 8 ? corners[Math.floor((j + 1) / (count / 4))] : null;
        const border = crossed ? [edge(j), crossed, edge(j + 1)] : [edge(j), edge(j + 1)];
        if (crossed) {
          pieces.push({ vertices: [at(edge(j), thickness), at(crossed, thickness), at(edge(j + 1), thickness)], triangles: [[0, 1, 2]] });
          pieces.push({ vertices: [at(edge(j), 0), at(edge(j + 1), 0), at(crossed, 0)], triangles: [[0, 1, 2]] });
        }
        for (let k = 0; k + 1 < border.length; ++k) {
          const [first, second] = [border[k], border[k + 1]];
          const middle = [(first[0] + second[0]) / 2 + center[0], (first[1] + second[1]) / 2 + center[1]];
          const outer = Math.min(middle[0], middle[1], columns * tile - middle[0], rows * tile - middle[1]) < 1e-6;
          if (outer) pieces.push(quad(at(first, 0), at(second, 0), at(second, thickness), at(first, thickness)));
        }
      }
      creases.push(ring(hole, 0, count, center), ring(hole, thickness, count, center));
    }
  }
  const [width, depth] = [columns * tile, rows * tile];
  for (const z of [0, thickness]) creases.push([[0, 0, z], [width, 0, z], [width, depth, z], [0, depth, z], [0, 0, z]]);
  for (const [x, y] of [[0, 0], [width, 0], [width, depth], [0, depth]]) creases.push([[x, y, 0], [x, y, thickness]]);
  const distance = (p) => {
    const box = Math.max(-p[0], p[0] - width, -p[1], p[1] - depth, -p[2], p[2] - thickness);
    const x = p[0] - (Math.min(columns - 1, Math.max(0, Math.floor(p[0] / tile))) + 0.5) * tile;
    const y = p[1] - (Math.min(rows - 1, Math.max(0, Math.floor(p[1] / tile))) + 0.5) * tile;
    return Math.max(box, hole - Math.hypot(x, y));
  };
  return { surface: joined(pieces), creases, distance };
}
