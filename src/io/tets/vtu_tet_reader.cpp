// SPDX-License-Identifier: Apache-2.0
// Tets in VTK XML files of unstructured grids (.vtu), whoever wrote them.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/result/field_arrays.hpp"
#include "io/tets/tet_builder.hpp"
#include "io/tets/tet_reader.hpp"
#include "io/tets/vtk_cells.hpp"
#include "io/text/text_scanner.hpp"
#include "io/vtu/vtu_data.hpp"
#include "io/vtu/vtu_types.hpp"
#include "io/vtu/xml_tags.hpp"

namespace crossgrain {
namespace {

/// An array of the file, not yet looked at.
struct DataArray {
  VtuSection section;
  std::string name;
  NumberType type;
  std::uint64_t components;
  std::string format;      ///< ascii, binary (base64 in place) or appended
  std::uint64_t offset;    ///< of an appended one, from the begin of the appended data
  std::size_t begin, end;  ///< what stands between its tags
};

class VtuTetReader {
 public:
  explicit VtuTetReader(const InputFile& file) : file_(&file), builder_(file) {}

  TetMesh read() {
    read_tags();
    if (!has_grid_) fail(0, "no <VTKFile>: this is no VTK XML file", Remedy::kExportAgain);
    if (!has_piece_)
      fail(file_->bytes().size(), "no <Piece> with cells: cut short, or empty", Remedy::kExportAgain);
    add_points();
    add_cells();
    return builder_.finish({});
  }

 private:
  /// Names the line of a byte that is part of the XML.
  [[noreturn]] void fail(std::size_t position, const std::string& text,
                         Remedy remedy = Remedy::kRepairFile) const {
    fail_input(*file_, at_line(line_of(position)), text, remedy);
  }

  std::size_t line_of(std::size_t position) const {
    const std::string_view before = file_->bytes().substr(0, position);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  }

  /// All tags up to the appended data, which may hold anything.
  void read_tags() {
    XmlTags tags(file_->bytes());
    std::optional<VtuSection> section;
    while (const auto tag = tags.next()) {
      const std::size_t position = tags.position();
      if (tag->name == "VTKFile") {
        read_layout(*tag, position);
      } else if (tag->name == "Piece") {
        read_piece(*tag, position);
      } else if (tag->name == "DataArray") {
        if (section && (*section == VtuSection::kFieldData || takes_arrays_))
          read_array(*section, *tag, position);
      } else if (tag->name == "AppendedData") {
        return read_appended(*tag, position);
      } else if (const auto opened = vtu_section_named(tag->name)) {
        section = opened;
      }
    }
  }

  void read_layout(const XmlTag& tag, std::size_t position) {
    const std::string_view kind = tag.attribute("type");
    if (kind != "UnstructuredGrid")
      fail(position,
           fmt::format("a VTK file of type {}, where tets are in an UnstructuredGrid", in_quotes(kind)),
           Remedy::kExportAgain);
    const bool is_big = tag.attribute("byte_order") == "BigEndian";
    package_.is_swapped = is_big != (std::endian::native == std::endian::big);
    const std::string_view header = tag.attribute("header_type");
    if (header == "UInt64") package_.header_type = NumberType::kUint64;
    if (!header.empty() && header != "UInt64" && header != "UInt32")
      fail(position, fmt::format("headers of type {}, where UInt32 and UInt64 are known", in_quotes(header)));
    const std::string_view compressor = tag.attribute("compressor");
    package_.is_compressed = !compressor.empty();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      fail(position, fmt::format("compressed by {}, where zlib or none is known", in_quotes(compressor)),
           Remedy::kExportAgain);
    has_grid_ = true;
  }

  std::uint64_t read_count(const XmlTag& tag, const char* attribute, std::size_t position,
                           const char* otherwise = "") const {
    std::string_view text = tag.attribute(attribute);
    if (text.empty()) text = otherwise;
    std::uint64_t value = 0;
    const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || stop != text.data() + text.size())
      fail(position, fmt::format("{} is {}, no whole number", attribute, in_quotes(text)));
    return value;
  }

  void read_piece(const XmlTag& tag, std::size_t position) {
    const std::uint64_t points = read_count(tag, "NumberOfPoints", position);
    const std::uint64_t cells = read_count(tag, "NumberOfCells", position);
    takes_arrays_ = cells > 0;
    if (!takes_arrays_) return;
    if (has_piece_)
      fail(position,
           "a second piece with cells, where one is known (in ParaView, Merge Blocks makes one of them)",
           Remedy::kExportAgain);
    has_piece_ = true;
    point_count_ = points;
    cell_count_ = cells;
  }

  void read_array(VtuSection section, const XmlTag& tag, std::size_t position) {
    const std::string name(tag.attribute("Name"));
    if (section == VtuSection::kFieldData && name == field_arrays::kSchema)
      fail(position, "a frame field that crossgrain has written, no mesh", Remedy::kGiveModel);
    const auto type = vtu_type_named(tag.attribute("type"));
    // Of strings, which are for people, there is nothing to tell.
    if (!type) return;
    DataArray array{section, name, *type, 0, std::string(tag.attribute("format")), 0, position, position};
    array.components = read_count(tag, "NumberOfComponents", position, "1");
    if (array.format == "appended") {
      array.offset = read_count(tag, "offset", position);
    } else {
      array.end = file_->bytes().find('<', position);
      if (array.end == std::string_view::npos)
        fail(position, fmt::format("array {} has no end: cut short", in_quotes(name)), Remedy::kCopyAgain);
    }
    arrays_.push_back(std::move(array));
  }

  void read_appended(const XmlTag& tag, std::size_t position) {
    const std::string_view encoding = tag.attribute("encoding");
    appended_base64_ = encoding == "base64";
    if (!appended_base64_ && encoding != "raw")
      fail(position, fmt::format("appended data in {}, where raw and base64 are known", in_quotes(encoding)));
    const std::size_t mark = file_->bytes().find('_', position);
    if (mark == std::string_view::npos)
      fail(position, "no '_' before the appended data: cut short", Remedy::kCopyAgain);
    appended_ = file_->bytes().substr(mark + 1);
    if (appended_base64_) appended_ = appended_.substr(0, appended_.find('<'));
  }

  const DataArray* find(VtuSection section, std::string_view name) const {
    const auto found = std::find_if(arrays_.begin(), arrays_.end(), [&](const DataArray& array) {
      return array.section == section && (name.empty() || array.name == name);
    });
    return found == arrays_.end() ? nullptr : &*found;
  }

  /// By its name, or the first of the section where that is empty.
  const DataArray& require(VtuSection section, std::string_view name) const {
    const DataArray* array = find(section, name);
    if (array == nullptr)
      fail_input(*file_, {},
                 fmt::format("no array {} in {}: cut short, or no mesh",
                             name.empty() ? "of coordinates" : in_quotes(name), name_of(section)));
    return *array;
  }

  /// The numbers of an array, `count` of them where that is given. Unpacked bytes are kept for as long as the
  /// reader lives.
  VtkNumbers numbers(const DataArray& array, std::optional<std::uint64_t> count) {
    if (array.format == "ascii" || array.format.empty()) {
      const TextScanner scanner(*file_, {}, array.begin, line_of(array.begin), array.end);
      const VtkNumbers numbers{NumberStream(scanner), array.type};
      if (count && *count > numbers.stream.most_left(array.type))
        fail(array.begin,
             fmt::format("array {} should have {} numbers, but only {} bytes are here: cut short, or damaged",
                         in_quotes(array.name), *count, array.end - array.begin),
             Remedy::kCopyAgain);
      return numbers;
    }
    auto bytes = unpack(array);
    if (!bytes)
      fail_input(*file_, {}, fmt::format("array {} is damaged or cut short", in_quotes(array.name)),
                 Remedy::kCopyAgain);
    if (bytes->size() % size_of(array.type) != 0 || (count && *count != bytes->size() / size_of(array.type)))
      fail_input(*file_, {},
                 fmt::format("array {} has {} numbers where {} should be", in_quotes(array.name),
                             bytes->size() / size_of(array.type), count.value_or(0)));
    unpacked_.push_back(std::make_unique<std::string>(std::move(*bytes)));
    return {NumberStream(*file_, array.name, *unpacked_.back(), package_.is_swapped), array.type};
  }

  std::optional<std::string> unpack(const DataArray& array) const {
    const std::string_view bytes = file_->bytes();
    if (array.format == "binary")
      return unpack_vtu_data(bytes.substr(array.begin, array.end - array.begin), true, package_);
    if (array.format != "appended" || array.offset > appended_.size()) return std::nullopt;
    return unpack_vtu_data(appended_.substr(array.offset), appended_base64_, package_);
  }

  void add_points() {
    const DataArray& array = require(VtuSection::kPoints, "");
    if (array.components != 3)
      fail(array.begin, fmt::format("points of {} coordinates, not 3", array.components));
    if (point_count_ > file_->bytes().size() * kMostNumbersAByte / 3)
      fail(array.begin, fmt::format("{} points are more than the file can hold", point_count_),
           Remedy::kCopyAgain);
    VtkNumbers points = numbers(array, 3 * point_count_);
    builder_.reserve_vertices(point_count_);
    for (std::uint64_t i = 0; i < point_count_; ++i) {
      Vector3 position;
      for (double& coordinate : position) coordinate = points.stream.real(points.type, "a coordinate");
      builder_.add_vertex(position, points.stream.place("point", i));
    }
    unpacked_.clear();
  }

  void add_cells() {
    VtkCells cells{cell_count_, numbers(require(VtuSection::kCells, "connectivity"), std::nullopt),
                   numbers(require(VtuSection::kCells, "offsets"), cell_count_),
                   numbers(require(VtuSection::kCells, "types"), cell_count_), std::nullopt};
    if (const DataArray* tags = find_tags()) cells.tags = numbers(*tags, cell_count_);
    add_vtk_cells(std::move(cells), builder_);
  }

  const DataArray* find_tags() const {
    const DataArray* best = nullptr;
    std::size_t best_rank = 0;
    for (const DataArray& array : arrays_) {
      if (array.section != VtuSection::kCellData) continue;
      const auto rank = vtk_tag_rank(array.name, array.type, array.components);
      if (!rank || (best != nullptr && *rank >= best_rank)) continue;
      best = &array;
      best_rank = *rank;
    }
    return best;
  }

  /// Zlib packs a thousand bytes into one, and a number takes one at least.
  static constexpr std::uint64_t kMostNumbersAByte = 1040;

  const InputFile* file_;
  TetBuilder builder_;
  VtuPackage package_;
  bool has_grid_ = false, has_piece_ = false, takes_arrays_ = false, appended_base64_ = false;
  std::uint64_t point_count_ = 0, cell_count_ = 0;
  std::vector<DataArray> arrays_;
  std::string_view appended_;
  std::vector<std::unique_ptr<std::string>> unpacked_;
};

}  // namespace

TetMesh read_vtu_tets(const InputFile& file) {
  return VtuTetReader(file).read();
}

}  // namespace crossgrain
