// SPDX-License-Identifier: Apache-2.0
#include "measure/angle_statistics.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

constexpr double kShareAbove = 0.05;

/// Areas are counted in this share of the total.
constexpr double kAreaUnit = 0x1p-50;

/// Number of tasks that a sum over pieces is split into.
constexpr std::size_t kTasks = 64;

/// Pieces with their areas and angles, of which some are excluded.
class WeightedPieces {
 public:
  WeightedPieces(std::span<const SurfacePiece> pieces, std::span<const float> angles, double total_area)
      : pieces_(pieces), angles_(angles), units_(total_area > 0 ? 1 / (kAreaUnit * total_area) : 0) {}

  std::size_t size() const { return pieces_.size(); }
  bool is_included(std::size_t k) const { return angles_[k] != kExcludedAngle; }
  float angle(std::size_t k) const { return angles_[k]; }

  /// In units; positive for any area.
  std::uint64_t area(std::size_t k) const {
    return pieces_[k].area > 0 ? std::max<std::uint64_t>(1, rounded(scaled(k))) : 0;
  }
  std::uint64_t weighted_angle(std::size_t k) const {
    return rounded(scaled(k) * static_cast<double>(angles_[k]));
  }

 private:
  static std::uint64_t rounded(double number) { return static_cast<std::uint64_t>(std::llround(number)); }
  double scaled(std::size_t k) const { return static_cast<double>(pieces_[k].area) * units_; }

  std::span<const SurfacePiece> pieces_;
  std::span<const float> angles_;
  double units_;
};

/// Returns counts, which add(piece, counts) adds to for every piece of all processes.
template <std::size_t N, class Add>
std::array<std::uint64_t, N> counted_over(const WeightedPieces& pieces, const Share& share, const Add& add) {
  const std::size_t grain = std::max<std::size_t>(1, (pieces.size() + kTasks - 1) / kTasks);
  std::vector<std::array<std::uint64_t, N>> tasks((pieces.size() + grain - 1) / grain);
  parallel_for_chunks(pieces.size(), grain, [&](std::size_t begin, std::size_t end) {
    auto& counts = tasks[begin / grain];
    for (std::size_t k = begin; k < end; ++k) add(k, counts);
  });
  std::array<std::uint64_t, N> sum{};
  for (const auto& counts : tasks)
    for (std::size_t n = 0; n < N; ++n) sum[n] += counts[n];
  add_up(share, std::span<std::uint64_t>(sum));
  return sum;
}

/// Returns the largest angle such that the pieces of that angle or more have more area than `area_above`, in
/// units. Numbers that are not negative are ordered as their bits: three rounds of bins, each within the bin
/// found before, determine one angle. Sorting would take longer, and in one process.
float angle_below_area(const WeightedPieces& pieces, const Share& share, std::uint64_t area_above) {
  constexpr int kBits = 11;
  constexpr std::size_t kBins = 1 << kBits;
  std::uint64_t found = 0;  // the leading bits of the angle
  std::uint64_t above = 0;
  for (int shift = 2 * kBits; shift >= 0; shift -= kBits) {
    const auto areas = counted_over<kBins>(pieces, share, [&](std::size_t k, auto& counts) {
      if (!pieces.is_included(k)) return;
      const std::uint64_t leading = std::uint64_t{std::bit_cast<std::uint32_t>(pieces.angle(k))} >> shift;
      if (leading >> kBits == found) counts[leading % kBins] += pieces.area(k);
    });
    std::size_t lowest = 0, bin = kBins - 1;
    while (areas[lowest] == 0) ++lowest;
    while (bin > lowest && above + areas[bin] <= area_above) above += areas[bin--];
    found = found << kBits | bin;
  }
  return std::bit_cast<float>(static_cast<std::uint32_t>(found));
}

}  // namespace

SolveReport::AngleSummary summary_of(std::vector<double> angles) {
  if (angles.empty()) return {};
  std::sort(angles.begin(), angles.end());
  const auto count = static_cast<double>(angles.size());
  const double rank = 0.95 * (count - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, angles.size() - 1);
  return {std::accumulate(angles.begin(), angles.end(), 0.0) / count,
          std::lerp(angles[below], angles[above], rank - std::floor(rank)), angles.back()};
}

SolveReport::AngleSummary summary_of(std::vector<WeightedAngle> angles) {
  if (angles.empty()) return {};
  std::ranges::stable_sort(angles, {}, &WeightedAngle::angle_deg);
  double weighted = 0, weight = 0;
  for (const WeightedAngle& angle : angles) {
    weighted += angle.weight * angle.angle_deg;
    weight += angle.weight;
  }
  double above = 0;
  std::size_t k = angles.size() - 1;
  while (k > 0 && above + angles[k].weight <= kShareAbove * weight) above += angles[k--].weight;
  return {weighted / weight, angles[k].angle_deg, angles.back().angle_deg};
}

SolveReport::Alignment angle_statistics(std::span<const SurfacePiece> pieces, std::span<const float> angles,
                                        double total_area, const Share& share) {
  const WeightedPieces weighted(pieces, angles, total_area);
  const auto [included, excluded, angle_sum] =
      counted_over<3>(weighted, share, [&](std::size_t k, auto& counts) {
        counts[weighted.is_included(k) ? 0 : 1] += weighted.area(k);
        if (weighted.is_included(k)) counts[2] += weighted.weighted_angle(k);
      });
  SolveReport::Alignment alignment;
  if (excluded > 0)
    alignment.excluded_share = static_cast<double>(excluded) / static_cast<double>(excluded + included);
  if (included == 0) return alignment;
  alignment.mean = static_cast<double>(angle_sum) / static_cast<double>(included);
  const float largest = angles.empty() ? 0 : *std::max_element(angles.begin(), angles.end());
  alignment.max = largest_of_all(share, largest);
  alignment.p95 = angle_below_area(weighted, share,
                                   static_cast<std::uint64_t>(kShareAbove * static_cast<double>(included)));
  return alignment;
}

}  // namespace crossgrain
