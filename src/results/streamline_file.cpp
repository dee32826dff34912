// SPDX-License-Identifier: Apache-2.0
// Writes streamlines as polylines in the format that the name of the file says (docs/streamlines.md). Lines
// do not share points.
#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/writing.hpp"
#include "files/file_mark.hpp"
#include "files/output_file.hpp"
#include "mesh_files/mesh_formats.hpp"
#include "text/text_lines.hpp"
#include "vtu/vtu_arrays.hpp"

namespace crossgrain {
namespace {

/// The lines, with prefix sums of their point counts.
class LinesInFile {
 public:
  explicit LinesInFile(std::span<const Streamline> lines) : lines_(lines), ends_(lines.size()) {
    for (std::size_t k = 0; k < lines.size(); ++k) ends_[k] = points_before(k) + lines[k].points.size();
    distances_.reserve(points());
    for (const Streamline& line : lines) add_distances(line);
  }

  std::size_t size() const { return lines_.size(); }
  std::size_t points() const { return points_before(lines_.size()); }
  std::size_t points_before(std::size_t line) const { return line == 0 ? 0 : ends_[line - 1]; }
  const Streamline& operator[](std::size_t line) const { return lines_[line]; }

  /// Signed distances from the seed along the line, one per point.
  const std::vector<float>& distances() const { return distances_; }

  /// Calls use(line, first, last) for the points of each line that are in rows [begin, end) of the file.
  template <class Use>
  void for_points(std::size_t begin, std::size_t end, const Use& use) const {
    auto line = static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), begin) - ends_.begin());
    for (; begin < end; begin = ends_[line++])
      use(lines_[line], begin - points_before(line), std::min(end, ends_[line]) - points_before(line));
  }

 private:
  void add_distances(const Streamline& line) {
    double to_seed = 0;
    for (std::size_t i = 1; i <= line.seed_point; ++i) to_seed += norm(line.points[i] - line.points[i - 1]);
    double along = -to_seed;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      if (i > 0) along += norm(line.points[i] - line.points[i - 1]);
      distances_.push_back(i == line.seed_point ? 0.0f : static_cast<float>(along));
    }
  }

  std::span<const Streamline> lines_;
  std::vector<std::size_t> ends_;  ///< one past each line's points, counted over all lines
  std::vector<float> distances_;
};

/// Rows of three numbers of T: vectors_of(line)[i] for each point i of each line.
template <class T, class VectorsOf>
VtuArray point_vectors(VtuSection section, const char* name, const LinesInFile& lines, VectorsOf vectors_of) {
  return vtu_array<T>(
      section, name, 3, lines.points(),
      [&lines, vectors_of](std::size_t begin, std::size_t end, T* out) {
        lines.for_points(begin, end, [&](const Streamline& line, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            for (const double x : vectors_of(line)[i]) *out++ = static_cast<T>(x);
          }
        });
      },
      VtuPacking::kMeasured);
}

/// One T per line.
template <class T, class ValueOf>
VtuArray line_array(const char* name, const LinesInFile& lines, ValueOf value_of) {
  return value_array<T>(VtuSection::kCellData, name, lines.size(),
                        [&lines, value_of](std::size_t k) { return value_of(lines[k]); });
}

void add_line_data(const LinesInFile& lines, std::vector<VtuArray>& arrays) {
  arrays.push_back(
      line_array<std::uint32_t>("seed", lines, [](const Streamline& line) { return line.seed; }));
  arrays.push_back(line_array<std::uint8_t>("axis", lines, [](const Streamline& line) { return line.axis; }));
  arrays.push_back(line_array<float>("length", lines, [](const Streamline& line) { return line.length; }));
  arrays.push_back(
      line_array<std::uint8_t>("first_end", lines, [](const Streamline& line) { return line.first_end; }));
  arrays.push_back(
      line_array<std::uint8_t>("last_end", lines, [](const Streamline& line) { return line.last_end; }));
}

template <class Index>
void add_polylines(const LinesInFile& lines, std::vector<VtuArray>& arrays) {
  arrays.push_back(value_array<Index>(VtuSection::kCells, "connectivity", lines.points(), std::identity()));
  arrays.push_back(value_array<Index>(VtuSection::kCells, "offsets", lines.size(),
                                      [&lines](std::size_t k) { return lines.points_before(k + 1); }));
}

/// All that files of VTK have of the lines, but the types of the cells.
std::vector<VtuArray> vtk_arrays(const LinesInFile& lines) {
  std::vector<VtuArray> arrays;
  arrays.push_back(point_vectors<float>(
      VtuSection::kPointData, "tangent", lines,
      [](const Streamline& line) -> const std::vector<Vector3>& { return line.tangents; }));
  arrays.push_back(stored_array(VtuSection::kPointData, "distance", lines.distances()));
  add_line_data(lines, arrays);
  arrays.push_back(point_vectors<double>(
      VtuSection::kPoints, "Points", lines,
      [](const Streamline& line) -> const std::vector<Vector3>& { return line.points; }));
  if (fits_32_bits(lines.points(), lines.points()))
    add_polylines<std::int32_t>(lines, arrays);
  else
    add_polylines<std::int64_t>(lines, arrays);
  return arrays;
}

void write_vtu_lines(OutputFile& file, const LinesInFile& lines, const Monitor& monitor) {
  std::vector<VtuArray> arrays = vtk_arrays(lines);
  arrays.push_back(uniform_types(lines.size(), kVtkPolyLine));
  watch(arrays, monitor);
  write_vtu(file, lines.points(), lines.size(), arrays);
}

void write_vtp_lines(OutputFile& file, const LinesInFile& lines, const Monitor& monitor) {
  std::vector<VtuArray> arrays = vtk_arrays(lines);
  watch(arrays, monitor);
  write_vtp(file, lines.points(), lines.size(), arrays);
}

/// The points of all lines, then each line by their numbers from 1; without tangents and numbers of lines,
/// for which the format has no place.
void write_obj_lines(OutputFile& file, const LinesInFile& lines, const Monitor& monitor) {
  file.write(text_mark("lines along the axes of a field", file.solve()));
  std::vector<Vector3> points;
  points.reserve(lines.points());
  for (std::size_t k = 0; k < lines.size(); ++k)
    points.insert(points.end(), lines[k].points.begin(), lines[k].points.end());
  const auto put_point = [&points](std::size_t i, char* out) {
    const auto& [x, y, z] = points[i];
    *out++ = 'v';
    *out++ = ' ';
    return put_shortest(put_shortest(put_shortest(out, x, ' '), y, ' '), z, '\n');
  };
  write_text_lines(file, points.size(), 3 * kNumberBytes + 2, put_point, monitor);
  // A line takes a text of its own, as lines are of any length.
  for (std::size_t k = 0; k < lines.size(); ++k) {
    monitor.check();
    std::string text = "l";
    for (std::size_t i = lines.points_before(k); i < lines.points_before(k + 1);)
      text += ' ' + std::to_string(++i);
    file.write(text + '\n');
  }
}

constexpr std::array kLineFormats{MeshFormat<LinesInFile>{".vtu", write_vtu_lines, SealForm::kXml},
                                  MeshFormat<LinesInFile>{".vtp", write_vtp_lines},
                                  MeshFormat<LinesInFile>{".obj", write_obj_lines}};

const MeshFormat<LinesInFile>& line_format_of(const std::filesystem::path& path) {
  return format_of<LinesInFile>(path, kLineFormats, "streamlines");
}

void check_lines(std::span<const Streamline> lines) {
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Streamline& line = lines[k];
    if (line.tangents.size() == line.points.size() && line.seed_point < line.points.size()) continue;
    throw Error(ErrorKind::kUsage,
                "streamline " + std::to_string(k) +
                    " (counted from 0) must have a tangent for each point, and its seed among the points");
  }
}

}  // namespace

void check_streamline_file(const std::filesystem::path& path) {
  line_format_of(path);
  OutputFile{path};
}

void write_streamlines(std::span<const Streamline> lines, const std::filesystem::path& path,
                       const Monitor& monitor, const std::string& solve) {
  const MeshFormat<LinesInFile>& format = line_format_of(path);
  check_lines(lines);
  OutputFile file(path);
  file.set_solve(solve);
  format.write(file, LinesInFile(lines), monitor);
  if (format.seal) write_seal(file, *format.seal);
  file.commit();
}

}  // namespace crossgrain
