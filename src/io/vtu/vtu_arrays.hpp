// SPDX-License-Identifier: Apache-2.0
// Arrays that the files of more than one kind of grid have.
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
#include "io/vtu/vtu_writer.hpp"

namespace crossgrain {

/// A vector as it stands in memory, which must outlive the array.
template <class T>
VtuArray stored_array(VtuSection section, const char* name, const std::vector<T>& values) {
  const auto copy = [&values](std::size_t begin, std::size_t end, T* out) {
    std::copy(values.begin() + static_cast<std::ptrdiff_t>(begin),
              values.begin() + static_cast<std::ptrdiff_t>(end), out);
  };
  constexpr bool kIsMeasured = std::is_floating_point_v<T>;
  return vtu_array<T>(section, name, 1, values.size(), copy,
                      kIsMeasured ? VtuPacking::kMeasured : VtuPacking::kRepetitions);
}

/// Rows of `components` floats, row i from row_of(i), any sequence of as many numbers.
template <class RowOf>
VtuArray float_array(VtuSection section, const char* name, std::size_t components, std::size_t rows,
                     RowOf row_of) {
  return vtu_array<float>(
      section, name, components, rows,
      [row_of = std::move(row_of)](std::size_t begin, std::size_t end, float* out) {
        for (std::size_t i = begin; i < end; ++i) {
          for (const double value : row_of(i)) *out++ = static_cast<float>(value);
        }
      },
      VtuPacking::kMeasured);
}

/// axis_u, axis_v and axis_w of the unit quaternions frame_of(i), i < count.
template <class FrameOf>
void add_axes(VtuSection section, std::size_t count, const FrameOf& frame_of, std::vector<VtuArray>& arrays) {
  const std::array names{"axis_u", "axis_v", "axis_w"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    arrays.push_back(float_array(section, names[k], 3, count,
                                 [frame_of, k](std::size_t i) { return axes_of(frame_of(i))[k]; }));
  }
}

/// Whether 32 bits do for a connectivity of `entries` numbers of `points` points, and for its offsets: it
/// takes half the time then, and less space.
inline bool fits_32_bits(std::size_t points, std::size_t entries) {
  return std::max(points, entries) <= std::numeric_limits<std::int32_t>::max();
}

/// "offsets", of the same integer type as the connectivity, and "types" of `cells` cells that all have
/// `corners` corners and the same VTK type.
template <class Index>
void add_uniform_cells(std::size_t cells, std::size_t corners, std::uint8_t vtk_type,
                       std::vector<VtuArray>& arrays) {
  arrays.push_back(vtu_array<Index>(VtuSection::kCells, "offsets", 1, cells,
                                    [corners](std::size_t begin, std::size_t end, Index* out) {
                                      for (std::size_t i = begin; i < end; ++i)
                                        *out++ = static_cast<Index>(corners * (i + 1));
                                    }));
  arrays.push_back(vtu_array<std::uint8_t>(VtuSection::kCells, "types", 1, cells,
                                           [vtk_type](std::size_t begin, std::size_t end, std::uint8_t* out) {
                                             std::fill_n(out, end - begin, vtk_type);
                                           }));
}

/// Makes the arrays ask the monitor between blocks whether to go on. It must outlive them.
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
