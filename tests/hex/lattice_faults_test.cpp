// SPDX-License-Identifier: Apache-2.0
#include "hex/lattice_faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"
#include "fit/hex_lattice.hpp"
#include "hex/lattice_search.hpp"
#include "measure/hex_faces.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// 4 by 4 by 4 unit cubes in a box that is higher.
struct Low {
  LatticeHexahedra made;
  Surface model;

  explicit Low(double height)
      : model(prepare_surface(
            CheckedMesh::derived(translate_mesh(make_box({4, 4, height}), {2, 2, height / 2})))) {
    made.mesh = testing::lattice_mesh({4, 4, 4}, [](int, int, int) { return 1; });
    made.mesh.regions.clear();
    for (const HexSide& side : boundary_of(made.mesh)) made.mesh.boundary.push_back({side.vertices, 0});
    made.report.features.emplace();
    made.report.size = 1;
  }
};

TEST(PlacesToRefine, AreThoseFarFromTheSurfaceWithItsNormal) {
  const Low low(4.5);
  const std::vector<FinePlace> places = places_to_refine(low.made.mesh, low.made.report, low.model, 1, {});
  ASSERT_FALSE(places.empty());
  for (const FinePlace& place : places) {
    EXPECT_GT(place.at[2], 3.9);
    EXPECT_NEAR(std::abs(place.normal[2]), 1, 0.01) << place.at[0] << " " << place.at[1];
    EXPECT_EQ(place.size, kFinerSize);
  }
  const Low near(4.2);
  EXPECT_TRUE(places_to_refine(near.made.mesh, near.made.report, near.model, 1, {}).empty()) << "near enough";
}

TEST(PlacesToRefine, AreFarInSizesAskedFor) {
  Low low(4.5);
  low.made.report.size = 2;
  EXPECT_TRUE(places_to_refine(low.made.mesh, low.made.report, low.model, 1, {}).empty());
}

TEST(PlacesToRefine, AreFinerThanWhereItWasTriedBefore) {
  const Low low(4.5);
  const std::vector<FinePlace> before = {{{2, 2, 4}, 0.5, {0, 0, 1}}};
  bool has_finer = false;
  const std::vector<FinePlace> places =
      places_to_refine(low.made.mesh, low.made.report, low.model, 1, before);
  for (const FinePlace& place : places) has_finer |= place.size == kFinerSize * 0.5;
  EXPECT_TRUE(has_finer);
  EXPECT_EQ(places.front().at, before.front().at) << "what was tried is not given up";
}

TEST(PlacesToRefine, AreThoseOfLostFeaturesAndOfBadShapesInAllDirections) {
  Low low(4);
  low.made.report.features->lacking.push_back({HexLackKind::kCrease, 1, {4, 4, 1}});
  low.made.mesh.vertices[0] = {1.2, 1.2, 1.2};
  const std::vector<FinePlace> places = places_to_refine(low.made.mesh, low.made.report, low.model, 1, {});
  const auto is_near = [&](const Vector3& at) {
    return std::ranges::any_of(
        places, [&](const FinePlace& place) { return norm(place.at - at) < 1 && norm(place.normal) == 0; });
  };
  EXPECT_TRUE(is_near({4, 4, 1}));
  EXPECT_TRUE(is_near({0.6, 0.6, 0.6}));
}

}  // namespace
}  // namespace crossgrain
