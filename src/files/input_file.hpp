// SPDX-License-Identifier: Apache-2.0
// The bytes of an input file, and how an error names a place in it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "crossgrain/message.hpp"

namespace crossgrain {

/// A whole file in memory. It is read, not mapped: a mapped file that another program cuts short meanwhile
/// would end the process.
class InputFile {
 public:
  /// Throws Error(kInput) for what is missing, not a regular file, not readable or empty.
  explicit InputFile(const std::filesystem::path& path);

  /// All that comes through standard input, which errors call "standard input".
  static InputFile standard_input();

  std::string_view bytes() const { return {bytes_.get(), size_}; }
  const std::string& name() const { return name_; }

 private:
  InputFile(std::string name, std::unique_ptr<char[]> bytes, std::size_t size)
      : name_(std::move(name)), bytes_(std::move(bytes)), size_(size) {}

  std::string name_;
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

/// A place in a file: a line of text, or a numbered element of a binary file ("triangle 17"). Numbers start
/// at 1 for lines and at 0 for elements. Without a unit it is the file as a whole.
struct Place {
  const char* unit = nullptr;
  std::size_t number = 0;
};

inline Place at_line(std::size_t number) {
  return {"line", number};
}

/// As Message::place: "line 12".
std::string in_words(const Place& place);

/// Throws Error(kInput) naming the file and the place in it.
[[noreturn]] void fail_input(const InputFile& file, const Place& place, const std::string& text,
                             Remedy remedy = Remedy::kRepairFile);

/// A word of a file as an error message can show it: in quotes, printable, at most 32 characters.
std::string in_quotes(std::string_view word);

}  // namespace crossgrain
