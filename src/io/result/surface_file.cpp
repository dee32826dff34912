// SPDX-License-Identifier: Apache-2.0
#include "io/result/surface_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "io/result/field_arrays.hpp"
#include "io/vtu/vtu_arrays.hpp"
#include "io/vtu/vtu_reader.hpp"
#include "io/vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

/// Limit of the coordinates of a surface (surface/surface.hpp).
constexpr double kLargestCoordinate = 1e100;

/// A surface as rows of the file. Crease points follow the vertices; no two cells share one.
struct SurfaceRows {
  explicit SurfaceRows(const SolvedSurface& surface)
      : vertices(surface.vertices), triangles(surface.triangles) {
    for (const std::vector<Vector3>& crease : surface.creases) {
      crease_points.insert(crease_points.end(), crease.begin(), crease.end());
      crease_ends.push_back(crease_points.size());
    }
  }

  std::size_t points() const { return vertices.size() + crease_points.size(); }
  std::size_t cells() const { return triangles.size() + crease_ends.size(); }
  std::size_t entries() const { return 3 * triangles.size() + crease_points.size(); }

  const Vector3& point(std::size_t i) const {
    return i < vertices.size() ? vertices[i] : crease_points[i - vertices.size()];
  }
  std::size_t entry(std::size_t i) const {
    const std::size_t of_triangles = 3 * triangles.size();
    return i < of_triangles ? triangles[i / 3][i % 3] : vertices.size() + (i - of_triangles);
  }
  std::size_t cell_end(std::size_t cell) const {
    return cell < triangles.size() ? 3 * (cell + 1)
                                   : 3 * triangles.size() + crease_ends[cell - triangles.size()];
  }

  const std::vector<Vector3>& vertices;
  const std::vector<std::array<std::uint32_t, 3>>& triangles;
  std::vector<Vector3> crease_points;
  std::vector<std::size_t> crease_ends;
};

template <class Index>
void add_cells(const SurfaceRows& rows, std::vector<VtuArray>& arrays) {
  arrays.push_back(vtu_array<Index>(VtuSection::kCells, "connectivity", 1, rows.entries(),
                                    [&rows](std::size_t begin, std::size_t end, Index* out) {
                                      for (std::size_t i = begin; i < end; ++i)
                                        *out++ = static_cast<Index>(rows.entry(i));
                                    }));
  arrays.push_back(vtu_array<Index>(VtuSection::kCells, "offsets", 1, rows.cells(),
                                    [&rows](std::size_t begin, std::size_t end, Index* out) {
                                      for (std::size_t i = begin; i < end; ++i)
                                        *out++ = static_cast<Index>(rows.cell_end(i));
                                    }));
}

std::vector<VtuArray> arrays_of(const SurfaceRows& rows) {
  std::vector<VtuArray> arrays;
  arrays.push_back(constant_array<std::uint32_t>(field_arrays::kSchema, {field_arrays::kSchemaNumber}));
  arrays.push_back(points_array(rows.points(), [&rows](std::size_t i) { return rows.point(i); }));
  if (fits_32_bits(rows.points(), rows.entries()))
    add_cells<std::int32_t>(rows, arrays);
  else
    add_cells<std::int64_t>(rows, arrays);
  arrays.push_back(vtu_array<std::uint8_t>(VtuSection::kCells, "types", 1, rows.cells(),
                                           [&rows](std::size_t begin, std::size_t end, std::uint8_t* out) {
                                             for (std::size_t i = begin; i < end; ++i)
                                               *out++ =
                                                   i < rows.triangles.size() ? kVtkTriangle : kVtkPolyLine;
                                           }));
  return arrays;
}

/// Builds a surface from the file's arrays. Points of creases must follow those of triangles, as written.
class SurfaceReader {
 public:
  explicit SurfaceReader(const VtuFile& file) : file_(file) {
    require(file.find(VtuSection::kFieldData, field_arrays::kSchema) != nullptr);
    const auto schema = file.read<std::uint32_t>(VtuSection::kFieldData, field_arrays::kSchema, 1);
    require(schema.size() == 1 && schema[0] == field_arrays::kSchemaNumber);
  }

  SolvedSurface read() const {
    return file_.has_wide_indices() ? read_cells<std::int64_t>() : read_cells<std::int32_t>();
  }

 private:
  template <class Index>
  SolvedSurface read_cells() const {
    const auto types = file_.read<std::uint8_t>(VtuSection::kCells, "types", 1);
    const auto ends = file_.read<Index>(VtuSection::kCells, "offsets", 1);
    const auto entries = file_.read<Index>(VtuSection::kCells, "connectivity", 1);
    require(types.size() == file_.cells() && ends.size() == types.size());
    const auto triangles = static_cast<std::size_t>(
        std::find_if(types.begin(), types.end(), [](auto type) { return type != kVtkTriangle; }) -
        types.begin());
    require(std::all_of(types.begin() + static_cast<std::ptrdiff_t>(triangles), types.end(),
                        [](auto type) { return type == kVtkPolyLine; }));
    require(3 * triangles <= entries.size() && file_.points() <= UINT32_MAX);

    const std::vector<Vector3> points = file_.read_points(kLargestCoordinate);
    const std::size_t crease_points = entries.size() - 3 * triangles;
    require(crease_points <= points.size());
    SolvedSurface surface;
    surface.vertices.assign(points.begin(), points.end() - static_cast<std::ptrdiff_t>(crease_points));
    surface.triangles.resize(triangles);
    for (std::size_t i = 0; i < triangles; ++i) {
      require(static_cast<std::size_t>(ends[i]) == 3 * (i + 1));
      for (std::size_t k = 0; k < 3; ++k) {
        const auto vertex = static_cast<std::size_t>(entries[3 * i + k]);
        require(vertex < surface.vertices.size());
        surface.triangles[i][k] = static_cast<std::uint32_t>(vertex);
      }
    }
    std::size_t begin = 3 * triangles;
    for (std::size_t cell = triangles; cell < types.size(); ++cell) {
      const auto end = static_cast<std::size_t>(ends[cell]);
      require(end >= begin + 2 && end <= entries.size());
      std::vector<Vector3>& crease = surface.creases.emplace_back();
      for (; begin < end; ++begin) {
        const std::size_t place = surface.vertices.size() + (begin - 3 * triangles);
        require(static_cast<std::size_t>(entries[begin]) == place);
        crease.push_back(points[place]);
      }
    }
    require(begin == entries.size());
    return surface;
  }

  void require(bool sound) const {
    if (!sound)
      throw Error(ErrorKind::kInput,
                  {file_.name(), "", "is not a surface written by crossgrain", Remedy::kSolveAgain});
  }

  const VtuFile& file_;
};

}  // namespace

void write_surface(OutputFile& file, const SolvedSurface& surface, const Monitor& monitor) {
  const SurfaceRows rows(surface);
  std::vector<VtuArray> arrays = arrays_of(rows);
  watch(arrays, monitor);
  write_vtu(file, rows.points(), rows.cells(), arrays);
  file.finish();
}

SurfaceSource surface_in(const std::filesystem::path& path) {
  std::error_code unknown;
  if (std::filesystem::status(path, unknown).type() == std::filesystem::file_type::not_found) return {};
  return SurfaceSource(
      [file = std::make_shared<const VtuFile>(path)] { return SurfaceReader(*file).read(); });
}

}  // namespace crossgrain
