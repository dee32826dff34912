// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/known_faces.hpp"

#include <BOPTools_AlgoTools3D.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>

namespace crossgrain {
namespace {

/// Points of a face that are looked at, along either parameter: a copy has all of them on other faces,
/// whatever else hardly one.
constexpr int kPointsAlong = 4;

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer explorer(shape, TopAbs_FACE); explorer.More(); explorer.Next())
    faces.push_back(TopoDS::Face(explorer.Current()));
  return faces;
}

/// Middles of the edges of a face that are no points.
std::vector<gp_Pnt> middles_of_edges(const TopoDS_Face& face) {
  std::vector<gp_Pnt> middles;
  for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More(); explorer.Next()) {
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(explorer.Current()), first, last);
    if (!curve.IsNull()) middles.push_back(curve->Value((first + last) / 2));
  }
  return middles;
}

}  // namespace

/// Looks through the faces whose boxes hold a point, until it is on one.
class KnownFaces::FacesAt : public BoxTree::Selector {
 public:
  FacesAt(const KnownFaces& known, const gp_Pnt& point) : known_(known), point_(point) {}

  Standard_Boolean Reject(const Bnd_Box& box) const override { return box.IsOut(point_); }
  Standard_Boolean Accept(const int& face) override {
    const TopoDS_Face& at = known_.faces_[static_cast<std::size_t>(face)];
    const bool is_on = known_.context_->IsValidPointForFace(point_, at, known_.tolerance_);
    myStop = is_on;
    return is_on;
  }

 private:
  const KnownFaces& known_;
  const gp_Pnt& point_;
};

void KnownFaces::add(const TopoDS_Shape& body) {
  for (const TopoDS_Face& face : faces_of(body)) {
    if (!shapes_.Add(face)) continue;
    Bnd_Box box;
    const bool use_triangulation = false;
    BRepBndLib::Add(face, box, use_triangulation);
    if (box.IsVoid()) continue;
    box.Enlarge(tolerance_);
    boxes_.Add(static_cast<int>(faces_.size()), box);
    faces_.push_back(face);
  }
}

bool KnownFaces::hold(const TopoDS_Shape& body) const {
  const std::vector<TopoDS_Face> faces = faces_of(body);
  return !faces_.empty() &&
         std::all_of(faces.begin(), faces.end(), [&](const TopoDS_Face& face) { return hold_face(face); });
}

bool KnownFaces::hold_face(const TopoDS_Face& face) const {
  if (shapes_.Contains(face)) return true;
  // One point tells nearly all faces that are no copies.
  gp_Pnt inside;
  gp_Pnt2d place;
  if (BOPTools_AlgoTools3D::PointInFace(face, inside, place, context_) != 0 || !hold_point(inside))
    return false;
  const std::vector<gp_Pnt> points = points_of(face);
  return std::all_of(points.begin(), points.end(), [&](const gp_Pnt& point) { return hold_point(point); });
}

bool KnownFaces::hold_point(const gp_Pnt& point) const {
  FacesAt at(*this, point);
  return boxes_.Select(at) > 0;
}

std::vector<gp_Pnt> KnownFaces::points_of(const TopoDS_Face& face) const {
  std::vector<gp_Pnt> points = middles_of_edges(face);
  const BRepAdaptor_Surface surface(face, /*restricted=*/false);
  double u_low = 0, u_high = 0, v_low = 0, v_high = 0;
  BRepTools::UVBounds(face, u_low, u_high, v_low, v_high);
  for (int i = 0; i < kPointsAlong; ++i) {
    for (int j = 0; j < kPointsAlong; ++j) {
      const double u = u_low + (i + 0.5) / kPointsAlong * (u_high - u_low);
      const double v = v_low + (j + 0.5) / kPointsAlong * (v_high - v_low);
      if (context_->IsPointInFace(face, gp_Pnt2d(u, v))) points.push_back(surface.Value(u, v));
    }
  }
  return points;
}

}  // namespace crossgrain
