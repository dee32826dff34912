// SPDX-License-Identifier: Apache-2.0
// The types that options have, and the values that the C interface gives them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "crossgrain/c.h"
#include "crossgrain/picture.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/tet_making.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// A value that is passed in: what crossgrain_options_set_integer, _number, _numbers and _text take.
using OptionValue = std::variant<std::int64_t, double, std::vector<double>, std::string>;

/// A value as it is read: numbers, or a text.
using OptionContent = std::variant<std::vector<double>, std::string>;

/// What options of a type take.
template <class T>
inline constexpr crossgrain_option_type kOptionType = CROSSGRAIN_TEXT;
template <>
inline constexpr crossgrain_option_type kOptionType<bool> = CROSSGRAIN_FLAG;
template <>
inline constexpr crossgrain_option_type kOptionType<int> = CROSSGRAIN_INTEGER;
template <>
inline constexpr crossgrain_option_type kOptionType<std::uint64_t> = CROSSGRAIN_INTEGER;
template <>
inline constexpr crossgrain_option_type kOptionType<Degree> = CROSSGRAIN_INTEGER;
template <>
inline constexpr crossgrain_option_type kOptionType<double> = CROSSGRAIN_NUMBER;
template <class T>
inline constexpr crossgrain_option_type kOptionType<std::optional<T>> = CROSSGRAIN_NUMBERS;
template <class T, std::size_t n>
inline constexpr crossgrain_option_type kOptionType<std::array<T, n>> = CROSSGRAIN_NUMBERS;

/// Names of the values of an enumeration, from 0 on.
template <class Enum>
inline constexpr std::array<const char*, 0> kOptionNames;
template <>
inline constexpr std::array kOptionNames<TetBoundary>{"all", "smooth-only"};
template <>
inline constexpr std::array kOptionNames<TetMaker>{"automatic", "gmsh", "netgen"};
template <>
inline constexpr std::array kOptionNames<LengthUnit>{"none", "um", "mm", "cm", "m", "inch", "foot"};
template <>
inline constexpr std::array kOptionNames<HexPreference>{"features", "map", "lattice", "map_only"};
template <>
inline constexpr std::array kOptionNames<ForeignFiles>{"refuse", "keep", "replace"};
template <>
inline constexpr std::array kOptionNames<PictureColour>{"none",  "alignment", "energy",
                                                        "class", "region",    "face"};
template <>
inline constexpr std::array kOptionNames<PictureFrames>{"lines", "boxes", "crosses", "none"};
template <>
inline constexpr std::array kOptionNames<PicturePart>{"lines", "creases", "legend"};
template <>
inline constexpr std::array kOptionNames<PictureBackground>{"light", "dark", "transparent"};

/// Returns the position of a text among names.
std::size_t position_among(std::span<const char* const> names, const OptionValue& value);

/// Returns the numbers of a value: one, several or, if it may be `absent`, none.
std::vector<double> numbers_in(const OptionValue& value, std::size_t count, bool absent);

// set_option sets an option to a value, or throws std::invalid_argument with what it takes; content_of
// returns its value. An option that may be absent is no numbers then.

void set_option(bool& option, const OptionValue& value);
void set_option(int& option, const OptionValue& value);
void set_option(std::uint64_t& option, const OptionValue& value);
void set_option(double& option, const OptionValue& value);
void set_option(Degree& option, const OptionValue& value);
void set_option(std::optional<int>& option, const OptionValue& value);
void set_option(std::optional<double>& option, const OptionValue& value);
void set_option(std::optional<std::array<double, 2>>& option, const OptionValue& value);
void set_option(std::optional<Box>& option, const OptionValue& value);
/// A view may be given by its name.
void set_option(std::optional<PictureOptions::View>& option, const OptionValue& value);
/// The position may be NaN for the middle.
void set_option(std::optional<PictureOptions::Cut>& option, const OptionValue& value);
/// Names separated by commas.
void set_option(std::vector<std::string>& option, const OptionValue& value);

OptionContent content_of(const Box& box);
OptionContent content_of(const PictureOptions::View& view);
OptionContent content_of(const PictureOptions::Cut& cut);
OptionContent content_of(const std::vector<std::string>& option);

template <class Enum>
requires std::is_enum_v<Enum>
void set_option(Enum& option, const OptionValue& value) {
  option = static_cast<Enum>(position_among(kOptionNames<Enum>, value));
}

template <class Enum>
requires std::is_enum_v<Enum>
void set_option(std::vector<Enum>& option, const OptionValue& value) {
  std::vector<std::string> names;
  set_option(names, value);
  std::vector<Enum> members(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) set_option(members[i], names[i]);
  option = members;
}

template <class T, std::size_t n>
void set_option(std::array<T, n>& option, const OptionValue& value) {
  const std::vector<double> numbers = numbers_in(value, n, /*absent=*/false);
  std::array<T, n> members;
  for (std::size_t i = 0; i < n; ++i) set_option(members[i], numbers[i]);
  option = members;
}

template <class T>
requires std::is_arithmetic_v<T> || std::is_enum_v<T> OptionContent content_of(T option) {
  if constexpr (kOptionType<T> == CROSSGRAIN_TEXT)
    return kOptionNames<T>[static_cast<std::size_t>(option)];
  else
    return std::vector<double>{static_cast<double>(option)};
}

template <class Enum>
OptionContent content_of(const std::vector<Enum>& option) {
  std::vector<std::string> names;
  for (const Enum member : option) names.push_back(kOptionNames<Enum>[static_cast<std::size_t>(member)]);
  return content_of(names);
}

template <class T, std::size_t n>
OptionContent content_of(const std::array<T, n>& option) {
  return std::vector<double>(option.begin(), option.end());
}

template <class T>
OptionContent content_of(const std::optional<T>& option) {
  return option ? content_of(*option) : std::vector<double>();
}

}  // namespace crossgrain
