// SPDX-License-Identifier: Apache-2.0
// Hexahedra by region and faces of the boundary by tag, as formats with groups need them.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// A face of the boundary as one of its hexahedron.
struct BoundarySide {
  std::uint32_t hexahedron;
  std::uint8_t face;  ///< in kHexFaces
};

/// Returns the sides of HexMesh::boundary, in its order. Throws Error(kUsage) if one is no face of a
/// hexahedron.
std::vector<BoundarySide> sides_of_boundary(const HexMesh& mesh);

struct HexGroup {
  std::int32_t tag;
  std::vector<std::uint32_t> members;  ///< indices, ascending
};

struct HexGroups {
  std::vector<HexGroup> faces;    ///< of HexMesh::boundary, ascending by tag
  std::vector<HexGroup> regions;  ///< of hexahedra, ascending; one of tag 0 for a mesh without regions

  /// Whether the faces have no other tag than 0, and are one group or none.
  bool are_faces_untagged() const { return faces.empty() || (faces.size() == 1 && faces[0].tag == 0); }
};

HexGroups groups_of(const HexMesh& mesh);

/// Returns the vertices of a group of faces, ascending.
std::vector<std::uint32_t> vertices_of_faces(const HexMesh& mesh, const HexGroup& group);

}  // namespace crossgrain
