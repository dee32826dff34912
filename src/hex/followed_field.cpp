// SPDX-License-Identifier: Apache-2.0
#include "hex/followed_field.hpp"

#include "matching/tet_complex.hpp"
#include "reduction/arc_lengths.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {

FollowedField::FollowedField(const TetFrameField& field) {
  const TetSolid& solid = field.domain().data().solid;
  const TetComplex complex(solid);
  const MatchedField matched(complex, field.data().tet_frames, matchings_of(solid, field.data()));
  const SingularityGraph& graph = field.singularities();
  for (const std::size_t arc : arcs_of_length_zero(matched, graph)) {
    const auto& vertices = graph.arcs[arc].vertices;
    arcs_without_length_.push_back(
        solid.mesh.vertices[static_cast<std::size_t>(vertices[vertices.size() / 2])]);
  }
  split_ = split_for_map(matched);
  cut_ = std::make_unique<CutSolid>(*split_.field);
  unknowns_ = std::make_unique<MapUnknowns>(*cut_);
}

}  // namespace crossgrain
