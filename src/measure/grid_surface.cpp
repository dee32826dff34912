// SPDX-License-Identifier: Apache-2.0
#include "measure/grid_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "singularity/surface_hexahedra.hpp"

namespace crossgrain {
namespace {

/// Votes along a crease: one every few cells, so that the number of samples follows the cells and not the
/// triangles.
constexpr double kVoteCells = 2;

/// Largest angle between consecutive samples around a crease.
constexpr double kStepDeg = 20;

/// Frames are sampled a quarter of a step off the faces, inside the solid.
constexpr double kOffFaces = 0.25;

class CreaseSampler {
 public:
  CreaseSampler(const SolidSurface& surface, const Sampler& sampler, double cell_size)
      : surface_(surface), sampler_(sampler), cell_size_(cell_size) {}

  std::vector<CreaseVote> operator()(const SolidCrease& crease) const {
    std::vector<CreaseVote> votes;
    const double step = kVoteCells * cell_size_;
    double since_last = step;
    for (const SolidCrease::Edge& edge : crease.edges) {
      since_last += edge.length;
      if (since_last < step) continue;
      const int parts = std::max(1, static_cast<int>(edge.length / step));
      for (int part = 0; part < parts; ++part)
        votes.push_back({turns_at(edge, (part + 0.5) / parts), since_last / parts});
      since_last = 0;
    }
    return votes;
  }

 private:
  int turns_at(const SolidCrease::Edge& edge, double along_share) const {
    const Vector3 &a = surface_.vertices[edge.ends[0]], &b = surface_.vertices[edge.ends[1]];
    const Vector3 along = normalised(b - a), place = a + along_share * (b - a);
    const std::array normals{normal_of(surface_, edge.triangles[0]), normal_of(surface_, edge.triangles[1])};
    // The solid lies from the first face's direction towards its inward normal.
    const Vector3 in_face = cross(normals[0], -1.0 * along);
    const int steps = std::max(2, static_cast<int>(std::ceil(edge.angle_deg / kStepDeg)));
    std::vector<Quaternion> way;
    for (int k = 0; k <= steps; ++k) {
      const double turn = (kOffFaces + k * (steps - 2 * kOffFaces) / steps) / steps * edge.angle_deg;
      const double angle = turn * std::numbers::pi / 180;
      way.push_back(
          sampler_.at(place + cell_size_ * (std::cos(angle) * in_face - std::sin(angle) * normals[0])).frame);
    }
    return quarter_turns(way, normals, along, edge.angle_deg);
  }

  const SolidSurface& surface_;
  const Sampler& sampler_;
  double cell_size_;
};

}  // namespace

void add_grid_surface(const SolvedSurface& solved, const Sampler& sampler, double cell_size,
                      const SingularityGraph& graph, const SingularityOptions& options,
                      SolveReport::Singularity& summary) {
  const SolidSurface surface{solved.vertices, solved.triangles};
  add_surface(surface, solid_creases(surface, options.sharp_deg, options.bend_deg),
              CreaseSampler(surface, sampler, cell_size), {[&](std::uint32_t) { return cell_size; }, false},
              graph, options, summary);
}

}  // namespace crossgrain
