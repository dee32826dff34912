// SPDX-License-Identifier: Apache-2.0
#include "results/output_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "files/temporary_folder.hpp"
#include "grid/leaf_finder.hpp"
#include "harmonics/frame.hpp"
#include "results/field_arrays.hpp"
#include "results/sample_field.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Quaternion turned_about_z(double angle_rad) {
  return {std::cos(0.5 * angle_rad), 0, 0, std::sin(0.5 * angle_rad)};
}

Coefficients<4> coefficients_of(const StoredQuaternion& frame) {
  return frame_coefficients<4>(from_stored(frame));
}

/// Not the coefficients, which are the same for all names of the axes of a frame.
std::vector<std::array<std::uint32_t, 4>> bits_of(const std::vector<StoredQuaternion>& frames) {
  std::vector<std::array<std::uint32_t, 4>> bits;
  for (const StoredQuaternion& frame : frames)
    bits.push_back(std::bit_cast<std::array<std::uint32_t, 4>>(frame));
  return bits;
}

double volume_of(const Octree& tree) {
  double volume = 0;
  for (CellIndex i = 0; i < tree.size(); ++i) volume += std::pow(tree.cell_size(i) / tree.root().size, 3);
  return volume;
}

Box meeting_box(const Octree& tree, const Vector3& low, const Vector3& high) {
  const RootCube& root = tree.root();
  return {root.origin + root.size * low, root.origin + root.size * high};
}

class OutputCellsAtLevel : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Levels, OutputCellsAtLevel, testing::Values(0, 1, 2, 3, 4, 19));

TEST_P(OutputCellsAtLevel, AreNoDeeperAndFillTheSameVolume) {
  const FieldData part = output_cells(sample_data(Degree::kFour, 3), {.level = GetParam(), .clip = {}});
  for (const CellAddress cell : part.tree.leaves()) EXPECT_LE(cell.depth(), GetParam());
  EXPECT_EQ(volume_of(part.tree), 1);
  if (GetParam() <= 3) {
    EXPECT_EQ(part.tree.size(), std::size_t{1} << 3 * GetParam());
  }
}

TEST_P(OutputCellsAtLevel, OfAConstantFieldHaveItsFrame) {
  FieldData data = sample_data(Degree::kFour, 3);
  const Quaternion frame = normalised(Quaternion{0.9, 0.3, -0.2, 0.25});
  for (std::size_t i = 0; i < data.frames.size(); ++i) {
    // Named differently from cell to cell.
    data.frames[i] = to_stored(frame * turned_about_z(std::numbers::pi / 2 * static_cast<double>(i % 4)));
  }
  for (const StoredQuaternion& merged : output_cells(data, {.level = GetParam(), .clip = {}}).frames) {
    const Coefficients<4> off = difference(coefficients_of(merged), frame_coefficients<4>(frame));
    EXPECT_LT(std::sqrt(squared_norm(off)), 1e-5) << "single precision";
  }
}

TEST_P(OutputCellsAtLevel, MakeAFieldThatReadsBackToTheBit) {
  const TemporaryFolder folder;
  const FieldData data = sample_data(Degree::kThree, 3);
  const OutputOptions options{.level = GetParam(),
                              .clip = meeting_box(data.tree, {0.3, -1, 0.1}, {0.6, 2, 0.4})};
  write_field(field_of(data), folder.path(), {}, options);
  const FieldData expected = output_cells(data, options);
  const FieldData read = read_field_arrays({folder.path() / "field.vtu"});
  EXPECT_EQ(read.tree.leaves(), expected.tree.leaves());
  EXPECT_EQ(read.open_faces, expected.open_faces);
  EXPECT_EQ(read.on_boundary, expected.on_boundary);
  EXPECT_EQ(read.energy_density, expected.energy_density);
  EXPECT_EQ(read.alignment_deg, expected.alignment_deg);
  EXPECT_EQ(bits_of(read.frames), bits_of(expected.frames));
}

TEST(OutputCells, AreAskedForWhereSomeAreMergedOrLeftOut) {
  const Octree tree = sample_tree(2);
  const Box whole = meeting_box(tree, {-0.1, -0.1, -0.1}, {1.1, 1.1, 1.1});
  const Box part = meeting_box(tree, {-0.1, -0.1, -0.1}, {1.1, 0.9, 1.1});
  EXPECT_TRUE(ask_for_all({}, tree));
  EXPECT_TRUE(ask_for_all({.level = 3, .clip = whole}, tree));
  EXPECT_FALSE(ask_for_all({.level = 2, .clip = whole}, tree));
  EXPECT_FALSE(ask_for_all({.level = 3, .clip = part}, tree));
}

TEST(OutputCells, ThatAreLeavesStayAsTheyAre) {
  const FieldData data = sample_data(Degree::kFour, 2);
  const FieldData part = output_cells(data, {.level = 2, .clip = {}});
  ASSERT_EQ(part.tree.size(), 64u);
  std::size_t kept = 0;
  for (CellIndex i = 0; i < part.tree.size(); ++i) {
    const CellIndex leaf = data.tree.find_containing(part.tree[i]);
    if (leaf == kNoCell) continue;
    ++kept;
    EXPECT_EQ(coefficients_of(part.frames[i]), coefficients_of(data.frames[leaf]));
    EXPECT_EQ(part.energy_density[i], data.energy_density[leaf]);
    EXPECT_EQ(part.alignment_deg[i], data.alignment_deg[leaf]);
    EXPECT_EQ(part.on_boundary[i], data.on_boundary[leaf]);
  }
  EXPECT_EQ(kept, 63u) << "all but the one that is split";
}

TEST(OutputCells, HaveTheMeanOfTheirLeavesFramesByVolume) {
  // Seven leaves, and eight of an eighth of their volume each that are turned by t.
  FieldData data = sample_data(Degree::kFour, 1);
  constexpr double t = 0.3;
  for (CellIndex i = 0; i < data.tree.size(); ++i)
    data.frames[i] = to_stored(turned_about_z(data.tree[i].depth() == 2 ? t : 0));
  // Coefficients of order 4 turn by 4 t, all others stay.
  const double expected = 0.25 * std::atan2(std::sin(4 * t) / 8, 7.0 / 8 + std::cos(4 * t) / 8);
  const FieldData part = output_cells(data, {.level = 0, .clip = {}});
  const Coefficients<4> off =
      difference(coefficients_of(part.frames[0]), frame_coefficients<4>(turned_about_z(expected)));
  EXPECT_LT(std::sqrt(squared_norm(off)), 1e-6);
}

TEST(OutputCells, HaveTheNearestFrameAlsoWhereLeavesDisagree) {
  const FieldData data = sample_data(Degree::kFour, 3);
  const FieldData part = output_cells(data, {.level = 2, .clip = {}});
  const LeafFinder finder(data.tree);
  for (CellIndex i = 0; i < part.tree.size(); ++i) {
    Coefficients<4> mean{};
    const auto [first, last] = finder.over(part.tree[i]);
    for (CellIndex leaf = first; leaf < last; ++leaf)
      add_scaled(mean, std::pow(data.tree.cell_size(leaf), 3), coefficients_of(data.frames[leaf]));
    const double best = dot(mean, frame_coefficients<4>(nearest_frame<4>(mean)));
    EXPECT_GT(dot(mean, coefficients_of(part.frames[i])), best * (1 - 1e-6));
  }
}

TEST(OutputCells, HaveMeansOfNumbersAndAnyOfFlags) {
  FieldData data = sample_data(Degree::kFour, 1);
  double energy = 0, angle = 0, area = 0;
  for (CellIndex i = 0; i < data.tree.size(); ++i) {
    data.on_boundary[i] = i % 3 == 0;
    const double size = data.tree.cell_size(i) / data.tree.root().size;
    energy += size * size * size * data.energy_density[i];
    if (data.on_boundary[i]) angle += size * size * data.alignment_deg[i], area += size * size;
  }
  const FieldData part = output_cells(data, {.level = 0, .clip = {}});
  EXPECT_NEAR(part.energy_density[0], energy, 1e-6 * energy);
  EXPECT_NEAR(part.alignment_deg[0], angle / area, 1e-6 * angle / area);
  EXPECT_EQ(part.on_boundary[0], 1);

  std::fill(data.on_boundary.begin(), data.on_boundary.end(), std::uint8_t{0});
  const FieldData inside = output_cells(data, {.level = 0, .clip = {}});
  EXPECT_EQ(inside.on_boundary[0], 0);
  EXPECT_EQ(inside.alignment_deg[0], 0);
}

TEST(OutputCells, AskForWhatMostOfTheirSurfaceAsksFor) {
  FieldData data = sample_data(Degree::kFour, 1);
  // Eight small leaves with a plane are as many as two of the seven larger ones.
  std::size_t large = 0;
  for (const CellAddress leaf : data.tree.leaves()) {
    const bool is_free = leaf.depth() == 1 && large++ < 3;
    data.constraints.push_back(leaf.depth() > 1 ? CellConstraint::kPlane
                               : is_free        ? CellConstraint::kFree
                                                : CellConstraint::kNoSurface);
  }
  const FieldData part = output_cells(data, {.level = 0, .clip = {}});
  EXPECT_EQ(part.constraints, std::vector<CellConstraint>{CellConstraint::kFree});
}

TEST(OutputCells, HaveTheRegionOfMostOfTheirVolume) {
  FieldData data = sample_data(Degree::kFour, 1);
  // The split cell alone is of region 5.
  for (const CellAddress leaf : data.tree.leaves()) data.regions.push_back(leaf.depth() > 1 ? 5 : 2);
  EXPECT_EQ(output_cells(data, {.level = 0, .clip = {}}).regions, std::vector<std::int32_t>{2});
  const FieldData part = output_cells(data, {.level = 1, .clip = {}});
  EXPECT_EQ(std::count(part.regions.begin(), part.regions.end(), 5), 1);
  EXPECT_EQ(part.regions.size(), 8u);
}

TEST(OutputCells, AreJoinedWhereLeavesOnBothSidesAre) {
  FieldData data = sample_data(Degree::kFour, 2);
  std::fill(data.open_faces.begin(), data.open_faces.end(), std::uint8_t{0});
  // The one leaf at the low corner, joined upwards along x within its parent and the leaf there across.
  const CellIndex inner = data.tree.find_containing(CellAddress::root().child(0).child(0));
  const CellIndex outer = data.tree.find_containing(CellAddress::root().child(0).child(7));
  data.open_faces[inner] = 1 << 1;
  data.open_faces[outer] = 1 << 3;
  const FieldData part = output_cells(data, {.level = 1, .clip = {}});
  EXPECT_EQ(part.open_faces, (std::vector<std::uint8_t>{1 << 3, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(OutputCells, OfABoxAreExactlyThoseThatMeetIt) {
  const FieldData data = sample_data(Degree::kFour, 3);
  const Box whole = data.tree.root().box(CellAddress::root());
  for (const Box& box :
       {meeting_box(data.tree, {0.3, 0.1, 0.2}, {0.55, 0.7, 0.21}),
        meeting_box(data.tree, {0.31, 0.31, 0.31}, {0.31, 0.31, 0.31}),
        // On a face of cells, where those of both sides meet it.
        Box{data.tree.root().box(CellAddress::root().child(7)).low, whole.high},
        Box{{-kInfinity, -kInfinity, whole.low[2] + 0.1}, {kInfinity, kInfinity, kInfinity}}}) {
    const FieldData part = output_cells(data, {.level = {}, .clip = box});
    const std::set<std::uint64_t> there = [&] {
      std::set<std::uint64_t> addresses;
      for (const CellAddress cell : part.tree.leaves()) addresses.insert(cell.packed());
      return addresses;
    }();
    EXPECT_FALSE(there.empty());
    for (CellIndex i = 0; i < data.tree.size(); ++i) {
      const Box cell = data.tree.root().box(data.tree[i]);
      bool meets = true;
      for (int axis = 0; axis < 3; ++axis)
        meets = meets && std::max(cell.low[axis], box.low[axis]) <= std::min(cell.high[axis], box.high[axis]);
      EXPECT_EQ(there.contains(data.tree[i].packed()), meets);
    }
  }
}

TEST(OutputCells, OfABoxAreClippedAfterTheyAreMerged) {
  const FieldData data = sample_data(Degree::kFour, 3);
  // Within one leaf; its ancestor is there with all that it has.
  const Box box = meeting_box(data.tree, {0.05, 0.05, 0.05}, {0.06, 0.06, 0.06});
  const FieldData part = output_cells(data, {.level = 1, .clip = box});
  ASSERT_EQ(part.tree.leaves(), std::vector<CellAddress>{CellAddress::root().child(0)});
  const FieldData whole = output_cells(data, {.level = 1, .clip = {}});
  EXPECT_EQ(coefficients_of(part.frames[0]), coefficients_of(whole.frames[0]));
  EXPECT_EQ(part.energy_density[0], whole.energy_density[0]);
}

TEST(OutputCells, HaveNoFaceOpenToWhatIsNotThere) {
  const FieldData data = sample_data(Degree::kFour, 2);
  const FieldData part =
      output_cells(data, {.level = {}, .clip = meeting_box(data.tree, {0.3, -1, -1}, {0.4, 2, 2})});
  for (CellIndex i = 0; i < part.tree.size(); ++i) EXPECT_EQ(part.open_faces[i] & 3, 0) << "one cell along x";
}

TEST(WriteField, HasTheSameBytesOfAPartForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const FieldData data = sample_data(Degree::kFour, 5);
  const OutputOptions options{.level = 4, .clip = meeting_box(data.tree, {0.1, 0, 0}, {0.9, 1, 1})};
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    write_field(field_of(data), folder.path() / std::to_string(threads), {}, options);
  }
  EXPECT_TRUE(content_of(folder.path() / "1" / "field.vtu") == content_of(folder.path() / "2" / "field.vtu"));
}

TEST(WriteField, TellsInTheFileWhatPartItIs) {
  const TemporaryFolder folder;
  const FieldData data = sample_data(Degree::kFour);
  const Box box = meeting_box(data.tree, {0.1, 0.2, 0.3}, {0.4, 0.5, kInfinity});
  write_field(field_of(data), folder.path() / "part", {}, {.level = 1, .clip = box});
  const VtuFile part(folder.path() / "part" / "field.vtu");
  EXPECT_EQ(part.read<std::uint32_t>(VtuSection::kFieldData, "output_level", 1),
            std::vector<std::uint32_t>{1});
  EXPECT_EQ(part.read<double>(VtuSection::kFieldData, "clip_box", 6),
            (std::vector<double>{box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]}));

  write_field(field_of(data), folder.path() / "whole");
  const VtuFile whole(folder.path() / "whole" / "field.vtu");
  EXPECT_EQ(whole.find(VtuSection::kFieldData, "output_level"), nullptr);
  EXPECT_EQ(whole.find(VtuSection::kFieldData, "clip_box"), nullptr);
  EXPECT_TRUE(is_clipped_field(folder.path() / "part"));
  EXPECT_FALSE(is_clipped_field(folder.path() / "whole"));
}

TEST(WriteField, KeepsTheReportOfTheWholeField) {
  const TemporaryFolder folder;
  const SolveReport written = write_field(field_of(sample_data(Degree::kFour)), sample_report(),
                                          folder.path(), {}, {.level = 0, .clip = {}});
  const SolveReport read = read_field(folder.path()).report();
  EXPECT_EQ(read.levels.back().active_cells, sample_report().levels.back().active_cells);
  EXPECT_EQ(read.warnings, sample_report().warnings);
  EXPECT_EQ(written.seconds.write, read.seconds.write);
}

TEST(WriteField, WritesAllCellsAndWarnsWhereNoneMeetsTheBox) {
  const TemporaryFolder folder;
  const FieldData data = sample_data(Degree::kFour);
  const SolveReport report = write_field(field_of(data), sample_report(), folder.path(), {},
                                         {.level = 1, .clip = meeting_box(data.tree, {2, 2, 2}, {3, 3, 3})});
  ASSERT_EQ(report.warnings.size(), sample_report().warnings.size() + 1);
  EXPECT_NE(report.warnings.back().text.find("clip"), std::string::npos);
  EXPECT_EQ(read_field(folder.path()).report().warnings, report.warnings);
  EXPECT_EQ(read_field(folder.path()).size(), 8u) << "merged all the same";
}

TEST(WriteField, RefusesOptionsThatMakeNoSense) {
  const TemporaryFolder folder;
  const FrameField field = field_of(sample_data(Degree::kFour));
  for (const OutputOptions& options :
       {OutputOptions{.level = -1, .clip = {}}, OutputOptions{.level = 20, .clip = {}},
        OutputOptions{.level = {}, .clip = Box{{0, 0, 1}, {1, 1, 0.5}}},
        OutputOptions{.level = {}, .clip = Box{{0, NAN, 0}, {1, 1, 1}}}}) {
    try {
      write_field(field, folder.path() / "out", {}, options);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(ReadField, SamplesAPartLikeAnyOtherField) {
  const TemporaryFolder folder;
  FieldData data = sample_data(Degree::kFour, 3);
  const Quaternion frame = normalised(Quaternion{0.9, 0.3, -0.2, 0.25});
  std::fill(data.frames.begin(), data.frames.end(), to_stored(frame));
  write_field(field_of(data), folder.path(), {},
              {.level = 2, .clip = meeting_box(data.tree, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2})});
  const FrameField read = read_field(folder.path());
  ASSERT_EQ(read.size(), 1u);
  for (const auto& [place, is_there] : {std::pair{0.15, true}, std::pair{0.7, false}}) {
    const Vector3 point = meeting_box(data.tree, {place, place, place}, {}).low;
    const FrameField::Sample sample = read.sample(point);
    EXPECT_EQ(sample.in_active_cell, is_there);
    const Coefficients<4> off =
        difference(frame_coefficients<4>(sample.frame.axes), frame_coefficients<4>(frame));
    EXPECT_LT(std::sqrt(squared_norm(off)), 1e-5);
  }
}

}  // namespace
}  // namespace crossgrain
