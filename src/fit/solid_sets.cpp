// SPDX-License-Identifier: Apache-2.0
#include "fit/solid_sets.hpp"

#include "base/ascending.hpp"

namespace crossgrain {

std::uint32_t SolidSets::number_of(std::vector<std::int32_t> solids) {
  sort_uniquely(solids);
  const auto [entry, is_new] = numbers_.try_emplace(solids, static_cast<std::uint32_t>(sizes.size()));
  if (is_new) sizes.push_back(solids.size());
  return entry->second;
}

SolidSets::SolidSets(const QuadComplex& surface, std::size_t mesh_vertices, const FeatureComplex& features) {
  std::vector<std::int32_t> solids;
  const auto add = [&](const auto& part) { solids.insert(solids.end(), {part.below, part.above}); };
  number_of({});
  for (std::uint32_t e = 0; e < surface.edges().size(); ++e) {
    solids.clear();
    for (const QuadComplex::Use& use : surface.uses_of_edge(e)) add(surface.quads()[use.quad]);
    of_edge.push_back(number_of(solids));
  }
  of_vertex.assign(mesh_vertices, 0);
  for (const std::uint32_t v : surface.vertices()) {
    solids.clear();
    for (const std::uint32_t quad : surface.quads_of(v)) add(surface.quads()[quad]);
    of_vertex[v] = number_of(solids);
  }
  for (const FeatureComplex::Curve& curve : features.curves) {
    solids.clear();
    for (const FeatureComplex::Side& side : curve.sides) add(features.faces[side.face]);
    of_curve.push_back(number_of(solids));
  }
  for (const FeatureComplex::Corner& corner : features.corners) {
    solids.clear();
    for (const FeatureComplex::Sector& sector : corner.sectors) add(sector);
    of_corner.push_back(number_of(solids));
  }
}

}  // namespace crossgrain
