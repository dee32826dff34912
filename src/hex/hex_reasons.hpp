// SPDX-License-Identifier: Apache-2.0
// Why hexahedra do not fill a model.
#pragma once

#include "crossgrain/hex_report.hpp"
#include "hex/hex_candidate.hpp"

namespace crossgrain {

/// Fills in the reason why a result is not whole, the places and what to try, unless it is. The report has
/// its outcome and quality.
void explain(const HexCandidate& best, HexReport& report);

}  // namespace crossgrain
