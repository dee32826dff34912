// SPDX-License-Identifier: Apache-2.0
// Reads cells from VTK XML files of unstructured grids (.vtu) of any writer.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_files/cells/cell_builder.hpp"
#include "mesh_files/cells/cell_reader.hpp"
#include "mesh_files/cells/vtk_cells.hpp"
#include "text/text_scanner.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_header.hpp"

namespace crossgrain {
namespace {

using DataArray = VtuHeader::Array;

class VtuCellReader {
 public:
  VtuCellReader(const InputFile& file, CellBuilder& builder) : file_(&file), builder_(builder) {}

  void read() {
    read_header();
    if (const DataArray* schema = header_.find(VtuSection::kFieldData, field_arrays::kSchema))
      fail(schema->begin, "a frame field written by crossgrain, not a mesh", Remedy::kGiveModel);
    if (header_.cells == 0)
      fail(file_->bytes().size(), "<Piece> with cells is missing: cut short, or empty", Remedy::kExportAgain);
    add_points();
    add_cells();
  }

 private:
  /// Returns the line of a byte of the XML.
  [[noreturn]] void fail(std::size_t position, const std::string& text,
                         Remedy remedy = Remedy::kRepairFile) const {
    fail_input(*file_, at_line(line_of(position)), text, remedy);
  }

  std::size_t line_of(std::size_t position) const {
    const std::string_view before = file_->bytes().substr(0, position);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  }

  void read_header() {
    try {
      header_ = read_vtu_header(file_->bytes());
    } catch (const VtuHeaderFault& fault) {
      fail(fault.position, fault.text, fault.remedy);
    }
    if (!header_.appended) return;
    appended_ = file_->bytes().substr(header_.appended->begin);
    if (header_.appended->is_base64) appended_ = appended_.substr(0, appended_.find('<'));
  }

  /// Returns the array of a name, or the first of the section if the name is empty.
  const DataArray& require(VtuSection section, std::string_view name) const {
    const DataArray* array = header_.find(section, name);
    if (array == nullptr)
      fail_input(*file_, {},
                 fmt::format("the array {} is missing in {}: cut short, or not a mesh",
                             name.empty() ? "of coordinates" : in_quotes(name), name_of(section)));
    return *array;
  }

  /// Returns the numbers of an array; checks that there are `count` if that is given. Decompressed bytes are
  /// kept as long as the reader.
  VtkNumbers numbers(const DataArray& array, std::optional<std::uint64_t> count) {
    if (array.format == "ascii" || array.format.empty()) {
      const TextScanner scanner(*file_, {}, array.begin, line_of(array.begin), array.end);
      const VtkNumbers numbers{NumberStream(scanner), array.type};
      if (count && *count > numbers.stream.most_left(array.type))
        fail(array.begin,
             fmt::format("array {} should have {} in its {}: cut short, or damaged", in_quotes(array.name),
                         counted(*count, "number"), counted(array.end - array.begin, "byte")),
             Remedy::kCopyAgain);
      return numbers;
    }
    auto bytes = unpack(array);
    if (!bytes)
      fail_input(*file_, {}, fmt::format("array {} is damaged or cut short", in_quotes(array.name)),
                 Remedy::kCopyAgain);
    if (bytes->size() % size_of(array.type) != 0 || (count && *count != bytes->size() / size_of(array.type)))
      fail_input(*file_, {},
                 fmt::format("array {} has {} instead of {}", in_quotes(array.name),
                             counted(bytes->size() / size_of(array.type), "number"), count.value_or(0)));
    unpacked_.push_back(std::make_unique<std::string>(std::move(*bytes)));
    return {NumberStream(*file_, array.name, *unpacked_.back(), header_.package.is_swapped), array.type};
  }

  std::optional<std::string> unpack(const DataArray& array) const {
    const std::string_view bytes = file_->bytes();
    if (array.format == "binary")
      return unpack_vtu_data(file_->name(), bytes.substr(array.begin, array.end - array.begin), true,
                             header_.package);
    if (array.format != "appended" || !header_.appended || array.offset > appended_.size())
      return std::nullopt;
    return unpack_vtu_data(file_->name(), appended_.substr(array.offset), header_.appended->is_base64,
                           header_.package);
  }

  void add_points() {
    const DataArray& array = require(VtuSection::kPoints, "");
    if (array.components != 3)
      fail(array.begin, fmt::format("points of {}, not 3", counted(array.components, "coordinate")));
    if (header_.points > file_->bytes().size() * kMostNumbersAByte / 3)
      fail(array.begin, fmt::format("{} points are more than the file can hold", header_.points),
           Remedy::kCopyAgain);
    VtkNumbers points = numbers(array, 3 * header_.points);
    builder_.reserve_vertices(header_.points);
    for (std::uint64_t i = 0; i < header_.points; ++i) {
      Vector3 position;
      for (double& coordinate : position) coordinate = points.stream.real(points.type, "a coordinate");
      builder_.add_vertex(position, points.stream.place("point", i));
    }
    unpacked_.clear();
  }

  void add_cells() {
    VtkCells cells{header_.cells, numbers(require(VtuSection::kCells, "connectivity"), std::nullopt),
                   numbers(require(VtuSection::kCells, "offsets"), header_.cells),
                   numbers(require(VtuSection::kCells, "types"), header_.cells), std::nullopt};
    if (const DataArray* tags = find_tags()) cells.tags = numbers(*tags, header_.cells);
    add_vtk_cells(std::move(cells), builder_);
  }

  const DataArray* find_tags() const {
    const DataArray* best = nullptr;
    std::size_t best_rank = 0;
    for (const DataArray& array : header_.arrays) {
      if (array.section != VtuSection::kCellData) continue;
      const auto rank = vtk_tag_rank(array.name, array.type, array.components);
      if (!rank || (best != nullptr && *rank >= best_rank)) continue;
      best = &array;
      best_rank = *rank;
    }
    return best;
  }

  /// Zlib compresses at most a thousand bytes into one, and a number takes at least one byte.
  static constexpr std::uint64_t kMostNumbersAByte = 1040;

  const InputFile* file_;
  CellBuilder& builder_;
  VtuHeader header_;
  std::string_view appended_;
  std::vector<std::unique_ptr<std::string>> unpacked_;
};

}  // namespace

Place read_vtu(const InputFile& file, CellBuilder& builder) {
  VtuCellReader(file, builder).read();
  return {};
}

}  // namespace crossgrain
