// SPDX-License-Identifier: Apache-2.0
#include "results/cell_file.hpp"

#include <array>
#include <utility>

#include "harmonics/deviation.hpp"
#include "harmonics/frame.hpp"
#include "results/leaf_corners.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_arrays.hpp"

namespace crossgrain {
namespace {

/// Returns a cell array of `components` floats; value_of(frame) returns any sequence of that many numbers.
template <class ValueOf>
VtuArray frame_array(const FieldData& data, const char* name, std::size_t components,
                     const ValueOf& value_of) {
  return row_array<float>(VtuSection::kCellData, name, components, data.frames.size(),
                          [&data, value_of](std::size_t i) { return value_of(from_stored(data.frames[i])); });
}

/// Returns the coefficients of a frame in single precision, as in the file.
template <int D>
Coefficients<D> written_coefficients(const Quaternion& frame) {
  Coefficients<D> h = frame_coefficients<D>(frame);
  for (double& value : h) value = static_cast<float>(value);
  return h;
}

template <int D>
void add_coefficients(const FieldData& data, std::vector<VtuArray>& arrays) {
  arrays.push_back(frame_array(data, "coefficients", kCoefficientCount<D>, written_coefficients<D>));
  arrays.push_back(frame_array(data, "deviation", 1, [](const Quaternion& frame) {
    return std::array{deviation<D>(written_coefficients<D>(frame))};
  }));
}

}  // namespace

std::vector<VtuArray> cell_data_arrays(const FieldData& data) {
  std::vector<VtuArray> arrays;
  add_axes(
      VtuSection::kCellData, data.frames.size(),
      [&data](std::size_t i) { return from_stored(data.frames[i]); }, arrays);
  if (data.degree == Degree::kThree)
    add_coefficients<3>(data, arrays);
  else
    add_coefficients<4>(data, arrays);
  arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kEnergyDensity, data.energy_density));
  arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kAlignment, data.alignment_deg));
  const auto& leaves = data.tree.leaves();
  arrays.push_back(value_array<std::uint8_t>(VtuSection::kCellData, "level", leaves.size(),
                                             [&leaves](std::size_t i) { return leaves[i].depth(); }));
  arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kOnBoundary, data.on_boundary));
  if (!data.constraints.empty())
    arrays.push_back(value_array<std::uint8_t>(VtuSection::kCellData, field_arrays::kConstraint,
                                               data.constraints.size(),
                                               [&data](std::size_t i) { return data.constraints[i]; }));
  if (!data.regions.empty())
    arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kRegion, data.regions));
  return arrays;
}

namespace {

template <class Index>
void add_cells(const LeafCorners& corners, std::size_t cells, std::vector<VtuArray>& arrays) {
  arrays.push_back(vtu_array<Index>(VtuSection::kCells, "connectivity", 1, 8 * cells,
                                    [&corners](std::size_t begin, std::size_t end, Index* out) {
                                      corners.write_indices(begin, end, out);
                                    }));
  add_uniform_cells<Index>(cells, 8, kVtkHexahedron, arrays);
}

void add_grid(const LeafCorners& corners, std::size_t cells, std::vector<VtuArray>& arrays) {
  arrays.push_back(vtu_array<double>(VtuSection::kPoints, "Points", 3, corners.size(),
                                     [&corners](std::size_t begin, std::size_t end, double* out) {
                                       corners.write_positions(begin, end, out);
                                     }));
  if (fits_32_bits(corners.size(), 8 * cells))
    add_cells<std::int32_t>(corners, cells, arrays);
  else
    add_cells<std::int64_t>(corners, cells, arrays);
}

void add_field_data(const FieldData& data, std::vector<VtuArray>& arrays) {
  const RootCube& root = data.tree.root();
  arrays.push_back(constant_array<std::uint32_t>(field_arrays::kSchema, {field_arrays::kSchemaNumber}));
  arrays.push_back(
      constant_array<std::uint32_t>(field_arrays::kDegree, {static_cast<std::uint32_t>(data.degree)}));
  arrays.push_back(constant_array<double>(field_arrays::kRootCube,
                                          {root.origin[0], root.origin[1], root.origin[2], root.size}));
  const auto& leaves = data.tree.leaves();
  arrays.push_back(value_array<std::uint64_t>(VtuSection::kFieldData, field_arrays::kCellAddress,
                                              leaves.size(),
                                              [&leaves](std::size_t i) { return leaves[i].packed(); }));
  arrays.push_back(row_array<float>(VtuSection::kFieldData, field_arrays::kFrame, 4, data.frames.size(),
                                    [&data](std::size_t i) {
                                      const StoredQuaternion& q = data.frames[i];
                                      return std::array{q.w, q.x, q.y, q.z};
                                    }));
  arrays.push_back(stored_array(VtuSection::kFieldData, field_arrays::kOpenFaces, data.open_faces));
}

/// Adds which part of the field the file holds, if not all of it.
void add_extent(const OutputOptions& options, std::vector<VtuArray>& arrays) {
  if (options.level)
    arrays.push_back(constant_array<std::uint32_t>(field_arrays::kOutputLevel,
                                                   {static_cast<std::uint32_t>(*options.level)}));
  if (options.clip) {
    const auto& [low, high] = *options.clip;
    arrays.push_back(
        constant_array<double>(field_arrays::kClipBox, {low[0], low[1], low[2], high[0], high[1], high[2]}));
  }
}

}  // namespace

void write_cell_file(const FieldData& data, const OutputOptions& options, OutputFile& file,
                     const Monitor& monitor) {
  const LeafCorners corners(data.tree);
  std::vector<VtuArray> arrays;
  add_field_data(data, arrays);
  add_extent(options, arrays);
  for (VtuArray& array : cell_data_arrays(data)) arrays.push_back(std::move(array));
  add_grid(corners, data.tree.size(), arrays);
  watch(arrays, monitor);
  write_vtu(file, corners.size(), data.tree.size(), arrays);
  file.finish();
}

}  // namespace crossgrain
