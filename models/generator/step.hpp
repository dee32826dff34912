// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>

namespace crossgrain::models {

/// Writes STEP (AP214, millimetres), the same bytes on every run. Throws std::runtime_error if that fails.
void write_step(const std::filesystem::path& path, const TopoDS_Shape& solid);

}  // namespace crossgrain::models
