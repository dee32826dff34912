// SPDX-License-Identifier: Apache-2.0
#include "io/tet_making/tet_program.hpp"

namespace crossgrain {

std::unique_ptr<TetProgram> netgen_tets(const std::filesystem::path&) {
  return nullptr;
}

}  // namespace crossgrain
