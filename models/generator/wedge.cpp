// SPDX-License-Identifier: Apache-2.0
#include "parts.hpp"
#include "solid.hpp"

namespace crossgrain::models {

TopoDS_Shape wedge() {
  const double depth = 50;
  TopoDS_Shape solid = prism({{0, 0, 0}, {90, 0, 0}, {90, 0, 14}, {20, 0, 60}, {0, 0, 60}}, {0, depth, 0});
  solid = fillet(solid, 8, "upright edges of the back", [](const EdgeFacts& edge) {
    return edge.along({0, 0, 1}) && edge.middle.X() < 1;
  });
  solid = fillet(solid, 6, "top edge of the slanted face", [](const EdgeFacts& edge) {
    return edge.along({0, 1, 0}) && edge.middle.Z() > 59 && edge.middle.X() > 1;
  });
  solid = chamfer(solid, 3, "edge of the toe", [](const EdgeFacts& edge) {
    return edge.along({0, 0, 1}) && edge.middle.X() > 89;
  });

  const gp_Dir inwards(-46, 0, -70);  // square to the slanted face
  const gp_Pnt mouth = gp_Pnt(55, 29, 37).Translated(-1.0 * gp_Vec(inwards));
  return cut(solid, {cylinder({20, 0, 26}, {0, 1, 0}, 11, depth), cylinder(mouth, inwards, 6, 90),
                     cone(mouth, inwards, 13, 6, 7)});
}

}  // namespace crossgrain::models
