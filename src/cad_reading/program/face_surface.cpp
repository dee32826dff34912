// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/face_surface.hpp"

#include <BRepTools.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Relative to the model's size. At the apex of a cone and the pole of a sphere rounding leaves about 1e-16.
constexpr double kPoint = 1e-9;

/// If the sine of the angle between the derivatives is less, their product has no direction.
constexpr double kParallel = 1e-9;

/// Offset from a point as a share of the way: much more than kPoint, much less than the size of facets.
constexpr double kBeside = 1e-6;

Vector3 vector_of(const gp_Vec& v) {
  return {v.X(), v.Y(), v.Z()};
}

}  // namespace

FaceSurface::FaceSurface(const TopoDS_Face& face, double size) : surface_(face), smallest_(kPoint * size) {
  double u_low, u_high, v_low, v_high;
  BRepTools::UVBounds(face, u_low, u_high, v_low, v_high);
  u_span_ = u_high - u_low;
  v_span_ = v_high - v_low;
}

FaceSurface::Derivatives FaceSurface::derivatives_at(const gp_Pnt2d& uv) const {
  gp_Pnt point;
  gp_Vec by_u, by_v;
  surface_.D1(uv.X(), uv.Y(), point, by_u, by_v);
  return {vector_of(by_u), vector_of(by_v), by_u.Magnitude() * u_span_ <= smallest_,
          by_v.Magnitude() * v_span_ <= smallest_};
}

std::optional<Vector3> FaceSurface::normal_at(const gp_Pnt2d& uv) const {
  const Derivatives at = derivatives_at(uv);
  if (at.u_is_point || at.v_is_point) return std::nullopt;
  const Vector3 product = cross(normalised(at.by_u), normalised(at.by_v));
  if (!(norm(product) > kParallel)) return std::nullopt;
  return normalised(product);
}

std::optional<Vector3> FaceSurface::normal_beside(const gp_Pnt2d& uv, const gp_Pnt2d& towards) const {
  const Derivatives at = derivatives_at(uv);
  gp_XY beside = uv.XY() + kBeside * (towards.XY() - uv.XY());
  if (at.u_is_point) beside.SetX(towards.X());
  if (at.v_is_point) beside.SetY(towards.Y());
  return normal_at(beside);
}

}  // namespace crossgrain
