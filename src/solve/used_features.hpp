// SPDX-License-Identifier: Apache-2.0
// The features of tets that a field follows.
#pragma once

#include <optional>

#include "solve/tet_domain_data.hpp"
#include "tets/boundary_vertices.hpp"

namespace crossgrain {

/// The features and boundary of a domain, unless it has walls that a union ignores. `tets` must outlive it.
class UsedFeatures {
 public:
  UsedFeatures(const TetDomainData& tets, bool unite) : tets_(tets) {
    if (!unite || !has_several_regions(tets.solid.mesh)) return;
    united_features_ = features_of(tets.solid, tets.walls, /*unite=*/true);
    united_boundary_ = classify_boundary_vertices(tets.solid, {}, *united_features_);
  }

  const InnerFeatures& features() const { return united_features_ ? *united_features_ : tets_.features; }
  const BoundaryVertices& boundary() const { return united_boundary_ ? *united_boundary_ : tets_.boundary; }

 private:
  const TetDomainData& tets_;
  std::optional<InnerFeatures> united_features_;
  std::optional<BoundaryVertices> united_boundary_;
};

}  // namespace crossgrain
