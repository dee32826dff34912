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

/// Pieces that one task sums up: many more than there are bins.
constexpr std::size_t kPieceGrain = std::size_t{1} << 16;

constexpr double kShareAbove = 0.05;

/// Of the pieces of one task, or of all.
struct AngleSums {
  double included_area = 0, excluded_area = 0, weighted = 0;
  float largest = 0;

  void add(const AngleSums& other) {
    included_area += other.included_area;
    excluded_area += other.excluded_area;
    weighted += other.weighted;
    largest = std::max(largest, other.largest);
  }
};

/// part(begin, end) over fixed runs of pieces, added up in their order.
template <class Sum, class Part>
Sum summed_over_runs(std::size_t count, const Part& part) {
  std::vector<Sum> runs((count + kPieceGrain - 1) / kPieceGrain);
  parallel_for_chunks(count, kPieceGrain, [&](std::size_t begin, std::size_t end) {
    runs[begin / kPieceGrain] = part(begin, end);
  });
  Sum sum{};
  for (const Sum& run : runs) sum.add(run);
  return sum;
}

AngleSums sums_of(std::span<const SurfacePiece> pieces, std::span<const float> angles) {
  return summed_over_runs<AngleSums>(pieces.size(), [&](std::size_t begin, std::size_t end) {
    AngleSums sums;
    for (std::size_t k = begin; k < end; ++k) {
      if (angles[k] == kExcludedAngle) {
        sums.excluded_area += pieces[k].area;
        continue;
      }
      sums.included_area += pieces[k].area;
      sums.weighted += static_cast<double>(pieces[k].area) * angles[k];
      sums.largest = std::max(sums.largest, angles[k]);
    }
    return sums;
  });
}

/// Area by kBinBits of the bits of an angle.
struct AreaBins {
  static constexpr int kBinBits = 11;

  std::array<double, 1 << kBinBits> areas{};

  void add(const AreaBins& other) {
    for (std::size_t bin = 0; bin < areas.size(); ++bin) areas[bin] += other.areas[bin];
  }
};

/// The largest angle such that the pieces of that angle or more have more area than `area_above`. Numbers
/// that are not negative are in the order of their bits: three rounds of bins, each within the bin found
/// before, leave one angle. Sorting would take longer and one thread.
float angle_below_area(std::span<const SurfacePiece> pieces, std::span<const float> angles,
                       double area_above) {
  constexpr int kBits = AreaBins::kBinBits;
  std::uint64_t found = 0;  // the leading bits of the angle
  double above = 0;
  for (int shift = 2 * kBits; shift >= 0; shift -= kBits) {
    const AreaBins bins = summed_over_runs<AreaBins>(pieces.size(), [&](std::size_t begin, std::size_t end) {
      AreaBins run;
      for (std::size_t k = begin; k < end; ++k) {
        if (angles[k] == kExcludedAngle) continue;
        const std::uint64_t leading = std::uint64_t{std::bit_cast<std::uint32_t>(angles[k])} >> shift;
        if (leading >> kBits == found) run.areas[leading % run.areas.size()] += pieces[k].area;
      }
      return run;
    });
    std::size_t lowest = 0, bin = bins.areas.size() - 1;
    while (!(bins.areas[lowest] > 0)) ++lowest;
    while (bin > lowest && !(above + bins.areas[bin] > area_above)) above += bins.areas[bin--];
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
  std::stable_sort(angles.begin(), angles.end(),
                   [](const WeightedAngle& a, const WeightedAngle& b) { return a.angle_deg < b.angle_deg; });
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

SolveReport::Alignment angle_statistics(std::span<const SurfacePiece> pieces, std::span<const float> angles) {
  const AngleSums sums = sums_of(pieces, angles);
  SolveReport::Alignment alignment;
  if (sums.excluded_area > 0)
    alignment.excluded_share = sums.excluded_area / (sums.excluded_area + sums.included_area);
  if (!(sums.included_area > 0)) return alignment;
  alignment.mean = sums.weighted / sums.included_area;
  alignment.max = sums.largest;
  alignment.p95 = angle_below_area(pieces, angles, kShareAbove * sums.included_area);
  return alignment;
}

}  // namespace crossgrain
