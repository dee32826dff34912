// SPDX-License-Identifier: Apache-2.0
// The files of a field on a tet mesh, and the numbers of its report against a script that shares no code with
// them.
#include "results/onto_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/solve.hpp"
#include "files/temporary_folder.hpp"
#include "measure/made_tets.hpp"
#include "results/axes_behind_faces.hpp"
#include "results/sample_field.hpp"
#include "sampling/orthonormal_frame.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

struct Sample {
  explicit Sample(std::array<std::uint32_t, 3> cells, double spread_rad = 0.5)
      : solid(solid_of(tet_box(cells, 0.2))) {
    onto.vertex_frames = scattered_frames(solid.mesh.vertices.size(), spread_rad);
    onto.tet_frames = tet_frames_of(solid.mesh, onto.vertex_frames);
  }

  void write(const std::filesystem::path& folder, const Monitor& monitor = {}) const {
    write_field_onto(field_of(sample_data(Degree::kFour)), sample_report(), {solid, onto, {}}, folder,
                     monitor);
  }

  TetSolid solid;
  TetField onto;
};

std::vector<double> numbers_in(const std::filesystem::path& path) {
  std::istringstream text(content_of(path));
  return {std::istream_iterator<double>(text), {}};
}

TEST(OntoFrames, HasTheAxesOfEachVertexToTheBit) {
  const TemporaryFolder folder;
  const Sample sample({11, 11, 11});  // 1728 vertices: more than one task takes
  sample.write(folder.path());
  const std::string text = content_of(folder.path() / "onto.frames");
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), 12u * 12 * 12);
  std::vector<double> expected;
  for (const Quaternion& frame : sample.onto.vertex_frames) {
    for (const Vector3& axis : orthonormal_frame(frame).axes)
      expected.insert(expected.end(), axis.begin(), axis.end());
  }
  EXPECT_TRUE(numbers_in(folder.path() / "onto.frames") == expected);
}

TEST(OntoFrames, WritesNumbersAsSampleDoes) {
  const TemporaryFolder folder;
  Sample sample({1, 1, 1});
  sample.onto.vertex_frames[0] = {};
  sample.onto.vertex_frames[1] = from_rotation_vector({0, 0, 1e-9});
  sample.write(folder.path());
  std::istringstream text(content_of(folder.path() / "onto.frames"));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "1 0 0 0 1 0 0 0 1");
  std::getline(text, line);
  const auto axes = orthonormal_frame(sample.onto.vertex_frames[1]).axes;
  EXPECT_EQ(line, fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}",
                              axes[0][0], axes[0][1], axes[0][2], axes[1][0], axes[1][1], axes[1][2],
                              axes[2][0], axes[2][1], axes[2][2]));
}

TEST(OntoGrid, HasTheTetsAndTheFramesOnVerticesAndTets) {
  const TemporaryFolder folder;
  const Sample sample({3, 2, 2});
  sample.write(folder.path());
  const VtuFile file(folder.path() / "onto.vtu");
  const TetMesh& mesh = sample.solid.mesh;
  ASSERT_EQ(file.points(), mesh.vertices.size());
  ASSERT_EQ(file.cells(), mesh.tets.size());
  EXPECT_EQ(file.read<std::uint8_t>(VtuSection::kCells, "types", 1), std::vector<std::uint8_t>(72, 10));
  const auto points = file.read<double>(VtuSection::kPoints, "Points", 3);
  const auto corners = file.read<std::int32_t>(VtuSection::kCells, "connectivity", 1);
  const auto ends = file.read<std::int32_t>(VtuSection::kCells, "offsets", 1);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) EXPECT_EQ(points[3 * v + 1], mesh.vertices[v][1]);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    EXPECT_EQ(ends[t], static_cast<std::int32_t>(4 * (t + 1)));
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_EQ(static_cast<std::uint32_t>(corners[4 * t + k]), mesh.tets[t][k]);
  }
  const auto at_points = file.read<float>(VtuSection::kPointData, "axis_w", 3);
  const auto in_cells = file.read<float>(VtuSection::kCellData, "axis_u", 3);
  EXPECT_EQ(at_points[3 * 7 + 2], static_cast<float>(axes_of(sample.onto.vertex_frames[7])[2][2]));
  EXPECT_EQ(in_cells[3 * 50 + 1], static_cast<float>(axes_of(sample.onto.tet_frames[50])[0][1]));
}

TEST(OntoFiles, GiveTheFieldOnTetsBack) {
  const TemporaryFolder folder;
  TetMesh mesh = tet_box({3, 2, 2}, 0.2);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) mesh.regions.push_back(t < 20 ? 4 : 9);
  const TetFrameField field = solve_onto(TetDomain(mesh));
  write_field(field, folder.path());
  const auto read = read_tet_field(folder.path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->domain().mesh().vertices, field.domain().mesh().vertices);
  EXPECT_EQ(read->domain().mesh().tets, field.domain().mesh().tets);
  EXPECT_EQ(read->domain().mesh().regions, field.domain().mesh().regions);
  EXPECT_EQ(read->report().onto->dirichlet, field.report().onto->dirichlet);
  EXPECT_EQ(read->grid().quaternions(), field.grid().quaternions());
  const auto expect_near = [](const std::vector<Frame>& a, const std::vector<Frame>& b, double distance) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_LT(norm(a[i].axes[axis] - b[i].axes[axis]), distance);
  };
  expect_near(read->vertex_frames(), field.vertex_frames(), 1e-12);
  // Newton steps end at 1e-8, and rounding decides from which of two equal vertices they start.
  expect_near(read->tet_frames(), field.tet_frames(), 1e-7);
}

/// A coarse ball: its field has arcs that touch the surface before the repair.
TetFrameField repaired_ball() {
  TetMesh mesh = tet_box({3, 3, 3});
  for (Vector3& v : mesh.vertices) {
    for (double& x : v) x = x / 1.5 - 1;
    const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (largest > 0) v = largest / norm(v) * v;
  }
  return repaired(solve_onto(TetDomain(mesh).prepared_for_map()));
}

TEST(OntoFiles, GiveARepairedFieldBackToTheBit) {
  const TemporaryFolder folder;
  const TetFrameField field = repaired_ball();
  ASSERT_GT(field.report().onto->repair.value().changed_faces, 0u);
  write_field(field, folder.path());
  const auto read = read_tet_field(folder.path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->tet_quaternions(), field.tet_quaternions());
  EXPECT_EQ(read->data().matchings, field.data().matchings);
  EXPECT_EQ(read->report().onto->repair->changed_faces, field.report().onto->repair->changed_faces);
  const SingularityGraph own = field.singularities(), other = read->singularities();
  ASSERT_EQ(own.arcs.size(), other.arcs.size());
  for (std::size_t k = 0; k < own.arcs.size(); ++k) {
    EXPECT_EQ(own.arcs[k].vertices, other.arcs[k].vertices);
    EXPECT_EQ(own.arcs[k].verdict, other.arcs[k].verdict);
  }
  const auto lines = read_onto_singularities(folder.path());
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->arcs.size(), own.arcs.size());
}

TEST(AxesBehindFaces, AreTheMatchingsFromEitherSide) {
  const TetFrameField field = repaired_ball();
  const TetSolid& solid = field.domain().data().solid;
  const auto axes = axes_behind_faces(solid, field.data().matchings);
  EXPECT_EQ(matchings_in(solid, axes), field.data().matchings);
  std::size_t zeros = 0;
  for (const AxesBehindFaces& all : axes)
    for (std::size_t k = 0; k < 12; k += 3) zeros += all[k] == 0 && all[k + 1] == 0 && all[k + 2] == 0;
  EXPECT_EQ(zeros, solid.boundary.size());
}

TEST(AxesBehindFaces, ThatAreChangedAnywhereAreNoMatchings) {
  const TetFrameField field = repaired_ball();
  const TetSolid& solid = field.domain().data().solid;
  const auto axes = axes_behind_faces(solid, field.data().matchings);
  for (std::size_t k = 0; k < 12 * axes.size(); k += 5) {
    for (const int other : {0, 1, -3, 4, -128}) {
      auto changed = axes;
      std::int8_t& entry = changed[k / 12][k % 12];
      if (entry == other) continue;
      entry = static_cast<std::int8_t>(other);
      EXPECT_FALSE(matchings_in(solid, changed)) << k << ' ' << other;
    }
  }
}

TEST(OntoFiles, OfAFolderWithoutTetsGiveNoField) {
  const TemporaryFolder folder;
  write_field(field_of(sample_data(Degree::kFour)), folder.path());
  EXPECT_FALSE(read_tet_field(folder.path()));
}

TEST(OntoFiles, ThatDoNotBelongTogetherAreRefused) {
  const TemporaryFolder folder;
  const TetFrameField field = solve_onto(TetDomain(tet_box({2, 2, 2}, 0.2)));
  write_field(field, folder.path());
  const std::string frames = content_of(folder.path() / "onto.frames");
  for (const std::string& damaged : {frames + "1 0 0 0 1 0 0 0 1\n", frames.substr(0, frames.size() / 2),
                                     "1 0 0 0 1 0 0 0 2\n" + frames.substr(frames.find('\n') + 1)}) {
    folder.write("onto.frames", damaged);
    EXPECT_THROW(read_tet_field(folder.path()), Error);
  }
}

TEST(OntoFiles, HaveTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Sample sample({11, 11, 11});
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    sample.write(folder.path() / std::to_string(threads));
  }
  for (const char* name : {"onto.frames", "onto.vtu"})
    EXPECT_TRUE(content_of(folder.path() / "1" / name) == content_of(folder.path() / "3" / name)) << name;
}

TEST(OntoFiles, AppearTogetherWithTheFieldOrNotAtAll) {
  const TemporaryFolder folder;
  const Sample sample({2, 2, 2});
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(sample.write(folder.path() / "out", monitor), Error);
  EXPECT_EQ(folder.names(), std::vector<std::string>{});
  std::filesystem::create_directories(folder.path() / "out" / "onto.vtu");
  EXPECT_THROW(sample.write(folder.path() / "out"), Error);
  EXPECT_THROW(check_onto_folder(folder.path() / "out"), Error);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out" / "field.vtu"));
  std::filesystem::remove(folder.path() / "out" / "onto.vtu");
  check_onto_folder(folder.path() / "out");
  sample.write(folder.path() / "out");
  for (const char* name : {"field.vtu", "report.json", "onto.frames", "onto.vtu"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / name)) << name;
}

TEST(OntoFiles, GoWhereAFieldWithoutTetsIsWritten) {
  const TemporaryFolder folder;
  Sample({2, 2, 2}).write(folder.path());
  const FrameField without = field_of(sample_data(Degree::kFour));
  Monitor cancelled;
  cancelled.cancel();
  const std::vector<std::string> before = folder.names();
  EXPECT_THROW(write_field(without, folder.path(), cancelled), Error);
  EXPECT_EQ(folder.names(), before);
  write_field(without, folder.path());
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"field.vtu", "report.json", "singularities.vtu"}));
}

// Against tools/evaluate.py of the folder that CROSSGRAIN_SHARED names.

std::filesystem::path evaluator() {
  const char* shared = std::getenv("CROSSGRAIN_SHARED");
  return std::filesystem::path(shared ? shared : CROSSGRAIN_DEFAULT_SHARED) / "tools" / "evaluate.py";
}

/// Writes a mesh as a Medit file.
std::filesystem::path write_medit(const TemporaryFolder& folder, const TetMesh& mesh) {
  std::string text = "MeshVersionFormatted 2\nDimension 3\n";
  text += fmt::format("Vertices\n{}\n", mesh.vertices.size());
  for (const auto& [x, y, z] : mesh.vertices) text += fmt::format("{:.17g} {:.17g} {:.17g} 0\n", x, y, z);
  text += fmt::format("Tetrahedra\n{}\n", mesh.tets.size());
  for (const auto& [a, b, c, d] : mesh.tets)
    text += fmt::format("{} {} {} {} 0\n", a + 1, b + 1, c + 1, d + 1);
  return folder.write("mesh.mesh", text + "End\n");
}

nlohmann::json script_says(const std::filesystem::path& mesh, const std::filesystem::path& frames) {
  const std::string command =
      fmt::format("/usr/bin/python3 '{}' '{}' '{}'", evaluator().string(), mesh.string(), frames.string());
  FILE* pipe = ::popen(command.c_str(), "r");
  std::string text;
  for (int c; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  EXPECT_EQ(::pclose(pipe), 0);
  return nlohmann::json::parse(text, nullptr, false);
}

void expect_angles(const nlohmann::json& script, const SolveReport::AngleSummary& own) {
  EXPECT_NEAR(script.at("mean").get<double>(), own.mean.value(), 1e-6);
  EXPECT_NEAR(script.at("p95").get<double>(), own.p95.value(), 1e-6);
  EXPECT_NEAR(script.at("max").get<double>(), own.max.value(), 1e-6);
}

class AgainstTheScript : public testing::TestWithParam<double> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(evaluator())) GTEST_SKIP() << evaluator() << " is not there";
  }
};
INSTANTIATE_TEST_SUITE_P(SpreadRad, AgainstTheScript, testing::Values(0.1, 0.4, 3.0));

TEST_P(AgainstTheScript, AFieldOnVerticesIsEvaluatedEqually) {
  const TemporaryFolder folder;
  const Sample sample({5, 4, 6}, GetParam());
  sample.write(folder.path());
  const auto script = script_says(write_medit(folder, sample.solid.mesh), folder.path() / "onto.frames");
  ASSERT_TRUE(script.is_object());
  const auto own = evaluate(sample.solid, sample.onto.vertex_frames);
  EXPECT_NEAR(own.dirichlet / script.at("dirichlet").get<double>(), 1, 1e-10);
  EXPECT_NEAR(own.edge_sum / script.at("edge_sum").get<double>(), 1, 1e-10);
  EXPECT_EQ(own.singular.interior_faces, script.at("singular").at("interior_faces").get<std::size_t>());
  EXPECT_EQ(own.singular.boundary_faces, script.at("singular").at("boundary_faces").get<std::size_t>());
  expect_angles(script.at("normal_deg"), own.normal_deg);
  expect_angles(script.at("crease_deg"), own.crease_deg);
}

TEST_P(AgainstTheScript, AFieldOnTetsIsEvaluatedEqually) {
  const TemporaryFolder folder;
  const Sample sample({5, 4, 6}, GetParam());
  std::string frames;
  for (const Quaternion& frame : sample.onto.tet_frames) {
    for (const Vector3& axis : axes_of(frame))
      frames += fmt::format("{:.17g} {:.17g} {:.17g} ", axis[0], axis[1], axis[2]);
    frames.back() = '\n';
  }
  const auto script = script_says(write_medit(folder, sample.solid.mesh), folder.write("tet.frames", frames));
  ASSERT_TRUE(script.is_object());
  const auto own = evaluate_cell_field(sample.solid, sample.onto.tet_frames);
  EXPECT_NEAR(own.dirichlet / script.at("dirichlet").get<double>(), 1, 1e-10);
  expect_angles(script.at("normal_deg"), own.normal_deg);
}

}  // namespace
}  // namespace crossgrain
