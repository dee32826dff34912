// SPDX-License-Identifier: Apache-2.0
// Reading and writing of the members of a JSON object by calls of the same form.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <ranges>
#include <string>
#include <type_traits>
#include <vector>

#include "base/names.hpp"
#include "crossgrain/error.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// A struct of which describe(file, value) lists the members.
template <class T>
concept Described = std::is_class_v<T> && !std::ranges::range<T>;

/// Sets members of a JSON object.
class JsonWriter {
 public:
  using Json = nlohmann::ordered_json;

  explicit JsonWriter(Json& json) : json_(json) {}

  /// Writes a number, a text that is always there, an array of such, or the name of an enumerator.
  template <class T>
  void member(const char* key, const T& value) {
    if constexpr (std::is_enum_v<T>)
      json_[key] = name_of(value);
    else
      json_[key] = value;
  }

  /// Writes an optional number; null if there is none.
  template <class T>
  void member(const char* key, const std::optional<T>& value) {
    json_[key] = value ? Json(*value) : Json(nullptr);
  }

  template <Described T>
  void member(const char* key, const T& value) {
    object(key, [&](JsonWriter& inner) { describe(inner, value); });
  }

  /// Writes an optional object; no key if there is none.
  template <Described T>
  void member(const char* key, const std::optional<T>& value) {
    if (value) member(key, *value);
  }

  template <Described T>
  void member(const char* key, const std::vector<T>& values) {
    Json& list = json_[key] = Json::array();
    for (const T& value : values) {
      JsonWriter inner(list.emplace_back(Json::object()));
      describe(inner, value);
    }
  }

  /// Writes a list; no key if it is empty.
  template <class T>
  void optional_list(const char* key, const std::vector<T>& values) {
    if (!values.empty()) member(key, values);
  }

  /// Writes a text; no key if it is empty.
  void text(const char* key, const std::string& value) {
    if (!value.empty()) json_[key] = value;
  }

  /// Writes the name of an enumerator; no key for the first one.
  template <class Enum>
  void optional_name(const char* key, Enum value) {
    if (value != Enum{}) member(key, value);
  }

  /// Writes a text for people that follows from other members; no key if it is empty. Reading skips it.
  void note(const char* key, const char* words) { text(key, words); }

  template <class Members>
  void object(const char* key, const Members& members) {
    JsonWriter inner(json_[key] = Json::object());
    members(inner);
  }

 private:
  Json& json_;
};

/// Reads members of a JSON object of a file. Throws Error(kInput) with the key of a member that is missing or
/// of the wrong type.
class JsonReader {
 public:
  using Json = nlohmann::ordered_json;

  JsonReader(const Json& json, const InputFile& file) : json_(json), file_(file) {}

  template <class T>
  void member(const char* key, T& value) {
    const Json& json = require(key);
    bool fits = true;
    if constexpr (std::is_same_v<T, bool>)
      fits = json.is_boolean();
    else if constexpr (std::is_same_v<T, std::int64_t>)
      fits = json.is_number_integer();  // may be negative
    else if constexpr (std::is_integral_v<T>)
      fits = json.is_number_unsigned() && json.get<std::uint64_t>() <= std::numeric_limits<T>::max();
    if (!fits) fail(key);
    try {
      take(json, value);
    } catch (const nlohmann::json::exception&) {
      fail(key);
    }
  }

  template <class Enum>
  requires std::is_enum_v<Enum>
  void member(const char* key, Enum& value) {
    std::string name;
    member(key, name);
    const std::optional<Enum> named = value_named<Enum>(name);
    if (!named)
      fail_input(file_, {}, fmt::format("'{}' has the unknown value {}", key, in_quotes(name)),
                 Remedy::kSolveAgain);
    value = *named;
  }

  template <class T>
  void member(const char* key, std::optional<T>& value) {
    value.reset();
    if (!require(key).is_null()) member(key, value.emplace());
  }

  template <Described T>
  void member(const char* key, T& value) {
    object(key, [&](JsonReader& inner) { describe(inner, value); });
  }

  template <Described T>
  void member(const char* key, std::optional<T>& value) {
    value.reset();
    // T{} is needed because clang takes a nested struct with initialisers for one without a default
    // constructor.
    if (has(key)) member(key, value.emplace(T{}));
  }

  template <Described T>
  void member(const char* key, std::vector<T>& values) {
    const Json& list = require(key);
    if (!list.is_array()) fail(key);
    for (const Json& json : list) {
      JsonReader inner(json, file_);
      describe(inner, values.emplace_back());
    }
  }

  template <class T>
  void optional_list(const char* key, std::vector<T>& values) {
    values.clear();
    if (has(key)) member(key, values);
  }

  void text(const char* key, std::string& value) {
    value.clear();
    if (has(key)) member(key, value);
  }

  template <class Enum>
  void optional_name(const char* key, Enum& value) {
    value = {};
    if (has(key)) member(key, value);
  }

  void note(const char*, const char*) {}

  template <class Members>
  void object(const char* key, const Members& members) {
    JsonReader inner(require(key), file_);
    members(inner);
  }

 private:
  /// null is a number that was not finite when it was written.
  static void take(const Json& json, double& value) {
    value = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
  }
  template <class T, std::size_t N>
  static void take(const Json& json, std::array<T, N>& values) {
    for (std::size_t i = 0; i < N; ++i) take(json.at(i), values[i]);
  }
  template <class T>
  static void take(const Json& json, std::vector<T>& values) {
    values.clear();
    for (const Json& item : json.get_ref<const Json::array_t&>()) take(item, values.emplace_back());
  }
  template <class T>
  static void take(const Json& json, T& value) {
    value = json.get<T>();
  }

  bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
  const Json& require(const char* key) const {
    if (!has(key)) fail(key);
    return json_.at(key);
  }
  [[noreturn]] void fail(const char* key) const {
    fail_input(file_, {}, fmt::format("'{}' is missing or of another type", key), Remedy::kSolveAgain);
  }

  const Json& json_;
  const InputFile& file_;
};

}  // namespace crossgrain
