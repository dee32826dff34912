// SPDX-License-Identifier: Apache-2.0
// The numbers of a text or of raw bytes, one after the other, so that one reader does for all encodings of a
// format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "files/input_file.hpp"
#include "io/text/number_type.hpp"
#include "io/text/text_scanner.hpp"

namespace crossgrain {

/// Copies go on from the same place, each by itself. The file and the bytes must outlive the stream.
class NumberStream {
 public:
  /// Words of a text from where the scanner stands; line breaks do not matter.
  explicit NumberStream(const TextScanner& scanner) : file_(&scanner.file()), scanner_(scanner) {}

  /// The bytes of a binary file from `begin` on; `swapped` where their order is not that of this machine.
  NumberStream(const InputFile& file, std::size_t begin, bool swapped)
      : file_(&file), bytes_(file.bytes()), position_(begin), swapped_(swapped) {}

  /// The bytes of an array that stands in the file in another form; errors name the array.
  NumberStream(const InputFile& file, std::string array, std::string_view bytes, bool swapped)
      : file_(&file), bytes_(bytes), swapped_(swapped), array_(std::move(array)) {}

  /// A number of the type given; in text any. `what` names it in errors ("a coordinate").
  double real(NumberType type, const char* what) {
    return scanner_ ? scanner_->number(scanner_->word_anywhere(), what) : binary_real(type);
  }

  /// A whole number; in text any of 64 bits.
  std::int64_t integer(NumberType type, const char* what) {
    return scanner_ ? scanner_->integer(scanner_->word_anywhere(), what) : binary_integer(type);
  }

  /// Passes over numbers, whatever they are.
  void skip(NumberType type, std::uint64_t count);

  /// How many numbers can follow at most: to be asked before memory is taken for them.
  std::uint64_t most_left(NumberType type) const;

  /// A count of things to come that take at least `least` numbers of `type` each. Throws Error(kInput) where
  /// it is negative or the rest is too short for as many.
  std::uint64_t checked_count(std::int64_t count, std::uint64_t least, NumberType type,
                              const std::string& what) const;

  /// The line of a text, or the numbered element of a binary file.
  Place place(const char* unit, std::size_t number) const {
    return scanner_ ? scanner_->place() : Place{unit, number};
  }

  bool is_text() const { return scanner_.has_value(); }
  std::size_t position() const { return scanner_ ? scanner_->position() : position_; }
  const TextScanner& scanner() const { return *scanner_; }

  /// Throws Error(kInput) that names this line, this byte or the array.
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
  std::string array_;
};

}  // namespace crossgrain
