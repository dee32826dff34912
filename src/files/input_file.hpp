// SPDX-License-Identifier: Apache-2.0
// The bytes of an input file, and how errors name a place in it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "crossgrain/message.hpp"

namespace crossgrain {

/// A whole file in memory. It is read, not mapped: if another program shortened a mapped file, the process
/// would crash.
class InputFile {
 public:
  /// Reads a file. Throws Error(kInput) if it is missing, not a regular file, not readable or empty.
  explicit InputFile(const std::filesystem::path& path);

  /// Bytes that no file has as they are: what comes out of an archive, named like it.
  InputFile(std::string name, std::unique_ptr<char[]> bytes, std::size_t size)
      : name_(std::move(name)), bytes_(std::move(bytes)), size_(size), is_on_disk_(false) {}

  /// Reads standard input to its end. Errors call it "standard input".
  static InputFile standard_input();

  std::string_view bytes() const { return {bytes_.get(), size_}; }
  const std::string& name() const { return name_; }

  /// Whether the file of this name has these bytes.
  bool is_on_disk() const { return is_on_disk_; }

 private:
  std::string name_;
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
  bool is_on_disk_ = true;
};

/// A place in a file: a line of text, or a numbered element of a binary file ("triangle 17"). Lines count
/// from 1, elements from 0. Without a unit it is the file as a whole.
struct Place {
  const char* unit = nullptr;
  std::size_t number = 0;
};

inline Place at_line(std::size_t number) {
  return {"line", number};
}

/// Text of a place for Message::place, such as "line 12".
std::string in_words(const Place& place);

/// Throws Error(kInput) naming the file and the place in it.
[[noreturn]] void fail_input(const InputFile& file, const Place& place, const std::string& text,
                             Remedy remedy = Remedy::kRepairFile);

/// Returns a word of a file for an error message: quoted, printable, at most 32 characters.
std::string in_quotes(std::string_view word);

}  // namespace crossgrain
