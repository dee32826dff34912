// SPDX-License-Identifier: Apache-2.0
// Reads a field from the arrays of field.vtu.
#pragma once

#include <filesystem>
#include <vector>

#include "field/field_data.hpp"

namespace crossgrain {

/// Returns what write_field has written, bitwise identical, without the report: all of it from field.vtu, or
/// the pieces in their order. Throws Error(kInput) for any other files and for damaged ones.
FieldData read_field_arrays(const std::vector<std::filesystem::path>& files);

}  // namespace crossgrain
