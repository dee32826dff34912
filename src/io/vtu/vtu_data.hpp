// SPDX-License-Identifier: Apache-2.0
// The bytes of arrays of VTK XML files, out of whatever they are packed in ("VTK file formats", XML formats;
// vtu_types.hpp has the layout of compressed ones).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/text/number_type.hpp"

namespace crossgrain {

/// How all arrays of a file are packed.
struct VtuPackage {
  NumberType header_type = NumberType::kUint32;  ///< of the numbers before the data
  bool is_swapped = false;                       ///< in the other byte order than this machine
  bool is_compressed = false;                    ///< blocks of zlib
};

/// The bytes of the array at the front of `text`, which is base64 or raw and may go on behind it; still in
/// the byte order of the file. Nothing where it is cut short or damaged. Takes memory for what `text` holds,
/// not for what it claims.
std::optional<std::string> unpack_vtu_data(std::string_view text, bool is_base64, const VtuPackage& package);

}  // namespace crossgrain
