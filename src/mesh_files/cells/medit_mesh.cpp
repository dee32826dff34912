// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/cells/medit_mesh.hpp"

#include <fmt/format.h>

#include <array>
#include <span>

#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

/// Maximum number of nodes of a cell that a builder takes: a tet of degree 4.
constexpr std::size_t kMostNodes = 35;

/// Converts a 1-based number to a 0-based one. Unsigned, so that the least of 64 bits wraps instead of
/// overflowing.
std::int64_t from_zero(std::int64_t number) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(number) - 1);
}

/// What errors in binary files call a cell.
const char* unit_of(CellShape shape) {
  switch (shape) {
    case CellShape::kTet:
      return "tet";
    case CellShape::kHexahedron:
      return "hexahedron";
    case CellShape::kQuad:
      return "quadrilateral";
    case CellShape::kTriangle:
      return "triangle";
    default:
      return "edge";
  }
}

constexpr MeditSection cells(std::string_view keyword, int code, CellShape shape, std::uint8_t nodes,
                             std::string_view plural) {
  return {keyword, code, nodes + 1, MeditContent::kCells, {code, shape, nodes, plural}};
}

constexpr std::array kSections = {
    MeditSection{"Vertices", 4, 4, MeditContent::kVertices},
    cells("Edges", 5, CellShape::kEdge, 2, "edges"),
    cells("EdgesP2", 25, CellShape::kEdge, 3, "edges"),
    cells("Triangles", 6, CellShape::kTriangle, 3, "triangles"),
    cells("TrianglesP2", 24, CellShape::kTriangle, 6, "triangles"),
    cells("Tetrahedra", 8, CellShape::kTet, 4, "tets"),
    cells("TetrahedraP2", 30, CellShape::kTet, 10, "tets"),
    cells("TetrahedraP3", 96, CellShape::kTet, 20, "tets"),
    cells("TetrahedraP4", 97, CellShape::kTet, 35, "tets"),
    cells("Hexahedra", 10, CellShape::kHexahedron, 8, "hexahedra"),
    cells("HexahedraQ2", 33, CellShape::kHexahedron, 27, "hexahedra"),
    cells("Prisms", 9, CellShape::kOtherSolid, 6, "prisms"),
    cells("Pentahedra", 0, CellShape::kOtherSolid, 6, "prisms"),
    cells("PrismsP2", 86, CellShape::kOtherSolid, 18, "prisms"),
    cells("Pyramids", 49, CellShape::kOtherSolid, 5, "pyramids"),
    cells("PyramidsP2", 87, CellShape::kOtherSolid, 14, "pyramids"),
    cells("Quadrilaterals", 7, CellShape::kQuad, 4, "quadrilaterals"),
    cells("QuadrilateralsQ2", 27, CellShape::kQuad, 9, "quadrilaterals"),
    MeditSection{"Corners", 13, 1},
    MeditSection{"Ridges", 14, 1, MeditContent::kRidges},
    MeditSection{"RequiredVertices", 15, 1},
    MeditSection{"RequiredEdges", 16, 1},
    MeditSection{"RequiredTriangles", 17, 1},
    MeditSection{"RequiredQuadrilaterals", 18, 1},
    MeditSection{"RequiredTetrahedra", 0, 1},
    MeditSection{"Normals", 60, 3},
    MeditSection{"NormalAtVertices", 20, 2},
    MeditSection{"NormalAtTriangleVertices", 21, 3},
    MeditSection{"NormalAtQuadrilateralVertices", 22, 3},
    MeditSection{"Tangents", 59, 3},
    MeditSection{"TangentAtVertices", 61, 2},
    MeditSection{"TangentAtEdges", 0, 3},
    MeditSection{"SubDomainFromMesh", 0, 4},
    MeditSection{"SubDomainFromGeom", 29, 4},
};

}  // namespace

const MeditSection* medit_section_named(std::string_view keyword) {
  for (const MeditSection& section : kSections) {
    if (equals_ignoring_case(section.keyword, keyword)) return &section;
  }
  return nullptr;
}

const MeditSection* medit_section_coded(std::int64_t code) {
  for (const MeditSection& section : kSections) {
    if (section.code == code && code != 0) return &section;
  }
  return nullptr;
}

void MeditMesh::read_rows(NumberStream& rows, const MeditSection& section, std::uint64_t count) {
  switch (section.content) {
    case MeditContent::kPassedOver:
      return;
    case MeditContent::kVertices:
      return read_vertices(rows, count);
    case MeditContent::kCells:
      return read_cells(rows, section, count);
    case MeditContent::kRidges:
      ridges_place_ = rows.place("ridge", 0);
      for (std::uint64_t i = 0; i < count; ++i)
        append_within_memory(file_->name(), ridges_, rows.integer(numbers_.integer, "the number of an edge"));
      return;
  }
}

void MeditMesh::read_vertices(NumberStream& rows, std::uint64_t count) {
  has_vertices_ = true;
  builder_.reserve_vertices(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    Vector3 position;
    for (double& coordinate : position) coordinate = rows.real(numbers_.real, "a coordinate");
    builder_.add_vertex(position, rows.place("vertex", i));
    rows.integer(numbers_.integer, "the reference number of a vertex");
  }
}

void MeditMesh::read_cells(NumberStream& rows, const MeditSection& section, std::uint64_t count) {
  const CellType& type = section.cell;
  if (!builder_.takes(type.shape)) {
    if (is_solid(type.shape)) builder_.count_other_solids(type, count, rows.place(section.keyword.data(), 0));
    return rows.skip(numbers_.integer, count * static_cast<std::uint64_t>(section.columns));
  }
  if (type.shape == builder_.solid()) builder_.reserve_solids(count);
  std::array<std::int64_t, kMostNodes> nodes;
  for (std::uint64_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < type.nodes; ++k)
      nodes[k] = from_zero(rows.integer(numbers_.integer, "the number of a vertex"));
    const Place place = rows.place(unit_of(type.shape), i);
    const std::int64_t tag = rows.integer(numbers_.integer, "the reference number of a cell");
    builder_.add_cell(type, std::span(nodes).first(type.nodes), tag, place, /*is_stated=*/false);
  }
}

void MeditMesh::finish() {
  if (!ridges_.empty()) builder_.choose_edges(ridges_, ridges_place_);
}

}  // namespace crossgrain
