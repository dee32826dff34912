// SPDX-License-Identifier: Apache-2.0
// The types that options have, and the values that the C interface gives them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "crossgrain/c.h"
#include "crossgrain/options.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/tet_making.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// A value that is passed in: what crossgrain_options_set_integer, _number, _numbers and _text take.
using OptionValue = std::variant<std::int64_t, double, std::vector<double>, std::string>;

/// A value as it is read: numbers, or a text.
using OptionContent = std::variant<std::vector<double>, std::string>;

/// How options of type T are passed: `type` for the interface; `of(value)`, which throws
/// std::invalid_argument with what the option takes; `content(member)`.
template <class T>
struct OptionOf;

template <>
struct OptionOf<bool> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_FLAG;
  static bool of(const OptionValue& value);
  static OptionContent content(bool member);
};

template <>
struct OptionOf<int> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_INTEGER;
  static int of(const OptionValue& value);
  static OptionContent content(int member);
};

template <>
struct OptionOf<std::uint64_t> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_INTEGER;
  static std::uint64_t of(const OptionValue& value);
  static OptionContent content(std::uint64_t member);
};

template <>
struct OptionOf<double> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_NUMBER;
  static double of(const OptionValue& value);
  static OptionContent content(double member);
};

template <>
struct OptionOf<Degree> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_INTEGER;
  static Degree of(const OptionValue& value);
  static OptionContent content(Degree member);
};

/// Names of the values of an enumeration, from 0 on.
template <class Enum>
struct OptionNames;
template <>
struct OptionNames<TetBoundary> {
  static constexpr std::array names{"all", "smooth-only"};
};
template <>
struct OptionNames<TetMaker> {
  static constexpr std::array names{"automatic", "gmsh", "netgen"};
};
template <>
struct OptionNames<ForeignFiles> {
  static constexpr std::array names{"refuse", "keep", "replace"};
};
template <>
struct OptionNames<PictureColour> {
  static constexpr std::array names{"none", "alignment", "energy", "class", "region"};
};
template <>
struct OptionNames<PictureFrames> {
  static constexpr std::array names{"lines", "boxes", "crosses", "none"};
};
template <>
struct OptionNames<PicturePart> {
  static constexpr std::array names{"lines", "creases", "legend"};
};
template <>
struct OptionNames<PictureBackground> {
  static constexpr std::array names{"light", "dark", "transparent"};
};

/// Returns the position of a text among names.
std::size_t position_among(const char* const* names, std::size_t count, const OptionValue& value);

template <class Enum>
requires std::is_enum_v<Enum>
struct OptionOf<Enum> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_TEXT;
  static Enum of(const OptionValue& value) {
    const auto& names = OptionNames<Enum>::names;
    return static_cast<Enum>(position_among(names.data(), names.size(), value));
  }
  static OptionContent content(Enum member) {
    return std::string(OptionNames<Enum>::names[static_cast<std::size_t>(member)]);
  }
};

template <>
struct OptionOf<std::filesystem::path> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_TEXT;
  static std::filesystem::path of(const OptionValue& value);
  static OptionContent content(const std::filesystem::path& member);
};

/// Names separated by commas.
template <>
struct OptionOf<std::vector<std::string>> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_TEXT;
  static std::vector<std::string> of(const OptionValue& value);
  static OptionContent content(const std::vector<std::string>& member);
};

template <class Enum>
requires std::is_enum_v<Enum>
struct OptionOf<std::vector<Enum>> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_TEXT;
  static std::vector<Enum> of(const OptionValue& value) {
    std::vector<Enum> members;
    for (const std::string& name : OptionOf<std::vector<std::string>>::of(value))
      members.push_back(OptionOf<Enum>::of(name));
    return members;
  }
  static OptionContent content(const std::vector<Enum>& members) {
    std::vector<std::string> names;
    for (const Enum member : members)
      names.push_back(OptionNames<Enum>::names[static_cast<std::size_t>(member)]);
    return OptionOf<std::vector<std::string>>::content(names);
  }
};

/// Types that are several numbers: `counts` are how many it may have, `from` and `to` convert.
template <class T>
struct OptionNumbers;
template <>
struct OptionNumbers<Box> {
  static constexpr std::size_t count = 6;
  static Box from(const std::vector<double>& n) { return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}}; }
  static std::vector<double> to(const Box& b) {
    return {b.low[0], b.low[1], b.low[2], b.high[0], b.high[1], b.high[2]};
  }
};
template <>
struct OptionNumbers<std::array<double, 2>> {
  static constexpr std::size_t count = 2;
  static std::array<double, 2> from(const std::vector<double>& n) { return {n[0], n[1]}; }
  static std::vector<double> to(const std::array<double, 2>& a) { return {a[0], a[1]}; }
};
template <>
struct OptionNumbers<PictureOptions::View> {
  static constexpr std::size_t count = 2;
  static PictureOptions::View from(const std::vector<double>& n) { return {n[0], n[1]}; }
  static std::vector<double> to(const PictureOptions::View& v) { return {v.azimuth_deg, v.elevation_deg}; }
};
template <>
struct OptionNumbers<double> {
  static constexpr std::size_t count = 1;
  static double from(const std::vector<double>& n) { return n[0]; }
  static std::vector<double> to(double number) { return {number}; }
};
/// The position may be NaN for the middle.
template <>
struct OptionNumbers<PictureOptions::Cut> {
  static constexpr std::size_t count = 2;
  static PictureOptions::Cut from(const std::vector<double>& n);
  static std::vector<double> to(const PictureOptions::Cut& cut);
};
template <>
struct OptionNumbers<int> {
  static constexpr std::size_t count = 1;
  static int from(const std::vector<double>& n) { return OptionOf<int>::of(n[0]); }
  static std::vector<double> to(int number) { return {static_cast<double>(number)}; }
};

/// Returns the numbers of a value: one, several or, if it may be `absent`, none.
std::vector<double> numbers_in(const OptionValue& value, std::size_t count, bool absent);

/// An option that may be absent: no numbers. A view may be given by its name.
template <class T>
struct OptionOf<std::optional<T>> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_NUMBERS;
  static std::optional<T> of(const OptionValue& value) {
    if constexpr (std::is_same_v<T, PictureOptions::View>) {
      if (const auto* const name = std::get_if<std::string>(&value)) return view_named(*name);
    }
    const std::vector<double> numbers = numbers_in(value, OptionNumbers<T>::count, /*absent=*/true);
    if (numbers.empty()) return std::nullopt;
    return OptionNumbers<T>::from(numbers);
  }
  static OptionContent content(const std::optional<T>& member) {
    return member ? OptionNumbers<T>::to(*member) : std::vector<double>{};
  }
};

/// Flags or integers.
template <class T, std::size_t n>
struct OptionOf<std::array<T, n>> {
  static constexpr crossgrain_option_type type = CROSSGRAIN_NUMBERS;
  static std::array<T, n> of(const OptionValue& value) {
    const std::vector<double> numbers = numbers_in(value, n, /*absent=*/false);
    std::array<T, n> member;
    for (std::size_t i = 0; i < n; ++i) member[i] = OptionOf<T>::of(numbers[i]);
    return member;
  }
  static OptionContent content(const std::array<T, n>& member) {
    return std::vector<double>(member.begin(), member.end());
  }
};

}  // namespace crossgrain
