// SPDX-License-Identifier: Apache-2.0
#include "fit/surface_samples.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/bvh.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// In sizes: what chords of curved faces are off is no reason to move.
constexpr double kUnfelt = 0.04;

/// Calls add(corners) for parts of a triangle whose edges are no longer than `most`: halves it across its
/// longest edge, so that a sliver is cut across and not along.
template <class Add>
void for_each_part(const std::array<Vector3, 3>& triangle, double most, const Add& add) {
  std::vector<std::array<Vector3, 3>> waiting{triangle};
  while (!waiting.empty()) {
    const std::array<Vector3, 3> corners = waiting.back();
    waiting.pop_back();
    std::size_t longest = 0;
    std::array<double, 3> squares;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 edge = corners[(k + 1) % 3] - corners[k];
      squares[k] = dot(edge, edge);
      if (squares[k] > squares[longest]) longest = k;
    }
    if (squares[longest] <= most * most) {
      add(corners);
      continue;
    }
    const Vector3 &a = corners[longest], &b = corners[(longest + 1) % 3], &c = corners[(longest + 2) % 3];
    const Vector3 middle = 0.5 * (a + b);
    waiting.push_back({middle, b, c});
    waiting.push_back({a, middle, c});
  }
}

/// The quads of a group, each as two triangles.
struct QuadTree {
  Surface surface;  ///< TriangleMesh::faces: twice the quad, and its half
  std::optional<TriangleBvh> tree;
};

constexpr std::array<std::array<std::size_t, 3>, 2> kHalves{{{0, 1, 2}, {0, 2, 3}}};

std::unique_ptr<QuadTree> tree_of(const std::vector<std::uint32_t>& quads, const HexMesh& mesh,
                                  const HexCarriers& carriers) {
  TriangleMesh triangles;
  for (const std::uint32_t q : quads) {
    const auto first = static_cast<std::uint32_t>(triangles.vertices.size());
    for (const std::uint32_t v : carriers.quads[q].vertices) triangles.vertices.push_back(mesh.vertices[v]);
    for (std::uint32_t half = 0; half < 2; ++half) {
      const auto& [a, b, c] = kHalves[half];
      triangles.triangles.push_back({first + static_cast<std::uint32_t>(a),
                                     first + static_cast<std::uint32_t>(b),
                                     first + static_cast<std::uint32_t>(c)});
      triangles.faces.push_back(static_cast<std::int32_t>(2 * q + half));
    }
  }
  const auto has_area = [&](const auto& t) { return shape_of(corners_of(t, triangles.vertices)).area > 0; };
  if (std::none_of(triangles.triangles.begin(), triangles.triangles.end(), has_area)) return nullptr;
  auto result = std::make_unique<QuadTree>();
  result->surface = prepare_surface(CheckedMesh::derived(std::move(triangles)));
  result->tree.emplace(result->surface);
  return result;
}

/// Shares of the corners of a triangle in a point of it.
std::array<double, 3> shares_in(const std::array<Vector3, 3>& corners, const Vector3& p) {
  const Vector3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double whole = dot(normal, normal);
  std::array<double, 3> shares;
  for (std::size_t k = 0; k < 3; ++k)
    shares[k] = dot(cross(corners[(k + 1) % 3] - p, corners[(k + 2) % 3] - p), normal) / whole;
  return shares;
}

}  // namespace

std::vector<SurfaceSample> surface_samples(const FeatureComplex& complex,
                                           const std::vector<std::uint32_t>& group_of_face, double spacing) {
  const double full = 0.5 * spacing * spacing;
  std::vector<SurfaceSample> samples;
  Checkpoint checkpoint;
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    double waiting = 0;
    for (const std::uint32_t t : complex.faces[f].triangles)
      for_each_part(complex.points_of(t), spacing, [&](const std::array<Vector3, 3>& corners) {
        checkpoint.pass();
        // Small parts share a sample.
        waiting += shape_of(corners).area;
        if (waiting < full) return;
        samples.push_back({(1.0 / 3) * (corners[0] + corners[1] + corners[2]), group_of_face[f], waiting});
        waiting = 0;
      });
  }
  return samples;
}

double QuadPull::difference(const std::vector<Vector3>& places) const {
  double sum = -target;
  for (std::size_t k = 0; k < 3; ++k) sum += shares[k] * dot(direction, places[vertices[k]]);
  return sum;
}

std::vector<QuadPull> quad_pulls(const std::vector<SurfaceSample>& samples, const HexMesh& mesh,
                                 const HexCarriers& carriers, double size) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> quads_of;
  for (std::uint32_t q = 0; q < carriers.quads.size(); ++q) quads_of[carriers.quads[q].group].push_back(q);
  std::map<std::uint32_t, std::unique_ptr<QuadTree>> trees;
  for (const auto& [group, quads] : quads_of)
    if (auto tree = tree_of(quads, mesh, carriers)) trees[group] = std::move(tree);
  std::vector<QuadPull> pulls(samples.size());
  parallel_for(samples.size(), [&](std::size_t s) {
    const SurfaceSample& sample = samples[s];
    QuadPull& pull = pulls[s];
    pull.weight = 0;
    const auto found = trees.find(sample.group);
    if (found == trees.end()) return;
    const Surface& surface = found->second->surface;
    const NearestPoint nearest = found->second->tree->nearest(sample.point);
    const double distance = std::sqrt(nearest.squared_distance);
    if (distance < kUnfelt * size || distance > size) return;
    const auto code = static_cast<std::uint32_t>(surface.mesh.faces[nearest.triangle]);
    for (std::size_t k = 0; k < 3; ++k)
      pull.vertices[k] = carriers.quads[code / 2].vertices[kHalves[code % 2][k]];
    pull.shares = shares_in(surface.corners(nearest.triangle), nearest.point);
    pull.direction = (1 / distance) * (nearest.point - sample.point);
    pull.target = dot(pull.direction, sample.point) + kUnfelt * size;
    pull.weight = sample.area / (size * size);
  });
  std::erase_if(pulls, [](const QuadPull& pull) { return pull.weight == 0; });
  return pulls;
}

}  // namespace crossgrain
