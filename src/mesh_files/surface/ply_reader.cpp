// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "files/read_memory.hpp"
#include "mesh_files/surface/ply_header.hpp"
#include "mesh_files/surface/surface_builder.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "text/number_stream.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

NumberStream body_of(const InputFile& file, const PlyHeader& header) {
  if (header.encoding == PlyEncoding::kAscii)
    return NumberStream(TextScanner(file, {}, header.body_begin, header.body_line));
  const bool is_little = header.encoding == PlyEncoding::kLittleEndian;
  return NumberStream(file, std::min(header.body_begin, file.bytes().size()),
                      is_little != (std::endian::native == std::endian::little));
}

std::optional<std::size_t> find_property(const PlyElement& element, std::string_view name, bool is_list) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (element.properties[i].name == name && element.properties[i].is_list == is_list) return i;
  }
  return std::nullopt;
}

class PlyBodyReader {
 public:
  PlyBodyReader(const InputFile& file, const PlyHeader& header)
      : file_(file), header_(header), values_(body_of(file, header)), builder_(file) {}

  TriangleMesh read() {
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements) {
      check_claim(element);
      if (element.name == "vertex") {
        read_vertices(element);
        has_vertices = true;
      } else if (element.name == "face") {
        if (!has_vertices && element.count > 0)
          fail_input(file_, {}, "faces come before the vertices: element vertex must be first",
                     Remedy::kExportAgain);
        read_faces(element);
      } else {
        skip_rows(element);
      }
    }
    return builder_.finish();
  }

 private:
  /// Checks the counts of the header against the file size before memory is allocated.
  void check_claim(const PlyElement& element) const {
    // In text, a value takes a digit and a blank or line end.
    const std::size_t row_bytes =
        values_.is_text() ? 2 * element.properties.size() : element.least_row_bytes();
    if (row_bytes == 0) return;
    // One more, since the last line of text may lack its end.
    if (element.count > values_.bytes_left() / row_bytes + 1)
      fail_input(
          file_, {},
          fmt::format("the header announces {} of element {}, but the rest of the file has {}: cut short, "
                      "or a damaged header",
                      element.count, in_quotes(element.name), counted(values_.bytes_left(), "byte")),
          Remedy::kCopyAgain);
  }

  void skip_property(const PlyProperty& property) {
    values_.skip(property.type, property.is_list ? list_length(property) : 1);
  }

  std::uint64_t list_length(const PlyProperty& property) {
    const std::int64_t length = values_.integer(property.count_type, "the length of a list");
    if (length < 0) values_.fail(fmt::format("a list of {} items", length));
    return static_cast<std::uint64_t>(length);
  }

  void skip_rows(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.begin_element("element", row);
      for (const PlyProperty& property : element.properties) skip_property(property);
    }
  }

  void read_vertices(const PlyElement& element) {
    const auto x = find_property(element, "x", false), y = find_property(element, "y", false),
               z = find_property(element, "z", false);
    if (!x || !y || !z) fail_input(file_, {}, "element vertex lacks x, y or z");
    builder_.reserve(element.count, 0);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.begin_element("vertex", row);
      Vector3 position{};
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (i == *x || i == *y || i == *z) {
          position[i == *x ? 0 : i == *y ? 1 : 2] = values_.real(property.type, "a coordinate");
        } else {
          skip_property(property);
        }
      }
      builder_.add_vertex(position, values_.place("vertex", row));
    }
  }

  void read_faces(const PlyElement& element) {
    auto corners = find_property(element, "vertex_indices", true);
    if (!corners) corners = find_property(element, "vertex_index", true);
    if (!corners) fail_input(file_, {}, "element face lacks the list vertex_indices");
    builder_.reserve(builder_.vertex_count(), element.count);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.begin_element("face", row);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i == *corners) {
          read_corners(element.properties[i]);
        } else {
          skip_property(element.properties[i]);
        }
      }
      builder_.add_polygon(corners_, values_.place("face", row));
    }
  }

  /// The vector grows with the numbers read, not by the claimed length of the list.
  void read_corners(const PlyProperty& property) {
    const std::uint64_t length = list_length(property);
    corners_.clear();
    for (std::uint64_t i = 0; i < length; ++i)
      append_within_memory(file_.name(), corners_, values_.integer(property.type, "an index"));
  }

  const InputFile& file_;
  const PlyHeader& header_;
  NumberStream values_;
  SurfaceBuilder builder_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

TriangleMesh read_ply(const InputFile& file) {
  const PlyHeader header = read_ply_header(file);
  return PlyBodyReader(file, header).read();
}

}  // namespace crossgrain
