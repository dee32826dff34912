// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/cells/vtk_cells.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <utility>

namespace crossgrain {
namespace {

/// A box of an image, whose corners are not in the order of a hexahedron: 3 before 2, and 7 before 6.
constexpr int kVoxel = 11;

// vtkCellType.h. Lagrange and Bezier cells (68 to 81) have as many points as their degree requires.
constexpr std::array kVtkTypes = {
    CellType{0, CellShape::kPassedOver, 0, "empty cells"},
    CellType{1, CellShape::kPassedOver, 1, "vertices"},
    CellType{2, CellShape::kPassedOver, 0, "vertices"},
    CellType{3, CellShape::kEdge, 2, "lines"},
    CellType{4, CellShape::kPassedOver, 0, "polylines"},
    CellType{5, CellShape::kTriangle, 3, "triangles"},
    CellType{6, CellShape::kPassedOver, 0, "strips"},
    CellType{7, CellShape::kPassedOver, 0, "polygons"},
    CellType{8, CellShape::kQuad, 4, "pixels"},
    CellType{9, CellShape::kQuad, 4, "quads"},
    CellType{10, CellShape::kTet, 4, "tets"},
    CellType{kVoxel, CellShape::kHexahedron, 8, "voxels"},
    CellType{12, CellShape::kHexahedron, 8, "hexahedra"},
    CellType{13, CellShape::kOtherSolid, 6, "wedges"},
    CellType{14, CellShape::kOtherSolid, 5, "pyramids"},
    CellType{15, CellShape::kOtherSolid, 10, "pentagonal prisms"},
    CellType{16, CellShape::kOtherSolid, 12, "hexagonal prisms"},
    CellType{21, CellShape::kEdge, 3, "lines"},
    CellType{22, CellShape::kTriangle, 6, "triangles"},
    CellType{23, CellShape::kQuad, 8, "quads"},
    CellType{24, CellShape::kTet, 10, "tets"},
    CellType{25, CellShape::kHexahedron, 20, "hexahedra"},
    CellType{26, CellShape::kOtherSolid, 15, "wedges"},
    CellType{27, CellShape::kOtherSolid, 13, "pyramids"},
    CellType{28, CellShape::kQuad, 9, "quads"},
    CellType{29, CellShape::kHexahedron, 27, "hexahedra"},
    CellType{30, CellShape::kQuad, 6, "quads"},
    CellType{31, CellShape::kOtherSolid, 12, "wedges"},
    CellType{32, CellShape::kOtherSolid, 18, "wedges"},
    CellType{33, CellShape::kHexahedron, 24, "hexahedra"},
    CellType{34, CellShape::kTriangle, 7, "triangles"},
    CellType{35, CellShape::kEdge, 4, "lines"},
    CellType{36, CellShape::kPassedOver, 0, "polygons"},
    CellType{37, CellShape::kOtherSolid, 19, "pyramids"},
    CellType{41, CellShape::kOtherSolid, 0, "convex point sets"},
    CellType{42, CellShape::kOtherSolid, 0, "polyhedra"},
    CellType{68, CellShape::kEdge, 0, "lines"},
    CellType{69, CellShape::kTriangle, 0, "triangles"},
    CellType{70, CellShape::kQuad, 0, "quads"},
    CellType{71, CellShape::kTet, 0, "tets"},
    CellType{72, CellShape::kHexahedron, 0, "hexahedra"},
    CellType{73, CellShape::kOtherSolid, 0, "wedges"},
    CellType{74, CellShape::kOtherSolid, 0, "pyramids"},
    CellType{75, CellShape::kEdge, 0, "lines"},
    CellType{76, CellShape::kTriangle, 0, "triangles"},
    CellType{77, CellShape::kQuad, 0, "quads"},
    CellType{78, CellShape::kTet, 0, "tets"},
    CellType{79, CellShape::kHexahedron, 0, "hexahedra"},
    CellType{80, CellShape::kOtherSolid, 0, "wedges"},
    CellType{81, CellShape::kOtherSolid, 0, "pyramids"},
};

const CellType* type_of(std::int64_t code) {
  for (const CellType& type : kVtkTypes) {
    if (type.code == code) return &type;
  }
  return nullptr;
}

/// Memory for solids is reserved at once; lists of a million cells would otherwise be copied about twenty
/// times.
std::size_t solids_among(VtkNumbers types, std::uint64_t count, CellShape solid) {
  std::size_t solids = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const CellType* type = type_of(types.next("the type of a cell"));
    if (type != nullptr && type->shape == solid) ++solids;
  }
  return solids;
}

class CellSizes {
 public:
  explicit CellSizes(VtkCells& cells) : cells_(&cells) {}

  std::int64_t next() {
    if (!cells_->ends) return cells_->points.next("the number of points of a cell");
    const std::int64_t end = cells_->ends->next("the end of a cell"), begin = end_;
    end_ = end;
    // Unsigned, so that places at the ends of the 64-bit range wrap instead of overflowing.
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(end) - static_cast<std::uint64_t>(begin));
  }

 private:
  VtkCells* cells_;
  std::int64_t end_ = 0;
};

void check_size(const VtkNumbers& points, const CellType& type, std::int64_t size) {
  const auto given = static_cast<std::uint64_t>(size);
  const bool fits = type.nodes > 0 ? given == type.nodes : given >= corners_of(type.shape);
  if (size < 0 || !fits || given > points.stream.most_left(points.type))
    points.stream.fail(fmt::format("a cell of type {} ({}) has {} {}", type.code, type.plural, size,
                                   size == 1 ? "point" : "points"));
}

}  // namespace

void add_vtk_cells(VtkCells cells, CellBuilder& builder) {
  builder.reserve_solids(solids_among(cells.types, cells.count, builder.solid()));
  CellSizes sizes(cells);
  std::array<std::int64_t, 8> nodes{};
  for (std::uint64_t i = 0; i < cells.count; ++i) {
    const std::int64_t code = cells.types.next("the type of a cell");
    const CellType* type = type_of(code);
    if (type == nullptr)
      cells.types.stream.fail(fmt::format("cell {} has the unknown type {}", i, code), Remedy::kCutIntoTets);
    const std::int64_t size = sizes.next();
    check_size(cells.points, *type, size);
    const std::size_t corners = builder.nodes_needed(*type);
    for (std::size_t k = 0; k < corners; ++k) nodes[k] = cells.points.next("the number of a point");
    if (code == kVoxel) {
      std::swap(nodes[2], nodes[3]);
      std::swap(nodes[6], nodes[7]);
    }
    const Place place = cells.points.stream.place("cell", i);
    cells.points.stream.skip(cells.points.type, static_cast<std::uint64_t>(size) - corners);
    std::optional<std::int64_t> tag;
    if (cells.tags) tag = cells.tags->next("the tag of a cell");
    builder.add_cell(*type, std::span(nodes).first(corners), tag, place);
  }
}

std::optional<std::size_t> vtk_tag_rank(std::string_view name, NumberType type, std::uint64_t components) {
  constexpr std::array<std::string_view, 8> kNames = {
      "CellEntityIds", "gmsh:physical", "region",      "RegionId",
      "tag",           "material",      "MaterialIds", "gmsh:geometrical"};
  if (!is_integer(type) || components != 1) return std::nullopt;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (equals_ignoring_case(name, kNames[i])) return i;
  }
  if (name.starts_with("vtk") || name.starts_with("Global")) return std::nullopt;
  return kNames.size();
}

}  // namespace crossgrain
