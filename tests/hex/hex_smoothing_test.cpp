// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_smoothing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/thread_limit.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"
#include "reduction/mapped_shapes.hpp"

namespace crossgrain {
namespace {

using testing::AskewBox;

/// A box that lies askew, with its grid of cubes, of which each vertex keeps to what it lies on. Coordinates
/// of the tests are those along the sides of the box.
struct GridInABox {
  static constexpr std::array<std::uint32_t, 3> kCells{4, 3, 3};
  AskewBox box{kCells};
  MapSurface surface{box.field};
  std::vector<Vector3> upright;
  std::vector<Foot> feet;
  HexMesh mesh;

  GridInABox() {
    const TetBox grid{kCells};
    upright = grid.mesh().vertices;
    for (std::uint32_t v = 0; v < upright.size(); ++v) {
      Carrier carrier{};
      carrier.vertices[0] = v;
      carrier.count = 1;
      feet.push_back(surface.foot_of(carrier));
    }
    for (std::uint32_t z = 0; z < kCells[2]; ++z)
      for (std::uint32_t y = 0; y < kCells[1]; ++y)
        for (std::uint32_t x = 0; x < kCells[0]; ++x)
          mesh.hexahedra.push_back({grid.at(x, y, z), grid.at(x + 1, y, z), grid.at(x + 1, y + 1, z),
                                    grid.at(x, y + 1, z), grid.at(x, y, z + 1), grid.at(x + 1, y, z + 1),
                                    grid.at(x + 1, y + 1, z + 1), grid.at(x, y + 1, z + 1)});
    mesh.vertices = turned(upright);
  }

  static std::vector<Vector3> turned(std::vector<Vector3> places) {
    for (Vector3& p : places) p = rotate(AskewBox::turn(), p);
    return places;
  }

  /// Whether a vertex is held along an axis of the box.
  bool is_held(std::size_t vertex, std::size_t axis) const {
    return upright[vertex][axis] == 0 || upright[vertex][axis] == kCells[axis];
  }

  /// Vertices moved at random by up to `reach` within what they keep to.
  HexMesh disturbed(double reach, unsigned seed = 1) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-reach, reach);
    std::vector<Vector3> places = upright;
    for (std::size_t v = 0; v < places.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!is_held(v, axis)) places[v][axis] += uniform(random);
    HexMesh result = mesh;
    result.vertices = turned(std::move(places));
    return result;
  }

  HexMesh smooth(const HexMesh& given, const HexSmoothingOptions& options = {}) const {
    return smoothed(given, surface, feet, 1, options);
  }
};

double least_scaled_jacobian(const HexMesh& mesh) {
  const std::vector<double> quality = scaled_jacobians(mesh);
  return *std::min_element(quality.begin(), quality.end());
}

TEST(HexSmoothing, LeavesAGridOfCubesToTheBit) {
  const GridInABox grid;
  EXPECT_EQ(grid.smooth(grid.mesh).vertices, grid.mesh.vertices);
}

TEST(HexSmoothing, OfCubesTakesNoRound) {
  const GridInABox grid;
  std::size_t tells = 0;
  const Monitor monitor([&](const Progress&) { ++tells; });
  const WatchedLoops watched(monitor, Stops::kHeeded);
  const HexSmoothingOptions options;
  grid.smooth(grid.mesh, options);
  EXPECT_EQ(tells, options.powers.size());
  grid.smooth(grid.disturbed(0.2), options);
  EXPECT_GT(tells, 2 * options.powers.size());
}

TEST(HexSmoothing, MakesNearlyCubesOfADisturbedGrid) {
  const GridInABox grid;
  for (const unsigned seed : {1u, 2u, 3u}) {
    const HexMesh given = grid.disturbed(0.4, seed);
    ASSERT_LT(least_scaled_jacobian(given), 0.4);
    const HexMesh smooth = grid.smooth(given);
    EXPECT_GT(least_scaled_jacobian(smooth), 0.9);
    EXPECT_EQ(smooth.hexahedra, given.hexahedra);
  }
}

TEST(HexSmoothing, TurnsInvertedHexahedraRight) {
  const GridInABox grid;
  const HexMesh given = grid.disturbed(1.2);
  const std::vector<std::uint8_t> before = inverted_hexahedra(given);
  ASSERT_GT(std::ranges::count(before, 1), 10);
  EXPECT_GT(least_scaled_jacobian(grid.smooth(given)), 0.5);
}

TEST(HexSmoothing, KeepsVerticesOnSidesEdgesAndCornersOfTheModel) {
  const GridInABox grid;
  const HexMesh smooth = grid.smooth(grid.disturbed(0.3));
  for (std::size_t v = 0; v < smooth.vertices.size(); ++v) {
    const Vector3 place = rotate(conjugate(AskewBox::turn()), smooth.vertices[v]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (grid.is_held(v, axis)) {
        EXPECT_NEAR(place[axis], grid.upright[v][axis], 1e-14);
      }
    if (grid.feet[v].kind == Foot::Kind::kCorner) {
      EXPECT_EQ(smooth.vertices[v], grid.box.solid.mesh.vertices[v]);
    }
  }
}

TEST(HexSmoothing, BringsVerticesBackToTheSurface) {
  const GridInABox grid;
  HexMesh given = grid.disturbed(0.3);
  for (Vector3& p : given.vertices) p += Vector3{0.1, -0.05, 0.08};
  const HexMesh smooth = grid.smooth(given);
  for (std::size_t v = 0; v < smooth.vertices.size(); ++v)
    EXPECT_LT(norm(grid.surface.nearest(grid.feet[v], smooth.vertices[v]).point - smooth.vertices[v]), 1e-14);
}

TEST(HexSmoothing, IsTheSameToTheBitForAnyNumberOfThreads) {
  const GridInABox grid;
  const auto on = [&](int threads) {
    const ThreadLimit limit(threads);
    return grid.smooth(grid.disturbed(0.3)).vertices;
  };
  EXPECT_EQ(on(1), on(2));
}

TEST(HexSmoothing, TurnsWithTheModel) {
  const GridInABox grid;
  const HexMesh given = grid.disturbed(0.3), expected = grid.smooth(given);
  const Quaternion turn = from_rotation_vector({-0.8, 0.5, 0.3});
  TetMesh tets = grid.box.solid.mesh;
  for (Vector3& p : tets.vertices) p = rotate(turn, p);
  const testing::MappedSolid turned(tets, [&](const TetSolid&) {
    std::vector<Quaternion> frames;
    for (const Quaternion& frame : grid.box.frames) frames.push_back(turn * frame);
    return frames;
  });
  HexMesh mesh = given;
  for (Vector3& p : mesh.vertices) p = rotate(turn, p);
  const HexMesh found = smoothed(mesh, MapSurface(turned.field), grid.feet, 1);
  // Not to rounding: the first step of the descent is limited along each coordinate, and it ends before
  // the minimum.
  for (std::size_t v = 0; v < found.vertices.size(); ++v)
    EXPECT_LT(norm(found.vertices[v] - rotate(turn, expected.vertices[v])), 5e-3);
}

TEST(HexSmoothing, ReturnsTheGivenMeshWithoutRounds) {
  const GridInABox grid;
  const HexMesh given = grid.disturbed(0.3);
  HexSmoothingOptions options;
  options.rounds = 0;
  EXPECT_EQ(grid.smooth(given, options).vertices, given.vertices);
  EXPECT_TRUE(smoothed(HexMesh{}, grid.surface, {}, 1).vertices.empty());
}

}  // namespace
}  // namespace crossgrain
