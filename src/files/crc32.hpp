// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace crossgrain {

/// The CRC-32 of bytes, as in ZIP and gzip files: it shows that a file was changed, but not whether on
/// purpose with the same sum. Unlike FNV-1a (checksum.hpp) it allows for bytes that are replaced, and takes a
/// third of a second for a gigabyte.
class Crc32 {
 public:
  void add(std::string_view bytes);

  /// Exchanges bytes for as many others, with `behind` bytes behind them.
  void replace(std::string_view old_bytes, std::string_view new_bytes, std::uint64_t behind);

  std::uint32_t value() const { return value_; }

  /// Eight hexadecimal digits.
  static std::string text_of(std::uint32_t value);
  std::string text() const { return text_of(value_); }

 private:
  std::uint32_t value_ = 0;
};

}  // namespace crossgrain
