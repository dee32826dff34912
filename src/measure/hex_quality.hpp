// SPDX-License-Identifier: Apache-2.0
// Shape and size of hexahedra.
#pragma once

#include <cstddef>
#include <vector>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// The scaled Jacobian of each hexahedron: the least, over its eight corners, of the determinant of the unit
/// vectors along the three edges there; 1 for a cube, at most 0 if the hexahedron is inverted at a corner. An
/// edge without length makes it 0. (Knupp 2000; Verdict's measure but for its further value at the centre.)
std::vector<double> scaled_jacobians(const HexMesh& mesh);

/// The mean of the corners of a hexahedron.
Vector3 centre_of(const HexMesh& mesh, std::size_t hexahedron);

/// Volumes of hexahedra with trilinear sides, exact to rounding.
std::vector<double> volumes_of(const HexMesh& mesh);

/// Area of a face: the mean of its two cuts into triangles.
double area_of(const HexMesh& mesh, const HexMesh::Face& face);

/// Area of the boundary.
double boundary_area(const HexMesh& mesh);

/// The shortest edge of hexahedra, which there are, and its middle.
struct ShortestEdge {
  double length;
  Vector3 place;
};
ShortestEdge shortest_edge(const HexMesh& mesh);

/// Mean length of the edges of hexahedra, those of each counted for it; 0 without hexahedra.
double mean_edge(const HexMesh& mesh);

}  // namespace crossgrain
