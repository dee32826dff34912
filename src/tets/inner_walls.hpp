// SPDX-License-Identifier: Apache-2.0
// Faces between tets that frames are to have an axis across, and the surface of tets with all that is known
// of them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// A face between two tets of different regions, or one that the mesh tags (TetMesh::feature_faces).
struct InnerWall {
  std::array<std::uint32_t, 3> vertices;  ///< by the right-hand rule outward of the first tet
  std::array<std::uint32_t, 2> tets;      ///< that of the lower region first; the second may be kNoTet
  bool separates_regions;
};

/// In the order of TetSolid::inner_faces. Tells `warnings` how many tagged triangles are faces of no tet.
std::vector<InnerWall> find_inner_walls(const TetSolid& solid, std::vector<Warning>& warnings);

/// Whether tets are of more than one region.
bool has_several_regions(const TetMesh& mesh);

/// The mesh's edges that frames are to run along, in its order: those that are stated (TetMesh::Edge), and
/// those inside the solid that are of no wall. Others are sharp edges of faces, or nothing.
std::vector<std::array<std::uint32_t, 2>> followed_edges(const TetSolid& solid,
                                                         const std::vector<InnerWall>& walls);

/// The boundary with only the vertices that it, walls and tagged edges use, in the order of the solid's.
/// Where there are several regions, they are its solids, and the faces between them are there twice; tagged
/// faces within a region are its inner faces. Tags of triangles are its face numbers. Where there are edges
/// to be followed, its creases are these and the sharp edges of all these faces; else it has none.
TriangleMesh model_surface(const TetSolid& solid, const std::vector<InnerWall>& walls);

}  // namespace crossgrain
