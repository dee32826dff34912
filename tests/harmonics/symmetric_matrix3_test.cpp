// SPDX-License-Identifier: Apache-2.0
#include "harmonics/symmetric_matrix3.hpp"

#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

// V diag(values) V^T, V the axes of a rotation.
SymmetricMatrix3 with_eigenvalues(const Vector3& values, const Quaternion& rotation) {
  const auto v = axes_of(rotation);
  SymmetricMatrix3 m{};
  for (int k = 0; k < 3; ++k) {
    int entry = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) m[entry++] += values[k] * v[k][i] * v[k][j];
    }
  }
  return m;
}

TEST(Eigensystem3, SolvesItsEquationForSimpleAndRepeatedEigenvalues) {
  testing::RandomSamples random(1);
  for (const Vector3& values :
       {Vector3{1, 2, 3}, Vector3{-1, -1, 5}, Vector3{2, 2, 2}, Vector3{0, 0, 1e-9}}) {
    const SymmetricMatrix3 m = with_eigenvalues(values, random.rotation());
    const Eigensystem3 system = eigensystem(m);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(system.values[i], values[i], 1e-14);
      EXPECT_LT(norm(apply(m, system.vectors[i]) - system.values[i] * system.vectors[i]), 1e-14);
      EXPECT_NEAR(norm(system.vectors[i]), 1, 1e-14);
    }
    EXPECT_NEAR(dot(cross(system.vectors[0], system.vectors[1]), system.vectors[2]) *
                    dot(cross(system.vectors[0], system.vectors[1]), system.vectors[2]),
                1, 1e-13);
  }
}

TEST(GuardedNewtonStep, ReachesTheMinimumOfAConvexQuadratic) {
  testing::RandomSamples random(2);
  for (int i = 0; i < 50; ++i) {
    const SymmetricMatrix3 m = with_eigenvalues(
        {random.uniform(1, 9), random.uniform(1, 9), random.uniform(1, 9)}, random.rotation());
    const Vector3 minimum = 0.1 * random.direction();
    const Vector3 step = guarded_newton_step(m, -1 * apply(m, minimum), 0.5);
    EXPECT_LT(norm(step - minimum), 1e-14);
  }
}

TEST(GuardedNewtonStep, GoesDownhillForAnyHessian) {
  testing::RandomSamples random(3);
  for (int i = 0; i < 500; ++i) {
    const SymmetricMatrix3 m{random.normal(), random.normal(), random.normal(),
                             random.normal(), random.normal(), random.normal()};
    const Vector3 gradient = random.vector();
    const Vector3 step = guarded_newton_step(m, gradient, 0.5);
    EXPECT_LT(dot(step, gradient), 0);
    EXPECT_LE(norm(step), 0.5 * (1 + 1e-15));
  }
}

TEST(GuardedNewtonStep, TakesTheSameStepByEitherOfItsWays) {
  testing::RandomSamples random(4);
  for (int i = 0; i < 200; ++i) {
    const SymmetricMatrix3 m = with_eigenvalues(
        {random.uniform(0.01, 9), random.uniform(0.01, 9), random.uniform(1, 9)}, random.rotation());
    const Vector3 gradient = 0.01 * random.vector();
    const Vector3 step = guarded_newton_step(m, gradient, 0.5);
    EXPECT_LT(norm(step - guarded_spectral_step(m, gradient, 0.5)), 1e-12);
  }
}

TEST(GuardedNewtonStep, LeavesFlatDirectionsWithoutSlopeAlone) {
  const Vector3 step = guarded_newton_step({1, 0, 0, 1, 0, 0}, {0.1, 0.1, 0}, 0.5);
  EXPECT_NEAR(step[0], -0.1, 1e-15);
  EXPECT_EQ(step[2], 0);
}

TEST(GuardedNewtonStep, WithoutCurvatureIsTheWholeAngleDownhill) {
  const Vector3 step = guarded_newton_step({0, 0, 0, 0, 0, 0}, {0, 1e-3, 0}, 0.5);
  EXPECT_NEAR(step[1], -0.5, 1e-15);
}

TEST(GuardedNewtonStep, WithoutSlopeIsNone) {
  const Vector3 step = guarded_newton_step({-1, 0, 0, 0, 0, 0}, {0, 0, 0}, 0.5);
  EXPECT_EQ(norm(step), 0);
}

}  // namespace
}  // namespace crossgrain
