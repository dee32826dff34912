// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace crossgrain::app {

/// Returns the columns of the terminal that a file descriptor leads to; 80 if it leads to none, or to one
/// that does not tell.
std::size_t terminal_width(int descriptor);

}  // namespace crossgrain::app
