// SPDX-License-Identifier: Apache-2.0
#include "fit/feature_fit.hpp"

#include <gtest/gtest.h>

#include <map>

#include "base/parallel.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/thread_limit.hpp"
#include "fit/fitted_shapes.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain::testing {
namespace {

/// A box of unit cubes whose vertices near one edge are pushed in, as where a map has rounded a crease off.
FittedShape dented_box() {
  FittedShape shape = lattice_in_box({5, 4, 3});
  for (Vector3& v : shape.mesh.vertices)
    if (v[0] == 0 && v[2] == 0) v = {0.35, v[1], 0.35};
  for (const HexSide& side : boundary_of(shape.mesh)) shape.mesh.boundary.push_back({side.vertices, 0});
  return shape;
}

TEST(FeatureFit, LeavesAMeshThatKeepsAllAsItIs) {
  FittedShape shape = lattice_in_box({5, 4, 3});
  const FeatureFit fit = fitted_to_features(shape.mesh, shape.complex, {1, 1});
  EXPECT_EQ(fit.tries.size(), 1u);
  EXPECT_EQ(fit.best.mesh.vertices, shape.mesh.vertices);
  EXPECT_TRUE(fit.best.is_good());
}

TEST(FeatureFit, BringsBackACreaseThatTheMeshHasRoundedOff) {
  const FittedShape shape = dented_box();
  const FeatureFit fit = fitted_to_features(shape.mesh, shape.complex, {1, 1});
  ASSERT_EQ(fit.tries.front().way, HexFitWay::kAsMapped);
  EXPECT_GE(fit.tries.front().lacking, 3u) << "two corners and a crease";
  EXPECT_EQ(fit.tries[1].way, HexFitWay::kSnapped);
  EXPECT_TRUE(fit.best.measure.is_faithful());
  EXPECT_GT(fit.best.least, 0.4);
  EXPECT_EQ(fit.best.measure.corners.kept, 8);
  EXPECT_EQ(fit.best.measure.curves.kept, 12);
}

TEST(FeatureFit, IsJudgedInTheSizeAskedForWhateverTheEdge) {
  const FittedShape shape = dented_box();
  // A crease 0.5 off is lost in cubes of 1, and within the limits of hexahedra of 10.
  EXPECT_GE(fitted_to_features(shape.mesh, shape.complex, {1, 1}).tries.front().lacking, 3u);
  const FeatureFit large = fitted_to_features(shape.mesh, shape.complex, {1, 10});
  EXPECT_EQ(large.tries.front().lacking, 0u);
  EXPECT_EQ(large.best.measure.size, 10);
}

TEST(FeatureFit, GivesQuadsTheNumbersOfTheModelsFaces) {
  const FittedShape shape = dented_box();
  const HexMesh mesh = fitted_to_features(shape.mesh, shape.complex, {1, 1}).best.mesh;
  std::map<std::int32_t, std::size_t> quads;
  for (const HexMesh::Face& face : mesh.boundary) ++quads[face.tag];
  EXPECT_EQ(quads.size(), 6u);
  EXPECT_EQ(quads.count(0), 0u);
}

TEST(FeatureFit, GivesQuadsTheNumbersOfFacesThatASoftCurveWithoutPathDivides) {
  const FittedShape shape = dented_box();
  TriangleMesh halved = translate_mesh(make_box({5, 4, 3}), {2.5, 2, 1.5});
  for (std::int32_t t = 0; t < 12; ++t) halved.faces.push_back(t + 1);
  const FeatureFit fit =
      fitted_to_features(shape.mesh, feature_complex(prepare_surface(std::move(halved))), {1, 1});
  EXPECT_NE(fit.best_try, 0u);
  std::map<std::int32_t, std::size_t> quads;
  for (const HexMesh::Face& face : fit.best.mesh.boundary) ++quads[face.tag];
  EXPECT_EQ(quads.size(), 12u);
  EXPECT_EQ(quads.count(0), 0u);
}

TEST(FeatureFit, IsTheSameForAnyNumberOfThreads) {
  const FittedShape shape = dented_box();
  const auto made = [&](int threads) {
    const ThreadLimit limit(threads);
    return fitted_to_features(shape.mesh, shape.complex, {1, 1}).best.mesh.vertices;
  };
  EXPECT_EQ(made(1), made(2));
}

TEST(FeatureFit, LeavesTheMeshAsItIsWhereAStopComesBeforeItIsMeasured) {
  const FittedShape shape = dented_box();
  Monitor monitor;
  monitor.stop();
  const WatchedLoops watched(monitor, Stops::kHeeded);
  const FeatureFit fit = fitted_to_features(shape.mesh, shape.complex, {1, 1});
  EXPECT_TRUE(fit.is_stopped);
  EXPECT_TRUE(fit.tries.empty());
  EXPECT_EQ(fit.best.mesh.vertices, shape.mesh.vertices);
}

TEST(FeatureFit, IsBetterValidThanFaithfulAndFaithfulThanOfGoodShape) {
  FittedMesh shapely, faithful;
  shapely.least = 0.9;
  shapely.measure.lacking.push_back({FeatureMeasure::Kind::kCurve, 0, 0, {}, 0.5, 0, 0});
  faithful.least = 0.05;
  EXPECT_TRUE(is_better_fit(faithful, shapely));
  faithful.least = 0.01;
  EXPECT_FALSE(is_better_fit(faithful, shapely)) << "too poor to compute on";
  faithful.least = 0.9;
  faithful.invalid = 1;
  EXPECT_FALSE(is_better_fit(faithful, shapely));
}

}  // namespace
}  // namespace crossgrain::testing
