// SPDX-License-Identifier: Apache-2.0
#include "vtu/vtu_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

/// More than any header with some dozens of arrays needs.
constexpr std::size_t kLongestHeader = 1 << 20;

/// Far more than the writer puts into a block; larger ones could not be stopped in time.
constexpr std::uint64_t kLargestBlock = std::uint64_t{1} << 26;

}  // namespace

VtuFile::VtuFile(const std::filesystem::path& path) : name_(path.string()) {
  struct stat status {};
  if (::stat(name_.c_str(), &status) != 0) fail(std::generic_category().message(errno), Remedy::kCheckPath);
  if (!S_ISREG(status.st_mode)) fail("is not a regular file", Remedy::kGiveFieldFolder);
  file_bytes_ = static_cast<std::uint64_t>(status.st_size);
  descriptor_ = Descriptor(::open(name_.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor_.is_open()) fail(std::generic_category().message(errno), Remedy::kAllowReading);
  parse_header(read_header());
}

void VtuFile::fail(const std::string& text, Remedy remedy) const {
  throw Error(ErrorKind::kInput, {name_, "", text, remedy});
}

void VtuFile::read_at(std::uint64_t offset, void* out, std::size_t bytes) const {
  auto* to = static_cast<char*>(out);
  while (bytes > 0) {
    const ssize_t got = ::pread(descriptor_.number(), to, bytes, static_cast<off_t>(offset));
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
  const std::size_t data_tag = header.find(kVtuDataTag);
  const std::size_t mark = data_tag == std::string::npos ? data_tag : header.find('_', data_tag);
  if (mark == std::string::npos)
    fail("is not a field written by crossgrain (it has no appended data), or is cut short",
         Remedy::kSolveAgain);
  header.resize(mark + 1);
  return header;
}

void VtuFile::parse_header(const std::string& text) {
  const auto fail_foreign = [&] { fail("is not a field written by crossgrain", Remedy::kGiveFieldFolder); };
  try {
    header_ = read_vtu_header(text);
  } catch (const VtuHeaderFault&) {
    fail_foreign();
  }
  const VtuPackage& package = header_.package;
  if (!package.is_compressed || package.is_swapped || package.header_type != NumberType::kUint64 ||
      !header_.appended || header_.appended->is_base64)
    fail_foreign();
  for (const Array& array : header_.arrays) {
    if (array.format != "appended" || array.components == 0 || array.components > file_bytes_) fail_foreign();
  }
}

const VtuFile::Array& VtuFile::require(VtuSection section, std::string_view name, NumberType type,
                                       std::size_t components) const {
  const Array* array = find(section, name);
  if (array == nullptr)
    fail(fmt::format("has no array '{}' in {}", name, name_of(section)), Remedy::kGiveFieldFolder);
  if (array->type != type || array->components != components)
    fail(fmt::format("array '{}' holds {} x {} instead of {} x {}", name, array->components,
                     vtu_name_of(array->type), components, vtu_name_of(type)),
         Remedy::kSolveAgain);
  return *array;
}

std::vector<Vector3> VtuFile::read_points(double limit) const {
  const Array& array = require(VtuSection::kPoints, "Points", NumberType::kFloat64, 3);
  const ZlibBlocks blocks = locate(array);
  std::vector<Vector3> points(blocks.raw_bytes / sizeof(Vector3));
  inflate(array, blocks, reinterpret_cast<char*>(points.data()));
  for (const Vector3& point : points) {
    for (const double coordinate : point) {
      if (!(std::abs(coordinate) < limit))
        fail(fmt::format("a point has a coordinate {}", coordinate), Remedy::kCopyAgain);
    }
  }
  return points;
}

bool VtuFile::has_wide_indices() const {
  const Array* offsets = find(VtuSection::kCells, "offsets");
  return offsets != nullptr && offsets->type == NumberType::kInt64;
}

ZlibBlocks VtuFile::locate(const Array& array) const {
  const auto check = [&](bool sound) {
    if (!sound)
      fail(fmt::format("array '{}' is damaged or cut short", array.name), Remedy::kCopyOrSolveAgain);
  };
  constexpr std::uint64_t kWord = sizeof(std::uint64_t);
  const std::uint64_t data_begin = header_.appended->begin, data_bytes = file_bytes_ - data_begin;
  check(array.offset <= data_bytes && data_bytes - array.offset >= 3 * kWord);
  std::array<std::uint64_t, 3> head;  // blocks, bytes of a block, bytes of a shorter last block
  read_at(data_begin + array.offset, head.data(), sizeof head);
  const std::uint64_t count = head[0];
  check(count <= (data_bytes - array.offset - 3 * kWord) / kWord);
  std::vector<std::uint64_t> sizes(count);
  const std::uint64_t sizes_begin = data_begin + array.offset + 3 * kWord;
  read_at(sizes_begin, sizes.data(), count * kWord);
  std::optional<ZlibBlocks> blocks = zlib_blocks(head, sizes, sizes_begin + count * kWord, file_bytes_);
  check(blocks.has_value() && blocks->block_bytes <= kLargestBlock);

  const std::uint64_t row_bytes = array.components * size_of(array.type);
  check(blocks->raw_bytes % row_bytes == 0);
  const std::uint64_t rows = blocks->raw_bytes / row_bytes;
  if (array.section == VtuSection::kPoints || array.section == VtuSection::kPointData)
    check(rows == header_.points);
  if (array.section == VtuSection::kCellData) check(rows == header_.cells);
  require_read_memory(name_, static_cast<double>(blocks->raw_bytes));
  // All blocks but the last claim one size, and memory is allocated for it.
  if (blocks->count() > 0) {
    std::vector<unsigned char> first(blocks->begins[1] - blocks->begins[0]);
    read_at(blocks->begins[0], first.data(), first.size());
    std::string inflated;
    check(inflate_onto(name_, inflated, first, blocks->raw_size(0)));
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
