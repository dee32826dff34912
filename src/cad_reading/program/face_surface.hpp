// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt2d.hxx>
#include <optional>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The exact surface of a face, for its normals.
class FaceSurface {
 public:
  /// `size` is that of the model; what is much smaller counts as a point.
  FaceSurface(const TopoDS_Face& face, double size);

  /// Returns the unit vector along the product of the derivatives by u and v, which is the outward normal of
  /// a face of orientation FORWARD. None if the surface degenerates to a point there, as at the apex of a
  /// cone.
  std::optional<Vector3> normal_at(const gp_Pnt2d& uv) const;

  /// Returns the normal next to `uv`, where the surface degenerates to a point: on the line of u or v from
  /// there to `towards`.
  std::optional<Vector3> normal_beside(const gp_Pnt2d& uv, const gp_Pnt2d& towards) const;

 private:
  struct Derivatives {
    Vector3 by_u, by_v;
    bool u_is_point, v_is_point;  ///< derivative by u or v is zero
  };
  Derivatives derivatives_at(const gp_Pnt2d& uv) const;

  BRepAdaptor_Surface surface_;
  double u_span_, v_span_;
  double smallest_;  ///< a derivative counts as zero if its length times the range of u or v is at most this
};

}  // namespace crossgrain
