// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "crossgrain/constraints.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

/// Which boundary vertices of a tet mesh are constrained.
enum class TetBoundary {
  kAll,        ///< smooth vertices exactly, vertices of creases and corners by a weighted form
  kSmoothOnly  ///< smooth vertices exactly; those of creases and corners are free
};

/// Returns the name in report.json: "all" or "smooth-only".
const char* name_of(TetBoundary boundary);

/// Which lists of a tet mesh (TetMesh::feature_edges, feature_faces, regions) say where features are. Many
/// programs write every face and edge of a mesh, or number its tets, which would make each face a wall and
/// each edge a crease; such lists are left out.
struct TetTagOptions {
  /// Whether all lists count, whatever they name.
  bool keep_all = false;
};

/// How tets are split before a solve, for maps that take the surface to integer planes
/// (TetDomain::prepared_for_map).
struct MapPreparationOptions {
  /// Whether faces between regions count as inside (SolveOptions::unite_solids).
  bool unite_solids = false;
};

inline constexpr int kDefaultResolution = 128;

/// All options of a solve.
struct SolveOptions {
  Degree degree = Degree::kFour;

  /// Cells along the longest side of the bounding box at the finest level, at least 4. 0 stands for
  /// kDefaultResolution or, with `sized_for`, for cells that suit a tet mesh.
  int resolution = 0;

  /// Size of the finest cells in model units. Replaces `resolution` if positive.
  double cell_size = 0;

  /// Number of threads; 0 for all processors. The result does not depend on it.
  int threads = 0;

  /// Largest memory of the process in bytes; 0 for nine tenths of what the machine or the container has. If
  /// the finest cells need more, refinement ends up to three levels earlier (SolveReport::limited); if that
  /// still needs more, the solve throws Error(kLimit).
  std::size_t max_memory_bytes = 0;

  /// Whether several solids, or regions of tets, are solved as one: faces between them do not constrain
  /// frames. Cells have their region in both cases.
  bool unite_solids = false;

  /// Seed of the random frames of all starts.
  std::uint64_t seed = 0;

  /// Directions to follow besides the surface.
  Constraints constraints;

  /// Smallest angle between the normals beside an edge that makes it a crease, above 0; 180 for none. Ignored
  /// for meshes that bring their creases along (TriangleMesh::creases), such as those of CAD files.
  double crease_angle_deg = 35;

  /// Which boundary vertices are constrained when a field is carried onto tets.
  TetBoundary boundary = TetBoundary::kAll;

  /// Whether the result is for a page (crossgrain/page.hpp): it keeps the constraint forms that this shows
  /// for a cell. Without them, and for fields read from files, the page leaves that panel empty.
  bool for_page = false;
};

/// @}

}  // namespace crossgrain
