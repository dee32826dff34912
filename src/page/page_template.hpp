// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace crossgrain {

/// viewer/dist/report.html, as it was when the library was built (cmake/CrossgrainEmbed.cmake).
std::string_view page_template();

}  // namespace crossgrain
