// SPDX-License-Identifier: Apache-2.0
#include "surface/faded_creases.hpp"

#include <gtest/gtest.h>

#include "support/curved_shapes.hpp"
#include "support/rims.hpp"
#include "support/shapes.hpp"
#include "surface/creases.hpp"

namespace crossgrain {
namespace {

std::optional<Warning> warning_of(TriangleMesh mesh, double least_deg = 35) {
  const Surface surface = prepare_surface(std::move(mesh));
  return faded_crease_warning(surface, sorted_edge_uses(surface.mesh.triangles), {.least_deg = least_deg});
}

TEST(FadedCreases, AreToldWithTheAngleThatFollowsThem) {
  // 56 to 21 degrees.
  const TriangleMesh rim = make_wavy_rim(38.5, 17.5);
  const std::optional<Warning> warning = warning_of(rim);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->kind, WarningKind::kFadedCreases);
  EXPECT_EQ(warning->remedy, Remedy::kUseCreaseAngle);
  EXPECT_EQ(warning->remedy_number, 20);
  EXPECT_EQ(warning->text.find("a crease fades out at "), 0u) << warning->text;
  EXPECT_NE(warning->text.find("where its angle falls to 21 degrees"), std::string::npos) << warning->text;
  EXPECT_TRUE(sharp_curves(prepare_surface(rim), {}).empty());
  EXPECT_EQ(sharp_curves(prepare_surface(rim), {.least_deg = 20}).size(), 1u);
  EXPECT_FALSE(warning_of(rim, 20));
}

TEST(FadedCreases, AreNotToldWhereTheyAreFollowed) {
  EXPECT_FALSE(warning_of(make_wavy_rim(41, 9)));
  EXPECT_FALSE(warning_of(make_box({1, 0.7, 0.4})));
}

TEST(FadedCreases, AreNotToldWhereTheyFadeToNothing) {
  for (const int cells : {10, 40, 160}) {
    EXPECT_FALSE(warning_of(make_fading_ridge(cells, 60))) << cells;
    EXPECT_FALSE(warning_of(make_fading_ridge(cells, 90))) << cells;
  }
}

TEST(FadedCreases, OfCurvedSurfacesOfCoarseTrianglesAreNotTold) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u})
    for (const int subdivisions : {3, 4})
      for (const auto& [knobs, noise] : {std::pair{0.9, 0.0}, {0.5, 0.01}, {0.0, 0.03}})
        EXPECT_FALSE(warning_of(make_knobbly_sphere(subdivisions, knobs, noise, seed)))
            << seed << ' ' << knobs;
}

}  // namespace
}  // namespace crossgrain
