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
  Vector3 sum{0, 0, 0};  ///< area times centroids
  double flux = 0;       ///< of places through it: area times normals times centroids
  std::vector<Vector3> points;

  bool looks_outward() const { return flux > dot(towards, (1 / area) * sum); }
};

}  // namespace

std::vector<Hole> holes_of(const FeatureComplex& features) {
  DisjointSets smooth(features.faces.size());
  for (const FeatureComplex::Curve& curve : features.curves)
    if (curve.is_soft)
      for (const FeatureComplex::Side& side : curve.sides) smooth.join(side.face, curve.sides.front().face);
  std::vector<Wall> walls(features.faces.size());
  for (std::size_t t = 0; t < features.triangles.size(); ++t) {
    Wall& wall = walls[smooth.root(features.face_of[t])];
    const auto corners = features.points_of(t);
    const Vector3 twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const Vector3 centroid = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    wall.towards += 0.5 * twice;
    wall.area += 0.5 * norm(twice);
    wall.sum += 0.5 * norm(twice) * centroid;
    wall.flux += 0.5 * dot(twice, centroid);
    wall.points.insert(wall.points.end(), corners.begin(), corners.end());
  }
  std::vector<Hole> holes;
  for (Wall& wall : walls)
    if (wall.area > 0 && norm(wall.towards) <= kMostOneSided * wall.area)
      holes.push_back({std::move(wall.points), wall.looks_outward()});
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
