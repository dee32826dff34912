// SPDX-License-Identifier: Apache-2.0
// The solids of a shape, and the faces that belong to no solid.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <vector>

#include "cad_reading/cad_reading.hpp"
#include "crossgrain/warning.hpp"

namespace crossgrain {

/// A connected set of faces.
struct Body {
  TopoDS_Shape shape;  ///< a solid or a shell
  bool closed;         ///< true if it has a volume and an outside
  std::int32_t solid;  ///< its number in TriangleMesh::solids, ascending; pieces of one solid share it
};

struct Bodies {
  TopoDS_Shape whole;        ///< all bodies
  std::vector<Body> bodies;  ///< solids, in the order of TopExp::MapShapes; then shells of no solid

  /// All distinct faces and edges of `whole`, counted from 1.
  TopTools_IndexedMapOfShape faces, edges;

  /// For each of `faces` its 1-based place in TopExp::MapShapes over the original shape, the first for a face
  /// that was glued; it differs from that in `faces` only if faces were sewn or glued. Entry 0 is unused.
  std::vector<std::int32_t> face_numbers;

  std::vector<Warning> warnings;
};

/// Returns the bodies of a shape. Faces of no solid are sewn together if their edges are within 1e-5 of the
/// longest side, since files often contain a solid only as its faces. With ReadOptions::glue, solids share
/// the faces where they touch. Solids and shells that are there twice are left out, with a warning
/// (distinct_bodies.hpp). Throws Fault if there is no face, or the solids cannot be glued.
Bodies find_bodies(const TopoDS_Shape& shape, const CadReading& options);

/// Upper bound of the longest side of a shape's box; 0 for an empty shape. Throws Fault if the shape is
/// infinite.
double longest_side_at_most(const TopoDS_Shape& shape);

}  // namespace crossgrain
