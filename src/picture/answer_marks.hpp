// SPDX-License-Identifier: Apache-2.0
// The answer about a field in a picture: a block of the legend, and cubes at creases and corners of the
// surface that hexahedra cannot have.
#pragma once

#include <vector>

#include "crossgrain/report.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// Adds cubes at creases and corners that are not meshable or undecided; `radius` is that of singular lines.
void answer_marks(const SolveReport& report, double radius, std::vector<Facet>& facets);

/// The answer in short as a title, with the colours of the cubes if they are drawn.
LegendBlock answer_legend(const SolveReport& report, bool has_marks);

}  // namespace crossgrain
