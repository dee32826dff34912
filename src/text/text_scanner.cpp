// SPDX-License-Identifier: Apache-2.0
#include "text/text_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

enum class Character : unsigned char { kOther, kBlank, kLineEnd };

/// A table, since classifying characters takes half the time of reading text.
constexpr std::array<Character, 256> kCharacters = [] {
  std::array<Character, 256> characters{};
  for (const unsigned char c : {' ', '\t', '\v', '\f'}) characters[c] = Character::kBlank;
  for (const unsigned char c : {'\n', '\r'}) characters[c] = Character::kLineEnd;
  return characters;
}();

Character character(char c) {
  return kCharacters[static_cast<unsigned char>(c)];
}

bool is_line_end(char c) {
  return character(c) == Character::kLineEnd;
}

/// Returns the exponent after the 'e' of a number; a huge value if it does not fit into 64 bits.
std::int64_t power_of_ten(std::string_view digits) {
  constexpr std::int64_t kFarOut = std::int64_t{1} << 60;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t power = 0;
  const auto [stop, code] = std::from_chars(digits.data(), digits.data() + digits.size(), power);
  if (code == std::errc::result_out_of_range) power = digits.starts_with('-') ? -kFarOut : kFarOut;
  return std::clamp(power, -kFarOut, kFarOut);
}

/// Value of a number that std::from_chars reports as out of range: infinity if it is too large, zero if it is
/// too small. std::strtod is not used because it follows the locale of the program.
double out_of_range_value(std::string_view number) {
  const std::string_view digits = number.substr(0, number.find_first_of("eE"));
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = std::min(digits.find_first_of("123456789"), digits.size());
  // The largest double is near 1e308, the smallest near 5e-324, so the sign decides even if this is off by
  // one.
  std::int64_t power = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  if (digits.size() < number.size()) power += power_of_ten(number.substr(digits.size() + 1));
  const double magnitude = power > 0 ? std::numeric_limits<double>::infinity() : 0;
  return number.starts_with('-') ? -magnitude : magnitude;
}

}  // namespace

TextScanner::TextScanner(const InputFile& file, Syntax syntax, std::size_t begin, std::size_t line,
                         std::size_t end)
    : file_(&file), text_(file.bytes().substr(0, end)), syntax_(syntax), position_(begin), line_(line) {
  // Some editors put a byte order mark before UTF-8 text.
  if (begin == 0 && text_.starts_with("\xEF\xBB\xBF")) position_ = 3;
}

bool TextScanner::at_line_end() const {
  return position_ >= text_.size() || is_line_end(text_[position_]);
}

void TextScanner::skip_line_end() {
  if (position_ >= text_.size()) return;
  const bool carriage_return = text_[position_] == '\r';
  ++position_;
  if (carriage_return && position_ < text_.size() && text_[position_] == '\n') ++position_;
  ++line_;
}

bool TextScanner::skip_continuation() {
  if (!syntax_.continuations || text_[position_] != '\\') return false;
  if (position_ + 1 < text_.size() && !is_line_end(text_[position_ + 1])) return false;
  ++position_;
  skip_line_end();
  return true;
}

void TextScanner::check_stop() {
  // Takes some milliseconds to read.
  constexpr std::size_t kBetween = std::size_t{1} << 20;
  if (position_ < next_check_) return;
  check_watched();
  next_check_ = position_ + kBetween;
}

std::string_view TextScanner::word() {
  check_stop();
  do {
    while (position_ < text_.size() && character(text_[position_]) == Character::kBlank) ++position_;
    if (at_line_end()) return {};
  } while (skip_continuation());
  if (syntax_.comments && text_[position_] == '#') {
    while (!at_line_end()) ++position_;
    return {};
  }
  const std::size_t begin = position_;
  for (; position_ < text_.size() && character(text_[position_]) == Character::kOther; ++position_) {
    if (syntax_.continuations && text_[position_] == '\\' &&
        (position_ + 1 == text_.size() || is_line_end(text_[position_ + 1])))
      break;
  }
  return text_.substr(begin, position_ - begin);
}

std::string_view TextScanner::word_anywhere() {
  for (;;) {
    const std::string_view found = word();
    if (!found.empty() || position_ >= text_.size()) return found;
    skip_line_end();
  }
}

bool TextScanner::next_line() {
  check_stop();
  for (;;) {
    const std::size_t begin = position_;
    while (!at_line_end()) ++position_;
    const bool goes_on = syntax_.continuations && position_ > begin && text_[position_ - 1] == '\\';
    skip_line_end();
    if (!goes_on || position_ >= text_.size()) return position_ < text_.size();
  }
}

double TextScanner::number(std::string_view word, const char* what) const {
  if (word.empty()) fail(fmt::format("{} is missing: cut short, or damaged", what));
  // from_chars takes a minus sign but no plus sign.
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  double value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(digits.data(), end, value);
  if (code == std::errc::result_out_of_range) value = out_of_range_value(digits);
  if (code == std::errc::invalid_argument || stop != end)
    fail(fmt::format("{} instead of {} (a number with a decimal point)", in_quotes(word), what));
  if (!std::isfinite(value)) fail(fmt::format("{} is {}, not a finite number", what, in_quotes(word)));
  return value;
}

std::int64_t TextScanner::integer(std::string_view word, const char* what) const {
  if (word.empty()) fail(fmt::format("{} is missing: cut short, or damaged", what));
  std::int64_t value = 0;
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  const char* end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(digits.data(), end, value);
  if (code != std::errc() || stop != end)
    fail(fmt::format("{} instead of {} (a whole number)", in_quotes(word), what));
  return value;
}

}  // namespace crossgrain
