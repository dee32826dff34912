// SPDX-License-Identifier: Apache-2.0
// The solids of a shape, and the faces that belong to none.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/warning.hpp"

namespace crossgrain {

/// Faces that bound something together.
struct Body {
  TopoDS_Shape shape;  ///< a solid or a shell
  bool closed;         ///< so that it has a volume, and a side that is outside
};

struct Bodies {
  TopoDS_Shape whole;        ///< all bodies
  std::vector<Body> bodies;  ///< solids, in the order of TopExp::MapShapes; then shells of no solid

  /// All faces and edges of `whole`, each once wherever it is used, counted from 1.
  TopTools_IndexedMapOfShape faces, edges;

  /// For each of `faces` its place in TopExp::MapShapes over the shape as read, from 1, which is that in
  /// `faces` unless faces were sewn. Of [0] there is no face.
  std::vector<std::int32_t> face_numbers;

  std::vector<Warning> warnings;
};

/// Faces of no solid are sewn together where their edges are as close as 1e-5 of the longest side: files
/// often hold a solid as nothing but its faces. Throws Fault where there is no face.
Bodies find_bodies(const TopoDS_Shape& shape);

/// The longest side of a box around a shape, which may be somewhat too large; 0 for an empty shape. Throws
/// Fault for one that has no end.
double longest_side_at_most(const TopoDS_Shape& shape);

}  // namespace crossgrain
