// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "crossgrain/result_folder.hpp"

namespace crossgrain {

/// Returns read(), which reads files of a result, all of one solve: again if the result is replaced
/// meanwhile.
template <class Read>
auto read_one_solve(const std::filesystem::path& folder, const Read& read) {
  for (std::string solve = solve_of_result(folder);;) {
    std::exception_ptr failure;
    std::optional<decltype(read())> value;
    try {
      value.emplace(read());
    } catch (...) {
      failure = std::current_exception();
    }
    const std::string before = std::exchange(solve, solve_of_result(folder));
    if (solve != before) continue;
    if (failure) std::rethrow_exception(failure);
    return std::move(*value);
  }
}

}  // namespace crossgrain
