// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"
#include "crossgrain/warning.hpp"

namespace crossgrain {

/// \addtogroup types Meshes and frames
/// @{

/// A mesh of hexahedra that index vertices. Corners of a hexahedron are numbered as in VTK, gmsh and Abaqus:
/// 0 1 2 3 around one face, 4 5 6 7 opposite to them, so that the edges from 0 to 1, 3 and 4 are right-handed
/// in a valid hexahedron. It is valid if the determinant of its trilinear map is positive everywhere in it,
/// and inverted otherwise.
struct HexMesh {
  struct Face {
    std::array<std::uint32_t, 4> vertices;
    std::int32_t tag = 0;  ///< TriangleMesh::faces of the model where most of the face lies; 0 without
  };

  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 8>> hexahedra;

  std::vector<std::int32_t> regions = {};  ///< region number of each hexahedron; empty if the model has none
  std::vector<Face> boundary = {};         ///< faces of only one hexahedron, outward by the right-hand rule

  std::string unit = {};  ///< of the coordinates, as of a TriangleMesh

  /// Whether it is a part of its model, or has inverted hexahedra: names and heads of its files say so.
  bool is_partial = false;

  std::vector<Warning> warnings = {};  ///< about the file that was read
};

/// @}

}  // namespace crossgrain
