// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_memory.hpp"

#include <fmt/format.h>

#include "base/required_memory.hpp"

namespace crossgrain {

void require_memory_of_tets(std::size_t tets, Remedy remedy) {
  require_memory(kBytesOfTet * static_cast<double>(tets), fmt::format("a field on {} tets", tets), remedy);
}

void require_memory_of_hexahedra(double hexahedra) {
  require_memory(kBytesOfHexahedron * hexahedra, fmt::format("a mesh of about {:.2g} hexahedra", hexahedra),
                 Remedy::kTakeFewerHexahedra);
}

}  // namespace crossgrain
