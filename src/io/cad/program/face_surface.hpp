// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt2d.hxx>
#include <optional>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The true surface of a face, for its normals.
class FaceSurface {
 public:
  /// `size`: of the model; what is much smaller counts as a point.
  FaceSurface(const TopoDS_Face& face, double size);

  /// The unit vector along the product of the derivatives by u and by v, the outward normal of a face of
  /// orientation FORWARD. None where the surface comes together in a point, as at the apex of a cone.
  std::optional<Vector3> normal_at(const gp_Pnt2d& uv) const;

  /// The same just beside `uv`, where the surface comes together in a point: on the line of u or v that
  /// leads from that point to `towards`.
  std::optional<Vector3> normal_beside(const gp_Pnt2d& uv, const gp_Pnt2d& towards) const;

 private:
  struct Derivatives {
    Vector3 by_u, by_v;
    bool u_is_point, v_is_point;  ///< the surface stands still along u or v
  };
  Derivatives derivatives_at(const gp_Pnt2d& uv) const;

  BRepAdaptor_Surface surface_;
  double u_span_, v_span_;
  double smallest_;  ///< how far the surface must go over the face in u and in v, at the speed at a point
};

}  // namespace crossgrain
