// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace crossgrain {

/// What a number in a file is, one enumerator for each kind that a binary encoding can hold.
enum class NumberType : std::uint8_t {
  kFloat32,
  kFloat64,
  kInt32,
  kInt64,
  kUint8,
  kUint32,
  kUint64,
  kInt8,
  kInt16,
  kUint16
};

constexpr std::size_t size_of(NumberType type) {
  switch (type) {
    case NumberType::kInt8:
    case NumberType::kUint8:
      return 1;
    case NumberType::kInt16:
    case NumberType::kUint16:
      return 2;
    case NumberType::kFloat32:
    case NumberType::kInt32:
    case NumberType::kUint32:
      return 4;
    default:
      return 8;
  }
}

constexpr bool is_integer(NumberType type) {
  return type != NumberType::kFloat32 && type != NumberType::kFloat64;
}

}  // namespace crossgrain
