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
#include <optional>
#include <string_view>

#include "text/number_type.hpp"

namespace crossgrain {

/// Begins the tag before the data.
inline constexpr std::string_view kVtuDataTag = "<AppendedData";

inline constexpr std::array kVtuTypeNames = {
    NumberTypeName{"Float32", NumberType::kFloat32}, NumberTypeName{"Float64", NumberType::kFloat64},
    NumberTypeName{"Int32", NumberType::kInt32},     NumberTypeName{"Int64", NumberType::kInt64},
    NumberTypeName{"UInt8", NumberType::kUint8},     NumberTypeName{"UInt32", NumberType::kUint32},
    NumberTypeName{"UInt64", NumberType::kUint64},   NumberTypeName{"Int8", NumberType::kInt8},
    NumberTypeName{"Int16", NumberType::kInt16},     NumberTypeName{"UInt16", NumberType::kUint16},
};

constexpr std::string_view vtu_name_of(NumberType type) {
  for (const NumberTypeName& entry : kVtuTypeNames) {
    if (entry.type == type) return entry.name;
  }
  return {};
}

/// Section of the file that holds an array, in the order of the file. kPoints holds the positions; kCells
/// holds "connectivity", "offsets" and, unless all are polylines, "types".
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
