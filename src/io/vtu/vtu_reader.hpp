// SPDX-License-Identifier: Apache-2.0
// Reads back the .vtu files that vtu_writer.hpp writes, an array at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/message.hpp"
#include "io/vtu/vtu_types.hpp"
#include "io/vtu/zlib_blocks.hpp"

namespace crossgrain {

/// A .vtu file, open for reading. Only the layout of vtu_types.hpp is understood; any other file, also a VTU
/// in another encoding, and a file cut short throw Error(kInput).
class VtuFile {
 public:
  struct Array {
    VtuSection section;
    std::string name;
    VtuType type;
    std::size_t components;
    std::uint64_t offset;  ///< from the begin of the data
  };

  explicit VtuFile(const std::filesystem::path& path);
  ~VtuFile();
  VtuFile(const VtuFile&) = delete;
  VtuFile& operator=(const VtuFile&) = delete;

  const std::string& name() const { return name_; }
  std::size_t points() const { return points_; }
  std::size_t cells() const { return cells_; }
  const std::vector<Array>& arrays() const { return arrays_; }

  /// Null where there is none.
  const Array* find(VtuSection section, std::string_view name) const;

  /// All values of an array, row after row. Throws Error(kInput) where it is missing, of another type or
  /// number of components, damaged, or of another length than the grid.
  template <class T>
  std::vector<T> read(VtuSection section, std::string_view name, std::size_t components) const {
    const Array& array = require(section, name, vtu_type_of<T>(), components);
    const ZlibBlocks blocks = locate(array);
    std::vector<T> values(blocks.raw_bytes / sizeof(T));
    inflate(array, blocks, reinterpret_cast<char*>(values.data()));
    return values;
  }

 private:
  void parse_header(const std::string& header);
  std::string read_header() const;
  const Array& require(VtuSection section, std::string_view name, VtuType type, std::size_t components) const;
  ZlibBlocks locate(const Array& array) const;
  void inflate(const Array& array, const ZlibBlocks& blocks, char* out) const;
  void read_at(std::uint64_t offset, void* out, std::size_t bytes) const;
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kSolveAgain) const;

  std::string name_;
  int descriptor_ = -1;
  std::uint64_t file_bytes_ = 0;
  std::uint64_t data_begin_ = 0;
  std::size_t points_ = 0;
  std::size_t cells_ = 0;
  std::vector<Array> arrays_;
};

}  // namespace crossgrain
