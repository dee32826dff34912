// SPDX-License-Identifier: Apache-2.0
// Arrays that files of several kinds of grids share.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/monitor.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {

/// Numbers that are measured hardly get shorter by packing.
template <class T>
inline constexpr VtuPacking kUsualPacking =
    std::is_floating_point_v<T> ? VtuPacking::kMeasured : VtuPacking::kAlways;

/// Writes a vector as it stands in memory. It must outlive the array.
template <class T>
VtuArray stored_array(VtuSection section, const char* name, const std::vector<T>& values) {
  const auto copy = [&values](std::size_t begin, std::size_t end, T* out) {
    std::copy(values.begin() + static_cast<std::ptrdiff_t>(begin),
              values.begin() + static_cast<std::ptrdiff_t>(end), out);
  };
  return vtu_array<T>(section, name, 1, values.size(), copy, kUsualPacking<T>);
}

/// Rows of `components` numbers; row_of(i) returns row i, any sequence of that many numbers.
template <class T, class RowOf>
VtuArray row_array(VtuSection section, const char* name, std::size_t components, std::size_t rows,
                   RowOf row_of, VtuPacking packing = kUsualPacking<T>) {
  auto put = [row_of = std::move(row_of)](std::size_t begin, std::size_t end, T* out) {
    for (std::size_t i = begin; i < end; ++i)
      for (const auto value : row_of(i)) *out++ = static_cast<T>(value);
  };
  return vtu_array<T>(section, name, components, rows, std::move(put), packing);
}

/// A number value_of(i) for each row.
template <class T, class ValueOf>
VtuArray value_array(VtuSection section, const char* name, std::size_t rows, ValueOf value_of) {
  return row_array<T>(section, name, 1, rows, [value_of](std::size_t i) { return std::array{value_of(i)}; });
}

/// Arrays axis_u, axis_v and axis_w of the unit quaternions frame_of(i), i < count.
template <class FrameOf>
void add_axes(VtuSection section, std::size_t count, const FrameOf& frame_of, std::vector<VtuArray>& arrays) {
  const std::array names{"axis_u", "axis_v", "axis_w"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    arrays.push_back(row_array<float>(section, names[k], 3, count,
                                      [frame_of, k](std::size_t i) { return axes_of(frame_of(i))[k]; }));
  }
}

/// Positions of the points of the grid: point_of(i), i < count.
template <class PointOf>
VtuArray points_array(std::size_t count, PointOf point_of) {
  return row_array<double>(VtuSection::kPoints, "Points", 3, count, std::move(point_of));
}

/// Numbers that belong to the grid as a whole.
template <class T>
VtuArray constant_array(const char* name, std::vector<T> values) {
  const std::size_t count = values.size();
  return vtu_array<T>(VtuSection::kFieldData, name, count, 1,
                      [values = std::move(values)](std::size_t begin, std::size_t end, T* out) {
                        if (begin < end) std::ranges::copy(values, out);
                      });
}

// Types of cells (vtkCellType.h).
inline constexpr std::uint8_t kVtkLine = 3, kVtkPolyLine = 4, kVtkTriangle = 5, kVtkTet = 10,
                              kVtkHexahedron = 12;

/// Array of types for `cells` cells of one type.
inline VtuArray uniform_types(std::size_t cells, std::uint8_t vtk_type) {
  return value_array<std::uint8_t>(VtuSection::kCells, "types", cells,
                                   [vtk_type](std::size_t) { return vtk_type; });
}

/// Returns whether 32-bit indices suffice for a connectivity of `entries` indices of `points` points, and for
/// its offsets. They halve the time and take less space.
inline bool fits_32_bits(std::size_t points, std::size_t entries) {
  return std::max(points, entries) <= std::numeric_limits<std::int32_t>::max();
}

/// Appends "offsets", of the same integer type as the connectivity, and "types" of `cells` cells that all
/// have `corners` corners and the same VTK type.
template <class Index>
void add_uniform_cells(std::size_t cells, std::size_t corners, std::uint8_t vtk_type,
                       std::vector<VtuArray>& arrays) {
  arrays.push_back(value_array<Index>(VtuSection::kCells, "offsets", cells,
                                      [corners](std::size_t i) { return corners * (i + 1); }));
  arrays.push_back(uniform_types(cells, vtk_type));
}

/// Makes the arrays query the monitor between blocks. It must outlive them.
inline void watch(std::vector<VtuArray>& arrays, const Monitor& monitor) {
  for (VtuArray& array : arrays) {
    array.produce = [produce = std::move(array.produce), &monitor](std::size_t begin, std::size_t end,
                                                                   void* out) {
      monitor.check();
      produce(begin, end, out);
    };
  }
}

}  // namespace crossgrain
