// SPDX-License-Identifier: Apache-2.0
#include "files/file_seal.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include "files/crc32.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlockBytes = 1 << 20;

constexpr std::size_t kDigits = 8;

/// A number as PNG files have it: four bytes, the highest first.
std::string in_png(std::uint64_t number) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

/// Length, type, data and CRC (PNG specification, section 5.3).
std::string png_chunk(std::string_view type, std::string_view data) {
  Crc32 crc;
  crc.add(type);
  crc.add(data);
  return in_png(data.size()) + std::string(type) + std::string(data) + in_png(crc.value());
}

/// A regular file, read from its beginning.
class SummedFile {
 public:
  explicit SummedFile(const fs::path& path) {
    std::error_code unknown;
    if (!fs::is_regular_file(path, unknown)) return;
    size_ = fs::file_size(path, unknown);
    if (!unknown) file_.open(path, std::ios::binary);
  }

  bool is_open() const { return file_.is_open(); }
  std::uint64_t size() const { return size_; }

  std::string at(std::uint64_t offset, std::size_t count) {
    std::string bytes(count, '\0');
    file_.seekg(static_cast<std::streamoff>(offset));
    file_.read(bytes.data(), static_cast<std::streamsize>(count));
    return file_ ? bytes : std::string();
  }

  /// The sum of the first `count` bytes; none if the file does not give them.
  std::optional<std::uint32_t> crc_of_first(std::uint64_t count, const Monitor& monitor) {
    file_.clear();
    file_.seekg(0);
    std::string block(kBlockBytes, '\0');
    Crc32 crc;
    while (count > 0) {
      monitor.check();
      const std::size_t wanted = std::min<std::uint64_t>(count, block.size());
      if (!file_.read(block.data(), static_cast<std::streamsize>(wanted))) return std::nullopt;
      crc.add(std::string_view(block).substr(0, wanted));
      count -= wanted;
    }
    return crc.value();
  }

 private:
  std::ifstream file_;
  std::uint64_t size_ = 0;
};

/// The number in a seal of this form; none if the bytes are no such seal.
std::optional<std::uint32_t> crc_in(SealForm form, const std::string& seal) {
  // The digits are where they differ.
  const std::size_t place = seal_text(form, 0).find(std::string(kDigits, '0'));
  std::uint32_t crc = 0;
  const char* digits = seal.data() + place;
  std::from_chars(digits, digits + kDigits, crc, 16);
  return seal == seal_text(form, crc) ? std::optional(crc) : std::nullopt;
}

}  // namespace

std::string seal_text(SealForm form, std::uint32_t crc) {
  const std::string digits = Crc32::text_of(crc);
  switch (form) {
    case SealForm::kXml:
      return "<!-- checksum " + digits + " -->\n";
    case SealForm::kText:
      return "# checksum " + digits + "\n";
    case SealForm::kJson:
      return ",\n  \"checksum\": \"" + digits + "\"\n}\n";
    case SealForm::kPng:
      return png_chunk("tEXt", std::string("Checksum") + '\0' + digits) + png_chunk("IEND", "");
  }
  return "";
}

void write_seal(OutputFile& file, SealForm form) {
  file.write(seal_text(form, file.crc().value()));
}

bool has_whole_seal(const fs::path& path, const Monitor& monitor) {
  SummedFile file(path);
  if (!file.is_open()) return false;
  for (const SealForm form : {SealForm::kXml, SealForm::kText, SealForm::kJson, SealForm::kPng}) {
    const std::size_t size = seal_text(form, 0).size();
    if (file.size() < size) continue;
    const std::string end = file.at(file.size() - size, size);
    const std::optional<std::uint32_t> crc = end.size() == size ? crc_in(form, end) : std::nullopt;
    if (crc) return file.crc_of_first(file.size() - size, monitor) == crc;
  }
  return false;
}

bool has_content(const fs::path& path, std::uint64_t bytes, const std::string& crc, const Monitor& monitor) {
  SummedFile file(path);
  if (!file.is_open() || file.size() != bytes) return false;
  const std::optional<std::uint32_t> found = file.crc_of_first(bytes, monitor);
  return found && Crc32::text_of(*found) == crc;
}

}  // namespace crossgrain
