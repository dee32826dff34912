// SPDX-License-Identifier: Apache-2.0
// Faces between tets that frames must have an axis across, and the surface of tets with all its features.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// A face between two tets of different regions, or one that the mesh tags (TetMesh::feature_faces).
struct InnerWall {
  std::array<std::uint32_t, 3> vertices;  ///< outward from the first tet, by the right-hand rule
  std::array<std::uint32_t, 2> tets;      ///< the one of the lower region first; the second may be kNoTet
  bool separates_regions;
};

/// The walls in the order of TetSolid::inner_faces. Adds to `warnings` how many tagged triangles are faces of
/// no tet.
std::vector<InnerWall> find_inner_walls(const TetSolid& solid, std::vector<Warning>& warnings);

/// Whether the tets belong to more than one region.
bool has_several_regions(const TetMesh& mesh);

/// Returns the regions of the boundary faces; for a face whose tet has no volume, that of any tet at its
/// first corner. The mesh must have regions.
std::vector<std::int32_t> regions_of_boundary(const TetSolid& solid);

/// The edges of the mesh that frames must run along, in its order: those that are stated (TetMesh::Edge), and
/// those inside the solid that belong to no wall. All others are sharp edges of faces, or irrelevant.
std::vector<std::array<std::uint32_t, 2>> followed_edges(const TetSolid& solid,
                                                         const std::vector<InnerWall>& walls);

/// The faces of the model that the tets were made of (TetMesh::given), otherwise the tagged ones; ascending
/// by number.
std::vector<ModelFace> model_faces(const TetSolid& solid, const std::vector<InnerWall>& walls);

/// The boundary with only the vertices used by it, walls and tagged edges, in the order of the solid. Several
/// regions become its solids, and the faces between them are there twice; tagged faces within a region become
/// its inner faces, tags of triangles its face numbers. If there are edges to follow, its creases are these
/// and the sharp edges of all these faces; otherwise it has none.
TriangleMesh model_surface(const TetSolid& solid, const std::vector<InnerWall>& walls);

}  // namespace crossgrain
