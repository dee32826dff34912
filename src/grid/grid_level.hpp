// SPDX-License-Identifier: Apache-2.0
// One level of the nested iteration: the octree so far, with the surface in each leaf.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/monitor.hpp"
#include "grid/face_neighbours.hpp"
#include "grid/leaf_guides.hpp"
#include "grid/octree.hpp"
#include "grid/share.hpp"
#include "surface/bvh.hpp"
#include "surface/guides.hpp"
#include "surface/surface.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {

/// The part of one surface triangle that lies inside one cell.
struct SurfacePiece {
  std::uint32_t triangle;
  float area;  ///< of the clipped triangle, model units squared
};

/// The cells of a level. Only active leaves are stored: those that hold surface or have their centre inside,
/// and near the cap of a hole also those with a corner inside.
struct GridLevel {
  Octree tree;

  /// The pieces of leaf i are pieces[piece_begin[i] .. piece_begin[i + 1]).
  std::vector<std::uint32_t> piece_begin;
  std::vector<SurfacePiece> pieces;

  /// Constraints on the frames of leaves besides the surface.
  LeafGuides guides;

  /// Winding number of the surface at the centre of leaf i, an integer; 0 or 1 if the surface is not closed.
  std::vector<std::int8_t> centre_winding;

  /// Number of leaves of the complete octree, including those outside; of all processes.
  std::size_t examined_leaves = 0;

  /// Which of the leaves this process owns, if it does not have the whole level.
  Share part;
  Ghosts ghosts;

  std::size_t size() const { return tree.size(); }
  Share share() const { return share_of(part, size()); }
  std::span<const SurfacePiece> pieces_of(CellIndex i) const {
    return {pieces.data() + piece_begin[i], pieces.data() + piece_begin[i + 1]};
  }
  bool centre_inside(CellIndex i) const { return centre_winding[i] > 0; }
  bool has_inside() const {
    return std::any_of(centre_winding.begin(), centre_winding.end(), [](int w) { return w > 0; });
  }
  bool holds_surface(CellIndex i) const { return piece_begin[i + 1] > piece_begin[i]; }
  bool is_constrained(CellIndex i) const { return holds_surface(i) || guides.has(i); }

  /// Number of leaves for one task of a loop over their pieces: near the root, leaves hold many.
  std::size_t leaves_per_task() const {
    constexpr std::size_t kPieces = std::size_t{1} << 14;
    return std::clamp<std::size_t>(kPieces * size() / (pieces.size() + 1), 1, kParallelGrain);
  }
};

/// A new level, with data that are needed only until it is solved and refined.
struct RefinedLevel {
  GridLevel level;

  /// The neighbours across the faces of each leaf.
  std::vector<FaceNeighbours> neighbours;

  /// For each leaf, the same leaf on the previous level or its parent there; empty on the coarsest level.
  std::vector<CellIndex> parent;
};

/// Input of the grid. The objects that it refers to must outlive it.
struct Solid {
  const Surface& surface;
  const TriangleBvh& bvh;
  const WindingNumber& winding;

  /// Whether the surface has no boundary and is consistently oriented (MendedSurface::closed). Then winding
  /// numbers are integers and change by one at each crossing of the surface.
  bool closed = false;

  /// Null if there are none.
  const Guides* guides = nullptr;

  /// Returns the normal of a triangle that points out of the solid, even if the surface is inside out.
  Vector3 outward_normal(std::uint32_t triangle) const {
    return winding.flipped() ? -surface.normals[triangle] : surface.normals[triangle];
  }
};

/// Returns the root cube and the depth at which its cells have `cell_size`. The surface is centred, except
/// for an offset by a fraction of a cell, so that faces at round coordinates do not lie in cell faces. Throws
/// Error(kLimit) if more than 2^kMaxDepth cells across are needed.
struct GridFrame {
  RootCube root;
  int finest_depth;
};
GridFrame frame_around(const Box& box, double cell_size);

/// Returns the uniform octree of `depth`. Like `refined`, throws Error(kInterrupted) once the monitor is
/// cancelled.
RefinedLevel uniform_level(const Solid& solid, const RootCube& root, int depth, const Monitor& monitor = {});

/// Returns `level` with the marked leaves, and those that balance requires, split into eight. If it is
/// shared, marks are those of all processes, and the result is to be shared out: it has descendants of
/// ghosts, no neighbours and guides, and its share has no numbers.
RefinedLevel refined(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid,
                     std::vector<bool> marked, const Monitor& monitor = {});

}  // namespace crossgrain
