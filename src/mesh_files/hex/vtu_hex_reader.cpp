// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/hex/vtu_hex_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

#include "crossgrain/error.hpp"
#include "mesh_files/hex/hex_arrays.hpp"
#include "mesh_files/hex/hex_groups.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_arrays.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

class HexReader {
 public:
  explicit HexReader(const std::filesystem::path& path) : file_(path) {}

  HexMesh read() const {
    HexMesh mesh;
    require(file_.points() <= std::numeric_limits<std::uint32_t>::max());
    mesh.vertices = file_.read_points(kLargestLength);
    if (file_.has_wide_indices())
      read_cells<std::int64_t>(mesh);
    else
      read_cells<std::int32_t>(mesh);
    if (file_.find(VtuSection::kCellData, field_arrays::kRegion))
      mesh.regions = file_.read<std::int32_t>(VtuSection::kCellData, field_arrays::kRegion, 1);
    require(mesh.regions.empty() || mesh.regions.size() == mesh.hexahedra.size());
    check_boundary(mesh);
    mesh.is_partial = file_.find(VtuSection::kFieldData, hex_arrays::kPartial) != nullptr;
    return mesh;
  }

 private:
  template <class Index>
  void read_cells(HexMesh& mesh) const {
    const auto types = file_.read<std::uint8_t>(VtuSection::kCells, "types", 1);
    require(types.size() == file_.cells() &&
            std::ranges::all_of(types, [](std::uint8_t type) { return type == kVtkHexahedron; }));
    const auto ends = file_.read<Index>(VtuSection::kCells, "offsets", 1);
    require(ends.size() == file_.cells());
    for (std::size_t k = 0; k < ends.size(); ++k) require(static_cast<std::uint64_t>(ends[k]) == 8 * (k + 1));
    const auto corners = vertices<Index>(VtuSection::kCells, "connectivity", 1);
    require(corners.size() == 8 * file_.cells());
    mesh.hexahedra.resize(file_.cells());
    for (std::size_t k = 0; k < corners.size(); ++k) mesh.hexahedra[k / 8][k % 8] = corners[k];
    read_boundary<Index>(mesh);
  }

  template <class Index>
  void read_boundary(HexMesh& mesh) const {
    const auto corners = vertices<Index>(VtuSection::kFieldData, hex_arrays::kBoundary, 4);
    const auto tags = file_.read<std::int32_t>(VtuSection::kFieldData, hex_arrays::kBoundaryTag, 1);
    require(corners.size() == 4 * tags.size());
    mesh.boundary.resize(tags.size());
    for (std::size_t k = 0; k < corners.size(); ++k) mesh.boundary[k / 4].vertices[k % 4] = corners[k];
    for (std::size_t k = 0; k < tags.size(); ++k) mesh.boundary[k].tag = tags[k];
  }

  template <class Index>
  std::vector<std::uint32_t> vertices(VtuSection section, const char* name, std::size_t components) const {
    const std::vector<Index> read = file_.read<Index>(section, name, components);
    std::vector<std::uint32_t> indices(read.size());
    for (std::size_t k = 0; k < read.size(); ++k) {
      require(read[k] >= 0 && static_cast<std::uint64_t>(read[k]) < file_.points());
      indices[k] = static_cast<std::uint32_t>(read[k]);
    }
    return indices;
  }

  void check_boundary(const HexMesh& mesh) const {
    try {
      sides_of_boundary(mesh);
    } catch (const Error&) {
      require(false);
    }
  }

  void require(bool sound) const {
    if (!sound)
      throw Error(ErrorKind::kInput,
                  {file_.name(), "", "its arrays make no hexahedra", Remedy::kCopyOrSolveAgain});
  }

  VtuFile file_;
};

}  // namespace

bool is_written_vtu(const std::filesystem::path& path) {
  try {
    return VtuFile(path).find(VtuSection::kFieldData, hex_arrays::kBoundary) != nullptr;
  } catch (const Error&) {
    return false;
  }
}

HexMesh read_written_vtu(const std::filesystem::path& path) {
  return HexReader(path).read();
}

}  // namespace crossgrain
