// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>

#include "crossgrain/error.hpp"
#include "io/result/streamline_file.hpp"
#include "io/vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

constexpr double kLargestCoordinate = 1e102;

/// Lines have their points to themselves, one after the other.
template <class Index>
std::vector<std::vector<Vector3>> lines_of(const VtuFile& file) {
  const auto require = [&](bool sound) {
    if (!sound)
      throw Error(ErrorKind::kInput,
                  {file.name(), "", "its arrays make no streamlines", Remedy::kTraceStreamlines});
  };
  const auto numbers = file.read<double>(VtuSection::kPoints, "Points", 3);
  const auto ends = file.read<Index>(VtuSection::kCells, "offsets", 1);
  require(ends.size() == file.cells());
  std::vector<std::vector<Vector3>> lines(ends.size());
  std::size_t next = 0;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const auto end = static_cast<std::size_t>(ends[line]);
    require(end >= next + 2 && end <= file.points());
    for (; next < end; ++next) {
      const Vector3 point{numbers[3 * next], numbers[3 * next + 1], numbers[3 * next + 2]};
      for (const double x : point) require(std::abs(x) < kLargestCoordinate);
      lines[line].push_back(point);
    }
  }
  require(next == file.points());
  return lines;
}

}  // namespace

std::vector<std::vector<Vector3>> read_streamline_points(const std::filesystem::path& path) {
  const VtuFile file(path);
  const VtuFile::Array* ends = file.find(VtuSection::kCells, "offsets");
  const bool is_wide = ends != nullptr && ends->type == vtu_type_of<std::int64_t>();
  return is_wide ? lines_of<std::int64_t>(file) : lines_of<std::int32_t>(file);
}

}  // namespace crossgrain
