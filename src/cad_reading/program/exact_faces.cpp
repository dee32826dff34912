// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/exact_faces.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <map>
#include <set>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

FaceKind kind_of(const TopoDS_Face& face) {
  const bool within_bounds = false;
  switch (BRepAdaptor_Surface(face, within_bounds).GetType()) {
    case GeomAbs_Plane:
      return FaceKind::kPlane;
    case GeomAbs_Cylinder:
      return FaceKind::kCylinder;
    case GeomAbs_Cone:
      return FaceKind::kCone;
    case GeomAbs_Sphere:
      return FaceKind::kSphere;
    case GeomAbs_Torus:
      return FaceKind::kTorus;
    case GeomAbs_BezierSurface:
    case GeomAbs_BSplineSurface:
      return FaceKind::kSpline;
    case GeomAbs_SurfaceOfRevolution:
      return FaceKind::kRevolution;
    case GeomAbs_SurfaceOfExtrusion:
      return FaceKind::kExtrusion;
    case GeomAbs_OffsetSurface:
      return FaceKind::kOffset;
    default:
      return FaceKind::kOther;
  }
}

/// The bodies that a face bounds.
struct Uses {
  std::size_t bodies = 0;
  std::set<std::int32_t> solids;

  /// Whether it lies between pieces of one solid.
  bool is_within_solid() const { return bodies > solids.size(); }
};

/// Entry k is that of the face of number k in Bodies::faces; entry 0 is unused.
std::vector<Uses> uses_of_faces(const Bodies& bodies) {
  std::vector<Uses> uses(static_cast<std::size_t>(bodies.faces.Extent()) + 1);
  for (const Body& body : bodies.bodies) {
    TopTools_IndexedMapOfShape seen;
    for (TopExp_Explorer faces(body.shape, TopAbs_FACE); faces.More(); faces.Next()) {
      const TopoDS_Shape& face = faces.Current();
      if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) continue;
      const int before = seen.Extent();
      if (seen.Add(face) <= before) continue;
      Uses& of_face = uses[static_cast<std::size_t>(bodies.faces.FindIndex(face))];
      ++of_face.bodies;
      of_face.solids.insert(body.solid);
    }
  }
  return uses;
}

/// Area and centroid; both 0 if they cannot be computed.
ModelFace measured(const TopoDS_Face& face) {
  ModelFace result;
  result.kind = kind_of(face);
  try {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    const double area = std::abs(properties.Mass());
    const gp_Pnt centre = properties.CentreOfMass();
    const Vector3 place{centre.X(), centre.Y(), centre.Z()};
    if (!std::isfinite(area) || !std::isfinite(dot(place, place))) return result;
    result.area = area;
    result.centre = place;
  } catch (const Standard_Failure&) {
    // A face with damaged bounds: the model can still be meshed.
  }
  return result;
}

/// 0 if it cannot be computed.
double volume_of(const std::vector<Body>& bodies) {
  double volume = 0;
  try {
    for (const Body& body : bodies) {
      if (!body.closed) continue;
      GProp_GProps properties;
      BRepGProp::VolumeProperties(body.shape, properties);
      volume += std::abs(properties.Mass());
    }
  } catch (const Standard_Failure&) {
    return 0;
  }
  return std::isfinite(volume) ? volume : 0;
}

/// Adds a part of a face that has been cut.
void add(const ModelFace& part, ModelFace& whole) {
  const double area = whole.area + part.area;
  if (area > 0) whole.centre = (1 / area) * (whole.area * whole.centre + part.area * part.centre);
  whole.area = area;
  if (part.solids == 1) whole.solids = 1;
}

}  // namespace

ExactFaces exact_faces(const Bodies& bodies) {
  const std::vector<Uses> uses = uses_of_faces(bodies);
  std::map<std::int32_t, ModelFace> by_number;
  ExactFaces result;
  bool all_known = true;
  for (int place = 1; place <= bodies.faces.Extent(); ++place) {
    const Uses& its_uses = uses[static_cast<std::size_t>(place)];
    if (its_uses.is_within_solid()) continue;
    ModelFace face = measured(TopoDS::Face(bodies.faces(place)));
    face.number = bodies.face_numbers[static_cast<std::size_t>(place)];
    face.solids = static_cast<std::uint32_t>(its_uses.solids.size());
    all_known = all_known && face.area > 0;
    if (face.solids == 1) result.size.area += face.area;
    const auto [known, is_new] = by_number.try_emplace(static_cast<std::int32_t>(face.number), face);
    if (!is_new) add(face, known->second);
  }
  for (const auto& [number, face] : by_number) result.faces.push_back(face);
  result.size.volume = volume_of(bodies.bodies);
  if (!all_known || result.size.volume == 0) result.size = {};
  return result;
}

}  // namespace crossgrain
