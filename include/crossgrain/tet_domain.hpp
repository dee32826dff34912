// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "crossgrain/options.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

struct TetDomainData;

/// A tet mesh prepared for a field: validated, its tets oriented, its boundary extracted. Immutable and cheap
/// to copy; all members are safe to call from any number of threads.
class TetDomain {
 public:
  /// Reorients inverted tets and drops tets without volume and duplicates; keeps vertices that no tet uses,
  /// which get frames too. `warnings` lists all of this. Throws Error(kInput) naming the vertex, tet or face,
  /// counted from 0, for coordinates that are not finite, indices out of range, a mesh without a tet of
  /// positive volume and faces of three or more tets.
  ///
  /// Lists and tags that name nearly every face, edge or tet are removed, with a warning (TetTagOptions).
  explicit TetDomain(TetMesh mesh, const TetTagOptions& tags = {});

  /// All vertices, and the tets that have frames, in the order given and with positive volume.
  const TetMesh& mesh() const;

  /// The boundary as a surface that points outward, with the vertices that it uses and the tags: several
  /// regions become its solids (TriangleMesh::solids), tagged faces inside a region its inner faces. If edges
  /// are tagged, its creases are these and all sharp edges.
  TriangleMesh boundary() const;

  /// Edge of a regular tet with the mean volume of the tets, model units. Unlike the mean edge, it is not
  /// dominated by many tiny tets in a corner.
  double typical_edge_length() const;

  /// These tets, split so that a map that is linear in each can take the surface to integer planes:
  /// afterwards an edge, face or tet whose vertices all lie on the surface is part of it, and a tet has at
  /// most one face there. Vertices keep their numbers, new ones follow; parts inherit tags and regions. Solve
  /// on the result: frames belong to its mesh. Warns if rounding would leave a tet without volume, which is
  /// then not split.
  TetDomain prepared_for_map(const MapPreparationOptions& options = {}) const;

  /// These tets with their vertices elsewhere, one place each. Throws Error(kUsage) if that leaves a tet
  /// inverted or without volume.
  TetDomain with_vertices(std::vector<Vector3> vertices) const;

  /// What `prepared_for_map` did; none for tets as given.
  const std::optional<MapPreparation>& preparation() const;

  /// For each tet the one that it is a part of before `prepared_for_map`, UINT32_MAX if that is flat; empty
  /// for tets as given.
  const std::vector<std::uint32_t>& parents() const;

  /// Warnings about what was repaired or is unusual; those of the mesh first.
  const std::vector<Warning>& warnings() const;

  /// The representation behind it, for the library itself.
  const TetDomainData& data() const { return *data_; }

 private:
  explicit TetDomain(std::shared_ptr<const TetDomainData> data);

  std::shared_ptr<const TetDomainData> data_;
};

/// @}

}  // namespace crossgrain
