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
  arcs_without_length_ = arcs_of_length_zero(matched);
  split_ = split_for_map(matched);
  cut_ = std::make_unique<CutSolid>(*split_.field);
  unknowns_ = std::make_unique<MapUnknowns>(*cut_);
}

}  // namespace crossgrain
