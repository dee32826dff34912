// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/picture.hpp"

#include <set>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/solve.hpp"
#include "field/field_data.hpp"
#include "files/temporary_folder.hpp"
#include "picture/read_png.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// A small field, solved once.
const FrameField& solved_field() {
  static const FrameField field = [] {
    SolveOptions options;
    options.resolution = 16;
    return solve(make_bracket(16), options);
  }();
  return field;
}

class Picture : public testing::Test {
 protected:
  Picture() { options.size = {200, 150}; }

  std::filesystem::path drawn(const char* name) {
    render_picture(solved_field(), folder.path() / name, options);
    return folder.path() / name;
  }

  ErrorKind error() {
    try {
      render_picture(solved_field(), folder.path() / "none.png", options);
    } catch (const Error& error) {
      EXPECT_EQ(folder.names(), std::vector<std::string>{});
      return error.kind();
    }
    ADD_FAILURE() << "no error";
    return ErrorKind::kInterrupted;
  }

  TemporaryFolder folder;
  PictureOptions options;
};

TEST_F(Picture, HasTheSizeThatIsAskedForAndTheBackgroundInItsCorners) {
  const ReadPng read = read_png(drawn("a.png"));
  EXPECT_EQ(read.width, 200);
  EXPECT_EQ(read.height, 150);
  EXPECT_EQ(read.at(1, 148), (std::array{255, 255, 255, 255}));
  options.background = PictureBackground::kTransparent;
  EXPECT_EQ(read_png(drawn("b.png")).at(1, 148)[3], 0);
  options.background = PictureBackground::kDark;
  EXPECT_LT(read_png(drawn("c.png")).at(1, 148)[0], 40);
}

TEST_F(Picture, HasTheSameBytesOnAnyNumberOfThreads) {
  options.cut = PictureOptions::Cut{1, std::nullopt};
  options.colour = PictureColour::kEnergy;
  std::set<std::string> contents;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    contents.insert(content_of(drawn("a.png")));
  }
  EXPECT_EQ(contents.size(), 1u);
}

TEST_F(Picture, IsAnotherFromEverySide) {
  std::set<std::string> contents;
  for (const char* view : {"iso", "front", "back", "left", "right", "top", "bottom"}) {
    options.view = view_named(view);
    contents.insert(content_of(drawn("a.png")));
  }
  EXPECT_EQ(contents.size(), 7u);
}

TEST_F(Picture, IsAnotherForEveryOption) {
  std::set<std::string> contents{content_of(drawn("a.png"))};
  const auto with = [&](const auto& change) {
    const PictureOptions before = options;
    change();
    contents.insert(content_of(drawn("a.png")));
    options = before;
  };
  with([&] { options.colour = PictureColour::kAlignment; });
  with([&] { options.colour = PictureColour::kAlignment, options.range = {0, 1}; });
  with([&] { options.colour = PictureColour::kEnergy; });
  with([&] { options.colour = PictureColour::kConstraint; });
  with([&] { options.colour = PictureColour::kFace; });
  with([&] { options.cut = PictureOptions::Cut{0, std::nullopt}; });
  with([&] { options.cut = PictureOptions::Cut{2, std::nullopt}, options.frames = PictureFrames::kCrosses; });
  with([&] { options.cut = PictureOptions::Cut{2, std::nullopt}, options.frames = PictureFrames::kNone; });
  with([&] { options.without = {PicturePart::kLines}; });
  with([&] { options.without = {PicturePart::kCreases}; });
  with([&] { options.up_axis = 1; });
  EXPECT_EQ(contents.size(), 12u);
}

TEST_F(Picture, HasALegendWhereThereIsRoomForOne) {
  const auto pixels = [&] { return read_png(drawn("a.png")).bytes; };
  const auto small = pixels();
  options.without = {PicturePart::kLegend};
  EXPECT_EQ(pixels(), small) << "letters would take half of it";
  options.size = {800, 600};
  const auto without = pixels();
  options.without = {};
  EXPECT_NE(pixels(), without);
}

TEST_F(Picture, OfWrongSizesViewsAndCutsIsRefused) {
  const auto refused = [&](const auto& change) {
    const PictureOptions before = options;
    change();
    EXPECT_EQ(error(), ErrorKind::kUsage);
    options = before;
  };
  refused([&] { options.size[0] = 63; });
  refused([&] { options.size[1] = 10001; });
  refused([&] { options.size = {9000, 9000}; });
  refused([&] { options.view = {{0, 91}}; });
  refused([&] { options.view = {{NAN, 0}}; });
  refused([&] { options.cut = PictureOptions::Cut{1, 1e6}; });
  refused([&] { options.cut = PictureOptions::Cut{3, std::nullopt}; });
  refused([&] { options.view = view_named("front"), options.cut = PictureOptions::Cut{0, std::nullopt}; });
  refused([&] { options.range = {0, 1}; });
  refused([&] { options.range = {0, 1}, options.colour = PictureColour::kEnergy; });
  EXPECT_THROW(view_named("inside"), Error);
}

TEST_F(Picture, NeedsTheSurface) {
  auto without = std::make_shared<FieldData>(solved_field().data());
  without->surface = {};
  try {
    render_picture(FrameField(without), folder.path() / "a.png", options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(error.what()).find("solve again"), std::string::npos);
  }
}

TEST_F(Picture, OfAFieldInMemoryIsThatOfTheFieldReadFromItsFiles) {
  const TemporaryFolder other;
  write_field(solved_field(), other.path());
  options.cut = PictureOptions::Cut{1, std::nullopt};
  options.colour = PictureColour::kEnergy;
  const std::string in_memory = content_of(drawn("a.png"));
  render_picture(read_field(other.path()), folder.path() / "b.png", options);
  EXPECT_EQ(content_of(folder.path() / "b.png"), in_memory);
}

TEST_F(Picture, ShowsTheCurvesThatItIsGiven) {
  const std::string plain = content_of(drawn("a.png"));
  const Box box = solved_field().report().model.bounding_box;
  PictureCurves curves;
  curves.streamlines = {{{box.low, box.high}, 0}};
  render_picture(solved_field(), folder.path() / "b.png", options, curves);
  EXPECT_NE(content_of(folder.path() / "b.png"), plain);
  const SingularityGraph none;
  render_picture(solved_field(), folder.path() / "c.png", options, {&none, {}});
  EXPECT_NE(content_of(folder.path() / "c.png"), plain);
}

TEST_F(Picture, LeavesNothingWhereItIsCancelled) {
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(render_picture(solved_field(), folder.path() / "a.png", options, {}, monitor), Error);
  EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST_F(Picture, OfPartOfAFieldIsDrawnToo) {
  const Box box = solved_field().report().model.bounding_box;
  const TemporaryFolder other;
  OutputOptions part;
  part.clip = Box{box.low, 0.5 * (box.low + box.high)};
  write_field(solved_field(), other.path(), {}, part);
  options.colour = PictureColour::kConstraint;
  options.cut = PictureOptions::Cut{1, std::nullopt};
  render_picture(read_field(other.path()), folder.path() / "a.png", options);
  EXPECT_EQ(read_png(folder.path() / "a.png").width, 200);
}

}  // namespace
}  // namespace crossgrain
