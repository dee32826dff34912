// SPDX-License-Identifier: Apache-2.0
// A frame field on a tet mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"
#include "singularity/matching.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// Unit quaternions, in double precision so that frames on the boundary keep their normals exactly.
struct TetField {
  std::vector<Quaternion> vertex_frames;  ///< one per vertex of the mesh, including unused ones
  std::vector<Quaternion> tet_frames;     ///< one per tet

  /// Of a repaired field, the matching across each of TetSolid::inner_faces, from its first tet to its
  /// second. Empty: the nearest of the frames of tets.
  std::vector<CubeRotation> matchings = {};

  bool is_repaired() const { return !matchings.empty(); }
};

/// The matchings of a field across TetSolid::inner_faces: its own, or the nearest.
std::vector<CubeRotation> matchings_of(const TetSolid& solid, const TetField& field);

/// The singular graph of a field on tets; that of a repaired field is exact (repair/repaired_graph.hpp).
SingularityGraph graph_of(const TetSolid& solid, const TetField& field,
                          const SingularityOptions& options = {});

/// The frame of each tet of the solid. Inside it is the frame nearest to the mean of the degree-4
/// coefficients of its four vertices: the local maximum found from the most central of the four frames, or
/// the global one if they differ too much.
///
/// A tet with one face of the boundary or of the walls has an axis exactly along the normal of that face, and
/// is nearest to the mean among such frames: hexahedra at the face need this axis, and the mean of four
/// vertices is off it where the surface turns within the tet. With several faces that turn by more than 45
/// degrees it is nearest to all their normals; faces that turn by less share their mean normal, by area.
std::vector<Quaternion> tet_frames_of(const TetSolid& solid,
                                      std::span<const std::array<std::uint32_t, 3>> walls,
                                      std::span<const Quaternion> vertex_frames);

}  // namespace crossgrain
