// SPDX-License-Identifier: Apache-2.0
// Lines of input files of Abaqus and CalculiX: keywords with parameters, and rows of fields, between commas.
// Lines that begin with ** are comments.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "text/text_scanner.hpp"

namespace crossgrain {

/// "*ELEMENT, TYPE=C3D8, ELSET=ALL"; words as in the file.
struct AbaqusKeyword {
  std::string_view name;  ///< without the star

  struct Parameter {
    std::string_view name, value;
  };
  std::vector<Parameter> parameters;

  bool is(std::string_view other) const { return equals_ignoring_case(name, other); }

  /// Returns the value of a parameter, which may be empty; nothing if it is not there.
  std::optional<std::string_view> find(std::string_view parameter) const;
};

/// Reads one line after the other.
class AbaqusLines {
 public:
  explicit AbaqusLines(const InputFile& file) : scanner_(file, {}) { find_line(); }

  bool is_at_end() const { return is_at_end_; }

  /// Whether the line is a row of fields.
  bool is_row() const { return !is_at_end_ && !line_.starts_with('*'); }

  /// Returns the keyword of the line, which goes on in the next one behind a comma, and passes to the rows.
  AbaqusKeyword take_keyword();

  /// Returns the fields of the row without the blanks around them, and passes to the next line. An empty
  /// field behind the last comma is left out. The fields are good until the next row is taken.
  const std::vector<std::string_view>& take_row();

  /// Passes to the next keyword.
  void skip_rows();

  double number(std::string_view field, const char* what) const { return row_.number(field, what); }
  std::int64_t integer(std::string_view field, const char* what) const { return row_.integer(field, what); }

  /// Of the row that was taken last.
  Place place() const { return row_.place(); }
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kRepairFile) const {
    row_.fail(text, remedy);
  }

 private:
  void find_line();
  void pass_line();
  void split_line();

  TextScanner scanner_;         ///< at the line
  TextScanner row_ = scanner_;  ///< at the row that was taken
  std::string_view line_;       ///< without blanks around it
  std::vector<std::string_view> fields_;
  bool is_at_end_ = false;
};

}  // namespace crossgrain
