// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <cstdint>
#include <vector>

#include "cad_reading/program/bodies.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Numbers the nodes of the triangulations of faces such that faces share nodes on common edges, even if
/// their coordinates differ by rounding.
class EdgeNodes {
 public:
  explicit EdgeNodes(const Bodies& bodies);

  /// Returns the vertex of each node of a face's triangulation, from 1; entry 0 is unused.
  std::vector<std::uint32_t> vertices_of(const TopoDS_Face& face, const Handle(Poly_Triangulation) & mesh,
                                         const TopLoc_Location& location);

  /// An edge as a polyline of vertices, by increasing parameter; empty if no face with it was meshed.
  struct Line {
    std::vector<std::uint32_t> vertices;
    std::vector<double> parameters;
  };
  const Line& line(int edge) const { return lines_[static_cast<std::size_t>(edge)]; }

  /// Coordinates of all vertices so far.
  const std::vector<Vector3>& positions() const { return positions_; }

 private:
  std::uint32_t add(const gp_Pnt& point);
  std::uint32_t end_vertex(const TopoDS_Shape& vertex, const gp_Pnt& point);

  const Bodies& bodies_;
  TopTools_IndexedMapOfShape ends_;
  std::vector<std::uint32_t> end_vertices_;  ///< of `ends_`, from 1
  std::vector<Line> lines_;                  ///< of the edges of the bodies, from 1
  std::vector<Vector3> positions_;
};

}  // namespace crossgrain
