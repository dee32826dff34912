// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "solid.hpp"

namespace crossgrain::models {
namespace {

constexpr double kFlange = 12, kRun = 150;
constexpr double kRunOuter = 27, kRunInner = 18;
constexpr double kBranchOuter = 20, kBranchInner = 12;
constexpr double kBranchLength = 85;

std::vector<TopoDS_Shape> bolt_holes() {
  const int count = 6;
  const double circle = 37, radius = 4.5;
  std::vector<TopoDS_Shape> holes;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / count;
    holes.push_back(
        cylinder({0, circle * std::cos(angle), circle * std::sin(angle)}, {1, 0, 0}, radius, kFlange));
  }
  return holes;
}

}  // namespace

TopoDS_Shape pipe_branch() {
  const gp_Dir along(1, 0, 0);
  const double lean = 55 * std::numbers::pi / 180;
  const gp_Dir aside(std::cos(lean), 0, std::sin(lean));
  const gp_Pnt fork(62, 0, 0);

  TopoDS_Shape solid =
      fuse({cylinder({0, 0, 0}, along, kRunOuter, kRun), cylinder(fork, aside, kBranchOuter, kBranchLength)});
  solid = fillet(solid, 6, "where the branch leaves the pipe", [&](const EdgeFacts& edge) {
    const bool at_an_end = edge.middle.X() < 1 || edge.middle.X() > kRun - 1;
    const bool on_run = std::abs(std::hypot(edge.middle.Y(), edge.middle.Z()) - kRunOuter) < 0.01;
    return !edge.straight && on_run && !at_an_end;
  });
  solid = fuse({solid, cylinder({0, 0, 0}, along, 46, kFlange)});
  solid = fillet(solid, 4, "neck of the flange", [](const EdgeFacts& edge) {
    return !edge.straight && std::abs(edge.middle.X() - kFlange) < 1e-6 &&
           std::hypot(edge.middle.Y(), edge.middle.Z()) < kRunOuter + 1;
  });
  std::vector<TopoDS_Shape> holes = bolt_holes();
  holes.push_back(fuse(
      {cylinder({0, 0, 0}, along, kRunInner, kRun), cylinder(fork, aside, kBranchInner, kBranchLength)}));
  return cut(solid, holes);
}

}  // namespace crossgrain::models
