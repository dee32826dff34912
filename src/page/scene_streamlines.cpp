// SPDX-License-Identifier: Apache-2.0
#include "page/scene_streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/streamlines.hpp"
#include "field/field_data.hpp"
#include "grid/leaf_finder.hpp"
#include "page/scene_parts.hpp"

namespace crossgrain {
namespace {

/// Number of seeds of each set, with three lines each: a few lines across any part, not so many that they
/// hide each other.
constexpr std::size_t kSeeds = 16;

/// Number of places on the cut that are tried, most of which may lie outside of a thin or hollow part.
constexpr std::size_t kMostTried = 4000;

/// Largest length of a line in each direction, in longest sides: lines may wind around a part many times and
/// hide it.
constexpr double kSides = 1;

/// Largest number of points of a streamline: tracing takes one point per cell.
constexpr std::size_t kMostPoints = 200;

/// Depth of seeds below the surface, in cells: on it, rounding decides whether they are inside.
constexpr double kDepth = 0.25;

/// Lines from the surface run along it if they leave their seeds at more than 45 degrees to its normal.
constexpr double kAlong = 0.7071;

/// Terms of Roberts' sequence R2, the plane's most evenly spread one: 1/g and 1/g^2 with g^3 = g + 1.
constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;

double share_of(double step, std::size_t k) {
  const double place = 0.5 + step * static_cast<double>(k);
  return place - std::floor(place);
}

struct Seeds {
  std::vector<Vector3> points;
  std::vector<Vector3> normals;  ///< of the surface there; empty for those on the cut
};

Seeds seeds_on_cut(const FrameField& field, const Box& box, std::size_t axis) {
  Seeds seeds;
  const Octree& tree = field.data().tree;
  const LeafFinder finder(tree);
  for (std::size_t k = 1; k <= kMostTried && seeds.points.size() < kSeeds; ++k) {
    Vector3 point = 0.5 * (box.low + box.high);
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    point[a] = box.low[a] + share_of(kFirst, k) * (box.high[a] - box.low[a]);
    point[b] = box.low[b] + share_of(kSecond, k) * (box.high[b] - box.low[b]);
    const auto cell = tree.root().locate(point);
    if (cell && finder.containing(*cell) != kNoCell) seeds.points.push_back(point);
  }
  return seeds;
}

TriangleMesh mesh_of(const DrawnSurface& surface, const Vector3& origin) {
  TriangleMesh mesh;
  for (std::size_t k = 0; k < surface.positions.size(); k += 3)
    mesh.vertices.push_back(
        origin + Vector3{surface.positions[k], surface.positions[k + 1], surface.positions[k + 2]});
  for (std::size_t k = 0; k < surface.vertices.size(); k += 3)
    mesh.triangles.push_back({surface.vertices[k], surface.vertices[k + 1], surface.vertices[k + 2]});
  return mesh;
}

/// Evenly spread over the area, a little below the surface.
Seeds seeds_on_surface(const TriangleMesh& mesh, double depth) {
  Seeds seeds;
  std::vector<double> areas;
  double sum = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector3& o = mesh.vertices[i];
    areas.push_back(sum += 0.5 * norm(cross(mesh.vertices[j] - o, mesh.vertices[k] - o)));
  }
  for (std::size_t n = 1; n <= kSeeds && sum > 0; ++n) {
    const auto found = std::upper_bound(areas.begin(), areas.end(), share_of(kFirst, n) * sum);
    const auto& [i, j, k] =
        mesh.triangles[std::min(static_cast<std::size_t>(found - areas.begin()), areas.size() - 1)];
    const Vector3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    const Vector3 normal = normalised(cross(b - a, c - a));
    seeds.points.push_back((1.0 / 3) * (a + b + c) - depth * normal);
    seeds.normals.push_back(normal);
  }
  return seeds;
}

/// A tracer whose lines end on the simplified surface, which is faster to search, or with the cells if no
/// surface is known or it lies elsewhere than the field.
StreamlineTracer tracer_of(const FrameField& field, const TriangleMesh& mesh) {
  StreamlineOptions options;
  options.longest_sides = kSides;
  if (!mesh.triangles.empty()) {
    try {
      return StreamlineTracer(field, options, &mesh);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kInput) throw;
    }
  }
  return StreamlineTracer(field, options);
}

}  // namespace

void add_streamlines(const FrameField& shown, const DrawnSurface& surface, const Box& box, std::size_t axis,
                     const Monitor& monitor, SceneWriter& scene) {
  const Vector3 origin = 0.5 * (box.low + box.high);
  const TriangleMesh mesh = mesh_of(surface, origin);
  const StreamlineTracer tracer = tracer_of(shown, mesh);
  const double cell = (box.high[0] - box.low[0] + box.high[1] - box.low[1] + box.high[2] - box.low[2]) /
                      (3 * std::max(1.0, shown.report().resolution));
  Polylines lines(origin);
  std::vector<std::uint8_t> axes, sets;
  const auto add = [&](const Seeds& seeds, std::uint8_t set) {
    for (const Streamline& line : tracer.trace(seeds.points, monitor).lines) {
      if (!seeds.normals.empty() &&
          std::abs(dot(line.tangents[line.seed_point], seeds.normals[line.seed])) > kAlong)
        continue;
      const std::size_t pieces = line.points.size() - 1;
      const std::size_t drawn = std::min(pieces, kMostPoints);
      for (std::size_t k = 0; k <= drawn; ++k) lines.add_point(line.points[k * pieces / drawn]);
      lines.end_line();
      axes.push_back(static_cast<std::uint8_t>(line.axis));
      sets.push_back(set);
    }
  };
  add(seeds_on_cut(shown, box, axis), 0);
  add(seeds_on_surface(mesh, kDepth * cell), 1);
  lines.write(scene, "streamline_points", "streamline_starts");
  scene.add("streamline_axis", 1, axes);
  scene.add("streamline_set", 1, sets);
}

}  // namespace crossgrain
