// SPDX-License-Identifier: Apache-2.0
#include "surface/defeaturing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/vector3.hpp"
#include "surface/edge_loops.hpp"
#include "surface/edge_uses.hpp"
#include "surface/hole_filling.hpp"
#include "surface/patch_sides.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// Cosine of the largest angle between normals of a flat face.
constexpr double kFlatFace = 0.9999;

/// Of the width of all other loops around a face that is not flat, the most that a rim inside it has.
constexpr double kWithin = 0.5;

/// A loop around a face.
struct FaceLoop {
  std::vector<DirectedEdge> edges;  ///< `across`: the triangle of the face itself
  Vector3 middle{};
  double width = 0, length = 0;
};

class Defeaturing {
 public:
  Defeaturing(const TriangleMesh& mesh, const FeatureComplex& features, double size)
      : mesh_(mesh), features_(features), size_(size), uses_(sorted_edge_uses(features.triangles)) {}

  DefeaturedSurface made() {
    for (std::uint32_t face = 0; face < features_.faces.size(); ++face) find_rims(face);
    DefeaturedSurface result;
    result.mesh = mesh_;
    if (rims_.empty()) return result;
    join_faces();
    choose();
    if (left_out_.empty()) return result;
    std::vector<std::uint32_t> kept;
    for (std::uint32_t t = 0; t < features_.triangles.size(); ++t)
      if (!is_gone_[parts_of_faces_.root(features_.face_of[t])]) kept.push_back(features_.source_of[t]);
    std::ranges::sort(kept);
    result.mesh = with_filled_holes(selected_triangles(mesh_, kept)).mesh;
    std::ranges::stable_sort(left_out_, std::greater(), &LeftOutFeature::width);
    result.features = std::move(left_out_);
    return result;
  }

 private:
  const Vector3& vertex(std::uint32_t v) const { return features_.vertices[v]; }

  /// The face across an edge of a triangle; kNone where there is not just one other triangle.
  std::uint32_t face_across(std::uint32_t a, std::uint32_t b, std::uint32_t triangle) const {
    const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [first, last] = std::ranges::equal_range(uses_, edge, {}, &EdgeUse::edge);
    if (last - first != 2) return FeatureComplex::kNone;
    return features_.face_of[first->triangle == triangle ? (first + 1)->triangle : first->triangle];
  }

  std::vector<FaceLoop> loops_around(std::uint32_t face) const {
    std::vector<DirectedEdge> border;
    for (const std::uint32_t t : features_.faces[face].triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = features_.triangles[t][k], b = features_.triangles[t][(k + 1) % 3];
        if (face_across(a, b, t) != face) border.push_back({a, b, t});
      }
    std::vector<FaceLoop> loops;
    for (auto& edges : loops_of(std::move(border))) {
      FaceLoop& loop = loops.emplace_back();
      const double share = 1 / static_cast<double>(edges.size());
      for (const DirectedEdge& edge : edges) loop.middle += share * vertex(edge.from);
      for (const DirectedEdge& edge : edges) {
        loop.width = std::max(loop.width, 2 * norm(vertex(edge.from) - loop.middle));
        loop.length += norm(vertex(edge.to) - vertex(edge.from));
      }
      loop.edges = std::move(edges);
    }
    return loops;
  }

  bool is_flat(std::uint32_t face) const {
    const auto normal_of = [&](std::uint32_t t) { return shape_of(features_.points_of(t)).normal; };
    const std::vector<std::uint32_t>& triangles = features_.faces[face].triangles;
    return std::ranges::all_of(triangles, [&](std::uint32_t t) {
      return dot(normal_of(t), normal_of(triangles.front())) > kFlatFace;
    });
  }

  /// The narrow loops inside a face.
  void find_rims(std::uint32_t face) {
    std::vector<FaceLoop> loops = loops_around(face);
    if (loops.size() < 2) return;
    std::ranges::stable_sort(loops, std::greater(), &FaceLoop::length);
    const bool flat = is_flat(face);
    for (std::size_t k = 1; k < loops.size(); ++k) {
      if (loops[k].width >= size_) continue;
      double least = HUGE_VAL;
      for (std::size_t other = 0; other < k; ++other)
        if (loops[other].width >= size_) least = std::min(least, loops[other].width);
      if (flat || loops[k].width < kWithin * std::min(least, loops[0].width))
        rims_.push_back(std::move(loops[k]));
    }
  }

  /// Joins faces over all edges but those of rims.
  void join_faces() {
    std::vector<std::uint64_t> of_rims;
    for (const FaceLoop& rim : rims_)
      for (const DirectedEdge& edge : rim.edges)
        of_rims.push_back(std::uint64_t{std::min(edge.from, edge.to)} << 32 | std::max(edge.from, edge.to));
    std::ranges::sort(of_rims);
    parts_of_faces_ = DisjointSets(features_.faces.size());
    for_each_edge(std::span<const EdgeUse>(uses_), [&](std::span<const EdgeUse> edge) {
      if (std::ranges::binary_search(of_rims, edge[0].edge)) return;
      for (const EdgeUse& use : edge)
        parts_of_faces_.join(features_.face_of[edge[0].triangle], features_.face_of[use.triangle]);
    });
  }

  struct Part {
    std::vector<std::uint32_t> triangles;
    std::size_t faces = 0;
    const FaceLoop* rim = nullptr;  ///< the widest
    double area = 0;
  };

  /// Twice the largest distance of triangles from the axis of a rim.
  double width_about(const FaceLoop& rim, const std::vector<std::uint32_t>& triangles) const {
    Vector3 axis{};
    for (const DirectedEdge& edge : rim.edges)
      axis += cross(vertex(edge.from) - rim.middle, vertex(edge.to) - rim.middle);
    const double length = norm(axis);
    if (!(length > 0)) return HUGE_VAL;
    double width = 0;
    for (const std::uint32_t t : triangles)
      for (const Vector3& p : features_.points_of(t))
        width = std::max(width, 2 / length * norm(cross(p - rim.middle, axis)));
    return width;
  }

  void choose() {
    std::vector<Part> parts(features_.faces.size());
    for (std::uint32_t face = 0; face < features_.faces.size(); ++face) {
      Part& part = parts[parts_of_faces_.root(face)];
      const FeatureComplex::Face& own = features_.faces[face];
      part.triangles.insert(part.triangles.end(), own.triangles.begin(), own.triangles.end());
      part.area += own.area;
      ++part.faces;
    }
    double largest = 0;
    for (const Part& part : parts) largest = std::max(largest, part.area);
    for (const FaceLoop& rim : rims_) {
      const DirectedEdge& edge = rim.edges.front();
      const std::uint32_t beyond = face_across(edge.from, edge.to, edge.across);
      if (beyond == FeatureComplex::kNone) continue;
      Part& part = parts[parts_of_faces_.root(beyond)];
      if (part.rim == nullptr || rim.width > part.rim->width) part.rim = &rim;
    }
    is_gone_.assign(parts.size(), 0);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Part& part = parts[k];
      if (part.rim == nullptr || part.area == largest || width_about(*part.rim, part.triangles) > size_)
        continue;
      is_gone_[k] = 1;
    }
    keep_what_joins_others();
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (is_gone_[k]) left_out_.push_back({parts[k].rim->middle, parts[k].rim->width, parts[k].faces});
  }

  /// The parts of faces on both sides of a rim.
  std::pair<std::uint32_t, std::uint32_t> parts_at(const FaceLoop& rim) {
    const DirectedEdge& edge = rim.edges.front();
    const std::uint32_t own = parts_of_faces_.root(features_.face_of[edge.across]);
    const std::uint32_t other = face_across(edge.from, edge.to, edge.across);
    return {own, other == FeatureComplex::kNone ? own : parts_of_faces_.root(other)};
  }

  /// Parts that lead from one that stays to another stay too: without them the model would fall apart, or
  /// have a void.
  void keep_what_joins_others() {
    constexpr std::uint32_t kNone = FeatureComplex::kNone;
    DisjointSets together(is_gone_.size());
    for (const FaceLoop& rim : rims_) {
      const auto [a, b] = parts_at(rim);
      if (is_gone_[a] && is_gone_[b]) together.join(a, b);
    }
    std::vector<std::uint32_t> beside(is_gone_.size(), kNone);  // of each set, a part that stays
    std::vector<std::uint8_t> joins_others(is_gone_.size(), 0);
    for (const FaceLoop& rim : rims_) {
      auto [gone, stays] = parts_at(rim);
      if (is_gone_[stays]) std::swap(gone, stays);
      if (!is_gone_[gone] || is_gone_[stays]) continue;
      std::uint32_t& known = beside[together.root(gone)];
      if (known != kNone && known != stays) joins_others[together.root(gone)] = 1;
      known = stays;
    }
    for (std::uint32_t k = 0; k < is_gone_.size(); ++k)
      if (is_gone_[k] && joins_others[together.root(k)]) is_gone_[k] = 0;
  }

  const TriangleMesh& mesh_;
  const FeatureComplex& features_;
  const double size_;
  const std::vector<EdgeUse> uses_;
  std::vector<FaceLoop> rims_;
  DisjointSets parts_of_faces_{0};
  std::vector<std::uint8_t> is_gone_;
  std::vector<LeftOutFeature> left_out_;
};

}  // namespace

DefeaturedSurface without_small_features(const TriangleMesh& mesh, const FeatureComplex& features,
                                         double size) {
  return Defeaturing(mesh, features, size).made();
}

}  // namespace crossgrain
