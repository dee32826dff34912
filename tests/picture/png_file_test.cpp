// SPDX-License-Identifier: Apache-2.0
#include "picture/png_file.hpp"

#include "crossgrain/error.hpp"
#include "files/file_mark.hpp"
#include "files/small_files.hpp"
#include "files/temporary_folder.hpp"
#include "picture/read_png.hpp"

namespace crossgrain {
namespace {

/// Every pixel another colour.
Image many_colours(int width, int height, float opacity) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = pixel_of(
          {static_cast<float>(x) / 255, static_cast<float>(y) / 255, static_cast<float>((x * y) % 256) / 255},
          opacity);
  return image;
}

void write(const std::filesystem::path& path, const Image& image) {
  OutputFile file(path);
  write_png(file, image, {});
  file.commit();
}

TEST(PngFile, GivesEveryPixelBack) {
  const TemporaryFolder folder;
  write(folder.path() / "a.png", many_colours(70, 50, 1));
  const ReadPng read = read_png(folder.path() / "a.png");
  ASSERT_EQ(read.width, 70);
  ASSERT_EQ(read.height, 50);
  EXPECT_FALSE(read.has_opacity);
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 70; ++x) ASSERT_EQ(read.at(x, y), (std::array{x, y, x * y % 256, 255}));
}

TEST(PngFile, KeepsTheColourOfWhatIsTransparentInPart) {
  const TemporaryFolder folder;
  Image image = many_colours(70, 50, 0.5f);
  image.at(3, 4) = {};
  write(folder.path() / "a.png", image);
  const ReadPng read = read_png(folder.path() / "a.png");
  EXPECT_TRUE(read.has_opacity);
  EXPECT_EQ(read.at(60, 40), (std::array{60, 40, 60 * 40 % 256, 128}));
  EXPECT_EQ(read.at(3, 4), (std::array{0, 0, 0, 0}));
}

TEST(PngFile, HasTheMarkOfTheProgramAndADescriptionOnRequest) {
  const TemporaryFolder folder;
  write(folder.path() / "a.png", many_colours(70, 50, 1));
  EXPECT_FALSE(has_mark(folder.path() / "a.png"));
  OutputFile file(folder.path() / "b.png");
  write_png(file, many_colours(70, 50, 1), {}, {.has_mark = true, .description = "what it shows"});
  file.commit();
  EXPECT_TRUE(has_mark(folder.path() / "b.png"));
  EXPECT_NE(content_of(folder.path() / "b.png").find("what it shows"), std::string::npos);
  EXPECT_TRUE(read_png(folder.path() / "a.png").bytes == read_png(folder.path() / "b.png").bytes);
}

TEST(PngFile, EndsWhereItIsCancelled) {
  const TemporaryFolder folder;
  Monitor monitor;
  monitor.cancel();
  OutputFile file(folder.path() / "a.png");
  try {
    write_png(file, many_colours(64, 64, 1), monitor);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
}

TEST(PngFile, PassesOnWhatTheDiskSays) {
  // Bytes that do not compress, so that they reach the disk before the end.
  Image image(1500, 1500);
  std::uint32_t state = 1;
  for (int y = 0; y < 1500; ++y)
    for (int x = 0; x < 1500; ++x) {
      state = state * 1664525u + 1013904223u;
      image.at(x, y) = pixel_of(colour_of(state >> 8));
    }
  const TemporaryFolder folder;
  OutputFile file(folder.path() / "a.png");
  const SmallFiles limit;
  try {
    write_png(file, image, {});
    file.commit();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kOutput);
  }
}

}  // namespace
}  // namespace crossgrain
