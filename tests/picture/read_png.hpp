// SPDX-License-Identifier: Apache-2.0
// A PNG file read back with libpng.
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace crossgrain {

struct ReadPng {
  int width = 0, height = 0;
  bool has_opacity = false;
  std::vector<std::uint8_t> bytes;  ///< RGBA, row by row

  std::array<int, 4> at(int x, int y) const {
    const std::size_t i =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]};
  }
};

inline ReadPng read_png(const std::filesystem::path& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ReadPng out;
  EXPECT_TRUE(png_image_begin_read_from_file(&image, path.c_str())) << image.message;
  out.has_opacity = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  image.format = PNG_FORMAT_RGBA;
  out.width = static_cast<int>(image.width);
  out.height = static_cast<int>(image.height);
  out.bytes.resize(PNG_IMAGE_SIZE(image));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, out.bytes.data(), 0, nullptr)) << image.message;
  return out;
}

}  // namespace crossgrain
