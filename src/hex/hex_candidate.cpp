// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_candidate.hpp"

#include <tuple>

#include "fit/feature_fit.hpp"

namespace crossgrain {

bool is_good(const HexCandidate& candidate, double least_quality) {
  return candidate.is_filled() && candidate.made->is_faithful &&
         candidate.made->quality.least >= least_quality;
}

bool is_better_in_round(const HexCandidate& candidate, const HexCandidate& other, double least_quality) {
  const auto rank = [&](const HexCandidate& of) {
    const auto& made = of.made;
    return std::tuple(!is_good(of, least_quality), !of.is_filled(), !(made && made->are_complete()),
                      !(made && made->fills), made ? made->left_out + made->quality.inverted : SIZE_MAX,
                      of.attempt.faults, of.attempt.arcs_without_length);
  };
  return rank(candidate) < rank(other);
}

bool is_better(const HexCandidate& candidate, const HexCandidate& other, double least_quality) {
  const auto rank = [&](const HexCandidate& of) {
    const bool is_complete = of.made && of.made->are_complete();
    const bool is_usable = is_complete && of.made->quality.least >= kPoorestShape;
    return std::tuple(!is_good(of, least_quality), !(is_usable && of.made->is_faithful), !is_usable,
                      !is_complete, !(of.made && of.made->fills), of.made ? of.made->volume_missed : 1);
  };
  return rank(candidate) < rank(other);
}

}  // namespace crossgrain
