// SPDX-License-Identifier: Apache-2.0
#include "field/level_sharing.hpp"

#include <bit>

#include "field/nested_solve.hpp"

namespace crossgrain {

std::uint64_t identity_of(const Solid& solid, const SolveOptions& options) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&hash](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
    hash ^= hash >> 29;
  };
  for (std::size_t t = 0; t < solid.surface.size(); ++t) {
    for (const Vector3& corner : solid.surface.corners(static_cast<std::uint32_t>(t)))
      for (const double x : corner) add(x);
  }
  add(finest_cell_size(solid.surface.box, options));
  add(static_cast<double>(options.degree));
  add(static_cast<double>(options.seed));
  return hash;
}

}  // namespace crossgrain
