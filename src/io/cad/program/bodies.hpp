// SPDX-License-Identifier: Apache-2.0
// The solids of a shape, and the faces that belong to no solid.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/warning.hpp"

namespace crossgrain {

/// A connected set of faces.
struct Body {
  TopoDS_Shape shape;  ///< a solid or a shell
  bool closed;         ///< true if it has a volume and an outside
};

struct Bodies {
  TopoDS_Shape whole;        ///< all bodies
  std::vector<Body> bodies;  ///< solids, in the order of TopExp::MapShapes; then shells of no solid

  /// All distinct faces and edges of `whole`, counted from 1.
  TopTools_IndexedMapOfShape faces, edges;

  /// For each of `faces` its 1-based place in TopExp::MapShapes over the original shape; it differs from that
  /// in `faces` only if faces were sewn. Entry 0 is unused.
  std::vector<std::int32_t> face_numbers;

  std::vector<Warning> warnings;
};

/// Returns the bodies of a shape. Faces of no solid are sewn together if their edges are within 1e-5 of the
/// longest side, since files often contain a solid only as its faces. Throws Fault if there is no face.
Bodies find_bodies(const TopoDS_Shape& shape);

/// Upper bound of the longest side of a shape's box; 0 for an empty shape. Throws Fault if the shape is
/// infinite.
double longest_side_at_most(const TopoDS_Shape& shape);

}  // namespace crossgrain
