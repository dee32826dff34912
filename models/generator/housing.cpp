// SPDX-License-Identifier: Apache-2.0
#include "parts.hpp"
#include "solid.hpp"

namespace crossgrain::models {
namespace {

constexpr double kLength = 110, kDepth = 70, kHeight = 44;
constexpr double kWall = 3;
constexpr double kCornerRadius = 10;

/// The box inset by `inset` on its sides and its floor, with its upright edges and its floor rounded.
TopoDS_Shape rounded_box(double inset) {
  TopoDS_Shape solid = box({inset, inset, inset}, {kLength - inset, kDepth - inset, kHeight});
  solid = fillet(solid, kCornerRadius - inset, "upright edges of the housing", [](const EdgeFacts& edge) {
    return edge.along({0, 0, 1});
  });
  return fillet(solid, 5 - inset, "edges of the floor",
                [&](const EdgeFacts& edge) { return edge.middle.Z() < inset + 1e-6; });
}

/// Everything above the rim, which falls from the left to the right.
TopoDS_Shape above_rim() {
  return prism({{-1, -1, 44}, {kLength + 1, -1, 30}, {kLength + 1, -1, 60}, {-1, -1, 60}},
               {0, kDepth + 2, 0});
}

}  // namespace

TopoDS_Shape housing() {
  const gp_Dir up(0, 0, 1);
  const double floor = kWall / 2, boss_top = 24, boss_radius = 5, screw_radius = 1.75;
  std::vector<TopoDS_Shape> solids{cut(rounded_box(0), {rounded_box(kWall)})};
  std::vector<TopoDS_Shape> tools{above_rim()};
  for (const gp_Pnt& centre :
       {gp_Pnt(16, 16, floor), gp_Pnt(94, 16, floor), gp_Pnt(16, 54, floor), gp_Pnt(78, 54, floor)}) {
    solids.push_back(cylinder(centre, up, boss_radius, boss_top - floor));
    tools.push_back(cylinder(centre.Translated(gp_Vec(0, 0, 8)), up, screw_radius, boss_top));
  }
  tools.push_back(cylinder({-1, 42, 21}, {1, 0, 0}, 8, 2 * kWall));  // for a cable, in the left wall
  for (int i = 0; i < 4; ++i) {                                      // slots to let air in, in the floor
    const double x = 38 + 10 * i;
    tools.push_back(box({x, 22, -1}, {x + 4, 48, 2 * kWall}));
  }
  return cut(fuse(solids), tools);
}

}  // namespace crossgrain::models
