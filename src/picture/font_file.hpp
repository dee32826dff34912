// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace crossgrain {

/// The content of DejaVuSans.ttf at build time (cmake/CrossgrainEmbed.cmake).
std::string_view font_file();

}  // namespace crossgrain
