// SPDX-License-Identifier: Apache-2.0
#include "measure/angle_statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "crossgrain/thread_limit.hpp"

namespace crossgrain {
namespace {

struct Weighed {
  std::vector<SurfacePiece> pieces;
  std::vector<float> angles;

  void add(float angle, float area) {
    pieces.push_back({0, area});
    angles.push_back(angle);
  }
  SolveReport::Alignment statistics() const {
    double area = 0;
    for (const SurfacePiece& piece : pieces) area += piece.area;
    return angle_statistics(pieces, angles, area);
  }
};

/// Enough for several tasks; a tenth does not count.
Weighed many_pieces(unsigned seed, const std::function<float(double)>& angle_of) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Weighed weighed;
  for (int k = 0; k < 200000; ++k) {
    const float angle = uniform(engine) < 0.1 ? kExcludedAngle : angle_of(uniform(engine));
    weighed.add(angle, static_cast<float>(uniform(engine)));
  }
  return weighed;
}

/// By sorting.
float expected_p95(const Weighed& weighed) {
  std::vector<std::pair<float, float>> included;
  double area = 0;
  for (std::size_t k = 0; k < weighed.pieces.size(); ++k) {
    if (weighed.angles[k] == kExcludedAngle) continue;
    included.emplace_back(weighed.angles[k], weighed.pieces[k].area);
    area += weighed.pieces[k].area;
  }
  std::sort(included.rbegin(), included.rend());
  double above = 0;
  for (const auto& [angle, piece_area] : included) {
    above += piece_area;
    if (above > 0.05 * area) return angle;
  }
  return included.back().first;
}

TEST(AngleStatistics, FindTheVeryAngleThatSortingFinds) {
  const std::vector<std::function<float(double)>> angles_of{
      [](double u) { return static_cast<float>(54 * u); },
      [](double u) { return static_cast<float>(1e-6 * u * u); },          // close together
      [](double u) { return static_cast<float>(u < 0.96 ? 0 : 20); },     // two values
      [](double u) { return static_cast<float>(std::floor(9 * u) / 8); }  // few, often repeated
  };
  for (unsigned seed = 0; seed < angles_of.size(); ++seed) {
    const Weighed weighed = many_pieces(seed, angles_of[seed]);
    EXPECT_EQ(weighed.statistics().p95, expected_p95(weighed)) << seed;
  }
}

TEST(AngleStatistics, WeighByAreaAndLeaveOutWhatDoesNotCount) {
  Weighed weighed;
  weighed.add(10, 3);
  weighed.add(kExcludedAngle, 5);
  weighed.add(30, 1);
  const SolveReport::Alignment result = weighed.statistics();
  EXPECT_NEAR(result.mean.value(), 15, 1e-12);
  EXPECT_EQ(result.max, 30);
  EXPECT_EQ(result.p95, 30);
  EXPECT_NEAR(result.excluded_share, 5.0 / 9, 1e-14);
}

TEST(AngleStatistics, OfNothingAreNone) {
  Weighed excluded;
  excluded.add(kExcludedAngle, 2);
  for (const SolveReport::Alignment& result : {Weighed{}.statistics(), excluded.statistics()}) {
    EXPECT_FALSE(result.mean || result.max || result.p95);
  }
  EXPECT_EQ(Weighed{}.statistics().excluded_share, 0);
  EXPECT_EQ(excluded.statistics().excluded_share, 1);
}

TEST(AngleStatistics, OfWeightedAnglesDoNotDependOnHowTheyAreCut) {
  const SolveReport::AngleSummary whole = summary_of({{3, 94}, {1, 2}, {7, 6}});
  const SolveReport::AngleSummary cut = summary_of({{7, 2}, {3, 47}, {7, 4}, {1, 2}, {3, 47}});
  EXPECT_DOUBLE_EQ(*whole.mean, (3 * 94 + 1 * 2 + 7 * 6) / 102.0);
  EXPECT_DOUBLE_EQ(*cut.mean, *whole.mean);
  EXPECT_EQ(*whole.p95, 7);
  EXPECT_EQ(*cut.p95, 7);
  EXPECT_EQ(*whole.max, 7);
  EXPECT_EQ(*summary_of({{3, 96}, {7, 4}}).p95, 3);
  EXPECT_FALSE(summary_of(std::vector<WeightedAngle>{}).mean);
}

TEST(AngleStatistics, AreTheSameForAnyNumberOfThreads) {
  const Weighed weighed = many_pieces(9, [](double u) { return static_cast<float>(u); });
  const auto with_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return weighed.statistics();
  };
  const SolveReport::Alignment one = with_threads(1), two = with_threads(2);
  EXPECT_EQ(one.mean, two.mean);
  EXPECT_EQ(one.p95, two.p95);
  EXPECT_EQ(one.excluded_share, two.excluded_share);
}

}  // namespace
}  // namespace crossgrain
