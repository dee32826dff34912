// SPDX-License-Identifier: Apache-2.0
// Solids cut along each other's faces, so that they share the faces where they touch.
#pragma once

#include <BOPAlgo_Builder.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <vector>

namespace crossgrain {

/// The general fuse of solids, by BOPAlgo_Builder.
class GluedSolids {
 public:
  /// A solid of the result, and the number of the solid that it is a part of: of several, where these
  /// overlap, the smallest.
  struct Piece {
    TopoDS_Shape solid;
    std::size_t number;
  };

  /// Glues faces at most `gap` apart, model units. Throws Fault if OpenCASCADE cannot, or changes a volume.
  GluedSolids(const std::vector<TopoDS_Shape>& solids, double gap);

  /// In the order of their numbers.
  const std::vector<Piece>& pieces() const { return pieces_; }

  /// Returns what has become of a solid or face.
  std::vector<TopoDS_Shape> parts_of(const TopoDS_Shape& shape);

 private:
  BOPAlgo_Builder builder_;
  std::vector<Piece> pieces_;
};

}  // namespace crossgrain
