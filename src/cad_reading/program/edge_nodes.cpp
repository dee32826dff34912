// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/edge_nodes.hpp"

#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <limits>

#include "cad_reading/program/fault.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace

EdgeNodes::EdgeNodes(const Bodies& bodies)
    : bodies_(bodies), lines_(static_cast<std::size_t>(bodies.edges.Extent()) + 1) {
  TopExp::MapShapes(bodies.whole, TopAbs_VERTEX, ends_);
  end_vertices_.assign(static_cast<std::size_t>(ends_.Extent()) + 1, kNone);
}

std::uint32_t EdgeNodes::add(const gp_Pnt& point) {
  const Vector3 position{point.X(), point.Y(), point.Z()};
  for (const double coordinate : position) {
    if (!std::isfinite(coordinate)) throw Fault("has a point at infinity");
  }
  if (positions_.size() >= kNone)
    throw Fault("needs more than 4294967295 vertices", Remedy::kLowerResolution);
  positions_.push_back(position);
  return static_cast<std::uint32_t>(positions_.size() - 1);
}

std::uint32_t EdgeNodes::end_vertex(const TopoDS_Shape& vertex, const gp_Pnt& point) {
  const int place = vertex.IsNull() ? 0 : ends_.FindIndex(vertex);
  if (place == 0) return add(point);
  std::uint32_t& known = end_vertices_[static_cast<std::size_t>(place)];
  if (known == kNone) known = add(point);
  return known;
}

std::vector<std::uint32_t> EdgeNodes::vertices_of(const TopoDS_Face& face,
                                                  const Handle(Poly_Triangulation) & mesh,
                                                  const TopLoc_Location& location) {
  const auto point = [&](int node) { return mesh->Node(node).Transformed(location); };
  std::vector<std::uint32_t> vertices(static_cast<std::size_t>(mesh->NbNodes()) + 1, kNone);
  // Forward, so that the orientation of a seam's edges tells which of its two sides is meant.
  const TopoDS_Shape forward = face.Oriented(TopAbs_FORWARD);
  for (TopExp_Explorer edges(forward, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    const Handle(Poly_PolygonOnTriangulation) polygon =
        BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
    if (polygon.IsNull()) continue;
    const int count = polygon->NbNodes();
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    if (BRep_Tool::Degenerated(edge)) {
      const std::uint32_t tip = end_vertex(first, point(polygon->Node(1)));
      for (int i = 1; i <= count; ++i) vertices[static_cast<std::size_t>(polygon->Node(i))] = tip;
      continue;
    }
    Line& line = lines_[static_cast<std::size_t>(bodies_.edges.FindIndex(edge))];
    if (line.vertices.empty()) {
      for (int i = 1; i <= count; ++i) {
        const gp_Pnt here = point(polygon->Node(i));
        line.vertices.push_back(i == 1       ? end_vertex(first, here)
                                : i == count ? end_vertex(last, here)
                                             : add(here));
        if (polygon->HasParameters()) line.parameters.push_back(polygon->Parameter(i));
      }
    }
    // Otherwise the edge was cut differently for an earlier face, and equal coordinates are merged later.
    if (line.vertices.size() != static_cast<std::size_t>(count)) continue;
    for (int i = 1; i <= count; ++i)
      vertices[static_cast<std::size_t>(polygon->Node(i))] = line.vertices[static_cast<std::size_t>(i - 1)];
  }
  for (int node = 1; node <= mesh->NbNodes(); ++node) {
    std::uint32_t& vertex = vertices[static_cast<std::size_t>(node)];
    if (vertex == kNone) vertex = add(point(node));
  }
  return vertices;
}

}  // namespace crossgrain
