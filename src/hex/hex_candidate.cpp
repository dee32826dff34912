// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_candidate.hpp"

#include <tuple>

namespace crossgrain {

bool is_good(const HexCandidate& candidate, double least_quality) {
  return candidate.is_filled() && candidate.made->quality.least >= least_quality;
}

bool is_better(const HexCandidate& candidate, const HexCandidate& other, double least_quality) {
  const auto rank = [&](const HexCandidate& of) {
    const bool has_mesh = of.made && !of.made->mesh.hexahedra.empty();
    return std::tuple(!is_good(of, least_quality), !(has_mesh && of.made->are_complete()), !has_mesh,
                      has_mesh ? of.made->volume_missed : 0, !of.made, of.attempt.faults,
                      of.attempt.arcs_without_length);
  };
  return rank(candidate) < rank(other);
}

}  // namespace crossgrain
