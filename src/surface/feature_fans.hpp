// SPDX-License-Identifier: Apache-2.0
// Triangles around vertices between feature edges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/feature_edges.hpp"
#include "surface/feature_surface.hpp"

namespace crossgrain {

/// Half-edge 3 t + k runs from corner k of triangle t to the next one. Around a vertex, triangles follow each
/// other counter-clockwise, seen from the side that their normals look to.
class FeatureFans {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// Triangles at a vertex, from one feature edge to the next.
  struct Fan {
    std::uint32_t vertex;
    std::uint32_t first;  ///< half-edge from the vertex, of the first triangle
    std::uint32_t last;   ///< half-edge to the vertex, of the last one
    bool is_closed;       ///< it goes all around and crosses no feature edge
  };

  /// `edges` are those of `feature_edges` of the same surface.
  FeatureFans(const FeatureSurface& surface, std::span<const EdgeUse> all_uses,
              const std::vector<FeatureEdge>& edges);

  /// Ascending by vertex, then open ones first, then by `first`.
  const std::vector<Fan>& fans() const { return fans_; }

  /// The half-edge on the other side; kNone on feature edges.
  std::uint32_t opposite(std::uint32_t half_edge) const { return opposite_[half_edge]; }

  /// The feature edge that a half-edge lies on; kNone on others.
  std::uint32_t edge_of(std::uint32_t half_edge) const { return edge_of_[half_edge]; }

  /// Calls visit(half-edge from the vertex) for every triangle of a fan.
  template <class Visit>
  void for_each_triangle(const Fan& fan, const Visit& visit) const {
    for (std::uint32_t h = fan.first;; h = opposite_[before(h)]) {
      visit(h);
      if (before(h) == fan.last) return;
    }
  }

  static std::uint32_t next(std::uint32_t half_edge) {
    return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
  }
  static std::uint32_t before(std::uint32_t half_edge) {
    return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
  }

 private:
  void find_fans(const FeatureSurface& surface);

  std::vector<std::uint32_t> opposite_, edge_of_;
  std::vector<Fan> fans_;
};

/// Returns the sum of the angles of a fan's triangles at its vertex.
double angle_rad_of(const FeatureFans& fans, const FeatureFans::Fan& fan, const Surface& surface);

/// Whether a closed fan is the tip of a cone: its triangles are tilted against their mean by 20 degrees or
/// more, all around, and so is what lies around them: exact normals at the far vertices, or the triangles
/// behind. On a smooth surface that is tilted twice as much, around the peak of a rough one less.
bool is_tip(const FeatureFans& fans, const FeatureFans::Fan& fan, const Surface& surface);

}  // namespace crossgrain
