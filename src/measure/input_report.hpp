// SPDX-License-Identifier: Apache-2.0
// What is wrong with a surface, in words.
#pragma once

#include "crossgrain/report.hpp"
#include "surface/mending.hpp"

namespace crossgrain {

/// The section `input` of the report.
SolveReport::Input input_report(const MendedSurface& mended, const SurfaceFindings& findings);

}  // namespace crossgrain
