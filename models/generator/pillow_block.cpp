// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "parts.hpp"
#include "solid.hpp"

namespace crossgrain::models {
namespace {

constexpr double kLength = 160, kDepth = 44, kBase = 16;
constexpr double kAxisHeight = 46, kOuterRadius = 30;

/// A slot along x, through the base.
TopoDS_Shape slot(double centre_x) {
  const double half = 7, radius = 6, y = kDepth / 2;
  const gp_Dir up(0, 0, 1);
  return fuse({cylinder({centre_x - half, y, 0}, up, radius, kBase),
               cylinder({centre_x + half, y, 0}, up, radius, kBase),
               box({centre_x - half, y - radius, 0}, {centre_x + half, y + radius, kBase})});
}

TopoDS_Shape base() {
  return fillet(box({0, 0, 0}, {kLength, kDepth, kBase}), 9, "corners of the base",
                [](const EdgeFacts& edge) {
                  return edge.along({0, 0, 1});
                });
}

/// The ring around the bearing and the flanks, tangent to it, that carry it.
TopoDS_Shape body() {
  const double x = kLength / 2, front = 4, depth = 36;
  const double lean = 0.25;  // angle of the flanks from the vertical, rad
  const double tangent_x = kOuterRadius * std::cos(lean),
               tangent_z = kAxisHeight + kOuterRadius * std::sin(lean);
  const double foot_x = tangent_x + (tangent_z - kBase) * std::tan(lean);
  const TopoDS_Shape flanks = prism({{x - foot_x, front, kBase},
                                     {x + foot_x, front, kBase},
                                     {x + tangent_x, front, tangent_z},
                                     {x - tangent_x, front, tangent_z}},
                                    {0, depth, 0});
  return fuse({flanks, cylinder({x, front, kAxisHeight}, {0, 1, 0}, kOuterRadius, depth)});
}

}  // namespace

TopoDS_Shape pillow_block() {
  TopoDS_Shape solid = fuse({base(), body()});
  solid = fillet(solid, 3, "feet of the flanks", [](const EdgeFacts& edge) {
    const gp_Pnt& p = edge.middle;
    const bool on_base = std::abs(p.Z() - kBase) < 1e-6;
    return on_base && edge.straight && p.X() > 20 && p.X() < kLength - 20 && p.Y() > 1 && p.Y() < kDepth - 1;
  });
  const double x = kLength / 2;
  const gp_Dir back(0, 1, 0), up(0, 0, 1);
  return cut(solid,
             {cylinder({x, 0, kAxisHeight}, back, 17, kDepth), cylinder({x, 0, kAxisHeight}, back, 22, 10),
              cylinder({x, 26, kAxisHeight}, up, 3, 40), slot(21), slot(kLength - 21)});
}

}  // namespace crossgrain::models
