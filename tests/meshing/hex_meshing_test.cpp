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
#include "crossgrain/reading.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/tet_making.hpp"
#include "crossgrain/writing.hpp"
#include "meshing/hexahedra_of_models.hpp"
#include "support/nightly.hpp"
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
  options.hexahedra.preference = HexPreference::kMapOnly;  // other tests tell of lattices
  return options;
}

/// Fails to make tets from the call `failing` on, counted from 0.
Hexahedra tuned_hexahedra(const TriangleMesh& model, const HexMeshingOptions& options,
                          const MeshingTuning& tuning, int failing = 1000, const Monitor& heard = {}) {
  int calls = 0;
  const auto make = [&](const TetMakingTuning& making, const Monitor& monitor) {
    if (calls++ == failing) throw Error(ErrorKind::kLimit, "too many tets");
    return make_tets(model, making, monitor);
  };
  return hexahedra_in_tets_of(make, options, tuning, heard);
}

/// Hexahedra of a pyramid, at whose tip four faces meet and so no hexahedra; with a single repair each.
Hexahedra partial_pyramid(std::vector<double> shares, const MeshingTuning& given = MeshingTuning(),
                          int failing = 1000, const Monitor& monitor = {},
                          const std::function<void(const HexAttemptEnd&)>& on_end = {}) {
  MeshingTuning tuning = given;
  tuning.hexahedra.repair.tries = {{}};
  tuning.hexahedra.repair.finalists = 0;
  tuning.hexahedra.more_tries = {};
  tuning.hexahedra.smaller_sizes = 0;
  tuning.hexahedra.largest_gap = 1e-9;  // so that nothing counts as filled
  tuning.tet_shares = std::move(shares);
  HexMeshingOptions options = of_size(0.5);
  options.tets.size = 0.3;
  options.on_attempt_end = on_end;
  TriangleMesh pyramid;
  pyramid.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}};
  pyramid.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return tuned_hexahedra(pyramid, options, tuning, failing, monitor);
}

/// The attempts at tets.
std::vector<HexAttempt> tets_of(const Hexahedra& made) {
  std::vector<HexAttempt> tets;
  for (const HexAttempt& attempt : made.report().attempts)
    if (attempt.kind == "tets") tets.push_back(attempt);
  return tets;
}

std::size_t used_round(const Hexahedra& made) {
  return made.report().attempts[made.report().best_attempt].round;
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

/// Of a box of four by two by three, made once.
const Hexahedra& hexahedra_of_box() {
  static const Hexahedra made = make_hexahedra(make_box({4, 2, 3}), of_size(1));
  return made;
}

TEST_F(HexMeshing, OfASurfaceFillsIt) {
  const Hexahedra& made = hexahedra_of_box();
  EXPECT_EQ(made.report().outcome, HexOutcome::kAllHex);
  EXPECT_EQ(made.mesh.hexahedra.size(), 24u);
  EXPECT_NEAR(made.report().volume, 24, 1e-9);
}

TEST_F(HexMeshing, TellsTheTetsItMade) {
  const Hexahedra& made = hexahedra_of_box();
  ASSERT_EQ(tets_of(made).size(), 1u);
  const HexAttempt tets = tets_of(made).front();
  EXPECT_NEAR(tets.tet_size, 1.4 * 4.0 / 20, 1e-9);  // 20 edges of 1.4
  EXPECT_EQ(tets.tets, made.field.domain().mesh().tets.size());
  EXPECT_GT(tets.tet_seconds, 0);
  EXPECT_GT(tets.seconds, tets.tet_seconds);
  EXPECT_EQ(made.field.report().seconds.read, tets.tet_seconds);
  EXPECT_EQ(made.field.report().hexahedra->attempts.size(), made.report().attempts.size());
}

TEST_F(HexMeshing, TellsTheAttemptThatMadeTheMesh) {
  const Hexahedra& made = hexahedra_of_box();
  const HexAttempt& best = made.report().attempts[made.report().best_attempt];
  EXPECT_EQ(best.kind, "repair");
  EXPECT_EQ(best.outcome, HexOutcome::kAllHex);
  EXPECT_EQ(best.hexahedra, 24u);
  EXPECT_GT(best.work, 0);
}

TEST_F(HexMeshing, TriesAllSizesOfTetsWhereNoneIsFilledAndKeepsTheBest) {
  const Hexahedra made = partial_pyramid({1, 1.4, 2});
  ASSERT_NE(made.report().outcome, HexOutcome::kAllHex);
  const std::vector<HexAttempt> tets = tets_of(made);
  ASSERT_EQ(tets.size(), 3u);
  const std::vector<double> sizes{0.3, 0.42, 0.6};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(tets[k].tet_size, sizes[k], 1e-9);
    EXPECT_EQ(used_round(made) == k, tets[k].tets == made.field.domain().mesh().tets.size());
  }
  EXPECT_GT(tets[0].tets, tets[1].tets);
  EXPECT_GT(tets[1].tets, tets[2].tets);
}

TEST_F(HexMeshing, TriesNoMoreSizesThanItMay) {
  MeshingTuning tuning;
  tuning.most_sizes = 2;
  EXPECT_EQ(tets_of(partial_pyramid({1, 1.4, 2}, tuning)).size(), 2u);
}

TEST_F(HexMeshing, TriesNoFurtherTetsOnceTheWorkIsDone) {
  MeshingTuning tuning;
  tuning.hexahedra.most_work = 1;
  const Hexahedra made = partial_pyramid({1, 1.4, 2}, tuning);
  EXPECT_EQ(tets_of(made).size(), 1u);
  EXPECT_GT(made.mesh.hexahedra.size(), 0u);
}

TEST_F(HexMeshing, TakesTheSizeThatIsGivenAndNoOtherWithManyTets) {
  MeshingTuning tuning;
  tuning.large_tets = 1;
  const std::vector<HexAttempt> tets = tets_of(partial_pyramid({1, 2, 1.4}, tuning));
  ASSERT_EQ(tets.size(), 1u);
  EXPECT_NEAR(tets.front().tet_size, 0.3, 1e-9);
}

/// What is expected before the work in a box of four by two by three, of which the first tets are 0.28.
HexExpectation expected_of_box(std::size_t large_tets) {
  MeshingTuning tuning;
  tuning.tet_shares = {1, 2, 4};
  tuning.large_tets = large_tets;
  HexMeshingOptions options = of_size(1);
  std::vector<HexExpectation> heard;
  options.on_expected = [&](const HexExpectation& expected) { heard.push_back(expected); };
  tuned_hexahedra(make_box({4, 2, 3}), options, tuning);
  EXPECT_EQ(heard.size(), 1u);
  return heard.front();
}

TEST_F(HexMeshing, TellsBeforeTheWorkThatTheFirstSizeHasTooManyTets) {
  const HexExpectation expected = expected_of_box(500);
  EXPECT_NEAR(expected.tet_size.used, 4 * 0.28, 1e-9);
  EXPECT_NEAR(expected.tet_size.dropped, 0.28, 1e-9);
  EXPECT_GT(expected.tet_size.dropped_tets, 500u);
  EXPECT_LE(expected.tets, 500u);
}

TEST_F(HexMeshing, TakesTheCoarsestTetsHoweverManyThatAre) {
  const std::size_t of_coarse = expected_of_box(500).tets;
  EXPECT_NEAR(expected_of_box(of_coarse - 1).tet_size.used, 4 * 0.28, 1e-9);
}

TEST_F(HexMeshing, WarnsBeforeManyTetsThatAreAskedForAreMade) {
  HexMeshingOptions options = of_size(1);
  options.tets.size = 0.05;
  std::vector<Warning> heard;
  options.on_warning = [&](const Warning& warning) { heard.push_back(warning); };
  const auto make = [&](const TetMakingTuning& making, const Monitor&) -> TetMesh {
    making.on_solid(SearchableSurface(prepare_surface(CheckedMesh::derived(make_box({4, 2, 3})))));
    throw Error(ErrorKind::kInterrupted, "enough");
  };
  EXPECT_THROW(hexahedra_in_tets_of(make, options, {}, {}), Error);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard.front().kind, WarningKind::kManyTets);
  EXPECT_TRUE(heard.front().text.starts_with("about 1.6e+06 tets of 0.05 are made, as asked for"));
  EXPECT_EQ(heard.front().remedy, Remedy::kTakeLargerTets);
}

TEST_F(HexMeshing, MakesNoTetsOfASizeBetweenTwoThatMakeTheSame) {
  const TetMesh fine = make_tets(make_box({4, 2, 3}), TetMakingOptions{.size = 1});
  MeshingTuning tuning;
  tuning.tet_shares = {1, 4, 3, 2};
  tuning.hexahedra.least_quality = 1.5;  // more than any hexahedron has, so that the search goes on
  std::vector<double> sizes;
  std::vector<HexAttemptEnd> ends;
  HexMeshingOptions options = of_size(1);
  options.tets.size = 1;
  options.on_attempt_end = [&](const HexAttemptEnd& end) { ends.push_back(end); };
  const auto make = [&](const TetMakingTuning& making, const Monitor&) {
    sizes.push_back(making.size);
    return fine;
  };
  const Hexahedra made = hexahedra_in_tets_of(make, options, tuning, {});
  EXPECT_EQ(sizes, (std::vector<double>{1, 4}));
  for (const HexAttemptEnd& end : ends) EXPECT_EQ(end.next.find("tets of 3"), std::string::npos) << end.next;
  EXPECT_EQ(made.report().remedy, Remedy::kUseHexSize)
      << "sizes of tets are tried, not advised one after the other";
}

TEST_F(HexMeshing, GoesOnAfterPoorHexahedraAndKeepsThem) {
  MeshingTuning tuning;
  tuning.tet_shares = {1, 2};
  tuning.hexahedra.least_quality = 1.5;  // more than any hexahedron has
  const Hexahedra made = tuned_hexahedra(make_box({4, 2, 3}), of_size(1), tuning);
  EXPECT_EQ(tets_of(made).size(), 2u);
  EXPECT_EQ(made.report().outcome, HexOutcome::kAllHex);
  EXPECT_EQ(made.mesh.hexahedra.size(), 24u);
}

TEST_F(HexMeshing, KeepsWhatItHasWhereLaterTetsFail) {
  const Hexahedra made = partial_pyramid({1, 2}, MeshingTuning(), /*failing=*/1);
  EXPECT_EQ(used_round(made), 0u);
  const HexAttempt& last = made.report().attempts.back();
  EXPECT_EQ(last.kind, "tets");
  EXPECT_EQ(last.failure, "too many tets");
}

TEST_F(HexMeshing, ProgressTellsAttemptAndBestSoFar) {
  std::vector<Progress> heard;
  const Monitor monitor([&](const Progress& progress) { heard.push_back(progress); });
  make_hexahedra(make_box({4, 2, 3}), of_size(1), monitor);
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard.front().attempt, 1u);
  EXPECT_EQ(heard.back().attempt, 1u);
  EXPECT_EQ(heard.front().tets, 1u);
  for (const Progress& progress : heard) EXPECT_EQ(progress.most_tets, MeshingTuning().most_sizes);
  EXPECT_EQ(heard.back().phase, Phase::kSmooth);
  EXPECT_GT(heard.back().share, 0);
}

TEST_F(HexMeshing, TellsWhyEachAttemptEndedAndWhichTetsAreTriedNext) {
  std::vector<HexAttemptEnd> ends;
  partial_pyramid({1, 2}, MeshingTuning(), 1000, {}, [&](const HexAttemptEnd& end) { ends.push_back(end); });
  ASSERT_GE(ends.size(), 2u);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    EXPECT_EQ(ends[k].attempt, k + 1);
    EXPECT_LE(ends[k].tets, ends[k].most_tets);
    EXPECT_LE(ends[k].most_tets, ends[k == 0 ? 0 : k - 1].most_tets)
        << "how many there are at most only falls";
    EXPECT_NE(ends[k].outcome, HexOutcome::kAllHex);
    EXPECT_FALSE(ends[k].text.empty());
  }
  EXPECT_EQ(
      std::count_if(ends.begin(), ends.end(), [](const auto& end) { return end.next == "tets of 0.6"; }), 1);
  EXPECT_EQ(ends.back().next, "");
  EXPECT_NE(ends.back().over, "");
}

TEST_F(HexMeshing, AnnouncesNoTetsThatAreTooMany) {
  MeshingTuning tuning;
  tuning.large_tets = 2000;
  std::vector<HexAttemptEnd> ends;
  const Hexahedra made =
      partial_pyramid({2, 0.25}, tuning, 1000, {}, [&](const HexAttemptEnd& end) { ends.push_back(end); });
  EXPECT_EQ(tets_of(made).size(), 1u);
  ASSERT_FALSE(ends.empty());
  for (const HexAttemptEnd& end : ends) EXPECT_FALSE(end.next.starts_with("tets")) << end.next;
  EXPECT_EQ(ends.back().over, "nothing else is left to try");
}

TEST_F(HexMeshing, GivesTheBestMeshSoFarWhenItIsStopped) {
  Monitor* heard = nullptr;
  Monitor monitor([&](const Progress& progress) {
    if (progress.hexahedra > 0) heard->stop();
  });
  heard = &monitor;
  monitor.allow_stops();
  const Hexahedra made = partial_pyramid({1, 1.4, 2}, MeshingTuning(), 1000, monitor);
  EXPECT_TRUE(made.report().is_stopped);
  EXPECT_EQ(made.report().remedy, Remedy::kLetFinish);
  EXPECT_TRUE(sentence_of(made.report()).starts_with("partial, the search was stopped: "));
  EXPECT_GT(made.mesh.hexahedra.size(), 0u);
  EXPECT_TRUE(made.mesh.is_partial);
  EXPECT_EQ(used_round(made), 0u);
}

TEST_F(HexMeshing, ExpectsOneLayerOfHexahedraInAPlateThatIsThinnerThanOne) {
  HexMeshingOptions options = of_size(1);
  std::vector<HexExpectation> expected;
  options.on_expected = [&](const HexExpectation& it) { expected.push_back(it); };
  const Hexahedra made = make_hexahedra(make_box({8, 8, 0.2}), options);
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_NEAR(expected.front().hexahedra, 64, 16);
  EXPECT_EQ(made.report().expected, expected.front().hexahedra);
  EXPECT_NEAR(static_cast<double>(made.mesh.hexahedra.size()), 64, 16);
}

TEST_F(HexMeshing, IsTheSameForAnyNumberOfThreads) {
  HexMeshingOptions options = of_size(0.5);
  options.tets.size = is_nightly() ? 0.5 : 0.8;
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

TEST_F(HexMeshingOfTets, FillsThemAndMakesNoOthers) {
  const Hexahedra made = make_hexahedra(TetDomain(TetBox{{4, 3, 3}}.mesh()), of_size(0.5));
  EXPECT_EQ(made.mesh.hexahedra.size(), 8u * 6 * 6);
  EXPECT_TRUE(tets_of(made).empty());
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
  EXPECT_TRUE(tets_of(of_file).empty());
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
