// SPDX-License-Identifier: Apache-2.0
#include "fit/hex_sheet.hpp"

#include <algorithm>
#include <utility>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/hex_sides.hpp"
#include "fit/sheet_fans.hpp"
#include "fit/twin_places.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNoTwin = UINT32_MAX;

/// Inserts a sheet; reads the mesh as it was until `apply`.
class SheetInsertion {
 public:
  SheetInsertion(HexMesh& mesh, const HexSheet& sheet)
      : mesh_(mesh),
        sheet_(sheet),
        opposite_(opposite_sides(mesh)),
        fans_(mesh, sheet, opposite_),
        twins_(8 * mesh.hexahedra.size(), kNoTwin) {
    inserted_.first_vertex = mesh.vertices.size();
    inserted_.first_hexahedron = mesh.hexahedra.size();
    inserted_.base = sheet.sides;
  }

  InsertedSheet run(double depth) {
    make_twins();
    find_quads();
    const std::vector<TwinCorner> corners = twin_corners();
    std::vector<std::array<std::uint32_t, 8>> layer;
    layer.reserve(sheet_.sides.size());
    for (const std::uint32_t side : sheet_.sides) layer.push_back(hexahedron_on(side));
    const TwinPlaces places(mesh_, inserted_.original, corners);
    apply(layer);
    inserted_.inverted = places.put(mesh_, inserted_.first_vertex, depth);
    return std::move(inserted_);
  }

 private:
  std::uint32_t twin(std::uint32_t side, std::size_t k) const {
    return twins_[8 * (side / 6) + kHexFaces[side % 6][k]];
  }

  void make_twins();
  void find_quads();
  void follow_edge(std::uint32_t side, std::size_t k);
  void add_moved_quad(std::uint32_t side);
  std::vector<TwinCorner> twin_corners() const;
  std::array<std::uint32_t, 4> shrunk(std::uint32_t side) const;
  void apply(const std::vector<std::array<std::uint32_t, 8>>& layer);
  void update_boundary();

  std::array<std::uint32_t, 8> hexahedron_on(std::uint32_t side) const {
    const auto outer = corners_of_side(mesh_, side);
    return {twin(side, 0), twin(side, 1), twin(side, 2), twin(side, 3),
            outer[0],      outer[1],      outer[2],      outer[3]};
  }

  bool is_interface(std::uint32_t side) const {
    const std::uint32_t other = opposite_[side];
    return other != kNoSide && !mesh_.regions.empty() && mesh_.regions[side / 6] != mesh_.regions[other / 6];
  }

  HexMesh& mesh_;
  const HexSheet& sheet_;
  std::vector<std::uint32_t> opposite_;
  SheetFans fans_;
  std::vector<std::uint32_t> twins_;  ///< of each corner of the set
  InsertedSheet inserted_;
};

/// Corners of the set, joined across sides not in the sheet, share a twin.
void SheetInsertion::make_twins() {
  std::vector<std::uint8_t> has_twin(twins_.size(), 0);
  for (const std::uint32_t side : sheet_.sides)
    for (const std::uint32_t vertex : corners_of_side(mesh_, side))
      has_twin[fans_.cluster(fans_.corner_at(side, vertex))] = 1;
  // A root is the lowest of its cluster, so that it comes before the others.
  for (std::uint32_t corner = 0; corner < twins_.size(); ++corner) {
    const std::uint32_t root = fans_.cluster(corner);
    if (!has_twin[root]) continue;
    if (root == corner) {
      twins_[corner] = static_cast<std::uint32_t>(inserted_.first_vertex + inserted_.original.size());
      inserted_.original.push_back(mesh_.hexahedra[corner / 8][corner % 8]);
    }
    twins_[corner] = twins_[root];
  }
}

/// The vertices of a side of the set after it has shrunk.
std::array<std::uint32_t, 4> SheetInsertion::shrunk(std::uint32_t side) const {
  auto vertices = corners_of_side(mesh_, side);
  for (std::size_t k = 0; k < 4; ++k)
    if (twin(side, k) != kNoTwin) vertices[k] = twin(side, k);
  return vertices;
}

void SheetInsertion::add_moved_quad(std::uint32_t side) {
  const auto vertices = corners_of_side(mesh_, side), now = shrunk(side);
  if (now != vertices) inserted_.quads.push_back({now, vertices, false});
}

void SheetInsertion::find_quads() {
  for (std::uint32_t side = 0; side < opposite_.size(); ++side) {
    if (!sheet_.is_shrunk[side / 6] || fans_.is_in_sheet(side)) continue;
    if (opposite_[side] == kNoSide || (is_interface(side) && side < opposite_[side])) add_moved_quad(side);
  }
  for (const std::uint32_t side : sheet_.sides)
    for (std::size_t k = 0; k < 4; ++k) follow_edge(side, k);
}

/// Adds the quad of the layer at an edge of a side in the sheet, where it lies on the boundary or between two
/// regions: goes around the edge within the set, to the boundary or to the sheet again.
void SheetInsertion::follow_edge(std::uint32_t side, std::size_t k) {
  const auto corners = corners_of_side(mesh_, side);
  const std::uint32_t a = corners[k], b = corners[(k + 1) % 4];
  const std::array<std::uint32_t, 4> quad{twin(side, k), twin(side, (k + 1) % 4), b, a};
  std::uint32_t crossed = kNoSide;
  const std::uint32_t end = fans_.end_of_fan(side, k, [&](std::uint32_t at) {
    if (is_interface(at)) crossed = at;
  });
  if (!fans_.is_in_sheet(end))
    inserted_.quads.push_back({quad, corners_of_side(mesh_, end), true});
  else if (crossed != kNoSide && side < end)
    inserted_.quads.push_back({quad, corners_of_side(mesh_, crossed), true});
}

std::vector<TwinCorner> SheetInsertion::twin_corners() const {
  std::vector<TwinCorner> corners;
  for (const std::uint32_t side : sheet_.sides) {
    for (const std::uint8_t k : kHexFaces[side % 6]) {
      const auto& hexahedron = mesh_.hexahedra[side / 6];
      for (const std::uint8_t n : kHexNeighbours[k])
        if (std::ranges::find(kHexFaces[side % 6], n) == kHexFaces[side % 6].end())
          corners.push_back({static_cast<std::uint32_t>(twins_[8 * (side / 6) + k] - inserted_.first_vertex),
                             hexahedron[n]});
    }
  }
  return corners;
}

void SheetInsertion::update_boundary() {
  if (mesh_.boundary.empty()) return;
  const auto sorted = [](std::array<std::uint32_t, 4> vertices) {
    std::ranges::sort(vertices);
    return vertices;
  };
  std::vector<std::pair<std::array<std::uint32_t, 4>, std::size_t>> known;
  for (std::size_t f = 0; f < mesh_.boundary.size(); ++f)
    known.emplace_back(sorted(mesh_.boundary[f].vertices), f);
  std::ranges::sort(known);
  for (const auto& [vertices, before, is_new] : inserted_.quads) {
    const auto key = sorted(before);
    const auto entry = std::ranges::lower_bound(known, key, {}, [](const auto& pair) { return pair.first; });
    if (entry == known.end() || entry->first != key) continue;
    if (is_new)
      mesh_.boundary.push_back({vertices, mesh_.boundary[entry->second].tag});
    else
      mesh_.boundary[entry->second].vertices = vertices;
  }
}

void SheetInsertion::apply(const std::vector<std::array<std::uint32_t, 8>>& layer) {
  update_boundary();
  for (std::size_t corner = 0; corner < twins_.size(); ++corner)
    if (twins_[corner] != kNoTwin) mesh_.hexahedra[corner / 8][corner % 8] = twins_[corner];
  mesh_.hexahedra.insert(mesh_.hexahedra.end(), layer.begin(), layer.end());
  if (mesh_.regions.empty()) return;
  for (const std::uint32_t side : sheet_.sides) mesh_.regions.push_back(mesh_.regions[side / 6]);
}

/// Marks pairs of sides within the set that are both in its sheet and around an edge of which the set closes
/// up: the two hexahedra on them would share two faces. Returns whether there are any.
bool mark_folded(const SheetFans& fans, const HexSheet& sheet, const std::vector<std::uint32_t>& opposite,
                 std::vector<std::uint8_t>& is_folded) {
  bool has_any = false;
  for (const std::uint32_t side : sheet.sides) {
    const std::uint32_t other = opposite[side];
    if (other == kNoSide || !fans.is_in_sheet(other)) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (fans.end_of_fan(side, k, [](std::uint32_t) {}) != other) continue;
      is_folded[side] = is_folded[other] = 1;
      has_any = true;
    }
  }
  return has_any;
}

/// Adds all hexahedra at some edges to a set. Returns whether there were any.
bool fill_crowded_edges(const HexMesh& mesh, std::vector<std::array<std::uint32_t, 2>> edges,
                        std::vector<std::uint8_t>& is_in_set) {
  if (edges.empty()) return false;
  std::ranges::sort(edges);
  bool is_larger = false;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
    if (is_in_set[h]) continue;
    for (const auto& [a, b] : kHexEdges)
      is_in_set[h] |=
          std::ranges::binary_search(edges, ascending<2>({mesh.hexahedra[h][a], mesh.hexahedra[h][b]}));
    is_larger |= is_in_set[h] != 0;
  }
  return is_larger;
}

}  // namespace

HexSheet sheet_around(const HexMesh& mesh, std::vector<std::uint8_t> is_shrunk,
                      const std::vector<std::uint32_t>& opposite,
                      const std::function<bool(std::uint32_t side)>& is_covered) {
  HexSheet sheet{std::move(is_shrunk), {}, false};
  std::vector<std::uint8_t> is_folded(opposite.size(), 0);
  for (;;) {
    sheet.sides.clear();
    for (std::uint32_t side = 0; side < opposite.size(); ++side) {
      if (!sheet.is_shrunk[side / 6] || is_folded[side]) continue;
      const std::uint32_t other = opposite[side];
      const bool is_border = other != kNoSide && !sheet.is_shrunk[other / 6];
      if (is_border || is_covered(side) || (other != kNoSide && is_covered(other)))
        sheet.sides.push_back(side);
    }
    SheetFans fans(mesh, sheet, opposite);
    if (mark_folded(fans, sheet, opposite, is_folded)) continue;
    const auto crowded = fans.crowded_edges(sheet);
    if (!fill_crowded_edges(mesh, crowded, sheet.is_shrunk)) {
      sheet.is_crowded = !crowded.empty();
      return sheet;
    }
  }
}

InsertedSheet insert_sheet(HexMesh& mesh, const HexSheet& sheet, double depth) {
  return SheetInsertion(mesh, sheet).run(depth);
}

}  // namespace crossgrain
