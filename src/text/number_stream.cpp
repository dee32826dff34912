// SPDX-License-Identifier: Apache-2.0
#include "text/number_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "crossgrain/error.hpp"

namespace crossgrain {

void NumberStream::fail(const std::string& text, Remedy remedy) const {
  if (scanner_) scanner_->fail(text, remedy);
  if (!array_.empty())
    throw Error(ErrorKind::kInput, {file_->name(), "array " + in_quotes(array_), text, remedy});
  fail_input(*file_, element_.unit != nullptr ? element_ : Place{"byte", position_}, text, remedy);
}

template <class T>
T NumberStream::take() {
  checkpoint_.pass();
  if (bytes_.size() - position_ < sizeof(T))
    fail(array_.empty() ? "the file ends here: cut short" : "holds fewer numbers than it should",
         Remedy::kCopyAgain);
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes_.data() + position_, sizeof(T));
  if (swapped_) std::reverse(raw.begin(), raw.end());
  position_ += sizeof(T);
  return std::bit_cast<T>(raw);
}

double NumberStream::binary_real(NumberType type) {
  if (type == NumberType::kFloat64) return take<double>();
  if (type == NumberType::kFloat32) return static_cast<double>(take<float>());
  return static_cast<double>(binary_integer(type));
}

std::int64_t NumberStream::binary_integer(NumberType type) {
  switch (type) {
    case NumberType::kInt8:
      return take<std::int8_t>();
    case NumberType::kUint8:
      return take<std::uint8_t>();
    case NumberType::kInt16:
      return take<std::int16_t>();
    case NumberType::kUint16:
      return take<std::uint16_t>();
    case NumberType::kInt32:
      return take<std::int32_t>();
    case NumberType::kUint32:
      return take<std::uint32_t>();
    case NumberType::kInt64:
      return take<std::int64_t>();
    case NumberType::kUint64:
      // Beyond 63 bits they become negative, which is invalid for an index or count too.
      return static_cast<std::int64_t>(take<std::uint64_t>());
    default:
      fail("numbers with decimals instead of whole numbers");
  }
}

void NumberStream::skip(NumberType type, std::uint64_t count) {
  if (scanner_) {
    for (std::uint64_t i = 0; i < count; ++i) {
      if (scanner_->word_anywhere().empty()) fail("the file ends too early: cut short", Remedy::kCopyAgain);
    }
    return;
  }
  if (count > most_left(type))
    fail(fmt::format("{} should follow, but there {} only {}", counted(count, "number"),
                     is_or_are(bytes_left()), counted(bytes_left(), "byte")),
         Remedy::kCopyAgain);
  position_ += count * size_of(type);
}

std::uint64_t NumberStream::most_left(NumberType type) const {
  // In text a number takes a digit and a blank; one is added, since the last line may lack its end.
  return scanner_ ? (bytes_left() + 1) / 2 : bytes_left() / size_of(type);
}

std::uint64_t NumberStream::checked_count(std::int64_t count, std::uint64_t least, NumberType type,
                                          const std::string& what) const {
  if (count < 0) fail(fmt::format("{} is {}", what, count));
  if (static_cast<std::uint64_t>(count) > most_left(type) / least) {
    fail(fmt::format("{} is {}, but the rest of the file has {}: cut short, or damaged", what, count,
                     counted(bytes_left(), "byte")),
         Remedy::kCopyAgain);
  }
  return static_cast<std::uint64_t>(count);
}

}  // namespace crossgrain
