// SPDX-License-Identifier: Apache-2.0
#include "field/neighbour_comparison.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/instruction_set.hpp"
#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Least squared difference of coefficients of frames that are 22.5 degrees or more apart modulo symmetry:
/// 5/6 for a rotation about an axis, more about other lines. If all four faces around an edge have less, the
/// frames rotate by less than 90 degrees in total around it, hence by nothing.
constexpr double kSharpTurn = 0.83;

/// Returns the sum over the edges of a cell of w |h_i - h_j|^2 in degree 4, with the first eight orders side
/// by side. Each edge is visited from both its cells.
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

/// Calls visit(cell, its edge_sum_in_lanes) for all own cells, from several threads. Returns the sum over
/// those of all processes.
template <class Visit>
double for_each_edge_sum(const Adjacency& adjacency, const Share& share,
                         const std::vector<StoredCoefficients<4>>& coefficients, const Visit& visit) {
  std::vector<double> partial((share.size() + kParallelGrain - 1) / kParallelGrain, 0.0);
  parallel_for_chunks(share.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    run_in_lanes([&]<int Doubles>() {
      for (std::size_t i = share.begin + begin; i < share.begin + end; ++i) {
        const double sum = edge_sum_in_lanes<Doubles>(adjacency[i], coefficients, i);
        visit(i, sum);
        partial[begin / kParallelGrain] += sum;
      }
    });
  });
  return sum_of_all(share, partial);
}

/// Returns whether the frame of a neighbour differs sharply from the cell's; `edge_sum` is the cell's.
bool has_sharp_turn(const Adjacency::Row& row, const std::vector<StoredCoefficients<4>>& coefficients,
                    std::size_t cell, double edge_sum) {
  float least_weight = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k < row.size(); ++k) least_weight = std::min(least_weight, row.weight(k));
  if (edge_sum <= 0.99 * kSharpTurn * least_weight) return false;
  const Coefficients<4> h = from_stored<4>(coefficients[cell]);
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (squared_norm(difference(h, from_stored<4>(coefficients[row.cell(k)]))) > kSharpTurn) return true;
  }
  return false;
}

}  // namespace

double smoothness_energy(const Adjacency& adjacency, const Share& share,
                         const std::vector<StoredCoefficients<4>>& coefficients) {
  return for_each_edge_sum(adjacency, share, coefficients, [](std::size_t, double) {}) / 4;
}

NeighbourComparison compare_neighbours(const GridLevel& level, const Adjacency& adjacency,
                                       std::span<const StoredQuaternion> frames, SharpTurns sharp_turns) {
  const std::vector<StoredCoefficients<4>> coefficients = coefficients_of<4>(frames);
  NeighbourComparison result;
  result.energy_density = sized_vector<float>(frames.size());
  const bool looks_for_turns = sharp_turns == SharpTurns::kLookedFor;
  if (looks_for_turns) result.turns_sharply.resize(frames.size());
  const double total =
      for_each_edge_sum(adjacency, level.share(), coefficients, [&](std::size_t i, double sum) {
        const double size = level.tree.cell_size(static_cast<CellIndex>(i));
        result.energy_density[i] = static_cast<float>(sum / (4 * size * size * size));
        if (looks_for_turns) result.turns_sharply[i] = has_sharp_turn(adjacency[i], coefficients, i, sum);
      });
  result.smoothness = total / 4;
  return result;
}

std::vector<std::uint8_t> near_sharp_turns(const Adjacency& adjacency,
                                           const std::vector<std::uint8_t>& turns_sharply) {
  // The owner of a singular edge is a leaf at one of the four faces around it, or shares a face with one.
  std::vector<std::uint8_t> near(turns_sharply.size());
  parallel_for(near.size(), [&](std::size_t i) {
    near[i] = turns_sharply[i];
    const Adjacency::Row row = adjacency[i];
    for (std::size_t k = 0; k < row.size() && !near[i]; ++k) near[i] = turns_sharply[row.cell(k)];
  });
  return near;
}

Marks moved_line_marks(const GridLevel& level, const Adjacency& adjacency,
                       std::span<const StoredQuaternion> frames, int depth, double threshold) {
  Marks marks(level.size(), false);
  const NeighbourComparison comparison = compare_neighbours(level, adjacency, frames, SharpTurns::kLeftOut);
  mark_energy_density(level, comparison.energy_density, threshold, marks);
  for (CellIndex i = 0; i < level.size(); ++i)
    if (level.tree[i].depth() == depth) marks[i] = false;
  return marks;
}

}  // namespace crossgrain
