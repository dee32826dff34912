// SPDX-License-Identifier: Apache-2.0
// Writes VTK XML files, UnstructuredGrid (.vtu) and PolyData (.vtp): appended raw data in zlib blocks. See
// vtu_types.hpp for the layout.
//
// Data are streamed: the caller fills a few blocks, which are compressed in parallel while those before them
// are written, so memory does not grow with the field. Offsets and block sizes precede the data in the file;
// they are written into reserved space afterwards. Compressing first would need the whole file in memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "files/output_file.hpp"
#include "vtu/vtu_types.hpp"
#include "vtu/zlib_packer.hpp"

namespace crossgrain {

/// An array to write: `tuples` rows of `components` values.
struct VtuArray {
  VtuSection section;
  std::string name;
  NumberType type;
  std::size_t components;
  std::size_t tuples;
  /// Writes rows [begin, end) to `out`. Called for disjoint ranges from several threads at once. `out` is
  /// aligned for any type.
  std::function<void(std::size_t begin, std::size_t end, void* out)> produce;
  VtuPacking packing = VtuPacking::kAlways;
};

/// Returns an array of T from produce(begin, end, T* out).
template <class T, class Produce>
VtuArray vtu_array(VtuSection section, std::string name, std::size_t components, std::size_t tuples,
                   Produce produce, VtuPacking packing = VtuPacking::kAlways) {
  return {section,
          std::move(name),
          number_type_of<T>(),
          components,
          tuples,
          [produce = std::move(produce)](std::size_t begin, std::size_t end, void* out) {
            produce(begin, end, static_cast<T*>(out));
          },
          packing};
}

/// Writes a grid of `points` points and `cells` cells. Arrays keep their order within a section; point data
/// must have one row per point, cell data one per cell. The bytes do not depend on the number of threads.
/// Throws Error(kOutput), and what a producer throws. `file` must be a regular file.
void write_vtu(OutputFile& file, std::size_t points, std::size_t cells, const std::vector<VtuArray>& arrays);

/// Writes polylines as PolyData in the same manner. Cells have no array of types.
void write_vtp(OutputFile& file, std::size_t points, std::size_t lines, const std::vector<VtuArray>& arrays);

}  // namespace crossgrain
