// SPDX-License-Identifier: Apache-2.0
#include "results/surface_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "results/result_files.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_arrays.hpp"
#include "vtu/vtu_reader.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

/// Cell data of a surface of several solids: the solid of a triangle, and that on the other side.
constexpr std::array kRegionArrays{field_arrays::kRegion, "region_beyond"};

/// Cell data: SolvedSurface::faces, 0 for interfaces and creases.
constexpr const char* kFaceArray = "face";

/// Entry of these arrays for cells without a solid.
constexpr std::int32_t kNoRegion = std::numeric_limits<std::int32_t>::min();

/// A surface as rows of the file: triangles of the surface, interfaces, creases. Crease points follow the
/// vertices; no two cells share one.
struct SurfaceRows {
  explicit SurfaceRows(const SolvedSurface& shown)
      : surface(shown),
        vertices(shown.vertices),
        triangles(shown.triangles.size() + shown.interfaces.size()) {
    for (const std::vector<Vector3>& crease : surface.creases) {
      crease_points.insert(crease_points.end(), crease.begin(), crease.end());
      crease_ends.push_back(crease_points.size());
    }
  }

  std::size_t points() const { return vertices.size() + crease_points.size(); }
  std::size_t cells() const { return triangles + crease_ends.size(); }
  std::size_t entries() const { return 3 * triangles + crease_points.size(); }

  const Vector3& point(std::size_t i) const {
    return i < vertices.size() ? vertices[i] : crease_points[i - vertices.size()];
  }
  std::size_t entry(std::size_t i) const {
    const std::size_t outer = surface.triangles.size();
    if (i / 3 < outer) return surface.triangles[i / 3][i % 3];
    if (i / 3 < triangles) return surface.interfaces[i / 3 - outer][i % 3];
    return vertices.size() + (i - 3 * triangles);
  }
  std::size_t cell_end(std::size_t cell) const {
    return cell < triangles ? 3 * (cell + 1) : 3 * triangles + crease_ends[cell - triangles];
  }

  /// The solid of a triangle, or one of the two of an interface; kNoRegion for a crease.
  std::int32_t region(std::size_t cell, std::size_t side) const {
    const std::size_t outer = surface.triangles.size();
    if (cell < outer) return side == 0 ? surface.regions[cell] : kNoRegion;
    return cell < triangles ? surface.interface_regions[cell - outer][side] : kNoRegion;
  }

  std::int32_t face(std::size_t cell) const {
    return cell < surface.triangles.size() ? surface.faces[cell] : 0;
  }

  const SolvedSurface& surface;
  const std::vector<Vector3>& vertices;
  std::size_t triangles;  ///< those of interfaces included
  std::vector<Vector3> crease_points;
  std::vector<std::size_t> crease_ends;
};

template <class Index>
void add_cells(const SurfaceRows& rows, std::vector<VtuArray>& arrays) {
  arrays.push_back(value_array<Index>(VtuSection::kCells, "connectivity", rows.entries(),
                                      [&rows](std::size_t i) { return rows.entry(i); }));
  arrays.push_back(value_array<Index>(VtuSection::kCells, "offsets", rows.cells(),
                                      [&rows](std::size_t i) { return rows.cell_end(i); }));
}

std::vector<VtuArray> arrays_of(const SurfaceRows& rows) {
  std::vector<VtuArray> arrays;
  arrays.push_back(constant_array<std::uint32_t>(field_arrays::kSchema, {field_arrays::kSchemaNumber}));
  arrays.push_back(points_array(rows.points(), [&rows](std::size_t i) { return rows.point(i); }));
  if (fits_32_bits(rows.points(), rows.entries()))
    add_cells<std::int32_t>(rows, arrays);
  else
    add_cells<std::int64_t>(rows, arrays);
  arrays.push_back(value_array<std::uint8_t>(
      VtuSection::kCells, "types", rows.cells(),
      [&rows](std::size_t i) { return i < rows.triangles ? kVtkTriangle : kVtkPolyLine; }));
  if (!rows.surface.faces.empty())
    arrays.push_back(value_array<std::int32_t>(VtuSection::kCellData, kFaceArray, rows.cells(),
                                               [&rows](std::size_t i) { return rows.face(i); }));
  if (!rows.surface.regions.empty()) {
    for (const std::size_t side : {0, 1})
      arrays.push_back(
          value_array<std::int32_t>(VtuSection::kCellData, kRegionArrays[side], rows.cells(),
                                    [&rows, side](std::size_t i) { return rows.region(i, side); }));
  }
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

    const std::vector<Vector3> points = file_.read_points(kSurfaceReach);
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
    if (file_.find(VtuSection::kCellData, kRegionArrays[0])) take_regions(surface);
    if (file_.find(VtuSection::kCellData, kFaceArray)) {
      surface.faces = file_.read<std::int32_t>(VtuSection::kCellData, kFaceArray, 1);
      require(surface.faces.size() == file_.cells());
      surface.faces.resize(surface.triangles.size());
    }
    return surface;
  }

  /// Reads the solids of triangles, and moves those with a solid on both sides, the last, to the interfaces.
  void take_regions(SolvedSurface& surface) const {
    std::array<std::vector<std::int32_t>, 2> regions;
    for (const std::size_t side : {0, 1})
      regions[side] = file_.read<std::int32_t>(VtuSection::kCellData, kRegionArrays[side], 1);
    auto& triangles = surface.triangles;
    require(regions[0].size() == file_.cells() && regions[1].size() == file_.cells());
    const auto ends = regions[1].begin() + static_cast<std::ptrdiff_t>(triangles.size());
    const auto first =
        std::find_if(regions[1].begin(), ends, [](auto region) { return region != kNoRegion; });
    const auto outer = static_cast<std::size_t>(first - regions[1].begin());
    for (std::size_t i = outer; i < triangles.size(); ++i) {
      require(regions[1][i] != kNoRegion);
      surface.interfaces.push_back(triangles[i]);
      surface.interface_regions.push_back({regions[0][i], regions[1][i]});
    }
    triangles.resize(outer);
    surface.regions.assign(regions[0].begin(), regions[0].begin() + static_cast<std::ptrdiff_t>(outer));
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
  if (!may_exist(path)) return {};
  return SurfaceSource(
      [file = std::make_shared<const VtuFile>(path)] { return SurfaceReader(*file).read(); });
}

}  // namespace crossgrain
