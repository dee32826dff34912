// SPDX-License-Identifier: Apache-2.0
#include "archives/zip_archive.hpp"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <utility>

#include "base/ignoring_case.hpp"
#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

/// The bytes of a file, as minizip reads them.
struct BytesInMemory {
  std::string_view bytes;
  std::uint64_t position = 0;
};

BytesInMemory& memory(void* stream) {
  return *static_cast<BytesInMemory*>(stream);
}

uLong read_memory(void*, void* stream, void* out, uLong size) {
  BytesInMemory& from = memory(stream);
  const auto count = std::min<std::uint64_t>(size, from.bytes.size() - from.position);
  std::memcpy(out, from.bytes.data() + from.position, count);
  from.position += count;
  return static_cast<uLong>(count);
}

long seek_memory(void*, void* stream, ZPOS64_T offset, int origin) {
  BytesInMemory& from = memory(stream);
  const std::uint64_t begin = origin == SEEK_SET ? 0 : origin == SEEK_CUR ? from.position : from.bytes.size();
  if (offset > from.bytes.size() - begin) return -1;
  from.position = begin + offset;
  return 0;
}

zlib_filefunc64_def functions_for(BytesInMemory& bytes) {
  zlib_filefunc64_def functions{};
  functions.opaque = &bytes;
  functions.zopen64_file = [](void* opaque, const void*, int) { return opaque; };
  functions.zread_file = read_memory;
  functions.zwrite_file = [](void*, void*, const void*, uLong) -> uLong { return 0; };
  functions.ztell64_file = [](void*, void* stream) -> ZPOS64_T { return memory(stream).position; };
  functions.zseek64_file = seek_memory;
  functions.zclose_file = [](void*, void*) { return 0; };
  functions.zerror_file = [](void*, void*) { return 0; };
  return functions;
}

struct Close {
  void operator()(void* archive) const { unzClose(archive); }
};

std::string in_lower_case(std::string_view name) {
  std::string result(name);
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

}  // namespace

struct ZipArchive::Directory {
  BytesInMemory bytes;
  zlib_filefunc64_def functions;
  std::unique_ptr<void, Close> archive;
  std::map<std::string, unz64_file_pos, std::less<>> members;  ///< by names in lower case, the first of each
};

ZipArchive::ZipArchive(const InputFile& file) : file_(file), directory_(std::make_unique<Directory>()) {
  directory_->bytes.bytes = file.bytes();
  directory_->functions = functions_for(directory_->bytes);
  directory_->archive.reset(unzOpen2_64("", &directory_->functions));
  void* const archive = directory_->archive.get();
  if (archive == nullptr) {
    const bool begins_so = file.bytes().starts_with("PK");
    fail_input(file, {},
               begins_so ? "is a ZIP archive cut short or damaged: it has no directory of its members"
                         : "is no ZIP archive, as its name says",
               begins_so ? Remedy::kCopyAgain : Remedy::kExportAgain);
  }
  int code = unzGoToFirstFile(archive);
  for (; code == UNZ_OK; code = unzGoToNextFile(archive)) {
    check_watched();
    // Members with longer names are none that a document needs.
    std::array<char, 1 << 10> name{};
    unz64_file_pos place;
    code = unzGetCurrentFileInfo64(archive, nullptr, name.data(), name.size() - 1, nullptr, 0, nullptr, 0);
    if (code == UNZ_OK) code = unzGetFilePos64(archive, &place);
    if (code != UNZ_OK) break;
    directory_->members.emplace(in_lower_case(name.data()), place);
  }
  if (code != UNZ_END_OF_LIST_OF_FILE) fail_input(file, {}, "is a damaged ZIP archive", Remedy::kCopyAgain);
}

ZipArchive::~ZipArchive() = default;

void ZipArchive::fail(std::string_view member, const std::string& text) const {
  throw Error(ErrorKind::kInput, {file_.name(), in_quotes(member), text, Remedy::kCopyAgain});
}

bool ZipArchive::holds(std::string_view name) const {
  return directory_->members.contains(in_lower_case(name));
}

std::string ZipArchive::read(std::string_view name) const {
  constexpr std::size_t kPiece = 1 << 16;
  constexpr uLong kEncrypted = 1;
  const auto found = directory_->members.find(in_lower_case(name));
  if (found == directory_->members.end()) fail(name, "is missing in the archive");
  void* const archive = directory_->archive.get();
  unz_file_info64 info;
  if (unzGoToFilePos64(archive, &found->second) != UNZ_OK ||
      unzGetCurrentFileInfo64(archive, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
    fail(name, "is damaged");
  if ((info.flag & kEncrypted) != 0) fail(name, "is encrypted");
  if (unzOpenCurrentFile(archive) != UNZ_OK)
    fail(name, "is damaged, or packed by another method than deflate");
  std::string out;
  int got = 1;
  while (got > 0) {
    check_watched();
    const std::size_t done = out.size();
    if (done + kPiece > out.capacity()) {
      const std::size_t capacity = std::max(done + kPiece, 2 * out.capacity());
      require_read_memory(file_.name(), static_cast<double>(capacity));
      out.reserve(capacity);
    }
    out.resize(done + kPiece);
    got = unzReadCurrentFile(archive, out.data() + done, static_cast<unsigned>(kPiece));
    out.resize(done + static_cast<std::size_t>(std::max(got, 0)));
  }
  const bool is_whole = got == 0 && out.size() == info.uncompressed_size;
  if (unzCloseCurrentFile(archive) != UNZ_OK || !is_whole) fail(name, "is damaged or cut short");
  return out;
}

}  // namespace crossgrain
