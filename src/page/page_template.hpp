// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace crossgrain {

/// The content of viewer/dist/report.html at build time (cmake/CrossgrainEmbed.cmake).
std::string_view page_template();

}  // namespace crossgrain
