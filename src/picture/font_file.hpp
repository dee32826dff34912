// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace crossgrain {

/// DejaVuSans.ttf, as it was when the library was built (cmake/CrossgrainEmbed.cmake).
std::string_view font_file();

}  // namespace crossgrain
