// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace crossgrain::app {

/// Throws Error(kOutput) where standard output does not take all of it.
void print_result(const std::string& text);

/// `crossgrain: message` on standard error, whatever the message holds: one line.
void print_message(const std::string& message);

}  // namespace crossgrain::app
