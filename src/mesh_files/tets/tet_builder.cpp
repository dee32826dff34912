// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/tets/tet_builder.hpp"

#include <fmt/format.h>

#include <utility>

#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

/// The six edges of each tet have 32-bit numbers (tets/stiffness.cpp).
constexpr std::size_t kMostTets = UINT32_MAX / 6;

}  // namespace

TetBuilder::TetBuilder(const InputFile& file)
    : CellBuilder(file, {CellShape::kTet, CellShape::kTriangle, /*has_edges=*/true, kMostTets}) {}

void TetBuilder::reserve(std::size_t more_tets) {
  reserve_more(file().name(), mesh_.tets, more_tets);
}

void TetBuilder::take(CellShape shape, const Corners& corners, std::optional<std::int32_t> tag,
                      bool is_stated) {
  const std::uint32_t a = corners[0], b = corners[1], c = corners[2], d = corners[3];
  if (shape == CellShape::kEdge) {
    append_within_memory(file().name(), mesh_.feature_edges, {{a, b}, tag.value_or(0), is_stated});
  } else if (shape == CellShape::kTriangle) {
    append_within_memory(file().name(), mesh_.feature_faces, {{a, b, c}, tag.value_or(0)});
  } else {
    append_within_memory(file().name(), mesh_.tets, {a, b, c, d});
    if (tag) append_within_memory(file().name(), mesh_.regions, *tag);
  }
}

void TetBuilder::choose_edges(const std::vector<std::int64_t>& numbers, const Place& place) {
  std::vector<TetMesh::Edge> kept;
  kept.reserve(numbers.size());
  for (const std::int64_t number : numbers) {
    if (number < 1 || static_cast<std::uint64_t>(number) > mesh_.feature_edges.size())
      fail_input(file(), place,
                 fmt::format("Ridges name edge {}, but there are {} Edges, numbered from 1", number,
                             mesh_.feature_edges.size()));
    kept.push_back(mesh_.feature_edges[static_cast<std::size_t>(number - 1)]);
    kept.back().is_stated = true;
  }
  mesh_.feature_edges = std::move(kept);
}

TetMesh TetBuilder::finish(const Place& end) {
  refuse_other_solids(
      "tets", has_only_others_of(CellShape::kHexahedron) ? Remedy::kFitHexahedra : Remedy::kCutIntoTets);
  if (mesh_.tets.empty() && !mesh_.feature_faces.empty())
    fail_input(file(), end,
               fmt::format("{} but no tets (for surfaces use STL, OBJ, PLY, OFF or 3MF)",
                           counted(mesh_.feature_faces.size(), "triangle")),
               Remedy::kCutIntoTets);
  if (mesh_.tets.empty()) fail_input(file(), end, "the file has no tets", Remedy::kExportAgain);
  if (curved_solids() > 0)
    warn(WarningKind::kCurvedTets, {},
         fmt::format("tets of higher order: {}; only their corners are used, as if they were straight",
                     curved_solids()));
  mesh_.vertices = std::move(vertices());
  mesh_.warnings = std::move(warnings());
  return std::move(mesh_);
}

}  // namespace crossgrain
