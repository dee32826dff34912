// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <istream>
#include <optional>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Returns the tets of a file in Netgen's own format with the numbers of domains, faces and edges; nothing if
/// it is incomplete or has other elements. Each edge appears once, though Netgen writes one for each face
/// there.
std::optional<TetMesh> tets_of_vol_file(std::istream& file);

}  // namespace crossgrain
