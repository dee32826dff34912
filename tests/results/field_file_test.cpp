// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "field/field_data.hpp"
#include "files/temporary_folder.hpp"
#include "results/onto_files.hpp"
#include "results/sample_field.hpp"
#include "tets/tet_meshes.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

class FieldFileOfDegree : public testing::TestWithParam<Degree> {};
INSTANTIATE_TEST_SUITE_P(Degrees, FieldFileOfDegree, testing::Values(Degree::kThree, Degree::kFour));

TEST_P(FieldFileOfDegree, GivesTheFieldBackToTheBit) {
  const TemporaryFolder folder;
  const FieldData data = sample_data(GetParam());
  write_field(field_of(data), folder.path() / "made" / "for it");
  const FrameField read = read_field(folder.path() / "made" / "for it");
  EXPECT_EQ(read.data().degree, data.degree);
  EXPECT_EQ(read.data().tree.root().origin, data.tree.root().origin);
  EXPECT_EQ(read.data().tree.root().size, data.tree.root().size);
  EXPECT_EQ(read.data().tree.leaves(), data.tree.leaves());
  EXPECT_TRUE(same_bits(read.data().frames, data.frames));
  EXPECT_EQ(read.data().open_faces, data.open_faces);
  EXPECT_EQ(read.data().on_boundary, data.on_boundary);
  EXPECT_TRUE(same_bits(read.data().energy_density, data.energy_density));
  EXPECT_TRUE(same_bits(read.data().alignment_deg, data.alignment_deg));
}

TEST_P(FieldFileOfDegree, HasTheCellDataThatTheInterfacePromises) {
  const TemporaryFolder folder;
  const FieldData data = sample_data(GetParam());
  write_field(field_of(data), folder.path());
  const VtuFile file(folder.path() / "field.vtu");
  EXPECT_EQ(file.cells(), data.tree.size());
  std::set<std::string> names;
  for (const auto& array : file.arrays()) {
    if (array.section == VtuSection::kCellData) names.insert(array.name);
  }
  EXPECT_EQ(names, (std::set<std::string>{"axis_u", "axis_v", "axis_w", "coefficients", "deviation",
                                          "energy_density", "alignment_deg", "level", "is_boundary"}));
  const std::size_t coefficients = 2 * static_cast<std::size_t>(GetParam()) + 1;
  EXPECT_EQ(file.read<float>(VtuSection::kCellData, "coefficients", coefficients).size(),
            coefficients * data.tree.size());
  EXPECT_EQ(file.read<float>(VtuSection::kCellData, "axis_v", 3).size(), 3 * data.tree.size());
}

TEST(FieldFile, KeepsTheRegionsOfCellsWhereThereAreAny) {
  const TemporaryFolder folder;
  FieldData data = sample_data(Degree::kFour);
  write_field(field_of(data), folder.path());
  EXPECT_TRUE(read_field(folder.path()).data().regions.empty());
  for (std::size_t i = 0; i < data.tree.size(); ++i) data.regions.push_back(i % 3 == 0 ? -7 : 100000);
  write_field(field_of(data), folder.path());
  EXPECT_EQ(read_field(folder.path()).data().regions, data.regions);
}

TEST(FieldFile, KeepsTheConstraintsOfCellsWhereThereAreAny) {
  const TemporaryFolder folder;
  FieldData data = sample_data(Degree::kFour);
  write_field(field_of(data), folder.path());
  EXPECT_TRUE(read_field(folder.path()).data().constraints.empty());
  for (std::size_t i = 0; i < data.tree.size(); ++i)
    data.constraints.push_back(static_cast<CellConstraint>(i % kCellConstraintCount));
  write_field(field_of(data), folder.path());
  EXPECT_EQ(read_field(folder.path()).data().constraints, data.constraints);
}

TEST(FieldFile, HasEveryCellAsAHexahedronOfSharedPoints) {
  const TemporaryFolder folder;
  const FieldData data = sample_data(Degree::kFour);
  write_field(field_of(data), folder.path());
  const VtuFile file(folder.path() / "field.vtu");
  const auto points = file.read<double>(VtuSection::kPoints, "Points", 3);
  const auto connectivity = file.read<std::int32_t>(VtuSection::kCells, "connectivity", 1);
  // 5 corners along each side of 4 cells, and those of the cell that is split in two each way.
  EXPECT_EQ(file.points(), 5u * 5 * 5 + 27 - 8);
  ASSERT_EQ(connectivity.size(), 8 * data.tree.size());
  for (CellIndex i = 0; i < data.tree.size(); ++i) {
    const Box box = data.tree.root().box(data.tree[i]);
    for (std::size_t corner = 0; corner < 8; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // Around the lower square, then around the upper one.
        const std::array is_high{corner % 4 == 1 || corner % 4 == 2, corner % 4 >= 2, corner >= 4};
        const double expected = is_high[axis] ? box.high[axis] : box.low[axis];
        EXPECT_EQ(points[3 * static_cast<std::size_t>(connectivity[8 * i + corner]) + axis], expected);
      }
    }
  }
}

TEST(FieldFile, HasTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const FrameField field = field_of(sample_data(Degree::kFour, 5));
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    write_field(field, folder.path() / std::to_string(threads));
  }
  EXPECT_TRUE(content_of(folder.path() / "1" / "field.vtu") == content_of(folder.path() / "3" / "field.vtu"));
}

TEST(ReportFile, GivesBackWhatItSaysOfSolids) {
  const TemporaryFolder folder;
  FieldData data = sample_data(Degree::kFour);
  data.report.regions = {{-3, 12, 0.1}, {4000000, 5, 1.0 / 3}};
  data.report.interfaces = SolveReport::Interfaces{1.5, 0.25, 0.5, 1.0 / 3};
  write_field(field_of(data), folder.path());
  const SolveReport report = read_field(folder.path()).report();
  ASSERT_EQ(report.regions.size(), 2u);
  EXPECT_EQ(report.regions[0].region, -3);
  EXPECT_EQ(report.regions[1].cells, 5u);
  EXPECT_EQ(report.regions[1].volume, 1.0 / 3);
  ASSERT_TRUE(report.interfaces);
  EXPECT_EQ(report.interfaces->area, 1.5);
  EXPECT_EQ(report.interfaces->max, 1.0 / 3);
}

TEST(ReportFile, GivesTheReportBack) {
  const TemporaryFolder folder;
  const SolveReport written = sample_report();
  write_field(field_of(sample_data(Degree::kThree)), folder.path());
  const SolveReport read = read_field(folder.path()).report();
  EXPECT_EQ(read.model.path, written.model.path);
  EXPECT_EQ(read.model.bounding_box.high, written.model.bounding_box.high);
  EXPECT_TRUE(read.model.watertight);
  EXPECT_EQ(read.model.unit, written.model.unit);
  EXPECT_EQ(read.model.file_unit, written.model.file_unit);
  EXPECT_EQ(read.resolution, written.resolution);
  ASSERT_EQ(read.levels.size(), 2u);
  EXPECT_EQ(read.levels[1].energy, written.levels[1].energy);
  EXPECT_EQ(read.energy.deviation_max, written.energy.deviation_max);
  EXPECT_EQ(read.alignment_deg.excluded_share, written.alignment_deg.excluded_share);
  EXPECT_EQ(read.spectrum.conflicted, written.spectrum.conflicted);
  EXPECT_EQ(read.singularity.boundary_ends, written.singularity.boundary_ends);
  EXPECT_EQ(read.walls.tied_cells, written.walls.tied_cells);
  EXPECT_EQ(read.warnings, written.warnings);
  ASSERT_TRUE(read.expected && read.limited);
  EXPECT_EQ(read.expected->depth, written.expected->depth);
  EXPECT_EQ(read.expected->active_cells, written.expected->active_cells);
  EXPECT_EQ(read.expected->seconds, written.expected->seconds);
  EXPECT_EQ(read.limited->memory_needed_bytes, written.limited->memory_needed_bytes);
  ASSERT_TRUE(read.unfinished);
  EXPECT_EQ(read.unfinished->resolution_requested, written.unfinished->resolution_requested);
  EXPECT_EQ(read.unfinished->levels_missing, written.unfinished->levels_missing);
  EXPECT_TRUE(read.unfinished->tets_missing);
}

TEST(ReportFile, HasNullAndAWarningWhereANumberIsNotFinite) {
  const TemporaryFolder folder;
  SolveReport report = sample_report();
  report.energy.total = NAN;
  report.levels[1].energy = INFINITY;
  report.model.bounding_box.high[2] = -INFINITY;
  report.creases.knife_edge_places = {{1, NAN, 3}};
  report.creases.tangent_deg = {1, NAN, 3};
  const SolveReport written = write_field(field_of(sample_data(Degree::kFour)), report, folder.path());
  ASSERT_EQ(written.warnings.size(), report.warnings.size() + 1);
  EXPECT_EQ(written.warnings.back().kind, WarningKind::kNotFinite);
  EXPECT_EQ(written.warnings.back().text,
            "5 numbers of the report are not finite and null in report.json, the first is "
            "model.bounding_box.high[2]");

  const SolveReport read = read_field(folder.path()).report();
  EXPECT_EQ(read.warnings, written.warnings);
  EXPECT_TRUE(std::isnan(read.energy.total));
  EXPECT_EQ(read.energy.smoothness, report.energy.smoothness);
  EXPECT_TRUE(std::isnan(read.levels[1].energy));
  EXPECT_TRUE(std::isnan(read.model.bounding_box.high[2]));
  EXPECT_EQ(read.model.bounding_box.high[1], report.model.bounding_box.high[1]);
  ASSERT_EQ(read.creases.knife_edge_places.size(), 1u);
  EXPECT_TRUE(std::isnan(read.creases.knife_edge_places[0][1]));
  EXPECT_EQ(read.creases.knife_edge_places[0][2], 3);
  EXPECT_FALSE(read.creases.tangent_deg.p95);
  EXPECT_EQ(read.creases.tangent_deg.max, 3);
}

TEST(ReportFile, HasNoNullForAnythingButNumbers) {
  for (const char* member :
       {"\"degree\": 3", "\"watertight\": true", "\"cells\": 100", "\"type\": \"changing\""}) {
    const TemporaryFolder folder;
    write_field(field_of(sample_data(Degree::kFour)), sample_report(), folder.path());
    std::string text = content_of(folder.path() / "report.json");
    const std::size_t at = text.find(member);
    ASSERT_NE(at, std::string::npos) << member;
    const std::string key(member, std::string_view(member).find(": "));
    text.replace(at, std::strlen(member), key + ": null");
    folder.write("report.json", text);
    EXPECT_THROW(read_field(folder.path()), Error) << member;
  }
}

TEST(ReportFile, HasASectionOnTheTetMeshOnlyWhereThereIsOne) {
  const TemporaryFolder folder;
  SolveReport report = sample_report();
  write_field(field_of(sample_data(Degree::kFour)), report, folder.path());
  EXPECT_FALSE(read_field(folder.path()).report().onto);

  report.onto = SolveReport::Onto{.vertices = 1,
                                  .tets = 2,
                                  .boundary = TetBoundary::kSmoothOnly,
                                  .dirichlet = 0.1,
                                  .edge_sum = 1.0 / 3,
                                  .prepared = MapPreparation{10, 20, 30, 40, 50, 60},
                                  .singularity = report.singularity,
                                  .singular = {3, 4},
                                  .normal_deg = {},
                                  .crease_deg = {0.5, 1.5, 2.5},
                                  .feature_edge_deg = SolveReport::AngleSummary{0.1, 0.2, 0.3},
                                  .outside_vertices = 5,
                                  .unused_vertices = 6,
                                  .inverted_tets = 7,
                                  .left_out_tets = 8,
                                  .seconds = 0.7,
                                  .repair = SolveReport::Onto::Repair{}};
  report.onto->repair->moves = 11;
  report.onto->repair->faults = 12;
  report.onto->repair->bent_length = 0.25;
  report.onto->repair->turned_deg.max = 13.5;
  const TetSolid tet = solid_of(corner_tet());
  const TetField onto{std::vector<Quaternion>(4), {Quaternion{}}};
  write_field_onto(field_of(sample_data(Degree::kFour)), report, {tet, onto, {}}, folder.path());
  const SolveReport read = read_field(folder.path()).report();
  ASSERT_TRUE(read.onto);
  EXPECT_EQ(read.onto->tets, 2u);
  EXPECT_EQ(read.onto->boundary, TetBoundary::kSmoothOnly);
  EXPECT_EQ(read.onto->edge_sum, 1.0 / 3);
  ASSERT_TRUE(read.onto->prepared);
  EXPECT_EQ(read.onto->prepared->tets_before, 10u);
  EXPECT_EQ(read.onto->prepared->vertices_before, 20u);
  EXPECT_EQ(read.onto->prepared->split_edges, 30u);
  EXPECT_EQ(read.onto->prepared->split_faces, 40u);
  EXPECT_EQ(read.onto->prepared->split_tets, 50u);
  EXPECT_EQ(read.onto->prepared->refused_splits, 60u);
  EXPECT_EQ(read.onto->singular.boundary_faces, 4u);
  EXPECT_FALSE(read.onto->normal_deg.p95) << "null";
  EXPECT_EQ(read.onto->crease_deg.p95, 1.5);
  ASSERT_TRUE(read.onto->feature_edge_deg);
  EXPECT_EQ(read.onto->feature_edge_deg->max, 0.3);
  EXPECT_EQ(read.onto->left_out_tets, 8u);
  EXPECT_EQ(read.onto->seconds, 0.7);
  ASSERT_TRUE(read.onto->repair);
  EXPECT_EQ(read.onto->repair->moves, 11u);
  EXPECT_EQ(read.onto->repair->faults, 12u);
  EXPECT_EQ(read.onto->repair->bent_length, 0.25);
  EXPECT_EQ(read.onto->repair->turned_deg.max, 13.5);

  // Written again without its tets, it has nothing to say of them.
  write_field(read_field(folder.path()), folder.path() / "again");
  EXPECT_FALSE(read_field(folder.path() / "again").report().onto);
}

TEST(ReportFile, CountsTheTimeOfWritingAndTheMemoryOfTheProcess) {
  const TemporaryFolder folder;
  SolveReport report = sample_report();
  write_field(field_of(sample_data(Degree::kFour)), report, folder.path());
  const SolveReport read = read_field(folder.path()).report();
  EXPECT_GT(read.seconds.write, 0);
  EXPECT_EQ(read.seconds.total, report.seconds.total + read.seconds.write);
  EXPECT_GT(read.peak_memory_bytes, std::size_t{1} << 20);
}

TEST(FieldFile, LeavesAnEarlierResultAsItWasWhereItIsInterrupted) {
  const TemporaryFolder folder;
  const FrameField field = field_of(sample_data(Degree::kFour));
  write_field(field, folder.path() / "field");
  const std::string before = content_of(folder.path() / "field" / "report.json");
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(write_field(field, folder.path() / "field", monitor), Error);
  EXPECT_THROW(write_field(field, folder.path() / "other", monitor), Error);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"field"});
  EXPECT_EQ(content_of(folder.path() / "field" / "report.json"), before);
}

/// Writes the arrays of a field that somebody has spoilt, and tells what reading them says.
std::string error_of_reading(const FieldData& data) {
  const TemporaryFolder folder;
  write_field(field_of(data), folder.path());
  try {
    read_field(folder.path());
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(error.what()).find("field.vtu: "), std::string::npos);
    return error.what();
  }
  return "";
}

TEST(FieldFile, WhoseArraysMakeNoFieldIsRefused) {
  const FieldData sound = sample_data(Degree::kFour);
  EXPECT_EQ(error_of_reading(sound), "");
  FieldData data = sound;
  data.frames[7].w += 0.5f;
  EXPECT_NE(error_of_reading(data), "") << "a quaternion not of unit norm";
  data = sound;
  data.frames[7].x = NAN;
  EXPECT_NE(error_of_reading(data), "") << "a quaternion that is no number";
  data = sound;
  data.open_faces[0] |= 1;
  EXPECT_NE(error_of_reading(data), "") << "a face open to nowhere";
  data = sound;
  data.open_faces[9] |= 64;
  EXPECT_NE(error_of_reading(data), "") << "a face that there is not";
  data = sound;
  std::vector<CellAddress> leaves = data.tree.leaves();
  std::swap(leaves[3], leaves[4]);
  data.tree = Octree(data.tree.root(), leaves);
  EXPECT_NE(error_of_reading(data), "") << "cells out of order";
  data = sound;
  data.tree = Octree({data.tree.root().origin, NAN}, data.tree.leaves());
  EXPECT_NE(error_of_reading(data), "") << "a root cube that is none";
  data = sound;
  data.tree = Octree({data.tree.root().origin, 1e-315}, data.tree.leaves());
  EXPECT_NE(error_of_reading(data), "") << "a root cube of which a cell has no size";
}

TEST(FieldFile, SurvivesDamage) {
  const TemporaryFolder folder;
  write_field(field_of(sample_data(Degree::kFour)), folder.path());
  for (const char* name : {"field.vtu", "report.json"}) {
    const std::string content = content_of(folder.path() / name);
    std::mt19937 random(9);
    for (int trial = 0; trial < 300; ++trial) {
      std::string damaged = content;
      for (int flips = 0; flips < 3; ++flips)
        damaged[random() % damaged.size()] = static_cast<char>(random());
      folder.write(name, damaged);
      try {
        read_field(folder.path());
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kInput);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
    folder.write(name, content);
  }
}

TEST(FieldFile, IsMissedByItsName) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_field(folder.path() / "none"), Error);
  write_field(field_of(sample_data(Degree::kFour)), folder.path());
  std::filesystem::remove(folder.path() / "report.json");
  try {
    read_field(folder.path());
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("report.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace crossgrain
