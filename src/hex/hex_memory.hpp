// SPDX-License-Identifier: Apache-2.0
// The memory that hexahedra take, predicted before they are made: bench/hex_memory.py measures it.
#pragma once

#include <cstddef>

#include "crossgrain/message.hpp"

namespace crossgrain {

/// Bytes for a tet of the field at the peak of its repairs and their maps, beyond what the tets and the field
/// take themselves: 3.3 to 3.9 kB on six models of 18,000 to 86,000 tets.
inline constexpr double kBytesOfTet = 4500;

/// Of those for a tet of one map, of the tets that its field splits: 1.3 to 1.5 kB.
inline constexpr double kBytesOfMappedTet = 1800;

/// Bytes for a hexahedron when it is taken out of a map, smoothed and judged: 1.0 kB on boxes of 4,500 to
/// 105,000.
inline constexpr double kBytesOfHexahedron = 1200;

/// Throws Error(kLimit) if the memory of watched loops (require_memory) is not enough for repairs and maps of
/// a field on so many tets.
void require_memory_of_tets(std::size_t tets, Remedy remedy);

/// The same for hexahedra.
void require_memory_of_hexahedra(double hexahedra);

}  // namespace crossgrain
