// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_samples.hpp"

#include <gtest/gtest.h>

namespace crossgrain {
namespace {

struct Sampled {
  std::size_t count = 0;
  double area = 0;
  Vector3 moment{0, 0, 0};
};

Sampled sampled(const std::array<Vector3, 3>& corners, double spacing) {
  Sampled all;
  for_each_sample(corners, spacing, [&](const Vector3& point, double weight) {
    ++all.count;
    all.area += weight;
    all.moment += weight * point;
  });
  return all;
}

TEST(TriangleSamples, AddUpToTheAreaAboutTheCentroid) {
  const Vector3 a{1, 2, 3};
  for (const Vector3& tip :
       {Vector3{0.5, 1, 0}, {0.1, 0.3, 0.2}, {2, 0.02, 0}, {-1, 0.01, 0}, {0.5, 0, 0.3}}) {
    for (const double spacing : {0.01, 0.1, 0.4, 5.0}) {
      const Vector3 b = a + Vector3{1, 0, 0}, c = a + tip;
      const double area = norm(cross(b - a, c - a)) / 2;
      const Sampled all = sampled({a, b, c}, spacing);
      EXPECT_NEAR(all.area, area, 1e-12);
      // Rows are of the width of their middle, which is off by a third of a row's height squared.
      EXPECT_LT(norm((1 / area) * all.moment - (1.0 / 3) * (a + b + c)), all.count == 4 ? 1e-12 : 0.2);
    }
  }
}

TEST(TriangleSamples, OfASliverAreAsManyAsItsLengthAsksFor) {
  for (const double height : {1e-3, 1e-6, 0.0}) {
    EXPECT_EQ(sampled({Vector3{0, 0, 0}, {6, 0, 0}, {3, height, 0}}, 0.1).count, 60u + 3);
    EXPECT_EQ(sampled({Vector3{3, height, 0}, {0, 0, 0}, {6, 0, 0}}, 0.1).count, 60u + 3);
  }
  EXPECT_EQ(sampled({Vector3{0, 0, 0}, {6, 0, 0}, {3, 5, 0}}, 0.1).count, 60u * 60 + 3);
}

TEST(TriangleSamples, OfAPointAreOnIt) {
  EXPECT_EQ(sampled({Vector3{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, 0.1).count, 4u);
}

}  // namespace
}  // namespace crossgrain
