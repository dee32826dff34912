// SPDX-License-Identifier: Apache-2.0
// Sequence of numbers in text or raw bytes, so that one reader handles all encodings of a format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/parallel.hpp"
#include "files/input_file.hpp"
#include "text/number_type.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {

/// Copies continue independently from the same place. The file and the bytes must outlive the stream.
class NumberStream {
 public:
  /// Reads words of a text from the current place of the scanner; line breaks are ignored.
  explicit NumberStream(const TextScanner& scanner) : file_(&scanner.file()), scanner_(scanner) {}

  /// Reads the bytes of a binary file from `begin` on; `swapped` if their byte order is not that of this
  /// machine.
  NumberStream(const InputFile& file, std::size_t begin, bool swapped)
      : file_(&file), bytes_(file.bytes()), position_(begin), swapped_(swapped) {}

  /// Reads the decoded bytes of an array of the file; errors name the array.
  NumberStream(const InputFile& file, std::string array, std::string_view bytes, bool swapped)
      : file_(&file), bytes_(bytes), swapped_(swapped), array_(std::move(array)) {}

  /// Reads a number of the given type; in text any number. `what` names it in errors ("a coordinate").
  double real(NumberType type, const char* what) {
    return scanner_ ? scanner_->number(scanner_->word_anywhere(), what) : binary_real(type);
  }

  /// Reads a whole number of the given type; in text any of 64 bits.
  std::int64_t integer(NumberType type, const char* what) {
    return scanner_ ? scanner_->integer(scanner_->word_anywhere(), what) : binary_integer(type);
  }

  /// Skips numbers without checking them.
  void skip(NumberType type, std::uint64_t count);

  /// Upper bound of the remaining numbers. Check it before allocating memory for them.
  std::uint64_t most_left(NumberType type) const;

  /// Returns the count of items that take at least `least` numbers of `type` each. Throws Error(kInput) if it
  /// is negative or the rest of the file is too short.
  std::uint64_t checked_count(std::int64_t count, std::uint64_t least, NumberType type,
                              const std::string& what) const;

  /// Returns the line of a text, or the numbered element of a binary file.
  Place place(const char* unit, std::size_t number) const {
    return scanner_ ? scanner_->place() : Place{unit, number};
  }

  /// From now on errors in a binary file name this element instead of a byte.
  void begin_element(const char* unit, std::size_t number) { element_ = {unit, number}; }

  bool is_text() const { return scanner_.has_value(); }
  std::size_t bytes_left() const { return scanner_ ? scanner_->bytes_left() : bytes_.size() - position_; }
  std::size_t position() const { return scanner_ ? scanner_->position() : position_; }
  const TextScanner& scanner() const { return *scanner_; }

  /// Throws Error(kInput) that names the current line, byte, element or array.
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kRepairFile) const;

 private:
  double binary_real(NumberType type);
  std::int64_t binary_integer(NumberType type);
  template <class T>
  T take();

  const InputFile* file_;
  std::optional<TextScanner> scanner_;
  std::string_view bytes_;
  std::size_t position_ = 0;
  bool swapped_ = false;
  Checkpoint checkpoint_;
  std::string array_;
  Place element_;
};

}  // namespace crossgrain
