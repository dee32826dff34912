// SPDX-License-Identifier: Apache-2.0
// Decodes arrays of VTK XML files ("VTK file formats", XML formats; vtu_types.hpp describes the layout of
// compressed ones).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "text/number_type.hpp"

namespace crossgrain {

/// Encoding of all arrays of a file.
struct VtuPackage {
  NumberType header_type = NumberType::kUint32;  ///< of the numbers before the data
  bool is_swapped = false;                       ///< byte order other than this machine's
  bool is_compressed = false;                    ///< blocks of zlib
};

/// Returns the decoded bytes, in the byte order of the file, of the array at the start of `text`, which is
/// base64 or raw and may continue beyond the array. Nothing if it is cut short or damaged. Allocates memory
/// for what `text` contains, not for what it claims, and within the limits of reading the file `name`
/// (files/read_memory.hpp).
std::optional<std::string> unpack_vtu_data(const std::string& name, std::string_view text, bool is_base64,
                                           const VtuPackage& package);

}  // namespace crossgrain
