// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/thread_limit.hpp"
#include "crossgrain/writing.hpp"
#include "files/temporary_folder.hpp"
#include "results/sample_field.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

/// A helix of `count` points, far from the origin.
Streamline helix(std::size_t count, std::size_t seed_point, std::size_t number) {
  Streamline line;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    line.points.push_back({1e5 + std::cos(t), std::sin(t), 0.1 * t + static_cast<double>(number)});
    line.tangents.push_back(normalised(Vector3{-std::sin(t), std::cos(t), 0.1}));
    if (i > 0) line.length += norm(line.points[i] - line.points[i - 1]);
  }
  line.seed = 10 * number;
  line.axis = static_cast<int>(number % 3);
  line.seed_point = seed_point;
  line.first_end = static_cast<StreamlineEnd>(number % 5);
  line.last_end = static_cast<StreamlineEnd>((number + 1) % 5);
  return line;
}

/// Returns lines of two points and of so many that arrays take several blocks.
std::vector<Streamline> made_lines() {
  std::vector<Streamline> lines;
  for (std::size_t k = 0; k < 40; ++k) lines.push_back(helix(2 + 137 * k, k, k));
  return lines;
}

TEST(StreamlineFile, HasTheLinesPointsAndWhatIsKnownOfThem) {
  const TemporaryFolder folder;
  const auto lines = made_lines();
  const auto path = folder.path() / "lines.vtu";
  write_streamlines(lines, path);
  const VtuFile file(path);
  ASSERT_EQ(file.cells(), lines.size());
  const auto points = file.read<double>(VtuSection::kPoints, "Points", 3);
  const auto tangents = file.read<float>(VtuSection::kPointData, "tangent", 3);
  const auto distances = file.read<float>(VtuSection::kPointData, "distance", 1);
  const auto connectivity = file.read<std::int32_t>(VtuSection::kCells, "connectivity", 1);
  const auto offsets = file.read<std::int32_t>(VtuSection::kCells, "offsets", 1);
  const auto types = file.read<std::uint8_t>(VtuSection::kCells, "types", 1);
  const auto seeds = file.read<std::uint32_t>(VtuSection::kCellData, "seed", 1);
  const auto axes = file.read<std::uint8_t>(VtuSection::kCellData, "axis", 1);
  const auto lengths = file.read<float>(VtuSection::kCellData, "length", 1);
  const auto first_ends = file.read<std::uint8_t>(VtuSection::kCellData, "first_end", 1);
  const auto last_ends = file.read<std::uint8_t>(VtuSection::kCellData, "last_end", 1);
  std::size_t row = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Streamline& line = lines[k];
    EXPECT_EQ(types[k], 4);
    EXPECT_EQ(seeds[k], line.seed);
    EXPECT_EQ(axes[k], line.axis);
    EXPECT_EQ(lengths[k], static_cast<float>(line.length));
    EXPECT_EQ(first_ends[k], k % 5);
    EXPECT_EQ(last_ends[k], (k + 1) % 5);
    ASSERT_EQ(static_cast<std::size_t>(offsets[k]), row + line.points.size());
    for (std::size_t i = 0; i < line.points.size(); ++i, ++row) {
      ASSERT_EQ(static_cast<std::size_t>(connectivity[row]), row);
      for (std::size_t a = 0; a < 3; ++a) {
        ASSERT_EQ(points[3 * row + a], line.points[i][a]);
        ASSERT_EQ(tangents[3 * row + a], static_cast<float>(line.tangents[i][a]));
      }
      // Steps of the helix are all of one length.
      const double from_seed = static_cast<double>(i) - static_cast<double>(line.seed_point);
      ASSERT_NEAR(distances[row], from_seed * line.length / static_cast<double>(line.points.size() - 1),
                  1e-6 * line.length);
    }
  }
  EXPECT_EQ(row, file.points());
}

TEST(StreamlineFile, HasAsObjThePointsAndTheLinesByTheirNumbers) {
  const TemporaryFolder folder;
  const std::vector<Streamline> lines{helix(3, 1, 0), helix(2, 0, 1)};
  write_streamlines(lines, folder.path() / "lines.OBJ");
  std::istringstream text(content_of(folder.path() / "lines.OBJ"));
  std::vector<Vector3> points;
  std::vector<std::string> numbers;
  for (std::string row; std::getline(text, row);) {
    std::istringstream words(row.substr(1));
    if (row[0] == 'v') {
      Vector3& point = points.emplace_back();
      for (double& x : point) words >> x;
    } else if (row[0] == 'l') {
      numbers.push_back(row);
    } else {
      EXPECT_EQ(row[0], '#');
    }
  }
  std::vector<Vector3> expected = lines[0].points;
  expected.insert(expected.end(), lines[1].points.begin(), lines[1].points.end());
  EXPECT_EQ(points, expected);
  EXPECT_EQ(numbers, (std::vector<std::string>{"l 1 2 3", "l 4 5"}));
}

TEST(StreamlineFile, IsWrittenAsWhatItsNameSaysOrNotAtAll) {
  const TemporaryFolder folder;
  write_streamlines(made_lines(), folder.path() / "lines.vtp");
  EXPECT_NE(content_of(folder.path() / "lines.vtp").find("<VTKFile type=\"PolyData\""), std::string::npos);
  for (const char* name : {"lines.csv", "lines.vtk", "lines"}) {
    try {
      check_streamline_file(folder.path() / name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
      EXPECT_NE(std::string(error.what()).find("let it end in .vtu, .vtp or .obj"), std::string::npos);
    }
    EXPECT_THROW(write_streamlines(made_lines(), folder.path() / name), Error);
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"lines.vtp"});
}

TEST(StreamlineFile, IsNotWrittenOfLinesThatContradictThemselves) {
  const TemporaryFolder folder;
  Streamline few_tangents = helix(5, 2, 0), seed_elsewhere = helix(5, 2, 1);
  few_tangents.tangents.pop_back();
  seed_elsewhere.seed_point = 5;
  for (const Streamline& line : {few_tangents, seed_elsewhere})
    EXPECT_THROW(write_streamlines(std::vector{line}, folder.path() / "lines.vtu"), Error);
  EXPECT_TRUE(folder.names().empty());
}

TEST(StreamlineFile, GivesThePointsAndAxesOfItsLinesBack) {
  const TemporaryFolder folder;
  const auto lines = made_lines();
  write_streamlines(lines, folder.path() / "lines.vtu");
  const auto read = read_streamlines(folder.path() / "lines.vtu");
  ASSERT_EQ(read.size(), lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    EXPECT_EQ(read[k].points, lines[k].points);
    EXPECT_EQ(read[k].axis, lines[k].axis);
  }
  write_field(field_of(sample_data(Degree::kFour, 0)), folder.path());
  EXPECT_THROW(read_streamlines(folder.path() / "field.vtu"), Error);
}

TEST(StreamlineFile, IsReadByAnIndependentReaderAlsoWithoutAnyLine) {
  const TemporaryFolder folder;
  if (std::system("/usr/bin/python3 -c pass") != 0) GTEST_SKIP() << "no /usr/bin/python3";
  for (const auto& lines : {made_lines(), std::vector<Streamline>{}}) {
    const auto path = folder.path() / "lines.vtu";
    write_streamlines(lines, path);
    const std::string command = fmt::format("/usr/bin/python3 {}/vtu/check_vtu.py {} > /dev/null",
                                            CROSSGRAIN_TESTS_FOLDER, path.string());
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
}

TEST(StreamlineFile, HasTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const auto written = [&](int threads) {
    const ThreadLimit limit(threads);
    write_streamlines(made_lines(), folder.path() / "lines.vtu");
    return content_of(folder.path() / "lines.vtu");
  };
  EXPECT_TRUE(written(1) == written(4));
}

TEST(StreamlineFile, IsNotTouchedByAWriteThatIsCancelled) {
  const TemporaryFolder folder;
  const auto path = folder.write("lines.vtu", "earlier");
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(write_streamlines(made_lines(), path, monitor), Error);
  EXPECT_EQ(content_of(path), "earlier");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"lines.vtu"});
}

TEST(StreamlineFile, IsRefusedWhereItCannotBe) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const auto& path : {folder.path(), folder.path() / "none" / "lines.vtu", pipe}) {
    for (const auto& act : {+[](const std::filesystem::path& p) { check_streamline_file(p); },
                            +[](const std::filesystem::path& p) { write_streamlines(made_lines(), p); }}) {
      try {
        act(path);
        ADD_FAILURE() << path;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kOutput);
        EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
      }
    }
  }
  check_streamline_file(folder.path() / "lines.vtu");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"pipe"});
}

TEST(StreamlineFile, OfAnEarlierFieldGoesWhenANewOneIsWrittenToItsFolder) {
  const TemporaryFolder folder;
  const FrameField field = field_of(sample_data(Degree::kFour));
  write_field(field, folder.path());
  write_streamlines(made_lines(), folder.path() / kStreamlinesFile);
  write_field(field, folder.path());
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"field.vtu", "report.json", "singularities.vtu"}));
}

}  // namespace
}  // namespace crossgrain
