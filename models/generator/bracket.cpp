// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "parts.hpp"
#include "solid.hpp"

namespace crossgrain::models {
namespace {

constexpr double kPlate = 14;                    // thickness of the base plate
constexpr double kFront = 30, kBack = 46;        // the upright, in y
constexpr double kRibLeft = 74, kRibRight = 86;  // the rib, in x
constexpr double kDepth = 90;

bool near(double a, double b) {
  return std::abs(a - b) < 1e-6;
}

TopoDS_Shape base_plate() {
  // The right end leans inwards.
  const TopoDS_Shape plate =
      prism({{0, 0, 0}, {124, 0, 0}, {114, 0, kPlate}, {0, 0, kPlate}}, {0, kDepth, 0});
  return fillet(plate, 10, "corners of the base plate", [](const EdgeFacts& edge) {
    return edge.along({0, 0, 1});
  });
}

TopoDS_Shape upright() {
  const TopoDS_Shape wall =
      prism({{24, kFront, kPlate}, {106, kFront, kPlate}, {78, kFront, 86}, {24, kFront, 86}},
            {0, kBack - kFront, 0});
  return fillet(wall, 12, "top of the upright", [](const EdgeFacts& edge) {
    return edge.along({0, 1, 0}) && edge.middle.Z() > kPlate + 1;
  });
}

TopoDS_Shape rib() {
  return prism({{kRibLeft, kBack, kPlate}, {kRibLeft, 80, kPlate}, {kRibLeft, kBack, 52}},
               {kRibRight - kRibLeft, 0, 0});
}

/// The concave edges: where the upright stands on the plate and where the rib meets both.
bool is_concave(const EdgeFacts& edge) {
  const gp_Pnt& p = edge.middle;
  const bool under_upright =
      near(p.Z(), kPlate) && edge.along({1, 0, 0}) && (near(p.Y(), kFront) || near(p.Y(), kBack));
  const bool beside_rib = near(p.X(), kRibLeft) || near(p.X(), kRibRight);
  const bool at_rib = beside_rib && ((near(p.Z(), kPlate) && edge.along({0, 1, 0})) ||
                                     (near(p.Y(), kBack) && edge.along({0, 0, 1})));
  return under_upright || at_rib;
}

}  // namespace

TopoDS_Shape bracket() {
  const gp_Dir up(0, 0, 1), back(0, 1, 0);
  const TopoDS_Shape boss = cylinder({48, 22, 60}, back, 22, kFront - 22);
  TopoDS_Shape solid = fuse({base_plate(), upright(), rib()});
  solid = fillet(solid, 5, "feet of the upright and the rib", is_concave);
  solid = fuse({solid, boss});
  return cut(solid, {cylinder({48, 0, 60}, back, 15, kDepth), cylinder({14, 14, 0}, up, 5.5, kPlate),
                     cylinder({100, 13, 0}, up, 5.5, kPlate), cylinder({17, 72, 0}, up, 7, kPlate),
                     cylinder({104, 70, 0}, up, 5.5, kPlate)});
}

}  // namespace crossgrain::models
