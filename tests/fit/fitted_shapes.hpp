// SPDX-License-Identifier: Apache-2.0
// Blocks of hexahedra beside the models that they shall be put onto.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "base/vector3.hpp"
#include "fit/hex_carriers.hpp"
#include "fit/hex_lattice.hpp"
#include "measure/hex_faces.hpp"
#include "support/shapes.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain::testing {

struct FittedShape {
  FeatureComplex complex;
  HexMesh mesh;
  HexCarriers carriers;
};

/// The path from one vertex along boundary edges whose ends both are `in` a set, back to it or to the end.
inline std::vector<std::uint32_t> path_through(const HexMesh& mesh, std::uint32_t from, std::uint32_t next,
                                               const std::function<bool(std::uint32_t)>& in) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> beside;
  for (const HexSide& side : boundary_of(mesh))
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t a = side.vertices[k], b = side.vertices[(k + 1) % 4];
      if (in(a) && in(b)) beside[a].push_back(b);
    }
  std::vector<std::uint32_t> path{from, next};
  while (path.back() != from) {
    std::vector<std::uint32_t> ahead = beside[path.back()];
    std::erase(ahead, path[path.size() - 2]);
    if (ahead.empty()) break;
    path.push_back(ahead.front());
  }
  return path;
}

/// A box of these whole-numbered sides with its unit cubes.
inline FittedShape lattice_in_box(const std::array<int, 3>& cells) {
  FittedShape shape;
  const Vector3 sides{static_cast<double>(cells[0]), static_cast<double>(cells[1]),
                      static_cast<double>(cells[2])};
  shape.complex = feature_complex(prepare_surface(translate_mesh(make_box(sides), 0.5 * sides)));
  shape.mesh = lattice_mesh(cells, [](int, int, int) { return 1; });
  const auto vertex_at = [&](const Vector3& p) {
    const auto nearest = std::ranges::min_element(shape.mesh.vertices, {},
                                                  [&](const Vector3& v) { return dot(v - p, v - p); });
    return static_cast<std::uint32_t>(nearest - shape.mesh.vertices.begin());
  };
  std::vector<std::uint32_t> corners;
  for (const auto& corner : shape.complex.corners) corners.push_back(vertex_at(corner.point));
  std::vector<std::vector<std::uint32_t>> paths;
  for (const auto& curve : shape.complex.curves) {
    const Vector3 from = shape.complex.vertices[curve.vertices.front()],
                  to = shape.complex.vertices[curve.vertices.back()];
    const int edges = static_cast<int>(std::lround(curve.length));
    paths.emplace_back();
    for (int k = 0; k <= edges; ++k)
      paths.back().push_back(vertex_at(from + (static_cast<double>(k) / edges) * (to - from)));
  }
  std::vector<HexCarriers::Quad> quads;
  for (const HexSide& side : boundary_of(shape.mesh)) {
    const auto place = [&](std::size_t k) { return shape.mesh.vertices[side.vertices[k]]; };
    const Vector3 normal = normalised(cross(place(2) - place(0), place(3) - place(1)));
    for (std::uint32_t t = 0; t < shape.complex.triangles.size(); ++t)
      if (dot(shape_of(shape.complex.points_of(t)).normal, normal) > 0.9) {
        quads.push_back({side.vertices, shape.complex.face_of[t]});
        break;
      }
  }
  shape.carriers = carriers_on(shape.mesh.vertices.size(), shape.complex, corners, paths, quads);
  return shape;
}

/// A cylinder along z of radius 3 and height 4, and a block of 4 x 4 x 4 cubes inside it with a layer of
/// hexahedra around its sides, whose outer vertices are those of a square.
inline FittedShape block_in_cylinder() {
  constexpr int kSide = 4;
  FittedShape shape;
  shape.complex = feature_complex(prepare_surface(translate_mesh(make_cylinder(3, 2, 96), {0, 0, 2})));
  // Cells beside the corners of a square of 6 x 6 are no part of it: the layer goes around instead.
  HexMesh block = lattice_mesh({kSide, kSide, kSide}, [](int, int, int) { return 1; });
  shape.mesh = block;
  std::map<std::uint32_t, std::uint32_t> outer;
  const auto is_side = [&](const Vector3& p) {
    return p[0] == 0 || p[0] == kSide || p[1] == 0 || p[1] == kSide;
  };
  for (std::uint32_t v = 0; v < block.vertices.size(); ++v) {
    Vector3& p = shape.mesh.vertices[v];
    const bool is_outer = is_side(p);
    p[0] -= 2, p[1] -= 2;
    if (!is_outer) continue;
    outer[v] = static_cast<std::uint32_t>(shape.mesh.vertices.size());
    shape.mesh.vertices.push_back({1.4 * p[0], 1.4 * p[1], p[2]});
  }
  for (const HexSide& side : boundary_of(block)) {
    const auto& [a, b, c, d] = side.vertices;
    const bool is_cap = block.vertices[a][2] == block.vertices[c][2];
    if (is_cap) continue;
    shape.mesh.hexahedra.push_back({a, b, c, d, outer[a], outer[b], outer[c], outer[d]});
    shape.mesh.regions.push_back(1);
  }
  const auto is_on_rim = [&](double z) {
    return [&, z](std::uint32_t v) { return v >= block.vertices.size() && shape.mesh.vertices[v][2] == z; };
  };
  std::vector<std::vector<std::uint32_t>> paths;
  for (const auto& curve : shape.complex.curves) {
    const Vector3 first = shape.complex.vertices[curve.vertices[0]],
                  second = shape.complex.vertices[curve.vertices[1]];
    const auto in = is_on_rim(first[2]);
    std::uint32_t from = 0;
    while (!in(from)) ++from;
    // Around the axis in the direction of the curve.
    const double turn = cross(first, second)[2];
    std::vector<std::uint32_t> path;
    for (std::uint32_t next = 0; next < shape.mesh.vertices.size(); ++next) {
      if (!in(next) || next == from || norm(shape.mesh.vertices[next] - shape.mesh.vertices[from]) > 1.5)
        continue;
      path = path_through(shape.mesh, from, next, in);
      if (cross(shape.mesh.vertices[from], shape.mesh.vertices[next])[2] * turn > 0) break;
    }
    paths.push_back(path);
  }
  std::vector<HexCarriers::Quad> quads;
  for (const HexSide& side : boundary_of(shape.mesh)) {
    const double low = shape.mesh.vertices[side.vertices[0]][2],
                 high = shape.mesh.vertices[side.vertices[2]][2];
    for (std::uint32_t t = 0; t < shape.complex.triangles.size(); ++t) {
      const double along = shape_of(shape.complex.points_of(t)).normal[2];
      const double wanted = low != high ? 0 : low == 0 ? -1 : 1;
      if (std::abs(along - wanted) > 0.5) continue;
      quads.push_back({side.vertices, shape.complex.face_of[t]});
      break;
    }
  }
  shape.carriers = carriers_on(shape.mesh.vertices.size(), shape.complex, {}, paths, quads);
  return shape;
}

}  // namespace crossgrain::testing
