// SPDX-License-Identifier: Apache-2.0
#include "picture/streamlines.hpp"

#include <gtest/gtest.h>

#include "display/axis_colours.hpp"

namespace crossgrain {
namespace {

TEST(PictureStreamlines, HaveTheColoursOfTheirAxes) {
  const std::vector<Rod> rods =
      streamlines({{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0}, {{{0, 0, 0}, {0, 0, 1}}, 2}}, 0.1);
  ASSERT_EQ(rods.size(), 3u);
  EXPECT_EQ(rods[0].colour, colour_of(kAxisColours[0]));
  EXPECT_EQ(rods[1].colour, colour_of(kAxisColours[0]));
  EXPECT_EQ(rods[2].colour, colour_of(kAxisColours[2]));
}

TEST(PictureStreamlines, LegendNamesTheAxesThatOccur) {
  const auto legend = streamline_legend({{{{0, 0, 0}, {1, 0, 0}}, 2}, {{{0, 0, 0}, {0, 1, 0}}, 0}});
  ASSERT_TRUE(legend);
  ASSERT_EQ(legend->signs.size(), 2u);
  EXPECT_EQ(legend->signs[0].text, "along axis x");
  EXPECT_EQ(legend->signs[1].text, "along axis z");
  EXPECT_FALSE(streamline_legend({}));
}

TEST(PictureStreamlines, NearACutLieOnIt) {
  Section section;
  section.normal = {0, 0, 1};
  section.offset = 2;
  // Falls through the plane; runs beside it; is too far away.
  const std::vector<AxisCurve> curves{
      {{{0, 0, 4}, {4, 0, 0}}, 0}, {{{0, 5, 2.5}, {1, 5, 2.5}}, 1}, {{{0, 0, 5}, {1, 0, 5}}, 1}};
  const std::vector<Rod> rods = streamlines_on(section, curves, 1, 0.1);
  ASSERT_EQ(rods.size(), 2u);
  EXPECT_EQ(rods[0].from, (Vector3{1, 0, 2}));
  EXPECT_EQ(rods[0].to, (Vector3{3, 0, 2}));
  EXPECT_EQ(rods[1].from, (Vector3{0, 5, 2}));
  EXPECT_EQ(rods[1].to, (Vector3{1, 5, 2}));
}

}  // namespace
}  // namespace crossgrain
