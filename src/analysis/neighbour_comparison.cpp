// SPDX-License-Identifier: Apache-2.0
#include "analysis/neighbour_comparison.hpp"

#include "analysis/frames_in_lanes.hpp"
#include "base/instruction_set.hpp"
#include "base/parallel.hpp"
#include "field/field_state.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {
namespace {

/// Leaves whose coefficients one task keeps: most of their neighbours are among them.
constexpr std::size_t kLeafGrain = 8192;

/// A squared difference of coefficients that frames 22.5 degrees or more apart have at least, however their
/// axes are named: it is 5/6 for a turn about an axis, more about other lines. Around an edge with less at
/// all four faces frames turn by less than 90 degrees in all, and so by nothing.
constexpr double kSharpTurn = 0.83;

StoredCoefficients<4> stored_coefficients(const StoredQuaternion& frame) {
  return to_stored<4>(frame_coefficients<4>(from_stored(frame)));
}

std::vector<StoredCoefficients<4>> stored_coefficients(std::span<const StoredQuaternion> frames) {
  std::vector<StoredCoefficients<4>> coefficients(frames.size());
  run_in_lanes([&]<int W>() {
    for (std::size_t i = 0; i < frames.size(); i += W) {
      const Coefficients<4, Lanes<W>> h = frame_coefficients<4>(frames_in_lanes<W>(frames, i));
      const int count = static_cast<int>(std::min<std::size_t>(W, frames.size() - i));
      for (int lane = 0; lane < count; ++lane)
        coefficients[i + static_cast<std::size_t>(lane)] = to_stored<4>(in_lane(h, lane));
    }
  });
  return coefficients;
}

/// Compares leaves [begin, end) with their neighbours.
class RunOfLeaves {
 public:
  RunOfLeaves(const Adjacency& adjacency, std::span<const StoredQuaternion> frames, std::size_t begin,
              std::size_t end)
      : adjacency_(adjacency),
        frames_(frames),
        begin_(begin),
        coefficients_(stored_coefficients(frames.subspan(begin, end - begin))) {}

  /// The sum over the edges of leaf i of w |h_i - h_j|^2, and whether there is a sharp turn at one.
  struct Row {
    double energy = 0;
    bool turns_sharply = false;
  };
  Row row(std::size_t i) const {
    const Coefficients<4> h = from_stored<4>(coefficients_[i - begin_]);
    Row row;
    for (const auto& [j, weight] : adjacency_[i]) {
      const double squared_difference = squared_norm(difference(h, coefficients_of(j)));
      row.energy += weight * squared_difference;
      row.turns_sharply = row.turns_sharply || squared_difference > kSharpTurn;
    }
    return row;
  }

 private:
  Coefficients<4> coefficients_of(std::size_t i) const {
    const bool kept = i >= begin_ && i - begin_ < coefficients_.size();
    return from_stored<4>(kept ? coefficients_[i - begin_] : stored_coefficients(frames_[i]));
  }

  const Adjacency& adjacency_;
  std::span<const StoredQuaternion> frames_;
  std::size_t begin_;
  std::vector<StoredCoefficients<4>> coefficients_;
};

}  // namespace

NeighbourComparison compare_neighbours(const Octree& tree, const Adjacency& adjacency,
                                       std::span<const StoredQuaternion> frames) {
  const std::size_t count = frames.size();
  NeighbourComparison result;
  result.energy_density.resize(count);
  std::vector<std::uint8_t> turns_sharply(count);
  parallel_for_chunks(count, kLeafGrain, [&](std::size_t begin, std::size_t end) {
    const RunOfLeaves run(adjacency, frames, begin, end);
    for (std::size_t i = begin; i < end; ++i) {
      const auto [energy, sharp] = run.row(i);
      const double size = tree.cell_size(static_cast<CellIndex>(i));
      result.energy_density[i] = static_cast<float>(energy / (4 * size * size * size));
      turns_sharply[i] = sharp;
    }
  });
  // The owner of a singular edge is a leaf at one of the four faces around it, or shares a face with one.
  result.near_sharp_turn.resize(count);
  parallel_for(count, [&](std::size_t i) {
    std::uint8_t near = turns_sharply[i];
    for (const Adjacency::Neighbour& neighbour : adjacency[i]) near |= turns_sharply[neighbour.cell];
    result.near_sharp_turn[i] = near;
  });
  return result;
}

}  // namespace crossgrain
