// SPDX-License-Identifier: Apache-2.0
// Frames and matchings that tests make for themselves.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "base/quaternion.hpp"
#include "field/field_state.hpp"
#include "field/made_grid.hpp"
#include "matching/matched_field.hpp"

namespace crossgrain::testing {

inline std::vector<Quaternion> random_tet_frames(const TetSolid& solid, std::uint64_t seed) {
  std::vector<Quaternion> frames;
  for (const StoredQuaternion& q : random_frames(solid.mesh.tets.size(), seed))
    frames.push_back(normalised(from_stored(q)));
  return frames;
}

/// Frames at the centroids of tets.
template <class Field>
std::vector<Quaternion> frames_at_centroids(const TetSolid& solid, const Field& field) {
  std::vector<Quaternion> frames;
  for (const auto& tet : solid.mesh.tets) {
    Vector3 sum{0, 0, 0};
    for (const std::uint32_t v : tet) sum += solid.mesh.vertices[v];
    frames.push_back(field(0.25 * sum));
  }
  return frames;
}

/// Turns so many random inner faces.
inline void turn_random_faces(MatchedField& field, int count, std::uint64_t seed) {
  const CubeGroup& group = CubeGroup::instance();
  std::mt19937_64 random(seed);
  for (int k = 0; k < count; ++k) {
    const auto face = static_cast<std::uint32_t>(random() % field.complex().solid().inner_faces.size());
    const auto turn = static_cast<std::uint8_t>(1 + random() % (CubeGroup::kCount - 1));
    field.set_matching(face, group.product(turn, field.matching(face)));
  }
}

}  // namespace crossgrain::testing
