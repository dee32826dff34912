// SPDX-License-Identifier: Apache-2.0
#include "archives/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "base/ignoring_case.hpp"
#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

constexpr std::string_view kExtension = ".gz", kMagic = "\x1f\x8b";

bool is_packed(const std::filesystem::path& path) {
  return equals_ignoring_case(path.extension().string(), kExtension);
}

/// Bytes that grow with what is written.
class GrowingBytes {
 public:
  explicit GrowingBytes(const std::string& name) : name_(name) { grow(kFirst); }

  /// Room behind the bytes so far, never empty.
  std::pair<char*, std::size_t> room() {
    if (size_ == capacity_) grow(2 * capacity_);
    return {bytes_.get() + size_, capacity_ - size_};
  }
  void add(std::size_t count) { size_ += count; }

  InputFile file() && { return InputFile(name_, std::move(bytes_), size_); }
  std::string_view bytes() const { return {bytes_.get(), size_}; }

 private:
  static constexpr std::size_t kFirst = 1 << 16;

  void grow(std::size_t capacity) {
    require_read_memory(name_, static_cast<double>(capacity));
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    std::copy_n(bytes_.get(), size_, larger.get());
    bytes_ = std::move(larger);
    capacity_ = capacity;
  }

  std::string name_;
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0, capacity_ = 0;
};

class Gunzip {
 public:
  explicit Gunzip(const InputFile& file) : file_(file), rest_(file.bytes()), out_(file.name()) {
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, kGzipOnly) != Z_OK) throw std::bad_alloc();
  }
  ~Gunzip() { inflateEnd(&stream_); }
  Gunzip(const Gunzip&) = delete;
  Gunzip& operator=(const Gunzip&) = delete;

  InputFile unpacked() && {
    if (!rest_.starts_with(kMagic))
      fail_input(file_, {}, "is named .gz, but does not begin like a gzip archive", Remedy::kRename);
    while (rest_.starts_with(kMagic)) unpack_member();
    // Tapes and some programs fill blocks up with zeros.
    if (rest_.find_first_not_of('\0') != std::string_view::npos)
      fail_input(file_, {}, "has other bytes behind its gzip archive", Remedy::kCopyAgain);
    if (out_.bytes().empty()) fail_input(file_, {}, "is a gzip archive of nothing", Remedy::kCopyAgain);
    if (out_.bytes().starts_with(kMagic))
      fail_input(file_, {}, "is packed by gzip twice; unpack it once", Remedy::kNone);
    return std::move(out_).file();
  }

 private:
  void unpack_member() {
    constexpr std::size_t kPiece = 1 << 20;
    inflateReset(&stream_);
    int code = Z_OK;
    while (code == Z_OK) {
      check_watched();
      const std::size_t given = std::min(kPiece, rest_.size());
      const auto [room, room_bytes] = out_.room();
      const std::size_t taken = std::min(kPiece, room_bytes);
      // The interface of zlib lacks const; it does not write to the input.
      stream_.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(rest_.data()));
      stream_.avail_in = static_cast<uInt>(given);
      stream_.next_out = reinterpret_cast<unsigned char*>(room);
      stream_.avail_out = static_cast<uInt>(taken);
      code = inflate(&stream_, Z_NO_FLUSH);
      rest_.remove_prefix(given - stream_.avail_in);
      out_.add(taken - stream_.avail_out);
    }
    if (code == Z_STREAM_END) return;
    if (code == Z_MEM_ERROR) throw std::bad_alloc();
    // Without input to go on, inflate makes no progress.
    fail_input(file_, {}, code == Z_BUF_ERROR ? "is a gzip archive cut short" : "is a damaged gzip archive",
               Remedy::kCopyAgain);
  }

  const InputFile& file_;
  std::string_view rest_;  ///< not yet unpacked
  GrowingBytes out_;
  z_stream stream_{};
};

}  // namespace

std::filesystem::path unpacked_name(const std::filesystem::path& path) {
  return is_packed(path) ? path.parent_path() / path.stem() : path;
}

InputFile read_unpacked(const std::filesystem::path& path) {
  InputFile file(path);
  if (!is_packed(path)) return file;
  return Gunzip(file).unpacked();
}

}  // namespace crossgrain
