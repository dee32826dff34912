// SPDX-License-Identifier: Apache-2.0
#include "measure/grid_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
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

/// Quarter circles around all creases, with the places at which frames vote.
class VotingPlaces {
 public:
  VotingPlaces(const SolidSurface& surface, const SolidCreases& creases, double cell_size)
      : surface_(surface), creases_(creases.creases), cell_size_(cell_size), begins_{0} {
    for (const SolidCrease& crease : creases_) {
      add(crease);
      begins_.push_back(circles_.size());
    }
  }

  const std::vector<Vector3>& places() const { return places_; }

  /// Returns the votes along one of the creases, given the frames at all places.
  std::vector<CreaseVote> votes(const SolidCrease& crease, std::span<const Quaternion> frames) const {
    const auto number = static_cast<std::size_t>(&crease - creases_.data());
    std::vector<CreaseVote> votes;
    for (std::size_t k = begins_[number]; k < begins_[number + 1]; ++k) {
      const Circle& circle = circles_[k];
      const SolidCrease::Edge& edge = crease.edges[circle.edge];
      const std::array normals{normal_of(surface_, edge.triangles[0]),
                               normal_of(surface_, edge.triangles[1])};
      const auto way = frames.subspan(circle.first, circle.count);
      votes.push_back({quarter_turns(way, normals, along(edge), edge.angle_deg), circle.length});
    }
    return votes;
  }

 private:
  struct Circle {
    std::size_t edge, first, count;  ///< of its crease; of its places
    double length;                   ///< along the crease that it votes for
  };

  Vector3 along(const SolidCrease::Edge& edge) const {
    return normalised(surface_.vertices[edge.ends[1]] - surface_.vertices[edge.ends[0]]);
  }

  void add(const SolidCrease& crease) {
    const double step = kVoteCells * cell_size_;
    double since_last = step;
    for (std::size_t e = 0; e < crease.edges.size(); ++e) {
      const SolidCrease::Edge& edge = crease.edges[e];
      since_last += edge.length;
      if (since_last < step) continue;
      const int parts = std::max(1, static_cast<int>(edge.length / step));
      for (int part = 0; part < parts; ++part) {
        const std::size_t first = places_.size();
        add_circle(edge, (part + 0.5) / parts);
        circles_.push_back({e, first, places_.size() - first, since_last / parts});
      }
      since_last = 0;
    }
  }

  void add_circle(const SolidCrease::Edge& edge, double along_share) {
    const Vector3 &a = surface_.vertices[edge.ends[0]], &b = surface_.vertices[edge.ends[1]];
    const Vector3 place = a + along_share * (b - a), normal = normal_of(surface_, edge.triangles[0]);
    // The solid lies from the first face's direction towards its inward normal.
    const Vector3 in_face = cross(normal, -1.0 * along(edge));
    const int steps = std::max(2, static_cast<int>(std::ceil(edge.angle_deg / kStepDeg)));
    for (int k = 0; k <= steps; ++k) {
      const double turn = (kOffFaces + k * (steps - 2 * kOffFaces) / steps) / steps * edge.angle_deg;
      const double angle = turn * std::numbers::pi / 180;
      places_.push_back(place + cell_size_ * (std::cos(angle) * in_face - std::sin(angle) * normal));
    }
  }

  const SolidSurface& surface_;
  const std::vector<SolidCrease>& creases_;
  double cell_size_;
  std::vector<Vector3> places_;
  std::vector<Circle> circles_;
  std::vector<std::size_t> begins_;  ///< of the circles of each crease, and the end
};

}  // namespace

void add_grid_surface(const SolvedSurface& solved, const PlaceSampler& sampler, double cell_size,
                      const SingularityGraph& graph, SolveReport::Singularity& summary) {
  const SolidSurface surface{solved.vertices, solved.triangles, solved.faces, solved.regions};
  const SolidCreases creases = solid_creases(surface);
  const VotingPlaces voting(surface, creases, cell_size);
  const std::vector<Quaternion> frames = sampler.frames_at(voting.places());
  add_surface(
      surface, creases, [&](const SolidCrease& crease) { return voting.votes(crease, frames); },
      {[&](std::uint32_t) { return cell_size; }, false}, graph, summary);
}

}  // namespace crossgrain
