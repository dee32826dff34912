// SPDX-License-Identifier: Apache-2.0
// Writer and reader of VTU files, and what a reader that shares no code with them makes of the files.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "files/temporary_folder.hpp"
#include "vtu/vtu_reader.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

template <class T>
VtuArray array_of(VtuSection section, const std::string& name, std::size_t components,
                  const std::vector<T>& values) {
  return vtu_array<T>(section, name, components, values.size() / components,
                      [&values, components](std::size_t begin, std::size_t end, T* out) {
                        std::copy(values.data() + begin * components, values.data() + end * components, out);
                      });
}

/// Cells on their own, of eight points each, with data that shrink well and data that do not.
struct Sample {
  explicit Sample(std::size_t cells) : cell_count(cells) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (std::size_t i = 0; i < 24 * cells; ++i) points.push_back(static_cast<float>(uniform(random)));
    for (std::size_t i = 0; i < 3 * cells; ++i) axis.push_back(uniform(random));
    for (std::size_t i = 0; i < cells; ++i) {
      level.push_back(static_cast<std::uint8_t>(i / 100 % 7));
      number.push_back(static_cast<std::int32_t>(i) - 5);
      key.push_back(i * 0x9E3779B97F4A7C15u);
      label.push_back(static_cast<std::uint32_t>(random()));
      types.push_back(11);
      offsets.push_back(static_cast<std::int64_t>(8 * (i + 1)));
    }
    connectivity.resize(8 * cells);
    std::iota(connectivity.begin(), connectivity.end(), 0);
  }

  std::vector<VtuArray> arrays() const {
    return {array_of(VtuSection::kCellData, "axis", 3, axis),
            array_of(VtuSection::kCellData, "level", 1, level),
            array_of(VtuSection::kPoints, "Points", 3, points),
            array_of(VtuSection::kCells, "connectivity", 1, connectivity),
            array_of(VtuSection::kCells, "offsets", 1, offsets),
            array_of(VtuSection::kCells, "types", 1, types),
            array_of(VtuSection::kCellData, "a <\"name\"> & more", 1, number),
            array_of(VtuSection::kPointData, "weight", 3, points),
            array_of(VtuSection::kFieldData, "keys", 1, key),
            array_of(VtuSection::kFieldData, "labels", 1, label),
            array_of(VtuSection::kFieldData, "nothing", 2, empty)};
  }

  std::filesystem::path write(const TemporaryFolder& folder, const std::string& name = "a.vtu") const {
    OutputFile file(folder.path() / name);
    write_vtu(file, 8 * cell_count, cell_count, arrays());
    file.commit();
    return folder.path() / name;
  }

  std::size_t cell_count;
  std::vector<float> points, empty;
  std::vector<double> axis;
  std::vector<std::uint8_t> level, types;
  std::vector<std::int32_t> number;
  std::vector<std::uint64_t> key;
  std::vector<std::uint32_t> label;
  std::vector<std::int64_t> connectivity, offsets;
};

/// Twenty thousand cells make several blocks of most arrays, the last one shorter.
constexpr std::size_t kSeveralBlocks = 20'000;

TEST(VtuFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  for (const std::size_t cells : {std::size_t{0}, std::size_t{1}, kSeveralBlocks}) {
    const Sample sample(cells);
    const VtuFile file(sample.write(folder));
    EXPECT_EQ(file.points(), 8 * cells);
    EXPECT_EQ(file.cells(), cells);
    EXPECT_EQ(file.arrays().size(), 11u);
    EXPECT_EQ(file.read<double>(VtuSection::kCellData, "axis", 3), sample.axis);
    EXPECT_EQ(file.read<std::uint8_t>(VtuSection::kCellData, "level", 1), sample.level);
    EXPECT_EQ(file.read<std::int32_t>(VtuSection::kCellData, "a <\"name\"> & more", 1), sample.number);
    EXPECT_EQ(file.read<float>(VtuSection::kPoints, "Points", 3), sample.points);
    EXPECT_EQ(file.read<std::int64_t>(VtuSection::kCells, "connectivity", 1), sample.connectivity);
    EXPECT_EQ(file.read<std::uint64_t>(VtuSection::kFieldData, "keys", 1), sample.key);
    EXPECT_EQ(file.read<std::uint32_t>(VtuSection::kFieldData, "labels", 1), sample.label);
    EXPECT_TRUE(file.read<float>(VtuSection::kFieldData, "nothing", 2).empty());
  }
}

TEST(VtuFile, IsReadByAnIndependentReader) {
  const TemporaryFolder folder;
  const Sample sample(kSeveralBlocks);
  const auto path = sample.write(folder);
  if (std::system("/usr/bin/python3 -c pass") != 0) GTEST_SKIP() << "no /usr/bin/python3";
  const auto output = folder.path() / "arrays.txt";
  const std::string command = fmt::format("/usr/bin/python3 {}/vtu/check_vtu.py {} > {}",
                                          CROSSGRAIN_TESTS_FOLDER, path.string(), output.string());
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string listing = content_of(output);
  const auto expect_line = [&](const std::string& begin, const auto& values) {
    const auto crc = crc32(0, reinterpret_cast<const unsigned char*>(values.data()),
                           static_cast<unsigned>(values.size() * sizeof values[0]));
    const std::string line = fmt::format("{} {} {:08x}\n", begin, values.size(), crc);
    EXPECT_NE(listing.find(line), std::string::npos) << "'" << line << "' is not in\n" << listing;
  };
  expect_line("CellData axis Float64 3", sample.axis);
  expect_line("CellData level UInt8 1", sample.level);
  expect_line("CellData a <\"name\"> & more Int32 1", sample.number);
  expect_line("PointData weight Float32 3", sample.points);
  expect_line("Points Points Float32 3", sample.points);
  expect_line("Cells connectivity Int64 1", sample.connectivity);
  expect_line("Cells offsets Int64 1", sample.offsets);
  expect_line("Cells types UInt8 1", sample.types);
  expect_line("FieldData keys UInt64 1", sample.key);
  expect_line("FieldData labels UInt32 1", sample.label);
  EXPECT_NE(listing.find("FieldData nothing Float32 2 0 00000000\n"), std::string::npos) << listing;
}

TEST(VtuFile, HasTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Sample sample(kSeveralBlocks);
  std::string one, many;
  {
    const ThreadLimit limit(1);
    one = content_of(sample.write(folder, "one.vtu"));
  }
  {
    const ThreadLimit limit(4);
    many = content_of(sample.write(folder, "many.vtu"));
  }
  EXPECT_TRUE(one == many);
}

TEST(VtuFile, PassesOnWhatAProducerThrows) {
  const TemporaryFolder folder;
  {
    OutputFile file(folder.path() / "a.vtu");
    const std::vector<VtuArray> arrays = {vtu_array<float>(
        VtuSection::kCellData, "a", 1, 10,
        [](std::size_t, std::size_t, float*) { throw Error(ErrorKind::kInterrupted, "interrupted"); })};
    EXPECT_THROW(write_vtu(file, 0, 10, arrays), Error);
  }
  EXPECT_TRUE(folder.names().empty());
}

/// The Error(kInput) of reading all arrays of a damaged sample; empty where it went well.
std::string error_of_reading(const std::filesystem::path& path) {
  try {
    const VtuFile file(path);
    file.read<double>(VtuSection::kCellData, "axis", 3);
    file.read<std::uint8_t>(VtuSection::kCellData, "level", 1);
    file.read<float>(VtuSection::kPoints, "Points", 3);
    file.read<std::uint64_t>(VtuSection::kFieldData, "keys", 1);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
    return error.what();
  }
  return "";
}

TEST(VtuFile, RefusesEveryFileCutShortWithinItsArrays) {
  const TemporaryFolder folder;
  const std::string content = content_of(Sample(30).write(folder));
  const std::size_t data_end = content.rfind("\n  </AppendedData>");
  ASSERT_EQ(error_of_reading(folder.write("b.vtu", content)), "");
  // "nothing", an empty array, takes the last 24 bytes; "labels" before it is not read here.
  const std::size_t keys_end = data_end - 300;
  for (std::size_t length = 0; length < keys_end; length += 7)
    EXPECT_NE(error_of_reading(folder.write("b.vtu", content.substr(0, length))), "") << length;
}

TEST(VtuFile, HasItsTagOfDataWhereEveryVtkFindsIt) {
  const TemporaryFolder folder;
  for (const int size : {0, 1, 30}) {
    const std::string content = content_of(Sample(size).write(folder));
    constexpr std::string_view kName = "<AppendedData";
    const std::size_t behind = content.find(kName) + kName.size();
    EXPECT_EQ(behind % 4096, 0u);
    const std::size_t attributes = content.find('>', behind) - behind;
    EXPECT_GE(attributes, 25u);
    EXPECT_LE(attributes, 37u);
    EXPECT_EQ(content.substr(behind + attributes - 2, 4), "w\">\n") << "what meshio looks for";
  }
}

TEST(VtuFile, SurvivesDamage) {
  const TemporaryFolder folder;
  const std::string content = content_of(Sample(30).write(folder));
  std::mt19937 random(8);
  for (int trial = 0; trial < 1000; ++trial) {
    std::string damaged = content;
    for (int flips = 0; flips < 3; ++flips) damaged[random() % damaged.size()] = static_cast<char>(random());
    error_of_reading(folder.write("b.vtu", damaged));
  }
}

TEST(VtuFile, RefusesBlocksThatHoldLessThanTheyClaim) {
  const TemporaryFolder folder;
  std::string content = content_of(Sample(30).write(folder));
  const std::size_t offset = content.find("offset=\"", content.find("Name=\"keys\"")) + 8;
  const std::size_t begin = content.find('_', content.find("<AppendedData")) + 1;
  // There: blocks, bytes of a block, bytes of a shorter last one.
  const std::size_t array = begin + std::stoul(content.substr(offset));
  ASSERT_EQ(content[array], 1);
  // One block of 30 numbers, now of 16 times as many, which zlib could have packed.
  for (const std::size_t at : {array + 8, array + 16}) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, content.data() + at, sizeof bytes);
    bytes *= 16;
    std::memcpy(content.data() + at, &bytes, sizeof bytes);
  }
  const std::string message = error_of_reading(folder.write("b.vtu", content));
  EXPECT_NE(message.find("'keys' is damaged or cut short"), std::string::npos) << message;
}

TEST(VtuFile, RefusesForeignFiles) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of_reading(folder.path() / "none.vtu"), "");
  EXPECT_NE(error_of_reading(folder.path()), "");
  EXPECT_NE(error_of_reading(folder.write("b.vtu", "")), "");
  EXPECT_NE(error_of_reading(folder.write("b.vtu", "no XML at all")), "");
  const std::string content = content_of(Sample(3).write(folder));
  for (const char* needed :
       {"UnstructuredGrid\"", "LittleEndian", "header_type=\"UInt64\"", "vtkZLibDataCompressor",
        "encoding=\"raw\"", "NumberOfCells=\"3\"", "Name=\"axis\"", "type=\"Float64\""}) {
    std::string foreign = content;
    foreign[foreign.find(needed) + 2] = '?';
    EXPECT_NE(error_of_reading(folder.write("b.vtu", foreign)), "") << needed;
  }
}

TEST(VtuFile, SaysWhichArrayIsMissingOrOfAnotherKind) {
  const TemporaryFolder folder;
  const VtuFile file(Sample(3).write(folder));
  const auto message_of = [&](const auto& read) -> std::string {
    try {
      read();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message_of([&] { file.read<double>(VtuSection::kCellData, "none", 3); }).find("no array 'none'"),
            std::string::npos);
  EXPECT_NE(message_of([&] { file.read<float>(VtuSection::kCellData, "axis", 3); }).find("3 x Float64"),
            std::string::npos);
  EXPECT_EQ(file.find(VtuSection::kPointData, "axis"), nullptr);
}

}  // namespace
}  // namespace crossgrain
