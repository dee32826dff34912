// SPDX-License-Identifier: Apache-2.0
// Chooses SingularityTuning::sign_cosine and sign_cells (docs/notes/verdict.md): how often an arc of known
// sense is said to change it, and how often a change is found.
//
//   sign_sweep
//
// Straight arcs in twenty directions through a grid of 32 cells a side. The axis of the rotation is oblique
// by a constant angle, so that hexahedra can have the arc; or it turns over by 180 degrees within a number of
// cells in its middle, so that they cannot.
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "field/made_grid.hpp"
#include "singularity/singular_edges.hpp"
#include "singularity/singularity_graph.hpp"

using namespace crossgrain;
using namespace crossgrain::testing;

namespace {

constexpr int kDepth = 5, kDirections = 20;

/// A quarter line whose axis at a distance along it is tilted from it by an angle.
struct TiltedLine {
  QuarterLine line;
  std::function<double(double)> tilt_rad;

  Quaternion operator()(const Vector3& p) const {
    const Vector3 across = orthogonal_unit(line.direction);
    const double tilt = tilt_rad(dot(p - line.point, line.direction));
    const Vector3 axis = std::cos(tilt) * line.direction + std::sin(tilt) * across;
    return from_rotation_vector(line.angle_rad(p) / 4 * axis) * with_axis_along({}, axis);
  }
};

std::vector<Vector3> directions() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Vector3> result;
  for (int k = 0; k < kDirections; ++k)
    result.push_back(normalised(Vector3{normal(random), normal(random), normal(random)}));
  return result;
}

std::vector<SingularEdges> lines_of(const std::function<double(double)>& tilt_rad) {
  const Octree tree = uniform_octree(kDepth);
  std::vector<SingularEdges> lines;
  for (const Vector3& direction : directions())
    lines.push_back(singular_grid_edges(
        tree, frames_of(tree, TiltedLine{{{0.52, 0.47, 0.51}, direction}, tilt_rad}), all_open(tree)));
  return lines;
}

/// Number of directions in which an arc changes its sense.
int changing(const std::vector<SingularEdges>& lines, double cosine, double cells) {
  SingularityTuning options;
  options.sign_cosine = cosine;
  options.sign_cells = cells;
  int count = 0;
  for (const SingularEdges& edges : lines) {
    bool changes = false;
    for (const auto& arc : singularity_graph(edges, options).arcs)
      changes |= arc.type == SingularityGraph::ArcType::kChanging;
    count += changes;
  }
  return count;
}

}  // namespace

int main() {
  constexpr double kDegree = std::numbers::pi / 180, kCell = 1.0 / (1 << kDepth);
  std::vector<std::vector<SingularEdges>> oblique, turning;
  for (const double degrees : {0., 45., 60., 70., 80., 85.})
    oblique.push_back(lines_of([=](double) { return degrees * kDegree; }));
  for (const double cells : {2., 4., 8., 12.}) {
    turning.push_back(lines_of([=](double along) {
      const double share = 0.5 + along / (cells * kCell);
      return std::numbers::pi * (share < 0 ? 0 : share > 1 ? 1 : share);
    }));
  }
  std::printf("arcs of %d that change their sense\n", kDirections);
  std::printf("  c    L | oblique by 0   45   60   70   80   85 | turning within 2    4    8   12 cells\n");
  for (const double cosine : {0., 0.1, 0.2, 0.3, 0.5}) {
    for (const double cells : {1., 2., 3., 4., 6.}) {
      std::printf("%.1f %4.0f |        ", cosine, cells);
      for (const auto& lines : oblique) std::printf("%5d", changing(lines, cosine, cells));
      std::printf(" |           ");
      for (const auto& lines : turning) std::printf("%5d", changing(lines, cosine, cells));
      std::printf("\n");
    }
  }
}
