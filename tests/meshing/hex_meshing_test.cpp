// SPDX-License-Identifier: Apache-2.0
// Hexahedra of models, on tets that are made by gmsh or Netgen; without both, those tests are skipped.
#include "crossgrain/hex_meshing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/features.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/writing.hpp"
#include "support/shapes.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

/// Tests that make tets.
class HexMeshing : public testing::Test {
 protected:
  void SetUp() override {
    if (gmsh_program().empty() && netgen_program().empty()) GTEST_SKIP() << "nothing makes tets";
  }
};

/// Tests of given tets.
class HexMeshingOfTets : public testing::Test {};

HexMeshingOptions of_size(double size) {
  HexMeshingOptions options;
  options.hexahedra.size = size;
  return options;
}

/// Hexahedra of a pyramid, at whose tip four faces meet and so no hexahedra; with a single repair each.
Hexahedra partial_pyramid(std::vector<double> shares, std::size_t large_tets = 50000,
                          std::size_t most_sizes = 5) {
  HexMeshingOptions options = of_size(0.5);
  options.large_tets = large_tets;
  options.most_sizes = most_sizes;
  options.hexahedra.repair.tries = {{}};
  options.hexahedra.repair.finalists = 0;
  options.hexahedra.more_tries = {};
  options.hexahedra.finer_sizes = 0;
  options.hexahedra.largest_gap = 1e-9;  // so that nothing counts as filled
  options.tets.size = 0.3;
  options.tet_shares = std::move(shares);
  TriangleMesh pyramid;
  pyramid.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}};
  pyramid.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return make_hexahedra(pyramid, options);
}

ErrorKind kind_of_failure(const TetDomain& tets, const HexMeshingOptions& options,
                          const Monitor& monitor = {}) {
  try {
    make_hexahedra(tets, options, monitor);
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "no error";
  return ErrorKind::kOutput;
}

TEST_F(HexMeshing, OfASurfaceFillsIt) {
  const Hexahedra made = make_hexahedra(make_box({4, 2, 3}), of_size(1));
  EXPECT_EQ(made.report.outcome, HexOutcome::kAllHex);
  EXPECT_EQ(made.mesh.hexahedra.size(), 24u);
  EXPECT_NEAR(made.report.volume, 24, 1e-9);
}

TEST_F(HexMeshing, TellsTheTetsItTried) {
  const Hexahedra made = make_hexahedra(make_box({4, 2, 3}), of_size(1));
  ASSERT_EQ(made.report.tried_tets.size(), 1u);
  const TriedTets& tried = made.report.tried_tets.front();
  EXPECT_NEAR(tried.size, 1.4 * 4.0 / 20, 1e-9);  // 20 edges of 1.4
  EXPECT_EQ(tried.tets, made.field.domain().mesh().tets.size());
  EXPECT_EQ(tried.outcome, HexOutcome::kAllHex);
  EXPECT_EQ(tried.hexahedra, 24u);
  EXPECT_TRUE(tried.is_used);
  EXPECT_GT(tried.tet_seconds, 0);
  EXPECT_GT(tried.seconds, tried.tet_seconds);
  EXPECT_EQ(made.field.report().seconds.read, tried.tet_seconds);
  EXPECT_EQ(made.field.report().hexahedra->tried_tets.size(), 1u);
}

TEST_F(HexMeshing, TriesAllSizesOfTetsWhereNoneIsFilledAndKeepsTheBest) {
  const Hexahedra made = partial_pyramid({1, 1.4, 2});
  ASSERT_NE(made.report.outcome, HexOutcome::kAllHex);
  const std::vector<TriedTets>& tried = made.report.tried_tets;
  ASSERT_EQ(tried.size(), 3u);
  const std::vector<double> sizes{0.3, 0.42, 0.6};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(tried[k].size, sizes[k], 1e-9);
    EXPECT_EQ(tried[k].is_used, tried[k].tets == made.field.domain().mesh().tets.size());
  }
  EXPECT_GT(tried[0].tets, tried[1].tets);
  EXPECT_GT(tried[1].tets, tried[2].tets);
  EXPECT_EQ(std::count_if(tried.begin(), tried.end(), [](const TriedTets& tets) { return tets.is_used; }), 1);
}

TEST_F(HexMeshing, TriesNoMoreSizesThanItMay) {
  EXPECT_EQ(partial_pyramid({1, 1.4, 2}, 50000, 2).report.tried_tets.size(), 2u);
}

TEST_F(HexMeshing, TriesOnlyTheCoarsestOfSizesWithManyTets) {
  const std::vector<TriedTets> tried = partial_pyramid({1, 2, 1.4}, 1).report.tried_tets;
  ASSERT_EQ(tried.size(), 1u);
  EXPECT_NEAR(tried.front().size, 0.6, 1e-9);
}

TEST_F(HexMeshing, SearchesOnAfterPoorHexahedraAndKeepsThem) {
  HexMeshingOptions options = of_size(1);
  options.tet_shares = {1, 2};
  options.least_quality = 1.5;  // more than any hexahedron has
  const Hexahedra made = make_hexahedra(make_box({4, 2, 3}), options);
  EXPECT_EQ(made.report.tried_tets.size(), 2u);
  EXPECT_EQ(made.report.outcome, HexOutcome::kAllHex);
  EXPECT_EQ(made.mesh.hexahedra.size(), 24u);
}

TEST_F(HexMeshing, KeepsWhatItHasWhereLaterTetsFail) {
  const Hexahedra made = partial_pyramid({1, 0.01});
  ASSERT_EQ(made.report.tried_tets.size(), 2u);
  EXPECT_TRUE(made.report.tried_tets[0].is_used);
  EXPECT_NE(made.report.tried_tets[1].failure.find("tets"), std::string::npos);
}

TEST_F(HexMeshing, IsTheSameForAnyNumberOfThreads) {
  HexMeshingOptions options = of_size(0.5);
  options.tets.size = 0.4;
  const TriangleMesh ball = make_sphere(1, 2);
  options.solve.threads = 1;
  const Hexahedra one = make_hexahedra(ball, options);
  options.solve.threads = 4;
  const Hexahedra four = make_hexahedra(ball, options);
  EXPECT_EQ(one.mesh.vertices, four.mesh.vertices);
  EXPECT_EQ(one.mesh.hexahedra, four.mesh.hexahedra);
}

TEST_F(HexMeshing, NamesTheFileThatIsNoModel) {
  try {
    make_hexahedra(std::filesystem::path("none.stl"));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_EQ(error.file(), "none.stl");
  }
}

TEST_F(HexMeshing, RefusesSharesThatAreNone) {
  for (const std::vector<double>& shares : {std::vector<double>{}, {1, 0}, {-1}, {NAN}}) {
    HexMeshingOptions options;
    options.tet_shares = shares;
    try {
      make_hexahedra(make_box({1, 1, 1}), options);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    }
  }
}

TEST_F(HexMeshingOfTets, FillsThemAndMakesNoOthers) {
  const Hexahedra made = make_hexahedra(TetDomain(TetBox{{4, 3, 3}}.mesh()), of_size(0.5));
  EXPECT_EQ(made.mesh.hexahedra.size(), 8u * 6 * 6);
  EXPECT_TRUE(made.report.tried_tets.empty());
  EXPECT_GT(made.field.report().seconds.total, 0);
}

TEST_F(HexMeshingOfTets, OfAFileAreThoseOfTheMesh) {
  const TetMesh mesh = TetBox{{2, 2, 3}}.mesh();
  const auto file = std::filesystem::path(testing::TempDir()) / "hex_meshing_box.mesh";
  write_tets(mesh, file);
  const Hexahedra of_file = make_hexahedra(file, of_size(0.5));
  const Hexahedra of_mesh = make_hexahedra(TetDomain(mesh), of_size(0.5));
  EXPECT_EQ(of_file.mesh.vertices, of_mesh.mesh.vertices);
  EXPECT_EQ(of_file.mesh.hexahedra, of_mesh.mesh.hexahedra);
  EXPECT_TRUE(of_file.report.tried_tets.empty());
  std::filesystem::remove(file);
}

TEST_F(HexMeshingOfTets, PreparesOnlyThoseThatAreNot) {
  const TetDomain tets(TetBox{{2, 2, 3}}.mesh());
  const Hexahedra given = make_hexahedra(tets, of_size(1));
  const Hexahedra prepared = make_hexahedra(tets.prepared_for_map(), of_size(1));
  EXPECT_EQ(given.mesh.vertices, prepared.mesh.vertices);
  EXPECT_TRUE(given.field.domain().preparation());
}

TEST_F(HexMeshingOfTets, RefusesConstraints) {
  HexMeshingOptions options;
  options.solve.constraints.points.push_back({{1, 1, 1}, {{1, 0, 0}}});
  EXPECT_EQ(kind_of_failure(TetDomain(TetBox{{2, 2, 2}}.mesh()), options), ErrorKind::kUsage);
}

TEST_F(HexMeshingOfTets, RefusesWrongOptionsBeforeAnyWork) {
  bool has_begun = false;
  const Monitor monitor([&](const Progress&) { has_begun = true; });
  HexMeshingOptions options;
  options.hexahedra.cells = 0;
  EXPECT_EQ(kind_of_failure(TetDomain(TetBox{{2, 2, 2}}.mesh()), options, monitor), ErrorKind::kUsage);
  EXPECT_FALSE(has_begun);
}

TEST_F(HexMeshingOfTets, EndsWhenTheMonitorIsStopped) {
  Monitor monitor;
  monitor.allow_stops();
  monitor.stop();
  EXPECT_EQ(kind_of_failure(TetDomain(TetBox{{2, 2, 2}}.mesh()), of_size(1), monitor),
            ErrorKind::kInterrupted);
}

}  // namespace
}  // namespace crossgrain
