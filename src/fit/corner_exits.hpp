// SPDX-License-Identifier: Apache-2.0
// Edges by which the curves of a corner leave a vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "fit/quad_complex.hpp"
#include "fit/solid_sets.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

struct CornerExits {
  std::vector<std::uint32_t> edges;  ///< of the surface, for each end of the corner; kNowhere without

  /// Mean of 1 - cos of the angles between the ends and their edges; 0 without ends.
  double mean_turn = 0;

  /// Ends that have no edge of their own, between the same solids.
  std::size_t missing = 0;

  /// Whether between edges there are the sectors of the corner, each of one quad or more. If not, edges are
  /// those of the least turn without regard to sectors.
  bool fits = false;
};

/// Finds the exits of corners at vertices. Refers to its arguments, which must outlive it.
class ExitSearch {
 public:
  ExitSearch(const HexMesh& mesh, const QuadComplex& surface, const FeatureComplex& features,
             const SolidSets& sets, double size);

  /// Returns the exits with the least sum of turns. Corners of many ends at vertices of many edges are
  /// searched in part.
  CornerExits exits(std::uint32_t corner, std::uint32_t vertex) const;

 private:
  const HexMesh& mesh_;
  const QuadComplex& surface_;
  const FeatureComplex& features_;
  const SolidSets& sets_;
  std::vector<std::vector<Vector3>> directions_;  ///< of the ends of each corner, unit
};

}  // namespace crossgrain
