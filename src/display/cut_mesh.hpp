// SPDX-License-Identifier: Apache-2.0
// The intersection of a field with a plane, as polygons with frames: one for each cell or tet.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/lists.hpp"
#include "base/quaternion.hpp"
#include "display/shown_field.hpp"
#include "singularity/axis_names.hpp"

namespace crossgrain {

/// The plane x[axis] = position.
struct CutPlane {
  std::size_t axis;
  double position;  ///< model units

  /// The two coordinates in the plane, so that together with `axis` they are right-handed.
  std::size_t across() const { return (axis + 1) % 3; }
  std::size_t up() const { return (axis + 2) % 3; }
};

/// Polygons of a plane through a field, with the frame of each and the sides that they share.
class CutMesh {
 public:
  struct Piece {
    std::uint32_t element;  ///< leaf or tet
    std::uint32_t first;    ///< first of its corners
    std::uint32_t count;    ///< number of its corners
    Vector3 middle;         ///< mean of the corners
    double size;            ///< square root of its area, model units
  };

  /// A side of two pieces through which the field goes on.
  struct Side {
    std::uint32_t a, b;  ///< pieces
    Vector3 from, to;
  };

  /// Cuts the leaves of a grid, or the tets. Polygons of leaves are whole squares, also where the surface
  /// passes through. A leaf or vertex that the plane only touches counts as below it.
  CutMesh(const ShownField& field, const CutPlane& plane);

  const CutPlane& plane() const { return plane_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Side>& sides() const { return sides_; }
  std::span<const Vector3> corners(const Piece& piece) const {
    return std::span(corners_).subspan(piece.first, piece.count);
  }

  const std::vector<Quaternion>& frames() const { return frames_; }

  std::optional<std::uint32_t> piece_at(const Vector3& point) const;

  /// Shared sides as links for name_axes.
  std::vector<FrameLink> links() const;

  /// The axes of all frames, named from the largest piece on.
  std::vector<AxisNames> named_axes() const;

  /// Lines across which the names disagree, smoothed: polylines of two or more points.
  std::vector<std::vector<Vector3>> seams(std::span<const AxisNames> names) const;

 private:
  void cut_leaves(const FieldData& field);
  void cut_tets(const TetSolid& solid, std::span<const Quaternion> frames);
  void add_piece(std::uint32_t element, const Quaternion& frame, std::span<const Vector3> corners);
  void sort_into_bins();
  bool contains(const Piece& piece, const Vector3& point) const;
  template <class Act>
  void for_each_bin(const Piece& piece, const Act& act) const;
  std::int64_t bin(double place, std::size_t side) const;

  CutPlane plane_;
  std::vector<Vector3> corners_;
  std::vector<Piece> pieces_;
  std::vector<Quaternion> frames_;
  std::vector<Side> sides_;

  // A raster over the plane: the pieces that meet each of its squares.
  std::array<double, 2> bin_low_{};
  double bin_size_ = 1;
  std::array<std::int64_t, 2> bin_count_{1, 1};
  Lists<std::uint32_t> binned_;
};

}  // namespace crossgrain
