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

/// Sets an option that may be absent to made(numbers).
template <class T, class Made>
void set_numbers(std::optional<T>& option, std::size_t count, const OptionValue& value, const Made& made) {
  const std::vector<double> numbers = numbers_in(value, count, /*absent=*/true);
  option = numbers.empty() ? std::nullopt : std::optional<T>(made(numbers));
}

}  // namespace

std::size_t position_among(std::span<const char* const> names, const OptionValue& value) {
  const auto* const text = std::get_if<std::string>(&value);
  const auto found = text == nullptr ? names.end() : std::find(names.begin(), names.end(), *text);
  if (found == names.end()) refuse(fmt::format("one of {}", fmt::join(names, ", ")));
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<double> numbers_in(const OptionValue& value, std::size_t count, bool absent) {
  std::vector<double> numbers;
  if (const auto* const several = std::get_if<std::vector<double>>(&value))
    numbers = *several;
  else if (!std::holds_alternative<std::string>(value))
    set_option(numbers.emplace_back(), value);
  if (std::holds_alternative<std::string>(value) || (numbers.size() != count && !(absent && numbers.empty())))
    refuse(fmt::format("{} number{}{}", count, count == 1 ? "" : "s", absent ? " or none" : ""));
  return numbers;
}

void set_option(bool& option, const OptionValue& value) {
  option = integer_in(value, 0, 1, "a flag, 0 or 1") != 0;
}

void set_option(int& option, const OptionValue& value) {
  option = any_integer_in<int>(value);
}

void set_option(std::uint64_t& option, const OptionValue& value) {
  option = any_integer_in<std::uint64_t>(value);
}

void set_option(double& option, const OptionValue& value) {
  if (const auto* const integer = std::get_if<std::int64_t>(&value))
    option = static_cast<double>(*integer);
  else if (const auto* const number = std::get_if<double>(&value))
    option = *number;
  else
    refuse("a number");
}

void set_option(Degree& option, const OptionValue& value) {
  option = static_cast<Degree>(integer_in(value, 3, 4, "3 or 4"));
}

void set_option(std::optional<int>& option, const OptionValue& value) {
  set_numbers(option, 1, value, [](const auto& n) { return any_integer_in<int>(n[0]); });
}

void set_option(std::optional<double>& option, const OptionValue& value) {
  set_numbers(option, 1, value, [](const auto& n) { return n[0]; });
}

void set_option(std::optional<std::array<double, 2>>& option, const OptionValue& value) {
  set_numbers(option, 2, value, [](const auto& n) { return std::array{n[0], n[1]}; });
}

void set_option(std::optional<Box>& option, const OptionValue& value) {
  set_numbers(option, 6, value, [](const auto& n) { return Box{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}}; });
}

void set_option(std::optional<PictureOptions::View>& option, const OptionValue& value) {
  if (const auto* const name = std::get_if<std::string>(&value))
    option = view_named(*name);
  else
    set_numbers(option, 2, value, [](const auto& n) { return PictureOptions::View{n[0], n[1]}; });
}

void set_option(std::optional<PictureOptions::Cut>& option, const OptionValue& value) {
  set_numbers(option, 2, value, [](const auto& n) {
    PictureOptions::Cut cut{any_integer_in<int>(n[0]), {}};
    if (!std::isnan(n[1])) cut.position = n[1];
    return cut;
  });
}

void set_option(std::vector<std::string>& option, const OptionValue& value) {
  const auto* const text = std::get_if<std::string>(&value);
  if (text == nullptr) refuse("a text");
  option.clear();
  for (std::size_t begin = 0; begin < text->size();) {
    const std::size_t end = std::min(text->find(',', begin), text->size());
    option.push_back(text->substr(begin, end - begin));
    begin = end + 1;
  }
}

OptionContent content_of(const Box& box) {
  const auto& [low, high] = box;
  return std::vector<double>{low[0], low[1], low[2], high[0], high[1], high[2]};
}

OptionContent content_of(const PictureOptions::View& view) {
  return std::vector<double>{view.azimuth_deg, view.elevation_deg};
}

OptionContent content_of(const PictureOptions::Cut& cut) {
  constexpr double kMiddle = std::numeric_limits<double>::quiet_NaN();
  return std::vector<double>{static_cast<double>(cut.axis), cut.position.value_or(kMiddle)};
}

OptionContent content_of(const std::vector<std::string>& option) {
  return fmt::format("{}", fmt::join(option, ","));
}

}  // namespace crossgrain
