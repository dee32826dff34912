// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/hexahedra.hpp"
#include "crossgrain/solve.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using Corners = HexMap::Corners;
using Matrix = std::array<Vector3, 3>;

const Hexahedra& cylinder() {
  static const Hexahedra made = [] {
    HexOptions options;
    options.size = 0.3;
    return hexahedra(solve_onto(TetDomain(tet_cylinder(8)).prepared_for_map()), options);
  }();
  return made;
}

std::vector<Matrix> cube_rotations() {
  std::vector<Matrix> found;
  std::array<int, 3> axes{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Matrix rotation{};
      for (std::size_t k = 0; k < 3; ++k)
        rotation[k][static_cast<std::size_t>(axes[k])] = (signs >> k & 1) == 0 ? 1 : -1;
      if (dot(cross(rotation[0], rotation[1]), rotation[2]) > 0) found.push_back(rotation);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return found;
}

Vector3 times(const Matrix& rotation, const Vector3& p) {
  return {dot(rotation[0], p), dot(rotation[1], p), dot(rotation[2], p)};
}

/// The sides of each face: tet and the corners in the order of their vertices.
struct Side {
  std::uint32_t tet;
  std::array<std::size_t, 3> corners;
};
std::vector<std::vector<Side>> faces_of(const HexMap& map) {
  std::map<std::array<std::uint32_t, 3>, std::vector<Side>> faces;
  for (std::uint32_t t = 0; t < map.tets.size(); ++t)
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      Side side{t, {}};
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != opposite) side.corners[n++] = k;
      const auto vertex = [&](std::size_t k) { return map.tets[t][k]; };
      std::sort(side.corners.begin(), side.corners.end(),
                [&](std::size_t a, std::size_t b) { return vertex(a) < vertex(b); });
      faces[{vertex(side.corners[0]), vertex(side.corners[1]), vertex(side.corners[2])}].push_back(side);
    }
  std::vector<std::vector<Side>> result;
  for (auto& [vertices, sides] : faces) result.push_back(std::move(sides));
  return result;
}

/// The translation of a rotation that takes one side of a face to the other within a tolerance; none if there
/// is no such rotation.
std::optional<Vector3> translation_across(const std::vector<Corners>& map, const Side& from, const Side& to,
                                          double tolerance) {
  static const std::vector<Matrix> kRotations = cube_rotations();
  const auto before = [&](std::size_t k) { return map[from.tet][from.corners[k]]; };
  const auto after = [&](std::size_t k) { return map[to.tet][to.corners[k]]; };
  for (const Matrix& rotation : kRotations) {
    const Vector3 translation = after(0) - times(rotation, before(0));
    double off = 0;
    for (const std::size_t k : {1, 2})
      for (const double x : times(rotation, before(k)) + translation - after(k))
        off = std::max(off, std::abs(x));
    if (off <= tolerance) return translation;
  }
  return std::nullopt;
}

bool is_whole(const Vector3& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return x == std::round(x); });
}

TEST(HexMap, HasExactWholeTransitionsAfterRounding) {
  for (const auto& sides : faces_of(cylinder().map)) {
    if (sides.size() != 2) continue;
    const auto translation = translation_across(cylinder().map.integer_grid, sides[0], sides[1], 0);
    ASSERT_TRUE(translation);
    EXPECT_TRUE(is_whole(*translation));
  }
}

TEST(HexMap, IsContinuousToRoundingBeforeIt) {
  std::size_t cut = 0;
  for (const auto& sides : faces_of(cylinder().map)) {
    if (sides.size() != 2) continue;
    const auto translation = translation_across(cylinder().map.seamless, sides[0], sides[1], 1e-12);
    ASSERT_TRUE(translation);
    cut += norm(*translation) > 1e-12 ? 1 : 0;
  }
  EXPECT_GT(cut, 0u);
}

TEST(HexMap, TakesTheSurfaceToPlanesThatAreWholeAfterRounding) {
  std::size_t whole_before = 0, faces = 0;
  for (const auto& sides : faces_of(cylinder().map)) {
    if (sides.size() != 1) continue;
    const auto constant = [&](const std::vector<Corners>& map) {
      const auto at = [&](std::size_t k) { return map[sides[0].tet][sides[0].corners[k]]; };
      for (std::size_t k = 0; k < 3; ++k)
        if (std::abs(at(0)[k] - at(1)[k]) < 1e-12 && std::abs(at(0)[k] - at(2)[k]) < 1e-12) return at(0)[k];
      return double(NAN);
    };
    const double after = constant(cylinder().map.integer_grid), before = constant(cylinder().map.seamless);
    EXPECT_EQ(after, std::round(after));
    EXPECT_FALSE(std::isnan(before));
    ++faces;
    whole_before += std::abs(before - std::round(before)) < 1e-9 ? 1 : 0;
  }
  EXPECT_LT(whole_before, faces);
}

TEST(HexMap, HasTheVolumeOfAsManyCubesAsThereAreHexahedra) {
  double six_volumes = 0;
  for (const Corners& p : cylinder().map.integer_grid)
    six_volumes += dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
  ASSERT_EQ(cylinder().report().outcome, HexOutcome::kAllHex);
  EXPECT_NEAR(six_volumes / 6, static_cast<double>(cylinder().mesh.hexahedra.size()), 1e-9);
}

TEST(HexMap, TellsTheSizeThatWasTaken) {
  EXPECT_EQ(cylinder().map.size, cylinder().report().used_size);
}

}  // namespace
}  // namespace crossgrain
