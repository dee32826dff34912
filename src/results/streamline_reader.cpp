// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

/// Lines do not share points; each line's points are consecutive.
template <class Index>
std::vector<AxisCurve> lines_of(const VtuFile& file) {
  const auto require = [&](bool sound) {
    if (!sound)
      throw Error(ErrorKind::kInput,
                  {file.name(), "", "its arrays make no streamlines", Remedy::kTraceStreamlines});
  };
  const std::vector<Vector3> points = file.read_points(kLargestLength);
  const auto ends = file.read<Index>(VtuSection::kCells, "offsets", 1);
  const auto axes = file.read<std::uint8_t>(VtuSection::kCellData, "axis", 1);
  require(ends.size() == file.cells() && axes.size() == file.cells());
  std::vector<AxisCurve> lines(ends.size());
  std::size_t next = 0;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const auto end = static_cast<std::size_t>(ends[line]);
    require(end >= next + 2 && end <= file.points() && axes[line] < 3);
    lines[line].axis = axes[line];
    for (; next < end; ++next) lines[line].points.push_back(points[next]);
  }
  require(next == file.points());
  return lines;
}

}  // namespace

std::vector<AxisCurve> read_streamlines(const std::filesystem::path& path) {
  const VtuFile file(path);
  return file.has_wide_indices() ? lines_of<std::int64_t>(file) : lines_of<std::int32_t>(file);
}

}  // namespace crossgrain
