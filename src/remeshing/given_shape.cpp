// SPDX-License-Identifier: Apache-2.0
#include "remeshing/given_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <queue>
#include <span>
#include <utility>

#include "base/ascending.hpp"
#include "base/elementary.hpp"
#include "base/vector3.hpp"
#include "surface/edge_uses.hpp"

namespace crossgrain {
namespace {

/// Distance from a plane, relative to the size, within which a patch is flat: above the rounding of files in
/// single precision.
constexpr double kFlat = 1e-5;

/// Normals of the patches at their vertices: of its triangles there, weighted by their angles.
class PatchNormals {
 public:
  explicit PatchNormals(const PatchedSurface& given) : given_(given) {
    for (std::size_t t = 0; t < given.triangles.size(); ++t)
      for (const std::uint32_t vertex : given.triangles[t]) keys_.push_back(key(vertex, t));
    sort_uniquely(keys_);
    normals_.assign(keys_.size(), {0, 0, 0});
    for (std::size_t t = 0; t < given.triangles.size(); ++t) add(t);
    for (Vector3& normal : normals_) normal = normalised(normal);
  }

  const Vector3& at(std::uint32_t vertex, std::size_t triangle) const {
    return normals_[place(key(vertex, triangle))];
  }

 private:
  std::uint64_t key(std::uint32_t vertex, std::size_t triangle) const {
    return std::uint64_t{vertex} << 32 | given_.patch_of[triangle];
  }
  std::size_t place(std::uint64_t key) const {
    return static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
  }

  void add(std::size_t t) {
    const auto corners = corners_of(given_.triangles[t], given_.vertices);
    const Vector3 normal = shape_of(corners).normal;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 a = normalised(corners[(k + 1) % 3] - corners[k]);
      const Vector3 b = normalised(corners[(k + 2) % 3] - corners[k]);
      normals_[place(key(given_.triangles[t][k], t))] +=
          arc_cosine(std::clamp(dot(a, b), -1.0, 1.0)) * normal;
    }
  }

  const PatchedSurface& given_;
  std::vector<std::uint64_t> keys_;  ///< vertex and patch, sorted
  std::vector<Vector3> normals_;
};

/// Returns the point of a segment nearest to p.
Vector3 nearest_on_segment(const Vector3& a, const Vector3& b, const Vector3& p) {
  const Vector3 along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return a + t * along;
}

double length_of(const std::vector<std::uint32_t>& curve, const std::vector<Vector3>& vertices) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < curve.size(); ++k)
    length += norm(vertices[curve[k + 1]] - vertices[curve[k]]);
  return length;
}

}  // namespace

GivenShape::GivenShape(const PatchedSurface& given, const Remeshing& options)
    : given_(given), options_(options) {
  find_curvature_sizes();
  make_patches();
  make_curves();
}

double GivenShape::clamped(double size) const {
  return std::clamp(size, options_.smallest_share * options_.size, options_.size);
}

/// The curvature of a triangle is the largest along its edges: how much the normal turns along the edge, over
/// its length.
void GivenShape::find_curvature_sizes() {
  const PatchNormals normals(given_);
  for (std::size_t t = 0; t < given_.triangles.size(); ++t) {
    double curvature = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = given_.triangles[t][k], b = given_.triangles[t][(k + 1) % 3];
      const Vector3 along = given_.vertices[b] - given_.vertices[a];
      const Vector3 turn = normals.at(b, t) - normals.at(a, t);
      curvature = std::max(curvature, std::abs(dot(turn, along)) / dot(along, along));
    }
    const double size = 2 * std::numbers::pi / (options_.edges_per_circle * curvature);
    triangle_sizes_.push_back(clamped(curvature > 0 ? size : options_.size));
  }
}

void GivenShape::make_patches() {
  patches_.resize(given_.patches());
  for (std::uint32_t t = 0; t < given_.triangles.size(); ++t)
    patches_[given_.patch_of[t]].triangles.push_back(t);
  std::vector<std::uint32_t> new_index(given_.vertices.size());
  std::vector<std::size_t> last_patch(given_.vertices.size(), SIZE_MAX);
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    TriangleMesh mesh;
    for (const std::uint32_t t : patches_[p].triangles) {
      auto triangle = given_.triangles[t];
      for (std::uint32_t& vertex : triangle) {
        if (std::exchange(last_patch[vertex], p) != p) {
          new_index[vertex] = static_cast<std::uint32_t>(mesh.vertices.size());
          mesh.vertices.push_back(given_.vertices[vertex]);
        }
        vertex = new_index[vertex];
      }
      mesh.triangles.push_back(triangle);
    }
    patches_[p].surface = prepare_surface(CheckedMesh::derived(std::move(mesh)));
  }
  // Trees refer to their surfaces, which must not move any more.
  for (Patch& patch : patches_) {
    find_plane(patch);
    if (!patch.is_flat) patch.tree = std::make_unique<TriangleBvh>(patch.surface);
  }
}

void GivenShape::find_plane(Patch& patch) const {
  const Surface& surface = patch.surface;
  const auto largest = std::max_element(surface.areas.begin(), surface.areas.end()) - surface.areas.begin();
  patch.normal = surface.normals[static_cast<std::size_t>(largest)];
  patch.origin = surface.corners(static_cast<std::size_t>(largest))[0];
  const auto is_in_plane = [&](const Vector3& vertex) {
    return std::abs(dot(vertex - patch.origin, patch.normal)) <= kFlat * options_.size;
  };
  const auto looks_alike = [&](const Vector3& normal) { return dot(normal, patch.normal) > 0; };
  patch.is_flat = std::all_of(surface.mesh.vertices.begin(), surface.mesh.vertices.end(), is_in_plane) &&
                  std::all_of(surface.normals.begin(), surface.normals.end(), looks_alike);
}

void GivenShape::make_curves() {
  std::map<std::array<std::uint32_t, 2>, double> sizes;
  for (std::size_t t = 0; t < given_.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto edge = ascending(std::array{given_.triangles[t][k], given_.triangles[t][(k + 1) % 3]});
      const auto [found, is_new] = sizes.emplace(edge, triangle_sizes_[t]);
      if (!is_new) found->second = std::min(found->second, triangle_sizes_[t]);
    }
  }
  for (const std::vector<std::uint32_t>& chain : given_.curves) {
    std::vector<Segment>& segments = curves_.emplace_back();
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      const std::array edge{chain[k], chain[k + 1]};
      segments.push_back({given_.vertices[edge[0]], given_.vertices[edge[1]], sizes.at(ascending(edge))});
    }
  }
}

PlaceOnShape GivenShape::on_patch(std::uint32_t patch, const Vector3& near) const {
  const Patch& of = patches_[patch];
  if (of.is_flat) return {near - dot(near - of.origin, of.normal) * of.normal, of.normal, options_.size};
  const NearestPoint found = of.tree->nearest(near);
  return {found.point, of.surface.normals[found.triangle], triangle_sizes_[of.triangles[found.triangle]]};
}

PlaceOnShape GivenShape::on_curve(std::uint32_t curve, const Vector3& near) const {
  PlaceOnShape best{near, {0, 0, 0}, options_.size};
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& segment : curves_[curve]) {
    const Vector3 point = nearest_on_segment(segment.from, segment.to, near);
    const double distance = norm(point - near);
    if (distance >= least) continue;
    least = distance;
    best = {point, {0, 0, 0}, segment.size};
  }
  return best;
}

std::vector<double> GivenShape::sizes_of_vertices() const {
  std::vector<double> sizes(given_.vertices.size(), options_.size);
  for (std::size_t t = 0; t < given_.triangles.size(); ++t)
    for (const std::uint32_t vertex : given_.triangles[t])
      sizes[vertex] = std::min(sizes[vertex], triangle_sizes_[t]);
  for (const std::vector<std::uint32_t>& curve : given_.curves) {
    const double length = clamped(length_of(curve, given_.vertices));
    for (const std::uint32_t vertex : curve) sizes[vertex] = std::min(sizes[vertex], length);
  }
  // Dijkstra along the edges.
  const std::vector<EdgeUse> uses = sorted_edge_uses(given_.triangles);
  std::vector<std::vector<std::uint32_t>> neighbours(given_.vertices.size());
  for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
    neighbours[edge[0].low()].push_back(edge[0].high());
    neighbours[edge[0].high()].push_back(edge[0].low());
  });
  using Reached = std::pair<double, std::uint32_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  for (std::uint32_t v = 0; v < sizes.size(); ++v) queue.emplace(sizes[v], v);
  while (!queue.empty()) {
    const auto [size, vertex] = queue.top();
    queue.pop();
    if (size > sizes[vertex]) continue;
    for (const std::uint32_t other : neighbours[vertex]) {
      const double grown = size + kGradation * norm(given_.vertices[other] - given_.vertices[vertex]);
      if (grown >= sizes[other]) continue;
      sizes[other] = grown;
      queue.emplace(grown, other);
    }
  }
  return sizes;
}

}  // namespace crossgrain
