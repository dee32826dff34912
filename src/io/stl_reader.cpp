// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "io/surface_builder.hpp"
#include "io/surface_reader.hpp"
#include "io/text_scanner.hpp"

namespace crossgrain {
namespace {

static_assert(std::endian::native == std::endian::little,
              "binary STL is little endian and read as it stands");

// The binary layout: a header of any 80 bytes, the count, then a record per triangle: the normal and three
// corners as twelve floats, and two bytes of attributes.
constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kCountOffset = 80;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kCornersOffset = 12;
constexpr std::size_t kCornerBytes = 12;

std::uint64_t announced_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kCountOffset, sizeof count);
  return count;
}

/// Binary files may begin with "solid" as well, so their length decides; where it fits neither, text has no
/// zero bytes.
bool is_binary(std::string_view bytes) {
  if (bytes.size() >= kHeaderBytes &&
      bytes.size() == kHeaderBytes + kTriangleBytes * announced_triangles(bytes))
    return true;
  const std::size_t start = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  const bool begins_like_text =
      start != std::string_view::npos && equals_ignoring_case(bytes.substr(start, 5), "solid");
  return !begins_like_text || bytes.substr(0, 1000).find('\0') != std::string_view::npos;
}

TriangleMesh read_binary(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  if (bytes.size() < kHeaderBytes)
    fail_input(file, {},
               fmt::format("is no STL file: it does not begin with 'solid', and its {} bytes are too few for "
                           "the binary form; export it again",
                           bytes.size()));
  const std::uint64_t announced = announced_triangles(bytes);
  const std::uint64_t present = (bytes.size() - kHeaderBytes) / kTriangleBytes;
  if (announced > present)
    fail_input(file, {},
               fmt::format("the header announces {} triangles but only {} follow: cut short, or no STL file; "
                           "copy or export it again",
                           announced, present));
  if (announced == 0 && present > 0)
    fail_input(file, {},
               fmt::format("the header announces no triangles though {} bytes follow; export it again",
                           bytes.size() - kHeaderBytes));

  SurfaceBuilder builder(file);
  builder.reserve(3 * announced, announced);
  for (std::size_t t = 0; t < announced; ++t) {
    const char* record = bytes.data() + kHeaderBytes + t * kTriangleBytes + kCornersOffset;
    for (int corner = 0; corner < 3; ++corner) {
      std::array<float, 3> position;
      std::memcpy(position.data(), record + corner * kCornerBytes, kCornerBytes);
      builder.add_vertex({position[0], position[1], position[2]}, {"triangle", t});
    }
    const auto first = static_cast<std::int64_t>(3 * t);
    builder.add_polygon(std::array{first, first + 1, first + 2}, {"triangle", t});
  }
  return builder.finish();
}

/// A state machine over words, since line breaks, indentation and case differ between writers. Only the words
/// that carry the corners matter; names and normals are skipped.
class AsciiStlReader {
 public:
  explicit AsciiStlReader(const InputFile& file) : scanner_(file, {}), builder_(file) {}

  TriangleMesh read() {
    for (;;) {
      const std::string_view word = scanner_.word_anywhere();
      if (word.empty()) break;
      take(word);
    }
    if (in_facet_) scanner_.fail("the file ends inside a facet: cut short; copy or export it again");
    return builder_.finish();
  }

 private:
  void take(std::string_view word) {
    if (equals_ignoring_case(word, "vertex")) {
      take_vertex();
    } else if (equals_ignoring_case(word, "facet")) {
      if (in_facet_) scanner_.fail("a facet begins inside another one; export the file again");
      in_facet_ = true;
      corners_ = 0;
    } else if (equals_ignoring_case(word, "normal")) {
      // Often wrong, and recomputed from the corners anyway.
      for (int i = 0; i < 3; ++i) scanner_.word_anywhere();
    } else if (equals_ignoring_case(word, "endfacet")) {
      take_end_of_facet();
    } else if (equals_ignoring_case(word, "solid") || equals_ignoring_case(word, "endsolid")) {
      if (in_facet_) scanner_.fail("a facet without 'endfacet': cut short; export the file again");
      while (!scanner_.word().empty()) continue;
    } else if (!equals_ignoring_case(word, "outer") && !equals_ignoring_case(word, "loop") &&
               !equals_ignoring_case(word, "endloop")) {
      scanner_.fail(in_quotes(word) + " is no word of an STL file; export the file again");
    }
  }

  void take_vertex() {
    if (!in_facet_) scanner_.fail("a vertex outside of any facet; export the file again");
    Vector3 position;
    for (double& coordinate : position)
      coordinate = scanner_.number(scanner_.word_anywhere(), "a coordinate");
    builder_.add_vertex(position, scanner_.place());
    ++corners_;
  }

  void take_end_of_facet() {
    if (!in_facet_ || corners_ != 3)
      scanner_.fail(fmt::format("a facet of {} corners, not 3; export the file again", corners_));
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
