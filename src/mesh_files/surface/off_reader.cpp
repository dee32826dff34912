// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "files/read_memory.hpp"
#include "mesh_files/surface/surface_builder.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

class OffReader {
 public:
  explicit OffReader(const InputFile& file) : scanner_(file, {.comments = true}), builder_(file) {}

  TriangleMesh read() {
    const std::string_view first_count = read_keyword();
    const std::size_t vertices = read_count(first_count, "the number of vertices", kVertexBytes);
    const std::size_t faces = read_count(scanner_.word_anywhere(), "the number of faces", kFaceBytes);
    // The rest of the line is the number of edges, which is not needed and often missing.
    scanner_.next_line();
    builder_.reserve(vertices, faces);
    for (std::size_t i = 0; i < vertices; ++i) read_vertex();
    for (std::size_t i = 0; i < faces; ++i) read_face();
    return builder_.finish();
  }

 private:
  // Bytes of the shortest vertex ("0 0 0") and face ("0") with a line end, to check the counts of the header.
  static constexpr std::size_t kVertexBytes = 6;
  static constexpr std::size_t kFaceBytes = 2;

  /// Skips [ST][C][N]OFF and returns the word after it, even without white space between. The format allows
  /// the keyword to be missing.
  std::string_view read_keyword() {
    std::string_view word = scanner_.word_anywhere();
    const std::size_t found = word.find("OFF");
    if (found == std::string_view::npos ||
        word.substr(0, found).find_first_not_of("STCN4n") != std::string_view::npos) {
      if (word.empty() || word[0] < '0' || word[0] > '9')
        scanner_.fail(in_quotes(word) + " instead of 'OFF': this is not an OFF file", Remedy::kExportAgain);
      return word;
    }
    const std::string_view prefix = word.substr(0, found);
    if (prefix.find_first_of("4n") != std::string_view::npos)
      scanner_.fail(in_quotes(word) + ": vertices of other than three dimensions", Remedy::kExportAgain);
    word = word.substr(found + 3);
    if (word.empty()) word = scanner_.word_anywhere();
    if (equals_ignoring_case(word, "BINARY"))
      scanner_.fail("binary OFF has no reader, only OFF in text", Remedy::kExportAgain);
    return word;
  }

  std::size_t read_count(std::string_view word, const char* what, std::size_t bytes_each) {
    const std::int64_t count = scanner_.integer(word, what);
    if (count < 0) scanner_.fail(fmt::format("{} is {}", what, count));
    // One more, since the last line may lack its end.
    if (static_cast<std::uint64_t>(count) > scanner_.bytes_left() / bytes_each + 1)
      scanner_.fail(
          fmt::format(
              "the header gives {} as {}, but the rest of the file has {}: cut short, or a damaged header",
              what, count, counted(scanner_.bytes_left(), "byte")),
          Remedy::kCopyAgain);
    return static_cast<std::size_t>(count);
  }

  /// Reads x y z; a normal, a colour and texture coordinates may follow on the line.
  void read_vertex() {
    Vector3 position;
    for (double& coordinate : position)
      coordinate = scanner_.number(scanner_.word_anywhere(), "a coordinate");
    builder_.add_vertex(position, scanner_.place());
    scanner_.next_line();
  }

  /// Reads the number of corners and the corners; a colour may follow on the line.
  void read_face() {
    const std::int64_t count = scanner_.integer(scanner_.word_anywhere(), "the number of a face's corners");
    if (count < 0) scanner_.fail(fmt::format("a face of {} corners", count));
    corners_.clear();
    for (std::int64_t i = 0; i < count; ++i)
      append_within_memory(scanner_.file().name(), corners_,
                           scanner_.integer(scanner_.word_anywhere(), "the number of a vertex"));
    builder_.add_polygon(corners_, scanner_.place());
    scanner_.next_line();
  }

  TextScanner scanner_;
  SurfaceBuilder builder_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

TriangleMesh read_off(const InputFile& file) {
  return OffReader(file).read();
}

}  // namespace crossgrain
