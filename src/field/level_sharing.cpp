// SPDX-License-Identifier: Apache-2.0
#include "field/level_sharing.hpp"

#include <array>
#include <bit>

#include "field/nested_solve.hpp"
#include "field/stages.hpp"

namespace crossgrain {
namespace {

/// Calls add(number) for all numbers of guides.
template <class Add>
void add_guides(const Guides& guides, const Add& add) {
  const auto add_vectors = [&](const auto& vectors) {
    for (const Vector3& vector : vectors)
      for (const double x : vector) add(x);
  };
  const auto add_all = [&](const auto& pieces, const auto& corners_of) {
    for (const auto& piece : pieces) {
      add_vectors(corners_of(piece));
      add_vectors(piece.directions);
    }
  };
  add_vectors(guides.corners);
  for (const auto* segments : {&guides.creases, &guides.segments}) {
    add_all(*segments, [](const GuideSegment& segment) { return segment.ends; });
    for (const GuideSegment& segment : *segments) add(segment.weight);
  }
  add_all(guides.faces, [](const GuideFace& face) { return face.corners; });
  for (const GuideFace& face : guides.faces) add(face.weight);
  add_all(guides.points, [](const GuidePoint& point) { return std::array<Vector3, 1>{point.place}; });
  for (const GuidePoint& point : guides.points) {
    for (const double weight : point.weights) add(weight);
    add(point.reach_cells);
  }
}

}  // namespace

std::uint64_t identity_of(const Solid& solid, const SolveTuning& options) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&hash](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
    hash ^= hash >> 29;
  };
  for (std::size_t t = 0; t < solid.surface.size(); ++t) {
    for (const Vector3& corner : solid.surface.corners(static_cast<std::uint32_t>(t)))
      for (const double x : corner) add(x);
  }
  if (solid.guides != nullptr) add_guides(*solid.guides, add);
  const SolverTuning& solver = options.solver;
  for (const double value :
       {finest_cell_size(solid.surface.box, options), static_cast<double>(options.degree),
        static_cast<double>(options.seed), kThicknessCells, solver.energy_density_threshold,
        solver.boundary_weight, solver.diagonal_share, solver.over_relaxation, solver.sweep_tolerance,
        kRestingShare})
    add(value);
  return hash;
}

}  // namespace crossgrain
