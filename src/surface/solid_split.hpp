// SPDX-License-Identifier: Apache-2.0
// A model of several solids: the surface around all of them, and the faces between them.
#pragma once

#include <vector>

#include "crossgrain/types.hpp"
#include "surface/guides.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Whether the triangles of a mesh bound more than one solid (TriangleMesh::solids).
bool has_several_solids(const TriangleMesh& mesh);

/// A mesh whose solids lie side by side, taken apart.
struct SolidSplit {
  /// What bounds all solids together, in the order given, with all else that the mesh knows: the mesh itself
  /// where there are no pairs.
  CheckedMesh outer;

  /// Over the vertices of the mesh, with corner normals: one triangle of each pair between two solids, that
  /// of the solid of the lower number, so that all of a face run the same way; then TriangleMesh::inner_faces
  /// that have an area.
  TriangleMesh inner;
};

/// Takes the triangles between solids out of a mesh. Two are a pair where they are of different solids and
/// have the same corners in opposite order, vertices of equal coordinates taken as one; of more than two,
/// pairs are made as long as there are any.
///
/// `unite`: pairs are left out of `inner` too, and so are the creases of the mesh that run along them and
/// along which `outer` is not sharp (CreaseAngles::least_deg).
SolidSplit split_solids(CheckedMesh mesh, bool unite);

/// Frames are to have an axis across them, as across the surface.
std::vector<GuideFace> guides_across(const TriangleMesh& inner);

}  // namespace crossgrain
