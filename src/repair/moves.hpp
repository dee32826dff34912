// SPDX-License-Identifier: Apache-2.0
// Changes of matchings that change the holonomies of few edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "matching/matched_field.hpp"

namespace crossgrain {

/// An inner face with the matching that it gets.
struct FaceChange {
  std::uint32_t face;
  std::uint8_t matching;
};

/// Pushes what is around the edge from `vertex` to way[0] along a way in the link of the vertex: faces[k] has
/// the vertex, way[k] and way[k + 1]. With the changes, in this order, the edges from the vertex to all of
/// the way but the last get the holonomy that they should have (MatchedField::wanted_holonomy). Others change
/// only if they join the vertex to the last of the way, or are edges of the way: an arc passes beside the
/// vertex then. On the boundary an edge that has no such holonomy ends the changes.
std::vector<FaceChange> push_changes(const MatchedField& field, std::uint32_t vertex,
                                     std::span<const std::uint32_t> way,
                                     std::span<const std::uint32_t> faces);

}  // namespace crossgrain
