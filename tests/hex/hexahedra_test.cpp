// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hexahedra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/solve.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

TetFrameField field_of(TetMesh mesh) {
  return solve_onto(TetDomain(std::move(mesh)).prepared_for_map());
}

HexOptions of_size(double size, int threads = 0) {
  HexOptions options;
  options.size = size;
  options.threads = threads;
  return options;
}

HexOptions of_cells(double cells) {
  HexOptions options;
  options.cells = cells;
  return options;
}

const TetFrameField& box_field() {
  static const TetFrameField field = [] {
    TetMesh mesh = TetBox{{4, 3, 3}}.mesh(0.1);
    mesh.regions.assign(mesh.tets.size(), 7);
    return field_of(std::move(mesh));
  }();
  return field;
}

const TetFrameField& cylinder_field() {
  static const TetFrameField field = field_of(tet_cylinder(8));
  return field;
}

TEST(Hexahedra, OfABoxAreTheBricksThatFitBest) {
  const Hexahedra made = hexahedra(box_field(), of_size(0.5));
  const HexReport& report = made.report();
  EXPECT_EQ(report.outcome, HexOutcome::kAllHex);
  EXPECT_EQ(report.reason, "");
  EXPECT_EQ(report.hexahedra, 8u * 6 * 6);
  EXPECT_EQ(report.vertices, 9u * 7 * 7);
  EXPECT_EQ(report.used_size, 0.5);
  EXPECT_NEAR(report.quality.least, 1, 1e-6);
  EXPECT_NEAR(report.volume, 36, 1e-6);
  EXPECT_NEAR(report.model_volume, 36, 1e-9);
  EXPECT_NEAR(report.area, 2 * (12 + 12 + 9), 1e-5);
  EXPECT_LT(report.largest_distance, 1e-9);
  EXPECT_LT(report.largest_distance_of_model, 1e-6);
  EXPECT_EQ(made.mesh.boundary.size(), 2u * (48 + 48 + 36));
  EXPECT_EQ(made.mesh.regions, std::vector<std::int32_t>(report.hexahedra, 7));
  ASSERT_TRUE(made.field.report().hexahedra);
  EXPECT_EQ(made.field.report().hexahedra->hexahedra, report.hexahedra);
}

TEST(Hexahedra, CountAlongTheLongestSide) {
  EXPECT_EQ(hexahedra(box_field(), of_cells(4)).report().hexahedra, 4u * 3 * 3);
}

TEST(Hexahedra, OfACylinderHaveGoodShapesAndKeepToItsSurface) {
  for (const double size : {0.5, 0.2}) {
    HexOptions options = of_size(size);
    options.preference = HexPreference::kMap;
    const HexReport report = hexahedra(cylinder_field(), options).report();
    // Twelve edges around the cylinder would keep its volume; eight do not.
    EXPECT_EQ(report.outcome, size < 0.3 ? HexOutcome::kAllHex : HexOutcome::kApproximate);
    EXPECT_GT(report.quality.least, 0.6);
    EXPECT_GT(report.quality.mean, size < 0.3 ? 0.9 : 0.85);
    EXPECT_GT(report.quality.least, report.quality_before.least);
    EXPECT_EQ(report.quality.inverted, 0u);
    EXPECT_LT(report.largest_distance, 1e-9 * size);
    EXPECT_EQ(report.inner_valences.size(), 5u);  // the four arcs have three hexahedra each
    EXPECT_GT(report.inner_valences[3], 0u);
    EXPECT_EQ(report.inner_valences[3] % 4, 0u);
  }
}

TEST(Hexahedra, AreThoseOfALatticeWhereAMapDoesNotKeepTheModel) {
  const Hexahedra made = hexahedra(cylinder_field(), of_size(0.5));
  const HexReport& report = made.report();
  EXPECT_EQ(report.outcome, HexOutcome::kAllHex);
  EXPECT_TRUE(report.attempts[report.best_attempt].is_of_lattice());
  EXPECT_GT(report.quality.least, 0.4);
  EXPECT_NE(report.map_fault, "");
  EXPECT_TRUE(made.map.tets.empty());
  EXPECT_EQ(made.mesh.hexahedra.size(), report.hexahedra);
}

TEST(Hexahedra, AreALatticeAtOnceWhereThatIsPreferred) {
  HexOptions options = of_size(0.5);
  options.preference = HexPreference::kLattice;
  const HexReport report = hexahedra(box_field(), options).report();
  EXPECT_EQ(report.outcome, HexOutcome::kAllHex);
  EXPECT_EQ(report.hexahedra, 8u * 6 * 6);
  ASSERT_EQ(report.attempts.size(), 1u);
  EXPECT_TRUE(report.attempts[0].is_of_lattice());
}

TEST(Hexahedra, AreTheSameForAnyNumberOfThreads) {
  const Hexahedra one = hexahedra(cylinder_field(), of_size(0.3, 1));
  const Hexahedra four = hexahedra(cylinder_field(), of_size(0.3, 4));
  EXPECT_EQ(one.mesh.vertices, four.mesh.vertices);
  EXPECT_EQ(one.mesh.hexahedra, four.mesh.hexahedra);
}

TEST(Hexahedra, SayWhatTheyAreInOneSentence) {
  const std::string text = sentence_of(hexahedra(box_field(), of_size(1)).report());
  EXPECT_EQ(text, "all-hex: 36 hexahedra, mean edge 1");
}

TEST(Hexahedra, RefuseSizesThatAreNone) {
  for (const HexOptions& options : {of_size(-1), of_cells(0), of_size(NAN)}) {
    try {
      hexahedra(box_field(), options);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    }
  }
}

TEST(Hexahedra, EndWhenTheMonitorIsCancelled) {
  Monitor monitor;
  monitor.cancel();
  try {
    hexahedra(cylinder_field(), HexOptions(), monitor);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
}

}  // namespace
}  // namespace crossgrain
