// SPDX-License-Identifier: Apache-2.0
#include "picture/png_file.hpp"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <exception>
#include <new>
#include <vector>

#include "files/file_mark.hpp"
#include "files/file_seal.hpp"

namespace crossgrain {
namespace {

/// Level of zlib: higher levels make a picture of lines and smooth shades a tenth smaller in three times the
/// time.
constexpr int kCompression = 4;

/// The data of libpng's callbacks. Exceptions must not pass through libpng, which is C, so they are stored
/// here.
struct Destination {
  OutputFile& file;
  std::exception_ptr failure;
};

void write_bytes(png_structp png, png_bytep bytes, std::size_t size) {
  auto& to = *static_cast<Destination*>(png_get_io_ptr(png));
  try {
    to.file.write(bytes, size);
    return;
  } catch (...) {
    to.failure = std::current_exception();
  }
  png_error(png, "cannot be written");
}

/// Does nothing: OutputFile writes everything at the end.
void flush_nothing(png_structp) {}

std::uint8_t byte_of(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f);
}

/// Fills the bytes of a row. Transparent pixels have their colour without the factor of opacity.
void put_row(const Image& image, int y, bool with_opacity, std::vector<std::uint8_t>& row) {
  row.clear();
  for (int x = 0; x < image.width(); ++x) {
    const Pixel& pixel = image.at(x, y);
    const float factor = with_opacity && pixel.opacity > 0 ? 1 / pixel.opacity : 1;
    for (const float value : {pixel.colour.r, pixel.colour.g, pixel.colour.b})
      row.push_back(byte_of(factor * value));
    if (with_opacity) row.push_back(byte_of(pixel.opacity));
  }
}

bool is_transparent_anywhere(const Image& image) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (image.at(x, y).opacity < 1 - 1e-4f) return true;
  return false;
}

/// Adds the texts, before the pixels.
void put_texts(png_structp png, png_infop info, const PngTexts& texts) {
  // libpng takes pointers to characters that it may not change, and copies them.
  constexpr std::size_t kKeywordBytes = 8;
  static_assert(kPngMark[kKeywordBytes] == '\0');
  if (texts.has_mark) {
    png_text mark{};
    mark.compression = PNG_TEXT_COMPRESSION_NONE;
    mark.key = const_cast<png_charp>(kPngMark.data());
    mark.text = const_cast<png_charp>(kPngMark.data() + kKeywordBytes + 1);
    png_set_text(png, info, &mark, 1);
  }
  if (!texts.description.empty()) {
    png_text description{};
    description.compression = PNG_ITXT_COMPRESSION_NONE;
    description.key = const_cast<png_charp>("Description");
    description.text = const_cast<png_charp>(texts.description.c_str());
    png_set_text(png, info, &description, 1);
  }
}

/// Writes all rows. Returns false if libpng has jumped out of it, so nothing in here has a destructor.
bool write_rows(png_structp png, png_infop info, const Image& image, bool with_opacity, const PngTexts& texts,
                std::vector<std::uint8_t>& row, const Monitor& monitor, Destination& to) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_compression_level(png, kCompression);
  png_set_filter(png, 0, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width()), static_cast<png_uint_32>(image.height()),
               8, with_opacity ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  put_texts(png, info, texts);
  png_write_info(png, info);
  for (int y = 0; y < image.height(); ++y) {
    try {
      monitor.check();
      put_row(image, y, with_opacity, row);
    } catch (...) {
      to.failure = std::current_exception();
      return false;
    }
    png_write_row(png, row.data());
  }
  if (!texts.has_mark) png_write_end(png, nullptr);
  return true;
}

/// Replaces libpng's own handlers, which would print errors and warnings.
[[noreturn]] void jump_on_error(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void pass_over_warning(png_structp, png_const_charp) {}

}  // namespace

void write_png(OutputFile& file, const Image& image, const Monitor& monitor, const PngTexts& texts) {
  Destination to{file, nullptr};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jump_on_error, pass_over_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) {
    png_destroy_write_struct(&png, nullptr);
    throw std::bad_alloc();
  }
  png_set_write_fn(png, &to, write_bytes, flush_nothing);
  const bool with_opacity = is_transparent_anywhere(image);
  std::vector<std::uint8_t> row;
  row.reserve(static_cast<std::size_t>(image.width()) * 4);
  const bool is_written = write_rows(png, info, image, with_opacity, texts, row, monitor, to);
  png_destroy_write_struct(&png, &info);
  if (to.failure) std::rethrow_exception(to.failure);
  if (!is_written) throw std::bad_alloc();  // the only other failure of libpng
  if (texts.has_mark) write_seal(file, SealForm::kPng);
}

}  // namespace crossgrain
