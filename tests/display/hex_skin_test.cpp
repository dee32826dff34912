// SPDX-License-Identifier: Apache-2.0
#include "display/hex_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "mesh_files/made_bricks.hpp"

namespace crossgrain {
namespace {

using Quad = std::array<std::uint32_t, 4>;

Quad sorted(Quad quad) {
  std::sort(quad.begin(), quad.end());
  return quad;
}

/// The faces that only one of the shown hexahedra has, found by counting, with their edges.
std::pair<std::multiset<Quad>, std::set<std::array<std::uint32_t, 2>>> counted_skin(
    const HexMesh& mesh, const std::vector<std::uint8_t>& is_shown) {
  std::map<Quad, std::pair<int, Quad>> uses;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
    if (is_shown[h] == 0) continue;
    for (const auto& face : kHexFaces) {
      Quad quad;
      for (std::size_t k = 0; k < 4; ++k) quad[k] = mesh.hexahedra[h][face[k]];
      auto& [count, first] = uses[sorted(quad)];
      if (count++ == 0) first = quad;
    }
  }
  std::pair<std::multiset<Quad>, std::set<std::array<std::uint32_t, 2>>> skin;
  for (const auto& [key, use] : uses) {
    if (use.first != 1) continue;
    skin.first.insert(use.second);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t a = use.second[k], b = use.second[(k + 1) % 4];
      skin.second.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return skin;
}

TEST(HexSkin, HasTheFacesAndEdgesThatCountingFindsOfAnyHexahedra) {
  const HexMesh mesh = made_bricks({5, 4, 3}, {5, 4, 3});
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::uint8_t> is_shown(mesh.hexahedra.size());
    for (std::uint8_t& flag : is_shown) flag = random() % 20 >= static_cast<unsigned>(trial);
    const HexSkin skin = skin_of(mesh, is_shown);
    const auto [faces, edges] = counted_skin(mesh, is_shown);
    std::multiset<Quad> found;
    for (const HexSide& face : skin.faces) {
      EXPECT_EQ(is_shown[face.hexahedron], 1);
      const auto& corners = mesh.hexahedra[face.hexahedron];
      for (const std::uint32_t vertex : face.vertices) EXPECT_EQ(std::ranges::count(corners, vertex), 1);
      found.insert(face.vertices);
    }
    EXPECT_EQ(found, faces);
    EXPECT_EQ((std::set(skin.edges.begin(), skin.edges.end())), edges);
    EXPECT_EQ(skin.edges.size(), edges.size());
  }
}

TEST(HexahedraBeside, AreThoseWhoseCentresAreOnThatSide) {
  HexMesh mesh = made_bricks({6, 5, 4}, {6, 5, 4});
  std::mt19937 random(4);
  for (Vector3& vertex : mesh.vertices)
    for (double& x : vertex) x += 0.3 * static_cast<double>(random()) / 4294967296.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double position : {-1.0, 0.7, 2.2, 3.4, 9.0}) {
      const auto low = hexahedra_beside(mesh, axis, position, false),
                 high = hexahedra_beside(mesh, axis, position, true);
      for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
        double sum = 0;
        for (const std::uint32_t vertex : mesh.hexahedra[h]) sum += mesh.vertices[vertex][axis];
        EXPECT_EQ(low[h] != 0, sum / 8 < position);
        EXPECT_EQ(high[h] != 0, sum / 8 > position);
      }
    }
  }
}

}  // namespace
}  // namespace crossgrain
