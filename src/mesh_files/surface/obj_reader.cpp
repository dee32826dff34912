// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <vector>

#include "files/read_memory.hpp"
#include "mesh_files/surface/surface_builder.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

/// Reads the file twice, since faces may come before their vertices. Negative indices count back from the
/// face's own place, so the second pass counts vertices again.
class ObjReader {
 public:
  explicit ObjReader(const InputFile& file) : file_(file), builder_(file, /*first_index=*/1) {}

  TriangleMesh read() {
    for_each_line([&](TextScanner& scanner, std::string_view keyword) {
      if (keyword == "v") read_vertex(scanner);
    });
    std::size_t vertices_so_far = 0;
    for_each_line([&](TextScanner& scanner, std::string_view keyword) {
      if (keyword == "v") ++vertices_so_far;
      if (keyword == "f") read_face(scanner, vertices_so_far);
    });
    return builder_.finish();
  }

 private:
  template <class Body>
  void for_each_line(const Body& body) {
    TextScanner scanner(file_, {.comments = true, .continuations = true});
    do {
      body(scanner, scanner.word());
    } while (scanner.next_line());
  }

  /// Reads x y z; w or a colour may follow.
  void read_vertex(TextScanner& scanner) {
    Vector3 position;
    for (double& coordinate : position) coordinate = scanner.number(scanner.word(), "a coordinate");
    builder_.add_vertex(position, scanner.place());
  }

  /// Reads corners as v, v/vt, v//vn or v/vt/vn.
  void read_face(TextScanner& scanner, std::size_t vertices_so_far) {
    const Place place = scanner.place();
    corners_.clear();
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
      const std::int64_t index = scanner.integer(word.substr(0, word.find('/')), "the number of a vertex");
      if (index == 0) fail_input(file_, place, "a face refers to vertex 0, but vertices are numbered from 1");
      append_within_memory(file_.name(), corners_,
                           index > 0 ? index - 1 : static_cast<std::int64_t>(vertices_so_far) + index);
    }
    builder_.add_polygon(corners_, place);
  }

  const InputFile& file_;
  SurfaceBuilder builder_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

TriangleMesh read_obj(const InputFile& file) {
  return ObjReader(file).read();
}

}  // namespace crossgrain
