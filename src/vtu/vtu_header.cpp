// SPDX-License-Identifier: Apache-2.0
#include "vtu/vtu_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <utility>

#include "base/parallel.hpp"
#include "files/input_file.hpp"
#include "vtu/xml_tags.hpp"

namespace crossgrain {
namespace {

[[noreturn]] void fail(std::size_t position, std::string text, Remedy remedy = Remedy::kRepairFile) {
  throw VtuHeaderFault{position, std::move(text), remedy};
}

class VtuHeaderReader {
 public:
  explicit VtuHeaderReader(std::string_view text) : text_(text) {}

  VtuHeader read() {
    read_tags();
    if (!has_grid_) fail(0, "no <VTKFile>: this is not a VTK XML file", Remedy::kExportAgain);
    if (!has_piece_)
      fail(text_.size(), "<Piece> with cells is missing: cut short, or empty", Remedy::kExportAgain);
    return std::move(header_);
  }

 private:
  void read_tags() {
    XmlTags tags(text_);
    std::optional<VtuSection> section;
    Checkpoint checkpoint;
    while (const auto tag = tags.next()) {
      checkpoint.pass();
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
    if (tags.malformed()) fail(tags.position(), "not XML, or cut short inside a tag", Remedy::kCopyAgain);
  }

  void read_layout(const XmlTag& tag, std::size_t position) {
    const std::string_view kind = tag.attribute("type");
    if (kind != "UnstructuredGrid")
      fail(position,
           fmt::format("a VTK file of type {}, but tets must be in an UnstructuredGrid", in_quotes(kind)),
           Remedy::kExportAgain);
    VtuPackage& package = header_.package;
    const std::string_view order = tag.attribute("byte_order");
    if (!order.empty() && order != "BigEndian" && order != "LittleEndian")
      fail(position, fmt::format("the byte order {} is not LittleEndian or BigEndian", in_quotes(order)),
           Remedy::kExportAgain);
    const bool is_big = order == "BigEndian";
    package.is_swapped = is_big != (std::endian::native == std::endian::big);
    const std::string_view header = tag.attribute("header_type");
    if (header == "UInt64") package.header_type = NumberType::kUint64;
    if (!header.empty() && header != "UInt64" && header != "UInt32")
      fail(position, fmt::format("headers of type {}, but must be UInt32 or UInt64", in_quotes(header)));
    const std::string_view compressor = tag.attribute("compressor");
    package.is_compressed = !compressor.empty();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
      fail(position, fmt::format("compressed by {}, but only zlib can be read", in_quotes(compressor)),
           Remedy::kExportAgain);
    has_grid_ = true;
  }

  static std::uint64_t read_count(const XmlTag& tag, const char* attribute, std::size_t position,
                                  const char* otherwise = "") {
    std::string_view text = tag.attribute(attribute);
    if (text.empty()) text = otherwise;
    std::uint64_t value = 0;
    const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || stop != text.data() + text.size())
      fail(position, fmt::format("{} is {}, not a whole number", attribute, in_quotes(text)));
    return value;
  }

  /// Parallel writers leave pieces without cells. Only the first of these counts, and only if no piece has
  /// cells.
  void read_piece(const XmlTag& tag, std::size_t position) {
    const std::uint64_t points = read_count(tag, "NumberOfPoints", position);
    const std::uint64_t cells = read_count(tag, "NumberOfCells", position);
    takes_arrays_ = cells > 0 || !has_piece_;
    if (!takes_arrays_) return;
    if (header_.cells > 0)
      fail(position, "a second piece with cells; merge the pieces into one grid (in ParaView: Merge Blocks)",
           Remedy::kNone);
    std::erase_if(header_.arrays,
                  [](const VtuHeader::Array& array) { return array.section != VtuSection::kFieldData; });
    has_piece_ = true;
    header_.points = points;
    header_.cells = cells;
  }

  void read_array(VtuSection section, const XmlTag& tag, std::size_t position) {
    const std::string name(tag.attribute("Name"));
    const auto type = type_named(kVtuTypeNames, tag.attribute("type"));
    // Arrays of strings are ignored.
    if (!type) return;
    VtuHeader::Array array{section, name,     *type,   0, std::string(tag.attribute("format")),
                           0,       position, position};
    array.components = read_count(tag, "NumberOfComponents", position, "1");
    if (array.format == "appended") {
      array.offset = read_count(tag, "offset", position);
    } else {
      array.end = text_.find('<', position);
      if (array.end == std::string_view::npos)
        fail(position, fmt::format("array {} has no end: cut short", in_quotes(name)), Remedy::kCopyAgain);
    }
    header_.arrays.push_back(std::move(array));
  }

  void read_appended(const XmlTag& tag, std::size_t position) {
    const std::string_view encoding = tag.attribute("encoding");
    if (encoding != "base64" && encoding != "raw")
      fail(position, fmt::format("appended data in {}, but must be raw or base64", in_quotes(encoding)));
    const std::size_t mark = text_.find('_', position);
    if (mark == std::string_view::npos)
      fail(position, "no '_' before the appended data: cut short", Remedy::kCopyAgain);
    header_.appended = {mark + 1, encoding == "base64"};
  }

  std::string_view text_;
  VtuHeader header_;
  bool has_grid_ = false, has_piece_ = false, takes_arrays_ = false;
};

}  // namespace

const VtuHeader::Array* VtuHeader::find(VtuSection section, std::string_view name) const {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const Array& array) {
    return array.section == section && (name.empty() || array.name == name);
  });
  return found == arrays.end() ? nullptr : &*found;
}

VtuHeader read_vtu_header(std::string_view text) {
  return VtuHeaderReader(text).read();
}

}  // namespace crossgrain
