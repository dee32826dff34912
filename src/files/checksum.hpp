// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace crossgrain {

/// The checksum FNV-1a of 64 bits (RFC 9923), long enough to tell apart all results that somebody keeps. A
/// gigabyte takes about a second.
class Checksum {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * kPrime;
  }

  std::uint64_t value() const { return value_; }

 private:
  static constexpr std::uint64_t kOffset = 0xcbf29ce484222325, kPrime = 0x100000001b3;

  std::uint64_t value_ = kOffset;
};

}  // namespace crossgrain
