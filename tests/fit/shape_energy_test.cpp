// SPDX-License-Identifier: Apache-2.0
#include "fit/shape_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "crossgrain/thread_limit.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {
namespace {

constexpr CornerEnergyOptions kPlain{.volume_weight = 0.05};

/// A cube of edge 1 whose corners are moved by up to `reach`.
std::array<Vector3, 8> disturbed_cube(double reach, std::mt19937& random) {
  std::array<Vector3, 8> corners{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  std::uniform_real_distribution<double> move(-reach, reach);
  for (Vector3& corner : corners)
    for (double& coordinate : corner) coordinate += move(random);
  return corners;
}

/// Of one hexahedron of size 1.
double energy_of(const std::vector<Vector3>& corners, const CornerEnergyOptions& options,
                 std::vector<Vector3>& gradient) {
  const std::vector<std::array<std::uint32_t, 8>> one{{0, 1, 2, 3, 4, 5, 6, 7}};
  return ShapeEnergy(8, one, {1.0})(corners, options, gradient);
}

/// Two hexahedra one above the other, with all vertices moved.
struct Stack {
  std::vector<Vector3> places;
  std::vector<std::array<std::uint32_t, 8>> hexahedra{{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}};

  Stack(double reach, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> move(-reach, reach);
    for (double z = 0; z < 3; ++z)
      for (const auto& [x, y] : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
        places.push_back({x + move(random), y + move(random), z + move(random)});
  }

  double energy(const CornerEnergyOptions& options) {
    std::vector<Vector3> gradient;
    return ShapeEnergy(places.size(), hexahedra, {1.0, 0.8})(places, options, gradient);
  }
};

TEST(ShapeEnergy, IsThatOfCubesForACubeOfTheSize) {
  std::mt19937 random(1);
  const std::array<Vector3, 8> cube = disturbed_cube(0, random);
  EXPECT_DOUBLE_EQ(energy_at(cube, 3, 1, kPlain), 4 * 3.1);
  std::vector<Vector3> gradient;
  EXPECT_DOUBLE_EQ(energy_of({cube.begin(), cube.end()}, kPlain, gradient), 8 * 3.1);
  for (const Vector3& of_vertex : gradient) EXPECT_LT(norm(of_vertex), 1e-15);
}

TEST(ShapeEnergy, IsThatOfCornersOneByOne) {
  // The corners that a vertex is part of are its own and three others: each is counted four times.
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const std::array<Vector3, 8> corners = disturbed_cube(0.2, random);
    const CornerEnergyOptions options{.volume_weight = 0.3, .power = 1 + trial % 3};
    double sum = 0;
    for (std::size_t k = 0; k < 8; ++k) sum += energy_at(corners, k, 1, options) / 4;
    std::vector<Vector3> gradient;
    EXPECT_NEAR(energy_of({corners.begin(), corners.end()}, options, gradient), sum, 1e-13 * sum);
  }
}

TEST(ShapeEnergy, IsInfiniteWhereACornerHasNoVolume) {
  std::mt19937 random(1);
  const std::array<Vector3, 8> cube = disturbed_cube(0, random);
  CornerEnergyOptions regularised = kPlain;
  regularised.epsilon = 0.1;
  std::vector<Vector3> gradient;
  for (const double height : {0.0, -1.0}) {
    std::vector<Vector3> flat(cube.begin(), cube.end());
    for (Vector3& place : flat) place[2] *= height;
    EXPECT_EQ(energy_of(flat, kPlain, gradient), INFINITY);
    EXPECT_LT(energy_of(flat, regularised, gradient), 1e5);
  }
}

TEST(ShapeEnergy, HasTheGradientOfItsDifferences) {
  for (const auto& [power, epsilon, reach] :
       {std::tuple{1, 0.0, 0.15}, {3, 0.0, 0.15}, {1, 0.2, 0.5}, {4, 0.2, 0.5}}) {
    Stack stack(reach, 7);
    const CornerEnergyOptions options{0.3, power, epsilon};
    std::vector<Vector3> gradient;
    ShapeEnergy(stack.places.size(), stack.hexahedra, {1.0, 0.8})(stack.places, options, gradient);
    for (std::size_t v = 0; v < stack.places.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double kStep = 1e-6;
        Stack before = stack, after = stack;
        before.places[v][axis] -= kStep, after.places[v][axis] += kStep;
        const double difference = (after.energy(options) - before.energy(options)) / (2 * kStep);
        // Rounding of the energies, divided by the step, and the third derivative.
        EXPECT_NEAR(gradient[v][axis], difference,
                    1e-9 * before.energy(options) + 1e-6 * std::abs(difference));
      }
  }
}

TEST(ShapeEnergy, OfOneVertexHasTheDerivativesOfItsDifferences) {
  std::mt19937 random(3);
  const std::array<Vector3, 8> corners = disturbed_cube(0.15, random);
  for (const int power : {1, 3})
    for (std::size_t k = 0; k < 8; ++k) {
      const CornerEnergyOptions options{.volume_weight = 0.2, .power = power};
      SecondOrder sum;
      ASSERT_TRUE(add_energy_at(corners, k, 1.3, options, sum));
      EXPECT_NEAR(sum.value, energy_at(corners, k, 1.3, options), 1e-12 * sum.value);
      std::size_t entry = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        constexpr double kStep = 1e-5;
        auto before = corners, after = corners;
        before[k][i] -= kStep, after[k][i] += kStep;
        SecondOrder low, high;
        add_energy_at(before, k, 1.3, options, low), add_energy_at(after, k, 1.3, options, high);
        EXPECT_NEAR(sum.gradient[i], (high.value - low.value) / (2 * kStep), 1e-6 * sum.value);
        for (std::size_t j = i; j < 3; ++j)
          EXPECT_NEAR(sum.hessian[entry++], (high.gradient[j] - low.gradient[j]) / (2 * kStep),
                      1e-5 * (1 + std::abs(sum.hessian[0])));
      }
    }
}

TEST(ShapeEnergy, OfOneVertexIsConvex) {
  std::mt19937 random(5);
  std::size_t valid = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    SecondOrder sum;
    if (!add_energy_at(disturbed_cube(0.4, random), 0, 1, {.volume_weight = 0.2, .power = 2}, sum)) continue;
    ++valid;
    EXPECT_GT(eigensystem(sum.hessian).values[0], 0);
  }
  EXPECT_GT(valid, 100u);
}

TEST(ShapeEnergy, KeepsMarkedHexahedraWhateverTheEpsilon) {
  Stack stack(0, 1);
  stack.places[8][2] = stack.places[9][2] = stack.places[10][2] = stack.places[11][2] = 0.5;
  const auto energy = [&](const std::vector<std::uint8_t>& kept) {
    std::vector<Vector3> gradient;
    return ShapeEnergy(12, stack.hexahedra, {1, 1})(stack.places, {.volume_weight = 0.2, .epsilon = 0.1},
                                                    gradient, kept);
  };
  EXPECT_LT(energy({1, 0}), INFINITY);
  EXPECT_EQ(energy({0, 1}), INFINITY);
}

TEST(ShapeEnergy, HasAPositiveStiffnessWhereItIsInverted) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 500; ++trial) {
    SymmetricMatrix3 stiffness{};
    add_stiffness_at(disturbed_cube(1, random), 0, 1, {.volume_weight = 0.2, .epsilon = 0.1}, stiffness);
    EXPECT_GT(eigensystem(stiffness).values[0], 0);
  }
}

TEST(ShapeEnergy, HasTheSameBitsForAnyNumberOfThreads) {
  const auto bits = [](int threads) {
    const ThreadLimit limit(threads);
    Stack stack(0.2, 1);
    std::vector<Vector3> gradient;
    const double value = ShapeEnergy(12, stack.hexahedra, {1, 1})(stack.places, kPlain, gradient);
    return std::pair{value, gradient};
  };
  EXPECT_EQ(bits(1), bits(2));
}

}  // namespace
}  // namespace crossgrain
