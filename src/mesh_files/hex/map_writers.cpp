// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/hex/map_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/writing.hpp"
#include "mesh_files/mesh_formats.hpp"
#include "text/text_lines.hpp"
#include "vtu/vtu_arrays.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

double six_volumes(const HexMap::Corners& p) {
  return dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
}

HexMap::Corners corners_of_tet(const HexMap& map, std::size_t tet) {
  HexMap::Corners corners{};
  for (std::size_t a = 0; a < 4; ++a) corners[a] = map.vertices[map.tets[tet][a]];
  return corners;
}

/// Of the Jacobian of the integer-grid map, in sizes of hexahedra.
double determinant(const HexMap& map, std::size_t tet) {
  return six_volumes(map.integer_grid[tet]) * map.size * map.size * map.size /
         six_volumes(corners_of_tet(map, tet));
}

VtuArray coordinates_array(const char* name, const std::vector<HexMap::Corners>& coordinates) {
  return row_array<double>(VtuSection::kPointData, name, 3, 4 * coordinates.size(),
                           [&coordinates](std::size_t i) { return coordinates[i / 4][i % 4]; });
}

template <class Index>
void add_tets(const HexMap& map, std::vector<VtuArray>& arrays) {
  const std::size_t corners = 4 * map.tets.size();
  arrays.push_back(value_array<Index>(VtuSection::kPointData, "vertex", corners,
                                      [&map](std::size_t i) { return map.tets[i / 4][i % 4]; }));
  arrays.push_back(value_array<Index>(VtuSection::kCells, "connectivity", corners, std::identity()));
  add_uniform_cells<Index>(map.tets.size(), 4, kVtkTet, arrays);
}

void write_grid_map(OutputFile& file, const HexMap& map, const Monitor& monitor) {
  write_hexex(file, map, map.integer_grid, monitor);
}

constexpr std::array kMapFormats{MeshFormat<HexMap>{".hexex", write_grid_map},
                                 MeshFormat<HexMap>{".vtu", write_vtu_map}};

void check(const HexMap& map) {
  const std::size_t tets = map.tets.size();
  if (map.seamless.size() != tets || map.integer_grid.size() != tets)
    throw Error(ErrorKind::kUsage, "a map must have coordinates for each of its tets");
  for (const auto& corners : map.tets)
    if (*std::max_element(corners.begin(), corners.end()) >= map.vertices.size())
      throw Error(ErrorKind::kUsage, "a tet of a map has a corner that is no vertex of it");
}

}  // namespace

void write_hexex(OutputFile& file, const HexMap& map, const std::vector<HexMap::Corners>& coordinates,
                 const Monitor& monitor) {
  const auto put_point = [](const Vector3& point, char behind, char* out) {
    out = put_shortest(out, point[0], ' ');
    out = put_shortest(out, point[1], ' ');
    return put_shortest(out, point[2], behind);
  };
  file.write(fmt::format("{}\n", map.vertices.size()));
  write_text_lines(
      file, map.vertices.size(), 3 * kNumberBytes,
      [&](std::size_t v, char* out) { return put_point(map.vertices[v], '\n', out); }, monitor);
  file.write(fmt::format("{}\n", map.tets.size()));
  const auto put_tet = [&](std::size_t t, char* out) {
    for (const std::uint32_t corner : map.tets[t]) out = put_integer(out, corner, ' ');
    for (std::size_t a = 0; a < 4; ++a) out = put_point(coordinates[t][a], a < 3 ? ' ' : '\n', out);
    return out;
  };
  write_text_lines(file, map.tets.size(), 4 * kIntegerBytes + 12 * kNumberBytes, put_tet, monitor);
  file.finish();
}

void write_vtu_map(OutputFile& file, const HexMap& map, const Monitor& monitor) {
  const std::size_t tets = map.tets.size(), points = 4 * tets;
  std::vector<VtuArray> arrays;
  arrays.push_back(coordinates_array("seamless", map.seamless));
  arrays.push_back(coordinates_array("integer_grid", map.integer_grid));
  arrays.push_back(value_array<double>(VtuSection::kCellData, "determinant", tets,
                                       [&map](std::size_t t) { return determinant(map, t); }));
  arrays.push_back(
      points_array(points, [&map](std::size_t i) { return map.vertices[map.tets[i / 4][i % 4]]; }));
  if (fits_32_bits(points, points))
    add_tets<std::int32_t>(map, arrays);
  else
    add_tets<std::int64_t>(map, arrays);
  watch(arrays, monitor);
  write_vtu(file, points, tets, arrays);
}

void write_map(const HexMap& map, const std::filesystem::path& path, const Monitor& monitor) {
  const MeshFormat<HexMap>& format = format_of<HexMap>(path, kMapFormats, "a map");
  check(map);
  write_mesh(format, map, path, monitor);
}

}  // namespace crossgrain
