// SPDX-License-Identifier: Apache-2.0
#include "vtu/vtu_data.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "files/read_memory.hpp"
#include "vtu/zlib_blocks.hpp"

namespace crossgrain {
namespace {

constexpr std::uint8_t kNoDigit = 0xff, kPadding = 0xfe;

/// Returns the six bits that a character encodes (RFC 4648).
constexpr std::array<std::uint8_t, 256> base64_digits() {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> digits{};
  for (std::uint8_t& digit : digits) digit = kNoDigit;
  for (std::size_t i = 0; i < kAlphabet.size(); ++i)
    digits[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  digits[static_cast<unsigned char>('=')] = kPadding;
  return digits;
}

constexpr auto kBase64Digits = base64_digits();

/// Reads consecutive bytes from base64. Some writers encode header and data separately, some together, so
/// padding is allowed at the end of any group of four characters.
class PackedBytes {
 public:
  PackedBytes(std::string_view text, bool is_base64) : text_(text), is_base64_(is_base64) {}

  /// Upper bound of the remaining bytes.
  std::uint64_t most_left() const {
    const std::uint64_t left = text_.size() - position_;
    return is_base64_ ? (left + 3) / 4 * 3 + (group_size_ - group_begin_) : left;
  }

  /// Reads bytes. Returns false if there are fewer.
  bool read(char* out, std::uint64_t count) {
    if (count > most_left()) return false;
    if (count == 0) return true;  // `out` may be null
    if (!is_base64_) {
      std::memcpy(out, text_.data() + position_, count);
      position_ += count;
      return true;
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      checkpoint_.pass();
      if (group_begin_ == group_size_ && !decode_group()) return false;
      out[i] = group_[group_begin_++];
    }
    return true;
  }

 private:
  bool decode_group() {
    std::uint32_t bits = 0;
    std::size_t padding = 0;
    for (int k = 0; k < 4; ++k) {
      while (position_ < text_.size() && static_cast<unsigned char>(text_[position_]) <= ' ') ++position_;
      if (position_ == text_.size()) return false;
      const std::uint8_t digit = kBase64Digits[static_cast<unsigned char>(text_[position_++])];
      if (digit == kNoDigit || (padding > 0 && digit != kPadding)) return false;
      if (digit == kPadding) ++padding;
      bits = bits << 6 | (digit == kPadding ? 0u : digit);
    }
    if (padding > 2) return false;
    for (std::size_t k = 0; k < 3; ++k) group_[k] = static_cast<char>(bits >> (16 - 8 * k));
    group_begin_ = 0;
    group_size_ = 3 - padding;
    return true;
  }

  std::string_view text_;
  bool is_base64_;
  std::size_t position_ = 0;
  std::array<char, 3> group_{};  ///< decoded bytes; those from group_begin_ on are unread
  std::size_t group_begin_ = 0, group_size_ = 0;
  Checkpoint checkpoint_;
};

class Unpacker {
 public:
  Unpacker(const std::string& name, std::string_view text, bool is_base64, const VtuPackage& package)
      : name_(name), bytes_(text, is_base64), package_(package) {}

  std::optional<std::string> unpack() { return package_.is_compressed ? inflate() : copy(); }

 private:
  bool read_words(std::span<std::uint64_t> words) {
    const std::size_t size = size_of(package_.header_type);
    for (std::uint64_t& word : words) {
      std::array<char, sizeof(std::uint64_t)> raw{};
      if (!bytes_.read(raw.data(), size)) return false;
      if (package_.is_swapped) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
      std::memcpy(&word, raw.data(), sizeof word);  // little endian, so that four bytes suffice
    }
    return true;
  }

  std::optional<std::string> copy() {
    std::uint64_t size = 0;
    if (!read_words({&size, 1}) || size > bytes_.most_left()) return std::nullopt;
    require_read_memory(name_, static_cast<double>(size));
    std::string out(size, '\0');
    if (!bytes_.read(out.data(), size)) return std::nullopt;
    return out;
  }

  std::optional<std::string> inflate() {
    std::array<std::uint64_t, 3> head{};
    // Without blocks, writers may omit the rest of the header.
    if (!read_words(std::span(head).first(1))) return std::nullopt;
    if (head[0] == 0) return std::string();
    if (!read_words(std::span(head).last(2)) || head[0] > bytes_.most_left() / size_of(package_.header_type))
      return std::nullopt;
    std::vector<std::uint64_t> sizes(head[0]);
    if (!read_words(sizes)) return std::nullopt;
    const auto blocks = zlib_blocks(head, sizes, 0, bytes_.most_left());
    if (!blocks) return std::nullopt;
    std::string out;
    std::vector<unsigned char> compressed;
    for (std::size_t i = 0; i < blocks->count(); ++i) {
      compressed.resize(sizes[i]);
      if (!bytes_.read(reinterpret_cast<char*>(compressed.data()), compressed.size())) return std::nullopt;
      if (!inflate_onto(name_, out, compressed, blocks->raw_size(i))) return std::nullopt;
    }
    return out;
  }

  const std::string& name_;  ///< of the file
  PackedBytes bytes_;
  const VtuPackage& package_;
};

}  // namespace

std::optional<std::string> unpack_vtu_data(const std::string& name, std::string_view text, bool is_base64,
                                           const VtuPackage& package) {
  return Unpacker(name, text, is_base64, package).unpack();
}

}  // namespace crossgrain
