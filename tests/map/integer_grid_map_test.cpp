// SPDX-License-Identifier: Apache-2.0
#include "map/integer_grid_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "crossgrain/thread_limit.hpp"
#include "map/arced_cylinder.hpp"
#include "reduction/demanded_splits.hpp"

namespace crossgrain {
namespace {

using testing::AskewBox;

/// How far a map is from integers where a map to a grid must have them: constant coordinates of faces of the
/// surface, coordinates across singular edges, and translations across the cut. From the coordinates alone.
double off_integers(const MapEnergy& energy, const MapCoordinates& map) {
  const MapUnknowns& unknowns = energy.unknowns();
  const CutSolid& cut = unknowns.cut();
  const TetComplex& complex = cut.field().complex();
  const TetSolid& solid = complex.solid();
  const auto at = [&](std::uint32_t tet, std::uint32_t vertex) -> Eigen::Vector3d {
    return map.segment<3>(static_cast<Eigen::Index>(3 * cut.copy_at(tet, vertex)));
  };
  double most = 0;
  const auto take = [&](double value) { most = std::max(most, std::abs(value - std::round(value))); };
  for (std::uint32_t f = 0; f < solid.boundary.size(); ++f)
    for (const std::uint32_t v : solid.boundary[f])
      take(at(solid.boundary_tets[f], v)[unknowns.normal_axis(f) % 3]);
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    if (!cut.is_singular(e)) continue;
    for (int k = 0; k < 3; ++k)
      for (const std::uint32_t end : complex.edges()[e].ends)
        if (k != unknowns.axis_of_edge(e)) take(at(complex.edges()[e].first_tet, end)[k]);
  }
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
    const SheetStep step = cut.step_across({f, false});
    const auto& [vertices, sides] = solid.inner_faces[f];
    for (const std::uint32_t v : vertices) {
      Eigen::Vector3d from = at(sides[0], v);
      const Eigen::Vector3d to = at(sides[1], v);
      if (step != 0) {
        const CubeGroup& group = CubeGroup::instance();
        const std::uint8_t own = cut.rotation(static_cast<std::size_t>(std::abs(step) - 1));
        Eigen::Vector3d turned;
        for (SignedAxis k = 0; k < 3; ++k) {
          const SignedAxis image = group.image(step > 0 ? own : group.inverse_of(own), k);
          turned[image % 3] = (image < 3 ? 1 : -1) * from[k];
        }
        from = turned;
      }
      for (int k = 0; k < 3; ++k) take(to[k] - from[k]);
    }
  }
  return most;
}

TEST(IntegerGridMap, OfABoxHasNoFlipsAndAllIntegers) {
  const AskewBox box({4, 3, 3}, {0.9, 1.1, 0.8});
  const MapEnergy energy(box.unknowns, 0.4);
  const IntegerGridMap map = integer_grid_map(energy);
  EXPECT_EQ(map.flips.tets, 0u);
  EXPECT_EQ(map.integers, 6u);
  EXPECT_LT(off_integers(energy, map.coordinates), 1e-9);
}

TEST(IntegerGridMap, OfACylinderHasItsFourArcsOnIntegerLines) {
  const testing::ArcedCylinder cylinder;
  for (const double size : {0.4, 0.2, 0.11}) {
    const MapEnergy energy(cylinder.unknowns, size);
    const IntegerGridMap map = integer_grid_map(energy);
    EXPECT_EQ(map.flips.tets, 0u) << size;
    EXPECT_EQ(map.missing, 0) << size;
    EXPECT_LT(off_integers(energy, map.coordinates), 1e-9) << size;
  }
}

TEST(IntegerGridMap, IsTheSameToTheBitForAnyNumberOfThreads) {
  const AskewBox box({3, 3, 3}, {0.9, 1.1, 0.8});
  const MapEnergy energy(box.unknowns, 0.4);
  const auto on = [&](int threads) {
    const ThreadLimit limit(threads);
    return integer_grid_map(energy).coordinates;
  };
  EXPECT_EQ(on(1), on(2));
}

}  // namespace
}  // namespace crossgrain
