// SPDX-License-Identifier: Apache-2.0
#include "singularity/axis_names.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

Quaternion turn_about_z(double degrees) {
  return from_rotation_vector({0, 0, degrees * std::numbers::pi / 180});
}

/// A ring of frames around a singular line of index `quarters` / 4 along z, each stored with another choice
/// among the 24 equivalent frames.
struct Ring {
  std::vector<Quaternion> frames;
  std::vector<FrameLink> links;

  explicit Ring(int quarters) {
    constexpr int kCount = 36;
    const std::array<CubeRotation, 3> choices{{{1, 0, 0, 0}, {1, 1, 1, 1}, {1, 1, 0, 0}}};
    for (int i = 0; i < kCount; ++i) {
      frames.push_back(turn_about_z(90.0 * quarters * i / kCount) *
                       to_quaternion(choices[static_cast<std::size_t>(i) % 3]));
      links.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>((i + 1) % kCount), 1, 1});
    }
  }
};

std::size_t axis_named(const AxisNames& names, std::uint8_t name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

TEST(AxisNames, AgreeAroundAPathThatExchangesNoAxes) {
  const Ring ring(2);
  const auto names = name_axes(ring.frames, ring.links, 7);
  EXPECT_TRUE(seams_of(names, ring.frames, ring.links).empty());
}

TEST(AxisNames, DisagreeOnceAroundAQuarterTurn) {
  for (const int quarters : {1, -1, 3}) {
    const Ring ring(quarters);
    const auto names = name_axes(ring.frames, ring.links, 0);
    EXPECT_EQ(seams_of(names, ring.frames, ring.links).size(), 1u);
  }
}

TEST(AxisNames, KeepTheAxisOfTheTurnAndStartFromTheCoordinateAxes) {
  const Ring ring(1);
  const auto names = name_axes(ring.frames, ring.links, 0);
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_NEAR(std::abs(axes_of(ring.frames[i])[axis_named(names[i], 2)][2]), 1, 1e-12);
  EXPECT_NEAR(std::abs(axes_of(ring.frames[0])[axis_named(names[0], 0)][0]), 1, 1e-12);
}

TEST(AxisNames, NamePartsWithoutLinksByTheCoordinateAxes) {
  const std::vector<Quaternion> frames{turn_about_z(10), turn_about_z(80)};
  const auto names = name_axes(frames, {}, 0);
  EXPECT_EQ(names[0], (AxisNames{0, 1, 2}));
  EXPECT_EQ(names[1], (AxisNames{1, 0, 2}));
}

}  // namespace
}  // namespace crossgrain
