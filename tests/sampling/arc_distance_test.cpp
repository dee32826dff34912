// SPDX-License-Identifier: Apache-2.0
#include "sampling/arc_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

using Arcs = std::vector<SingularityGraph::Arc>;

/// The rounding of a few operations on numbers as large as the tests have.
constexpr double kRounding = 1e-14;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector3 vector(double reach) {
    return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)};
  }
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(engine_);
  }

 private:
  std::mt19937 engine_;
};

SingularityGraph::Arc arc_of(std::vector<Vector3> points) {
  SingularityGraph::Arc arc;
  arc.points = std::move(points);
  return arc;
}

/// Curves that wander, from steps of all lengths; some end where they began, some are one point.
Arcs random_arcs(Random& random, std::size_t count) {
  Arcs arcs;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Vector3> points{random.vector(1)};
    const std::size_t steps = random.below(60);
    const double reach = std::exp(random.uniform(-8, -1));
    for (std::size_t step = 0; step < steps; ++step) points.push_back(points.back() + random.vector(reach));
    if (k % 3 == 0) points.push_back(points.front());
    arcs.push_back(arc_of(std::move(points)));
  }
  return arcs;
}

/// By the triangle of the point and the two ends: the height, or the shorter of two sides.
double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const double length = norm(b - a), to_ends = std::min(norm(p - a), norm(p - b));
  if (length == 0 || dot(p - a, b - a) <= 0 || dot(p - b, a - b) <= 0) return to_ends;
  return norm(cross(p - a, b - a)) / length;
}

double nearest_of_all(const Arcs& arcs, const Vector3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const SingularityGraph::Arc& arc : arcs) {
    for (std::size_t k = 0; k < arc.points.size(); ++k)
      best = std::min(best, distance_to_segment(p, arc.points[k], arc.points[k > 0 ? k - 1 : 0]));
  }
  return best;
}

std::vector<double> distances_of(const ArcDistance& distance, const std::vector<Vector3>& points) {
  std::vector<double> distances(points.size());
  distance.at(points, distances);
  return distances;
}

TEST(SamplingArcDistance, IsTheLeastOfTheDistancesToAllSegments) {
  Random random(1);
  for (const std::size_t count : {1, 2, 5, 40}) {
    const Arcs arcs = random_arcs(random, count);
    const ArcDistance distance(arcs);
    for (int k = 0; k < 500; ++k) {
      const double reach = k % 2 ? 1.2 : 20;
      const Vector3 p = random.vector(reach);
      const double expected = nearest_of_all(arcs, p);
      ASSERT_NEAR(distance.at(p), expected, kRounding * (1 + expected)) << count;
    }
  }
}

TEST(SamplingArcDistance, IsZeroOnAnArc) {
  Random random(2);
  const Arcs arcs = random_arcs(random, 20);
  const ArcDistance distance(arcs);
  for (const SingularityGraph::Arc& arc : arcs) {
    for (std::size_t k = 0; k + 1 < arc.points.size(); ++k) {
      EXPECT_EQ(distance.at(arc.points[k]), 0);
      EXPECT_LT(distance.at(0.5 * (arc.points[k] + arc.points[k + 1])), kRounding);
    }
  }
}

TEST(SamplingArcDistance, OfManyPointsIsThatOfEachToTheBitInAnyOrderAndNumber) {
  Random random(3);
  const Arcs arcs = random_arcs(random, 30);
  const ArcDistance distance(arcs);
  for (const std::size_t count : {0, 1, 3, 7, 8, 9, 100, 1000}) {
    std::vector<Vector3> points;
    for (std::size_t k = 0; k < count; ++k) points.push_back(random.vector(k % 5 ? 1 : 100));
    // On a side of its box, where rounding decides what is nearer.
    for (std::size_t k = 0; k < count; k += 3) points[k] = arcs[k % arcs.size()].points.back();
    const std::vector<double> distances = distances_of(distance, points);
    for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(distances[k], distance.at(points[k]));
  }
}

TEST(SamplingArcDistance, IsInfiniteWhereThereIsNoArc) {
  const ArcDistance distance(Arcs{});
  EXPECT_EQ(distance.at({1, 2, 3}), std::numeric_limits<double>::infinity());
  for (const double d : distances_of(distance, std::vector<Vector3>(9)))
    EXPECT_EQ(d, std::numeric_limits<double>::infinity());
}

TEST(SamplingArcDistance, ToAnArcOfOnePointIsThatToThePoint) {
  const ArcDistance distance(Arcs{arc_of({{1, 2, 3}})});
  EXPECT_EQ(distance.at({1, 2, 3}), 0);
  EXPECT_EQ(distance.at({4, 6, 3}), 5);
}

}  // namespace
}  // namespace crossgrain
