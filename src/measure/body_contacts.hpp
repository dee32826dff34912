// SPDX-License-Identifier: Apache-2.0
// Bodies of a tet mesh that touch without common vertices, or that overlap.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/warning.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// Two bodies (TetSolid::tet_components) that share no vertices where the solids that they fill meet.
struct BodyContact {
  std::array<std::uint32_t, 2> bodies;  ///< ascending
  std::array<std::int32_t, 2> regions;  ///< of the tets at `place`; 0 for a mesh without regions
  bool is_overlap = false;  ///< one reaches into the other; otherwise they share a part of their surfaces
  double area = 0;          ///< of one surface, in or on the other body
  Vector3 place{};          ///< in the middle of a triangle of it
};

/// Returns all pairs of bodies that overlap, then those that touch, each by falling area. Surfaces touch
/// where they are apart by no more than their triangles are from the curved surface that these stand for;
/// contact in points or along lines is none. The same for any number of threads.
std::vector<BodyContact> body_contacts(const TetSolid& solid);

/// Returns what is wrong with a mesh of such bodies and what to do: "solids 1 and 2 touch, but are meshed
/// apart, without common vertices, at 8 9 10". `contacts` has one entry at least.
Warning warning_of(const std::vector<BodyContact>& contacts);

}  // namespace crossgrain
