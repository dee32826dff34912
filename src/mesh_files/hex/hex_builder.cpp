// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/hex/hex_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/read_memory.hpp"
#include "measure/hex_faces.hpp"
#include "mesh_files/hex/turned_hexahedra.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

/// The six faces of each hexahedron have 32-bit numbers.
constexpr std::size_t kMostHexahedra = UINT32_MAX / 6;

}  // namespace

HexBuilder::HexBuilder(const InputFile& file)
    : CellBuilder(file, {CellShape::kHexahedron, CellShape::kQuad, /*has_edges=*/false, kMostHexahedra}) {}

void HexBuilder::reserve(std::size_t more_hexahedra) {
  reserve_more(file().name(), mesh_.hexahedra, more_hexahedra);
}

void HexBuilder::take(CellShape shape, const Corners& corners, std::optional<std::int32_t> tag,
                      bool /*is_stated*/) {
  if (shape == CellShape::kHexahedron) {
    append_within_memory(file().name(), mesh_.hexahedra, corners);
    if (tag) append_within_memory(file().name(), mesh_.regions, *tag);
    return;
  }
  Quad quad{{corners[0], corners[1], corners[2], corners[3]}, tag.value_or(0)};
  std::ranges::sort(quad.sorted);
  append_within_memory(file().name(), quads_, quad);
}

void HexBuilder::check_corners() const {
  std::size_t collapsed = 0, first = 0;
  Checkpoint checkpoint;
  for (std::size_t k = 0; k < mesh_.hexahedra.size(); ++k) {
    checkpoint.pass();
    Corners sorted = mesh_.hexahedra[k];
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) continue;
    if (collapsed++ == 0) first = k;
  }
  if (collapsed == 0) return;
  fail_input(file(), {"hexahedron", first},
             fmt::format("{} a corner twice, as wedges and pyramids do, which cannot be used",
                         collapsed == 1 ? "has" : fmt::format("this and {} others have", collapsed - 1)),
             Remedy::kMeshAgain);
}

void HexBuilder::check_lengths() const {
  for (const Vector3& vertex : mesh_.vertices)
    for (const double coordinate : vertex)
      if (!(std::abs(coordinate) < kLargestLength))
        fail_input(file(), {}, fmt::format("a coordinate is {}, too large to compute with", coordinate),
                   Remedy::kRescale);
}

void HexBuilder::drop_unused_vertices() {
  std::vector<std::uint32_t> index(mesh_.vertices.size(), UINT32_MAX);
  for (const auto& hexahedron : mesh_.hexahedra)
    for (const std::uint32_t corner : hexahedron) index[corner] = 0;
  std::uint32_t used = 0;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] == UINT32_MAX) continue;
    mesh_.vertices[used] = mesh_.vertices[v];
    index[v] = used++;
  }
  if (used == mesh_.vertices.size()) return;
  mesh_.vertices.resize(used);
  for (auto& hexahedron : mesh_.hexahedra)
    for (std::uint32_t& corner : hexahedron) corner = index[corner];
  // One with a vertex of no hexahedron is on no boundary.
  std::erase_if(quads_, [&](const Quad& quad) {
    return std::ranges::any_of(quad.sorted, [&](std::uint32_t v) { return index[v] == UINT32_MAX; });
  });
  for (Quad& quad : quads_)
    for (std::uint32_t& corner : quad.sorted) corner = index[corner];  // the order stays
}

void HexBuilder::find_boundary() {
  Checkpoint checkpoint;
  std::ranges::stable_sort(quads_, [&](const Quad& a, const Quad& b) {
    checkpoint.pass();
    return a.sorted < b.sorted;
  });
  for (const HexSide& side : boundary_of(mesh_)) {
    std::array<std::uint32_t, 4> sorted = side.vertices;
    std::ranges::sort(sorted);
    const auto found = std::ranges::lower_bound(quads_, sorted, {}, &Quad::sorted);
    const bool is_tagged = found != quads_.end() && found->sorted == sorted;
    mesh_.boundary.push_back({side.vertices, is_tagged ? found->tag : 0});
  }
}

HexMesh HexBuilder::finish(const Place& end) {
  refuse_other_solids("hexahedra", Remedy::kMeshAgain);
  if (mesh_.hexahedra.empty()) fail_input(file(), end, "the file has no hexahedra", Remedy::kExportAgain);
  check_corners();
  mesh_.vertices = std::move(vertices());
  drop_unused_vertices();
  check_lengths();
  if (std::ranges::all_of(mesh_.regions, [](std::int32_t region) { return region == 0; }))
    mesh_.regions.clear();
  const std::size_t turned = turn_right_handed(mesh_);
  find_boundary();
  if (curved_solids() > 0)
    warn(WarningKind::kSkippedData, {},
         fmt::format("hexahedra of higher order: {}; only their corners are used, as if they were straight",
                     curved_solids()));
  if (turned > 0)
    warn(WarningKind::kInvertedTets, {},
         fmt::format("{} left-handed in the file, and turned over",
                     turned == 1 ? "a hexahedron is" : fmt::format("{} hexahedra are", turned)));
  mesh_.warnings = std::move(warnings());
  return std::move(mesh_);
}

}  // namespace crossgrain
