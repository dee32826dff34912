// SPDX-License-Identifier: Apache-2.0
#include "page/page_file.hpp"

#include <zlib.h>

#include <cassert>
#include <cstdint>
#include <stdexcept>

#include "page/page_template.hpp"

namespace crossgrain {
namespace {

/// Floats hardly pack better for more effort.
constexpr int kZlibLevel = 5;

/// Largest window, and a gzip header, which browsers unpack on their own.
constexpr int kGzipWindow = 15 + 16;

constexpr std::string_view kReportPlace = "/*REPORT*/", kScenePlace = "/*SCENE*/";

std::string gzipped(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, kZlibLevel, Z_DEFLATED, kGzipWindow, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  [[maybe_unused]] const int result = deflate(&stream, Z_FINISH);
  assert(result == Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const auto at = [&](std::size_t i) {
      return i < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[i])} : 0;
    };
    const std::uint32_t three = at(k) << 16 | at(k + 1) << 8 | at(k + 2);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text.push_back(k + digit <= bytes.size() ? kDigits[three >> (18 - 6 * digit) & 63] : '=');
  }
  return text;
}

/// JSON that no element of a page ends within: '<' stands in strings only.
std::string inside_page(std::string_view json) {
  std::string text;
  for (const char c : json) c == '<' ? text += "\\u003c" : text += c;
  return text;
}

}  // namespace

std::string packed_for_page(std::string_view bytes) {
  return base64(gzipped(bytes));
}

void write_page(OutputFile& file, std::string_view report_text, std::string_view packed_scene) {
  const std::string_view page = page_template();
  const std::size_t report = page.find(kReportPlace), scene = page.find(kScenePlace);
  assert(report < scene && scene != std::string_view::npos);
  file.write(page.substr(0, report));
  file.write(inside_page(report_text));
  file.write(page.substr(report + kReportPlace.size(), scene - report - kReportPlace.size()));
  file.write(packed_scene);
  file.write(page.substr(scene + kScenePlace.size()));
}

}  // namespace crossgrain
