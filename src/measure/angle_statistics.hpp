// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "crossgrain/report.hpp"
#include "grid/grid_level.hpp"
#include "grid/share.hpp"

namespace crossgrain {

inline constexpr float kExcludedAngle = -1;

/// Mean, 95th percentile and maximum of equally weighted angles; none without angles.
SolveReport::AngleSummary summary_of(std::vector<double> angles);

struct WeightedAngle {
  double angle_deg, weight;
};

/// Mean, 95th percentile and maximum of angles with positive weights; p95 is the smallest angle that 95 % of
/// the weight does not exceed.
SolveReport::AngleSummary summary_of(std::vector<WeightedAngle> angles);

/// The statistics of the angles of pieces of surface, in degrees, not negative or kExcludedAngle, weighted by
/// the area of each piece: AlignmentMeasurement::alignment_deg. `total_area`, of all pieces within a factor
/// of a thousand, scales areas to integers, whose sums are the same for any order, threads and shares: areas
/// are rounded to 2^-50 of it. `share` is that of the level whose own leaves the pieces are in.
SolveReport::Alignment angle_statistics(std::span<const SurfacePiece> pieces, std::span<const float> angles,
                                        double total_area, const Share& share = {});

}  // namespace crossgrain
