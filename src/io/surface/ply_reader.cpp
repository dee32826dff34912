// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <vector>

#include "io/surface/ply_header.hpp"
#include "io/surface/surface_builder.hpp"
#include "io/surface/surface_reader.hpp"
#include "io/text/text_scanner.hpp"

namespace crossgrain {
namespace {

/// The values of an ASCII body, one after the other; line breaks do not matter.
class AsciiValues {
 public:
  AsciiValues(const InputFile& file, const PlyHeader& header)
      : scanner_(file, {}, header.body_begin, header.body_line) {}

  double value(PlyType) { return scanner_.number(scanner_.word_anywhere(), "a number"); }

  std::int64_t integer(PlyType) { return scanner_.integer(scanner_.word_anywhere(), "a whole number"); }

  void skip(PlyType, std::uint64_t values) {
    for (std::uint64_t i = 0; i < values; ++i) {
      if (scanner_.word_anywhere().empty()) fail("the file ends too early: cut short", Remedy::kCopyAgain);
    }
  }

  std::size_t bytes_left() const { return scanner_.bytes_left(); }
  Place place(const char*, std::size_t) const { return scanner_.place(); }
  void start_row(const char*, std::size_t) {}
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kRepairFile) const {
    scanner_.fail(text, remedy);
  }

  /// A digit and a blank or line end for each value.
  static std::size_t least_bytes(const PlyElement& element) { return 2 * element.properties.size(); }

 private:
  TextScanner scanner_;
};

/// The values of a binary body.
class BinaryValues {
 public:
  BinaryValues(const InputFile& file, const PlyHeader& header)
      : file_(file),
        position_(std::min(header.body_begin, file.bytes().size())),
        swapped_((header.encoding == PlyEncoding::kLittleEndian) !=
                 (std::endian::native == std::endian::little)) {}

  double value(PlyType type) {
    switch (type) {
      case PlyType::kFloat32:
        return take<float>();
      case PlyType::kFloat64:
        return take<double>();
      default:
        return static_cast<double>(integer(type));
    }
  }

  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::kInt8:
        return take<std::int8_t>();
      case PlyType::kUint8:
        return take<std::uint8_t>();
      case PlyType::kInt16:
        return take<std::int16_t>();
      case PlyType::kUint16:
        return take<std::uint16_t>();
      case PlyType::kInt32:
        return take<std::int32_t>();
      case PlyType::kUint32:
        return take<std::uint32_t>();
      default:
        fail("a number with decimals where a whole one should stand", Remedy::kExportAgain);
    }
  }

  void skip(PlyType type, std::uint64_t values) {
    if (values > bytes_left() / size_of(type)) fail_truncated();
    position_ += values * size_of(type);
  }

  std::size_t bytes_left() const { return file_.bytes().size() - position_; }
  Place place(const char* element, std::size_t row) const { return {element, row}; }
  void start_row(const char* element, std::size_t row) { here_ = {element, row}; }
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kRepairFile) const {
    fail_input(file_, here_, text, remedy);
  }

  static std::size_t least_bytes(const PlyElement& element) { return element.least_row_bytes(); }

 private:
  [[noreturn]] void fail_truncated() const { fail("the file ends here: cut short", Remedy::kCopyAgain); }

  template <class T>
  T take() {
    if (bytes_left() < sizeof(T)) fail_truncated();
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), file_.bytes().data() + position_, sizeof(T));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    position_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }

  const InputFile& file_;
  std::size_t position_;
  bool swapped_;
  Place here_;
};

std::optional<std::size_t> find_property(const PlyElement& element, std::string_view name, bool is_list) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (element.properties[i].name == name && element.properties[i].is_list == is_list) return i;
  }
  return std::nullopt;
}

template <class Values>
class PlyBodyReader {
 public:
  PlyBodyReader(const InputFile& file, const PlyHeader& header)
      : file_(file), header_(header), values_(file, header), builder_(file) {}

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
  /// What the header claims must have bytes behind it before anything is allocated for it.
  void check_claim(const PlyElement& element) const {
    const std::size_t row_bytes = Values::least_bytes(element);
    if (row_bytes == 0) return;
    // One more, since the last line of text may lack its end.
    if (element.count > values_.bytes_left() / row_bytes + 1)
      fail_input(file_, {},
                 fmt::format("the header announces {} of element {}, but only {} bytes follow: cut short, or "
                             "a damaged header",
                             element.count, in_quotes(element.name), values_.bytes_left()),
                 Remedy::kCopyAgain);
  }

  void skip_property(const PlyProperty& property) {
    values_.skip(property.type, property.is_list ? list_length(property) : 1);
  }

  std::uint64_t list_length(const PlyProperty& property) {
    const std::int64_t length = values_.integer(property.count_type);
    if (length < 0) values_.fail(fmt::format("a list of {} items", length));
    return static_cast<std::uint64_t>(length);
  }

  void skip_rows(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.start_row("element", row);
      for (const PlyProperty& property : element.properties) skip_property(property);
    }
  }

  void read_vertices(const PlyElement& element) {
    const auto x = find_property(element, "x", false), y = find_property(element, "y", false),
               z = find_property(element, "z", false);
    if (!x || !y || !z) fail_input(file_, {}, "element vertex lacks x, y or z");
    builder_.reserve(element.count, 0);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.start_row("vertex", row);
      Vector3 position{};
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (i == *x || i == *y || i == *z) {
          position[i == *x ? 0 : i == *y ? 1 : 2] = values_.value(property.type);
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
      values_.start_row("face", row);
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

  /// Grows with what is read, not by what the list says of its length.
  void read_corners(const PlyProperty& property) {
    const std::uint64_t length = list_length(property);
    corners_.clear();
    for (std::uint64_t i = 0; i < length; ++i) corners_.push_back(values_.integer(property.type));
  }

  const InputFile& file_;
  const PlyHeader& header_;
  Values values_;
  SurfaceBuilder builder_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

TriangleMesh read_ply(const InputFile& file) {
  const PlyHeader header = read_ply_header(file);
  return header.encoding == PlyEncoding::kAscii ? PlyBodyReader<AsciiValues>(file, header).read()
                                                : PlyBodyReader<BinaryValues>(file, header).read();
}

}  // namespace crossgrain
