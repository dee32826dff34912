// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/page.hpp"

#include <libdeflate.h>

#include <array>
#include <cassert>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "crossgrain/error.hpp"
#include "crossgrain/writing.hpp"
#include "files/file_mark.hpp"
#include "files/file_seal.hpp"
#include "files/output_file.hpp"
#include "files/output_name.hpp"
#include "page/page_scene.hpp"
#include "page/page_template.hpp"

namespace crossgrain {
namespace {

/// Compression level: floats hardly become smaller with a higher one.
constexpr int kCompressionLevel = 4;

constexpr std::string_view kReportPlace = "/*REPORT*/", kScenePlace = "/*SCENE*/";

/// With a gzip header, which browsers decompress by themselves.
std::string gzipped(std::string_view bytes) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kCompressionLevel), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::string packed(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()), '\0');
  packed.resize(
      libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
  return packed;
}

/// Base64 (RFC 4648, section 4).
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

/// JSON that cannot end an element of a page: '<' occurs in strings only and is escaped.
std::string inside_page(std::string_view json) {
  std::string text;
  for (const char c : json) c == '<' ? text += "\\u003c" : text += c;
  return text;
}

void write_page_text(const std::string& solve, std::string_view report, std::string_view packed_scene,
                     const ByteSink& write) {
  const std::string_view page = page_template();
  const std::size_t report_at = page.find(kReportPlace), scene_at = page.find(kScenePlace);
  const std::size_t marked = page.find(kHtmlMark) + kHtmlMark.size();
  assert(marked < report_at && report_at < scene_at && scene_at != std::string_view::npos);
  write(page.substr(0, marked));
  if (!solve.empty()) write(std::string(kHtmlSolve) + solve + "\">");
  write(page.substr(marked, report_at - marked));
  write(inside_page(report));
  write(page.substr(report_at + kReportPlace.size(), scene_at - report_at - kReportPlace.size()));
  write(packed_scene);
  write(page.substr(scene_at + kScenePlace.size()));
}

/// The page as a companion file, of the scene that this gives.
template <class SceneOf>
CompanionFile page_with(const SceneOf& scene_of) {
  return {kPageFile, [scene_of](const Monitor& monitor) -> CompanionFile::Writer {
            return [scene = base64(gzipped(scene_of(monitor)))](const SolveReport& report,
                                                                const ByteSink& write) {
              write_page_text(report.solve, report_json(report), scene, write);
            };
          }};
}

void write_alone(const CompanionFile& page, const SolveReport& report, const std::filesystem::path& path,
                 const Monitor& monitor) {
  check_extension(path, "a page", std::array<std::string_view, 2>{".html", ".htm"});
  OutputFile file(path);
  page.prepare(monitor)(report, [&](std::string_view bytes) { file.write(bytes); });
  monitor.check();
  // It may have the name of the page in the folder of a field, whose report does not list it.
  write_seal(file, SealForm::kXml);
  file.commit();
}

}  // namespace

CompanionFile page_of(const FrameField& field) {
  return page_with([field](const Monitor& monitor) { return page_scene(field, monitor); });
}

CompanionFile page_of(const TetFrameField& field, std::shared_ptr<const HexMesh> hexahedra) {
  return page_with([field, hexahedra = std::move(hexahedra)](const Monitor& monitor) {
    return page_scene(field, hexahedra.get(), monitor);
  });
}

CompanionFile page_of(const FittedHexahedra& fitted) {
  if (!fitted.surface)
    throw Error(ErrorKind::kUsage, "hexahedra without the surface of a model have no page");
  return page_with([&fitted](const Monitor& monitor) { return page_scene(fitted, monitor); });
}

void write_page(const FrameField& field, const std::filesystem::path& path, const Monitor& monitor) {
  write_alone(page_of(field), field.report(), path, monitor);
}

void write_page(const TetFrameField& field, const std::filesystem::path& path, const Monitor& monitor) {
  write_alone(page_of(field), field.report(), path, monitor);
}

}  // namespace crossgrain
