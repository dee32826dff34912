// SPDX-License-Identifier: Apache-2.0
// How the frame of a leaf varies around it, from the frames of the leaves that it is joined to.
//
// Notation: q_i the frame of leaf i as a quaternion, c_i its centre, s_i its side, W_i its turn: the frame
// near c_i is exp(W_i (x - c_i)) q_i, exp as in from_rotation_vector.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/quaternion.hpp"
#include "grid/leaf_surroundings.hpp"
#include "grid/packed_box.hpp"

namespace crossgrain {

/// A field as it is known cell by cell; refers to its arrays.
struct LeafField {
  const Octree& tree;
  std::span<const StoredQuaternion> frames;
  std::span<const std::uint8_t> open_faces;  ///< as in LeafConnections
  LeafFinder finder{tree};
};

/// A leaf with its place, in units of the smallest possible cell.
struct PlacedLeaf {
  CellIndex index;
  GridPoint corner;
  std::int32_t width;
  std::uint8_t open_faces;

  /// (point - centre) / width, the point in the same units.
  Vector3 offset_of(const Vector3& point) const {
    const double scale = 1.0 / width;
    return {scale * (point[0] - corner[0]) - 0.5, scale * (point[1] - corner[1]) - 0.5,
            scale * (point[2] - corner[2]) - 0.5};
  }
  Vector3 centre() const {
    return {corner[0] + 0.5 * width, corner[1] + 0.5 * width, corner[2] + 0.5 * width};
  }
};

inline PlacedLeaf placed(const LeafField& field, CellIndex i) {
  const CellAddress address = field.tree[i];
  return {i, address.corner(), address.width(), field.open_faces[i]};
}

/// What tells whether two leaves are joined.
struct LeafFaces {
  PackedBox box;
  std::int32_t width;
  std::uint8_t open;

  LeafFaces() = default;
  explicit LeafFaces(const PlacedLeaf& leaf)
      : box(leaf.corner, leaf.width), width(leaf.width), open(leaf.open_faces) {}
};

/// Whether there is an open face between two leaves.
inline bool joined(const LeafFaces& a, const LeafFaces& b) {
  const int face = shared_face(a.box, b.box);
  if (face < 0) return false;
  return (a.width <= b.width && a.open >> face & 1) ||
         (b.width <= a.width && b.open >> opposite_face(face) & 1);
}
inline bool joined(const PlacedLeaf& a, const PlacedLeaf& b) {
  return joined(LeafFaces(a), LeafFaces(b));
}

struct LeafTurn {
  /// s_i W_i row by row: radians of turn about each axis for a move of one cell along each axis.
  std::array<float, 9> per_cell{};

  /// The turn from the leaf's centre to the point at `offset` from it, in cells, as a rotation vector.
  Vector3 towards(const Vector3& offset) const {
    const auto& [x, y, z] = offset;
    const auto& w = per_cell;
    return {w[0] * x + w[1] * y + w[2] * z, w[3] * x + w[4] * y + w[5] * z, w[6] * x + w[7] * y + w[8] * z};
  }
};

/// The least-squares turn of the leaf in the middle of `around`, i: over the leaves j it is joined to, the
/// sum of (face area / distance) |W_i (c_j - c_i) - w_ij|^2 is least, w_ij the smallest turn that takes frame
/// i to frame j. Along directions in which there is no neighbour W_i is 0.
LeafTurn leaf_turn(const LeafField& field, const LeafSurroundings& around);

}  // namespace crossgrain
