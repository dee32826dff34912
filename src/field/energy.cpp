// SPDX-License-Identifier: Apache-2.0
#include "field/energy.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "base/parallel.hpp"
#include "constraint/normal_form.hpp"
#include "constraint/parallel_normals.hpp"
#include "constraint/spectral_shift.hpp"
#include "field/leaf_stencil.hpp"
#include "grid/cell_constraints.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {
namespace {

template <int D>
double form_value(const CellForms<D>& forms, std::size_t cell, const Coefficients<D>& h) {
  if (const PlaneForm* plane = forms.plane(cell)) {
    const Vector3 normal = normalised(Vector3{plane->normal[0], plane->normal[1], plane->normal[2]});
    return plane->weight * normal_value<D>(normal_basis<D>(normal), h);
  }
  const PackedForm<D>* packed = forms.general(cell);
  if (!packed) return 0;
  QuadraticForm<D> form;
  std::copy_n(packed->begin(), kFormEntryCount<D>, form.matrix.begin());
  if constexpr (D == 4) {
    std::copy_n(packed->begin() + kFormEntryCount<D>, kCoefficientCount<D>, form.linear.begin());
    form.constant = packed->back();
  }
  return value(form, h);
}

/// Returns sum over the surface pieces and guides in a leaf of area * E_n(h).
double boundary_value(const GridLevel& level, const Solid& solid, CellIndex leaf, const Coefficients<4>& h) {
  double sum = 0;
  for (const SurfacePiece& piece : level.pieces_of(leaf)) {
    // Rounding may make it slightly negative.
    sum +=
        piece.area * std::max(0.0, normal_value<4>(normal_basis<4>(normal_of(level, solid, leaf, piece)), h));
  }
  for (const LeafGuide& guide : level.guides.of(leaf))
    sum += guide.area * std::max(0.0, normal_value<4>(normal_basis<4>(guide.unit_direction()), h));
  return sum;
}

/// Up to two distinct normals (up to sign) of the surface in a leaf, with their areas.
struct FacedDirections {
  std::array<Vector3, 2> normals;
  std::array<double, 2> areas{};
  std::size_t count = 0;

  /// Further directions exist. One guide orthogonal to all the normals does not count, such as the tangent of
  /// a crease: the best frame for up to two normals has an axis along it anyway.
  bool are_more = false;

  FacedDirections(const GridLevel& level, const Solid& solid, CellIndex leaf) {
    for (const SurfacePiece& piece : level.pieces_of(leaf)) {
      const Vector3 normal = normal_of(level, solid, leaf, piece);
      const std::size_t k = place_of(normal);
      are_more = k == normals.size();
      if (are_more) return;
      if (k == count) normals[count++] = normal;
      areas[k] += piece.area;
    }
    std::optional<Vector3> across;
    for (const LeafGuide& guide : level.guides.of(leaf)) {
      const Vector3 direction = guide.unit_direction();
      const std::size_t k = place_of(direction);
      if (k < count || count == 0) {
        if (k == count) normals[count++] = direction;
        areas[k] += guide.area;
        continue;
      }
      are_more |= !is_across_all(direction) || (across && !is_same_normal(direction, *across));
      across = direction;
    }
  }

 private:
  /// A deviation of a thousandth of a radian costs a few millionths.
  static constexpr double kAcross = 1e-3;

  /// Returns the index of the first known direction equal to `direction`, or `count`.
  std::size_t place_of(const Vector3& direction) const {
    std::size_t k = 0;
    while (k < count && !is_same_normal(normals[k], direction)) ++k;
    return k;
  }

  bool is_across_all(const Vector3& direction) const {
    return count > 0 && std::all_of(normals.begin(), normals.begin() + static_cast<std::ptrdiff_t>(count),
                                    [&](const Vector3& n) { return std::abs(dot(n, direction)) < kAcross; });
  }
};

/// Returns the frame of least boundary value in a leaf whose normals are nearly parallel, to a share of 7e-4
/// of that: a twentieth of the time of a search.
std::optional<Quaternion> best_for_parallel(const GridLevel& level, const Solid& solid, CellIndex leaf) {
  if (level.guides.has(leaf)) return std::nullopt;
  ParallelNormals normals(first_normal(level, solid, leaf));
  for (const SurfacePiece& piece : level.pieces_of(leaf))
    normals.add(normal_of(level, solid, leaf, piece), piece.area);
  return normals.best_frame();
}

/// The boundary value of a frame in a leaf, and the least one that any frame attains there.
struct BoundaryValues {
  double of_frame = 0, least = 0;
};

BoundaryValues boundary_values(const GridLevel& level, const Solid& solid, CellIndex leaf,
                               const Quaternion& frame) {
  const Coefficients<4> h = frame_coefficients<4>(frame);
  const FacedDirections faced(level, solid, leaf);
  if (faced.are_more) {
    const QuadraticForm<4> form = cell_form<4>(level, solid, leaf);
    const double of_frame = std::max(0.0, value(form, h));
    if (const auto best = best_for_parallel(level, solid, leaf))
      return {of_frame, std::clamp(value(form, frame_coefficients<4>(*best)), 0.0, of_frame)};
    return {of_frame, std::max(0.0, least_value(form, frame))};
  }
  const double least = faced.count < 2 ? 0
                                       : least_value_of_two(faced.normals[0], faced.areas[0],
                                                            faced.normals[1], faced.areas[1]);
  return {boundary_value(level, solid, leaf, h), least};
}

/// Sums of both over all leaves, each divided by the size of its leaf.
BoundaryValues boundary_sums(const GridLevel& level, const Solid& solid,
                             std::span<const StoredQuaternion> frames) {
  const Share share = level.share();
  // A level that can be shared has the same chunks in one process and in several.
  const std::size_t grain = share.of_all < blocked_cells() ? level.leaves_per_task() : kParallelGrain;
  std::vector<BoundaryValues> sums((share.size() + grain - 1) / grain);
  const auto add = [](BoundaryValues& sum, const BoundaryValues& term, double factor) {
    sum.of_frame += factor * term.of_frame;
    sum.least += factor * term.least;
  };
  parallel_for_chunks(share.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (auto leaf = static_cast<CellIndex>(share.begin + begin); leaf < share.begin + end; ++leaf) {
      if (level.is_constrained(leaf))
        add(sums[begin / grain], boundary_values(level, solid, leaf, from_stored(frames[leaf])),
            1 / level.tree.cell_size(leaf));
    }
  });
  std::vector<double> of_frame, least;
  for (const BoundaryValues& sum : sums) {
    of_frame.push_back(sum.of_frame);
    least.push_back(sum.least);
  }
  return {sum_of_all(share, of_frame), sum_of_all(share, least)};
}

double smoothness_of(const Adjacency& adjacency, const Share& share, const FieldState<4>& state) {
  return smoothness_energy(adjacency, share, state.coefficients);
}
double smoothness_of(const Adjacency& adjacency, const Share& share, const FieldState<3>& state) {
  return parallel_sum(share,
                      [&](std::size_t i) {
                        const Coefficients<3> h = from_stored<3>(state.coefficients[i]);
                        double sum = 0;
                        for (const auto& [neighbour, weight] : adjacency[i]) {
                          const Coefficients<3> other = from_stored<3>(state.coefficients[neighbour]);
                          const double cosine = dot(h, other);
                          sum += weight * (squared_norm(h) * squared_norm(other) - cosine * cosine);
                        }
                        return sum;
                      }) *
         5.0 / 12;
}

}  // namespace

template <int D>
double graph_energy(const FieldGraph<D>& graph, const FieldState<D>& state) {
  const Share share = graph.share();
  return smoothness_of(graph.adjacency(), share, state) + parallel_sum(share, [&](std::size_t i) {
           return graph.forms.empty(i) ? 0
                                       : form_value(graph.forms, i, from_stored<D>(state.coefficients[i]));
         });
}

LevelEnergy level_energy(const GridLevel& level, const Solid& solid, const Adjacency& adjacency,
                         std::span<const StoredQuaternion> frames, double boundary_weight,
                         SharpTurns sharp_turns) {
  LevelEnergy energy;
  EnergyParts& parts = energy.parts;
  energy.neighbours = compare_neighbours(level, adjacency, frames, sharp_turns);
  parts.smoothness = energy.neighbours.smoothness;
  const BoundaryValues boundary = boundary_sums(level, solid, frames);
  parts.unavoidable = boundary_weight * boundary.least;
  parts.boundary = boundary_weight * std::max(0.0, boundary.of_frame - boundary.least);
  return energy;
}

template double graph_energy<3>(const FieldGraph<3>&, const FieldState<3>&);
template double graph_energy<4>(const FieldGraph<4>&, const FieldState<4>&);

}  // namespace crossgrain
