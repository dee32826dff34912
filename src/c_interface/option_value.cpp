// SPDX-License-Identifier: Apache-2.0
#include "c_interface/option_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace crossgrain {
namespace {

[[noreturn]] void refuse(const std::string& what_it_takes) {
  throw std::invalid_argument("takes " + what_it_takes);
}

/// Returns the integer from `low` to `high` in a value; a double or decimal digits that are one count.
template <class Integer>
Integer integer_in(const OptionValue& value, Integer low, Integer high, const std::string& what_it_takes) {
  if (const auto* const integer = std::get_if<std::int64_t>(&value)) {
    if (std::cmp_less(*integer, low) || std::cmp_greater(*integer, high)) refuse(what_it_takes);
    return static_cast<Integer>(*integer);
  }
  if (const auto* const text = std::get_if<std::string>(&value)) {
    Integer parsed{};
    const auto [end, code] = std::from_chars(text->data(), text->data() + text->size(), parsed);
    if (code != std::errc() || end != text->data() + text->size() || parsed < low || parsed > high)
      refuse(what_it_takes);
    return parsed;
  }
  const auto* const number = std::get_if<double>(&value);
  // Below 2^53 every integer is a double.
  if (number == nullptr || std::floor(*number) != *number || std::abs(*number) > 9e15) refuse(what_it_takes);
  return integer_in(static_cast<std::int64_t>(*number), low, high, what_it_takes);
}

template <class Integer>
Integer any_integer_in(const OptionValue& value) {
  using Limits = std::numeric_limits<Integer>;
  return integer_in(value, Limits::min(), Limits::max(),
                    Limits::is_signed ? "an integer" : "an integer that is not negative");
}

const std::string& text_in(const OptionValue& value) {
  const auto* const text = std::get_if<std::string>(&value);
  if (text == nullptr) refuse("a text");
  return *text;
}

OptionContent number(double value) {
  return std::vector<double>{value};
}

}  // namespace

bool OptionOf<bool>::of(const OptionValue& value) {
  return integer_in(value, 0, 1, "a flag, 0 or 1") != 0;
}

OptionContent OptionOf<bool>::content(bool member) {
  return number(member);
}

int OptionOf<int>::of(const OptionValue& value) {
  return any_integer_in<int>(value);
}

OptionContent OptionOf<int>::content(int member) {
  return number(member);
}

std::uint64_t OptionOf<std::uint64_t>::of(const OptionValue& value) {
  return any_integer_in<std::uint64_t>(value);
}

OptionContent OptionOf<std::uint64_t>::content(std::uint64_t member) {
  return number(static_cast<double>(member));
}

double OptionOf<double>::of(const OptionValue& value) {
  if (const auto* const integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  if (const auto* const its_number = std::get_if<double>(&value)) return *its_number;
  refuse("a number");
}

OptionContent OptionOf<double>::content(double member) {
  return number(member);
}

Degree OptionOf<Degree>::of(const OptionValue& value) {
  return static_cast<Degree>(integer_in(value, 3, 4, "3 or 4"));
}

OptionContent OptionOf<Degree>::content(Degree member) {
  return number(static_cast<int>(member));
}

std::size_t position_among(const char* const* names, std::size_t count, const OptionValue& value) {
  const std::span all(names, count);
  const auto* const text = std::get_if<std::string>(&value);
  const auto found = text == nullptr ? all.end() : std::find(all.begin(), all.end(), *text);
  if (found == all.end()) refuse(fmt::format("one of {}", fmt::join(all, ", ")));
  return static_cast<std::size_t>(found - all.begin());
}

std::filesystem::path OptionOf<std::filesystem::path>::of(const OptionValue& value) {
  return text_in(value);
}

OptionContent OptionOf<std::filesystem::path>::content(const std::filesystem::path& member) {
  return member.string();
}

std::vector<std::string> OptionOf<std::vector<std::string>>::of(const OptionValue& value) {
  std::vector<std::string> names;
  const std::string& text = text_in(value);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    names.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

OptionContent OptionOf<std::vector<std::string>>::content(const std::vector<std::string>& member) {
  return fmt::format("{}", fmt::join(member, ","));
}

PictureOptions::Cut OptionNumbers<PictureOptions::Cut>::from(const std::vector<double>& n) {
  PictureOptions::Cut cut;
  cut.axis = OptionOf<int>::of(n[0]);
  if (!std::isnan(n[1])) cut.position = n[1];
  return cut;
}

std::vector<double> OptionNumbers<PictureOptions::Cut>::to(const PictureOptions::Cut& cut) {
  return {static_cast<double>(cut.axis), cut.position.value_or(std::numeric_limits<double>::quiet_NaN())};
}

std::vector<double> numbers_in(const OptionValue& value, std::size_t count, bool absent) {
  std::vector<double> numbers;
  if (const auto* const several = std::get_if<std::vector<double>>(&value))
    numbers = *several;
  else if (!std::holds_alternative<std::string>(value))
    numbers = {OptionOf<double>::of(value)};
  if (std::holds_alternative<std::string>(value) || (numbers.size() != count && !(absent && numbers.empty())))
    refuse(fmt::format("{} number{}{}", count, count == 1 ? "" : "s", absent ? " or none" : ""));
  return numbers;
}

}  // namespace crossgrain
