// SPDX-License-Identifier: Apache-2.0
// Streamlines as `write_streamlines` (crossgrain/io.hpp) has written them.
#pragma once

#include <filesystem>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The points of each line, two at least, model units. Throws Error(kInput) for any other file.
std::vector<std::vector<Vector3>> read_streamline_points(const std::filesystem::path& path);

}  // namespace crossgrain
