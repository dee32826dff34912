// SPDX-License-Identifier: Apache-2.0
// Cells of an unstructured VTK grid from any kind of file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "mesh_files/cells/cell_builder.hpp"
#include "text/number_stream.hpp"

namespace crossgrain {

/// An array of numbers, starting at its first number.
struct VtkNumbers {
  NumberStream stream;
  NumberType type;

  std::int64_t next(const char* what) { return stream.integer(type, what); }
};

/// The arrays of the cells. All but `points` have one entry per cell.
struct VtkCells {
  std::uint64_t count = 0;
  VtkNumbers points;  ///< of all cells in sequence

  /// End of each cell in `points`; if absent, each cell's points are preceded by their number.
  std::optional<VtkNumbers> ends;

  VtkNumbers types;
  std::optional<VtkNumbers> tags;
};

/// Adds all cells. The builder must know the points. Throws Error(kInput) naming the cell (or the line) for a
/// wrong number of points, a point out of range or an unknown cell type.
void add_vtk_cells(VtkCells cells, CellBuilder& builder);

/// Returns how suitable an array of cell data is, by its name and type, for the tags of cells: less is
/// better. Nothing if it is unsuitable: arrays must hold one whole number per cell and not be added by VTK
/// itself (such as vtkGhostType). Order: CellEntityIds, gmsh:physical, region, RegionId, tag, material,
/// MaterialIds, gmsh:geometrical, ignoring case; then any other, the first in the file.
std::optional<std::size_t> vtk_tag_rank(std::string_view name, NumberType type, std::uint64_t components);

}  // namespace crossgrain
