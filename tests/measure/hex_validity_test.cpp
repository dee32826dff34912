// SPDX-License-Identifier: Apache-2.0
#include "measure/hex_validity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {
namespace {

const HexCorners kCube{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// The determinant of the trilinear map of kCube to these corners.
double determinant_at(const HexCorners& corners, const Vector3& at) {
  std::array<Vector3, 3> columns{};
  for (std::size_t k = 0; k < 8; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double weight = kCube[k][axis] > 0 ? 1 : -1;
      for (std::size_t other = 0; other < 3; ++other)
        if (other != axis) weight *= kCube[k][other] > 0 ? at[other] : 1 - at[other];
      columns[axis] += weight * corners[k];
    }
  }
  return dot(cross(columns[0], columns[1]), columns[2]);
}

/// The product of the mean lengths of the four edges along each axis.
double mean_box(const HexCorners& p) {
  const auto mean = [&](std::array<std::array<std::size_t, 2>, 4> edges) {
    double sum = 0;
    for (const auto& [a, b] : edges) sum += norm(p[b] - p[a]);
    return sum / 4;
  };
  return mean({{{0, 1}, {3, 2}, {4, 5}, {7, 6}}}) * mean({{{0, 3}, {1, 2}, {4, 7}, {5, 6}}}) *
         mean({{{0, 4}, {1, 5}, {2, 6}, {3, 7}}});
}

double least_of_samples(const HexCorners& corners, int steps) {
  double least = 1e300;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= steps; ++k)
        least = std::min(least,
                         determinant_at(corners, {i / double(steps), j / double(steps), k / double(steps)}));
  return least / mean_box(corners);
}

double least_at_corners(const HexCorners& corners) {
  return least_of_samples(corners, 1);
}

class HexValidity : public testing::Test {
 protected:
  HexCorners shaken(double most) {
    HexCorners corners = kCube;
    for (Vector3& corner : corners)
      for (double& x : corner) x += most * (static_cast<double>(random()) / 2147483648.0 - 1);
    return corners;
  }

  std::mt19937 random{7};
};

/// Positive at all corners, negative inside.
const HexCorners kNegativeInside{{{0, -0.5, 0.5},
                                  {1, -0.5, -0.5},
                                  {1, 1, 0.5},
                                  {-0.5, 0.5, 0},
                                  {0.5, 0.5, 1.5},
                                  {1.5, 0.5, 0.5},
                                  {0.5, 0.5, 1},
                                  {-0.5, 1.5, 0.5}}};

TEST_F(HexValidity, BoundsOfABoxAreOneHoweverItLies) {
  HexCorners box = kCube;
  for (Vector3& p : box) p = rotate(from_rotation_vector({0.4, -1, 0.3}), {3 * p[0], 0.01 * p[1], 7 * p[2]});
  const JacobianBounds bounds = least_jacobian(box);
  EXPECT_NEAR(bounds.lower, 1, 1e-13);
  EXPECT_NEAR(bounds.upper, 1, 1e-13);
  EXPECT_TRUE(is_valid(box));
}

TEST_F(HexValidity, RefusesAHexahedronThatIsPositiveAtAllCornersAndNegativeInside) {
  EXPECT_GT(least_at_corners(kNegativeInside), 0.09);
  EXPECT_FALSE(is_valid(kNegativeInside));
  EXPECT_NEAR(least_jacobian(kNegativeInside).upper, least_of_samples(kNegativeInside, 40), 1e-3);
}

TEST_F(HexValidity, AgreesWithDenseSamplesOfRandomHexahedra) {
  std::array<int, 2> counts{};
  for (int n = 0; n < 2000; ++n) {
    const HexCorners corners = shaken(0.45);
    const JacobianBounds bounds = least_jacobian(corners);
    const double least = least_of_samples(corners, 12);
    EXPECT_LE(bounds.lower, least + 1e-12);
    EXPECT_LE(bounds.upper - bounds.lower, 1e-3);
    // The least between samples 1/12 apart is lower by less than 1/8 of the square of that times the second
    // derivative, below 60 in shares for edges up to 1.9.
    EXPECT_GE(bounds.upper, least - 0.05);
    EXPECT_FALSE(least <= 0 && is_valid(corners));
    EXPECT_FALSE(bounds.lower > kLeastJacobian && !is_valid(corners));
    ++counts[is_valid(corners)];
  }
  EXPECT_GT(counts[0], 200);
  EXPECT_GT(counts[1], 200);
}

TEST_F(HexValidity, DoesNotChangeWithSizePlaceAndDirection) {
  for (int n = 0; n < 500; ++n) {
    const HexCorners corners = shaken(0.45);
    HexCorners moved = corners;
    const auto turn = from_rotation_vector({0.1 * n, 1, -0.3});
    const double scale = std::ldexp(1.0, n % 80 - 40);
    for (Vector3& p : moved) p = scale * (rotate(turn, p) + Vector3{3, -2, 1});
    EXPECT_EQ(is_valid(moved), is_valid(corners)) << n;
    EXPECT_NEAR(least_jacobian(moved).lower, least_jacobian(corners).lower, 1e-9);
  }
}

TEST_F(HexValidity, DoesNotChangeWithTheCornerThatIsNumberedFirst) {
  // A quarter turn about z, and one about x.
  constexpr std::array<std::size_t, 8> kTurn{3, 0, 1, 2, 7, 4, 5, 6}, kRoll{4, 5, 1, 0, 7, 6, 2, 3};
  for (int n = 0; n < 500; ++n) {
    const HexCorners corners = shaken(0.45);
    for (const auto& order : {kTurn, kRoll}) {
      HexCorners other;
      for (std::size_t k = 0; k < 8; ++k) other[k] = corners[order[k]];
      EXPECT_EQ(is_valid(other), is_valid(corners)) << n;
    }
  }
}

TEST_F(HexValidity, RefusesFlatCollapsedAndMirroredHexahedraAndThoseWithoutNumbers) {
  HexCorners flat = kCube, mirrored = kCube, collapsed = kCube, point = kCube, wrong = kCube;
  for (Vector3& p : flat) p[2] *= 0;
  for (Vector3& p : mirrored) p[2] = -p[2];
  collapsed[1] = collapsed[0];
  point.fill({1, 2, 3});
  wrong[3][1] = std::numeric_limits<double>::quiet_NaN();
  for (const HexCorners& corners : {flat, mirrored, collapsed, point, wrong}) EXPECT_FALSE(is_valid(corners));
  EXPECT_EQ(least_jacobian(point).lower, 0);
}

TEST_F(HexValidity, CallsAThinBoxValidAndOneThatIsFlatButForSinglePrecisionInverted) {
  HexCorners thin = kCube, rounded = kCube;
  for (Vector3& p : thin) p[2] *= 1e-9;
  EXPECT_TRUE(is_valid(thin));
  // Corner 6 in the plane of 2, 5 and 7 but for rounding: its three edges have no volume.
  rounded[6] = {2.0 / 3 + 1e-7, 2.0 / 3, 2.0 / 3};
  EXPECT_GT(determinant_at(rounded, {1, 1, 1}), 1e-8);
  EXPECT_FALSE(is_valid(rounded));
}

TEST_F(HexValidity, OfAMeshMarksTheInvertedOnes) {
  HexMesh mesh;
  for (const HexCorners& corners : {kCube, kNegativeInside, kCube}) {
    std::array<std::uint32_t, 8> hexahedron;
    for (std::size_t k = 0; k < 8; ++k) {
      hexahedron[k] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(corners[k]);
    }
    mesh.hexahedra.push_back(hexahedron);
  }
  EXPECT_EQ(inverted_hexahedra(mesh), (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST_F(HexValidity, OfAMeshIsThatOfEachHexahedronForAnyNumberOfThem) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> move(-0.6, 0.6);
  HexMesh mesh;
  std::vector<std::uint8_t> expected;
  for (int count = 1; count < 40; ++count) {
    HexCorners corners = kCube;
    if (count % 3 != 0)
      for (Vector3& corner : corners)
        for (double& coordinate : corner) coordinate += move(generator);
    if (count == 13) corners[2][0] = std::numeric_limits<double>::quiet_NaN();
    if (count == 17) corners.fill({1, 2, 3});
    auto& hexahedron = mesh.hexahedra.emplace_back();
    for (std::size_t k = 0; k < 8; ++k) {
      hexahedron[k] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(corners[k]);
    }
    expected.push_back(!is_valid(corners));
    ASSERT_EQ(inverted_hexahedra(mesh), expected) << count;
    std::vector<std::uint8_t> which(expected.size());
    for (std::size_t h = 0; h < which.size(); ++h) which[h] = !expected[h];
    EXPECT_TRUE(are_valid(mesh.vertices, mesh.hexahedra, which)) << count;
    which.back() = 1;
    EXPECT_EQ(are_valid(mesh.vertices, mesh.hexahedra, which), !expected.back()) << count;
  }
  EXPECT_GT(std::ranges::count(expected, 1), 5);
}

}  // namespace
}  // namespace crossgrain
