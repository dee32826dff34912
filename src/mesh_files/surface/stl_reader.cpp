// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "base/first_equal.hpp"
#include "base/parallel.hpp"
#include "mesh_files/surface/surface_builder.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

static_assert(std::endian::native == std::endian::little,
              "binary STL is little endian and read as it stands");

// Binary layout: a header of 80 arbitrary bytes, the count, then a record per triangle: the normal and three
// corners as twelve floats, and two bytes of attributes.
constexpr std::size_t kStlHeaderBytes = 84;
constexpr std::size_t kCountOffset = 80;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kCornersOffset = 12;
constexpr std::size_t kCornerBytes = 12;

std::uint64_t announced_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kCountOffset, sizeof count);
  return count;
}

/// Returns whether a file is binary. Binary files may begin with "solid" too, so the length decides; if it
/// fits neither, text has no zero bytes.
bool is_binary(std::string_view bytes) {
  if (bytes.size() >= kStlHeaderBytes &&
      bytes.size() == kStlHeaderBytes + kTriangleBytes * announced_triangles(bytes))
    return true;
  const std::size_t start = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  const bool begins_like_text =
      start != std::string_view::npos && equals_ignoring_case(bytes.substr(start, 5), "solid");
  return !begins_like_text || bytes.substr(0, 1000).find('\0') != std::string_view::npos;
}

/// Triangles of a binary file. They share no vertices; corners are numbered consecutively.
class BinaryTriangles {
 public:
  BinaryTriangles(std::string_view bytes, std::size_t count)
      : records_(bytes.data() + kStlHeaderBytes), count_(count) {}

  std::size_t count() const { return count_; }

  std::array<float, 3> corner(std::size_t c) const {
    std::array<float, 3> position;
    std::memcpy(position.data(), records_ + c / 3 * kTriangleBytes + kCornersOffset + c % 3 * kCornerBytes,
                kCornerBytes);
    return position;
  }

  /// Merges corners of equal coordinates into one vertex, in the order of their first use. Separate vertices
  /// for all corners would take more memory than everything else together.
  TriangleMesh welded() const {
    const auto bits_at = [&](std::size_t c) {
      std::array<std::uint32_t, 3> bits;
      const std::array<float, 3> position = corner(c);
      // Turns -0 into 0.
      for (std::size_t axis = 0; axis < 3; ++axis)
        bits[axis] = std::bit_cast<std::uint32_t>(position[axis] + 0.0f);
      return bits;
    };
    TriangleMesh mesh;
    mesh.triangles = sized_vector<std::array<std::uint32_t, 3>>(count_);
    const std::span<std::uint32_t> first(mesh.triangles.data()->data(), 3 * count_);
    find_first_equal(bits_at, first);
    const RankedSet kept(first.size(), [&](std::size_t c) { return first[c] == c; });
    mesh.vertices = sized_vector<Vector3>(kept.size());
    parallel_for(
        first.size(),
        [&](std::size_t c) {
          if (first[c] == c) {
            const std::array<float, 3> position = corner(c);
            mesh.vertices[kept.rank(c)] = {position[0], position[1], position[2]};
          }
          first[c] = kept.rank(first[c]);
        },
        kGrain);
    return mesh;
  }

 private:
  /// Large enough that chunks rarely share cache lines.
  static constexpr std::size_t kGrain = std::size_t{1} << 14;

  const char* records_;
  std::size_t count_;
};

void check_finite(const InputFile& file, const BinaryTriangles& triangles) {
  std::atomic<std::size_t> first_bad{SIZE_MAX};
  parallel_for(3 * triangles.count(), [&](std::size_t c) {
    for (const float coordinate : triangles.corner(c)) {
      if (std::isfinite(coordinate)) continue;
      for (std::size_t known = first_bad; c < known && !first_bad.compare_exchange_weak(known, c);) continue;
    }
  });
  if (first_bad == SIZE_MAX) return;
  // Reports what is wrong as for any other format.
  const std::array<float, 3> bad = triangles.corner(first_bad);
  SurfaceBuilder(file).add_vertex({bad[0], bad[1], bad[2]}, {"triangle", first_bad / 3});
}

TriangleMesh read_binary(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  if (bytes.size() < kStlHeaderBytes)
    fail_input(file, {},
               fmt::format(
                   "is not an STL file: it does not begin with 'solid', and is too short for the binary form "
                   "({})",
                   counted(bytes.size(), "byte")),
               Remedy::kExportAgain);
  const std::uint64_t announced = announced_triangles(bytes);
  const std::uint64_t present = (bytes.size() - kStlHeaderBytes) / kTriangleBytes;
  if (announced > present)
    fail_input(file, {},
               fmt::format("the header announces {}, of which the file has {}: cut short, or no STL file",
                           counted(announced, "triangle"), present),
               Remedy::kCopyAgain);
  if (announced == 0 && present > 0)
    fail_input(file, {},
               fmt::format("the header announces no triangles though {} bytes follow",
                           bytes.size() - kStlHeaderBytes),
               Remedy::kExportAgain);

  constexpr std::uint64_t kMostTriangles = UINT32_MAX / 3;
  if (announced > kMostTriangles)
    fail_input(file, {},
               fmt::format("{} triangles, of which {} can be read at most", announced, kMostTriangles),
               Remedy::kSimplify);
  if (announced == 0) SurfaceBuilder(file).finish();
  const BinaryTriangles triangles(bytes, announced);
  check_finite(file, triangles);
  return triangles.welded();
}

/// A state machine over words, since line breaks, indentation and case differ between writers. Only the words
/// before corners matter; names and normals are skipped.
class AsciiStlReader {
 public:
  explicit AsciiStlReader(const InputFile& file) : scanner_(file, {}), builder_(file) {}

  TriangleMesh read() {
    for (;;) {
      const std::string_view word = scanner_.word_anywhere();
      if (word.empty()) break;
      take(word);
    }
    if (in_facet_) scanner_.fail("the file ends inside a facet: cut short", Remedy::kCopyAgain);
    return builder_.finish();
  }

 private:
  void take(std::string_view word) {
    if (equals_ignoring_case(word, "vertex")) {
      take_vertex();
    } else if (equals_ignoring_case(word, "facet")) {
      if (in_facet_) scanner_.fail("a facet begins inside another one");
      in_facet_ = true;
      corners_ = 0;
    } else if (equals_ignoring_case(word, "normal")) {
      // Often wrong; recomputed from the corners.
      for (int i = 0; i < 3; ++i) scanner_.word_anywhere();
    } else if (equals_ignoring_case(word, "endfacet")) {
      take_end_of_facet();
    } else if (equals_ignoring_case(word, "solid") || equals_ignoring_case(word, "endsolid")) {
      if (in_facet_) scanner_.fail("a facet without 'endfacet': cut short", Remedy::kCopyAgain);
      while (!scanner_.word().empty()) continue;
    } else if (!equals_ignoring_case(word, "outer") && !equals_ignoring_case(word, "loop") &&
               !equals_ignoring_case(word, "endloop")) {
      scanner_.fail(in_quotes(word) + " is not a keyword of an STL file");
    }
  }

  void take_vertex() {
    if (!in_facet_) scanner_.fail("a vertex outside of any facet");
    Vector3 position;
    for (double& coordinate : position)
      coordinate = scanner_.number(scanner_.word_anywhere(), "a coordinate");
    builder_.add_vertex(position, scanner_.place());
    ++corners_;
  }

  void take_end_of_facet() {
    if (!in_facet_ || corners_ != 3)
      scanner_.fail(fmt::format("a facet of {}, not 3", counted(corners_, "corner")));
    const auto end = static_cast<std::int64_t>(builder_.vertex_count());
    builder_.add_polygon(std::array{end - 3, end - 2, end - 1}, scanner_.place());
    in_facet_ = false;
  }

  TextScanner scanner_;
  SurfaceBuilder builder_;
  bool in_facet_ = false;
  int corners_ = 0;
};

}  // namespace

TriangleMesh read_stl(const InputFile& file) {
  return is_binary(file.bytes()) ? read_binary(file) : AsciiStlReader(file).read();
}

}  // namespace crossgrain
