// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

namespace crossgrain {

/// Type of a number in a file: one enumerator for each type of a binary encoding.
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

/// NumberType of the C++ type T.
template <class T>
constexpr NumberType number_type_of() {
  static_assert(std::is_arithmetic_v<T> && sizeof(T) <= 8);
  if constexpr (std::is_floating_point_v<T>) {
    return sizeof(T) == 4 ? NumberType::kFloat32 : NumberType::kFloat64;
  } else if constexpr (std::is_signed_v<T>) {
    constexpr NumberType kBySize[] = {NumberType::kInt8, NumberType::kInt16, NumberType::kInt32,
                                      NumberType::kInt64};
    return kBySize[std::bit_width(sizeof(T)) - 1];
  } else {
    constexpr NumberType kBySize[] = {NumberType::kUint8, NumberType::kUint16, NumberType::kUint32,
                                      NumberType::kUint64};
    return kBySize[std::bit_width(sizeof(T)) - 1];
  }
}

/// Name of a type in a format.
struct NumberTypeName {
  std::string_view name;
  NumberType type;
};

/// Returns the type with a name; nothing if the format has no such name.
template <class Equal = std::equal_to<>>
constexpr std::optional<NumberType> type_named(std::span<const NumberTypeName> names, std::string_view name,
                                               const Equal& equal = {}) {
  for (const NumberTypeName& entry : names) {
    if (equal(entry.name, name)) return entry.type;
  }
  return std::nullopt;
}

}  // namespace crossgrain
