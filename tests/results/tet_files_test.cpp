// SPDX-License-Identifier: Apache-2.0
// Every format of fields on tets against a reader written from its description, and which files a folder has.
#include "results/tet_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/result_folder.hpp"
#include "files/temporary_folder.hpp"
#include "measure/made_tets.hpp"
#include "mesh_files/made_map.hpp"
#include "results/frame_file_rows.hpp"
#include "results/onto_files.hpp"
#include "results/sample_field.hpp"
#include "sampling/orthonormal_frame.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

using frame_files::Row;

struct Sample {
  explicit Sample(std::array<std::uint32_t, 3> cells) : Sample(tet_box(cells, 0.2)) {}
  explicit Sample(TetMesh mesh) : solid(solid_of(std::move(mesh))) {
    onto.vertex_frames = scattered_frames(solid.mesh.vertices.size(), 0.5);
    onto.tet_frames = tet_frames_of(solid.mesh, onto.vertex_frames);
  }

  SolveReport write(const std::filesystem::path& folder, std::vector<std::string> formats,
                    const Monitor& monitor = {}, ForeignFiles foreign = ForeignFiles::kRefuse) const {
    OutputOptions options;
    options.formats = std::move(formats);
    options.foreign_files = foreign;
    return write_field_onto(field_of(sample_data(Degree::kFour)), sample_report(),
                            {solid, onto, {}, 1, has_map ? &map : nullptr}, folder, monitor, options);
  }

  /// The rows of onto.fra and of onto.frame.
  std::array<std::vector<Row>, 2> rows_for_hexahedra(double hex_size) const {
    const TemporaryFolder folder;
    OutputOptions options;
    options.formats = {"fra", "frame"};
    options.hex_size = hex_size;
    write_field_onto(field_of(sample_data(Degree::kFour)), sample_report(), {solid, onto, {}, hex_size},
                     folder.path(), {}, options);
    return {frame_files::read_fra(folder.path() / "onto.fra"),
            frame_files::read_frame(folder.path() / "onto.frame")};
  }

  TetSolid solid;
  TetField onto;
  HexMap map = made_map(solid.mesh);
  bool has_map = true;
};

std::vector<std::string> every_format() {
  std::vector<std::string> names;
  for (const OutputFormat& format : output_formats()) names.push_back(format.name);
  return names;
}

Row row_of(const Quaternion& q) {
  Row row;
  for (const Vector3& axis : orthonormal_frame(q).axes) row.insert(row.end(), axis.begin(), axis.end());
  return row;
}

std::vector<Row> rows_of(const std::vector<Quaternion>& frames) {
  std::vector<Row> rows;
  for (const Quaternion& q : frames) rows.push_back(row_of(q));
  return rows;
}

std::vector<Row> quaternion_rows(const std::vector<Quaternion>& frames) {
  std::vector<Row> rows;
  for (const Quaternion& q : frames) rows.push_back({q.w, q.x, q.y, q.z});
  return rows;
}

/// More tets and vertices than one task makes text of.
class WrittenFormats : public ::testing::Test {
 protected:
  void SetUp() override { sample_.write(folder_.path(), every_format()); }

  const Sample sample_{{11, 11, 11}};
  const TemporaryFolder folder_;
};

TEST_F(WrittenFormats, FraHasTheAxesOfEachTetToTheBit) {
  EXPECT_TRUE(frame_files::read_fra(folder_.path() / "onto.fra") == rows_of(sample_.onto.tet_frames));
}

TEST_F(WrittenFormats, FrameHasTheAxesOfEachTetToTheBit) {
  EXPECT_TRUE(frame_files::read_frame(folder_.path() / "onto.frame") == rows_of(sample_.onto.tet_frames));
}

TEST_F(WrittenFormats, MeshHasTheTetsOfTheRowsToTheBit) {
  const frame_files::MeditFile file = frame_files::read_medit(folder_.path() / "onto.mesh");
  ASSERT_EQ(file.vertices.size(), sample_.solid.mesh.vertices.size());
  for (std::size_t v = 0; v < file.vertices.size(); ++v) {
    const Vector3& p = sample_.solid.mesh.vertices[v];
    ASSERT_EQ(file.vertices[v], (Row{p[0], p[1], p[2], 0}));
  }
  ASSERT_EQ(file.tets.size(), frame_files::read_fra(folder_.path() / "onto.fra").size());
  for (std::size_t t = 0; t < file.tets.size(); ++t) {
    const auto& [a, b, c, d] = sample_.solid.mesh.tets[t];
    ASSERT_EQ(file.tets[t], (Row{a + 1.0, b + 1.0, c + 1.0, d + 1.0, 0}));
  }
}

TEST(FramesForHexahedra, OfASizeHaveAxesOfItsInverseInFra) {
  const Sample sample({2, 2, 2});
  const std::vector<Row> unit = rows_of(sample.onto.tet_frames);
  EXPECT_EQ(sample.rows_for_hexahedra(1)[0], unit);
  for (const double size : {0.3, 0.25, 7.0}) {
    const std::vector<Row> rows = sample.rows_for_hexahedra(size)[0];
    ASSERT_EQ(rows.size(), unit.size());
    for (std::size_t t = 0; t < rows.size(); ++t)
      for (std::size_t k = 0; k < 9; ++k) ASSERT_EQ(rows[t][k], unit[t][k] / size);
  }
}

TEST(FramesForHexahedra, StayUnitInFrame) {
  const Sample sample({2, 2, 2});
  EXPECT_EQ(sample.rows_for_hexahedra(0.3)[1], rows_of(sample.onto.tet_frames));
}

TEST(FramesForHexahedra, OfNoSizeAreRefused) {
  for (const double size : {0.0, -1.0, double(NAN), double(INFINITY)}) {
    try {
      Sample({1, 1, 1}).rows_for_hexahedra(size);
      FAIL() << size;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    }
  }
}

TEST(WrittenMesh, HasTheRegionsOfTets) {
  const TemporaryFolder folder;
  Sample(with_regions(tet_box({2, 1, 1}), [](const Vector3& p) {
    return p[0] < 1 ? -4 : 70000;
  })).write(folder.path(), {"mesh"});
  const TetMesh mesh = read_tets(folder.path() / "onto.mesh");
  EXPECT_EQ(std::ranges::count(mesh.regions, -4), 6);
  EXPECT_EQ(std::ranges::count(mesh.regions, 70000), 6);
}

TEST_F(WrittenFormats, QuaternionsAreThoseOfVerticesAndTetsToTheBit) {
  EXPECT_TRUE(frame_files::read_quaternions(folder_.path() / "onto_vertices.quaternions") ==
              quaternion_rows(sample_.onto.vertex_frames));
  EXPECT_TRUE(frame_files::read_quaternions(folder_.path() / "onto_tets.quaternions") ==
              quaternion_rows(sample_.onto.tet_frames));
}

TEST_F(WrittenFormats, QuaternionsTurnTheCoordinateAxesIntoThoseOfFra) {
  const auto quaternions = frame_files::read_quaternions(folder_.path() / "onto_tets.quaternions");
  const auto axes = frame_files::read_fra(folder_.path() / "onto.fra");
  for (std::size_t t = 0; t < axes.size(); ++t) {
    const double w = quaternions[t][0], x = quaternions[t][1], y = quaternions[t][2], z = quaternions[t][3];
    EXPECT_NEAR(w * w + x * x + y * y + z * z, 1, 1e-14);
    // The matrix of the rotation v -> q v q*, column by column.
    const Row columns{1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
                      2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                      2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
    for (std::size_t k = 0; k < 9; ++k) ASSERT_NEAR(axes[t][k], columns[k], 1e-14);
  }
}

TEST_F(WrittenFormats, HaveTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder other;
  const ThreadLimit limit(1);
  sample_.write(other.path(), every_format());
  for (const TetFile& file : tet_files())
    EXPECT_TRUE(content_of(folder_.path() / file.name) == content_of(other.path() / file.name)) << file.name;
}

TEST(FeatureGrid, HasTheTaggedEdgesAndTrianglesWithTheirTags) {
  TetMesh mesh = tet_box({2, 2, 2});
  mesh.feature_edges = {{{0, 1}, 70000, true}, {{4, 13}, -3, false}};
  mesh.feature_faces = {{{0, 1, 4}, 5}};
  const TemporaryFolder folder;
  Sample(mesh).write(folder.path(), {"features"});
  const VtuFile file(folder.path() / "onto_features.vtu");
  EXPECT_EQ(file.points(), mesh.vertices.size());
  ASSERT_EQ(file.cells(), 3u);
  EXPECT_EQ(file.read<std::uint8_t>(VtuSection::kCells, "types", 1), (std::vector<std::uint8_t>{3, 3, 5}));
  EXPECT_EQ(file.read<std::int64_t>(VtuSection::kCells, "offsets", 1), (std::vector<std::int64_t>{2, 4, 7}));
  EXPECT_EQ(file.read<std::int64_t>(VtuSection::kCells, "connectivity", 1),
            (std::vector<std::int64_t>{0, 1, 4, 13, 0, 1, 4}));
  EXPECT_EQ(file.read<std::int32_t>(VtuSection::kCellData, "tag", 1),
            (std::vector<std::int32_t>{70000, -3, 5}));
  EXPECT_EQ(file.read<std::uint8_t>(VtuSection::kCellData, "is_stated", 1),
            (std::vector<std::uint8_t>{1, 0, 1}));
  const auto points = file.read<double>(VtuSection::kPoints, "Points", 3);
  EXPECT_EQ(points[3 * 13 + 2], mesh.vertices[13][2]);
}

TEST(FeatureGrid, IsEmptyWhereNothingIsTagged) {
  const TemporaryFolder folder;
  Sample({1, 1, 1}).write(folder.path(), {"features"});
  const VtuFile file(folder.path() / "onto_features.vtu");
  EXPECT_EQ(file.points(), 8u);
  EXPECT_EQ(file.cells(), 0u);
  EXPECT_TRUE(file.read<std::int32_t>(VtuSection::kCellData, "tag", 1).empty());
}

TEST(TetGrid, KeepsTheNumberOfASingleRegion) {
  const TemporaryFolder folder;
  Sample(with_regions(tet_box({1, 1, 1}), [](const Vector3&) { return 7; })).write(folder.path(), {});
  EXPECT_EQ(VtuFile(folder.path() / "onto.vtu").read<std::int32_t>(VtuSection::kCellData, "region", 1),
            std::vector<std::int32_t>(6, 7));
}

TEST(FormatsOfAFolder, AreThoseAskedForAndNoneOfAnotherSolve) {
  const TemporaryFolder folder;
  const Sample sample({2, 2, 2});
  sample.write(folder.path(), every_format());
  EXPECT_EQ(folder.names().size(), 3 + tet_files().size());
  folder.write("onto.notes", "mine");
  sample.write(folder.path(), {"perm", "fra", "perm", "vtu"}, {}, ForeignFiles::kKeep);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"field.vtu", "onto.fra", "onto.frames", "onto.notes",
                                                      "onto.perm", "onto.vtu", "onto_singularities.vtu",
                                                      "report.json", "singularities.vtu"}));
  OutputOptions options;
  options.foreign_files = ForeignFiles::kKeep;
  write_field(field_of(sample_data(Degree::kFour)), folder.path(), {}, options);
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"field.vtu", "onto.notes", "report.json", "singularities.vtu"}));
}

TEST(FormatsOfAFolder, AppearTogetherOrNotAtAll) {
  const TemporaryFolder folder;
  const Sample sample({2, 2, 2});
  std::filesystem::create_directories(folder.path() / "out" / "onto.perm");
  OutputOptions options;
  options.foreign_files = ForeignFiles::kReplace;
  EXPECT_NO_THROW(check_onto_folder(folder.path() / "out", options));
  options.formats = {"perm"};
  EXPECT_THROW(check_onto_folder(folder.path() / "out", options), Error);
  EXPECT_THROW(sample.write(folder.path() / "out", {"fra", "perm"}, {}, ForeignFiles::kReplace), Error);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out" / "onto.fra"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out" / "field.vtu"));
}

TEST(FormatsOfAFolder, StopWhereTheMonitorIsCancelled) {
  const TemporaryFolder folder;
  const Sample sample({2, 2, 2});
  const SingularityGraph lines;
  Monitor monitor;
  monitor.cancel();
  for (const TetFile& file : tet_files()) {
    OutputFile output(folder.path() / file.name);
    // A box has no features, and no block of them to look between.
    if (std::string(file.format) == "features") continue;
    EXPECT_THROW(file.write(output, {sample.solid, sample.onto, lines, 1, &sample.map}, monitor), Error)
        << file.name;
  }
}

TEST(FormatsOfAFolder, ThatAreNoneAreRefusedWithTheNamesOfAll) {
  const TemporaryFolder folder;
  try {
    Sample({1, 1, 1}).write(folder.path() / "out", {"fra", "ovm"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_NE(std::string(error.what()).find("'ovm'"), std::string::npos);
    for (const std::string& name : every_format())
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(FormatsOfAFolder, OfMapsAreRefusedForFieldsWithoutOne) {
  const TemporaryFolder folder;
  Sample sample({1, 1, 1});
  sample.has_map = false;
  for (const char* format : {"hexex", "map"}) {
    try {
      sample.write(folder.path() / "out", {format});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
      EXPECT_NE(std::string(error.what()).find(format), std::string::npos);
    }
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(FormatsOfAFolder, AreRefusedForFieldsWithoutTets) {
  const TemporaryFolder folder;
  OutputOptions options;
  options.formats = {"fra"};
  try {
    write_field(field_of(sample_data(Degree::kFour)), folder.path() / "out", {}, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(LeftOutTets, AreWarnedOfWhereRowsCountTheOthers) {
  TetMesh mesh = tet_box({2, 2, 2});
  mesh.tets.insert(mesh.tets.begin() + 7, {0, 1, 3, 4});  // a square of the boundary
  const Sample sample(mesh);
  ASSERT_EQ(sample.solid.left_out_tets, 1u);
  const TemporaryFolder folder;
  EXPECT_EQ(sample.write(folder.path(), {}).warnings, sample_report().warnings);
  EXPECT_EQ(sample.write(folder.path(), {"features"}).warnings, sample_report().warnings);
  const Warning warning = sample.write(folder.path(), {"fra", "quaternions"}).warnings.back();
  EXPECT_EQ(warning,
            Warning(WarningKind::kLeftOutTets,
                    "tets left out: 1 of 49; onto.fra, onto_tets.quaternions number the other 48, as "
                    "onto.vtu does",
                    Remedy::kUseWrittenMesh));
  EXPECT_EQ(read_field(folder.path()).report().warnings.back(), warning);
  EXPECT_EQ(frame_files::read_fra(folder.path() / "onto.fra").size(), 48u);
}

}  // namespace
}  // namespace crossgrain
