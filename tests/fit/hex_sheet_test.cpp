// SPDX-License-Identifier: Apache-2.0
#include "fit/hex_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "base/vector3.hpp"
#include "fit/hex_lattice.hpp"
#include "fit/hex_sides.hpp"
#include "fit/quad_complex.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

using testing::lattice_mesh;
using Quad = std::array<std::uint32_t, 4>;

HexMesh box(int side, int regions = 1) {
  HexMesh mesh = lattice_mesh({side, side, side}, [&](int x, int, int) { return 1 + x * regions / side; });
  std::int32_t tag = 0;
  for (const HexSide& quad : boundary_of(mesh)) mesh.boundary.push_back({quad.vertices, ++tag});
  return mesh;
}

double volume_of(const HexMesh& mesh) {
  const std::vector<double> volumes = volumes_of(mesh);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

/// Vertices - edges + faces - hexahedra.
int euler_of(const HexMesh& mesh) {
  std::set<std::uint32_t> vertices;
  std::set<std::set<std::uint32_t>> edges, faces;
  for (const auto& hexahedron : mesh.hexahedra) {
    vertices.insert(hexahedron.begin(), hexahedron.end());
    for (const auto& [a, b] : kHexEdges) edges.insert({hexahedron[a], hexahedron[b]});
    for (const auto& face : kHexFaces)
      faces.insert({hexahedron[face[0]], hexahedron[face[1]], hexahedron[face[2]], hexahedron[face[3]]});
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(faces.size()) -
         static_cast<int>(mesh.hexahedra.size());
}

Quad sorted(Quad quad) {
  std::ranges::sort(quad);
  return quad;
}

/// The mesh conforms, is bounded as before, and its own list of boundary quads is right.
void expect_sound(const HexMesh& mesh, const HexMesh& before) {
  const HexTopology topology = topology_of(mesh);
  EXPECT_TRUE(topology.is_closed());
  EXPECT_EQ(topology.pinched_vertices, 0u);
  EXPECT_EQ(euler_of(mesh), euler_of(before));
  EXPECT_EQ(count_bodies(mesh), count_bodies(before));
  std::set<Quad> found, listed;
  for (const HexSide& side : topology.boundary) found.insert(side.vertices);
  for (const HexMesh::Face& face : mesh.boundary) {
    Quad turned = face.vertices;
    for (int k = 0; k < 4 && !found.contains(turned); ++k) std::ranges::rotate(turned, turned.begin() + 1);
    EXPECT_TRUE(listed.insert(turned).second);
    EXPECT_TRUE(found.contains(turned));
  }
  EXPECT_EQ(found, listed);
  EXPECT_EQ(mesh.regions.size(), mesh.hexahedra.size());
}

std::vector<std::uint8_t> all_of(const HexMesh& mesh) {
  return std::vector<std::uint8_t>(mesh.hexahedra.size(), 1);
}

InsertedSheet pad(HexMesh& mesh) {
  const auto opposite = opposite_sides(mesh);
  return insert_sheet(mesh, sheet_around(mesh, all_of(mesh), opposite,
                                         [&](std::uint32_t side) { return opposite[side] == kNoSide; }));
}

TEST(HexSides, AreOppositeWhereTheyShareTheirVertices) {
  const HexMesh mesh = box(3);
  const auto opposite = opposite_sides(mesh);
  for (std::uint32_t side = 0; side < opposite.size(); ++side) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto corners = corners_of_side(mesh, side);
      const std::uint32_t across = side_across_edge(side, k);
      const std::size_t there = edge_of_side(mesh, across, corners[(k + 1) % 4], corners[k]);
      EXPECT_EQ(side_across_edge(across, there), side);
    }
    if (opposite[side] == kNoSide) continue;
    EXPECT_EQ(opposite[opposite[side]], side);
    EXPECT_EQ(sorted(corners_of_side(mesh, side)), sorted(corners_of_side(mesh, opposite[side])));
  }
  EXPECT_EQ(std::ranges::count(opposite, kNoSide), 54);
}

TEST(HexSheet, UnderTheBoundaryOfABoxAddsAHexahedronForEachQuadAndMovesNothing) {
  const HexMesh before = box(3);
  HexMesh mesh = before;
  const InsertedSheet inserted = pad(mesh);
  EXPECT_EQ(mesh.hexahedra.size(), 27u + 54u);
  EXPECT_EQ(inserted.original.size(), 56u);  // as many as there are vertices of the boundary
  EXPECT_TRUE(inserted.quads.empty());
  EXPECT_TRUE(inserted.inverted.empty());
  EXPECT_TRUE(std::equal(before.vertices.begin(), before.vertices.end(), mesh.vertices.begin()));
  expect_sound(mesh, before);
  EXPECT_NEAR(volume_of(mesh), 27, 1e-12);
  for (const double shape : scaled_jacobians(mesh)) EXPECT_GT(shape, 0.4);
  for (std::size_t f = 0; f < before.boundary.size(); ++f) {
    EXPECT_EQ(mesh.boundary[f].vertices, before.boundary[f].vertices);
    EXPECT_EQ(mesh.boundary[f].tag, before.boundary[f].tag);
  }
}

TEST(HexSheet, OfAConcaveSolidIsValidAtItsConcaveEdgesAndCorners) {
  const HexMesh before =
      lattice_mesh({4, 4, 4}, [](int x, int y, int z) { return x >= 2 && y >= 2 && z >= 2 ? 0 : 1; });
  HexMesh mesh = before;
  EXPECT_TRUE(pad(mesh).inverted.empty());
  EXPECT_TRUE(topology_of(mesh).is_closed());
  EXPECT_NEAR(volume_of(mesh), 56, 1e-12);
  for (const double shape : scaled_jacobians(mesh)) EXPECT_GT(shape, 0.18);
}

TEST(HexSheet, UnderTheTopDivesAlongTheSidesWhoseQuadsItDivides) {
  const HexMesh before = box(3);
  HexMesh mesh = before;
  const auto is_top = [&](std::uint32_t side) {
    return std::ranges::all_of(corners_of_side(before, side),
                               [&](auto v) { return before.vertices[v][2] == 3; });
  };
  const InsertedSheet inserted =
      insert_sheet(mesh, sheet_around(mesh, all_of(mesh), opposite_sides(mesh), is_top));
  expect_sound(mesh, before);
  EXPECT_EQ(mesh.hexahedra.size(), 36u);
  EXPECT_TRUE(inserted.inverted.empty());
  EXPECT_EQ(inserted.quads.size(), 24u);
  EXPECT_EQ(std::ranges::count(inserted.quads, true, &InsertedSheet::Quad::is_new), 12);
  EXPECT_NEAR(volume_of(mesh), 27, 1e-12);
  EXPECT_NEAR(boundary_area(mesh), 54, 1e-12);
  // A new quad has the tag of the old one below it, which lies in the same plane.
  std::map<std::int32_t, int> uses;
  for (const HexMesh::Face& face : mesh.boundary) ++uses[face.tag];
  EXPECT_EQ(std::ranges::count_if(uses, [](const auto& use) { return use.second == 2; }), 12);
}

TEST(HexSheet, BetweenTwoRegionsKeepsTheInterfaceWhereItCoversBothAndDividesIt) {
  const HexMesh before = box(4, 2);
  HexMesh mesh = before;
  const auto opposite = opposite_sides(mesh);
  // The four hexahedra beside the middle of the interface.
  std::vector<std::uint8_t> is_shrunk(mesh.hexahedra.size(), 0);
  for (std::size_t h = 0; h < is_shrunk.size(); ++h) {
    const Vector3 centre = centre_of(mesh, h);
    is_shrunk[h] = std::abs(centre[0] - 2) < 1 && centre[1] < 2 && std::abs(centre[2] - 2) < 1;
  }
  const InsertedSheet inserted =
      insert_sheet(mesh, sheet_around(mesh, is_shrunk, opposite, [](std::uint32_t) { return false; }));
  expect_sound(mesh, before);
  EXPECT_TRUE(inserted.inverted.empty());
  EXPECT_NEAR(volume_of(mesh), 64, 1e-12);
  double of_first = 0;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    if (mesh.regions[h] == 1) of_first += volumes_of(mesh)[h];
  EXPECT_NEAR(of_first, 32, 1e-12);
  // Interface quads: those that the complex finds are the old ones, replaced and added as told.
  const auto interface_of = [](const HexMesh& of) {
    std::set<Quad> quads;
    const QuadComplex complex(of, of.regions);
    for (const auto& quad : complex.quads())
      if (quad.above != 0) quads.insert(sorted(quad.vertices));
    return quads;
  };
  std::set<Quad> expected = interface_of(before);
  for (const InsertedSheet::Quad& quad : inserted.quads)
    if (!quad.is_new) expected.erase(sorted(quad.before));
  const std::set<Quad> found = interface_of(mesh);
  for (const InsertedSheet::Quad& quad : inserted.quads)
    if (found.contains(sorted(quad.vertices))) expected.insert(sorted(quad.vertices));
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), 16u + 6u);
}

/// Hexahedra at a twin whose edges lead to opposite sides, for which there need be no valid place.
std::set<std::uint32_t> without_direction(const HexMesh& before, const HexMesh& mesh, const HexSheet& sheet,
                                          const InsertedSheet& inserted) {
  std::map<std::uint32_t, std::set<std::array<double, 3>>> directions;
  for (const std::uint32_t side : sheet.sides)
    for (const std::uint8_t k : kHexFaces[side % 6])
      for (const std::uint8_t n : kHexNeighbours[k])
        if (std::ranges::find(kHexFaces[side % 6], n) == kHexFaces[side % 6].end())
          directions[mesh.hexahedra[side / 6][k]].insert(before.vertices[before.hexahedra[side / 6][n]] -
                                                         before.vertices[before.hexahedra[side / 6][k]]);
  std::set<std::uint32_t> result;
  for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h)
    for (const std::uint32_t v : mesh.hexahedra[h])
      if (v >= inserted.first_vertex)
        for (const Vector3& direction : directions[v])
          if (directions[v].contains(-direction)) result.insert(h);
  return result;
}

TEST(HexSheet, AroundRandomSetsConformsKeepsVolumeAndIsValidWhereThereIsAWayInside) {
  std::mt19937 random(11);
  std::size_t sheets_valid = 0, set_hexahedra = 0;
  for (int n = 0; n < 60; ++n) {
    const HexMesh before = box(4, 1 + n % 2);
    HexMesh mesh = before;
    const auto opposite = opposite_sides(mesh);
    std::vector<std::uint8_t> is_shrunk(mesh.hexahedra.size());
    const std::uint32_t share = 1 + n % 7;
    for (std::uint8_t& is_in : is_shrunk) is_in = random() % 8 < share;
    // Sides of a hexahedron of the lattice lie as those of the box.
    const auto covered = random() % 64;
    const HexSheet sheet = sheet_around(mesh, is_shrunk, opposite, [&](std::uint32_t side) {
      return opposite[side] == kNoSide && (covered >> side % 6 & 1) != 0;
    });
    const InsertedSheet inserted = insert_sheet(mesh, sheet);
    expect_sound(mesh, before);
    EXPECT_EQ(mesh.hexahedra.size(), before.hexahedra.size() + sheet.sides.size());
    const auto is_inverted = inverted_hexahedra(mesh);
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(is_inverted, 1)), inserted.inverted.size());
    const std::set<std::uint32_t> excused = without_direction(before, mesh, sheet, inserted);
    for (const std::uint32_t h : inserted.inverted) EXPECT_TRUE(excused.contains(h)) << n << " " << h;
    EXPECT_NEAR(volume_of(mesh), 64, 1e-11);
    sheets_valid += inserted.inverted.empty();
    set_hexahedra += mesh.hexahedra.size();
  }
  EXPECT_GT(sheets_valid, 10u);
  EXPECT_GT(set_hexahedra, 60u * 80);
}

/// Sides of all cubes towards x, of pairs for which is_chosen(y, z) of the second cube.
HexSheet sheet_at_plane(const HexMesh& block, const std::vector<std::uint32_t>& opposite,
                        const std::function<bool(double y, double z)>& is_chosen) {
  return sheet_around(block, std::vector<std::uint8_t>(block.hexahedra.size(), 1), opposite,
                      [&](std::uint32_t side) {
                        Vector3 centre{0, 0, 0};
                        for (const std::uint32_t v : corners_of_side(block, side))
                          centre += 0.25 * block.vertices[v];
                        return centre[0] == 1 && is_chosen(centre[1], centre[2]);
                      });
}

TEST(HexSheet, LeavesOutPairsWithinASetThatWouldShareTwoFaces) {
  const HexMesh block = lattice_mesh({3, 3, 3}, [](int, int, int) { return 1; });
  const std::vector<std::uint32_t> opposite = opposite_sides(block);
  EXPECT_EQ(sheet_at_plane(block, opposite, [](double, double) { return true; }).sides.size(), 2u * 9)
      << "from side to side";
  EXPECT_TRUE(
      sheet_at_plane(block, opposite, [](double y, double z) { return y == 1.5 && z == 1.5; }).sides.empty());
  EXPECT_TRUE(sheet_at_plane(block, opposite, [](double y, double) { return y < 2; }).sides.empty())
      << "its end is inside";
}

TEST(HexSheet, InsideASetMayCoverASideBetweenTwoOfIt) {
  const HexMesh before = box(3);
  HexMesh mesh = before;
  const auto opposite = opposite_sides(mesh);
  const auto is_middle = [&](std::uint32_t side) {
    return std::ranges::all_of(corners_of_side(before, side),
                               [&](auto v) { return before.vertices[v][2] == 1; });
  };
  const InsertedSheet inserted = insert_sheet(mesh, sheet_around(mesh, all_of(mesh), opposite, is_middle));
  expect_sound(mesh, before);
  EXPECT_EQ(mesh.hexahedra.size(), 27u + 18u);  // two layers
  EXPECT_TRUE(inserted.inverted.empty());
  EXPECT_NEAR(volume_of(mesh), 27, 1e-12);
}

}  // namespace
}  // namespace crossgrain
