// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
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

  /// Warnings about what was repaired or is unusual; those of the mesh first.
  const std::vector<Warning>& warnings() const;

  /// The representation behind it, for the library itself.
  const TetDomainData& data() const { return *data_; }

 private:
  std::shared_ptr<const TetDomainData> data_;
};

/// @}

}  // namespace crossgrain
