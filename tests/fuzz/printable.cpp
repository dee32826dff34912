// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fuzz/reader_checks.hpp"

namespace crossgrain {

void require_one_line(std::string_view text) {
  constexpr std::size_t kLongest = 600;
  require(!text.empty() && text.size() <= kLongest, "a message of " + std::to_string(text.size()) + " bytes");
  const bool printable = std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
  require(printable, "a message that cannot be printed: " + std::string(text));
}

}  // namespace crossgrain
