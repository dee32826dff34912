// SPDX-License-Identifier: Apache-2.0
// A model of several solids: the surface around all of them, and the faces between them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/guides.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns whether the triangles of a mesh bound more than one solid (TriangleMesh::solids).
bool has_several_solids(const TriangleMesh& mesh);

/// A mesh of adjacent solids, split.
struct SolidSplit {
  /// The common boundary of all solids, in the given order, with all other data of the mesh. It is the mesh
  /// itself if there are no pairs.
  CheckedMesh outer;

  /// One triangle of each pair between two solids, that of the solid of lower number so that all triangles of
  /// a face have the same orientation; then TriangleMesh::inner_faces with an area. Has the vertices of the
  /// mesh, and corner normals.
  TriangleMesh inner;

  /// The triangle of each pair that belongs to the solid of lower number, both solids, and the numbers of
  /// their triangles in the mesh; also if united. Vertices are those of `inner`.
  struct Between {
    std::array<std::uint32_t, 3> triangle;
    std::array<std::int32_t, 2> solids;
    std::array<std::uint32_t, 2> sources;
  };
  std::vector<Between> between;
};

/// Removes the triangles between solids from a mesh. Two triangles are a pair if they belong to different
/// solids and have the same corners in opposite order; vertices of equal coordinates count as one. Of more
/// than two such triangles, as many pairs as possible are made.
///
/// `unite` excludes the pairs from `inner` too, and removes the creases that run along them, except where
/// `outer` is sharp (CreaseAngles::least_deg).
SolidSplit split_solids(CheckedMesh mesh, bool unite);

/// Returns guides by which frames have an axis across inner faces, as across the surface.
std::vector<GuideFace> guides_across(const TriangleMesh& inner);

}  // namespace crossgrain
