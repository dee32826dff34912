// SPDX-License-Identifier: Apache-2.0
// Which solids meet at places of a mesh and of a model.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "fit/quad_complex.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Sets of solids, and outside, around places of a mesh's surface and of a model's features. Equal numbers
/// are equal sets.
struct SolidSets {
  SolidSets(const QuadComplex& surface, std::size_t mesh_vertices, const FeatureComplex& features);

  std::vector<std::uint32_t> of_edge, of_vertex;  ///< of the mesh; 0, the empty set, at vertices inside
  std::vector<std::uint32_t> of_curve, of_corner;
  std::vector<std::size_t> sizes;  ///< of each set

 private:
  std::uint32_t number_of(std::vector<std::int32_t> solids);

  std::map<std::vector<std::int32_t>, std::uint32_t> numbers_;
};

}  // namespace crossgrain
