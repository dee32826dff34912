// SPDX-License-Identifier: Apache-2.0
// Small sound inputs for every reader, made on the spot: what mutations start from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crossgrain {

/// For the reader of that name (readers_under_test); at least one.
std::vector<std::string> made_inputs(std::string_view reader);

std::vector<std::string> made_stl();
std::vector<std::string> made_obj();
std::vector<std::string> made_ply();
std::vector<std::string> made_off();

}  // namespace crossgrain
