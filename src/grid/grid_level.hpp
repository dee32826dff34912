// SPDX-License-Identifier: Apache-2.0
// One level of the nested iteration: the octree refined so far, with the surface inside each leaf.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "grid/face_neighbours.hpp"
#include "grid/leaf_guides.hpp"
#include "grid/octree.hpp"
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

/// The cells of a level. A leaf is active if it holds surface or its centre is inside, beside the cap over a
/// hole also if only a corner is; only active leaves are kept.
struct GridLevel {
  Octree tree;

  /// Pieces of leaf i: pieces[piece_begin[i] .. piece_begin[i + 1]).
  std::vector<std::uint32_t> piece_begin;
  std::vector<SurfacePiece> pieces;

  /// What the frames of leaves are to follow besides the surface in them.
  LeafGuides guides;

  /// How often the surface winds around the centre of leaf i: a whole number, 0 or 1 where the surface is not
  /// closed.
  std::vector<std::int8_t> centre_winding;

  /// Leaves of the complete octree, those outside counted too.
  std::size_t examined_leaves = 0;

  std::size_t size() const { return tree.size(); }
  std::span<const SurfacePiece> pieces_of(CellIndex i) const {
    return {pieces.data() + piece_begin[i], pieces.data() + piece_begin[i + 1]};
  }
  bool centre_inside(CellIndex i) const { return centre_winding[i] > 0; }
  bool holds_surface(CellIndex i) const { return piece_begin[i + 1] > piece_begin[i]; }
  bool is_constrained(CellIndex i) const { return holds_surface(i) || guides.has(i); }
};

/// A new level, with what is needed only until it is solved and the next one is made.
struct RefinedLevel {
  GridLevel level;

  /// The cells behind the faces of each leaf.
  std::vector<FaceNeighbours> neighbours;

  /// The leaf of the level before that is leaf i or its parent; empty on the coarsest level.
  std::vector<CellIndex> parent;
};

/// What the grid is built from; the referred objects must outlive it.
struct Solid {
  const Surface& surface;
  const TriangleBvh& bvh;
  const WindingNumber& winding;

  /// The surface has no boundary and no two sides of an edge contradict each other
  /// (MendedSurface::closed): winding numbers are whole, and change by one where a path crosses the
  /// surface.
  bool closed = false;

  /// Null for none.
  const Guides* guides = nullptr;

  /// The normal of a triangle that points out of the solid, also where the surface is inside out.
  Vector3 outward_normal(std::uint32_t triangle) const {
    return winding.flipped() ? -surface.normals[triangle] : surface.normals[triangle];
  }
};

/// The root cube for cells of `cell_size` at depth `finest_depth` around the surface. The surface is centred
/// up to a generic shift of a fraction of a cell, so that faces of parts drawn in round numbers do not lie in
/// cell faces. Throws Error(kLimit) where more than 2^kMaxDepth cells would be needed across.
struct GridFrame {
  RootCube root;
  int finest_depth;
};
GridFrame frame_around(const Box& box, double cell_size);

/// The uniform octree of `depth`. Throws Error(kInterrupted) once the monitor is cancelled, as does
/// `refined`.
RefinedLevel uniform_level(const Solid& solid, const RootCube& root, int depth, const Monitor& monitor = {});

/// Splits the marked leaves of `level` (and those that balance demands) into eight.
RefinedLevel refined(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid,
                     std::vector<bool> marked, const Monitor& monitor = {});

}  // namespace crossgrain
