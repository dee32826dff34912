// SPDX-License-Identifier: Apache-2.0
// Names of arrays in the files in VTK's XML that the library writes and knows again.
#pragma once

#include <cstdint>

namespace crossgrain {

/// Names in field.vtu. The first six are field data: numbers of the whole field, then one row per cell. The
/// next three are cell data.
namespace field_arrays {
inline constexpr const char* kSchema = "crossgrain_schema";      ///< 1 x UInt32
inline constexpr const char* kDegree = "degree";                 ///< 1 x UInt32: 3 or 4
inline constexpr const char* kRootCube = "root_cube";            ///< 4 x Float64: low corner, side
inline constexpr const char* kCellAddress = "cell_address";      ///< UInt64, as CellAddress::packed
inline constexpr const char* kFrame = "frame";                   ///< 4 x Float32: w, x, y, z of a quaternion
inline constexpr const char* kOpenFaces = "open_faces";          ///< UInt8, as FieldData::open_faces
inline constexpr const char* kEnergyDensity = "energy_density";  ///< Float32
inline constexpr const char* kAlignment = "alignment_deg";       ///< Float32
inline constexpr const char* kOnBoundary = "is_boundary";        ///< UInt8

/// Optional cell data that are read if present: `region` only for models of several solids.
inline constexpr const char* kConstraint = "constraint_class";  ///< UInt8, as FieldData::constraints
inline constexpr const char* kRegion = "region";                ///< Int32, as FieldData::regions

/// Cell data of the tets of a repaired field, in onto.vtu.
inline constexpr const char* kTetFrame = "tet_frame";  ///< 4 x Float64: w, x, y, z of a quaternion
inline constexpr const char* kMatching = "matching";   ///< 12 x Int8: axes behind the four faces

/// Field data of files that hold part of a field; they tell which part and are not read.
inline constexpr const char* kOutputLevel = "output_level";  ///< 1 x UInt32: OutputOptions::level
inline constexpr const char* kClipBox = "clip_box";  ///< 6 x Float64: low and high of OutputOptions::clip

/// Incremented when one of these arrays changes its meaning.
inline constexpr std::uint32_t kSchemaNumber = 1;
}  // namespace field_arrays

}  // namespace crossgrain
