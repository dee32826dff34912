// SPDX-License-Identifier: Apache-2.0
// What the writer and the reader of VTU files agree upon.
//
//   <?xml ...?> <VTKFile ...> ... one <DataArray .../> for each array ... <AppendedData encoding="raw">
//   _ array array ...
//   </AppendedData></VTKFile>
//
// An array is raw little-endian data cut into blocks, each a zlib stream of its own, behind a header of
// unsigned 64-bit numbers:
//
//   blocks | bytes of a block | bytes of the last block if it is shorter, else 0 | compressed bytes of each
//
// Sizes in the first two are of the raw data. `offset` in a <DataArray> counts from the byte after '_'.
// (VTK file formats, "XML file formats", appended data, vtkZLibDataCompressor.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "io/text/number_type.hpp"

namespace crossgrain {

using VtuType = NumberType;

struct VtuTypeInfo {
  VtuType type;
  std::string_view name;
  std::size_t bytes;
};

inline constexpr std::array kVtuTypes = {
    VtuTypeInfo{VtuType::kFloat32, "Float32", 4}, VtuTypeInfo{VtuType::kFloat64, "Float64", 8},
    VtuTypeInfo{VtuType::kInt32, "Int32", 4},     VtuTypeInfo{VtuType::kInt64, "Int64", 8},
    VtuTypeInfo{VtuType::kUint8, "UInt8", 1},     VtuTypeInfo{VtuType::kUint32, "UInt32", 4},
    VtuTypeInfo{VtuType::kUint64, "UInt64", 8},   VtuTypeInfo{VtuType::kInt8, "Int8", 1},
    VtuTypeInfo{VtuType::kInt16, "Int16", 2},     VtuTypeInfo{VtuType::kUint16, "UInt16", 2},
};

constexpr std::optional<VtuType> vtu_type_named(std::string_view name) {
  for (const VtuTypeInfo& info : kVtuTypes) {
    if (info.name == name) return info.type;
  }
  return std::nullopt;
}

constexpr const VtuTypeInfo& info_of(VtuType type) {
  return kVtuTypes[static_cast<std::size_t>(type)];
}

/// The type that holds values of T.
template <class T>
constexpr VtuType vtu_type_of();
template <>
constexpr VtuType vtu_type_of<float>() {
  return VtuType::kFloat32;
}
template <>
constexpr VtuType vtu_type_of<double>() {
  return VtuType::kFloat64;
}
template <>
constexpr VtuType vtu_type_of<std::int32_t>() {
  return VtuType::kInt32;
}
template <>
constexpr VtuType vtu_type_of<std::int64_t>() {
  return VtuType::kInt64;
}
template <>
constexpr VtuType vtu_type_of<std::uint8_t>() {
  return VtuType::kUint8;
}
template <>
constexpr VtuType vtu_type_of<std::uint32_t>() {
  return VtuType::kUint32;
}
template <>
constexpr VtuType vtu_type_of<std::uint64_t>() {
  return VtuType::kUint64;
}

/// Where an array stands in the file, in the order of the file. kPoints holds the one array of positions;
/// kCells holds "connectivity", "offsets" and "types".
enum class VtuSection { kFieldData, kPointData, kCellData, kPoints, kCells };

inline constexpr std::array<std::string_view, 5> kVtuSectionNames = {"FieldData", "PointData", "CellData",
                                                                     "Points", "Cells"};

constexpr std::string_view name_of(VtuSection section) {
  return kVtuSectionNames[static_cast<std::size_t>(section)];
}

constexpr std::optional<VtuSection> vtu_section_named(std::string_view name) {
  for (std::size_t i = 0; i < kVtuSectionNames.size(); ++i) {
    if (kVtuSectionNames[i] == name) return static_cast<VtuSection>(i);
  }
  return std::nullopt;
}

}  // namespace crossgrain
