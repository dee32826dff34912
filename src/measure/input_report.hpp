// SPDX-License-Identifier: Apache-2.0
// The faults of a surface, in words.
#pragma once

#include "crossgrain/report.hpp"
#include "surface/mending.hpp"

namespace crossgrain {

SolveReport::Input input_report(const MendedSurface& mended, const SurfaceFindings& findings);

/// sentence_of(finding) in a model of this longest side.
std::string sentence_of(const SolveReport::Finding& finding, double size);

}  // namespace crossgrain
