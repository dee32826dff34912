// SPDX-License-Identifier: Apache-2.0
// A few words in which the parts of models/ are described; lengths are millimetres.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <utility>
#include <vector>

namespace crossgrain::models {

/// The axis-aligned box between two corners.
TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high);

/// The cylinder that starts at `base` and goes `height` along `direction`.
TopoDS_Shape cylinder(const gp_Pnt& base, const gp_Dir& direction, double radius, double height);

/// The frustum with radius `base_radius` at `base` and `top_radius` at the other end.
TopoDS_Shape cone(const gp_Pnt& base, const gp_Dir& direction, double base_radius, double top_radius,
                  double height);

/// The polygon `corners`, closed, swept by `sweep`.
TopoDS_Shape prism(const std::vector<gp_Pnt>& corners, const gp_Vec& sweep);

/// The union of solids, with faces that continue each other merged.
TopoDS_Shape fuse(const std::vector<TopoDS_Shape>& solids);

/// What of `solid` is in none of `tools`.
TopoDS_Shape cut(const TopoDS_Shape& solid, const std::vector<TopoDS_Shape>& tools);

/// What is known of an edge when edges are chosen.
struct EdgeFacts {
  gp_Pnt start, middle, end;
  bool straight;

  /// Straight and parallel to `direction`.
  bool along(const gp_Dir& direction) const;
};

/// The edges of a solid that `choice` takes.
std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& solid,
                                  const std::function<bool(const EdgeFacts&)>& choice);

/// Rounds the chosen edges. Throws std::runtime_error naming `what` where no edge is chosen or the fillet
/// fails.
TopoDS_Shape fillet(const TopoDS_Shape& solid, double radius, const char* what,
                    const std::function<bool(const EdgeFacts&)>& choice);

/// Cuts the chosen edges off at `distance` from each.
TopoDS_Shape chamfer(const TopoDS_Shape& solid, double distance, const char* what,
                     const std::function<bool(const EdgeFacts&)>& choice);

}  // namespace crossgrain::models
