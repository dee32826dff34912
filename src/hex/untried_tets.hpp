// SPDX-License-Identifier: Apache-2.0
// Which tets to try next, where those of no size have brought a mesh.
#pragma once

#include <optional>
#include <vector>

#include "crossgrain/hex_report.hpp"

namespace crossgrain {

/// Returns a size of tets, of three digits, that makes clearly other tets than all sizes of the attempts did;
/// none if none is known to. docs/notes/hexahedra.md tells how often it helps.
std::optional<double> untried_tet_size(const std::vector<HexAttempt>& attempts);

}  // namespace crossgrain
