// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "crossgrain/hex_features.hpp"

namespace crossgrain {
namespace {

TEST(FeatureWords, CountWhatIsLackingByKindWithTheFirstPlace) {
  HexFeatures features;
  EXPECT_EQ(lacks_of(features, 2), "");
  features.lacking.push_back({HexLackKind::kCrease, 14, {1, 2, 3}, 0.4, 0.5});
  EXPECT_EQ(lacks_of(features, 2), "1 crease is not kept: edge 14 around 1 2 3");
  features.lacking.push_back({HexLackKind::kCrease, 0, {4, 5, 6}, 0.4, 0.5});
  features.lacking.push_back({HexLackKind::kFace, 7, {0, 0, 1}});
  EXPECT_EQ(
      lacks_of(features, 2),
      "2 creases are not kept, the first, edge 14 around 1 2 3; 1 face has no quads: face 7 around 0 0 1");
}

TEST(FeatureWords, TellDistancesInUnitsAndInHexahedraAndVolumesInPercent) {
  HexFeatures features;
  features.lacking.push_back({HexLackKind::kOffModel, 0, {1, 0, 0}, 0.46});
  features.lacking.push_back({HexLackKind::kOffMesh, 0, {2, 0, 0}, 0.5});
  features.lacking.push_back({HexLackKind::kVolume, 0, {}, 0.78});
  EXPECT_EQ(lacks_of(features, 2),
            "the mesh is up to 0.92 off the surface around 1 0 0, 0.46 of the size; the surface "
            "is up to 1 "
            "from it around 2 0 0, 0.5 of the size; its volume is 22 % below the model's");
}

TEST(FeatureWords, TellWhatIsKeptAndWhatIsTooSmall) {
  HexFeatures features;
  features.corners = {8, 7};
  features.creases = {1, 1};
  EXPECT_EQ(kept_of(features), "7 of 8 corners, 1 of 1 crease kept");
  features.small = 6;
  EXPECT_EQ(kept_of(features),
            "7 of 8 corners, 1 of 1 crease kept; 6 others smaller than the hexahedra, kept too");
  features.too_small.resize(2);
  EXPECT_EQ(
      kept_of(features),
      "7 of 8 corners, 1 of 1 crease kept; 6 others smaller than the hexahedra, 2 of which are not kept");
  features = {};
  features.small = 1;
  EXPECT_EQ(kept_of(features), "1 feature smaller than the hexahedra, kept too");
}

TEST(TopologyOf, TellsWhatDiffers) {
  HexFeatures features;
  EXPECT_EQ(topology_of(features), "");
  features.shells = {0};
  features.model_shells = {-2};
  EXPECT_EQ(topology_of(features), "it has 1 tunnel, the model 2 tunnels");
  features.model_shells = {0, 2};
  EXPECT_EQ(topology_of(features), "it has 1 closed surface, the model 2 closed surfaces");
  features.model_shells = {0};
  EXPECT_TRUE(features.has_topology_of_model());
}

}  // namespace
}  // namespace crossgrain
