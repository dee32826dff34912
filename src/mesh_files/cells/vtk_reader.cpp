// SPDX-License-Identifier: Apache-2.0
// Reads unstructured grids in legacy VTK files, versions 1 to 5.1, in text or binary, where numbers are big
// endian ("VTK file formats", simple legacy formats).
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mesh_files/cells/cell_builder.hpp"
#include "mesh_files/cells/cell_reader.hpp"
#include "mesh_files/cells/vtk_cells.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

constexpr bool kSwapped = std::endian::native == std::endian::little;

// "long" is that of Linux and macOS; VTK writes its own ids with 32 bits as vtkIdType.
constexpr std::array kVtkTypeNames = {
    NumberTypeName{"char", NumberType::kInt8},
    NumberTypeName{"signed_char", NumberType::kInt8},
    NumberTypeName{"unsigned_char", NumberType::kUint8},
    NumberTypeName{"short", NumberType::kInt16},
    NumberTypeName{"unsigned_short", NumberType::kUint16},
    NumberTypeName{"int", NumberType::kInt32},
    NumberTypeName{"unsigned_int", NumberType::kUint32},
    NumberTypeName{"long", NumberType::kInt64},
    NumberTypeName{"unsigned_long", NumberType::kUint64},
    NumberTypeName{"vtktypeint64", NumberType::kInt64},
    NumberTypeName{"vtktypeuint64", NumberType::kUint64},
    NumberTypeName{"vtkIdType", NumberType::kInt32},
    NumberTypeName{"float", NumberType::kFloat32},
    NumberTypeName{"double", NumberType::kFloat64},
};

/// Keywords of attributes of one array each, with their numbers per point or cell.
struct Attribute {
  std::string_view keyword;
  std::uint64_t components;
};

constexpr std::array kAttributes = {
    Attribute{"VECTORS", 3},    Attribute{"NORMALS", 3},    Attribute{"TENSORS", 9},
    Attribute{"TENSORS6", 6},   Attribute{"GLOBAL_IDS", 1}, Attribute{"PEDIGREE_IDS", 1},
    Attribute{"EDGE_FLAGS", 1},
};

class VtkReader {
 public:
  VtkReader(const InputFile& file, CellBuilder& builder)
      : file_(&file), scanner_(file, {}), builder_(builder) {}

  void read() {
    read_header();
    for (std::string_view keyword = next_keyword(); !keyword.empty(); keyword = next_keyword()) {
      if (!read_part(keyword)) break;
    }
    const char* const missing = !points_         ? "POINTS"
                                : !connectivity_ ? "CELLS"
                                : !types_        ? "CELL_TYPES"
                                                 : nullptr;
    if (missing != nullptr)
      fail(fmt::format("{} is missing: cut short, or not a mesh", missing), Remedy::kCopyAgain);
    if (cell_count_ != type_count_) fail(fmt::format("{} CELLS and {} CELL_TYPES", cell_count_, type_count_));
    add_points();
    add_vtk_cells({cell_count_, *connectivity_, ends_, *types_, tags_}, builder_);
  }

 private:
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kRepairFile) const {
    fail_input(*file_, here(), text, remedy);
  }

  Place here() const { return is_binary_ ? Place{"byte", scanner_.position()} : scanner_.place(); }

  void read_header() {
    if (scanner_.word() != "#" || scanner_.word() != "vtk")
      scanner_.fail("does not begin with '# vtk DataFile Version': this is not a VTK file",
                    Remedy::kExportAgain);
    for (int i = 0; i < 2; ++i) scanner_.word();  // DataFile Version
    const double version = scanner_.number(scanner_.word(), "the version");
    if (!(version >= 1 && version < 6))
      scanner_.fail("the version cannot be read, unlike 4.2 and 5.1", Remedy::kExportAgain);
    new_cells_ = version >= 5;
    scanner_.next_line();
    scanner_.next_line();  // title
    const std::string_view encoding = scanner_.word();
    is_binary_ = equals_ignoring_case(encoding, "BINARY");
    if (!is_binary_ && !equals_ignoring_case(encoding, "ASCII"))
      scanner_.fail(fmt::format("{} instead of ASCII or BINARY", in_quotes(encoding)));
  }

  std::string_view next_keyword() { return scanner_.word_anywhere(); }

  /// Reads the section of a keyword. Returns false if the rest of the file must be ignored.
  bool read_part(std::string_view keyword) {
    const auto is = [keyword](std::string_view name) { return equals_ignoring_case(keyword, name); };
    if (is("DATASET")) {
      read_dataset();
    } else if (is("POINTS")) {
      read_points();
    } else if (is("CELLS")) {
      read_cells();
    } else if (is("CELL_TYPES")) {
      type_count_ = read_count("the number of CELL_TYPES");
      types_ = take_numbers(NumberType::kInt32, type_count_, "CELL_TYPES");
    } else if (is("CELL_DATA") || is("POINT_DATA")) {
      in_cell_data_ = is("CELL_DATA");
      rows_ = read_count("the number of rows of data");
    } else if (is("METADATA")) {
      skip_metadata();
    } else {
      return read_attribute(keyword);
    }
    return true;
  }

  void read_dataset() {
    const std::string_view kind = scanner_.word();
    if (!equals_ignoring_case(kind, "UNSTRUCTURED_GRID"))
      fail(fmt::format("DATASET {}, but a mesh must be an UNSTRUCTURED_GRID", in_quotes(kind)),
           Remedy::kExportAgain);
  }

  std::uint64_t read_count(const char* what) {
    const std::int64_t count = scanner_.integer(scanner_.word(), what);
    if (count < 0) fail(fmt::format("{} is {}", what, count));
    return static_cast<std::uint64_t>(count);
  }

  NumberType read_type() {
    const std::string_view name = scanner_.word();
    const auto type = type_named(kVtkTypeNames, name, equals_ignoring_case);
    if (!type) fail(fmt::format("{} is not a number type", in_quotes(name)));
    return *type;
  }

  /// Returns the array that begins after this line, or in text after this word, and skips it.
  VtkNumbers take_numbers(NumberType type, std::uint64_t count, const char* what) {
    if (is_binary_) scanner_.next_line();
    NumberStream stream =
        is_binary_ ? NumberStream(*file_, scanner_.position(), kSwapped) : NumberStream(scanner_);
    if (count > stream.most_left(type))
      fail(fmt::format("{} should have {}, but the rest of the file has {}: cut short, or damaged", what,
                       counted(count, "number"), counted(scanner_.bytes_left(), "byte")),
           Remedy::kCopyAgain);
    const VtkNumbers begin{stream, type};
    stream.skip(type, count);
    scanner_ = is_binary_ ? TextScanner(*file_, {}, stream.position(), scanner_.line()) : stream.scanner();
    return begin;
  }

  /// Reads `rows` of `components` numbers; their product may exceed 64 bits.
  VtkNumbers take_rows(NumberType type, std::uint64_t rows, std::uint64_t components, const char* what) {
    if (components > 0 && rows > file_->bytes().size() / components)
      fail(fmt::format("{} of {} are more than the file can hold", counted(rows, "row"),
                       counted(components, "number")),
           Remedy::kCopyAgain);
    return take_numbers(type, rows * components, what);
  }

  void read_points() {
    if (points_) fail("a second section POINTS");
    point_count_ = read_count("the number of POINTS");
    const NumberType type = read_type();
    points_ = take_rows(type, point_count_, 3, "POINTS");
  }

  /// Up to version 4 cells are one array with each cell's number of points before them; from version 5,
  /// offsets and connectivity.
  void read_cells() {
    if (connectivity_) fail("a second section CELLS");
    const std::uint64_t first = read_count("the number of CELLS"), second = read_count("the size of CELLS");
    cell_count_ = first;
    if (!new_cells_) {
      connectivity_ = take_numbers(NumberType::kInt32, second, "CELLS");
      return;
    }
    ends_ = take_named("OFFSETS", first);
    connectivity_ = take_named("CONNECTIVITY", second);
    if (first == 0) return;
    cell_count_ = first - 1;
    if (ends_->next("an offset") != 0) fail("the first of OFFSETS is not 0");
  }

  VtkNumbers take_named(const char* name, std::uint64_t count) {
    const std::string_view keyword = scanner_.word_anywhere();
    if (!equals_ignoring_case(keyword, name)) fail(fmt::format("{} instead of {}", in_quotes(keyword), name));
    const NumberType type = read_type();
    return take_numbers(type, count, name);
  }

  /// Skips lines up to an empty one.
  void skip_metadata() {
    while (scanner_.next_line()) {
      if (scanner_.word().empty()) return;
    }
  }

  bool read_attribute(std::string_view keyword) {
    const auto is = [keyword](std::string_view name) { return equals_ignoring_case(keyword, name); };
    if (is("FIELD")) return read_field();
    if (is("SCALARS")) return read_scalars();
    const std::string name(scanner_.word());
    if (is("LOOKUP_TABLE")) return skip_colours(read_count("the size of a table"), 4);
    if (is("COLOR_SCALARS")) return skip_colours(rows_, read_count("the number of colours"));
    if (is("TEXTURE_COORDINATES")) {
      const std::uint64_t components = read_count("the number of coordinates");
      return read_array(name, scanner_.word(), components);
    }
    for (const Attribute& attribute : kAttributes) {
      if (is(attribute.keyword)) return read_array(name, scanner_.word(), attribute.components, false);
    }
    return leave_the_rest(keyword);
  }

  bool read_scalars() {
    const std::string name(scanner_.word());
    const std::string_view type = scanner_.word();
    const std::string_view stated = scanner_.word();
    const std::int64_t components = stated.empty() ? 1 : scanner_.integer(stated, "the number of components");
    if (components < 1) fail(fmt::format("{} components", components));
    // The line of the lookup table is skipped. In files without it, numbers follow.
    TextScanner ahead = scanner_;
    if (equals_ignoring_case(ahead.word_anywhere(), "LOOKUP_TABLE")) {
      ahead.word();
      scanner_ = ahead;
    }
    return read_array(name, type, static_cast<std::uint64_t>(components));
  }

  /// Colours are single bytes in binary and numbers from 0 to 1 in text.
  bool skip_colours(std::uint64_t rows, std::uint64_t components) {
    take_rows(NumberType::kUint8, rows, components, "a table of colours");
    return true;
  }

  bool read_field() {
    scanner_.word();  // name
    const std::uint64_t arrays = read_count("the number of arrays");
    for (std::uint64_t i = 0; i < arrays; ++i) {
      std::string_view word = scanner_.word_anywhere();
      if (equals_ignoring_case(word, "METADATA")) {
        skip_metadata();
        word = scanner_.word_anywhere();
      }
      const std::string name(word);
      const std::uint64_t components = read_count("the number of components");
      const std::uint64_t rows = read_count("the number of rows");
      const std::uint64_t rows_before = rows_;
      // Outside point and cell data, arrays of a field have any number of rows and are no tags.
      const bool may_be_tags = in_cell_data_ && rows == rows_before;
      rows_ = rows;
      const bool go_on = read_array(name, scanner_.word(), components, may_be_tags);
      rows_ = rows_before;
      if (!go_on) return false;
    }
    return true;
  }

  bool read_array(const std::string& name, std::string_view type_name, std::uint64_t components,
                  bool may_be_tags = true) {
    const std::string shown = in_quotes(name);
    if (equals_ignoring_case(type_name, "bit")) {
      if (is_binary_) {
        take_numbers(NumberType::kUint8, (rows_ * components + 7) / 8, shown.c_str());
      } else {
        take_rows(NumberType::kUint8, rows_, components, shown.c_str());
      }
      return true;
    }
    const std::optional<NumberType> type = type_named(kVtkTypeNames, type_name, equals_ignoring_case);
    if (!type) return leave_the_rest(type_name);
    const VtkNumbers numbers = take_rows(*type, rows_, components, shown.c_str());
    if (!in_cell_data_ || !may_be_tags) return true;
    const auto rank = vtk_tag_rank(name, *type, components);
    if (!rank || (tags_ && *rank >= tag_rank_)) return true;
    if (rows_ != cell_count_)
      fail(fmt::format("{} of cell data for {}", counted(rows_, "row"), counted(cell_count_, "cell")));
    tags_ = numbers;
    tag_rank_ = *rank;
    return true;
  }

  /// Data that cannot be skipped, such as strings, are harmless if the mesh is complete.
  bool leave_the_rest(std::string_view word) {
    if (!points_ || !connectivity_ || !types_)
      fail(fmt::format("{} is not a known keyword", in_quotes(word)), Remedy::kExportAgain);
    builder_.warn(WarningKind::kSkippedData, here(),
                  fmt::format("{} is not known, and data after it are ignored", in_quotes(word)));
    return false;
  }

  void add_points() {
    builder_.reserve_vertices(point_count_);
    for (std::uint64_t i = 0; i < point_count_; ++i) {
      Vector3 position;
      for (double& coordinate : position) coordinate = points_->stream.real(points_->type, "a coordinate");
      builder_.add_vertex(position, points_->stream.place("point", i));
    }
  }

  const InputFile* file_;
  TextScanner scanner_;
  CellBuilder& builder_;
  bool is_binary_ = false, new_cells_ = false, in_cell_data_ = false;
  std::uint64_t point_count_ = 0, cell_count_ = 0, type_count_ = 0;
  std::uint64_t rows_ = 0;  ///< of the current point or cell data
  std::optional<VtkNumbers> points_, connectivity_, ends_, types_, tags_;
  std::size_t tag_rank_ = 0;
};

}  // namespace

Place read_vtk(const InputFile& file, CellBuilder& builder) {
  VtkReader(file, builder).read();
  return {};
}

}  // namespace crossgrain
