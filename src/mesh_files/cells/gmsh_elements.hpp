// SPDX-License-Identifier: Apache-2.0
// The element types of Gmsh ("Gmsh file formats", MSH).
#pragma once

#include <array>
#include <cstdint>

#include "mesh_files/cells/cell_builder.hpp"

namespace crossgrain {

inline constexpr std::array kGmshElements = {
    CellType{1, CellShape::kEdge, 2, "lines"},
    CellType{2, CellShape::kTriangle, 3, "triangles"},
    CellType{3, CellShape::kQuad, 4, "quadrangles"},
    CellType{4, CellShape::kTet, 4, "tets"},
    CellType{5, CellShape::kHexahedron, 8, "hexahedra"},
    CellType{6, CellShape::kOtherSolid, 6, "prisms"},
    CellType{7, CellShape::kOtherSolid, 5, "pyramids"},
    CellType{8, CellShape::kEdge, 3, "lines"},
    CellType{9, CellShape::kTriangle, 6, "triangles"},
    CellType{10, CellShape::kQuad, 9, "quadrangles"},
    CellType{11, CellShape::kTet, 10, "tets"},
    CellType{12, CellShape::kHexahedron, 27, "hexahedra"},
    CellType{13, CellShape::kOtherSolid, 18, "prisms"},
    CellType{14, CellShape::kOtherSolid, 14, "pyramids"},
    CellType{15, CellShape::kPassedOver, 1, "points"},
    CellType{16, CellShape::kQuad, 8, "quadrangles"},
    CellType{17, CellShape::kHexahedron, 20, "hexahedra"},
    CellType{18, CellShape::kOtherSolid, 15, "prisms"},
    CellType{19, CellShape::kOtherSolid, 13, "pyramids"},
    CellType{20, CellShape::kTriangle, 9, "triangles"},
    CellType{21, CellShape::kTriangle, 10, "triangles"},
    CellType{22, CellShape::kTriangle, 12, "triangles"},
    CellType{23, CellShape::kTriangle, 15, "triangles"},
    CellType{24, CellShape::kTriangle, 15, "triangles"},
    CellType{25, CellShape::kTriangle, 21, "triangles"},
    CellType{26, CellShape::kEdge, 4, "lines"},
    CellType{27, CellShape::kEdge, 5, "lines"},
    CellType{28, CellShape::kEdge, 6, "lines"},
    CellType{29, CellShape::kTet, 20, "tets"},
    CellType{30, CellShape::kTet, 35, "tets"},
    CellType{31, CellShape::kTet, 56, "tets"},
    CellType{92, CellShape::kHexahedron, 64, "hexahedra"},
    CellType{93, CellShape::kHexahedron, 125, "hexahedra"},
};

/// Returns null for other types, whose number of nodes is unknown.
constexpr const CellType* gmsh_element(std::int64_t code) {
  for (const CellType& type : kGmshElements) {
    if (type.code == code) return &type;
  }
  return nullptr;
}

}  // namespace crossgrain
