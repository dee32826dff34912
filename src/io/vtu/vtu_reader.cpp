// SPDX-License-Identifier: Apache-2.0
#include "io/vtu/vtu_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "io/vtu/xml_tags.hpp"

namespace crossgrain {
namespace {

/// More than any header needs that lists some dozens of arrays.
constexpr std::size_t kLongestHeader = 1 << 20;

constexpr std::string_view kDataTag = "<AppendedData";

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t value = 0;
  const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

VtuFile::VtuFile(const std::filesystem::path& path) : name_(path.string()) {
  struct stat status {};
  if (::stat(name_.c_str(), &status) != 0) fail(std::generic_category().message(errno), Remedy::kCheckPath);
  if (!S_ISREG(status.st_mode)) fail("is not a regular file", Remedy::kGiveFieldFolder);
  file_bytes_ = static_cast<std::uint64_t>(status.st_size);
  descriptor_ = ::open(name_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(std::generic_category().message(errno), Remedy::kAllowReading);
  try {
    parse_header(read_header());
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

VtuFile::~VtuFile() {
  ::close(descriptor_);
}

void VtuFile::fail(const std::string& text, Remedy remedy) const {
  throw Error(ErrorKind::kInput, {name_, "", text, remedy});
}

void VtuFile::read_at(std::uint64_t offset, void* out, std::size_t bytes) const {
  auto* to = static_cast<char*>(out);
  while (bytes > 0) {
    const ssize_t got = ::pread(descriptor_, to, bytes, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot be read: " + std::generic_category().message(errno) + "", Remedy::kCheckDisk);
    if (got == 0) fail("is cut short", Remedy::kCopyOrSolveAgain);
    to += got;
    offset += static_cast<std::uint64_t>(got);
    bytes -= static_cast<std::size_t>(got);
  }
}

std::string VtuFile::read_header() const {
  std::string header(std::min<std::uint64_t>(file_bytes_, kLongestHeader), '\0');
  read_at(0, header.data(), header.size());
  const std::size_t data_tag = header.find(kDataTag);
  const std::size_t mark = data_tag == std::string::npos ? data_tag : header.find('_', data_tag);
  if (mark == std::string::npos)
    fail("is no field written by crossgrain (it has no appended data), or is cut short", Remedy::kSolveAgain);
  header.resize(mark + 1);
  return header;
}

void VtuFile::parse_header(const std::string& header) {
  const char* const kForeign = "is no field written by crossgrain";
  data_begin_ = header.size();
  XmlTags tags(header);
  std::optional<VtuSection> section;
  bool has_layout = false, has_piece = false, is_raw = false;
  while (const auto tag = tags.next()) {
    if (tag->name == "VTKFile") {
      has_layout = tag->attribute("type") == "UnstructuredGrid" &&
                   tag->attribute("byte_order") == "LittleEndian" &&
                   tag->attribute("header_type") == "UInt64" &&
                   tag->attribute("compressor") == "vtkZLibDataCompressor";
    } else if (tag->name == "Piece") {
      const auto points = parse_count(tag->attribute("NumberOfPoints"));
      const auto cells = parse_count(tag->attribute("NumberOfCells"));
      if (!points || !cells || has_piece) fail(kForeign, Remedy::kGiveFieldFolder);
      points_ = *points;
      cells_ = *cells;
      has_piece = true;
    } else if (tag->name == "AppendedData") {
      is_raw = tag->attribute("encoding") == "raw";
    } else if (tag->name == "DataArray") {
      const auto type = vtu_type_named(tag->attribute("type"));
      const auto offset = parse_count(tag->attribute("offset"));
      // One component is what VTK takes where none is stated.
      const std::string_view stated = tag->attribute("NumberOfComponents");
      const auto components = parse_count(stated.empty() ? "1" : stated);
      if (!section || !type || !offset || !components || *components == 0 || *components > file_bytes_)
        fail(kForeign, Remedy::kGiveFieldFolder);
      arrays_.push_back({*section, std::string(tag->attribute("Name")), *type, *components, *offset});
    } else if (const auto opened = vtu_section_named(tag->name)) {
      section = opened;
    }
  }
  if (!has_layout || !has_piece || !is_raw) fail(kForeign, Remedy::kGiveFieldFolder);
}

const VtuFile::Array* VtuFile::find(VtuSection section, std::string_view name) const {
  const auto found = std::find_if(arrays_.begin(), arrays_.end(), [&](const Array& array) {
    return array.section == section && array.name == name;
  });
  return found == arrays_.end() ? nullptr : &*found;
}

const VtuFile::Array& VtuFile::require(VtuSection section, std::string_view name, VtuType type,
                                       std::size_t components) const {
  const Array* array = find(section, name);
  if (array == nullptr)
    fail(fmt::format("has no array '{}' in {}", name, name_of(section)), Remedy::kGiveFieldFolder);
  if (array->type != type || array->components != components)
    fail(fmt::format("array '{}' holds {} x {} where {} x {} should be", name, array->components,
                     info_of(array->type).name, components, info_of(type).name),
         Remedy::kSolveAgain);
  return *array;
}

ZlibBlocks VtuFile::locate(const Array& array) const {
  const auto check = [&](bool sound) {
    if (!sound)
      fail(fmt::format("array '{}' is damaged or cut short", array.name), Remedy::kCopyOrSolveAgain);
  };
  constexpr std::uint64_t kWord = sizeof(std::uint64_t);
  const std::uint64_t data_bytes = file_bytes_ - data_begin_;
  check(array.offset <= data_bytes && data_bytes - array.offset >= 3 * kWord);
  std::array<std::uint64_t, 3> head;  // blocks, bytes of a block, bytes of a shorter last block
  read_at(data_begin_ + array.offset, head.data(), sizeof head);
  const std::uint64_t count = head[0];
  check(count <= (data_bytes - array.offset - 3 * kWord) / kWord);
  std::vector<std::uint64_t> sizes(count);
  const std::uint64_t sizes_begin = data_begin_ + array.offset + 3 * kWord;
  read_at(sizes_begin, sizes.data(), count * kWord);
  std::optional<ZlibBlocks> blocks = zlib_blocks(head, sizes, sizes_begin + count * kWord, file_bytes_);
  check(blocks.has_value());

  const std::uint64_t row_bytes = array.components * info_of(array.type).bytes;
  check(blocks->raw_bytes % row_bytes == 0);
  const std::uint64_t rows = blocks->raw_bytes / row_bytes;
  if (array.section == VtuSection::kPoints || array.section == VtuSection::kPointData) check(rows == points_);
  if (array.section == VtuSection::kCellData) check(rows == cells_);
  // All blocks but the last claim one size, for which memory will be taken.
  if (blocks->count() > 0) {
    std::vector<unsigned char> first(blocks->begins[1] - blocks->begins[0]);
    read_at(blocks->begins[0], first.data(), first.size());
    std::string inflated;
    check(inflate_onto(inflated, first, blocks->raw_size(0)));
  }
  return std::move(*blocks);
}

void VtuFile::inflate(const Array& array, const ZlibBlocks& blocks, char* out) const {
  std::atomic<bool> sound{true};
  parallel_for(
      blocks.count(),
      [&](std::size_t i) {
        std::vector<unsigned char> compressed(blocks.begins[i + 1] - blocks.begins[i]);
        read_at(blocks.begins[i], compressed.data(), compressed.size());
        if (!inflate_block(compressed, out + blocks.raw_begin(i), blocks.raw_size(i))) sound = false;
      },
      1);
  if (!sound)
    fail(fmt::format("array '{}' is damaged: its blocks do not inflate", array.name),
         Remedy::kCopyOrSolveAgain);
}

}  // namespace crossgrain
