// SPDX-License-Identifier: Apache-2.0
// Bodies of a tet mesh that touch without common vertices, or that overlap.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/warning.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// How bodies meet.
enum class ContactKind {
  kOverlap,  ///< one reaches into the other
  kInFaces,  ///< they share a part of their surfaces
  kInEdge,   ///< they share a line
  kInPoint
};

/// Two bodies (TetSolid::tet_components), which share no faces of tets, where the solids that they fill meet.
struct BodyContact {
  std::array<std::uint32_t, 2> bodies;  ///< ascending
  std::array<std::int32_t, 2> regions;  ///< of the tets at `place`; 0 for a mesh without regions
  ContactKind kind = ContactKind::kInFaces;
  double area = 0;  ///< of one surface, in or on the other body; 0 along edges and in points
  Vector3 place{};  ///< in the middle of a triangle or edge of it, or a vertex

  /// Whether hexahedra of both would have to share faces, or fill a place twice.
  bool is_of_areas() const { return kind == ContactKind::kOverlap || kind == ContactKind::kInFaces; }
};

/// Returns all pairs of bodies that meet, by kind, each by falling area. Surfaces touch where they are apart
/// by no more than their triangles are from the curved surface that these stand for. Of contact along edges
/// and in points only that at vertices is found. The same for any number of threads.
std::vector<BodyContact> body_contacts(const TetSolid& solid);

/// Returns what is wrong with a mesh of such bodies and what to do: "solids 1 and 2 touch, but are meshed
/// apart, without common vertices, at 8 9 10". `contacts` has one entry at least.
Warning warning_of(const std::vector<BodyContact>& contacts);

/// Whether a warning is about solids that meet, as the surface or the tets tell it ("edges of more than two
/// triangles"). Contacts say it in words of the model.
bool is_of_contact(const Warning& warning);

}  // namespace crossgrain
