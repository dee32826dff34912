// SPDX-License-Identifier: Apache-2.0
// The container of the scene of a page (viewer/README.md): a header in JSON, then arrays.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace crossgrain {

class SceneWriter {
 public:
  /// Members of the header besides "schema" and "arrays".
  nlohmann::ordered_json header = nlohmann::ordered_json::object();

  /// Adds an array of rows of `components` numbers of type float, std::uint32_t, std::uint16_t, std::int16_t
  /// or std::uint8_t; each name once.
  template <class T>
  void add(const std::string& name, std::size_t components, const std::vector<T>& values);

  /// Header and arrays as bytes.
  std::string bytes() const;

 private:
  nlohmann::ordered_json arrays_ = nlohmann::ordered_json::object();
  std::string data_;
};

/// The upper half of a number in single precision, rounded to nearest: three digits.
std::uint16_t to_bfloat16(float value);

}  // namespace crossgrain
