// SPDX-License-Identifier: Apache-2.0
// The cells of an unstructured grid of VTK, whatever file they come from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "io/tets/tet_builder.hpp"
#include "io/text/number_stream.hpp"

namespace crossgrain {

/// An array of numbers, from the first one on.
struct VtkNumbers {
  NumberStream stream;
  NumberType type;

  std::int64_t next(const char* what) { return stream.integer(type, what); }
};

/// The arrays that cells consist of, an entry a cell but for the first.
struct VtkCells {
  std::uint64_t count = 0;
  VtkNumbers points;  ///< of all cells, one after the other

  /// Where in `points` each cell ends; without it, each cell's number of points stands there before them.
  std::optional<VtkNumbers> ends;

  VtkNumbers types;
  std::optional<VtkNumbers> tags;
};

/// Adds all cells. `points` must be known to the builder. Throws Error(kInput) naming the cell (or the line)
/// for a wrong number of points, a point out of range and a type of cell that is not known.
void add_vtk_cells(VtkCells cells, TetBuilder& builder);

/// How well an array of cell data, by its name and type, does for the tags of cells: less is better. Nothing
/// where it does not: only whole numbers do, one a cell, and none of what VTK itself adds (vtkGhostType,
/// say). In this order: CellEntityIds, gmsh:physical, region, RegionId, tag, material, MaterialIds,
/// gmsh:geometrical, in any case of their letters; then whatever comes first.
std::optional<std::size_t> vtk_tag_rank(std::string_view name, NumberType type, std::uint64_t components);

}  // namespace crossgrain
