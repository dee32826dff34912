// SPDX-License-Identifier: Apache-2.0
// How programs of our own answer the library that runs them: a greeting; bytes as in memory, since both are
// of one build; a trailer. A vector or a text is the number of its items, in 64 bits, and their bytes.
// Compiled into both.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "crossgrain/types.hpp"
#include "crossgrain/version.hpp"

namespace crossgrain {

/// Ends a complete answer.
inline constexpr std::string_view kAnswerTrailer = "complete";

/// Begins the answer of a program. Contains this version, since library and program must be of one build.
inline std::string greeting_of(const std::string& program) {
  return program + " " + kVersion + "\n";
}

inline void write_greeting(std::FILE* out, const std::string& program) {
  std::fputs(greeting_of(program).c_str(), out);
  std::fflush(out);
}

class AnswerWriter {
 public:
  explicit AnswerWriter(std::FILE* file) : file_(file) {}

  template <class T>
  void value(const T& item) {
    bytes(&item, sizeof item);
  }

  /// Writes a vector of trivially copyable items.
  template <class Items>
  void items(const Items& items) {
    static_assert(std::is_trivially_copyable_v<typename Items::value_type>);
    value(static_cast<std::uint64_t>(items.size()));
    bytes(items.data(), items.size() * sizeof(typename Items::value_type));
  }

  /// Writes a vector whose items `write` writes one by one.
  template <class Items, class Each>
  void list(const Items& items, std::size_t, const Each& write) {
    value(static_cast<std::uint64_t>(items.size()));
    for (const auto& item : items) write(item);
  }

  void bytes(const void* data, std::size_t size) {
    complete_ = complete_ && (size == 0 || std::fwrite(data, 1, size, file_) == size);
  }

  /// Ends the answer. Returns false if it could not be written.
  bool end() {
    bytes(kAnswerTrailer.data(), kAnswerTrailer.size());
    return std::fflush(file_) == 0 && complete_;
  }

 private:
  std::FILE* file_;
  bool complete_ = true;
};

/// Reads an answer. Once data are missing, all further items are empty.
class AnswerReader {
 public:
  explicit AnswerReader(std::string_view rest) : rest_(rest) {}

  template <class T>
  void value(T& item) {
    bytes(&item, sizeof item);
  }

  template <class Items>
  void items(Items& items) {
    constexpr std::size_t kItem = sizeof(typename Items::value_type);
    items.resize(count(kItem));
    bytes(items.data(), items.size() * kItem);
  }

  /// `least_bytes` is the size of the shortest item in the answer.
  template <class Items, class Each>
  void list(Items& items, std::size_t least_bytes, const Each& read) {
    items.resize(count(least_bytes));
    for (auto& item : items) read(item);
  }

  /// Whether all items were there, and nothing but `trailer` is left.
  bool ends_with(std::string_view trailer) const { return sound_ && rest_ == trailer; }

 private:
  /// Returns the number of items of at least so many bytes; 0 if the remaining data are too short.
  std::size_t count(std::size_t item_bytes) {
    std::uint64_t announced = 0;
    value(announced);
    if (announced <= rest_.size() / item_bytes) return announced;
    sound_ = false;
    return 0;
  }

  void bytes(void* out, std::size_t size) {
    sound_ = sound_ && size <= rest_.size();
    if (!sound_ || size == 0) return;
    std::memcpy(out, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
  bool sound_ = true;
};

inline bool are_finite(std::span<const Vector3> vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](const Vector3& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  });
}

/// Whether all vertices of elements are below a number.
template <class Elements>
bool are_in_range(const Elements& elements, std::size_t vertices) {
  return std::all_of(elements.begin(), elements.end(), [&](const auto& element) {
    return std::all_of(element.begin(), element.end(), [&](std::uint32_t v) { return v < vertices; });
  });
}

/// The most bytes of a text that is shown. Programs cut texts, which may come from a file.
inline constexpr std::size_t kMostTextBytes = 1000;

inline bool is_control(unsigned char c) {
  return c < 0x20 || c == 0x7f;
}

/// Whether a text is one line that can be shown.
inline bool is_line(std::string_view text) {
  return text.size() <= kMostTextBytes && std::none_of(text.begin(), text.end(), is_control);
}

/// Returns a text as such a line.
inline std::string one_line(std::string text) {
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  constexpr std::string_view kCut = "...";
  if (text.size() > kMostTextBytes) text.replace(kMostTextBytes - kCut.size(), text.npos, kCut);
  return text;
}

/// Reads a number that is the whole text, as fmt writes it. Returns whether it is one.
template <class Number>
bool parse_number(const std::string& text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, number);
  return code == std::errc() && stop == end;
}

}  // namespace crossgrain
