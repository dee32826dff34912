// SPDX-License-Identifier: Apache-2.0
// Parses the header of a PLY file: its elements in order, and the properties of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/input_file.hpp"
#include "text/number_type.hpp"

namespace crossgrain {

struct PlyProperty {
  std::string name;
  NumberType type;       ///< of the value, or of each item of a list
  bool is_list = false;  ///< a count of `count_type`, then that many items
  NumberType count_type{};
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes of one binary row when all its lists are empty.
  std::size_t least_row_bytes() const;
};

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::size_t body_begin = 0;  ///< the byte after the header
  std::size_t body_line = 1;   ///< the line that byte is on
};

/// Parses the header. Counts are those of the header, not checked against the file. Throws Error(kInput)
/// naming the line.
PlyHeader read_ply_header(const InputFile& file);

}  // namespace crossgrain
