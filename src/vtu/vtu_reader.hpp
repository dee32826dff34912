// SPDX-License-Identifier: Apache-2.0
// Reads .vtu files of vtu_writer.hpp, one array at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/message.hpp"
#include "crossgrain/types.hpp"
#include "files/descriptor.hpp"
#include "vtu/vtu_header.hpp"
#include "vtu/zlib_blocks.hpp"

namespace crossgrain {

/// Limit of lengths in results. Between this and its inverse squares and cubes neither overflow nor
/// underflow. The cube around a surface is far within (kSurfaceReach of surface/surface.hpp).
inline constexpr double kLargestLength = 1e102;

/// An open .vtu file. Only the layout of vtu_types.hpp is supported. Throws Error(kInput) for any other file,
/// including VTU in another encoding, and for one that is cut short.
class VtuFile {
 public:
  using Array = VtuHeader::Array;

  explicit VtuFile(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  std::size_t points() const { return header_.points; }
  std::size_t cells() const { return header_.cells; }
  const std::vector<Array>& arrays() const { return header_.arrays; }

  /// Returns the header of an array, or null.
  const Array* find(VtuSection section, std::string_view name) const { return header_.find(section, name); }

  /// Returns all values of an array, row after row. Throws Error(kInput) if it is missing or damaged, or has
  /// the wrong type, number of components or length.
  template <class T>
  std::vector<T> read(VtuSection section, std::string_view name, std::size_t components) const {
    const Array& array = require(section, name, number_type_of<T>(), components);
    const ZlibBlocks blocks = locate(array);
    std::vector<T> values(blocks.raw_bytes / sizeof(T));
    inflate(array, blocks, reinterpret_cast<char*>(values.data()));
    return values;
  }

  /// Returns the positions of all points. Throws Error(kInput) as `read` does, and if a coordinate is not a
  /// number or its magnitude is not below `limit`.
  std::vector<Vector3> read_points(double limit) const;

  /// Returns whether point indices and cell offsets have 64 bits; otherwise they have 32 (fits_32_bits).
  bool has_wide_indices() const;

 private:
  void parse_header(const std::string& text);
  std::string read_header() const;
  const Array& require(VtuSection section, std::string_view name, NumberType type,
                       std::size_t components) const;
  ZlibBlocks locate(const Array& array) const;
  void inflate(const Array& array, const ZlibBlocks& blocks, char* out) const;
  void read_at(std::uint64_t offset, void* out, std::size_t bytes) const;
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kSolveAgain) const;

  std::string name_;
  Descriptor descriptor_;
  std::uint64_t file_bytes_ = 0;
  VtuHeader header_;
};

}  // namespace crossgrain
