// SPDX-License-Identifier: Apache-2.0
#include "fit/embedding_room.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/hex_sheet.hpp"
#include "fit/hex_sides.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

using QuadKey = std::array<std::uint32_t, 4>;  // vertices, ascending

/// Puts a layer around the hexahedra of some quads, and over all of their other sides on the boundary: around
/// these quads only there is a new ring. Whether it is valid; the mesh is as before if not.
bool put_ring_around(HexMesh& mesh, const std::set<QuadKey>& quads, std::vector<std::uint8_t> is_shrunk) {
  const std::vector<std::uint32_t> opposite = opposite_sides(mesh);
  const auto is_covered = [&](std::uint32_t side) {
    return opposite[side] == kNoSide && !quads.contains(ascending(corners_of_side(mesh, side)));
  };
  const HexSheet sheet = sheet_around(mesh, std::move(is_shrunk), opposite, is_covered);
  if (sheet.is_crowded || sheet.sides.empty()) return false;
  HexMesh changed = mesh;
  if (!insert_sheet(changed, sheet).inverted.empty()) return false;
  mesh = std::move(changed);
  return true;
}

/// The quad at a vertex with the largest angle there.
std::uint32_t widest_quad(const HexMesh& mesh, const QuadComplex& surface, std::uint32_t vertex) {
  std::uint32_t widest = kNowhere;
  double least = 2;  // cosine
  for (const std::uint32_t quad : surface.quads_of(vertex)) {
    std::array<Vector3, 2> along;
    for (std::size_t k = 0; k < 2; ++k)
      along[k] = normalised(mesh.vertices[surface.other_end(surface.edges_at(quad, vertex)[k], vertex)] -
                            mesh.vertices[vertex]);
    const double cosine = dot(along[0], along[1]);
    if (cosine < least) least = cosine, widest = quad;
  }
  return widest;
}

}  // namespace

bool add_edges_at(HexMesh& mesh, const QuadComplex& surface, const std::vector<std::uint32_t>& vertices) {
  std::vector<std::uint8_t> is_changed(mesh.hexahedra.size(), 0);
  bool are_any = false;
  for (const std::uint32_t vertex : vertices) {
    check_watched();
    const QuadComplex::Quad& quad = surface.quads()[widest_quad(mesh, surface, vertex)];
    std::vector<std::uint8_t> is_shrunk(mesh.hexahedra.size(), 0);
    bool is_free = true;
    for (const std::uint32_t hexahedron : {quad.hexahedron_below, quad.hexahedron_above}) {
      if (hexahedron == kNowhere) continue;
      is_free = is_free && is_changed[hexahedron] == 0;
      is_shrunk[hexahedron] = is_changed[hexahedron] = 1;
    }
    are_any |= is_free && put_ring_around(mesh, {ascending(quad.vertices)}, std::move(is_shrunk));
  }
  return are_any;
}

bool widen_around(HexMesh& mesh, const QuadComplex& surface,
                  const std::vector<std::vector<std::uint32_t>>& paths) {
  std::vector<std::uint8_t> is_shrunk(mesh.hexahedra.size(), 0);
  std::set<QuadKey> quads;
  for (const auto& path : paths) {
    const std::size_t ends = path.size() > 2 ? 1 : 0;
    for (std::size_t k = ends; k + ends < path.size(); ++k) {
      for (const std::uint32_t q : surface.quads_of(path[k])) {
        const QuadComplex::Quad& quad = surface.quads()[q];
        quads.insert(ascending(quad.vertices));
        for (const std::uint32_t hexahedron : {quad.hexahedron_below, quad.hexahedron_above})
          if (hexahedron != kNowhere) is_shrunk[hexahedron] = 1;
      }
    }
  }
  return !quads.empty() && put_ring_around(mesh, quads, std::move(is_shrunk));
}

}  // namespace crossgrain
