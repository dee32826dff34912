// SPDX-License-Identifier: Apache-2.0
// The answer about a field in a picture: a block of the legend, and balls at creases and corners of the
// surface that hexahedra cannot have.
#pragma once

#include <vector>

#include "crossgrain/report.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// Balls at creases and corners that are not meshable or undecided; `radius` is that of singular lines.
std::vector<Ball> answer_marks(const SolveReport& report, double radius);

/// The answer in short as a title, with the colours of the balls if they are drawn.
LegendBlock answer_legend(const SolveReport& report, bool has_marks);

}  // namespace crossgrain
