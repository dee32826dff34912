// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

struct TetDomainData;

/// A tet mesh made ready to carry a field: checked, its tets turned the right way round, its boundary found.
/// Immutable and cheap to copy; all members are safe to call from any number of threads.
class TetDomain {
 public:
  /// Tets that are inverted are turned; tets without volume, and those named twice, are left out; vertices
  /// that no tet uses stay and get frames all the same. `warnings` tells of each. Throws Error(kInput) naming
  /// the vertex, tet or face, counted from 0: coordinates that are not finite, indices out of range, no tet
  /// with a volume, a face of three tets or more.
  explicit TetDomain(TetMesh mesh);

  /// Vertices as given; the tets that carry frames, in the order given, of positive volume.
  const TetMesh& mesh() const;

  /// The boundary as a surface of its own, outward, with only the vertices that it uses, and what is tagged:
  /// regions are its solids (TriangleMesh::solids), where there are several; tagged faces within a region its
  /// inner faces. Where edges are tagged, its creases are these and all sharp edges.
  TriangleMesh boundary() const;

  /// Edge of a regular tet with the mean volume of the tets, model units. Many tiny tets in a corner do not
  /// make it tiny.
  double typical_edge_length() const;

  /// Of what was mended or is odd; those of the mesh first.
  const std::vector<Warning>& warnings() const;

  /// The representation behind it, for the library itself.
  const TetDomainData& data() const { return *data_; }

 private:
  std::shared_ptr<const TetDomainData> data_;
};

}  // namespace crossgrain
