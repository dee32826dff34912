// SPDX-License-Identifier: Apache-2.0
// VTK XML UnstructuredGrid files (.vtu): appended raw data in zlib blocks. See vtu_types.hpp for the layout.
//
// Data stream through: a few blocks at a time are filled by the caller and compressed in parallel, while
// those before them are written, so that memory does not grow with the field. Offsets and block sizes, which
// precede the data in the file, are put into their reserved places afterwards; compressing into memory first
// would hold the whole file there.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "files/output_file.hpp"
#include "io/vtu/vtu_types.hpp"
#include "io/vtu/zlib_packer.hpp"

namespace crossgrain {

/// An array to be written: `tuples` rows of `components` values.
struct VtuArray {
  VtuSection section;
  std::string name;
  VtuType type;
  std::size_t components;
  std::size_t tuples;
  /// Writes rows [begin, end) to `out`; called for disjoint ranges at once from several threads. `out` is
  /// aligned for any type.
  std::function<void(std::size_t begin, std::size_t end, void* out)> produce;
  VtuPacking packing = VtuPacking::kRepetitions;
};

/// An array of T from produce(begin, end, T* out).
template <class T, class Produce>
VtuArray vtu_array(VtuSection section, std::string name, std::size_t components, std::size_t tuples,
                   Produce produce, VtuPacking packing = VtuPacking::kRepetitions) {
  return {section,
          std::move(name),
          vtu_type_of<T>(),
          components,
          tuples,
          [produce = std::move(produce)](std::size_t begin, std::size_t end, void* out) {
            produce(begin, end, static_cast<T*>(out));
          },
          packing};
}

struct VtuOptions {
  /// Of zlib, 1 to 9. On the points, indices and axes of a field 6 takes eight times as long as 1 and its
  /// files are 2 % larger.
  int compression_level = 1;
};

/// Writes a grid of `points` points and `cells` cells. Arrays keep their order within a section; point data
/// must have a row for each point, cell data for each cell. The bytes do not depend on the number of threads.
/// Throws Error(kOutput), and what a producer throws. `file` must be a regular file.
void write_vtu(OutputFile& file, std::size_t points, std::size_t cells, const std::vector<VtuArray>& arrays,
               const VtuOptions& options = {});

}  // namespace crossgrain
