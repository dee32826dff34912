// SPDX-License-Identifier: Apache-2.0
#include "field/energy.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/instruction_set.hpp"
#include "base/parallel.hpp"
#include "constraint/normal_form.hpp"
#include "constraint/spectral_shift.hpp"
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

/// sum over the edges of a cell of w |h_i - h_j|^2 in degree 4, the eight orders below the last side by side.
/// Each edge is met from both its cells.
template <int Doubles>
double edge_sum_in_lanes(const Adjacency::Row& row, const std::vector<StoredCoefficients<4>>& coefficients,
                         std::size_t cell) {
  constexpr int W = std::min(2 * Doubles, 8), kGroups = 8 / W;
  using Group = SingleLanes<W>;
  const StoredCoefficients<4>& own = coefficients[cell];
  std::array<Group, kGroups> sums;
  float last_sum = 0;
  for (std::size_t k = 0; k < row.size(); k += W) {
    const std::size_t all = std::min<std::size_t>(W, row.size() - k);
    const Group weights = row.has_equal_weights() ? Group(row.weight(0)) : row.weights_from<Group>(k);
    const auto add = [&]<int J>() {
      if (J >= all) return;
      const StoredCoefficients<4>& other = coefficients[row.cell(k + J)];
      const Group weight = repeated<J>(weights);
      for (int g = 0; g < kGroups; ++g) {
        const Group step = lanes_of<Group>(other.data() + g * W) - lanes_of<Group>(own.data() + g * W);
        sums[g] += weight * (step * step);
      }
      const float last_step = other[8] - own[8];
      last_sum += weights[J] * (last_step * last_step);
    };
    [&]<int... J>(std::integer_sequence<int, J...>) {
      (add.template operator()<J>(), ...);
    }
    (std::make_integer_sequence<int, W>());
  }
  double sum = last_sum;
  for (int m = 0; m < 8; ++m) sum += sums[m / W][m % W];
  return sum;
}

/// visit(cell, its edge_sum_in_lanes) for all cells, from several threads.
template <class Visit>
void for_each_edge_sum(const Adjacency& adjacency, const std::vector<StoredCoefficients<4>>& coefficients,
                       const Visit& visit) {
  parallel_for_chunks(adjacency.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    run_in_lanes([&]<int Doubles>() {
      for (std::size_t i = begin; i < end; ++i)
        visit(i, edge_sum_in_lanes<Doubles>(adjacency[i], coefficients, i));
    });
  });
}

/// sum over the pieces of surface in a leaf of area * E_n(h).
double boundary_value(const GridLevel& level, const Solid& solid, CellIndex leaf, const Coefficients<4>& h) {
  double sum = 0;
  for (const SurfacePiece& piece : level.pieces_of(leaf)) {
    // Never negative but for rounding.
    sum += piece.area *
           std::max(0.0, normal_value<4>(normal_basis<4>(solid.surface.normals[piece.triangle]), h));
  }
  return sum;
}

/// The least that any frame gives it.
double least_boundary_value(const GridLevel& level, const Solid& solid, CellIndex leaf,
                            const Quaternion& frame) {
  if (has_single_normal(level, solid, leaf)) return 0;
  return std::max(0.0, least_value(cell_form<4>(level, solid, leaf), frame));
}

/// The energy of all edges.
double smoothness_energy(const Adjacency& adjacency, const FieldState<4>& state) {
  std::vector<double> partial((adjacency.size() + kParallelGrain - 1) / kParallelGrain, 0.0);
  for_each_edge_sum(adjacency, state.coefficients,
                    [&](std::size_t i, double sum) { partial[i / kParallelGrain] += sum; });
  return std::accumulate(partial.begin(), partial.end(), 0.0) / 4;
}
double smoothness_energy(const Adjacency& adjacency, const FieldState<3>& state) {
  return parallel_sum(adjacency.size(),
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
  return smoothness_energy(graph.adjacency(), state) + parallel_sum(graph.size(), [&](std::size_t i) {
           return graph.forms.empty(i) ? 0
                                       : form_value(graph.forms, i, from_stored<D>(state.coefficients[i]));
         });
}

LevelEnergy level_energy(const GridLevel& level, const Solid& solid, const Adjacency& adjacency,
                         std::span<const StoredQuaternion> frames, double boundary_weight) {
  LevelEnergy energy;
  EnergyParts& parts = energy.parts;
  {
    const std::vector<StoredCoefficients<4>> coefficients = coefficients_of<4>(frames);
    energy.density.resize(frames.size());
    std::vector<double> partial((frames.size() + kParallelGrain - 1) / kParallelGrain, 0.0);
    for_each_edge_sum(adjacency, coefficients, [&](std::size_t i, double sum) {
      const double size = level.tree.cell_size(static_cast<CellIndex>(i));
      energy.density[i] = static_cast<float>(sum / (4 * size * size * size));
      partial[i / kParallelGrain] += sum / 4;
    });
    parts.smoothness = std::accumulate(partial.begin(), partial.end(), 0.0);
  }
  const auto sum_over_leaves = [&](const auto& term) {
    return parallel_sum(frames.size(), [&](std::size_t i) {
      const auto leaf = static_cast<CellIndex>(i);
      if (!level.holds_surface(leaf)) return 0.0;
      return boundary_weight / level.tree.cell_size(leaf) * term(leaf, from_stored(frames[i]));
    });
  };
  parts.unavoidable = sum_over_leaves([&](CellIndex leaf, const Quaternion& frame) {
    return least_boundary_value(level, solid, leaf, frame);
  });
  const double boundary = sum_over_leaves([&](CellIndex leaf, const Quaternion& frame) {
    return boundary_value(level, solid, leaf, frame_coefficients<4>(frame));
  });
  parts.boundary = std::max(0.0, boundary - parts.unavoidable);
  return energy;
}

template double graph_energy<3>(const FieldGraph<3>&, const FieldState<3>&);
template double graph_energy<4>(const FieldGraph<4>&, const FieldState<4>&);

}  // namespace crossgrain
