// SPDX-License-Identifier: Apache-2.0
#include "lattice/holes.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Of the area of faces that go all around something, this share looks to one side at most.
constexpr double kMostOneSided = 0.05;

struct Wall {
  Vector3 towards{0, 0, 0};  ///< area times normals
  double area = 0;
  std::vector<Vector3> points;
};

}  // namespace

std::vector<std::vector<Vector3>> holes_of(const FeatureComplex& features) {
  DisjointSets smooth(features.faces.size());
  for (const FeatureComplex::Curve& curve : features.curves)
    if (curve.is_soft)
      for (const FeatureComplex::Side& side : curve.sides) smooth.join(side.face, curve.sides.front().face);
  std::vector<Wall> walls(features.faces.size());
  for (std::size_t t = 0; t < features.triangles.size(); ++t) {
    Wall& wall = walls[smooth.root(features.face_of[t])];
    const auto corners = features.points_of(t);
    const Vector3 twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
    wall.towards += 0.5 * twice;
    wall.area += 0.5 * norm(twice);
    wall.points.insert(wall.points.end(), corners.begin(), corners.end());
  }
  std::vector<std::vector<Vector3>> holes;
  for (Wall& wall : walls)
    if (wall.area > 0 && norm(wall.towards) <= kMostOneSided * wall.area)
      holes.push_back(std::move(wall.points));
  return holes;
}

std::vector<std::vector<Vector3>> soft_lines_of(const FeatureComplex& features) {
  std::vector<std::vector<Vector3>> lines;
  for (const FeatureComplex::Curve& curve : features.curves) {
    if (!curve.is_soft) continue;
    std::vector<Vector3>& line = lines.emplace_back();
    for (const std::uint32_t v : curve.vertices) line.push_back(features.vertices[v]);
  }
  return lines;
}

}  // namespace crossgrain
