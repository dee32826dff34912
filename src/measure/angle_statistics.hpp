// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "crossgrain/report.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Stands for the angle of a piece that does not count.
inline constexpr float kExcludedAngle = -1;

/// Mean, 95th percentile and largest of angles that count alike; none where there are none.
SolveReport::AngleSummary summary_of(std::vector<double> angles);

struct WeightedAngle {
  double angle_deg, weight;
};

/// The same by weight, which is positive; p95 is the smallest angle that 95 % of the weight does not exceed.
SolveReport::AngleSummary summary_of(std::vector<WeightedAngle> angles);

/// The statistics of the angles of `pieces` in degrees, not negative or kExcludedAngle, each weighted by its
/// piece's area: as AlignmentMeasurement::alignment_deg. The same to the bit for any number of threads.
SolveReport::Alignment angle_statistics(std::span<const SurfacePiece> pieces, std::span<const float> angles);

}  // namespace crossgrain
