// SPDX-License-Identifier: Apache-2.0
// What a repair of matchings minimises.
#pragma once

#include <cstdint>
#include <vector>

#include "matching/matched_field.hpp"
#include "repair/repair_tuning.hpp"

namespace crossgrain {

/// The cost of a field: length of singular edges and lengths of faults. Lengths are in model units.
class RepairCost {
 public:
  RepairCost(const MatchedField& field, const RepairWeights& weights);

  /// An inner edge: its length, three times if no hexahedra fit around it, twice for other half turns, with
  /// (1 + end) for each end on the surface that is no end of an arc. A boundary edge: its length times
  /// `crease` for each quarter turn between the map and the geometry beyond half of one; without any
  /// hexahedron 40 (1 + end).
  double of_edge(std::uint32_t edge) const;

  /// RepairWeights::corner mean edge lengths where no hexahedra can meet.
  double of_vertex(std::uint32_t vertex) const;

  const RepairWeights& weights() const { return weights_; }

 private:
  bool may_end(const TetComplex::Edge& edge, std::uint32_t vertex, const Vector3& axis) const;

  const MatchedField& field_;
  const TetComplex& complex_;
  RepairWeights weights_;
  std::vector<Vector3> smooth_normals_;  ///< of smooth boundary vertices; {0, 0, 0} elsewhere
};

}  // namespace crossgrain
