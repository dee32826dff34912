// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/sharp_edges.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Vec.hxx>
#include <map>
#include <numbers>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Places along an edge where the surfaces on both sides are compared; none at its ends, where surfaces may
/// degenerate to a point. An edge that is sharp on less than a seventh of its length may be missed.
constexpr int kPlaces = 7;

double cosine_of_degrees(double angle_deg) {
  return std::cos(angle_deg * std::numbers::pi / 180);
}

/// Tangents of the curve at the points of a polyline; those of the polyline if the curve's derivative is
/// zero.
std::vector<Vector3> tangents_of(const TopoDS_Edge& edge, const std::vector<double>& parameters,
                                 const std::vector<Vector3>& points) {
  const BRepAdaptor_Curve curve(edge);
  std::vector<Vector3> tangents;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, points.size() - 1);
    Vector3 tangent{0, 0, 0};
    if (parameters.size() == points.size()) {
      gp_Pnt point;
      gp_Vec derivative;
      curve.D1(parameters[i], point, derivative);
      tangent = normalised({derivative.X(), derivative.Y(), derivative.Z()});
    }
    if (!(norm(tangent) > 0.5)) tangent = normalised(points[after] - points[before]);
    tangents.push_back(tangent);
  }
  return tangents;
}

}  // namespace

SharpEdges::SharpEdges(const Bodies& bodies, const std::vector<FaceSurface>& surfaces,
                       double crease_angle_deg)
    : bodies_(bodies),
      surfaces_(surfaces),
      smallest_cosine_(cosine_of_degrees(crease_angle_deg)),
      sharp_(static_cast<std::size_t>(bodies.edges.Extent()) + 1) {}

bool SharpEdges::is_sharp(const std::vector<Side>& sides) const {
  for (int place = 0; place < kPlaces; ++place) {
    std::vector<Vector3> normals;
    for (const Side& side : sides) {
      double first, last;
      const TopoDS_Face face = TopoDS::Face(bodies_.faces(side.face).Oriented(TopAbs_FORWARD));
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(side.edge, face, first, last);
      if (curve.IsNull()) continue;
      const gp_Pnt2d uv = curve->Value(first + (place + 0.5) / kPlaces * (last - first));
      if (const auto normal = surfaces_[static_cast<std::size_t>(side.face)].normal_at(uv))
        normals.push_back(side.sign * *normal);
    }
    for (std::size_t a = 0; a < normals.size(); ++a) {
      for (std::size_t b = a + 1; b < normals.size(); ++b) {
        if (dot(normals[a], normals[b]) < smallest_cosine_) return true;
      }
    }
  }
  return false;
}

void SharpEdges::add(const TopoDS_Shape& body, bool inside_out) {
  std::map<int, std::vector<Side>> sides;
  for (TopExp_Explorer faces(body, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Shape& face = faces.Current();
    if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) continue;
    const double sign = (face.Orientation() == TopAbs_REVERSED) != inside_out ? -1 : 1;
    const int number = bodies_.faces.FindIndex(face);
    for (TopExp_Explorer edges(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
      if (!BRep_Tool::Degenerated(edge)) sides[bodies_.edges.FindIndex(edge)].push_back({edge, number, sign});
    }
  }
  for (const auto& [edge, of_edge] : sides) {
    if (!sharp_[static_cast<std::size_t>(edge)] && of_edge.size() > 1)
      sharp_[static_cast<std::size_t>(edge)] = is_sharp(of_edge);
  }
}

std::vector<CreaseCurve> SharpEdges::creases(const EdgeNodes& nodes) const {
  std::vector<CreaseCurve> creases;
  for (int number = 1; number <= bodies_.edges.Extent(); ++number) {
    const EdgeNodes::Line& line = nodes.line(number);
    if (!sharp_[static_cast<std::size_t>(number)] || line.vertices.size() < 2) continue;
    CreaseCurve crease;
    for (const std::uint32_t vertex : line.vertices) crease.points.push_back(nodes.positions()[vertex]);
    crease.tangents = tangents_of(TopoDS::Edge(bodies_.edges(number)), line.parameters, crease.points);
    crease.tag = number;
    creases.push_back(std::move(crease));
  }
  return creases;
}

}  // namespace crossgrain
