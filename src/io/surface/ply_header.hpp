// SPDX-License-Identifier: Apache-2.0
// The header of a PLY file: which elements it holds, in which order, and the properties of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/input_file.hpp"

namespace crossgrain {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;          ///< of the value, or of each item of a list
  bool is_list = false;  ///< a count of `count_type`, then as many items
  PlyType count_type{};
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes of one binary row when all its lists are empty.
  std::size_t least_row_bytes() const;
  bool has_list() const;
};

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::size_t body_begin = 0;  ///< the byte after the header
  std::size_t body_line = 1;   ///< the line that byte is on
};

/// Throws Error(kInput) naming the line. Counts are as the header claims them, not checked against the file.
PlyHeader read_ply_header(const InputFile& file);

}  // namespace crossgrain
