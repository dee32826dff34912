// SPDX-License-Identifier: Apache-2.0
// Words, numbers and lines of a text file. Lines end in LF, CR LF or CR.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/ignoring_case.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

class TextScanner {
 public:
  struct Syntax {
    bool comments = false;       ///< a word that starts with '#' ends the line
    bool continuations = false;  ///< a backslash at the end of a line joins it with the next one
  };

  /// Starts at byte `begin` on line `line`; the text ends at `end` or at the end of the file, whichever comes
  /// first. The file must outlive the scanner.
  TextScanner(const InputFile& file, Syntax syntax, std::size_t begin = 0, std::size_t line = 1,
              std::size_t end = std::string_view::npos);

  /// Returns the next word of this line; empty at its end.
  std::string_view word();

  /// Returns the next word of this or a later line; empty at the end of the file.
  std::string_view word_anywhere();

  /// Skips to the start of the next line. Returns false at the end of the file.
  bool next_line();

  /// Returns a word as a finite number; `what` names it in errors ("a coordinate").
  double number(std::string_view word, const char* what) const;

  /// Returns a word as a whole number of 64 bits.
  std::int64_t integer(std::string_view word, const char* what) const;

  std::size_t line() const { return line_; }
  std::size_t position() const { return position_; }
  std::size_t bytes_left() const { return text_.size() - position_; }
  Place place() const { return at_line(line_); }
  const InputFile& file() const { return *file_; }

  /// Throws Error(kInput) that names the current line.
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kRepairFile) const {
    fail_input(*file_, place(), text, remedy);
  }

 private:
  bool at_line_end() const;
  void skip_line_end();
  bool skip_continuation();
  void check_stop();

  const InputFile* file_;
  std::string_view text_;
  Syntax syntax_;
  std::size_t position_;
  std::size_t line_;
  std::size_t next_check_ = 0;  ///< position from which a stop is looked for
};

}  // namespace crossgrain
